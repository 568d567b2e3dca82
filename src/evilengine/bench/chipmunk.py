"""Chipmunk as a peer, by pymunk, with as many iterations as it takes by itself."""

from __future__ import annotations

import math
from typing import Any

import pymunk

from evilengine.bench.peers import Peer, Placed, corners_of, disc_of, refuse
from evilengine.values.vec2 import Vec2
from evilengine.world.body import Body
from evilengine.world.shapes import Circle, PolygonLike

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
        self._space.add(one, *(self._shape(one, shape) for shape in body.shapes))
        return one

    def _shape(self, one: Any, shape: Any) -> Any:
        made: pymunk.Shape
        if isinstance(shape.definition, Circle):
            centre, radius = disc_of(shape)
            made = pymunk.Circle(one, radius, one_point(centre))
        elif isinstance(shape.definition, PolygonLike):
            made = pymunk.Poly(one, corners_of(shape))
        else:
            raise refuse(shape.definition, self.name)
        made.friction = math.sqrt(shape.friction)  # it multiplies the two; we take the root of their product
        made.elasticity = shape.restitution
        return made

    def remove(self, one: Any) -> None:
        self._space.remove(one, *one.shapes)

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
