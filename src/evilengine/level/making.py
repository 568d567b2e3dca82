"""The values in a level's commands, as they are while it plays: numbers, points, and what the engine makes of them."""

from __future__ import annotations

import random
from collections.abc import Callable
from typing import Any

from evilengine.level.rules import Gone, Scope, Thing
from evilengine.script.arithmetic import evaluate
from evilengine.values import level as commands
from evilengine.values.level import Area, Called, Colours, Corners, Holes, Make, Number, Numbers, Pair
from evilengine.world import joints
from evilengine.world.forces import ConstantForce, Drag, Spring
from evilengine.world.media import Medium
from evilengine.world.shapes import Capsule, Chain, Circle, Particle, Polygon, Rectangle, Segment, Triangle

_SHAPES = (Circle, Rectangle, Triangle, Polygon, Capsule, Segment, Chain, Particle)
_FORCES = (Spring, ConstantForce, Drag, Medium)
TYPES: dict[str, Callable[..., Any]] = {each.__name__: each for each in (*_SHAPES, *_FORCES)}
TYPES |= {f"joints.{each.__name__}": each for each in joints.KINDS.values()}
"""What a level can make, by the names that its commands use."""


class Values:
    """The part of a level at play that knows what a number or a name stands for now."""

    _random: random.Random

    def _number(self, number: Number, scope: Scope) -> float:
        return evaluate(number, scope.numbers, self._random.uniform)

    def _pair(self, pair: Pair, scope: Scope) -> tuple[float, float]:
        x = self._number(pair.x, scope)
        return x, self._number(pair.y, scope)

    def _value(self, value: commands.Value, scope: Scope) -> Any:
        match value:
            case Pair():
                return self._pair(value, scope)
            case Numbers(parts=parts):
                return tuple(self._number(each, scope) for each in parts)
            case Called():
                return self._thing(value, scope)
            case Area():
                return tuple(self._number(each, scope) for each in (value.left, value.bottom, value.right, value.top))
            case Corners(points=points):
                return [self._pair(point, scope) for point in points]
            case Holes(rings=rings):
                return [self._value(ring, scope) for ring in rings]
            case Colours(names=names):
                return list(names)
            case bool() | int() | str():
                return value
            case _:
                return self._number(value, scope)

    def _made(self, make: Make, scope: Scope) -> Any:
        """The engine's value that a Make stands for."""
        arguments = [self._value(each, scope) for each in make.arguments]
        options = {each.name: self._value(each.value, scope) for each in make.options}
        return TYPES[make.type](*arguments, **options)

    def _thing(self, called: Called, scope: Scope) -> Thing | None:
        """What a name stands for; None when it is gone, or was never made."""
        thing = scope.things.get(called.name)
        return thing if thing is not None and not isinstance(thing, Gone) and thing.alive else None
