"""Checks of what World.add and its neighbours are given."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

from evilengine import _core
from evilengine.values.errors import ArgumentError, ArgumentTypeError
from evilengine.values.vec2 import Vec2, to_vec2
from evilengine.world.body import Body
from evilengine.world.shapes import ShapeDefinition, to_shape

MAX_SPEED = 1e5
"""Metres a second; beyond it, positions lose their decimals within a second."""

WORLD_EDGE = 1e7
"""Metres from the origin: a body that gets there stays there."""


def parts_of(shape: object, owner: str) -> tuple[Sequence[ShapeDefinition], Sequence[_core.ShapeSpec]]:
    """The shape or shapes that were given, and each as the core takes it."""
    if isinstance(shape, ShapeDefinition):
        return (shape,), (shape._spec,)
    shapes = several(shape, owner)
    return shapes, [one._spec for one in shapes]


def several(shapes: object, owner: str) -> list[ShapeDefinition]:
    if isinstance(shapes, Iterable) and not isinstance(shapes, (str, bytes)):
        found = [to_shape(shape, owner) for shape in shapes]
        if found:
            return found
    return [to_shape(shapes, owner)]


def listed(bodies: object) -> list[Any]:
    if isinstance(bodies, Body):
        return [bodies]
    if not isinstance(bodies, Iterable):
        raise ArgumentTypeError(f"World.add_force: bodies={bodies!r} must be a list of bodies, or None for all")
    return list(bodies)


def flag(value: object, owner: str, argument: str) -> bool:
    if not isinstance(value, bool):
        raise ArgumentTypeError(f"{owner}: {argument}={value!r} must be True or False")
    return value


def place(value: object, owner: str, argument: str = "at") -> Vec2:
    at = to_vec2(value, owner, argument)
    if at.length > WORLD_EDGE:
        raise ArgumentError(f"{owner}: {argument}={value!r} must be within {WORLD_EDGE:g} metres of the origin")
    return at


def speed(value: object, owner: str) -> Vec2:
    velocity = to_vec2(value, owner, "velocity")
    if max(abs(velocity.x), abs(velocity.y)) > MAX_SPEED:
        raise ArgumentError(f"{owner}: velocity={value!r} must be at most {MAX_SPEED:g} m/s along each axis")
    return velocity
