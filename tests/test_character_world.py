"""Characters among other things: what carries and pushes them, what they push and climb, and that they can be saved."""

from __future__ import annotations

import math
from collections.abc import Callable

import pytest
from heroes import FEET, STEP, flat, go, slope

import evilengine as evil

# -- what moves --


def test_a_platform_carries_it_exactly() -> None:
    world = evil.World()
    lift = world.add(evil.Rectangle(4, 0.5), kind="kinematic", velocity=(1.5, 0.7))
    hero = world.add_character(at=(0.4, 0.25 + FEET + 0.005))
    go(world, 10)
    apart = hero.position - lift.position
    go(world, 300)
    assert hero.position - lift.position == pytest.approx(apart, abs=1e-4)
    lift.velocity = (-2, -1.2)
    go(world, 300)
    assert hero.position - lift.position == pytest.approx(apart, abs=2e-4)
    assert hero.velocity == pytest.approx((-2, -1.2), abs=1e-4)


def test_a_jump_takes_the_speed_of_its_platform_along() -> None:
    world = evil.World()
    lift = world.add(evil.Rectangle(4, 0.5), kind="kinematic", velocity=(3, 2))
    hero = world.add_character(at=(0, 0.25 + FEET + 0.005), jump_height=1, air_deceleration=0)
    go(world, 10)
    hero.jump()
    go(world, 1)
    assert hero.velocity.x == pytest.approx(3, abs=1e-4)
    assert hero.velocity.y == pytest.approx(math.sqrt(2 * 2 * 9.81 * 1) + 2 - 2 * 9.81 * STEP, rel=1e-3)
    lift.destroy()
    go(world, 10)
    assert hero.velocity.x == pytest.approx(3, abs=1e-4)


def test_a_belt_carries_it() -> None:
    world = evil.World()
    world.add(evil.Rectangle(40, 1), at=(0, -0.5), kind="static", surface_speed=2)
    hero = world.add_character(at=(0, FEET))
    go(world, 60)
    assert hero.velocity.x == pytest.approx(2, abs=1e-3)
    hero.move(-1)
    go(world, 60)
    assert hero.velocity.x == pytest.approx(2 - hero.speed, abs=1e-3)


def test_a_wheel_that_turns_carries_it_round() -> None:
    world = evil.World()
    plate = world.add(evil.Rectangle(6, 0.5), kind="kinematic", angular_velocity=0.3)
    hero = world.add_character(at=(2, 0.25 + FEET + 0.005))
    go(world, 60)
    assert hero.grounded
    assert hero.ground is plate
    assert hero.position.y > FEET + 0.25 + 0.5


def test_a_wall_that_comes_pushes_it() -> None:
    world, hero = flat()
    wall = world.add(evil.Rectangle(1, 2), at=(2, 1.01), kind="kinematic", velocity=(-2, 0))
    go(world, 120)
    assert hero.position.x == pytest.approx(wall.position.x - 0.5 - 0.3, abs=0.02)
    assert hero.position.x < -2


def test_it_is_crushed_between_a_press_and_the_ground_and_told_once() -> None:
    world, hero = flat()
    told = []
    hero.on_crush(lambda: told.append(world.steps))
    world.add(evil.Rectangle(4, 1), at=(0, 3), kind="kinematic", velocity=(0, -1))
    go(world, 50)
    assert not told
    assert not hero.crushed
    go(world, 60)
    assert len(told) == 1
    assert hero.crushed


# -- pushing --


def test_it_pushes_a_crate_and_one_too_heavy_stops_it() -> None:
    world, hero = flat()
    crate = world.add(evil.Rectangle(1, 1), at=(2, 0.5))
    hero.move(1)
    go(world, 120)
    assert crate.position.x > 6
    assert crate.position.y == pytest.approx(0.5, abs=0.02)
    assert hero.position.x == pytest.approx(crate.position.x - 0.8, abs=0.06)
    world, hero = flat()
    crate = world.add(evil.Rectangle(1, 1), at=(2, 0.5), mass=200)
    hero.move(1)
    go(world, 120)
    assert crate.position.x == pytest.approx(2, abs=0.05)
    assert hero.position.x == pytest.approx(1.2, abs=0.05)


def test_its_push_is_no_stronger_than_its_force() -> None:
    world, hero = flat(push_force=6, step_height=0)
    crate = world.add(evil.Rectangle(1, 1), at=(2, 0.5), mass=3, friction=0)
    hero.move(1)
    touched = None
    for _ in range(90):
        world.step(STEP)
        if touched is None and crate.velocity.x > 1e-3:
            touched = (world.time, crate.velocity.x)
        if touched and world.time - touched[0] > 0.4:
            break
    assert touched is not None
    assert crate.velocity.x <= touched[1] + 6 / 3 * (world.time - touched[0]) * 1.05
    assert crate.velocity.x >= 0.5 * 6 / 3 * (world.time - touched[0])


