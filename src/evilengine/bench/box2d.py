"""Box2D 3 as a peer, by pyb2d3."""

from __future__ import annotations

from typing import Any

import pyb2d3 as b2

from evilengine.bench.peers import CannotMakeError, Peer, Placed, core_of, corners_of, disc_of, points_of
from evilengine.values.vec2 import Vec2
from evilengine.world.body import Body, Shape
from evilengine.world.joints import Hinge, Joint
from evilengine.world.shapes import Capsule, Chain, Circle, PolygonLike, Rectangle, Segment

KINDS = {"static": b2.BodyType.STATIC, "kinematic": b2.BodyType.KINEMATIC, "dynamic": b2.BodyType.DYNAMIC}


class TheirWorld(Peer):
    name = "pyb2d3"

    def open(self, gravity: Vec2) -> None:
        self._world = b2.World(gravity=tuple(gravity))
        self._world.sleeping_enabled = False

    def add(self, body: Body) -> Any:
        one = self._world.create_body(
            b2.body_def(
                type=KINDS[body.kind],
                position=tuple(body.position),
                rotation=b2.make_rot(body.angle),
                linear_velocity=tuple(body.velocity),
                angular_velocity=body.angular_velocity,
                is_bullet=body.bullet,
            )
        )
        for shape in body.shapes:
            self._add_shape(one, shape, shape.density if body.kind == "dynamic" else 0.0)
        return one

    def _add_shape(self, one: Any, shape: Shape, density: float) -> None:
        material = b2.surface_material(
            friction=shape.friction, restitution=shape.restitution, tangent_speed=shape.surface_speed
        )
        meets = b2.make_filter(category_bits=shape.category, mask_bits=shape.mask, group_index=shape.group)
        form, definition = b2.shape_def(density=density, material=material, filter=meets), shape.definition
        if isinstance(definition, Chain):
            points = points_of(shape, definition.points)
            one.create_chain(b2.chain_def(points, material=material, is_loop=definition.loop, filter=meets))
        elif isinstance(definition, Circle):
            one.create_circle_shape(form, b2.circle(*disc_of(shape)))
        elif isinstance(definition, Capsule):
            p, q = points_of(shape, (definition.a, definition.b))
            one.create_capsule_shape(form, b2.capsule(p, q, definition.radius))
        elif isinstance(definition, Segment):
            one.create_segment_shape(form, b2.segment(*points_of(shape, (definition.a, definition.b))))
        elif isinstance(definition, Rectangle) and definition.rounding:
            one.create_polygon_shape(form, b2.box(*core_of(definition), radius=definition.rounding))
        elif isinstance(definition, PolygonLike):
            one.create_polygon_shape(form, b2.polygon(points=corners_of(shape)))
        else:
            raise CannotMakeError(definition, self.name)

    def join(self, joint: Joint, a: Any, b: Any) -> None:
        if not isinstance(joint, Hinge):
            raise CannotMakeError(joint, self.name)
        pin = b2.revolute_joint_def(
            body_a=a,
            body_b=b,
            local_anchor_a=tuple(joint.a.to_local(joint.at_a)),
            local_anchor_b=tuple(joint.b.to_local(joint.at_b)),
            reference_angle=joint.b.angle - joint.a.angle,
            collide_connected=joint.collide,
        )
        if joint.limits is not None:
            pin.enable_limit = True
            pin.lower_angle, pin.upper_angle = joint.limits
        if joint.motor_speed is not None:
            pin.enable_motor = True
            pin.motor_speed = joint.motor_speed
            pin.max_motor_torque = 1e9 if joint.max_torque is None else joint.max_torque
        if joint.frequency:
            pin.enable_spring = True
            pin.hertz, pin.damping_ratio = joint.frequency, joint.damping_ratio
        self._world.create_revolute_joint(pin)

    def remove(self, one: Any) -> None:
        one.destroy()

    def steer(self, one: Any, velocity: Vec2, spin: float) -> None:
        one.linear_velocity, one.angular_velocity = tuple(velocity), spin

    def advance(self, dt: float, substeps: int) -> None:
        self._world.step(dt, substeps)

    def where(self, one: Any) -> Placed:
        return one.position.x, one.position.y, one.angle

    def ray(self, start: Vec2, end: Vec2) -> bool:
        return bool(self._world.cast_ray_closest(start, (end[0] - start[0], end[1] - start[1])).hit)

    @staticmethod
    def boxes(count: int) -> tuple[object, list[Any]]:
        world = b2.World(gravity=(0.0, -10.0))
        form, box = b2.shape_def(density=1.0), b2.box(0.5, 0.5)
        bodies = []
        for i in range(count):
            body = world.create_dynamic_body(position=(2.0 * i, 0.0))
            body.create_polygon_shape(form, box)
            bodies.append(body)
        return world, bodies

    @staticmethod
    def position(one: Any) -> object:
        return one.position
