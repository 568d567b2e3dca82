"""The debug view (SPEC G12): what the physics sees, drawn over the world."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from evilengine.scene.camera import Matrix6
from evilengine.scene.text import Fonts, layout
from evilengine.values.colour import ColourLike, to_colour
from evilengine.values.vec2 import Vec2

if TYPE_CHECKING:
    from evilengine._core import Scene as CoreScene
    from evilengine.world.world import World

EARTH = 9.81  # m/s2: gravity this strong fills its dial
DIAL = 30.0  # radius of the dial that shows gravity, and all lengths below: logical points
MARGIN = 12.0
LEGEND_SIZE = 13.0


def _packed(colour: ColourLike) -> int:
    return to_colour(colour, "DebugView", "colour").rgba8


@dataclass(slots=True)
class DebugView:
    """How the debug view looks; `scene.debug = True` shows it."""

    static: ColourLike = "#9db2cf"
    kinematic: ColourLike = "#cf9bff"
    awake: ColourLike = "#86f7a0"
    asleep: ColourLike = "#6f7f99"
    contact: ColourLike = "#ff6b6b"
    centre: ColourLike = "#ffffff"
    velocity: ColourLike = "#6cc4ff"
    sensor: ColourLike = "#ffb86c"
    medium: ColourLike = "#3f8fd2"
    gravity: ColourLike = "#ffd75e"
    veil: ColourLike = "#0c1018b0"
    """Lies over the world and under the lines, so that they stand out whatever the colours below."""
    velocities: bool = False
    """Arrows from each body's centre of mass to where it would be in a tenth of a second."""
    legend: bool = True
    """The line that says what the colours mean and counts bodies and contacts."""

    def draw(
        self,
        core: CoreScene,
        world: World,
        fonts: Fonts | None,
        view: Matrix6,
        alpha: float,
        screen: tuple[int, int],
        scale: float,
    ) -> None:
        """Put it on top of the collected frame, seen through `view`; `screen` in pixels, `scale` of them a point."""
        bodies = (self.static, self.kinematic, self.awake, self.asleep)
        palette = (*bodies, self.contact, self.centre, self.velocity, self.sensor, self.medium)
        core.box(0.0, 0.0, screen[0], screen[1], _packed(self.veil))
        counts = core.debug(world._core, view, alpha, scale, [_packed(one) for one in palette], self.velocities)
        self._draw_gravity(core, world.gravity, view, screen, scale)
        if self.legend and fonts is not None:
            self._draw_legend(core, world, fonts, counts, screen, scale)

    def _draw_gravity(
        self, core: CoreScene, gravity: Vec2, view: Matrix6, screen: tuple[int, int], scale: float
    ) -> None:
        radius = DIAL * scale
        x, y = screen[0] - radius - MARGIN * scale, radius + MARGIN * scale
        core.disc(x, y, radius, _packed("#00000080"))
        a, b, c, d, _, _ = view
        on_screen = Vec2(a * gravity.x + c * gravity.y, b * gravity.x + d * gravity.y).direction
        reach = on_screen * (0.85 * radius * min(gravity.length / EARTH, 1.0))
        core.arrow(x - reach.x, y - reach.y, x + reach.x, y + reach.y, 3.0 * scale, _packed(self.gravity))

    def _draw_legend(
        self,
        core: CoreScene,
        world: World,
        fonts: Fonts,
        counts: tuple[int, int, int],
        screen: tuple[int, int],
        scale: float,
    ) -> None:
        bodies, asleep, contacts = counts
        words: list[tuple[ColourLike | None, str]] = [
            (self.awake, "awake"),
            (self.asleep, f"asleep {asleep}"),
            (self.static, "static"),
            (self.kinematic, "kinematic"),
            (self.contact, f"contacts {contacts}"),
            (self.gravity, f"gravity {world.gravity.length:.1f}"),
            (None, f"bodies {bodies}   step {world.steps}"),
        ]
        texture, font = fonts(max(round(LEGEND_SIZE * scale), 6))
        left, line = float(round(MARGIN * scale)), font.line_height
        top = float(round(screen[1] - MARGIN * scale - line))
        rows = [(colour, *layout(font, word, 0.0)) for colour, word in words]
        swatch, gap = round(0.7 * line), round(0.5 * line)
        width = sum(extent[0] + gap * 2 + (swatch if colour else 0) for colour, _, extent in rows)
        core.box(left - gap, top - 0.3 * line, left + width, top + 1.3 * line, _packed("#000000a0"))
        for colour, boxes, extent in rows:
            if colour:
                core.box(left, top + 0.5 * (line - swatch), left + swatch, top + 0.5 * (line + swatch), _packed(colour))
                left += swatch + round(0.6 * gap)
            core.glyphs(boxes, left, top, texture, _packed("#e8edf5"))
            left += round(extent[0]) + gap * 1.4
