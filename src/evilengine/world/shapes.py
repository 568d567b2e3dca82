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
    """What all shapes have in common. Make one of its kinds: Circle, Rectangle, Triangle, Polygon, Capsule, Segment,
    Chain, Particle."""

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

    def _options(self) -> dict[str, object]:
        """The keyword arguments among them."""
        return {}

    def __copy__(self) -> Self:
        return self

    def __deepcopy__(self, memo: object) -> Self:
        return self

    def __reduce__(self) -> tuple[object, ...]:
        return _make_again, (type(self), self._arguments(), self._options())

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
    """A shape with corners, which `rounding` metres may be rounded off."""

    __slots__ = ("_corners", "rounding")
    _corners: tuple[Vec2, ...]
    rounding: float

    @property
    def corners(self) -> tuple[Vec2, ...]:
        """The corners before rounding, counter-clockwise, in the shape's own frame (metres, float32 as the engine
        keeps them)."""
        return self._corners

    @property
    def area(self) -> float:
        """Square metres."""
        return self._spec.area

    def _key(self) -> tuple[object, ...]:
        return self.corners, self.rounding

    def _options(self) -> dict[str, object]:
        return {"rounding": self.rounding} if self.rounding else {}

    def _written(self, arguments: str) -> str:
        rounding = f", rounding={self.rounding:g}" if self.rounding else ""
        return f"{type(self).__name__}({arguments}{rounding})"


class Rectangle(PolygonLike):
    """A rectangle with its centre at the origin. `width` and `height` in metres, 0.0001 to 100000. `rounding` is the
    radius of its corners, at most half the shorter side; the sides keep their length.

    Raises ShapeError for other sides or roundings.

    >>> Rectangle(2, 1).corners
    (Vec2(-1.0, -0.5), Vec2(1.0, -0.5), Vec2(1.0, 0.5), Vec2(-1.0, 0.5))
    >>> round(Rectangle(1, 1, rounding=0.5).area, 4)  # a circle
    0.7854
    """

    __slots__ = ("height", "width")
    width: float
    height: float

    @known_keywords
    def __init__(self, width: float, height: float, *, rounding: float = 0.0) -> None:
        width = number(width, "Rectangle", "width", least=MIN_SIZE, most=MAX_SIZE, error=ShapeError)
        height = number(height, "Rectangle", "height", least=MIN_SIZE, most=MAX_SIZE, error=ShapeError)
        most = 0.5 * min(width, height)
        rounding = number(rounding, "Rectangle", "rounding", least=0.0, most=most, error=ShapeError)
        x, y = 0.5 * width, 0.5 * height
        sharp = _core.ShapeSpec.polygon(((-x, -y), (x, -y), (x, y), (-x, y)), "Rectangle")
        spec = _rounded_rectangle(x, y, rounding) if rounding else sharp
        self._become(width=width, height=height, rounding=rounding, _corners=sharp.corners, _spec=spec)

    def _arguments(self) -> tuple[object, ...]:
        return self.width, self.height

    def __repr__(self) -> str:
        return self._written(f"{self.width:g}, {self.height:g}")


def _rounded_rectangle(x: float, y: float, rounding: float) -> _core.ShapeSpec:
    """Half sides x and y; where nothing is left between two skins it is a capsule or a circle."""
    core_x, core_y = x - rounding, y - rounding
    if max(core_x, core_y) < MIN_SIZE:
        return _core.ShapeSpec.circle(rounding)
    if core_y < MIN_SIZE:
        return _core.ShapeSpec.line((-core_x, 0.0), (core_x, 0.0), rounding, "Rectangle")
    if core_x < MIN_SIZE:
        return _core.ShapeSpec.line((0.0, -core_y), (0.0, core_y), rounding, "Rectangle")
    return _core.ShapeSpec.polygon(((-x, -y), (x, -y), (x, y), (-x, y)), "Rectangle", rounding)


class Polygon(PolygonLike):
    """Any simple polygon: three corners or more, in order, either way round, convex or not. `holes` are the corners of
    what is cut out of it, a list for each hole.

    A concave one, or one with holes, is split into convex parts for collisions; it stays one shape. `rounding` is the
    radius of the corners that point outward; the edges stay where they are. Raises ShapeError when corners repeat,
    edges cross, the area is zero, a hole is not within the outline or touches it or another hole, or the rounding
    leaves nothing of an edge.

    >>> Polygon([(0, 0), (1, 0), (0, 1)]).area
    0.5
    >>> frame = Polygon([(0, 0), (3, 0), (3, 3), (0, 3)], holes=[[(1, 1), (2, 1), (2, 2), (1, 2)]])
    >>> frame.area
    8.0
    """

    __slots__ = ("_holes",)
    _holes: tuple[tuple[Vec2, ...], ...]

    @known_keywords
    def __init__(
        self, corners: Iterable[Point], *, holes: Iterable[Iterable[Point]] = (), rounding: float = 0.0
    ) -> None:
        owner = type(self).__name__
        if not isinstance(corners, Iterable):
            raise ArgumentTypeError(f"Polygon({corners!r}): needs a list of points, such as [(0, 0), (1, 0), (0, 1)]")
        rounding = number(rounding, owner, "rounding", least=0.0, most=MAX_SIZE, error=ShapeError)
        sharp = _core.ShapeSpec.polygon(tuple(corners), owner, holes=_to_holes(holes))
        spec = _core.ShapeSpec.polygon(sharp.corners, owner, rounding, sharp.holes) if rounding else sharp
        self._become(rounding=rounding, _corners=sharp.corners, _holes=sharp.holes, _spec=spec)

    @property
    def holes(self) -> tuple[tuple[Vec2, ...], ...]:
        """The corners of each hole before rounding, clockwise."""
        return self._holes

    def _key(self) -> tuple[object, ...]:
        return self.corners, self.holes, self.rounding

    def _arguments(self) -> tuple[object, ...]:
        return (self.corners,)

    def _options(self) -> dict[str, object]:
        return super()._options() | ({"holes": self.holes} if self.holes else {})

    def __repr__(self) -> str:
        holes = ", ".join(f"[{_points(hole)}]" for hole in self.holes)
        return self._written(f"[{_points(self.corners)}]" + (f", holes=[{holes}]" if holes else ""))


