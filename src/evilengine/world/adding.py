"""What new bodies shall be: checked, and remembered for the next body that is made alike."""

from __future__ import annotations

from evilengine import _core
from evilengine.values.checks import number, one_of
from evilengine.world.arguments import flag
from evilengine.world.body import KINDS
from evilengine.world.traits import given

MAX_SPIN = 1e4
"""Radians a second."""

PLAIN = frozenset({float, int, bool, str, type(None)})
"""Types whose values never change: what was checked once need not be again."""


class Recipes:
    """The recipe that was asked for last: of a thousand bodies made alike in a loop, the first is checked."""

    __slots__ = ("given", "made")

    def __init__(self) -> None:
        self.given: tuple[object, ...] = ()
        self.made: _core.Recipe

    def of(self, me: str, given: tuple[object, ...]) -> _core.Recipe:
        """The recipe for what World.add was given, in the order of `recipe`'s arguments."""
        if not _core.identical(given, self.given):
            made = recipe(me, *given)
            if not all(type(value) in PLAIN for value in given):
                return made
            self.given, self.made = given, made
        return self.made


def recipe(
    me: str,
    kind: object,
    density: object,
    mass: object,
    friction: object,
    restitution: object,
    damping: object,
    angular_damping: object,
    drag: object,
    gravity_scale: object,
    bullet: object,
    touchable: object,
    category: object,
    mask: object,
    group: object,
    sensor: object,
    one_way: object,
    surface_speed: object,
) -> _core.Recipe:
    """Check everything about a new body but where it is and how it moves."""
    return _core.Recipe(
        kind=KINDS.index(one_of(kind, me, "kind", KINDS)),
        density=number(density, me, "density", least=0.0, most=1e9),
        mass=0.0 if mass is None else number(mass, me, "mass", least=1e-12, most=1e12),
        friction=number(friction, me, "friction", least=0.0, most=1e6),
        restitution=number(restitution, me, "restitution", least=0.0, most=1.0),
        damping=number(damping, me, "damping", least=0.0, most=1.0),
        angular_damping=number(angular_damping, me, "angular_damping", least=0.0, most=1.0),
        drag=number(drag, me, "drag", least=0.0, most=1e6),
        gravity_scale=number(gravity_scale, me, "gravity_scale", least=-1e6, most=1e6),
        bullet=flag(bullet, me, "bullet"),
        touchable=flag(touchable, me, "touchable"),
        traits=given(
            category=category,
            mask=mask,
            group=group,
            sensor=sensor,
            one_way=one_way,
            surface_speed=surface_speed,
        ),
        owner=me,
    )
