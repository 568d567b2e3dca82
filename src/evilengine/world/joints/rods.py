"""Joints that measure a distance: Distance, Rope, Pulley."""

from __future__ import annotations

from evilengine import _core
from evilengine.values.checks import known_keywords, number
from evilengine.values.errors import ArgumentError
from evilengine.values.vec2 import Point, Vec2
from evilengine.world.arguments import WORLD_EDGE, place
from evilengine.world.body import Body
from evilengine.world.joints.anchored import Anchored, LinearSpring
from evilengine.world.joints.fields import (
    Amount,
    Limits,
    place_or_none,
    to_ratio,
)

DISTANCE, ROPE, PULLEY = 0, 6, 8  # JointKind in core/solver/joints/joint.hpp


class Distance(Anchored, LinearSpring):
    """Keeps two points `length` metres apart: a rod, or a spring where `frequency` or `stiffness` is given.

    `length` is the distance that they have when the joint is added, unless given. With `limits` alone the points are
    free between the two; a spring may have limits too. `at_a` and `at_b` are the bodies' positions unless given.

    >>> import evilengine as evil
    >>> world = evil.World(gravity=(0, 0))
    >>> a, b = world.add(evil.Circle(0.2)), world.add(evil.Circle(0.2), at=(3, 0), velocity=(0, 2))
    >>> rod = world.add_joint(evil.joints.Distance(a, b))
    >>> for _ in range(60):
    ...     world.step()
    >>> round(rod.length, 2)
    3.0
    """

    _kind = DISTANCE
    rest_length = Amount("along_rest", "Metres that it keeps, or that its spring pulls to.", least=0.0, most=WORLD_EDGE)
    limits = Limits("along", "Least and greatest distance, or None.", least=0.0)

    @known_keywords
    def __init__(
        self,
        a: Body,
        b: Body,
        *,
        at_a: Point | None = None,
        at_b: Point | None = None,
        length: float | None = None,
        limits: tuple[float, float] | None = None,
        frequency: float = 0.0,
        damping_ratio: float = 0.0,
        stiffness: float = 0.0,
        damping: float = 0.0,
        collide: bool = False,
        breaking_force: float | None = None,
        breaking_torque: float | None = None,
    ) -> None:
        super().__init__(a, b, collide=collide, breaking_force=breaking_force, breaking_torque=breaking_torque)
        self._at_a, self._at_b = place_or_none(at_a, "Distance", "at_a"), place_or_none(at_b, "Distance", "at_b")
        sprung = self._spring(frequency, damping_ratio, stiffness, damping)
        self.limits = limits
        self._fields.along_held = not sprung and (limits is None or length is not None)
        self._wanted = None if length is None else number(length, "Distance", "length", least=0.0, most=WORLD_EDGE)

    def _measure(self, spec: _core.JointSpec, at_a: Vec2, at_b: Vec2) -> None:
        spec.along_rest = (at_b - at_a).length if self._wanted is None else self._wanted

    @property
    def length(self) -> float:
        """Metres between the two points."""
        return self._handle().length

    @property
    def speed(self) -> float:
        """Metres a second at which they part."""
        return self._handle().lengthening


class Rope(Anchored):
    """Keeps two points no further apart than `length` metres (what they are now, unless given); nearer they are free.

    >>> import evilengine as evil
    >>> world = evil.World()
    >>> hook, ball = world.add(evil.Circle(0.1), kind="static"), world.add(evil.Circle(0.2), at=(0, -1))
    >>> rope = world.add_joint(evil.joints.Rope(hook, ball, length=2))
    >>> for _ in range(120):
    ...     world.step()
    >>> round(rope.length, 2)
    2.0
    """

    _kind = ROPE
    max_length = Amount("along_upper", "Metres at which it is tight.", least=0.0, most=WORLD_EDGE)

    @known_keywords
    def __init__(
        self,
        a: Body,
        b: Body,
        *,
        at_a: Point | None = None,
        at_b: Point | None = None,
        length: float | None = None,
        collide: bool = False,
        breaking_force: float | None = None,
        breaking_torque: float | None = None,
    ) -> None:
        super().__init__(a, b, collide=collide, breaking_force=breaking_force, breaking_torque=breaking_torque)
        self._at_a, self._at_b = place_or_none(at_a, "Rope", "at_a"), place_or_none(at_b, "Rope", "at_b")
        self._wanted = None if length is None else number(length, "Rope", "length", least=0.0, most=WORLD_EDGE)

    def _measure(self, spec: _core.JointSpec, at_a: Vec2, at_b: Vec2) -> None:
        spec.along_limited = True
        spec.along_upper = (at_b - at_a).length if self._wanted is None else self._wanted

    @property
    def length(self) -> float:
        """Metres between the two points now."""
        return self._handle().length

    @property
    def speed(self) -> float:
        """Metres a second at which they part."""
        return self._handle().lengthening


class Pulley(Anchored):
    """A rope from a over two fixed points of the world to b: what the one side loses, the other gains.

    The sum that stays is the length from `over_a` to a plus `ratio` times that from `over_b` to b; with ratio 2 (a
    block and tackle) b moves half as far as a and is pulled twice as hard.

    >>> import evilengine as evil
    >>> world = evil.World()
    >>> heavy, light = world.add(evil.Circle(0.2), at=(-1, 0), mass=2), world.add(evil.Circle(0.2), at=(1, 0), mass=1)
    >>> pulley = world.add_joint(evil.joints.Pulley(heavy, light, over_a=(-1, 5), over_b=(1, 5)))
    >>> for _ in range(30):
    ...     world.step()
    >>> light.position.y > 0.3, round(pulley.length, 2)
    (True, 10.0)
    """

    _kind = PULLEY
    total_length = Amount("along_rest", "Metres that its ropes' sum keeps.", least=0.0, most=1e12)

    @known_keywords
    def __init__(
        self,
        a: Body,
        b: Body,
        over_a: Point,
        over_b: Point,
        *,
        at_a: Point | None = None,
        at_b: Point | None = None,
        ratio: float = 1.0,
        collide: bool = True,
        breaking_force: float | None = None,
        breaking_torque: float | None = None,
    ) -> None:
        super().__init__(a, b, collide=collide, breaking_force=breaking_force, breaking_torque=breaking_torque)
        self._at_a, self._at_b = place_or_none(at_a, "Pulley", "at_a"), place_or_none(at_b, "Pulley", "at_b")
        self._fields.over_a, self._fields.over_b = place(over_a, "Pulley", "over_a"), place(over_b, "Pulley", "over_b")
        self._fields.ratio = to_ratio(ratio, "Pulley")
        if not self._fields.ratio > 0.0:
            raise ArgumentError(f"Pulley: ratio={ratio!r} must be more than 0")

    def _measure(self, spec: _core.JointSpec, at_a: Vec2, at_b: Vec2) -> None:
        spec.along_rest = (at_a - spec.over_a).length + spec.ratio * (at_b - spec.over_b).length

    @property
    def over_a(self) -> Vec2:
        """The point of the world that a's rope runs over."""
        return self._fields.over_a

    @property
    def over_b(self) -> Vec2:
        """The point of the world that b's rope runs over."""
        return self._fields.over_b

    @property
    def ratio(self) -> float:
        """How much more b's rope weighs in the sum of lengths."""
        return self._fields.ratio

    @property
    def length(self) -> float:
        """Metres of rope: a's side and `ratio` times b's."""
        return self._handle().length
