"""What streams and areas of liquid are told: how much comes and goes, how fast, and where."""

from __future__ import annotations

import math
from collections.abc import Iterable

from evilengine import _core
from evilengine.values.checks import number
from evilengine.values.errors import ArgumentError
from evilengine.values.vec2 import Point, Vec2
from evilengine.world.arguments import place
from evilengine.world.character import to_area
from evilengine.world.shapes import Rectangle, ShapeDefinition

NARROWEST = 2.0
"""Particles: half the width of a stream that says nothing of it."""

FALLING = 2.5
"""m/s of a stream that says nothing of it: slower, it would come apart in lumps as it falls."""


def falling(gravity: Vec2, *, carried: bool) -> Vec2:
    """How what is poured comes out where nobody says it: down; of a body, as that moves."""
    return Vec2(0.0, 0.0) if carried or gravity.length == 0.0 else FALLING * gravity / gravity.length


def pouring(rate: float, me: str, argument: str) -> float:
    """Square metres a second that a stream pours."""
    return number(rate, me, argument, least=0.0, most=1e5)


def draining(rate: float, me: str, argument: str) -> float:
    """And those that it drains, at most."""
    return _core.MOST_POURING if rate == math.inf else number(rate, me, argument, above=0.0, most=1e5)


def shape_of(
    area: Iterable[float] | ShapeDefinition, at: Point, angle: float, me: str
) -> tuple[ShapeDefinition, Vec2, float]:
    """A shape where it says, or a box as one."""
    middle, turn = place(at, me), number(angle, me, "angle")
    if isinstance(area, ShapeDefinition):
        return area, middle, turn
    if middle != (0.0, 0.0) or turn != 0.0:
        raise ArgumentError(f"{me}: at= and angle= are for shapes; area={area!r} is a box and says where it is")
    left, bottom, right, top = to_area(area, me)
    return Rectangle(right - left, top - bottom), Vec2((left + right) / 2, (bottom + top) / 2), 0.0
