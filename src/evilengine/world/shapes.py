"""Shapes: what bodies are made of. Each is a frozen value; adding it to a body makes a Shape handle."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Self, TypeAlias

from evilengine import _core
from evilengine.values.checks import known_keywords, number
from evilengine.values.errors import ArgumentTypeError, ShapeError
from evilengine.values.vec2 import Point, Vec2, to_vec2

MIN_SIZE = 1e-4
"""Metres: the smallest radius or side. Contacts keep 5 mm of play, so anything smaller could not be held anyway."""

MAX_SIZE = 1e5
"""Metres: the largest radius or side."""


class ShapeDefinition:
    """What all shapes have in common. Make one of its kinds: Circle, Rectangle, Triangle, Polygon, Particle."""

    __slots__ = ("_spec",)
    _spec: _core.ShapeSpec

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(f"{self!r} cannot be changed; make another, or use shape.apply_matrix on a body's shape")

    def __delattr__(self, name: str) -> None:
        raise AttributeError(f"{self!r} cannot be changed")

    def _become(self, **values: object) -> None:
        for name, value in values.items():
            object.__setattr__(self, name, value)

    def _key(self) -> tuple[object, ...]:
        return tuple(getattr(self, name) for name in type(self).__slots__)

    def __eq__(self, other: object) -> bool:
        return type(other) is type(self) and self._key() == other._key()

    def __hash__(self) -> int:
        return hash((type(self).__name__, self._key()))

    def _arguments(self) -> tuple[object, ...]:
        """What makes the same shape again."""
        return self._key()

    def __copy__(self) -> Self:
        return self

    def __deepcopy__(self, memo: object) -> Self:
        return self

    def __reduce__(self) -> tuple[type[ShapeDefinition], tuple[object, ...]]:
        return type(self), self._arguments()

    def __repr__(self) -> str:
        return f"{type(self).__name__}({', '.join(f'{value:g}' for value in self._key())})"


class Circle(ShapeDefinition):
    """A disc round the origin. `radius` in metres, 0.0001 to 100000.

    Raises ShapeError for any other radius.

    >>> Circle(0.5).radius
    0.5
    """

    __slots__ = ("radius",)
    radius: float

    @known_keywords
    def __init__(self, radius: float) -> None:
        radius = number(radius, "Circle", "radius", least=MIN_SIZE, most=MAX_SIZE, error=ShapeError)
        self._become(radius=radius, _spec=_core.ShapeSpec.circle(radius))

    @property
    def area(self) -> float:
        """Square metres."""
        return math.pi * self.radius**2


class PolygonLike(ShapeDefinition):
    """A shape with corners."""

    __slots__ = ()

    @property
    def corners(self) -> tuple[Vec2, ...]:
        """The corners, counter-clockwise, in the shape's own frame (metres, float32 as the engine keeps them)."""
        return self._spec.corners

    @property
    def area(self) -> float:
        """Square metres."""
        corners = self.corners
        return 0.5 * sum(p.cross(q) for p, q in zip(corners, corners[1:] + corners[:1], strict=True))


class Rectangle(PolygonLike):
    """A rectangle with its centre at the origin. `width` and `height` in metres, 0.0001 to 100000.

    Raises ShapeError for other sides.

    >>> Rectangle(2, 1).corners
    (Vec2(-1.0, -0.5), Vec2(1.0, -0.5), Vec2(1.0, 0.5), Vec2(-1.0, 0.5))
    """

    __slots__ = ("height", "width")
    width: float
    height: float

    @known_keywords
    def __init__(self, width: float, height: float) -> None:
        width = number(width, "Rectangle", "width", least=MIN_SIZE, most=MAX_SIZE, error=ShapeError)
        height = number(height, "Rectangle", "height", least=MIN_SIZE, most=MAX_SIZE, error=ShapeError)
        x, y = 0.5 * width, 0.5 * height
        spec = _core.ShapeSpec.polygon(((-x, -y), (x, -y), (x, y), (-x, y)), "Rectangle")
        self._become(width=width, height=height, _spec=spec)

    def _arguments(self) -> tuple[object, ...]:
        return self.width, self.height

    def __repr__(self) -> str:
        return f"Rectangle({self.width:g}, {self.height:g})"


class Polygon(PolygonLike):
    """Any simple polygon: three corners or more, in order, either way round, convex or not.

    A concave one is split into convex parts for collisions; it stays one shape. Raises ShapeError when corners repeat,
    edges cross, or the area is zero.

    >>> Polygon([(0, 0), (1, 0), (0, 1)]).area
    0.5
    """

    __slots__ = ()

    @known_keywords
    def __init__(self, corners: Iterable[Point]) -> None:
        if not isinstance(corners, Iterable):
            raise ArgumentTypeError(f"Polygon({corners!r}): needs a list of points, such as [(0, 0), (1, 0), (0, 1)]")
        self._become(_spec=_core.ShapeSpec.polygon(tuple(corners), type(self).__name__))

    def _key(self) -> tuple[object, ...]:
        return self.corners

    def _arguments(self) -> tuple[object, ...]:
        return (self.corners,)

    def __repr__(self) -> str:
        return f"{type(self).__name__}([{', '.join(f'({x:g}, {y:g})' for x, y in self.corners)}])"


class Triangle(Polygon):
    """Three corners, either way round.

    >>> Triangle((0, 0), (1, 0), (0, 1)).area
    0.5
    """

    __slots__ = ()

    @known_keywords
    def __init__(self, a: Point, b: Point, c: Point) -> None:
        super().__init__([to_vec2(p, "Triangle", name) for p, name in ((a, "a"), (b, "b"), (c, "c"))])

    def _arguments(self) -> tuple[object, ...]:
        return self.corners

    def __repr__(self) -> str:
        return f"Triangle({', '.join(f'({x:g}, {y:g})' for x, y in self.corners)})"


class Particle(ShapeDefinition):
    """A mass without extent (SPEC P1): it feels forces and touches nothing. `mass` in kilograms.

    >>> Particle(mass=2).mass
    2.0
    """

    __slots__ = ("mass",)
    mass: float

    @known_keywords
    def __init__(self, mass: float = 1.0) -> None:
        mass = number(mass, "Particle", "mass", least=1e-9, most=1e9, error=ShapeError)
        self._become(mass=mass, _spec=_core.ShapeSpec.particle(mass))

    def __repr__(self) -> str:
        return f"Particle(mass={self.mass:g})"


AnyShape: TypeAlias = Circle | Rectangle | Triangle | Polygon | Particle


def to_shape(value: object, owner: str, argument: str = "shape") -> ShapeDefinition:
    """`value` if it is a shape, else an error that says what is."""
    if isinstance(value, ShapeDefinition):
        return value
    what = f"the class {value.__name__}; make one: {value.__name__}(...)" if isinstance(value, type) else repr(value)
    raise ArgumentTypeError(f"{owner}: {argument} must be a shape such as Circle(0.5) or Rectangle(2, 1); got {what}")