def _to_holes(holes: Iterable[Iterable[Point]]) -> tuple[tuple[Point, ...], ...]:
    if isinstance(holes, Iterable):
        each = tuple(holes)
        if all(isinstance(hole, Iterable) for hole in each):
            return tuple(tuple(hole) for hole in each)
    raise ArgumentTypeError(f"Polygon: holes={holes!r} must be a list of holes, each a list of points")


class Triangle(Polygon):
    """Three corners, either way round. `rounding` as of a Polygon.

    >>> Triangle((0, 0), (1, 0), (0, 1)).area
    0.5
    """

    __slots__ = ()

    @known_keywords
    def __init__(self, a: Point, b: Point, c: Point, *, rounding: float = 0.0) -> None:
        corners = [to_vec2(p, "Triangle", name) for p, name in ((a, "a"), (b, "b"), (c, "c"))]
        super().__init__(corners, rounding=rounding)

    def _arguments(self) -> tuple[object, ...]:
        return self.corners

    def __repr__(self) -> str:
        return self._written(_points(self.corners))


class Capsule(ShapeDefinition):
    """A segment from `a` to `b` with everything within `radius` metres of it: a pill, an arm, a rounded bar.

    Raises ShapeError for a radius outside 0.0001 to 100000, or for ends nearer than 0.0001 metres.

    >>> Capsule((-1, 0), (1, 0), 0.5).b
    Vec2(1.0, 0.0)
    """

    __slots__ = ("a", "b", "radius")
    a: Vec2
    b: Vec2
    radius: float

    @known_keywords
    def __init__(self, a: Point, b: Point, radius: float) -> None:
        radius = number(radius, "Capsule", "radius", least=MIN_SIZE, most=MAX_SIZE, error=ShapeError)
        spec = _core.ShapeSpec.line(a, b, radius, "Capsule")
        self._become(a=spec.corners[0], b=spec.corners[1], radius=radius, _spec=spec)

    @property
    def area(self) -> float:
        """Square metres."""
        return self._spec.area

    def __repr__(self) -> str:
        return f"Capsule({_points((self.a, self.b))}, {self.radius:g})"


class Segment(ShapeDefinition):
    """A straight line from `a` to `b` without thickness, solid from both sides: a floor, a plank. It weighs like a rod
    a centimetre thick.

    Raises ShapeError for ends nearer than 0.0001 metres.

    >>> Segment((-5, 0), (5, 0)).a
    Vec2(-5.0, 0.0)
    """

    __slots__ = ("a", "b")
    a: Vec2
    b: Vec2

    @known_keywords
    def __init__(self, a: Point, b: Point) -> None:
        spec = _core.ShapeSpec.line(a, b, 0.0, "Segment")
        self._become(a=spec.corners[0], b=spec.corners[1], _spec=spec)

    def __repr__(self) -> str:
        return f"Segment({_points((self.a, self.b))})"


class Chain(ShapeDefinition):
    """A path of segments through `points`, solid from both sides: the ground of a level. What slides along it does not
    feel where two segments meet. `loop=True` joins the last point to the first. It weighs like a rod a centimetre
    thick.

    Raises ShapeError for fewer than two points (three in a loop) or neighbours nearer than 0.0001 metres.

    >>> Chain([(-5, 0), (0, 0), (5, 1)]).points[2]
    Vec2(5.0, 1.0)
    """

    __slots__ = ("loop", "points")
    points: tuple[Vec2, ...]
    loop: bool

    @known_keywords
    def __init__(self, points: Iterable[Point], *, loop: bool = False) -> None:
        if not isinstance(points, Iterable):
            raise ArgumentTypeError(f"Chain({points!r}): needs a list of points, such as [(0, 0), (1, 0), (2, 1)]")
        if not isinstance(loop, bool):
            raise ArgumentTypeError(f"Chain: loop={loop!r} must be True or False")
        spec = _core.ShapeSpec.chain(tuple(points), loop, "Chain")
        self._become(points=spec.corners, loop=loop, _spec=spec)

    def _arguments(self) -> tuple[object, ...]:
        return (self.points,)

    def _options(self) -> dict[str, object]:
        return {"loop": True} if self.loop else {}

    def __repr__(self) -> str:
        return f"Chain([{_points(self.points)}]{', loop=True' if self.loop else ''})"


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


AnyShape: TypeAlias = Circle | Rectangle | Triangle | Polygon | Capsule | Segment | Chain | Particle


def _make_again(
    kind: type[ShapeDefinition], arguments: tuple[object, ...], options: dict[str, object]
) -> ShapeDefinition:
    return kind(*arguments, **options)


def _points(points: Iterable[Vec2]) -> str:
    return ", ".join(f"({x:g}, {y:g})" for x, y in points)


def to_shape(value: object, owner: str, argument: str = "shape") -> ShapeDefinition:
    """`value` if it is a shape, else an error that says what is."""
    if isinstance(value, ShapeDefinition):
        return value
    what = f"the class {value.__name__}; make one: {value.__name__}(...)" if isinstance(value, type) else repr(value)
    raise ArgumentTypeError(f"{owner}: {argument} must be a shape such as Circle(0.5) or Rectangle(2, 1); got {what}")