def test_what_comes_at_it_pushes_it_by_its_mass() -> None:
    world, hero = flat(mass=1, deceleration=5)
    world.add(evil.Circle(0.5), at=(-4, 0.8), mass=10, velocity=(10, 0), friction=0, gravity_scale=0)
    go(world, 30)
    assert hero.velocity.x > 3
    world, hero = flat(mass=1)
    world.add(evil.Circle(0.1), at=(-4, 0.8), mass=0.01, velocity=(10, 0), friction=0, gravity_scale=0)
    go(world, 40)
    assert abs(hero.position.x) < 0.1


def test_it_stands_on_a_crate_and_carries_none_away() -> None:
    world, hero = flat()
    crate = world.add(evil.Rectangle(2, 1), at=(0, 0.5), mass=3)
    hero.position = (0, 1 + FEET + 0.1)
    go(world, 120)
    assert hero.ground is crate
    assert crate.position == pytest.approx((0, 0.5), abs=0.02)
    place = hero.position
    go(world, 120)
    assert hero.position == pytest.approx(place, abs=2e-3)


# -- ways through and up --


def test_it_jumps_through_a_platform_from_below_stands_on_it_and_drops() -> None:
    world, hero = flat(jump_height=3)
    shelf = world.add(evil.Rectangle(4, 0.2), at=(0, 2), kind="static", one_way=True)
    hero.jump()
    go(world, 100)
    assert hero.ground is shelf
    assert hero.position.y == pytest.approx(2.1 + FEET, abs=0.02)
    hero.move(1)
    go(world, 20)
    assert hero.ground is shelf
    hero.move(0)
    hero.drop()
    go(world, 60)
    assert hero.position.y == pytest.approx(FEET, abs=0.02)


def test_a_ladder_takes_it_up_to_its_top_and_lets_it_go() -> None:
    world, hero = flat(ladders=[(-0.5, 0, 0.5, 4)], climb_speed=2)
    world.add(evil.Rectangle(4, 0.5), at=(2.6, 3.75), kind="static")  # a floor beside its top
    hero.climb(1)
    go(world, 30)
    assert hero.climbing
    assert hero.velocity == pytest.approx((0, 2), abs=1e-3)
    hero.climb(0)
    place = hero.position
    go(world, 60)
    assert hero.position == place, "it holds on"
    hero.climb(1)
    go(world, 150)
    assert hero.position.y - FEET == pytest.approx(4, abs=0.05), "and not beyond its top"
    hero.move(1)
    go(world, 40)
    assert hero.grounded
    assert hero.position.y == pytest.approx(4 + FEET, abs=0.05)
    hero.move(0)
    hero.position = (0, 2)
    hero.climb(1)
    go(world, 5)
    hero.climb(0)
    hero.jump()
    go(world, 3)
    assert not hero.climbing
    assert hero.velocity.y > 1


# -- never --


@pytest.mark.parametrize("speed", [20.0, 200.0, 1000.0])
@pytest.mark.parametrize("to", [(1, 0), (-1, -1), (0, -1), (0.3, 1)])
def test_it_never_passes_through_a_wall(speed: float, to: evil.Point) -> None:
    world = evil.World(gravity=(0, -20))
    for centre, size in (
        ((0, -5), (10.1, 0.02)),
        ((0, 5), (10.1, 0.02)),
        ((-5, 0), (0.02, 10.1)),
        ((5, 0), (0.02, 10.1)),
    ):
        world.add(evil.Rectangle(*size), at=centre, kind="static")
    hero = world.add_character(fall_speed=1e4)
    for _ in range(10):
        hero.velocity = evil.Vec2(*to).direction * speed
        go(world, 10)
        assert abs(hero.position.x) < 5
        assert abs(hero.position.y) < 5


def test_it_turns_with_gravity() -> None:
    world = evil.World()
    for at in ((0, -5.5), (0, 5.5)):
        world.add(evil.Rectangle(12, 1), at=at, kind="static")
    for at in ((-5.5, 0), (5.5, 0)):
        world.add(evil.Rectangle(1, 12), at=at, kind="static")
    hero = world.add_character()
    for gravity, down in (((9.81, 0), (1, 0)), ((0, 9.81), (0, 1)), ((-9.81, 0), (-1, 0)), ((0, -9.81), (0, -1))):
        world.gravity = gravity
        go(world, 120)
        assert hero.grounded
        assert hero.ground_normal == pytest.approx(-evil.Vec2(*down), abs=1e-4)
        assert evil.Vec2(*down).dot(hero.position) == pytest.approx(5 - FEET, abs=0.02)


