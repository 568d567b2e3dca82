"""Joints along a line of their first body: Slider, Wheel."""

from __future__ import annotations

from evilengine import _core
from evilengine.values.checks import known_keywords
from evilengine.values.vec2 import Point, Vec2
from evilengine.world.arguments import WORLD_EDGE, place
from evilengine.world.body import Body
from evilengine.world.joints.anchored import Anchored, LinearSpring
from evilengine.world.joints.fields import (
    Amount,
    Greatest,
    Limits,
    MotorSpeed,
    direction,
)

SLIDER, WHEEL = 2, 4  # JointKind in core/solver/joints/joint.hpp


class Slider(Anchored, LinearSpring):
    """Lets b slide along a line of a, and not turn: with limits, a motor, a spring.

    The line goes through `at` (b's position, unless given) along `axis`, and turns with a. Translations are metres
    along it from where it was added; `motor_speed` is in metres a second.

    >>> import evilengine as evil
    >>> world = evil.World()
    >>> frame = world.add(evil.Rectangle(1, 1), kind="static")
    >>> lift = world.add(evil.Rectangle(1, 0.2), at=(2, 0))
    >>> slider = world.add_joint(evil.joints.Slider(frame, lift, axis=(0, 1), limits=(0, 3), motor_speed=2))
    >>> for _ in range(60):
    ...     world.step()
    >>> round(slider.translation, 1), round(slider.speed, 1)
    (2.0, 2.0)
    """

    _kind = SLIDER
    limits = Limits("along", "Least and greatest translation, or None.")
    motor_speed = MotorSpeed("along", "Metres a second that its motor keeps; None: no motor.")
    max_force = Greatest("along_most", "Newtons that its motor has; None: as many as it takes.")
    rest = Amount("along_rest", "Translation that its spring pulls to.", least=-WORLD_EDGE, most=WORLD_EDGE)

    @known_keywords
    def __init__(
        self,
        a: Body,
        b: Body,
        at: Point | None = None,
        *,
        axis: Point = (1.0, 0.0),
        limits: tuple[float, float] | None = None,
        motor_speed: float | None = None,
        max_force: float | None = None,
        frequency: float = 0.0,
        damping_ratio: float = 0.0,
        stiffness: float = 0.0,
        damping: float = 0.0,
        rest: float = 0.0,
        collide: bool = False,
        breaking_force: float | None = None,
        breaking_torque: float | None = None,
    ) -> None:
        super().__init__(a, b, collide=collide, breaking_force=breaking_force, breaking_torque=breaking_torque)
        self._at_a = self._at_b = place(b.position if at is None else at, "Slider")
        self._axis = direction(axis, "Slider")
        self._spring(frequency, damping_ratio, stiffness, damping)
        self.limits, self.motor_speed, self.max_force, self.rest = limits, motor_speed, max_force, rest

    def _measure(self, spec: _core.JointSpec, at_a: Vec2, at_b: Vec2) -> None:
        spec.axis = self._axis.turned(-self._a.angle)

    @property
    def translation(self) -> float:
        """Metres along its line from where it was added."""
        return self._handle().length

    @property
    def speed(self) -> float:
        """Metres a second along its line."""
        return self._handle().lengthening


class Wheel(Anchored, LinearSpring):
    """A wheel b on a vehicle a: it turns freely `at` its axle, on a suspension along `axis`, with a motor on the axle.

    Without `frequency` or `stiffness` of the suspension the axle slides freely between the limits.

    >>> import evilengine as evil
    >>> world = evil.World()
    >>> ground = world.add(evil.Rectangle(40, 1), at=(0, -0.5), kind="static")
    >>> car = world.add(evil.Rectangle(2, 0.5), at=(0, 0.8))
    >>> wheels = [world.add(evil.Circle(0.4), at=(x, 0.4), friction=2) for x in (-0.8, 0.8)]
    >>> for wheel in wheels:
    ...     joint = world.add_joint(evil.joints.Wheel(car, wheel, motor_speed=-5))
    >>> for _ in range(120):
    ...     world.step()
    >>> car.position.x > 1
    True
    """

    _kind = WHEEL
    limits = Limits("along", "Least and greatest translation of the axle, or None.")
    motor_speed = MotorSpeed("turn", "Radians a second that its motor keeps; None: no motor.")
    max_torque = Greatest("turn_most", "Newton metres that its motor has; None: as many as it takes.")

    @known_keywords
    def __init__(
        self,
        a: Body,
        b: Body,
        at: Point | None = None,
        *,
        axis: Point = (0.0, 1.0),
        limits: tuple[float, float] | None = None,
        motor_speed: float | None = None,
        max_torque: float | None = None,
        frequency: float | None = None,
        damping_ratio: float = 0.7,
        stiffness: float = 0.0,
        damping: float = 0.0,
        collide: bool = False,
        breaking_force: float | None = None,
        breaking_torque: float | None = None,
    ) -> None:
        super().__init__(a, b, collide=collide, breaking_force=breaking_force, breaking_torque=breaking_torque)
        self._at_a = self._at_b = place(b.position if at is None else at, "Wheel")
        self._axis = direction(axis, "Wheel")
        if frequency is None:
            frequency = 0.0 if stiffness or damping else 4.0
        self._spring(frequency, damping_ratio, stiffness, damping)
        self.limits, self.motor_speed, self.max_torque = limits, motor_speed, max_torque

    _measure = Slider._measure

    @property
    def translation(self) -> float:
        """Metres that the axle has moved along its axis since it was added."""
        return self._handle().length

    @property
    def angle(self) -> float:
        """Radians that the wheel has turned against the vehicle."""
        return self._handle().angle

    @property
    def speed(self) -> float:
        """Radians a second at which the wheel turns against the vehicle."""
        return self._handle().turning
