"""Characters: how they walk and jump, what they climb, and that they stand still."""

from __future__ import annotations

import math

import pytest
from heroes import FEET, STEP, flat, go, heights, slope

import evilengine as evil

# -- walking --


def test_it_reaches_its_speed_by_its_acceleration_and_stops_by_its_deceleration() -> None:
    world, hero = flat(speed=6, acceleration=12, deceleration=24)
    hero.move(1)
    go(world, 15)
    assert hero.velocity.x == pytest.approx(3, rel=1e-4)
    go(world, 60)
    assert hero.velocity == pytest.approx((6, 0), abs=1e-4)
    hero.move(0)
    go(world, 7)
    assert hero.velocity.x == pytest.approx(6 - 24 * 7 / 60, rel=1e-4)
    go(world, 20)
    assert hero.velocity == (0, 0)
    hero.move(-0.5)
    go(world, 60)
    assert hero.velocity.x == pytest.approx(-3, rel=1e-4)


@pytest.mark.parametrize("ground", [0, 20, 40, -30])
def test_it_stands_still_to_a_tenth_of_a_millimetre(ground: float) -> None:
    world = evil.World()
    world.add(slope(ground) if ground else evil.Rectangle(40, 2), at=(-5, -1 if not ground else 0), kind="static")
    hero = world.add_character(at=(3, 8 if ground > 0 else 2))
    go(world, 120)
    assert hero.grounded
    place = hero.position
    farthest = 0.0
    for _ in range(300):
        world.step(STEP)
        farthest = max(farthest, (hero.position - place).length)
    assert farthest < 1e-4


@pytest.mark.parametrize(
    ("degrees", "walks"), [(20, True), (40, True), (49, True), (53, False), (60, False), (80, False)]
)
@pytest.mark.parametrize("shape", [None, evil.Rectangle(0.6, 1.5), evil.Circle(0.5)], ids=["capsule", "box", "ball"])
def test_it_walks_up_40_degrees_and_not_60(degrees: float, walks: bool, shape: evil.Shape | None) -> None:
    world = evil.World()
    world.add(evil.Rectangle(40, 1), at=(-20, -0.5), kind="static")
    world.add(slope(degrees), kind="static")
    hero = world.add_character(shape, at=(-2, 0.8))
    hero.move(1)
    track = heights(world, hero, 180)
    if walks:
        assert track[-1] > 4
        assert hero.grounded
        assert hero.velocity.length == pytest.approx(hero.speed, rel=1e-3), "as fast as on the flat"
    else:
        assert max(track) < track[30] + 0.35


@pytest.mark.parametrize("degrees", [15, 30, 45])
def test_it_walks_down_a_slope_without_a_hop(degrees: float) -> None:
    world = evil.World()
    world.add(evil.Rectangle(40, 1), at=(-20, -0.5), kind="static")
    world.add(slope(-degrees), kind="static")
    hero = world.add_character(at=(-2, 0.8), speed=8)
    go(world, 20)
    hero.move(1)
    in_the_air = []
    go(world, 120, lambda: in_the_air.append(not hero.grounded))
    assert not any(in_the_air)
    assert hero.position.y < -2
    assert hero.velocity.length == pytest.approx(8, rel=1e-3)


def test_it_slides_down_what_it_cannot_stand_on_and_does_not_climb_it_in_the_air() -> None:
    world = evil.World()
    world.add(evil.Rectangle(40, 1), at=(-20, -0.5), kind="static")
    world.add(slope(60), kind="static")
    hero = world.add_character(at=(3, 8))
    hero.move(1)
    go(world, 240)
    assert hero.grounded
    assert hero.position.x < 0.3


@pytest.mark.parametrize(("height", "over"), [(0.1, True), (0.3, True), (0.45, False), (1.0, False)])
@pytest.mark.parametrize("shape", [None, evil.Rectangle(0.6, 1.5)], ids=["capsule", "box"])
def test_it_steps_onto_what_is_no_higher_than_a_step(height: float, over: bool, shape: evil.Shape | None) -> None:
    world, hero = flat(shape=shape) if shape else flat()
    world.add(evil.Rectangle(40, height), at=(22, height / 2), kind="static")
    hero.move(1)
    go(world, 90)
    if over:
        assert hero.position == pytest.approx((hero.position.x, FEET + height), abs=0.01)
        assert hero.position.x > 4
    else:
        assert hero.position == pytest.approx((1.7, FEET), abs=0.01)
    assert hero.grounded


def test_it_walks_up_stairs_and_down_again_on_the_ground() -> None:
    world, hero = flat()
    for i in range(10):
        world.add(evil.Rectangle(0.5, 0.25 * (i + 1)), at=(2 + 0.5 * i, 0.125 * (i + 1)), kind="static")
    for i in range(10):
        world.add(evil.Rectangle(0.5, 0.25 * (10 - i)), at=(7 + 0.5 * i, 0.125 * (10 - i)), kind="static")
    hero.move(1)
    track, in_the_air = [], []
    go(world, 200, lambda: (track.append(hero.position.y), in_the_air.append(not hero.grounded)))
    assert max(track) == pytest.approx(FEET + 2.5, abs=0.02)
    assert hero.position.x > 12
    assert track[-1] == pytest.approx(FEET, abs=0.01)
    assert sum(in_the_air) == 0


