"""Sensors: shapes that see what overlaps them, and push nothing."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, overload

from evilengine import _core

if TYPE_CHECKING:
    from evilengine.world.body import Body, Shape
    from evilengine.world.world import World


@dataclass(frozen=True, slots=True)
class Visit:
    """A sensor sees a shape of another body."""

    sensor: Body
    visitor: Body
    sensor_shape: Shape
    visitor_shape: Shape


class VisitList(Sequence[Visit]):
    """Visits, one by one or as columns: read-only buffers with a row for each, as `numpy.asarray` takes them."""

    __slots__ = ("_rows", "_world")

    def __init__(self, world: World, rows: _core.Touches) -> None:
        self._world = world
        self._rows = rows

    def __len__(self) -> int:
        return len(self._rows)

    @overload
    def __getitem__(self, index: int) -> Visit: ...
    @overload
    def __getitem__(self, index: slice) -> tuple[Visit, ...]: ...
    def __getitem__(self, index: int | slice) -> Visit | tuple[Visit, ...]:
        numbers = range(len(self._rows))[index]
        if isinstance(numbers, range):
            return tuple(self._visit(number) for number in numbers)
        return self._visit(numbers)

    def _visit(self, number: int) -> Visit:
        a, ga, b, gb, sa, gsa, sb, gsb, *_ = self._rows.row(number)
        body, shape = self._world._body, self._world._shape
        return Visit(body(a, ga), body(b, gb), shape(sa, gsa), shape(sb, gsb))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, (VisitList, tuple, list)) and tuple(self) == tuple(other)

    __hash__ = None  # type: ignore[assignment]

    @property
    def bodies(self) -> _core.Column:
        """(n, 2) uint32: slots of the sensor's body and the visitor's."""
        return self._rows.bodies

    @property
    def shapes(self) -> _core.Column:
        """(n, 2) uint32: slots of the sensor and the visiting shape."""
        return self._rows.shapes

    def __repr__(self) -> str:
        return f"<VisitList, {len(self)}>"


class Sensors:
    """What a world's sensors saw in the last step, sorted by the sensor's body, then the visitor's, then their shapes,
    each by creation.

    A sensor sees bodies of every kind, awake or asleep, where they are after the step; it sees no other sensors.

    >>> world = evil.World()
    >>> goal = world.add(evil.Rectangle(4, 1), kind="static", sensor=True)
    >>> ball = world.add(evil.Circle(0.2), at=(0, 1))
    >>> while not world.sensors.entered:
    ...     world.step()
    >>> world.sensors.entered[0].visitor is ball, goal.visitors == (ball,)
    (True, True)
    """

    __slots__ = ("_world",)

    def __init__(self, world: World) -> None:
        self._world = world

    @property
    def entered(self) -> VisitList:
        """Visits that began in the last step."""
        return VisitList(self._world, self._world._core.entered)

    @property
    def left(self) -> VisitList:
        """Visits that ended in the last step, or whose sensor or visitor was destroyed since the step before."""
        return VisitList(self._world, self._world._core.left)

    @property
    def inside(self) -> VisitList:
        """All visits that go on."""
        return VisitList(self._world, self._world._core.inside)
