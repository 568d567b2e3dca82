"""All bodies of a world, one by one and as arrays."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from evilengine import _core
from evilengine.world.body import Body

if TYPE_CHECKING:
    from evilengine.world.world import World


class Bodies:
    """A world's bodies in creation order, and their values as arrays with a row for each slot (`body.slot`).

    The arrays are views without a copy, refreshed after each step; `numpy.asarray(world.bodies.positions)` works. A row
    whose slot is free holds zeros.
    """

    __slots__ = ("_world",)

    def __init__(self, world: World) -> None:
        self._world = world

    def __len__(self) -> int:
        return self._world._core.body_count

    def __iter__(self) -> Iterator[Body]:
        return iter([self._world._body(slot) for slot in self._world._core.body_slots()])

    def __contains__(self, body: object) -> bool:
        return isinstance(body, Body) and body._world is self._world and body.alive

    @property
    def positions(self) -> _core.View:
        """(n, 2) float32: where each body's origin is."""
        return self._world._core.positions

    @property
    def angles(self) -> _core.View:
        """(n,) float32: radians."""
        return self._world._core.angles

    @property
    def velocities(self) -> _core.View:
        """(n, 2) float32: metres a second."""
        return self._world._core.velocities

    @property
    def matrices(self) -> _core.View:
        """(n, 16) float32: body to world, column by column."""
        return self._world._core.matrices

    def __repr__(self) -> str:
        return f"<Bodies, {len(self)}>"
