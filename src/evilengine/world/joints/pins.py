"""Joints that hold a point, or turning alone: Hinge, Weld, Motor, Gear."""

from __future__ import annotations

from evilengine import _core
from evilengine.values.checks import known_keywords, number
from evilengine.values.vec2 import Point, Vec2
from evilengine.world.arguments import place
from evilengine.world.body import Body
from evilengine.world.joints.anchored import Anchored, TurningSpring
from evilengine.world.joints.fields import (
    MOST_HERTZ,
    Amount,
    Greatest,
    Limits,
    MotorSpeed,
    place_or_none,
    to_ratio,
)
from evilengine.world.joints.joint import Joint

HINGE, WELD, MOTOR, GEAR = 1, 3, 5, 7  # JointKind in core/solver/joints/joint.hpp


class Hinge(Anchored, TurningSpring):
    """A pin through both bodies `at` a point: they turn about it. With limits, a motor, a spring.

    Angles are radians from how the bodies stand when it is added. `motor_speed` is in radians a second.

    >>> import evilengine as evil
    >>> world = evil.World()
    >>> wall = world.add(evil.Rectangle(1, 1), kind="static")
    >>> door = world.add(evil.Rectangle(2, 0.2), at=(1, 0))
    >>> hinge = world.add_joint(evil.joints.Hinge(wall, door, at=(0, 0), limits=(-0.5, 0.5)))
    >>> for _ in range(120):
    ...     world.step()
    >>> round(hinge.angle, 2)
    -0.5
    """

    _kind = HINGE
    limits = Limits("turn", "Least and greatest angle, or None.", least=-1e6)
    motor_speed = MotorSpeed("turn", "Radians a second that its motor keeps; None: no motor.")
    max_torque = Greatest("turn_most", "Newton metres that its motor has; None: as many as it takes.")
    rest_angle = Amount("turn_rest", "Radians that its spring pulls to.", least=-1e6, most=1e6)

    @known_keywords
    def __init__(
        self,
        a: Body,
        b: Body,
        at: Point,
        *,
        limits: tuple[float, float] | None = None,
        motor_speed: float | None = None,
        max_torque: float | None = None,
        frequency: float = 0.0,
        damping_ratio: float = 0.0,
        stiffness: float = 0.0,
        damping: float = 0.0,
        rest_angle: float = 0.0,
        collide: bool = False,
        breaking_force: float | None = None,
        breaking_torque: float | None = None,
    ) -> None:
        super().__init__(a, b, collide=collide, breaking_force=breaking_force, breaking_torque=breaking_torque)
        self._at_a = self._at_b = place(at, "Hinge")
        self._fields.along_held = True
        self._spring(frequency, damping_ratio, stiffness, damping)
        self.limits, self.motor_speed, self.max_torque, self.rest_angle = limits, motor_speed, max_torque, rest_angle

    @property
    def angle(self) -> float:
        """Radians by which b has turned against a since it was added."""
        return self._handle().angle

    @property
    def speed(self) -> float:
        """Radians a second at which b turns against a."""
        return self._handle().turning


class Weld(Anchored, TurningSpring):
    """Makes the two one: no turning, no shifting. With a `frequency` the turning is springy, and with a
    `shift_frequency` the point `at` (halfway between the bodies, unless given) is held by a spring too.

    >>> import evilengine as evil
    >>> world = evil.World()
    >>> wall = world.add(evil.Rectangle(1, 1), kind="static")
    >>> shelf = world.add(evil.Rectangle(2, 0.2), at=(1.5, 0))
    >>> weld = world.add_joint(evil.joints.Weld(wall, shelf, at=(0.5, 0)))
    >>> for _ in range(120):
    ...     world.step()
    >>> abs(weld.angle) < 0.01
    True
    """

    _kind = WELD
    shift_frequency = Amount("along_frequency", "Hertz at which its place gives; 0: it does not.", least=0.0, most=1e4)
    shift_damping_ratio = Amount("along_damping_ratio", "Of that: 1 just does not swing.", least=0.0)

    @known_keywords
    def __init__(
        self,
        a: Body,
        b: Body,
        at: Point | None = None,
        *,
        frequency: float = 0.0,
        damping_ratio: float = 1.0,
        stiffness: float = 0.0,
        damping: float = 0.0,
        shift_frequency: float = 0.0,
        shift_damping_ratio: float = 1.0,
        collide: bool = False,
        breaking_force: float | None = None,
        breaking_torque: float | None = None,
    ) -> None:
        super().__init__(a, b, collide=collide, breaking_force=breaking_force, breaking_torque=breaking_torque)
        self._at_a = self._at_b = 0.5 * (a.position + b.position) if at is None else place(at, "Weld")
        self._fields.turn_held = not self._spring(frequency, damping_ratio, stiffness, damping)
        self.shift_frequency, self.shift_damping_ratio = shift_frequency, shift_damping_ratio
        self._fields.along_held = not self.shift_frequency > 0

    @property
    def angle(self) -> float:
        """Radians by which it has given."""
        return self._handle().angle