def test_two_characters_pass_each_other_and_each_has_its_own_abilities() -> None:
    world, strong = flat(speed=3, jump_height=1)
    light = world.add_character(at=(3, FEET + 0.01), speed=8, air_jumps=1)
    strong.move(1)
    light.move(-1)
    go(world, 60)
    assert strong.position.x > light.position.x
    assert (strong.speed, light.speed, strong.air_jumps, light.air_jumps) == (3, 8, 0, 1)
    assert world.characters == (strong, light)
    assert world.character_of(light.body) == light
    assert world.character_of(next(iter(world.bodies))) is None


# -- saved --


def busy() -> evil.World:
    world, hero = flat(ladders=[(-9, 0, -8, 5)], air_jumps=1)
    world.add(evil.Rectangle(3, 0.4), at=(4, 0.8), kind="kinematic", velocity=(0.3, 0.1))
    world.add(evil.Rectangle(1, 1), at=(2, 0.5))
    world.add(slope(30), at=(8, 0), kind="static")
    hero.move(1)
    return world


def play(world: evil.World, steps: int) -> None:
    hero = world.characters[0]
    for i in range(steps):
        if world.steps % 37 == 5:
            hero.jump()
        if world.steps % 37 == 15:
            hero.let_go()
        if world.steps % 90 == 0:
            hero.move(-1 if i % 180 else 1)
        world.step(STEP)


def test_a_restored_character_goes_on_to_the_bit() -> None:
    world = busy()
    play(world, 70)
    data = world.snapshot()
    other = evil.World.of(data)
    assert other.snapshot() == data
    assert other.characters[0].ladders == ((-9, 0, -8, 5),)
    for _ in range(20):
        play(world, 10)
        other.ray_cast((0, 0), (9, 9))  # its index may be of another form: nothing follows from it
        play(other, 10)
        assert other.checksum() == world.checksum()
    world.restore(data)
    assert world.characters[0].air_jumps == 1


def test_a_character_of_several_shapes_weighs_as_much_as_all_of_them() -> None:
    world = evil.World()
    hero = world.add_character([evil.Rectangle(1, 2), evil.Circle(0.5)], density=2)
    assert hero.mass == pytest.approx(2 * (2 + 0.25 * math.pi))
    assert hero.push_force == pytest.approx(40 * hero.mass)


def test_a_character_goes_with_its_body() -> None:
    world, hero = flat()
    other = world.add_character(at=(5, 1))
    hero.body.destroy()
    assert not hero.alive
    assert "gone" in repr(hero)
    with pytest.raises(evil.StaleReferenceError):
        hero.move(1)
    assert world.characters == (other,)
    for body in tuple(world.bodies):
        if body != other.body:
            body.destroy()
    go(world, 5)
    assert other.ground is None
    other.destroy()
    assert world.characters == ()
    go(world, 5)


@pytest.mark.parametrize(
    ("ask", "says"),
    [
        (lambda w: w.add_character(speed=-1), "speed=-1 must be from 0"),
        (lambda w: w.add_character(air_jumps=1.5), "air_jumps must be a whole number"),
        (lambda w: w.add_character(max_slope=90), "max_slope=90 must be from 0 to 1.57"),
        (lambda w: w.add_character(ladders=[(0, 0, 1)]), "must be four numbers"),
        (lambda w: w.add_character(ladders=[(2, 0, 1, 1)]), "left must be less than right"),
        (lambda w: w.add_character(kind="dynamic"), "unknown argument kind='dynamic'"),
        (lambda w: w.add_character(jump_hight=2), "jump_hight=2; did you mean 'jump_height'"),
        (lambda w: w.add_character().move(2), "axis=2 must be from -1 to 1"),
        (lambda w: w.add_character().climb("up"), "axis='up' must be a number"),
        (lambda w: setattr(w.add_character(), "velocity", (1e9, 0)), "velocity must be at most 1e5"),
    ],
)
def test_what_makes_no_sense_is_refused(ask: Callable[[evil.World], object], says: str) -> None:
    world = evil.World()
    with pytest.raises(evil.Error, match=says):
        ask(world)
    assert len(world.characters) in (0, 1)
    assert len(world.bodies) == len(world.characters), "nothing half-made stays"
    go(world, 2)
