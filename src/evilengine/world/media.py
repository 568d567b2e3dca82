"""Media: areas with their own drag, wind or buoyancy (SPEC P2)."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from typing import TYPE_CHECKING, Any

from evilengine import _core
from evilengine.values.checks import known_keywords, number
from evilengine.values.errors import ArgumentError, ArgumentTypeError, ShapeError
from evilengine.values.vec2 import Point, Vec2, to_vec2
from evilengine.world.forces import MEDIUM, Force, Value
from evilengine.world.shapes import Circle, Polygon, Rectangle, ShapeDefinition

if TYPE_CHECKING:
    from evilengine.world.body import Body
    from evilengine.world.world import World


class Medium(Force):
    """An area of mud, water or wind. What is in it is dragged, blown and lifted, by the share of it that is inside.

    `linear` (N s/m) and `quadratic` (N s2/m2) are its drag, as Drag's, against its own `velocity` (m/s: wind, a
    current), at the middle of the part inside. `density` is relative to water, 1.0: it lifts a body by the weight of
    what the part inside displaces, so what is less dense floats, at its proper draft, and rights itself. The world's
    gravity says which way is up.

    `area` is (left, bottom, right, top) or any shape with an inside, placed `at` and turned by `angle`. With a `body`,
    area and velocity are in that body's frame and move with it; the body itself feels nothing of it.

    >>> import evilengine as evil
    >>> world = evil.World()
    >>> lake = world.add_force(evil.Medium((-5, -4, 5, 0), density=1, linear=2))
    >>> raft = world.add(evil.Rectangle(2, 1), at=(0, 1), density=0.5)
    >>> for _ in range(1200):
    ...     world.step()
    >>> round(raft.position.y, 1)
    0.0
    """

    _kind = MEDIUM
    linear = Value("linear", least=0.0)
    quadratic = Value("quadratic", least=0.0)
    density = Value("density", least=0.0)
    velocity = Value("vector", point=True)

    @known_keywords
    def __init__(
        self,
        area: Sequence[float] | ShapeDefinition,
        *,
        linear: float = 0.0,
        quadratic: float = 0.0,
        density: float = 0.0,
        velocity: Point = (0.0, 0.0),
        at: Point = (0.0, 0.0),
        angle: float = 0.0,
        body: Body | None = None,
    ) -> None:
        self.linear, self.quadratic, self.density = linear, quadratic, density
        self.velocity = velocity
        if body is not None and not isinstance(body, _core.Body):
            raise ArgumentTypeError(f"Medium: body={body!r} must be a Body, as world.add returns, or None")
        self._body = body
        self._place(area, at, angle)

    def _place(self, area: Sequence[float] | ShapeDefinition, at: Point, angle: float) -> None:
        definition, centre = to_area(area, "Medium")
        where = centre + to_vec2(at, "Medium", "at")
        turn = number(angle, "Medium", "angle")
        if self._ref is not None:
            self._ref.set_area(definition._spec, where, turn)
        self._area: ShapeDefinition | None = definition
        self._at, self._angle = where, turn

    @property
    def area(self) -> ShapeDefinition | None:
        """The shape of its area, which lies `at` and is turned by `angle`. It may be set, to a shape or to (left,
        bottom, right, top), which wakes what the medium acts on: a tide. None for a shape of several parts that came
        from a snapshot: of another process, or of a time when this medium had another area.
        """
        return self._area

    @area.setter
    def area(self, value: Sequence[float] | ShapeDefinition) -> None:
        self._place(value, (0.0, 0.0), 0.0)

    @known_keywords
    def place(self, area: Sequence[float] | ShapeDefinition, *, at: Point = (0.0, 0.0), angle: float = 0.0) -> None:
        """Give it another area, elsewhere."""
        self._place(area, at, angle)

    @property
    def at(self) -> Vec2:
        """Where the origin of its area is, in the world or in the frame of its body."""
        return self._at

    @property
    def angle(self) -> float:
        """Radians by which its area is turned."""
        return self._angle

    @property
    def body(self) -> Body | None:
        """The body that carries it, or None."""
        return self._body

    def _parameters(self, world: World) -> dict[str, Any]:
        assert self._area is not None
        carrier = None if self._body is None else world._own_body(self._body, "Medium", "body")
        return {
            "vector": self.velocity,
            "linear": self.linear,
            "quadratic": self.quadratic,
            "density": self.density,
            "area": self._area._spec,
            "area_at": self._at,
            "area_angle": self._angle,
            "target": _core.NO_SLOT if carrier is None else carrier.slot,
        }

    def _read_back(self, world: World, handle: _core.Force) -> None:
        kind, *rest = handle.area
        self._body = None if handle.target == _core.NO_SLOT else world._body(handle.target)
        self._at, self._angle, self._area = Vec2(0.0, 0.0), 0.0, None
        with suppress(ShapeError):  # of a forged snapshot: it acts where it is, and no shape can be told
            if kind == "circle":
                self._at, self._area = rest[0], Circle(rest[1])
            elif len(rest[0]) == 1:
                self._area = Polygon(rest[0][0])


def to_area(area: object, owner: str) -> tuple[ShapeDefinition, Vec2]:
    """A shape and where its origin is, from a shape or (left, bottom, right, top)."""
    if isinstance(area, ShapeDefinition):
        return area, Vec2(0.0, 0.0)
    try:
        left, bottom, right, top = (number(side, owner, "area") for side in area)  # type: ignore[attr-defined]
    except (TypeError, ValueError) as problem:
        if isinstance(problem, ArgumentError):
            raise
        raise ArgumentTypeError(f"{owner}: area={area!r} must be (left, bottom, right, top) or a shape") from None
    if not (left < right and bottom < top):
        raise ArgumentError(f"{owner}: area={area!r} must have left < right and bottom < top")
    return Rectangle(right - left, top - bottom), Vec2(0.5 * (left + right), 0.5 * (bottom + top))