class Gear(Joint):
    """Ties the turning of two bodies: b turns `ratio` times for each turn of a. Negative where teeth mesh, so that a
    wheel of half the size has -2; positive where a belt or a chain runs over both.

    >>> import evilengine as evil
    >>> world = evil.World(gravity=(0, 0))
    >>> frame = world.add(evil.Rectangle(1, 1), kind="static")
    >>> large, small = world.add(evil.Circle(2), angular_velocity=1), world.add(evil.Circle(1), at=(3, 0))
    >>> for wheel in (large, small):
    ...     joint = world.add_joint(evil.joints.Hinge(frame, wheel, at=wheel.position))
    >>> gear = world.add_joint(evil.joints.Gear(large, small, ratio=-2))
    >>> world.step(); round(small.angular_velocity / large.angular_velocity, 3)
    -2.0
    """

    _kind = GEAR

    @known_keywords
    def __init__(
        self,
        a: Body,
        b: Body,
        ratio: float = -1.0,
        *,
        collide: bool = False,
        breaking_force: float | None = None,
        breaking_torque: float | None = None,
    ) -> None:
        super().__init__(a, b, collide=collide, breaking_force=breaking_force, breaking_torque=breaking_torque)
        self._fields.ratio = to_ratio(ratio, "Gear")

    def _place(self, spec: _core.JointSpec) -> None:
        spec.reference = self._b.angle - spec.ratio * self._a.angle

    @property
    def ratio(self) -> float:
        """Turns of b for one turn of a."""
        return self._fields.ratio

    @property
    def angle(self) -> float:
        """Radians by which b is off its ratio."""
        return self._handle().angle


class Motor(Joint):
    """Moves b to a place and an angle that a carries, with no more than `max_force` and `max_torque`.

    `offset` (metres, in a's frame, to b's position) and `angle` (radians) may be changed at any time; they are what
    they are when it is added, unless given. `frequency` says how eagerly it follows.

    >>> import evilengine as evil
    >>> world = evil.World(gravity=(0, 0))
    >>> ground, crane = world.add(evil.Circle(0.1), kind="static"), world.add(evil.Circle(0.2), at=(1, 0))
    >>> motor = world.add_joint(evil.joints.Motor(ground, crane, max_force=100))
    >>> motor.offset = (2, 1)
    >>> for _ in range(240):
    ...     world.step()
    >>> round(crane.position.x, 2), round(crane.position.y, 2)
    (2.0, 1.0)
    """

    _kind = MOTOR
    frequency = Amount("along_frequency", "Hertz at which it follows its place.", least=0.0, most=MOST_HERTZ)
    damping_ratio = Amount("along_damping_ratio", "1 just does not swing.", least=0.0)
    max_force = Greatest("along_spring_most", "Newtons that it has; None: as many as it takes.")
    max_torque = Greatest("turn_spring_most", "Newton metres that it has; None: as many as it takes.")

    @known_keywords
    def __init__(
        self,
        a: Body,
        b: Body,
        *,
        offset: Point | None = None,
        angle: float | None = None,
        max_force: float | None = None,
        max_torque: float | None = None,
        frequency: float = 5.0,
        damping_ratio: float = 1.0,
        collide: bool = False,
        breaking_force: float | None = None,
        breaking_torque: float | None = None,
    ) -> None:
        super().__init__(a, b, collide=collide, breaking_force=breaking_force, breaking_torque=breaking_torque)
        self._offset = place_or_none(offset, "Motor", "offset")
        self._angle = None if angle is None else number(angle, "Motor", "angle", least=-1e6, most=1e6)
        self.frequency, self.damping_ratio = frequency, damping_ratio
        self._fields.turn_frequency, self._fields.turn_damping_ratio = self.frequency, self.damping_ratio
        self.max_force, self.max_torque = max_force, max_torque

    def _place(self, spec: _core.JointSpec) -> None:
        spec.anchor_a = self._a.to_local(self._b.position) if self._offset is None else self._offset
        spec.turn_rest = self._b.angle - self._a.angle if self._angle is None else self._angle

    @property
    def offset(self) -> Vec2:
        """Where b's position shall be, in a's frame."""
        return self._handle().anchor_a

    @offset.setter
    def offset(self, value: Point) -> None:
        self._handle().anchor_a = place(value, "Motor", "offset")

    @property
    def angle(self) -> float:
        """The angle that b shall have against a, radians."""
        return self._handle().turn_rest

    @angle.setter
    def angle(self, value: float) -> None:
        self._handle().turn_rest = number(value, "Motor", "angle", least=-1e6, most=1e6)
