"""Random machines of every kind of joint: they stay in the numbers, keep momentum, and are restored to the bit."""

from __future__ import annotations

import math
import random
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import evilengine as evil
from evilengine import joints

SHAPES = [
    evil.Circle(0.4),
    evil.Rectangle(1.0, 0.5),
    evil.Capsule((-0.4, 0), (0.4, 0), 0.2),
    evil.Polygon([(-0.5, -0.4), (0.6, -0.3), (0.0, 0.6)], rounding=0.05),
]


def some_joint(chance: random.Random, a: evil.Body, b: evil.Body) -> joints.Joint:
    middle = 0.5 * (a.position + b.position)
    limits = chance.choice([None, (-0.5, 0.7)])
    spring: dict[str, Any] = chance.choice(
        [{}, {"frequency": chance.uniform(0.5, 5), "damping_ratio": chance.uniform(0, 1)}]
    )
    motor: dict[str, Any] = chance.choice([{}, {"motor_speed": chance.uniform(-5, 5)}])
    kind = chance.randrange(9)
    if kind == 0:
        return joints.Hinge(a, b, at=middle, limits=limits, max_torque=50 if motor else None, **motor, **spring)
    if kind == 1:
        return joints.Slider(a, b, axis=(chance.uniform(-1, 1), 1), max_force=50 if motor else None, **motor, **spring)
    if kind == 2:
        return joints.Weld(a, b, at=middle, **spring)
    if kind == 3:
        return joints.Wheel(a, b, at=middle, axis=(0, 1))
    if kind == 4:
        return joints.Motor(a, b, max_force=100, max_torque=20)
    if kind == 5:
        return joints.Rope(a, b)
    if kind == 6:
        return joints.Gear(a, b, ratio=chance.choice([-1.0, 2.0, -0.5]))
    if kind == 7:
        return joints.Pulley(a, b, over_a=a.position + (0, 3), over_b=b.position + (0, 3))
    return joints.Distance(a, b, **spring)


def machine(seed: int, gravity: tuple[float, float], *, floor: bool) -> evil.World:
    chance = random.Random(seed)
    world = evil.World(gravity=gravity)
    if floor:
        world.add(evil.Rectangle(60, 1), at=(0, -4), kind="static")
    bodies = [
        world.add(
            chance.choice(SHAPES),
            at=(1.6 * (k % 4) + chance.uniform(-0.2, 0.2), 1.6 * (k // 4) + chance.uniform(-0.2, 0.2)),
            angle=chance.uniform(-3, 3),
            velocity=(chance.uniform(-3, 3), chance.uniform(-3, 3)),
            density=chance.choice([0.5, 1.0, 4.0]),
        )
        for k in range(chance.randrange(2, 9))
    ]
    for _ in range(chance.randrange(1, 2 * len(bodies))):
        world.add_joint(some_joint(chance, *chance.sample(bodies, 2)))
    return world


@settings(max_examples=60, deadline=None)
@given(st.integers(0, 2**32), st.booleans())
def test_a_random_machine_stays_in_the_numbers_and_is_restored_to_the_bit(seed: int, floor: bool) -> None:
    world = machine(seed, (0, -10), floor=floor)
    for _ in range(40):
        world.step(1 / 60)
    again = evil.World()
    again.restore(world.snapshot())
    for _ in range(40):
        world.step(1 / 60)
        again.step(1 / 60)
    for body in world.bodies:
        assert math.isfinite(body.position.x + body.position.y + body.angle + body.angular_velocity)
        assert math.isfinite(body.velocity.length)
    assert again.checksum() == world.checksum()


@settings(max_examples=60, deadline=None)
@given(st.integers(0, 2**32))
def test_what_no_one_pushes_from_outside_keeps_its_momentum(seed: int) -> None:
    world = machine(seed, (0, 0), floor=False)
    if any(isinstance(joint, joints.Pulley) for joint in world.joints):
        return  # hangs from the world

    def momentum() -> evil.Vec2:
        return sum((body.mass * body.velocity for body in world.bodies), evil.Vec2(0, 0))

    before, scale = momentum(), sum(body.mass for body in world.bodies)
    for _ in range(60):
        world.step(1 / 60)
    assert (momentum() - before).length < 1e-4 * scale


@pytest.mark.parametrize("threads", [2])
def test_a_random_machine_is_the_same_on_any_number_of_threads(threads: int) -> None:
    for seed in range(8):
        world = machine(seed, (0, -10), floor=True)
        other = evil.World(threads=threads)
        other.restore(world.snapshot())
        for _ in range(60):
            world.step(1 / 60)
            other.step(1 / 60)
        assert other.checksum() == world.checksum()
