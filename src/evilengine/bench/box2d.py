"""Box2D 3 as a peer, by pyb2d3."""

from __future__ import annotations

from typing import Any

import pyb2d3 as b2

from evilengine.bench.peers import Peer, Placed, corners_of, disc_of, refuse
from evilengine.values.vec2 import Vec2
from evilengine.world.body import Body
from evilengine.world.shapes import Circle, PolygonLike

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
            material = b2.surface_material(friction=shape.friction, restitution=shape.restitution)
            density = shape.density if body.kind == "dynamic" else 0.0
            one.create_shape(b2.shape_def(density=density, material=material), self._shape(shape))
        return one

    def _shape(self, shape: Any) -> Any:
        if isinstance(shape.definition, Circle):
            return b2.circle(*disc_of(shape))
        if isinstance(shape.definition, PolygonLike):
            return b2.polygon(points=corners_of(shape))
        raise refuse(shape.definition, self.name)

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
