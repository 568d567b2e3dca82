"""Smoke and fire: gas in a box of cells, round the bodies and in their way (SPEC F1 to F6)."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import TYPE_CHECKING, Any

from evilengine import _core
from evilengine.values.checks import known_keywords, number, one_of
from evilengine.values.colour import ColourLike, to_colour
from evilengine.values.errors import ArgumentError, ArgumentTypeError
from evilengine.values.vec2 import Point, Vec2
from evilengine.world.arguments import flag, place, speed
from evilengine.world.character import Area, to_area
from evilengine.world.shapes import Circle, ShapeDefinition

if TYPE_CHECKING:
    from evilengine.world.body import Body
    from evilengine.world.world import World

MOST_CELLS, LEAST_CELLS = 2048, 2
"""Cells of a smoke, each way."""

SIDES = ("left", "right", "bottom", "top")
METHODS = ("staggered", "stam")
QUALITIES = ("fast", "high")
GREY = "#c8c8c8"


class Source(_core.Source):
    """Where smoke comes from, or goes to: `smoke.add_source` makes one.

    `rate`, `fuel`, `temperature`, `velocity` and `running` may be changed at any time.
    """

    __slots__ = ("__weakref__", "_world")

    def __init__(self, world: World, slot: int) -> None:
        super().__init__(world._core, slot)
        self._world = world

    @property
    def body(self) -> Body | None:
        """The body that carries it, or None. It goes when that goes."""
        return None if self._body == _core.NO_SLOT else self._world._body(self._body)

    def destroy(self) -> None:
        """Take it out of its smoke."""
        self._destroy()

    def __repr__(self) -> str:
        return f"<Source {self.slot}, rate {self.rate:g}>" if self.alive else "<Source, gone>"


class Smoke(_core.Smoke):
    """Gas in a box of cells: `world.add_smoke` and `game.add_smoke` make one.

    `density`, `temperature` and `fuel` are (ny, nx) float32 buffers, `velocity` (ny, nx, 2): views without a copy, rows
    from below, which may be written. `viscosity`, `buoyancy` and what else it was made with are attributes that may
    be changed at any time.

    >>> world = evil.World()
    >>> smoke = world.add_smoke((-2, 0, 2, 4), cells=32)
    >>> source = smoke.add_source(at=(0, 0.5), radius=0.3, rate=2, temperature=1)
    >>> for _ in range(60):
    ...     world.step()
    >>> smoke.mass > 0.3, smoke.velocity_at((0, 1)).y > 0.2
    (True, True)
    """

    __slots__ = ("__weakref__", "_world")

    def __init__(self, world: World, slot: int) -> None:
        super().__init__(world._core, slot)
        self._world = world

    @known_keywords
    def add_source(
        self,
        shape: ShapeDefinition | None = None,
        *,
        at: Point = (0.0, 0.0),
        angle: float = 0.0,
        radius: float | None = None,
        body: Body | None = None,
        rate: float = 0.0,
        colour: ColourLike | None = None,
        temperature: float = 0.0,
        velocity: Point | None = None,
        fuel: float = 0.0,
    ) -> Source:
        """Let smoke come out of a circle of `radius`, or of any shape with an inside, `at` a place; returns its handle.

        `rate` is density a second; a negative one takes that share away: a sink. `temperature` is what it heats to,
        `fuel` what burns by and by (a second), `velocity` (m/s) how it blows. With a `body`, place and velocity are in
        that body's frame and go with it. A colour other than the smoke's own mixes with what is there.

        >>> world = evil.World(); smoke = world.add_smoke((-2, 0, 2, 4), cells=32)
        >>> torch = world.add(evil.Circle(0.2), at=(0, 1))
        >>> smoke.add_source(radius=0.2, at=(0, 0.2), body=torch, rate=1).body is torch
        True
        """
        me = "Smoke.add_source"
        if (shape is None) == (radius is None):
            raise ArgumentError(f"{me}: give either a shape or radius=, the radius of a circle in metres")
        if shape is None:
            shape = Circle(number(radius, me, "radius", above=0.0, most=1e4))
        elif not isinstance(shape, ShapeDefinition):
            raise ArgumentTypeError(f"{me}: shape={shape!r} must be a shape such as evil.Rectangle(2, 1)")
        carrier = None if body is None else self._world._own_body(body, me, "body")
        slot = _core.add_source(
            self._world._core,
            smoke=self._live().slot,
            body=_core.NO_SLOT if carrier is None else carrier.slot,
            shape=shape._spec,
            at=place(at, me),
            angle=number(angle, me, "angle"),
            rate=number(rate, me, "rate", least=-1e4, most=1e4),
            fuel=number(fuel, me, "fuel", least=0.0, most=1e4),
            temperature=number(temperature, me, "temperature", least=-1e3, most=1e3),
            velocity=None if velocity is None else flow(velocity, me, "velocity"),
            colour=self._colour if colour is None else to_colour(colour, me, "colour")[:3],
        )
        return Source(self._world, slot)

    @property
    def sources(self) -> tuple[Source, ...]:
        """Its sources and sinks, in the order of their slots."""
        return tuple(Source(self._world, slot) for slot in self._sources())

    @known_keywords
    def stir(self, at: Point, *, radius: float, velocity: Point) -> None:
        """Push the gas round a point by hand: in its middle to `velocity`, less towards `radius`.

        >>> smoke = evil.World().add_smoke((0, 0, 4, 4), cells=16)
        >>> smoke.stir((2, 2), radius=1, velocity=(3, 0))
        """
        self._stir(*stirring(at, radius, velocity, "Smoke.stir"))

    @known_keywords
    def density_at(self, points: Any) -> Any:
        """The density at a point, as a number; at each of a list or an array of points, as a list. 0 outside."""
        return one_or_all(self._density_at, points, "Smoke.density_at")

    @known_keywords
    def temperature_at(self, points: Any) -> Any:
        """The temperature at a point, or at each of many."""
        return one_or_all(self._temperature_at, points, "Smoke.temperature_at")

    @known_keywords
    def velocity_at(self, points: Any) -> Any:
        """The velocity (m/s) at a point, as a Vec2, or at each of many.

        >>> smoke = evil.World().add_smoke((0, 0, 4, 4), cells=16)
        >>> smoke.velocity_at((1, 1)), smoke.velocity_at([(1, 1), (9, 9)])
        (Vec2(0.0, 0.0), [Vec2(0.0, 0.0), Vec2(0.0, 0.0)])
        """
        return one_or_all(self._velocity_at, points, "Smoke.velocity_at")

    @property
    def open_sides(self) -> tuple[str, ...]:
        """The sides by which gas may leave and enter."""
        return tuple(side for side, is_open in zip(SIDES, self._open, strict=True) if is_open)

    @property
    def method(self) -> str:
        """How it is reckoned: "staggered", or "stam" for Stam's as the thesis has it."""
        return METHODS[self._kind[0]]

    @property
    def quality(self) -> str:
        """What it spends: "fast" or "high"."""
        return QUALITIES[self._kind[1]]

    def destroy(self) -> None:
        """Take it and its sources out of the world."""
        self._destroy()

    def _live(self) -> Smoke:
        _ = self.cell  # raises StaleReferenceError
        return self

    def __repr__(self) -> str:
        if not self.alive:
            return "<Smoke, gone>"
        return f"<Smoke {self.slot}, {self.cells[0]} x {self.cells[1]} cells of {self.cell:g} m>"


