"""Platforms that are solid from one side: what comes from there stands, what comes from elsewhere passes."""

from __future__ import annotations

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import evilengine as evil


@pytest.fixture
def world():
    return evil.World()


def platform(world, at=(0, 2), width=6, height=0.2, **words):
    return world.add(evil.Rectangle(width, height), at=at, kind="static", one_way=True, **words)


def run(world, seconds):
    for _ in range(round(seconds * 60)):
        world.step()


SHAPES = [evil.Circle(0.3), evil.Rectangle(0.6, 0.6), evil.Polygon([(-0.3, -0.3), (0.3, -0.3), (0, 0.5)])]


@pytest.mark.parametrize("shape", SHAPES, ids=repr)
def test_from_above_it_is_solid_and_from_below_it_is_not(world, shape):
    platform(world)
    above = world.add(shape, at=(-2, 4))
    below = world.add(shape, at=(2, 0), velocity=(0, 9))
    highest = 0.0
    for _ in range(240):
        world.step()
        highest = max(highest, below.position.y)
    assert highest == pytest.approx(9**2 / (2 * 9.81), rel=0.03)  # nothing slowed it on the way
    for body in (above, below):
        assert body.position.y == pytest.approx(2.4, abs=0.02)
        assert not body.awake


def test_what_does_not_get_through_falls_back(world):
    platform(world)
    ball = world.add(evil.Circle(0.3), at=(0, 0.5), velocity=(0, 5.5))  # its middle gets to the platform's
    highest = 0.0
    for _ in range(90):
        world.step()
        highest = max(highest, ball.position.y)
    assert 1.9 < highest < 2.2
    assert ball.position.y < -1


def test_what_starts_inside_falls_out_below(world):
    platform(world, height=1)
    ball = world.add(evil.Circle(0.3), at=(0, 2))
    box = world.add(evil.Rectangle(0.5, 2), at=(2, 2))
    run(world, 1.5)
    assert ball.position.y < -1
    assert box.position.y < -1


def test_from_the_side_it_is_not_there(world):
    world.gravity = (0, 0)
    platform(world, height=1)
    ball = world.add(evil.Circle(0.3), at=(-6, 2), velocity=(4, 0))
    run(world, 3)
    assert ball.position == pytest.approx((6, 2), abs=1e-3)
    assert ball.velocity == pytest.approx((4, 0))
    assert not world.contacts.active


@pytest.mark.parametrize("speed", [5, 20, 60, 150, 400])
@pytest.mark.parametrize("shape", SHAPES, ids=repr)
def test_however_fast(world, shape, speed):
    platform(world)
    down = world.add(shape, at=(-2, 5), velocity=(0, -speed))
    up = world.add(shape, at=(2, -1), velocity=(0, speed))
    for _ in range(30):
        world.step()
        assert down.position.y > 2
    assert up.velocity.y == pytest.approx(speed - 9.81 / 2, rel=1e-3)
    assert up.position.y == pytest.approx(-1 + speed / 2 - 9.81 / 8, abs=0.1) or speed < 10


def test_the_side_is_the_bodys_own_and_turns_with_it(world):
    world.gravity = (0, 0)
    wall = world.add(evil.Rectangle(4, 0.2), kind="static", one_way=(0, 1), angle=math.pi / 2)  # solid to the left
    stopped = world.add(evil.Circle(0.3), at=(-3, 1), velocity=(4, 0))
    through = world.add(evil.Circle(0.3), at=(3, -1), velocity=(-4, 0))
    run(world, 2)
    assert wall.one_way == (0, 1)
    assert stopped.position.x == pytest.approx(-0.4, abs=0.02)
    assert through.position.x == pytest.approx(-5, abs=1e-3)


def test_a_moving_platform_lifts_what_stands_on_it_and_comes_down_through_what_is_below(world):
    world.add(evil.Rectangle(40, 1), at=(0, -0.5), kind="static")
    lift = world.add(evil.Rectangle(4, 0.2), at=(0, 3), kind="kinematic", one_way=True, velocity=(0, -1))
    rider = world.add(evil.Rectangle(0.5, 0.5), at=(-1, 3.4))
    below = world.add(evil.Rectangle(0.5, 0.5), at=(1, 0.25))
    run(world, 2.5)
    assert rider.position.y == pytest.approx(lift.position.y + 0.35, abs=0.02)
    assert below.position.y == pytest.approx(0.25, abs=0.01)
    run(world, 0.3)
    lift.velocity = (0, 1)
    run(world, 2)
    assert rider.position.y == pytest.approx(lift.position.y + 0.35, abs=0.02)
    assert below.position.y == pytest.approx(0.25, abs=0.01)


def test_it_may_be_opened_and_closed(world):
    floor = platform(world)
    box = world.add(evil.Rectangle(1, 1), at=(0, 2.6))
    run(world, 2)
    assert not box.awake
    floor.one_way = (0, -1)  # solid from below now: what stands on it drops through
    run(world, 1)
    assert box.position.y < 0
    floor.one_way = None
    assert floor.one_way is None


def test_contacts_are_told_of_what_stands_and_not_of_what_passes(world):
    platform(world)
    ball = world.add(evil.Circle(0.3), at=(0, 0), velocity=(0, 9))
    begun = []
    ball.on_collide(lambda contact: begun.append(contact.normal.y))
    run(world, 3)
    assert begun == pytest.approx([1])


@settings(max_examples=40, deadline=None)
@given(
    shape=st.sampled_from(SHAPES),
    speed=st.floats(0, 60),
    gap=st.floats(0.02, 3),
    angle=st.floats(-0.2, 0.2),
    height=st.floats(0.05, 1),
)
def test_nothing_that_comes_from_above_gets_through(shape, speed, gap, angle, height):
    world = evil.World()
    platform(world, at=(0, -height / 2), width=400, height=height)
    body = world.add(shape, at=(0, 0.5 + gap), angle=angle, velocity=(0, -speed))
    for _ in range(120):
        world.step()
        assert body.position.y > 0


def test_what_was_decided_is_in_a_snapshot(world):
    platform(world, height=1)
    for x in range(5):
        world.add(evil.Circle(0.3), at=(x - 2, 1 + x / 3), velocity=(0, 6))
    for step in range(150):
        twin = evil.World.of(world.snapshot())
        twin.step()
        world.step()
        assert twin.snapshot() == world.snapshot(), step
