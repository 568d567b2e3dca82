"""Questions to a world (SPEC C9): rays, points, overlaps, what is nearest; one at a time and many at once."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, TypeAlias

from evilengine import _core
from evilengine.values.checks import known_keywords, number, one_of
from evilengine.values.errors import ArgumentError, ArgumentTypeError
from evilengine.values.vec2 import Point
from evilengine.world.arguments import flag
from evilengine.world.body import KINDS, Body
from evilengine.world.shapes import ShapeDefinition, to_shape

RayHit = _core.RayHit
RayHits = _core.RayHits
Nearest = _core.Nearest
Nearests = _core.Nearests
BodyLists = _core.BodyLists

Points: TypeAlias = object
"""A buffer of float32 or float64 of shape (n, 2), such as a NumPy array or `world.bodies.positions`; or a list of
points; or one point, which stands for all."""

EVERY_KIND = (1 << len(KINDS)) - 1
SENSORS = 1 << len(KINDS)
ALL = 0xFFFFFFFF
"""Every category."""
FARTHEST = 1e8
"""Metres: from edge to edge of the world and more."""


class Queries:
    """What can be asked of a world. Nothing here changes it; asked inside a callback, the answer is of that moment.

    Every question takes `kind`, one of "static", "kinematic" and "dynamic" or several of them; `mask`, the bits of the
    categories that it is about; `ignore`, a body or several that it is not about; `sensors=True` to find sensors too.
    """

    _core: _core.World

    if TYPE_CHECKING:

        def _body(self, slot: int, generation: int | None = None) -> Body: ...
        def _own_body(self, body: object, owner: str, argument: str) -> Body: ...

    # -- one at a time --

    @known_keywords
    def ray_cast(
        self,
        start: Point,
        end: Point,
        *,
        kind: str | Iterable[str] | None = None,
        mask: int = ALL,
        ignore: Body | Iterable[Body] | None = None,
        sensors: bool = False,
    ) -> RayHit | None:
        """First shape that the segment from `start` to `end` enters (world coordinates, metres), or None.

        A shape that the segment starts in does not count. Of two at the very same place, it is the one that was created
        first. Both ends must be within 1e7 metres of the origin.

        >>> world = evil.World(); wall = world.add(evil.Rectangle(1, 4), at=(5, 0), kind="static")
        >>> hit = world.ray_cast((0, 0), (10, 0))
        >>> hit.body is wall, hit.point, hit.normal
        (True, Vec2(4.5, 0.0), Vec2(-1.0, 0.0))
        >>> world.ray_cast((0, 0), (10, 0), ignore=wall) is None
        True
        """
        if kind is None and ignore is None and mask == ALL and not sensors:
            return self._core.ray_cast(self, start, end, EVERY_KIND, ALL, ())
        return self._core.ray_cast(self, start, end, *self._whom(kind, mask, ignore, sensors, "World.ray_cast"))

    @known_keywords
    def ray_cast_all(
        self,
        start: Point,
        end: Point,
        *,
        kind: str | Iterable[str] | None = None,
        mask: int = ALL,
        ignore: Body | Iterable[Body] | None = None,
        sensors: bool = False,
    ) -> tuple[RayHit, ...]:
        """Every shape that the segment from `start` to `end` enters, each once, from start to end.

        >>> world = evil.World(); boxes = [world.add(evil.Rectangle(1, 1), at=(x, 0)) for x in (6, 3)]
        >>> [hit.body is box for hit, box in zip(world.ray_cast_all((0, 0), (9, 0)), reversed(boxes))]
        [True, True]
        """
        return self._core.ray_cast_all(self, start, end, *self._whom(kind, mask, ignore, sensors, "World.ray_cast_all"))

    @known_keywords
    def shape_cast(
        self,
        shape: ShapeDefinition,
        start: Point,
        end: Point,
        *,
        angle: float = 0.0,
        kind: str | Iterable[str] | None = None,
        mask: int = ALL,
        ignore: Body | Iterable[Body] | None = None,
        sensors: bool = False,
    ) -> RayHit | None:
        """First shape that `shape`, turned by `angle`, touches when it moves straight from `start` to `end`, or None.

        `point` is where the two touch, `normal` points out of what was met. What it touches or overlaps from the start
        is met at once, with fraction 0, if the way leads into it; if it leads along it or out of it, not at all.

        >>> world = evil.World(); wall = world.add(evil.Rectangle(1, 4), at=(5, 0), kind="static")
        >>> hit = world.shape_cast(evil.Circle(0.5), (0, 0), (8, 0))
        >>> hit.body is wall, round(hit.fraction, 3), round(hit.point.x, 2)
        (True, 0.5, 4.5)
        """
        me = "World.shape_cast"
        spec = to_shape(shape, me)._spec
        return self._core.shape_cast(
            self, spec, start, end, number(angle, me, "angle"), *self._whom(kind, mask, ignore, sensors, me)
        )

    @known_keywords
    def shape_cast_all(
        self,
        shape: ShapeDefinition,
        start: Point,
        end: Point,
        *,
        angle: float = 0.0,
        kind: str | Iterable[str] | None = None,
        mask: int = ALL,
        ignore: Body | Iterable[Body] | None = None,
        sensors: bool = False,
    ) -> tuple[RayHit, ...]:
        """Every shape that `shape` would touch on its way, each once, from start to end.

        >>> world = evil.World(); boxes = [world.add(evil.Rectangle(1, 1), at=(x, 0)) for x in (6, 3)]
        >>> [hit.body is box for hit, box in zip(world.shape_cast_all(evil.Circle(1), (0, 0), (9, 0)), boxes[::-1])]
        [True, True]
        """
        me = "World.shape_cast_all"
        spec = to_shape(shape, me)._spec
        return self._core.shape_cast_all(
            self, spec, start, end, number(angle, me, "angle"), *self._whom(kind, mask, ignore, sensors, me)
        )

    @known_keywords
    def bodies_at(
        self,
        point: Point,
        *,
        kind: str | Iterable[str] | None = None,
        mask: int = ALL,
        ignore: Body | Iterable[Body] | None = None,
        sensors: bool = False,
    ) -> tuple[Body, ...]:
        """Bodies with a shape over the point, in creation order.

        >>> world = evil.World(); box = world.add(evil.Rectangle(2, 2))
        >>> world.bodies_at((0.5, 0.5)) == (box,), world.bodies_at((5, 5))
        (True, ())
        """
        slots = self._core.bodies_at(point, *self._whom(kind, mask, ignore, sensors, "World.bodies_at"))
        return tuple(self._body(slot) for slot in slots)

    @known_keywords
    def overlapping(
        self,
        shape: ShapeDefinition,
        *,
        at: Point = (0.0, 0.0),
        angle: float = 0.0,
        kind: str | Iterable[str] | None = None,
        mask: int = ALL,
        ignore: Body | Iterable[Body] | None = None,
        sensors: bool = False,
    ) -> tuple[Body, ...]:
        """Bodies that `shape`, placed `at` and turned by `angle`, would overlap, in creation order.

        `at` must be within 1e7 metres of the origin, where the world ends.

        >>> world = evil.World(); box = world.add(evil.Rectangle(2, 2))
        >>> world.overlapping(evil.Circle(1), at=(1.5, 0)) == (box,)
        True
        """
        me = "World.overlapping"
        spec = to_shape(shape, me)._spec
        slots = self._core.overlapping(
            spec, at, number(angle, me, "angle"), *self._whom(kind, mask, ignore, sensors, me)
        )
        return tuple(self._body(slot) for slot in slots)

    @known_keywords
    def nearest(
        self,
        point: Point,
        *,
        within: float = FARTHEST,
        kind: str | Iterable[str] | None = None,
        mask: int = ALL,
        ignore: Body | Iterable[Body] | None = None,
        sensors: bool = False,
    ) -> Nearest | None:
        """The shape nearest to `point`, and where: or None when none is `within` so many metres.

        >>> world = evil.World(); box = world.add(evil.Rectangle(2, 2), at=(5, 0))
        >>> near = world.nearest((1, 0))
        >>> near.body is box, near.point, near.distance
        (True, Vec2(4.0, 0.0), 3.0)
        """
        me = "World.nearest"
        reach = number(within, me, "within", least=0.0, most=FARTHEST)
        return self._core.nearest(self, point, reach, *self._whom(kind, mask, ignore, sensors, me))

    # -- many at once --

    @known_keywords
    def ray_casts(
        self,
        starts: Points,
        ends: Points,
        *,
        kind: str | Iterable[str] | None = None,
        mask: int = ALL,
        ignore: Body | Iterable[Body] | None = None,
        sensors: bool = False,
    ) -> RayHits:
        """Many `ray_cast`s in one call: columns with a row for each ray, made without an object for each.

        `starts` and `ends` are buffers of float32 or float64 of shape (n, 2), such as NumPy arrays, or lists of points;
        one point stands for all. The columns `bodies`, `shapes`, `points`, `normals` and `fractions` are memoryviews,
        which `numpy.asarray` takes without a copy; `hits[i]` is what `ray_cast` would have given.

        >>> world = evil.World(); wall = world.add(evil.Rectangle(1, 4), at=(5, 0), kind="static")
        >>> hits = world.ray_casts((0, 0), [(10, 0), (0, 10)])
        >>> hits.bodies.tolist() == [wall.slot, -1], hits.fractions.tolist(), hits[1]
        (True, [0.44999998807907104, 1.0], None)
        """
        return self._core.ray_casts(self, starts, ends, *self._whom(kind, mask, ignore, sensors, "World.ray_casts"))

    @known_keywords
    def shape_casts(
        self,
        shape: ShapeDefinition,
        starts: Points,
        ends: Points,
        *,
        angle: object = 0.0,
        kind: str | Iterable[str] | None = None,
        mask: int = ALL,
        ignore: Body | Iterable[Body] | None = None,
        sensors: bool = False,
    ) -> RayHits:
        """Many `shape_cast`s with one shape in one call; `angle` is a number, or one for each. Columns as `ray_casts`.

        >>> world = evil.World(); wall = world.add(evil.Rectangle(1, 4), at=(5, 0), kind="static")
        >>> world.shape_casts(evil.Circle(0.5), [(0, 0), (0, 9)], [(8, 0), (8, 9)]).bodies.tolist() == [wall.slot, -1]
        True
        """
        me = "World.shape_casts"
        spec = to_shape(shape, me)._spec
        return self._core.shape_casts(self, spec, starts, ends, angle, *self._whom(kind, mask, ignore, sensors, me))

    @known_keywords
    def bodies_at_each(
        self,
        points: Points,
        *,
        kind: str | Iterable[str] | None = None,
        mask: int = ALL,
        ignore: Body | Iterable[Body] | None = None,
        sensors: bool = False,
    ) -> BodyLists:
        """Many `bodies_at` in one call: `found[i]` is the tuple of bodies over point i.

        >>> world = evil.World(); box = world.add(evil.Rectangle(2, 2))
        >>> found = world.bodies_at_each([(5, 5), (0.5, 0)])
        >>> found[0], found[1] == (box,), found.starts.tolist()
        ((), True, [0, 0, 1])
        """
        return self._core.bodies_at_each(self, points, *self._whom(kind, mask, ignore, sensors, "World.bodies_at_each"))

    @known_keywords
    def overlapping_each(
        self,
        shape: ShapeDefinition,
        at: Points,
        *,
        angle: object = 0.0,
        kind: str | Iterable[str] | None = None,
        mask: int = ALL,
        ignore: Body | Iterable[Body] | None = None,
        sensors: bool = False,
    ) -> BodyLists:
        """Many `overlapping` in one call, with one shape at many places; `angle` is a number, or one for each place.

        >>> world = evil.World(); box = world.add(evil.Rectangle(2, 2))
        >>> [bodies == (box,) for bodies in world.overlapping_each(evil.Circle(1), [(1.5, 0), (9, 0)])]
        [True, False]
        """
        me = "World.overlapping_each"
        return self._core.overlapping_each(
            self, to_shape(shape, me)._spec, at, angle, *self._whom(kind, mask, ignore, sensors, me)
        )

    @known_keywords
    def nearest_each(
        self,
        points: Points,
        *,
        within: float = FARTHEST,
        kind: str | Iterable[str] | None = None,
        mask: int = ALL,
        ignore: Body | Iterable[Body] | None = None,
        sensors: bool = False,
    ) -> Nearests:
        """Many `nearest` in one call: columns `bodies`, `shapes`, `points`, `distances`; `found[i]`, a Nearest or None.

        >>> world = evil.World(); box = world.add(evil.Rectangle(2, 2), at=(5, 0))
        >>> world.nearest_each([(1, 0), (5, 3)]).distances.tolist()
        [3.0, 2.0]
        """
        me = "World.nearest_each"
        reach = number(within, me, "within", least=0.0, most=FARTHEST)
        return self._core.nearest_each(self, points, reach, *self._whom(kind, mask, ignore, sensors, me))

    def _whom(
        self,
        kind: str | Iterable[str] | None,
        mask: int,
        ignore: Body | Iterable[Body] | None,
        sensors: bool,
        me: str,
    ) -> tuple[int, int, tuple[int, ...]]:
        """What the core takes for `kind`, `mask`, `ignore` and `sensors`."""
        bodies: tuple[int, ...] = ()
        if ignore is not None:
            if not isinstance(ignore, Body) and not isinstance(ignore, Iterable):
                raise ArgumentTypeError(f"{me}: ignore={ignore!r} must be a Body, or several")
            several = [ignore] if isinstance(ignore, Body) else ignore
            bodies = tuple(self._own_body(body, me, "ignore").slot for body in several)
        if isinstance(mask, bool) or not isinstance(mask, int) or not 0 <= mask <= ALL:
            raise ArgumentError(f"{me}: mask={mask!r} must be a whole number of 32 bits, such as 0b101")
        kinds = EVERY_KIND if kind is None else kinds_as_bits(kind, me)
        return kinds | (SENSORS if flag(sensors, me, "sensors") else 0), mask, bodies


def kinds_as_bits(kind: str | Iterable[str], me: str) -> int:
    """A bit for each kind that is named."""
    if not isinstance(kind, str) and not isinstance(kind, Iterable):
        raise ArgumentTypeError(f"{me}: kind={kind!r} must be one of {', '.join(map(repr, KINDS))}, or several")
    words = [kind] if isinstance(kind, str) else list(kind)
    if not words:
        raise ArgumentError(f"{me}: kind={kind!r} is empty, so nothing could be found; leave it out for all kinds")
    bits = 0
    for word in words:
        bits |= 1 << KINDS.index(one_of(word, me, "kind", KINDS))
    return bits