# -- jumping --


@pytest.mark.parametrize("height", [0.5, 2.0, 5.0])
@pytest.mark.parametrize("scale", [1.0, 2.5])
def test_a_jump_is_as_high_as_it_says(height: float, scale: float) -> None:
    world, hero = flat(jump_height=height, gravity_scale=scale, fall_speed=100)
    start = hero.position.y
    hero.jump()
    track = heights(world, hero, 150)
    assert max(track) - start == pytest.approx(height, abs=9.81 * scale * STEP**2 / 8 + 2e-4)
    seconds = 2 * math.sqrt(2 * height / (9.81 * scale))
    assert sum(y > start + 5e-3 for y in track) * STEP == pytest.approx(seconds, abs=2.5 * STEP)
    assert hero.grounded


def test_a_jump_let_go_early_is_lower() -> None:
    tops = []
    for held in (1, 6, 12, 60):
        world, hero = flat(jump_height=3)
        hero.jump()
        top = max(heights(world, hero, held))
        hero.let_go()
        tops.append(max(top, *heights(world, hero, 80)) - FEET)
    assert tops[0] < tops[1] < tops[2] < tops[3]
    assert tops[0] < 1
    assert tops[3] == pytest.approx(3, abs=0.01)


@pytest.mark.parametrize(("late", "jumps"), [(1, True), (5, True), (8, False)])
def test_a_jump_just_after_the_edge_still_counts(late: int, jumps: bool) -> None:
    world = evil.World()
    world.add(evil.Rectangle(10, 1), at=(-5, -0.5), kind="static")
    hero = world.add_character(at=(-1, FEET + 0.01), coyote_time=0.1)
    hero.move(1)
    while hero.grounded or hero.position.x < 0:
        world.step(STEP)
    go(world, late - 1)
    low = hero.position.y
    hero.jump()
    assert (max(heights(world, hero, 30)) > low + 1.5) is jumps


@pytest.mark.parametrize(("early", "jumps"), [(2, True), (5, True), (12, False)])
def test_a_jump_just_before_landing_is_remembered(early: int, jumps: bool) -> None:
    world, hero = flat(jump_buffer=0.1, jump_height=1)
    hero.jump()
    go(world, 1)
    airtime = 1
    while not hero.grounded:
        go(world, 1)
        airtime += 1
    go(world, 30)
    hero.jump()
    go(world, airtime - early)
    hero.jump()
    go(world, early + 5)
    assert (not hero.grounded) is jumps


def test_air_jumps_are_counted_until_it_lands() -> None:
    world, hero = flat(air_jumps=1, jump_height=1, coyote_time=0)
    told = []
    hero.on_jump(lambda: told.append(hero.position.y))
    for _ in range(4):
        hero.jump()
        go(world, 15)
    assert len(told) == 2
    go(world, 100)
    hero.jump()
    go(world, 5)
    assert len(told) == 3


def test_it_lands_with_the_speed_of_its_fall() -> None:
    world, hero = flat(gravity_scale=1, fall_speed=50)
    told = []
    hero.on_land(told.append)
    hero.position = (0, FEET + 5)
    go(world, 100)
    assert told == [pytest.approx(math.sqrt(2 * 9.81 * 5), rel=0.03)]


def test_it_falls_no_faster_than_it_may() -> None:
    world = evil.World()
    hero = world.add_character(at=(0, 0), fall_speed=12)
    go(world, 200)
    assert hero.velocity == pytest.approx((0, -12), abs=1e-4)


def test_a_ceiling_ends_a_jump() -> None:
    world, hero = flat(jump_height=4)
    world.add(evil.Rectangle(10, 1), at=(0, 3), kind="static")
    hero.jump()
    track = heights(world, hero, 60)
    assert max(track) == pytest.approx(2.5 - FEET, abs=0.02)
    assert track.index(max(track)) < 15
    assert hero.grounded


@pytest.mark.parametrize("thrown", [26, 100, 1000])
def test_it_does_not_bounce_when_it_was_thrown_at_the_ground(thrown: float) -> None:
    world, hero = flat()
    hero.position = (0, 8)
    hero.velocity = (3, -thrown)
    for _ in range(120):
        world.step()
        assert hero.velocity.y <= 0
    assert hero.grounded
    assert hero.position.y == pytest.approx(FEET, abs=0.01)


def test_it_does_not_bounce_when_it_opens_its_umbrella_just_above_the_ground() -> None:
    world, hero = flat()
    hero.position = (0, 4)
    while hero.position.y > FEET + 0.1:
        world.step()
    hero.fall_speed = 1
    world.step()
    assert hero.velocity.y <= 0
