"""A figure of eleven limbs on hinges, as large as a person, with the limits of a person's joints."""

from __future__ import annotations

import math
from typing import NamedTuple

from evilengine.world.body import Body
from evilengine.world.joints import Hinge
from evilengine.world.shapes import Capsule, Polygon
from evilengine.world.world import World

BODY = 0b10
FRICTION = 0.05  # newton metres in a joint that has the full share


class Limb(NamedTuple):
    """A capsule from `low` to `high` about its middle `at`, on a pin at height `pin` of the limb numbered `parent`."""

    at: float
    low: float
    high: float
    radius: float
    parent: int = -1
    pin: float = 0.0
    limits: tuple[float, float] = (0.0, 0.0)  # parts of half a turn
    share: float = 1.0


HIP, TORSO, UPPER_LEG, LOWER_LEG, UPPER_ARM, LOWER_ARM = 0, 1, 3, 4, 7, 8
LEGS = (
    Limb(0.775, -0.125, 0.125, 0.06, HIP, 0.9, (-0.05, 0.4)),
    Limb(0.475, -0.155, 0.125, 0.045, UPPER_LEG, 0.625, (-0.5, -0.02), 0.5),
)
ARMS = (
    Limb(1.225, -0.125, 0.125, 0.035, TORSO, 1.35, (-0.1, 0.8), 0.5),
    Limb(0.975, -0.125, 0.125, 0.03, UPPER_ARM, 1.1, (-0.2, 0.3), 0.1),
)
LIMBS = (
    Limb(0.95, -0.02, 0.02, 0.095),
    Limb(1.2, -0.135, 0.135, 0.09, HIP, 1.0, (-0.25, 0.0), 0.5),
    Limb(1.475, -0.038, 0.039, 0.075, TORSO, 1.4, (-0.3, 0.1), 0.25),
    *LEGS,
    LEGS[0],
    LEGS[1]._replace(parent=5),
    *ARMS,
    ARMS[0],
    ARMS[1]._replace(parent=9),
)
FOOT = Polygon([(-0.03, -0.185), (0.11, -0.185), (0.11, -0.16), (-0.03, -0.14)])
SHAPES = [Capsule((0, limb.low), (0, limb.high), limb.radius) for limb in LIMBS]


def figure(world: World, at: tuple[float, float], number: int) -> list[Body]:
    """Stand one with its soles at `at`. Limbs of one number pass through each other, as do the feet of all."""
    x, y = at
    bodies: list[Body] = []
    for limb, shape in zip(LIMBS, SHAPES, strict=True):
        body = world.add(shape, at=(x, y + limb.at), friction=0.2, category=BODY, group=-number)
        if limb.pin == 0.625:
            body.add_shape(FOOT, friction=0.05, category=BODY, mask=1, group=-number)
        if limb.parent >= 0:
            limits = (limb.limits[0] * math.pi, limb.limits[1] * math.pi)
            pin = Hinge(
                bodies[limb.parent],
                body,
                at=(x, y + limb.pin),
                limits=limits,
                frequency=5,
                damping_ratio=0.5,
                motor_speed=0,
                max_torque=FRICTION * limb.share,
            )
            world.add_joint(pin)
        bodies.append(body)
    return bodies
