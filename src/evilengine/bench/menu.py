"""The testbed's menu: a panel at the left with all scenes, what the present one costs, and the keys."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from evilengine.scene.text import Fonts
from evilengine.scene.typeset import layout
from evilengine.values.colour import to_colour
from evilengine.values.vec2 import Vec2

if TYPE_CHECKING:
    from evilengine._core import Scene as CoreScene

WIDTH, MARGIN, ROW = 210.0, 14.0, 21.0  # logical points, as all lengths here
TITLE_SIZE, SIZE, SMALL = 19.0, 14.0, 12.0
PARTS_WIDTH = 116.0
TOP = 52.0
"""Where the first scene's row begins."""

VEIL, CHOSEN, HOVER = "#0c1018ec", "#3a6df0", "#ffffff18"
BRIGHT, PLAIN, DIM = "#ffffff", "#c9d3e4", "#7f8da6"


class Menu:
    """Rows of names, of which one is chosen; readings and keys stand below them."""

    def __init__(self, title: str, names: Sequence[str]) -> None:
        self.title = title
        self.names = list(names)
        self.chosen = ""
        self.caption = ""
        self.pointer = Vec2(-1.0, -1.0)
        self.readings: Sequence[tuple[str, str]] = ()
        self.keys: Sequence[tuple[str, str]] = ()
        self.parts: Sequence[tuple[str, bool]] = ()
        """What of the debug view is on, by the number keys that turn it on and off; none while it is off."""

    def name_at(self, point: Vec2) -> str | None:
        """The name under a point of the screen, in logical points.

        >>> menu = Menu("", ["a", "b"])
        >>> menu.name_at(Vec2(20, TOP + 1.5 * ROW)), menu.name_at(Vec2(WIDTH + 1, TOP + 5))
        ('b', None)
        """
        row = int((point.y - TOP) // ROW)
        inside = 0.0 <= point.x < WIDTH and 0 <= row < len(self.names)
        return self.names[row] if inside else None

    def next(self, step: int) -> str:
        """The name so many rows below the chosen one, round and round."""
        return self.names[(self.names.index(self.chosen) + step) % len(self.names)]

    def draw(self, core: CoreScene, fonts: Fonts | None, screen: tuple[int, int], scale: float) -> None:
        """Put it on the screen."""
        if fonts is None:
            return
        page = _Page(core, fonts, scale)
        page.box(0.0, 0.0, WIDTH, screen[1] / scale, VEIL)
        page.text(self.title, MARGIN, 16.0, TITLE_SIZE, BRIGHT)
        page.text(self.caption, WIDTH + MARGIN, 16.0, SIZE, PLAIN)
        under = self.name_at(self.pointer)
        for row, name in enumerate(self.names):
            top = TOP + row * ROW
            if name in (self.chosen, under):
                page.box(0.0, top, WIDTH, top + ROW, CHOSEN if name == self.chosen else HOVER)
            page.text(name.replace("_", " "), MARGIN, top + 2.0, SIZE, BRIGHT if name == self.chosen else PLAIN)
        y = TOP + len(self.names) * ROW + 14.0
        for word, reading in self.readings:
            page.text(word, MARGIN, y, SIZE, DIM)
            page.text(reading, WIDTH - MARGIN, y, SIZE, BRIGHT, across=1.0)
            y += 19.0
        y = screen[1] / scale - MARGIN - 17.0 * len(self.keys)
        for key, meaning in self.keys:
            page.text(key, MARGIN, y, SMALL, PLAIN)
            page.text(meaning, MARGIN + 74.0, y, SMALL, DIM)
            y += 17.0
        self._draw_parts(page, screen[0] / scale)

    def _draw_parts(self, page: _Page, right: float) -> None:
        """At the right, below the dial of gravity."""
        top, left = 92.0, right - PARTS_WIDTH
        if self.parts:
            page.box(left, top - 8.0, right, top + 17.0 * len(self.parts) + 6.0, VEIL)
        for number, (part, on) in enumerate(self.parts, start=1):
            page.text(str(number), left + MARGIN, top, SMALL, BRIGHT if on else DIM)
            page.text(part, left + MARGIN + 18.0, top, SMALL, BRIGHT if on else DIM)
            top += 17.0


class _Page:
    """A screen in logical points."""

    def __init__(self, core: CoreScene, fonts: Fonts, scale: float) -> None:
        self._core, self._fonts, self._scale = core, fonts, scale

    def box(self, left: float, top: float, right: float, bottom: float, colour: str) -> None:
        s = self._scale
        self._core.box(left * s, top * s, right * s, bottom * s, _packed(colour))

    def text(self, words: str, x: float, y: float, size: float, colour: str, *, across: float = 0.0) -> None:
        """Words whose part `across` (0..1) lies left of x."""
        texture, font = self._fonts(max(round(size * self._scale), 6))
        glyphs, _ = layout(font, words, across)
        self._core.glyphs(glyphs, round(x * self._scale), round(y * self._scale), texture, _packed(colour))


def _packed(colour: str) -> int:
    return to_colour(colour, "Menu", "colour").rgba8
