"""Sensors: shapes that see what overlaps them, and push nothing."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from evilengine.world.touches import TouchList

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


class VisitList(TouchList[Visit]):
    """Visits, one by one or as columns: read-only buffers with a row for each, as `numpy.asarray` takes them. a is the
    sensor, b the visitor."""

    __slots__ = ()

    def _made(self, number: int) -> Visit:
        a, ga, b, gb, sa, gsa, sb, gsb, *_ = self._rows.row(number)
        body, shape = self._world._body, self._world._shape
        return Visit(body(a, ga), body(b, gb), shape(sa, gsa), shape(sb, gsb))


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
