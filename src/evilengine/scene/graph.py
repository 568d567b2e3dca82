"""The graph of what frames cost: a bar for each, in layers, over a line at a sixtieth of a second."""

from __future__ import annotations

from collections.abc import Collection
from typing import TYPE_CHECKING

from evilengine.scene.text import Fonts
from evilengine.scene.typeset import layout
from evilengine.values.colour import to_colour
from evilengine.values.frame import FrameTimes
from evilengine.values.tick import STEP

if TYPE_CHECKING:
    from evilengine._core import Scene as CoreScene

COLOURS = {"steps": "#86f7a0", "collect": "#6cc4ff", "draw": "#cf9bff", "present": "#566178"}
WIDTH, HEIGHT = 280.0, 80.0  # logical points, as all lengths here
FULL = 2000.0 * STEP  # milliseconds that fill its height: two frames of a screen at 60 Hz
MARGIN, LEGEND = 12.0, 12.0
MOST = 120  # bars


def draw(
    core: CoreScene, rows: Collection[FrameTimes], fonts: Fonts | None, screen: tuple[int, int], scale: float
) -> None:
    """Put it into the lower right corner of a picture of `screen` pixels, `scale` of them a point."""
    width, height, margin = WIDTH * scale, HEIGHT * scale, MARGIN * scale
    left, bottom = screen[0] - margin - width, screen[1] - margin
    core.box(left, bottom - height, left + width, bottom, _packed("#000000a0"))
    bar = width / MOST
    colours = [_packed(colour) for colour in COLOURS.values()]
    shown = list(rows)[-MOST:]
    for number, times in enumerate(shown, MOST - len(shown)):
        x, low = left + number * bar, 0.0
        for part, colour in zip(times, colours, strict=True):
            high = min(low + part / FULL * height, height)
            if high > low:
                core.box(x, bottom - high, x + bar, bottom - low, colour)
            low = high
    sixtieth = bottom - height * 1e3 * STEP / FULL
    core.box(left, sixtieth - 0.5 * scale, left + width, sixtieth + 0.5 * scale, _packed("#ffd75e"))
    if fonts is not None and shown:
        _legend(core, shown, fonts, (left, bottom - height), width, scale)


def _legend(
    core: CoreScene, rows: list[FrameTimes], fonts: Fonts, at: tuple[float, float], width: float, scale: float
) -> None:
    """The parts and what they cost on average, above the graph."""
    texture, font = fonts(max(round(LEGEND * scale), 6))
    means = [sum(column) / len(rows) for column in zip(*rows, strict=True)]
    x, y = at[0], at[1] - font.line_height - 2.0 * scale
    core.box(x, y, x + width, at[1], _packed("#000000a0"))
    x += 4.0 * scale
    for (name, colour), mean in zip(COLOURS.items(), means, strict=True):
        glyphs, extent = layout(font, f"{name} {mean:.1f}")
        core.glyphs(glyphs, round(x), round(y), texture, _packed("#aeb8cc" if name == "present" else colour))
        x += max(extent[0] + 6.0 * scale, width / len(COLOURS))


def _packed(colour: str) -> int:
    return to_colour(colour, "frame graph", "colour").rgba8
