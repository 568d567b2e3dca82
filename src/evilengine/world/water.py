"""Water: liquid of particles, round the bodies and in their way (SPEC F5, F7)."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, Any

from evilengine import _core
from evilengine.values.checks import known_keywords, number
from evilengine.values.colour import ColourLike
from evilengine.values.errors import ArgumentError, ArgumentTypeError
from evilengine.values.vec2 import Point, Vec2
from evilengine.world.arguments import place
from evilengine.world.character import Area, to_area
from evilengine.world.liquid import BLUE, MOST_LIQUIDS, Liquid, made_of, of_first
from evilengine.world.pouring import NARROWEST, draining, falling, pouring, shape_of
from evilengine.world.shapes import Circle, ShapeDefinition
from evilengine.world.smoke import LEAST_CELLS, MOST_CELLS, SIDES, flow, one_or_all, sides, stirring
from evilengine.world.smoke import Fluids as Fluids

if TYPE_CHECKING:
    from evilengine.world.body import Body
    from evilengine.world.world import World

CELL = 2
"""Particles along a side of a cell."""

MOST_PARTICLES: int = _core.MOST_PARTICLES
"""Of one water. Streams pour no more then, and `fill` refuses an area that would not fit."""


class Stream(_core.WaterStream):
    """Liquid that comes into a water, or goes from it: `water.pour` and `water.drain` make one.

    `rate`, `velocity` and `running` may be changed at any time.
    """

    __slots__ = ("__weakref__", "_world")

    def __init__(self, world: World, slot: int) -> None:
        super().__init__(world._core, slot)
        self._world = world

    @property
    def rate(self) -> float:
        """Square metres a second that it pours or drains; math.inf for a drain that takes all that it reaches."""
        rate = abs(self._rate)
        return math.inf if self.drains and rate >= _core.MOST_POURING else rate

    @rate.setter
    def rate(self, value: float) -> None:
        drains = self.drains
        rate = draining(value, "Stream", "rate") if drains else pouring(value, "Stream", "rate")
        self._set_rate(-rate if drains else rate)

    @property
    def drains(self) -> bool:
        """Does it take liquid away?"""
        return math.copysign(1.0, self._rate) < 0.0

    @property
    def water(self) -> Water:
        """The water that it pours into, or drains."""
        return Water(self._world, self._water)

    @property
    def liquid(self) -> Liquid:
        """The liquid that it pours."""
        return self.water.liquids[self._liquid]

    @property
    def body(self) -> Body | None:
        """The body that carries it, or None. It goes when that goes."""
        return None if self._body == _core.NO_SLOT else self._world._body(self._body)

    def destroy(self) -> None:
        """End it."""
        self._destroy()

    def __repr__(self) -> str:
        if not self.alive:
            return "<Stream, gone>"
        return f"<Stream {self.slot}, {'drains' if self.drains else 'pours'} {self.rate:g} m2/s>"


class Water(_core.Water):
    """Liquid of particles in a box: `world.add_water` and `game.add_water` make one.

    `positions` and `velocities` are (count, 2) float32 buffers, views without a copy which may be written; `kinds` says
    which of `liquids` each particle is. Ask for them anew after each step: particles change places, and come and go.
    What lies outside the box, or is no number, is brought back by the next step. `density`, `viscosity`,
    `surface_tension` and `colour` are those of the first of `liquids`.

    >>> world = evil.World()
    >>> water = world.add_water((0, 0, 4, 3), particle_size=0.1)
    >>> water.fill((0, 0, 4, 1))
    400
    >>> round(water.volume, 3), water.is_in((2, 0.5)), water.is_in([(2, 0.5), (2, 2)])
    (4.0, True, [True, False])
    """

    __slots__ = ("__weakref__", "_world")

    density, viscosity = of_first("density"), of_first("viscosity")
    surface_tension, colour = of_first("surface_tension"), of_first("colour")

    def __init__(self, world: World, slot: int) -> None:
        super().__init__(world._core, slot)
        self._world = world

    @known_keywords
    def fill(
        self,
        area: Iterable[float] | ShapeDefinition,
        *,
        at: Point = (0.0, 0.0),
        angle: float = 0.0,
        liquid: Liquid | None = None,
        velocity: Point = (0.0, 0.0),
    ) -> int:
        """Fill a box (left, bottom, right, top), or a shape `at` a place, where no body and no liquid is.

        `liquid` is the first of `liquids` unless said; `velocity` (m/s) how it moves. Returns how many particles came.
        Raises ArgumentError where that may be more than a water holds, MOST_PARTICLES.

        >>> water = evil.World().add_water((0, 0, 4, 3), particle_size=0.1)
        >>> water.fill(evil.Circle(0.5), at=(2, 2), velocity=(0, -3))
        80
        >>> water.fill((0, 0, 4, 1)), water.fill((0, 0, 4, 1))
        (400, 0)
        """
        me = "Water.fill"
        index, wanted = self._index_of(liquid, me), flow(velocity, me, "velocity")
        there = self._outline(area, at, angle, me)
        if there is None:
            return 0
        shape, middle, turn, box = there
        come = (box[2] - box[0]) * (box[3] - box[1]) / self.particle_size**2
        if self.count + come > MOST_PARTICLES:
            raise ArgumentError(
                f"{me}: area={area!r} would take up to {come:,.0f} particles, and a water holds {MOST_PARTICLES:,};"
                " make it with a larger particle_size"
            )
        return self._fill(shape._spec, middle, turn, index, (wanted.x, wanted.y))

    @known_keywords
    def clear(
        self, area: Iterable[float] | ShapeDefinition | None = None, *, at: Point = (0.0, 0.0), angle: float = 0.0
    ) -> int:
        """Take out, once, what is in a box (left, bottom, right, top) or a shape; without one, all. Returns how much.

        >>> water = evil.World().add_water((0, 0, 4, 3), particle_size=0.1)
        >>> water.fill((0, 0, 4, 1)), water.clear((0, 0, 1, 1)), water.clear(), water.count
        (400, 100, 300, 0)
        """
        there = self._outline(self.area if area is None else area, at, angle, "Water.clear")
        return 0 if there is None else self._clear(there[0]._spec, *there[1:3])

    @known_keywords
    def pour(
        self,
        at: Point,
        rate: float,
        velocity: Point | None = None,
        *,
        radius: float | None = None,
        shape: ShapeDefinition | None = None,
        angle: float = 0.0,
        body: Body | None = None,
        liquid: Liquid | None = None,
    ) -> Stream:
        """Let liquid come out of a circle of `radius`, or any shape with an inside, `at` a place; returns its handle.

        `rate` is square metres a second, `velocity` (m/s) how it comes out; it falls out unless said. The circle is as
        wide as the liquid needs at that speed. With a `body`, place and velocity are in that body's frame. What
        finds no room between bodies and liquid does not come: in a full box, or inside a solid, nothing does.

        >>> world = evil.World(); water = world.add_water((0, 0, 4, 3), particle_size=0.1)
        >>> tap = water.pour((2, 2.5), rate=2, velocity=(0, -3))
        >>> for _ in range(60):
        ...     world.step()
        >>> 1.9 < water.volume < 2.1
        True
        >>> tap.running = False; tap.destroy()
        """
        me = "Water.pour"
        amount = pouring(rate, me, "rate")
        falls = falling(self._world.gravity, carried=body is not None)
        wanted = falls if velocity is None else flow(velocity, me, "velocity")
        index, carrier = self._index_of(liquid, me), self._carrier(body, me)
        if shape is not None and radius is not None:
            raise ArgumentError(f"{me}: give either a shape or radius=, the radius of a circle in metres")
        if shape is None:
            wide = max(NARROWEST * self.particle_size, 0.5 * amount / max(wanted.length, 1.0))
            shape = Circle(wide if radius is None else number(radius, me, "radius", above=0.0, most=1e4))
        elif not isinstance(shape, ShapeDefinition):
            raise ArgumentTypeError(f"{me}: shape={shape!r} must be a shape such as evil.Rectangle(2, 1)")
        return self._add_stream(shape, place(at, me), number(angle, me, "angle"), amount, wanted, carrier, index)

    @known_keywords
    def drain(
        self,
        area: Iterable[float] | ShapeDefinition,
        *,
        at: Point = (0.0, 0.0),
        angle: float = 0.0,
        rate: float = math.inf,
        body: Body | None = None,
    ) -> Stream:
        """Let liquid go, from now on, where a box (left, bottom, right, top) or a shape is; returns its handle.

        `rate` is how many square metres a second at most. With a `body` the area is in its frame and goes with it. To
        take liquid out once, see `clear`.

        >>> world = evil.World(); water = world.add_water((0, 0, 4, 3), particle_size=0.1)
        >>> _ = water.fill((0, 0, 4, 1)); drain = water.drain((0, 0, 4, 1), rate=2)
        >>> for _ in range(60):
        ...     world.step()
        >>> 1.9 < water.volume < 2.1
        True
        """
        me = "Water.drain"
        carrier, amount = self._carrier(body, me), draining(rate, me, "rate")
        shape, middle, turn = shape_of(area, at, angle, me)
        return self._add_stream(shape, middle, turn, -amount, Vec2(0.0, 0.0), carrier, 0)

    @known_keywords
    def add_liquid(
        self,
        *,
        density: float = 1.0,
        viscosity: float = 0.0,
        surface_tension: float = 0.0,
        colour: ColourLike = BLUE,
    ) -> Liquid:
        """Make one more liquid that this water may be filled with: oil, which floats on it. There may be 16.

        >>> water = evil.World().add_water((0, 0, 4, 3))
        >>> oil = water.add_liquid(density=0.8, colour="gold", viscosity=0.01)
        >>> len(water.liquids), water.liquids[1] == oil
        (2, True)
        """
        me = "Water.add_liquid"
        made = made_of(density, viscosity, surface_tension, colour, me)
        if len(self._liquid_serials()) >= MOST_LIQUIDS:
            raise ArgumentError(f"{me}: a water has at most {MOST_LIQUIDS} liquids")
        return Liquid(self, len(self._liquid_serials()), self._add_liquid(*made))

    @property
    def liquids(self) -> tuple[Liquid, ...]:
        """Its liquids: first the one that it was made with, then those that were added."""
        return tuple(Liquid(self, index, serial) for index, serial in enumerate(self._liquid_serials()))

    @property
    def streams(self) -> tuple[Stream, ...]:
        """What pours into it and drains it, in the order of their slots."""
        return tuple(Stream(self._world, slot) for slot in self._streams())

    @property
    def volume(self) -> float:
        """Square metres of liquid."""
        return self.count * self.particle_size**2

    @property
    def open_sides(self) -> tuple[str, ...]:
        """The sides by which liquid may leave."""
        return tuple(side for side, is_open in zip(SIDES, self._open, strict=True) if is_open)

    @known_keywords
    def stir(self, at: Point, *, radius: float, velocity: Point) -> None:
        """Push the liquid round a point by hand: in its middle to `velocity`, less towards `radius`.

        >>> water = evil.World().add_water((0, 0, 4, 4)); _ = water.fill((0, 0, 4, 2))
        >>> water.stir((2, 1), radius=1, velocity=(3, 0))
        >>> water.velocity_at((2, 1)).x > 2
        True
        """
        self._stir(*stirring(at, radius, velocity, "Water.stir"))

    @known_keywords
    def velocity_at(self, points: Any) -> Any:
        """The velocity (m/s) of the liquid at a point, as a Vec2, or at each of a list or an array of points."""
        return one_or_all(self._velocity_at, points, "Water.velocity_at")

    @known_keywords
    def density_at(self, points: Any) -> Any:
        """The density (kg/m2) round a point, or round each of many: about that of the liquid there, 0 in the air."""
        return one_or_all(self._density_at, points, "Water.density_at")

    @known_keywords
    def is_in(self, points: Any) -> Any:
        """Is there liquid at a point, or at each of many?"""
        return one_or_all(self._is_in, points, "Water.is_in")

    @known_keywords
    def depth_at(self, points: Any) -> Any:
        """How many metres of liquid lie over a point, against gravity, or over each of many; 0 in the air.

        >>> water = evil.World().add_water((0, 0, 4, 4)); _ = water.fill((0, 0, 4, 2))
        >>> round(water.depth_at((2, 0.5)), 1), water.depth_at((2, 3))
        (1.5, 0.0)
        """
        return one_or_all(self._depth_at, points, "Water.depth_at")

    def destroy(self) -> None:
        """Take it and its streams out of the world."""
        self._destroy()

    def _index_of(self, liquid: Liquid | None, me: str) -> int:
        if liquid is None:
            return 0
        if not isinstance(liquid, Liquid):
            raise ArgumentTypeError(f"{me}: liquid={liquid!r} must be one of water.liquids")
        if liquid._water != self:
            raise ArgumentError(f"{me}: liquid={liquid!r} is of another water; make one with add_liquid of this one")
        _ = liquid.density  # raises StaleReferenceError
        return liquid._index

    def _carrier(self, body: Body | None, me: str) -> int:
        return _core.NO_SLOT if body is None else self._world._own_body(body, me, "body").slot

    def _outline(
        self, area: Iterable[float] | ShapeDefinition, at: Point, angle: float, me: str
    ) -> tuple[ShapeDefinition, Vec2, float, Area] | None:
        """A shape with its place and its bounds, as far as they are in this water; None where nothing of it is."""
        mine = self.area
        if isinstance(area, ShapeDefinition):
            return (*shape_of(area, at, angle, me), mine)
        left, bottom, right, top = to_area(area, me)
        box = (max(left, mine[0]), max(bottom, mine[1]), min(right, mine[2]), min(top, mine[3]))
        if not (box[0] < box[2] and box[1] < box[3]):
            return None
        return (*shape_of(box, at, angle, me), box)

    def _add_stream(
        self, shape: ShapeDefinition, at: Vec2, angle: float, rate: float, velocity: Vec2, body: int, liquid: int
    ) -> Stream:
        slot = _core.add_stream(
            self._world._core,
            water=self._live().slot,
            body=body,
            shape=shape._spec,
            at=at,
            angle=angle,
            rate=rate,
            velocity=(velocity.x, velocity.y),
            liquid=liquid,
        )
        return Stream(self._world, slot)

    def _live(self) -> Water:
        _ = self.count  # raises StaleReferenceError
        return self

    def __len__(self) -> int:
        return self.count

    def __bool__(self) -> bool:
        return True  # an empty one too

    def __repr__(self) -> str:
        return f"<Water {self.slot}, {self.count} particles>" if self.alive else "<Water, gone>"


class Waters(Fluids):
    """What a world knows of its waters."""

    @known_keywords
    def add_water(
        self,
        area: Iterable[float],
        *,
        particle_size: float = 0.1,
        viscosity: float = 0.0,
        surface_tension: float = 0.0,
        density: float = 1.0,
        colour: ColourLike = BLUE,
        open_sides: str | Iterable[str] = (),
    ) -> Water:
        """Make a box (left, bottom, right, top) that may hold liquid, empty at first; returns it.

        A particle stands for a square of side `particle_size` (metres): half of it, and there are four times as many.
        Walls are all round unless `open_sides` names some of "left", "right", "bottom", "top", or "all": liquid that
        leaves by one is gone. `density` (kg/m2) is compared with that of shapes: 1 is what a shape has that is told
        nothing else. `viscosity` (m2/s) makes it thick, `surface_tension` (N/m) draws it together.

        >>> world = evil.World()
        >>> world.add_water((0, 0, 4, 3), particle_size=0.1)
        <Water 0, 0 particles>
        """
        me = "World.add_water"
        box = to_area(area, me)
        size = number(particle_size, me, "particle_size", above=0.0, most=1e4)
        wide, high = box[2] - box[0], box[3] - box[1]
        least = max(wide, high) / (CELL * (MOST_CELLS + 0.4))
        if size < least:
            raise ArgumentError(
                f"{me}: particle_size={particle_size!r} is too small for this area; at least {least:.2g} fits"
            )
        nx, ny = (max(LEAST_CELLS, round(side / (CELL * size))) for side in (wide, high))
        thickness, tension = viscosity, surface_tension
        liquid = made_of(density, thickness, tension, colour, me)
        slot = _core.add_water(
            self._core,
            nx=nx,
            ny=ny,
            low=box[:2],
            particle_size=size,
            open=sides(open_sides, me),
            density=liquid[0],
            viscosity=liquid[1],
            surface_tension=liquid[2],
            colour=liquid[3],
        )
        return Water(self, slot)  # type: ignore[arg-type]

    @property
    def waters(self) -> tuple[Water, ...]:
        """All waters, in the order of their slots."""
        return tuple(Water(self, slot) for slot in _core.water_slots(self._core))  # type: ignore[arg-type]


def liquids_of(world: Waters) -> Iterator[Liquid]:
    """Those of all its waters."""
    return (liquid for water in world.waters for liquid in water.liquids)
