"""Smoke by its public face: what it takes and refuses, what bodies feel, what is saved, the same bits everywhere."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import evilengine as evil


def a_scene(**options: Any) -> evil.World:
    """A plume, a swinging lamp that carries a source, a wall, and light balls in the draught."""
    world = evil.World(**options.pop("world", {}))
    smoke = world.add_smoke((-2, 0, 2, 4), cells=48, vorticity=2, viscosity=1e-3, open_sides="top", **options)
    smoke.add_source(at=(0, 0.4), radius=0.3, rate=2, temperature=1, velocity=(0, 1))
    hook = world.add(evil.Circle(0.05), at=(0.5, 3.5), kind="static")
    lamp = world.add(evil.Capsule((0, -0.2), (0, 0.2), 0.15), at=(1.4, 2.6))
    world.add_joint(evil.joints.Distance(hook, lamp))
    smoke.add_source(evil.Rectangle(0.2, 0.1), body=lamp, rate=1, colour="orange", fuel=1)
    world.add(evil.Rectangle(1.5, 0.2), at=(-1, 2), angle=0.5, kind="static")
    for k in range(5):
        world.add(evil.Circle(0.1), at=(-1 + 0.4 * k, 1 + 0.1 * k), density=0.05)
    return world


def run(world: evil.World, steps: int) -> int:
    for _ in range(steps):
        world.step()
    return world.checksum()


@pytest.mark.parametrize("quality", ["fast", "high"])
def test_all_instruction_sets_and_any_threads_give_the_same_bits(quality: str) -> None:
    sums = set()
    for set_name, threads in (("plain", 1), ("sse2", 1), ("avx2", 1), ("avx2", 2)):
        world = a_scene(quality=quality, world={"threads": threads})
        try:
            world._core.instruction_set = set_name
        except evil.ArgumentError:
            continue  # this machine has no such set
        sums.add(run(world, 25))
    assert len(sums) == 1


def test_threads_change_nothing_on_a_grid_that_is_worth_sharing() -> None:
    sums = set()
    for threads in (1, 3):
        world = evil.World(threads=threads)
        smoke = world.add_smoke((0, 0, 2, 2), cells=128, vorticity=1)
        smoke.add_source(at=(1, 0.3), radius=0.2, rate=2, temperature=1)
        world.add(evil.Circle(0.2), at=(1, 1), density=0.1)
        sums.add(run(world, 12))
    assert len(sums) == 1


@pytest.mark.parametrize("quality", ["fast", "high"])
def test_a_restored_world_goes_on_to_the_same_bits(quality: str) -> None:
    world = a_scene(quality=quality)
    run(world, 20)
    data, then = world.snapshot(), world.checksum()
    later = run(world, 15)
    world.restore(data)
    assert world.checksum() == then
    assert run(world, 15) == later
    assert run(evil.World.of(data), 15) == later


def test_references_live_through_a_restore_as_those_of_bodies_do() -> None:
    world = a_scene()
    smoke = world.smokes[0]
    source = smoke.sources[0]
    data = world.snapshot()
    later = world.add_smoke((0, 0, 1, 1), cells=8)
    source.destroy()
    world.restore(data)
    assert smoke.alive
    assert smoke == world.smokes[0]
    assert not later.alive
    assert not source.alive, "it was destroyed, and another came in its place"
    assert len(smoke.sources) == 2
    with pytest.raises(evil.StaleReferenceError, match="this Source"):
        source.rate = 1
    with pytest.raises(evil.StaleReferenceError, match=r"this Smoke .* is gone"):
        later.add_source(radius=1)


def test_a_smoke_of_another_history_is_not_taken_for_the_one_that_is_restored() -> None:
    world = evil.World()
    before = world.snapshot()
    here = world.add_smoke((0, 0, 1, 1), cells=8)
    here.add_source(at=(0.5, 0.5), radius=0.2)
    data = world.snapshot()
    world.restore(before)
    other = world.add_smoke((0, 0, 1, 1), cells=16)
    world.restore(data)
    assert not other.alive
    assert world.smokes[0].cells == (8, 8)
    world.restore(before)
    again = world.add_smoke((0, 0, 1, 1), cells=8)
    source = again.add_source(at=(0.5, 0.5), radius=0.1)
    world.restore(data)
    assert again.alive
    assert not source.alive


def test_a_light_ball_rides_the_draught_and_a_heavy_one_does_not() -> None:
    world = evil.World(gravity=(0, 0))
    smoke = world.add_smoke((0, 0, 4, 2), cells=64, open_sides="left right", wind=(2, 0), wind_pull=5, weight=1)
    light = world.add(evil.Circle(0.15), at=(1, 1), density=0.5)
    heavy = world.add(evil.Circle(0.15), at=(1, 0.5), density=200)
    run(world, 60)
    assert 0.5 < light.velocity.x < 2.3
    assert 1 < heavy.position.x < 1.05
    assert smoke.velocity_at((3, 1)).x > 1.5


def test_a_draught_turns_a_wheel_that_it_meets_on_one_side() -> None:
    world = evil.World(gravity=(0, 0))
    smoke = world.add_smoke((0, 0, 2, 2), cells=64, open_sides="all", weight=1)
    smoke.add_source(evil.Rectangle(0.2, 0.5), at=(0.3, 1.35), velocity=(3, 0))
    wheel = world.add(evil.Rectangle(0.1, 1.2), at=(1, 1))
    axle = world.add(evil.Circle(0.01), at=(1, 1), kind="static", sensor=True)
    world.add_joint(evil.joints.Hinge(axle, wheel, at=(1, 1)))
    run(world, 40)
    assert wheel.angle < -0.1


def test_gas_wakes_what_sleeps_in_its_way() -> None:
    world = evil.World(gravity=(0, 0))
    smoke = world.add_smoke((0, 0, 2, 2), cells=32, weight=1)
    ball = world.add(evil.Circle(0.2), at=(1, 1), density=0.2)
    run(world, 120)
    assert not ball.awake
    smoke.add_source(radius=0.3, at=(0.5, 1), velocity=(3, 0))
    run(world, 30)
    assert ball.awake
    assert ball.velocity.x > 0


def test_a_very_light_body_in_heavy_gas_stays_calm() -> None:
    world = evil.World(gravity=(0, -10))
    smoke = world.add_smoke((0, 0, 2, 2), cells=32, weight=1)
    smoke.add_source(at=(1, 0.3), radius=0.2, temperature=2, rate=1)
    for x in (0, 2):
        world.add(evil.Rectangle(0.2, 4), at=(x, 1), kind="static")
    world.add(evil.Rectangle(4, 0.2), at=(1, 0), kind="static")
    feathers = [world.add(evil.Rectangle(0.3, 0.1), at=(0.4 + 0.3 * k, 1), density=0.05) for k in range(5)]
    for _ in range(240):
        world.step()
        assert max(f.velocity.length for f in feathers) < 12


def test_fuel_burns_to_heat_and_soot() -> None:
    world = evil.World(gravity=(0, 0))
    smoke = world.add_smoke((0, 0, 1, 1), cells=16, burning=2, heat=3, soot=0.5, cooling=0)
    np.asarray(smoke.fuel)[8, 8] = 1.0
    run(world, 300)
    assert smoke.fuel[8, 8] < 1e-3
    assert smoke.temperature[8, 8] == pytest.approx(3, rel=0.01)
    assert smoke.density[8, 8] == pytest.approx(0.5, rel=0.01)


def test_a_sink_takes_away_what_flows_into_it() -> None:
    world = evil.World(gravity=(0, 0))
    smoke = world.add_smoke((0, 0, 1, 1), cells=16)
    np.asarray(smoke.density)[...] = 1.0
    smoke.add_source(radius=0.2, at=(0.5, 0.5), rate=-20)
    before = smoke.mass
    run(world, 60)
    assert smoke.density[8, 8] < 0.01
    assert smoke.mass < before


def test_views_are_no_copies_and_may_be_written() -> None:
    world = evil.World(gravity=(0, 0))
    smoke = world.add_smoke((0, 0, 2, 1), cells=(16, 8))
    density, velocity = np.asarray(smoke.density), np.asarray(smoke.velocity)
    assert density.shape == (8, 16)
    assert velocity.shape == (8, 16, 2)
    assert density.dtype == np.float32
    density[2, 3] = 0.5
    assert smoke.density[2, 3] == 0.5
    assert smoke.density_at((7 / 16, 5 / 16)) == 0.5
    smoke.temperature[0, -1] = 2
    assert smoke.temperature[0, 15] == 2
    velocity[:, :, 0] = 1.0
    world.step()
    assert 0 < velocity[4, 8, 0] < 1.0 or abs(velocity).max() < 1e-3
    smoke.velocity[3, 3] = (0, 0.5)
    with pytest.raises(IndexError, match="no such cell"):
        _ = smoke.density[8, 0]
    smoke.destroy()
    assert density[2, 3] >= 0, "whoever looks keeps it"


@pytest.mark.parametrize("method", ["staggered", "stam"])
def test_numbers_that_are_none_go_no_further_than_a_step(method: str) -> None:
    world = evil.World()
    smoke = world.add_smoke((0, 0, 1, 1), cells=16, method=method)
    ball = world.add(evil.Circle(0.1), at=(0.5, 0.5))
    for field in (smoke.density, smoke.temperature, smoke.fuel, smoke.velocity):
        values = np.asarray(field)
        values[3:5] = math.nan
        values[6] = -math.inf
        values[7] = 1e30
    run(world, 3)
    for field in (smoke.density, smoke.temperature, smoke.fuel, smoke.velocity):
        assert np.isfinite(np.asarray(field)).all()
    assert math.isfinite(ball.position.x)
    world.restore(world.snapshot())


def test_points_are_sampled_one_by_one_or_many_at_once() -> None:
    world = evil.World(gravity=(0, 0))
    smoke = world.add_smoke((0, 0, 4, 4), cells=16)
    np.asarray(smoke.temperature)[...] = 2
    points = np.array([[1.0, 1.0], [3.0, 3.9], [9.0, 1.0]])
    assert smoke.temperature_at((1, 1)) == pytest.approx(2)
    assert smoke.temperature_at(points) == pytest.approx([2, 2, 0])
    assert smoke.density_at([(1, 1), evil.Vec2(2, 2)]) == [0, 0]
    with pytest.raises(evil.ArgumentError, match=r"Smoke.density_at: points must have two columns"):
        smoke.density_at(np.zeros((2, 3)))
    with pytest.raises(evil.ArgumentTypeError, match=r"Smoke.velocity_at: points must be"):
        smoke.velocity_at(3)


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"area": (0, 0, 0, 1)}, "left must be less than right"),
        ({"area": (0, 0, math.nan, 1)}, "area"),
        ({"area": (0, 0, -1, 1)}, "left must be less than right"),
        ({"cells": 0}, "cells=0 must be from 2 to 2048"),
        ({"cells": -4}, "must be from 2 to 2048"),
        ({"cells": 1e9}, "cells=1000000000.0 must be a whole number"),
        ({"cells": 5000}, "must be from 2 to 2048"),
        ({"cells": (16, 16)}, r"would not be square in an area of 2 x 1 m; \(16, 8\) would"),
        ({"viscosity": -1}, "Smoke: viscosity=-1 must be from 0"),
        ({"viscosity": math.nan}, "viscosity"),
        ({"buoyancy": math.inf}, "buoyancy"),
        ({"wind": (math.nan, 0)}, "wind"),
        ({"open_sides": 3}, "open_sides=3 must be sides, such as 'top'"),
        ({"open_sides": None}, "open_sides=None must be sides"),
        ({"open_sides": "lid"}, "open_sides='lid' must be one of 'left', 'right', 'bottom', 'top'"),
        ({"quality": "hihg"}, "did you mean 'high'"),
        ({"method": "flip"}, "method='flip' must be one of 'staggered', 'stam'"),
        ({"side_speeds": (1, 2)}, "four numbers"),
        ({"visosity": 1}, "did you mean 'viscosity'"),
        ({"colour": "smoky"}, "colour"),
    ],
)
def test_what_makes_no_sense_is_refused_and_leaves_nothing_behind(given: dict[str, Any], message: str) -> None:
    world = evil.World()
    before = world.checksum()
    words: dict[str, Any] = {"area": (0, 0, 2, 1), "cells": 16} | given
    with pytest.raises((evil.ArgumentError, evil.ArgumentTypeError), match=message):
        world.add_smoke(words.pop("area"), **words)
    assert world.smokes == ()
    assert world.checksum() == before


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({}, "either a shape or radius="),
        ({"radius": 0}, "radius=0 must be a finite number, more than 0"),
        ({"radius": math.nan}, "radius"),
        ({"radius": 1, "rate": math.inf}, "rate"),
        ({"radius": 1, "fuel": -1}, "fuel"),
        ({"radius": 1, "at": (1, math.nan)}, "at"),
        ({"radius": 1, "velocity": (1e6, 0)}, "velocity"),
        ({"shape": evil.Segment((0, 0), (1, 0))}, "shape with an inside"),
    ],
)
def test_a_source_that_makes_no_sense_is_refused(given: dict[str, Any], message: str) -> None:
    smoke = evil.World().add_smoke((0, 0, 2, 1), cells=16)
    with pytest.raises((evil.ArgumentError, evil.ArgumentTypeError), match=message):
        smoke.add_source(**given)
    assert smoke.sources == ()


@pytest.mark.parametrize("cells", [2, 3, (2, 64), (65, 3), 5])
@pytest.mark.parametrize("open_sides", ["", "all"])
def test_the_smallest_and_the_oddest_grids_work(cells: Any, open_sides: str) -> None:
    nx, ny = (cells, cells) if isinstance(cells, int) else cells
    world = evil.World()
    smoke = world.add_smoke((0, 0, nx / 8, ny / 8), cells=cells, open_sides=open_sides, vorticity=1, viscosity=0.1)
    smoke.add_source(at=(nx / 16, ny / 16), radius=0.3, rate=5, temperature=3, fuel=2, colour="red")
    world.add(evil.Circle(0.05), at=(nx / 16, ny / 16))
    run(world, 20)
    assert np.isfinite(np.asarray(smoke.velocity)).all()
    assert 0 < smoke.mass < 100


def test_a_large_grid_works() -> None:
    world = evil.World()
    smoke = world.add_smoke((0, 0, 10, 10), cells=1024)
    smoke.add_source(at=(5, 1), radius=1, rate=5, temperature=3)
    run(world, 2)
    assert smoke.mass > 0


def test_hard_cases_stay_bounded() -> None:
    """A body faster than a cell a step, bodies jammed in a corner, a source in a solid, a piston in a sealed box."""
    world = evil.World(gravity=(0, -10))
    smoke = world.add_smoke((0, 0, 2, 2), cells=32, weight=1)
    for x in (0, 2):
        world.add(evil.Rectangle(0.2, 4), at=(x, 1), kind="static")
    world.add(evil.Rectangle(4, 0.2), at=(1, 0), kind="static")
    smoke.add_source(at=(1, 0), radius=0.05, rate=100, temperature=50, fuel=100, velocity=(0, 50))
    for k in range(12):
        world.add(evil.Rectangle(0.3, 0.3), at=(0.3 + 0.05 * (k % 3), 0.3 + 0.2 * k), angle=0.3 * k)
    world.add(evil.Circle(0.2), at=(1.0, 1.8), velocity=(0, -200), bullet=True)
    world.add(evil.Rectangle(1.8, 0.1), at=(1, 1.9), kind="kinematic", velocity=(0, -0.5))
    for _ in range(180):
        world.step()
    assert np.isfinite(np.asarray(smoke.velocity)).all()
    assert np.abs(np.asarray(smoke.velocity)).max() < 2000
    world.restore(world.snapshot())


@pytest.mark.parametrize("hand", ["written", "stirred"])
def test_what_was_done_by_hand_before_a_snapshot_is_in_it(hand: str) -> None:
    world = evil.World()
    smoke = world.add_smoke((0, 0, 2, 2), cells=16)
    velocity = np.asarray(smoke.velocity)  # from now on anybody may have written into it
    if hand == "written":
        velocity[4:9, 4:9] = (1, 2)
    else:
        smoke.stir((1, 1), radius=0.5, velocity=(1, 2))
        assert velocity[8, 8, 1] > 1, "it is seen at once"
    twin = evil.World.of(world.snapshot())
    for _ in range(3):
        world.step()
        twin.step()
    assert twin.checksum() == world.checksum()
    assert np.abs(velocity).max() > 0.3


def test_a_smoke_that_is_refused_leaves_the_world_as_it_was() -> None:
    world = evil.World()
    world.add_smoke((0, 0, 2, 2), cells=8)
    before = world.checksum()
    with pytest.raises(evil.ArgumentError, match="buoyancy"):
        world.add_smoke((0, 0, 2, 2), cells=8, buoyancy=1e9)
    assert world.checksum() == before