class Fluids:
    """What a world knows of its fluids."""

    _core: _core.World

    @known_keywords
    def add_smoke(
        self,
        area: Iterable[float],
        *,
        cells: int | Sequence[int] = 256,
        viscosity: float = 0.0,
        diffusion: float = 0.0,
        buoyancy: float = 0.5,
        vorticity: float = 0.0,
        cooling: float = 0.3,
        fade: float = 0.0,
        burning: float = 3.0,
        heat: float = 2.0,
        soot: float = 0.3,
        weight: float = 0.1,
        wind: Point = (0.0, 0.0),
        wind_pull: float = 0.5,
        colour: ColourLike = GREY,
        open_sides: str | Iterable[str] = (),
        side_speeds: Sequence[float] = (0.0, 0.0, 0.0, 0.0),
        stick: bool = True,
        quality: str = "fast",
        method: str = "staggered",
    ) -> Smoke:
        """Fill `area` (left, bottom, right, top) with clear air, in which there may be smoke and fire; returns it.

        `cells` is how many cells the longer side has, or (across, up); cells are square, so the area grows to whole
        ones. `buoyancy` is how many times the world's gravity a temperature of 1 rises with; `vorticity` keeps small
        whirls alive; `cooling` and `fade` are the shares of heat and density lost a second. Of the fuel that sources
        bring, the share `burning` burns a second to `heat` and `soot`. `weight` (kg/m2) is how hard it pushes bodies.
        `wind` (m/s) draws it along.

        Walls are all round it unless `open_sides` names some of "left", "right", "bottom", "top", or "all".
        `side_speeds` (m/s) lets a wall slide along itself, which gas with a viscosity follows, unless it does
        not `stick` to walls. `quality` is "fast" or
        "high", which keeps whirls far longer for 1.8 times the time. `method="stam"` is Stam's, as the thesis of 2011
        has it, for comparison: it knows neither bodies nor open sides.

        >>> world = evil.World()
        >>> world.add_smoke((-8, -4, 8, 4), cells=64, open_sides="top").cells
        (64, 32)
        """
        me = "World.add_smoke"
        box = to_area(area, me)
        nx, ny, side = layout(box, cells, me)
        slot = _core.add_smoke(
            self._core,
            nx=nx,
            ny=ny,
            low=box[:2],
            cell=side,
            method=METHODS.index(one_of(method, me, "method", METHODS)),
            quality=QUALITIES.index(one_of(quality, me, "quality", QUALITIES)),
            open=sides(open_sides, me),
            side_speeds=speeds(side_speeds, me),
            stick=flag(stick, me, "stick"),
            colour=to_colour(colour, me, "colour")[:3],
        )
        smoke = Smoke(self, slot)  # type: ignore[arg-type]
        try:
            smoke.viscosity, smoke.diffusion, smoke.buoyancy, smoke.vorticity = (
                viscosity,
                diffusion,
                buoyancy,
                vorticity,
            )
            smoke.cooling, smoke.fade, smoke.burning, smoke.heat, smoke.soot = cooling, fade, burning, heat, soot
            smoke.weight, smoke.wind, smoke.wind_pull = weight, wind, wind_pull
        except BaseException:
            smoke._take_back()
            raise
        return smoke

    @property
    def smokes(self) -> tuple[Smoke, ...]:
        """All smokes, in the order of their slots."""
        return tuple(Smoke(self, slot) for slot in _core.smoke_slots(self._core))  # type: ignore[arg-type]


