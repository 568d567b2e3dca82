"""Conveyor belts, and kinematic bodies that carry what stands on them: with numbers."""

from __future__ import annotations

import math

import pytest

import evilengine as evil

G = 9.81


@pytest.fixture
def world():
    return evil.World()


def run(world, seconds):
    for _ in range(round(seconds * 60)):
        world.step()


@pytest.mark.parametrize("speed", [2.0, -3.0])
def test_a_belt_brings_what_lies_on_it_to_its_speed_by_friction(world, speed):
    world.add(evil.Rectangle(100, 1), at=(0, -0.5), kind="static", surface_speed=speed, friction=0.5)
    box = world.add(evil.Rectangle(1, 1), at=(0, 0.5), friction=0.5)
    run(world, 0.2)
    assert box.velocity.x == pytest.approx(math.copysign(0.5 * G * 0.2, speed), rel=0.05)  # it slides: mu g t
    run(world, 2)
    assert box.velocity.x == pytest.approx(speed, rel=1e-3)
    start = box.position.x
    run(world, 1)
    assert box.position.x - start == pytest.approx(speed, rel=1e-3)
    assert box.position.y == pytest.approx(0.5, abs=0.01)


def test_without_friction_a_belt_does_nothing(world):
    world.add(evil.Rectangle(100, 1), at=(0, -0.5), kind="static", surface_speed=5, friction=0)
    box = world.add(evil.Rectangle(1, 1), at=(0, 0.5))
    run(world, 1)
    assert box.velocity.x == 0


def test_the_surface_runs_round_the_body_clockwise():
    for angle, direction in ((0, (1, 0)), (math.pi / 2, (0, 1)), (math.pi, (-1, 0)), (-math.pi / 2, (0, -1))):
        side = evil.Vec2(*direction).turned(math.pi / 2)  # outward of the belt
        world = evil.World(gravity=tuple(-G * side))
        world.add(evil.Rectangle(100, 2), angle=angle, kind="static", surface_speed=1.5)
        box = world.add(evil.Rectangle(1, 1), at=tuple(1.5 * side), angle=angle)
        run(world, 2)
        assert box.velocity == pytest.approx(tuple(1.5 * evil.Vec2(*direction)), abs=0.01)


def test_tracks_drive_the_body_that_they_run_round(world):
    world.add(evil.Rectangle(100, 1), at=(0, -0.5), kind="static")
    tank = world.add(
        evil.Rectangle(3, 1), at=(0, 0.5), surface_speed=4
    )  # clockwise, as a wheel that rolls to the right
    run(world, 2)
    assert tank.velocity.x == pytest.approx(4, rel=0.01)


def test_two_surfaces_add_up(world):
    world.add(evil.Rectangle(100, 1), at=(0, -0.5), kind="static", surface_speed=1)
    tank = world.add(evil.Rectangle(3, 1), at=(0, 0.5), surface_speed=-3)
    run(world, 2)
    assert tank.velocity.x == pytest.approx(-2, rel=0.01)


def test_starting_a_belt_wakes_who_sleeps_on_it_and_a_slow_one_keeps_them_awake(world):
    belt = world.add(evil.Rectangle(100, 1), at=(0, -0.5), kind="static")
    box = world.add(evil.Rectangle(1, 1), at=(0, 0.5))
    run(world, 2)
    assert not box.awake
    belt.surface_speed = 0.03
    assert box.awake
    start = box.position.x
    run(world, 10)
    assert box.position.x - start == pytest.approx(0.3, rel=0.05)
    belt.surface_speed = 0
    run(world, 2)
    assert not box.awake


def test_one_shape_of_a_body_may_be_a_belt(world):
    track = world.add(evil.Rectangle(10, 1), at=(-5, -0.5), kind="static")
    belt = track.add_shape(evil.Rectangle(10, 1), offset=(10, 0), surface_speed=3)
    still = world.add(evil.Rectangle(0.5, 0.5), at=(-5, 0.25))
    carried = world.add(evil.Rectangle(0.5, 0.5), at=(2, 0.25))
    run(world, 1)
    assert belt.surface_speed == 3
    assert track.surface_speed == 0
    assert still.velocity.x == pytest.approx(0, abs=1e-3)
    assert carried.velocity.x == pytest.approx(3, rel=0.01)


# -- kinematic bodies that carry --


def test_an_elevator_carries_up_and_down_without_a_gap(world):
    lift = world.add(evil.Rectangle(3, 0.2), kind="kinematic")
    box = world.add(evil.Rectangle(1, 1), at=(0, 0.6))
    lift.follow(lambda time: (0, 2 * math.sin(time)))  # at most 2 m/s2: less than gravity
    run(world, 0.5)
    for _ in range(600):
        world.step()
        assert box.position.y - lift.position.y == pytest.approx(0.6, abs=0.02)


def test_a_ferry_takes_along_by_friction_and_not_faster_than_friction_can(world):
    ferry = world.add(evil.Rectangle(20, 0.2), kind="kinematic", friction=0.5)
    box = world.add(evil.Rectangle(1, 1), at=(0, 0.6), friction=0.5)
    run(world, 0.5)
    ferry.velocity = (2, 0)
    world.step()
    assert 0 < box.velocity.x <= 0.5 * G / 60 * 1.05
    run(world, 1)
    start = box.position.x - ferry.position.x
    run(world, 3)
    assert box.velocity.x == pytest.approx(2, rel=1e-3)
    assert box.position.x - ferry.position.x == pytest.approx(start, abs=0.01)


def test_a_turntable_carries_round(world):
    world.gravity = (0, -G)
    wheel = world.add(evil.Rectangle(8, 0.4), kind="kinematic", friction=1)
    box = world.add(evil.Rectangle(0.5, 0.5), at=(2, 0.45), friction=1)
    run(world, 0.5)
    wheel.angular_velocity = 0.2
    run(world, 2)  # 0.4 radians: a slope that friction holds
    where = wheel.to_local(box.position)
    assert where.x == pytest.approx(2, abs=0.05)
    assert where.y == pytest.approx(0.45, abs=0.02)
    assert box.angle == pytest.approx(0.4, abs=0.02)


def test_a_platform_that_starts_wakes_who_sleeps_on_it(world):
    lift = world.add(evil.Rectangle(3, 0.2), kind="kinematic")
    pile = [world.add(evil.Rectangle(1, 1), at=(0, 0.6 + y)) for y in range(3)]
    run(world, 2)
    assert not any(box.awake for box in pile)
    lift.velocity = (0, 0.02)
    world.step()
    assert all(box.awake for box in pile)
    run(world, 5)
    assert pile[-1].position.y == pytest.approx(lift.position.y + 2.6, abs=0.03)
