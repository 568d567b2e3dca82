"""Chipmunk as a peer, by pymunk, with as many iterations as it takes by itself."""

from __future__ import annotations

import math
from typing import Any

import pymunk

from evilengine.bench.peers import CannotMakeError, Peer, Placed, core_of, corners_of, disc_of, points_of
from evilengine.values.vec2 import Vec2
from evilengine.world.body import Body, Shape
from evilengine.world.joints import Hinge, Joint
from evilengine.world.shapes import Capsule, Chain, Circle, PolygonLike, Rectangle, Segment

KINDS = {"static": pymunk.Body.STATIC, "kinematic": pymunk.Body.KINEMATIC}


class TheirWorld(Peer):
    name = "pymunk"

    def open(self, gravity: Vec2) -> None:
        self._space = pymunk.Space()
        self._space.gravity = one_point(gravity)

    def add(self, body: Body) -> Any:
        if body.kind == "dynamic":
            one = pymunk.Body(body.mass, body.inertia)
            one.center_of_gravity = one_point(body.to_local(body.centre))
        else:
            one = pymunk.Body(body_type=KINDS[body.kind])
        one.position, one.angle = one_point(body.position), body.angle
        one.velocity, one.angular_velocity = one_point(body.velocity), body.angular_velocity
        self._space.add(one)
        for shape in body.shapes:
            for made in self._shapes(one, shape):
                made.friction = math.sqrt(shape.friction)  # it multiplies the two; we take the root of their product
                made.elasticity = shape.restitution
                made.surface_velocity = (shape.surface_speed, 0.0)
                made.filter = pymunk.ShapeFilter(abs(shape.group), shape.category, shape.mask)
                self._space.add(made)
        return one

    def _shapes(self, one: pymunk.Body, shape: Shape) -> list[Any]:
        definition = shape.definition
        if isinstance(definition, Chain):
            points = points_of(shape, definition.points)
            ends = [*points[1:], points[0]] if definition.loop else points[1:]
            return [pymunk.Segment(one, p, q, 0.0) for p, q in zip(points, ends, strict=False)]
        if isinstance(definition, Circle):
            centre, radius = disc_of(shape)
            return [pymunk.Circle(one, radius, one_point(centre))]
        if isinstance(definition, (Capsule, Segment)):
            p, q = points_of(shape, (definition.a, definition.b))
            return [pymunk.Segment(one, p, q, definition.radius if isinstance(definition, Capsule) else 0.0)]
        if isinstance(definition, Rectangle) and definition.rounding:
            x, y = core_of(definition)
            return [pymunk.Poly(one, [(-x, -y), (x, -y), (x, y), (-x, y)], radius=definition.rounding)]
        if isinstance(definition, PolygonLike):
            return [pymunk.Poly(one, corners_of(shape))]
        raise CannotMakeError(definition, self.name)

    def join(self, joint: Joint, a: Any, b: Any) -> None:
        if not isinstance(joint, Hinge):
            raise CannotMakeError(joint, self.name)
        if "dynamic" not in (joint.a.kind, joint.b.kind):
            return  # it takes none that has nothing to do
        made: list[Any] = [pymunk.PivotJoint(a, b, one_point(joint.at_a))]
        if joint.limits is not None:
            made.append(pymunk.RotaryLimitJoint(a, b, *joint.limits))
        if joint.motor_speed is not None:
            motor = pymunk.SimpleMotor(a, b, -joint.motor_speed)
            motor.max_force = math.inf if joint.max_torque is None else joint.max_torque
            made.append(motor)
        if joint.frequency:
            made.append(self._spring(joint, a, b))
        for constraint in made:
            constraint.collide_bodies = joint.collide
        self._space.add(*made)

    @staticmethod
    def _spring(joint: Hinge, a: Any, b: Any) -> Any:
        inertia = 1.0 / (joint.a.inverse_inertia + joint.b.inverse_inertia)
        turning = math.tau * joint.frequency
        stiffness, damping = inertia * turning**2, 2.0 * joint.damping_ratio * inertia * turning
        return pymunk.DampedRotarySpring(a, b, -joint.rest_angle, stiffness, damping)

    def remove(self, one: Any) -> None:
        self._space.remove(one, *one.shapes, *one.constraints)

    def steer(self, one: Any, velocity: Vec2, spin: float) -> None:
        one.velocity, one.angular_velocity = one_point(velocity), spin

    def advance(self, dt: float, substeps: int) -> None:
        self._space.step(dt)

    def where(self, one: Any) -> Placed:
        return one.position.x, one.position.y, one.angle

    def ray(self, start: Vec2, end: Vec2) -> bool:
        return self._space.segment_query_first(one_point(start), one_point(end), 0.0, pymunk.ShapeFilter()) is not None

    @staticmethod
    def boxes(count: int) -> tuple[object, list[Any]]:
        space, bodies = pymunk.Space(), []
        for i in range(count):
            body = pymunk.Body(1.0, 1.0 / 6.0)
            body.position = (2.0 * i, 0.0)
            space.add(body, pymunk.Poly.create_box(body, (1.0, 1.0)))
            bodies.append(body)
        return space, bodies

    @staticmethod
    def position(one: Any) -> object:
        return one.position


def one_point(point: Any) -> tuple[float, float]:
    return float(point[0]), float(point[1])
