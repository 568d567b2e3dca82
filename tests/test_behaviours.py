"""Behaviours (SPEC P5): what is done to bodies each step, and motions that they follow."""

import math

import numpy as np
import pytest

import evilengine as evil


@pytest.fixture
def world():
    return evil.World()


def run(world, seconds, dt=1 / 60):
    for _ in range(round(seconds / dt)):
        world.step(dt)


def test_a_kinematic_lift_carries_what_stands_on_it(world):
    lift = world.add(evil.Rectangle(4, 0.5), kind="kinematic")
    box = world.add(evil.Rectangle(1, 1), at=(0, 0.75))
    lift.follow(lambda time: (math.sin(time), 2 * math.sin(time / 2)))
    run(world, 3)
    assert lift.position == pytest.approx((math.sin(3), 2 * math.sin(1.5)), abs=1e-3)
    assert box.position == pytest.approx(lift.position + (0, 0.75), abs=0.1)


def test_update_behaviours_run_before_each_step(world):
    body = world.add(evil.Circle(1), kind="kinematic")

    @body.on_update
    def grow(dt):
        body.scale = body.scale * 1.01
        body.angle += dt

    run(world, 0.5)
    assert body.angle == pytest.approx(0.5)
    assert body.scale.x == pytest.approx(1.01**30, rel=1e-4)
    assert body.shapes[0].outline[2] == pytest.approx(1.01**30, rel=1e-4)


def test_a_motion_may_destroy_what_follows_it():
    world = evil.World()
    lift = world.add(evil.Rectangle(2, 0.2), kind="kinematic")
    lift.follow(lambda time: (0, time) if time < 0.1 else lift.destroy())
    for _ in range(10):
        world.step()
    assert not lift.alive


def test_a_motion_may_give_numbers_of_any_make():
    world = evil.World()
    goals = [
        (np.float32(1), 2),
        np.array([1.0, 2.0]),
        ((1, 2), 0.5),
        (np.array([1, 2]), np.float32(0.5)),
        ([1, 2], 0.5),
    ]
    for goal in goals:
        lift = world.add(evil.Rectangle(2, 0.2), kind="kinematic")
        lift.follow(lambda time, goal=goal: goal)
        world.step()
        assert lift.position == pytest.approx((1, 2), abs=1e-5)
        lift.destroy()
