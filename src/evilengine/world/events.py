"""What happened in the last step, besides contacts: who fell asleep, who woke."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from evilengine.world.body import Body
    from evilengine.world.joints import BrokenJoint
    from evilengine.world.world import World


class Events:
    """What the last step did to bodies, each list in the order in which they were created.

    >>> world = evil.World()
    >>> floor = world.add(evil.Rectangle(4, 1), kind="static")
    >>> box = world.add(evil.Rectangle(1, 1), at=(0, 1))
    >>> while box.awake:
    ...     world.step()
    >>> world.events.slept == (box,)
    True
    """

    __slots__ = ("_world",)

    def __init__(self, world: World) -> None:
        self._world = world

    @property
    def slept(self) -> tuple[Body, ...]:
        """Bodies that fell asleep in the last step, or were put to sleep since the step before."""
        return self._bodies(self._world._core.slept)

    @property
    def woke(self) -> tuple[Body, ...]:
        """Bodies that slept before the last step and are awake after it."""
        return self._bodies(self._world._core.woke)

    @property
    def broken(self) -> tuple[BrokenJoint, ...]:
        """Joints that broke in the last step; the same as `world.joints.broken`."""
        return self._world._broken_joints

    def _bodies(self, references: list[tuple[int, int]]) -> tuple[Body, ...]:
        return tuple(self._world._body(slot, generation) for slot, generation in references)
