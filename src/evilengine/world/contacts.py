"""Contacts: who touches whom after a step (SPEC C10)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from evilengine.values.errors import ArgumentError
from evilengine.values.vec2 import Vec2

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


@dataclass(frozen=True, slots=True)
class RayHit:
    """Where a ray enters a shape."""

    body: Body
    shape: Shape
    point: Vec2
    normal: Vec2
    """Direction of length 1 out of the shape."""
    fraction: float
    """How far along the ray, 0 at its start, 1 at its end."""


class Contacts:
    """The contacts of a world after its last step, in an order that is part of the promise: that of creation."""

    __slots__ = ("_world",)

    def __init__(self, world: World) -> None:
        self._world = world

    @property
    def begun(self) -> tuple[Contact, ...]:
        """Those that began in the last step."""
        return self._all(self._world._core.begun)

    @property
    def ended(self) -> tuple[Contact, ...]:
        """Those that ended in the last step, or whose body was destroyed since the step before."""
        return self._all(self._world._core.ended)

    @property
    def active(self) -> tuple[Contact, ...]:
        """All that touch."""
        return self._all(self._world._core.active)

    def _all(self, rows: list[tuple[Any, ...]]) -> tuple[Contact, ...]:
        body, shape = self._world._body, self._world._shape
        return tuple(
            Contact(body(a, ga), body(b, gb), shape(sa, gsa), shape(sb, gsb), *rest)
            for a, ga, b, gb, sa, gsa, sb, gsb, *rest in rows
        )