def one_or_all(ask: Callable[[Any], list[Any]], points: Any, me: str) -> Any:
    """What is asked of one point, or the list of it of many."""
    if points is None:
        raise ArgumentTypeError(f"{me}: points=None must be a point, (x, y), or a list or an array of points")
    shape = getattr(points, "shape", None)  # of an array
    pair = shape is None and isinstance(points, Sequence) and len(points) == 2
    one = not hasattr(points[0], "__len__") if pair else shape == (2,)
    return ask([points])[0] if one else ask(points)


def layout(area: Area, cells: int | Sequence[int], me: str) -> tuple[int, int, float]:
    """How many cells across and up, and the side of one in metres."""
    wide, high = area[2] - area[0], area[3] - area[1]
    if isinstance(cells, int) and not isinstance(cells, bool):
        longer = count(cells, me)
        side = max(wide, high) / longer
        return max(LEAST_CELLS, round(wide / side)), max(LEAST_CELLS, round(high / side)), side
    if isinstance(cells, (str, bytes)) or not isinstance(cells, Sequence) or len(cells) != 2:
        raise ArgumentTypeError(f"{me}: cells={cells!r} must be a whole number, or two: across and up")
    nx, ny = count(cells[0], me), count(cells[1], me)
    if abs(wide / nx - high / ny) > 0.01 * wide / nx:
        fitting = max(LEAST_CELLS, round(nx * high / wide))
        raise ArgumentError(
            f"{me}: cells={cells!r} would not be square in an area of {wide:g} x {high:g} m; ({nx}, {fitting}) would"
        )
    return nx, ny, wide / nx


def count(cells: object, me: str) -> int:
    """A number of cells."""
    if isinstance(cells, bool) or not isinstance(cells, int):
        raise ArgumentTypeError(f"{me}: cells={cells!r} must be a whole number, or two: across and up")
    if not LEAST_CELLS <= cells <= MOST_CELLS:
        raise ArgumentError(f"{me}: cells={cells!r} must be from {LEAST_CELLS} to {MOST_CELLS} each way")
    return cells


def sides(names: str | Iterable[str], me: str) -> tuple[bool, bool, bool, bool]:
    """Which sides are open: left, right, bottom, top."""
    if isinstance(names, str):
        names = SIDES if names == "all" else names.replace(",", " ").split()
    if not isinstance(names, Iterable):
        raise ArgumentTypeError(
            f"{me}: open_sides={names!r} must be sides, such as 'top' or ('left', 'right'), or 'all'"
        )
    chosen = {one_of(name, me, "open_sides", SIDES) for name in names}
    left, right, bottom, top = (side in chosen for side in SIDES)
    return left, right, bottom, top


def speeds(values: Sequence[float], me: str) -> tuple[float, float, float, float]:
    """How fast each side slides."""
    if isinstance(values, (str, bytes)) or not isinstance(values, Sequence) or len(values) != 4:
        raise ArgumentTypeError(f"{me}: side_speeds={values!r} must be four numbers: left, right, bottom, top")
    left, right, bottom, top = (number(value, me, "side_speeds", least=-1e4, most=1e4) for value in values)
    return left, right, bottom, top


def flow(value: Point, me: str, argument: str) -> Vec2:
    """A velocity that gas may have."""
    velocity = speed(value, me)
    if velocity.length > 1e4:
        raise ArgumentError(f"{me}: {argument}={value!r} must be at most 1e4 m/s")
    return velocity


def stirring(
    at: Point, radius: float, velocity: Point, me: str
) -> tuple[tuple[float, float], float, tuple[float, float]]:
    """Where, how far and how fast a hand pushes gas or liquid, as the core takes it."""
    middle, wanted = place(at, me), flow(velocity, me, "velocity")
    return (middle.x, middle.y), number(radius, me, "radius", above=0.0, most=1e4), (wanted.x, wanted.y)
