"""The debug view (SPEC G12): what the physics sees, drawn over the world."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, TypeAlias

from evilengine.scene.camera import Matrix6
from evilengine.scene.text import Fonts
from evilengine.scene.typeset import layout
from evilengine.values.checks import one_of
from evilengine.values.colour import ColourLike, to_colour
from evilengine.values.vec2 import Vec2

if TYPE_CHECKING:
    from evilengine._core import Scene as CoreScene
    from evilengine.scene.lights import Lights
    from evilengine.world.world import World

EARTH = 9.81  # m/s2: gravity this strong fills its dial
DIAL = 30.0  # radius of the dial that shows gravity, and all lengths below: logical points
MARGIN = 12.0
LEGEND_SIZE = 13.0

WORLD_PARTS = ("shapes", "contacts", "impulses", "joints", "bounds", "islands", "centres", "velocities")
"""What of a world can be shown; in the order of Part in core/draw/debug.hpp."""
FLUID_PARTS = ("flow", "divergence", "cells", "particles")
"""What of fluids can be shown; in the order of FluidPart in core/draw/debug_fluids.hpp."""
PARTS = (*WORLD_PARTS, "lights", *FLUID_PARTS)
"""All that can be shown."""
INKS = (
    "static", "kinematic", "awake", "asleep", "sensor", "medium", "contact", "impulse", "joint", "bound", "centre",
    "velocity",
)  # fmt: skip
"""Whose colours the core is told; in the order of Ink there."""
FLUID_INKS = ("arrow", "spreading", "gathering", "grid", "solid", "liquid")
"""The same for fluids, in the order of FluidInk."""

Counts: TypeAlias = tuple[int, int, int, int, int]
"""Bodies, sleepers, contacts, joints, islands."""


def _packed(colour: ColourLike) -> int:
    return to_colour(colour, "DebugView", "colour").rgba8


@dataclass(slots=True)
class DebugView:
    """What the debug view shows, and how; `game.debug = True` shows it, `game.debug_view` is this.

    Each part is on or off by itself: shapes, contacts, joints, centres, flow and particles are on at first.

    >>> import evilengine as evil
    >>> game = evil.Game(headless=True)
    >>> game.debug = True
    >>> game.debug_view.bounds = game.debug_view.islands = True
    >>> game.debug_view.shown
    ('shapes', 'contacts', 'joints', 'bounds', 'islands', 'centres', 'flow', 'particles')
    """

    shapes: bool = True
    """Outlines of shapes, in the colour of what their body does, and the areas of media."""
    contacts: bool = True
    """Points where shapes touch, with the normal, from the first body to the second."""
    impulses: bool = False
    """How hard contacts push, friction with it. As long as a normal: enough to hold the lighter body up. An arrow twice
    as long stands for four times the push, since pushes within one heap differ so much."""
    joints: bool = True
    """What ties bodies together: pins with the arc of their limits, rails, springs as coils, ropes that hang, and which
    way motors turn. A joint that may break takes the colour of contacts as it comes near that."""
    bounds: bool = False
    """Boxes round the convex pieces that shapes are made of."""
    islands: bool = False
    """Bodies that wake and sleep together have one colour, darker while they sleep, and a box round them."""
    centres: bool = True
    """Centres of mass."""
    velocities: bool = False
    """Arrows from each body's centre of mass to where it would be in a tenth of a second."""
    lights: bool = False
    """Where lights are, how large they are, how far they reach and how wide they open; and the edges of shadows: full
    ones, which end where nothing of a light is hidden whole any more, and half ones."""
    flow: bool = True
    """Arrows along the flow of smoke and water, one for every few cells; the legend says from what speed on they are
    the longest. One half as long stands for a quarter of that, since flows differ so much."""
    divergence: bool = False
    """Where smoke spreads and where it gathers: what the pressure has left of that; and the same of water, as its
    particles feel it. Colours are full at what the legend says (a share of the cell a second)."""
    cells: bool = False
    """The cells of fluids, or as many of their lines as there is room for; which are solid, which have liquid in them,
    which sides are closed."""
    particles: bool = True
    """Water's particles, in the colours of their liquids."""
    dial: bool = True
    """The dial at the top right, with which way and how strongly gravity pulls."""
    legend: bool = True
    """The line that says what the colours mean, and counts."""

    static: ColourLike = "#9db2cf"
    kinematic: ColourLike = "#cf9bff"
    awake: ColourLike = "#86f7a0"
    asleep: ColourLike = "#6f7f99"
    sensor: ColourLike = "#ffb86c"
    medium: ColourLike = "#3f8fd2"
    contact: ColourLike = "#ff6b6b"
    impulse: ColourLike = "#ff9ff3"
    joint: ColourLike = "#5ce1e6"
    bound: ColourLike = "#7a5cc0"
    centre: ColourLike = "#ffffff"
    velocity: ColourLike = "#6cc4ff"
    light: ColourLike = "#fff1a8"
    umbra: ColourLike = "#ff8f3f"
    penumbra: ColourLike = "#c9a35a90"
    arrow: ColourLike = "#b8f0ff"
    spreading: ColourLike = "#ff7a3c"
    gathering: ColourLike = "#3f8cff"
    grid: ColourLike = "#7f93b5"
    solid: ColourLike = "#c77dff80"
    liquid: ColourLike = "#2f7fd060"
    gravity: ColourLike = "#ffd75e"
    veil: ColourLike = "#0c1018b0"
    """Lies over the world and under the lines, so that they stand out whatever the colours below."""

    @property
    def shown(self) -> tuple[str, ...]:
        """The names of the parts that are on."""
        return tuple(part for part in PARTS if getattr(self, part))

    def show(self, parts: Iterable[str]) -> None:
        """Turn these parts on and the others off. Raises ArgumentError for one that there is not.

        >>> view = DebugView()
        >>> view.show(["joints", "islands"])
        >>> view.shown
        ('joints', 'islands')
        """
        wanted = [one_of(part, "DebugView.show", "part", PARTS) for part in parts]
        for part in PARTS:
            setattr(self, part, part in wanted)

    def draw(
        self,
        core: CoreScene,
        world: World,
        lights: Lights,
        fonts: Fonts | None,
        view: Matrix6,
        alpha: float,
        screen: tuple[int, int],
        scale: float,
    ) -> None:
        """Put it on top of the collected frame, seen through `view`; `screen` in pixels, `scale` of them a point."""
        core.box(0.0, 0.0, screen[0], screen[1], _packed(self.veil))
        inks = [_packed(getattr(self, ink)) for ink in INKS]
        fluids = self._draw_fluids(core, world, view, screen, scale)
        counts = core.debug(world._core, view, alpha, scale, inks, [bool(getattr(self, part)) for part in WORLD_PARTS])
        shining = lights._debug(core, view, alpha, scale, self._light_inks()) if self.lights else 0
        if self.dial:
            self._draw_gravity(core, world.gravity, view, screen, scale)
        if self.legend and fonts is not None:
            self._draw_legend(core, fonts, self._legend(world, counts, shining, fluids), screen, scale)

    def _draw_fluids(
        self, core: CoreScene, world: World, view: Matrix6, screen: tuple[int, int], scale: float
    ) -> list[tuple[ColourLike | None, str]]:
        """Put fluids on top, and say what their colours mean."""
        shown = [bool(getattr(self, part)) for part in FLUID_PARTS]
        inks = [_packed(getattr(self, ink)) for ink in FLUID_INKS]
        fluids, particles, speed, divergence = core.debug_fluids(world._core, view, screen, scale, inks, shown)
        if not fluids:
            return []
        words: list[tuple[ColourLike | None, str]] = [(self.arrow, f"flow to {speed:g} m/s")] if self.flow else []
        if self.divergence:
            words += [(self.spreading, "spreads"), (self.gathering, f"gathers, to {divergence:.1g}/s")]
        if self.cells:
            words += [(self.solid, "solid cells"), *([(self.liquid, "liquid")] if world.waters else [])]
        if self.particles and particles:
            words += [(None, f"particles {particles:,}")]
        return words

    def _light_inks(self) -> tuple[int, int, int]:
        return _packed(self.light), _packed(self.umbra), _packed(self.penumbra)

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

    def _legend(
        self, world: World, counts: Counts, shining: int, fluids: list[tuple[ColourLike | None, str]]
    ) -> list[tuple[ColourLike | None, str]]:
        """Colours with what they stand for, of what is shown."""
        bodies, asleep, contacts, joints, islands = counts
        states = [(self.awake, "awake"), (self.asleep, f"asleep {asleep}")] if not self.islands else []
        standing = [(self.static, "static"), (self.kinematic, "kinematic")]
        words: list[tuple[ColourLike | None, str]] = [*states, *standing] if self.shapes else []
        words += [(self.contact, f"contacts {contacts}")] if self.contacts else []
        words += [(self.impulse, "impulses")] if self.impulses else []
        words += [(self.joint, f"joints {joints}")] if self.joints and joints else []
        words += [(self.bound, "bounds")] if self.bounds else []
        words += [(self.velocity, "velocities")] if self.velocities else []
        words += [(self.light, f"lights {shining}"), (self.umbra, "shadow")] if self.lights else []
        words += fluids
        words += [(self.gravity, f"gravity {world.gravity.length:.1f}")] if self.dial else []
        counted = f"   islands {islands}" if self.islands else ""
        return [*words, (None, f"bodies {bodies}{counted}   step {world.steps}")]

    def _draw_legend(
        self,
        core: CoreScene,
        fonts: Fonts,
        words: list[tuple[ColourLike | None, str]],
        screen: tuple[int, int],
        scale: float,
    ) -> None:
        texture, font = fonts(max(round(LEGEND_SIZE * scale), 6))
        begin, line = float(round(MARGIN * scale)), font.line_height
        swatch, gap = round(0.7 * line), round(0.5 * line)
        lines: list[list[tuple[ColourLike | None, bytes, tuple[float, float]]]] = [[]]
        width = widest = 0.0
        for colour, word in words:
            row = (colour, *layout(font, word))
            wide = row[2][0] + gap * 2 + (swatch if colour else 0)
            if lines[-1] and begin + width + wide > screen[0]:
                lines.append([])
                width = 0.0
            lines[-1].append(row)
            width += wide
            widest = max(widest, width)
        top = float(round(screen[1] - MARGIN * scale - line)) - (len(lines) - 1) * 1.4 * line
        bottom = top + (len(lines) - 1) * 1.4 * line + 1.3 * line
        core.box(begin - gap, top - 0.3 * line, begin + widest, bottom, _packed("#000000a0"))
        for number, rows in enumerate(lines):
            self._draw_legend_line(core, rows, begin, round(top + number * 1.4 * line), line, texture)

    def _draw_legend_line(
        self,
        core: CoreScene,
        rows: list[tuple[ColourLike | None, bytes, tuple[float, float]]],
        left: float,
        top: float,
        line: float,
        texture: int,
    ) -> None:
        swatch, gap = round(0.7 * line), round(0.5 * line)
        for colour, boxes, extent in rows:
            if colour:
                core.box(left, top + 0.5 * (line - swatch), left + swatch, top + 0.5 * (line + swatch), _packed(colour))
                left += swatch + round(0.6 * gap)
            core.glyphs(boxes, left, top, texture, _packed("#e8edf5"))
            left += round(extent[0]) + gap * 1.4
