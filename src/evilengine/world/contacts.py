"""Contacts: who touches whom after a step (SPEC C10)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from evilengine.values.errors import ArgumentError
from evilengine.values.vec2 import Vec2
from evilengine.world.touches import TouchList

if TYPE_CHECKING:
    from evilengine.world.body import Body, Shape
    from evilengine.world.world import World


@dataclass(frozen=True, slots=True)
class Contact:
    """Two shapes that touch. `a` is the body that was created first."""

    a: Body
    b: Body
    shape_a: Shape
    shape_b: Shape
    point: Vec2
    """Where, in the world: the mean of the contact's points, weighted by how hard each pushed."""
    normal: Vec2
    """Direction of length 1 from a to b."""
    depth: float
    """Metres of overlap at the deepest point, 0 when they just touch."""
    impulse: float
    """Newton seconds along the normal in the last step: how hard they pushed each other."""
    speed: float
    """Metres a second at which they came together, before the step pushed them apart; 0 or less when they did not."""

    def other(self, body: Body) -> Body:
        """The one of the two that is not `body`."""
        if body == self.a:
            return self.b
        if body == self.b:
            return self.a
        raise ArgumentError(f"Contact.other({body!r}): this contact is between {self.a!r} and {self.b!r}")


class ContactList(TouchList[Contact]):
    """Contacts, one by one or, for bulk readers, as columns: read-only buffers with a row for each, which
    `numpy.asarray` takes as they are.

    It stays as it is while the world goes on; bodies that are destroyed meanwhile are stale in it.

    >>> world = evil.World()
    >>> floor = world.add(evil.Rectangle(4, 1), kind="static")
    >>> box = world.add(evil.Rectangle(1, 1), at=(0, 1))
    >>> world.step()
    >>> contacts = world.contacts.active
    >>> contacts[0].b is box, contacts.bodies.tolist(), contacts.depths.shape
    (True, [[0, 1]], (1,))
    """

    __slots__ = ()

    def _made(self, number: int) -> Contact:
        a, ga, b, gb, sa, gsa, sb, gsb, *rest = self._rows.row(number)
        body, shape = self._world._body, self._world._shape
        return Contact(body(a, ga), body(b, gb), shape(sa, gsa), shape(sb, gsb), *rest)

    @property
    def points(self) -> memoryview:
        """(n, 2) float32: metres, in the world."""
        return self._rows.points

    @property
    def normals(self) -> memoryview:
        """(n, 2) float32: from a to b."""
        return self._rows.normals

    @property
    def depths(self) -> memoryview:
        """(n,) float32: metres."""
        return self._rows.depths

    @property
    def impulses(self) -> memoryview:
        """(n,) float32: newton seconds."""
        return self._rows.impulses

    @property
    def speeds(self) -> memoryview:
        """(n,) float32: metres a second."""
        return self._rows.speeds


class Contacts:
    """The contacts of a world after its last step, in an order that is part of the promise, that of creation: by the
    older of the two bodies, then the younger, then their shapes.
    """

    __slots__ = ("_world",)

    def __init__(self, world: World) -> None:
        self._world = world

    @property
    def begun(self) -> ContactList:
        """Those that began in the last step."""
        return ContactList(self._world, self._world._core.begun)

    @property
    def ended(self) -> ContactList:
        """Those that ended in the last step, or whose body was destroyed since the step before.

        Point and normal are those of their last touch; depth, impulse and speed are 0.
        """
        return ContactList(self._world, self._world._core.ended)

    @property
    def hit(self) -> ContactList:
        """Those whose bodies came together faster than `world.hit_speed` in the last step and pushed each other.

        One that has just hit does not hit again in the next step.
        """
        return ContactList(self._world, self._world._core.hit)

    @property
    def active(self) -> ContactList:
        """All that touch, worked out when asked: where bodies are now."""
        return ContactList(self._world, self._world._core.active)
