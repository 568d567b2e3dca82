"""Liquids: how heavy, how thick, how taut they are."""

from __future__ import annotations

import numpy as np
import pytest

import evilengine as evil
from evilengine import _core

DT = 1 / 60


def run(world: evil.World, seconds: float) -> None:
    for _ in range(round(seconds / DT)):
        world.step(DT)


def heights(water: evil.Water) -> tuple[float, float]:
    y, kinds = np.asarray(water.positions)[:, 1], np.asarray(water.kinds).reshape(-1)
    return float(y[kinds == 0].mean()), float(y[kinds == 1].mean())


def test_liquids_of_two_densities_separate() -> None:
    world = evil.World(gravity=(0, -10))
    water = world.add_water((0, 0, 3, 3), particle_size=0.05)
    oil = water.add_liquid(density=0.5)
    for i in range(15):  # a chess board of both
        for j in range(10):
            area = (i * 0.2, j * 0.2, i * 0.2 + 0.2, j * 0.2 + 0.2)
            water.fill(area, liquid=oil if (i + j) % 2 else None)
    heavy, light = heights(water)
    assert abs(heavy - light) < 0.05
    run(world, 10)
    heavy, light = heights(water)
    assert light - heavy > 0.8  # of 1 when none is left in the other
    assert water.count == 2400


def test_what_lies_rightly_stays_so() -> None:
    world = evil.World(gravity=(0, -10))
    water = world.add_water((0, 0, 3, 2), particle_size=0.05)
    oil = water.add_liquid(density=0.2)
    water.fill((0, 0, 3, 0.7))
    water.fill((0, 0.7, 3, 1.4), liquid=oil)
    before = heights(water)
    run(world, 3)
    assert heights(water) == pytest.approx(before, abs=0.01)
    assert abs(np.asarray(water.velocities)).max() < 0.02


def test_a_ball_floats_between_two_liquids() -> None:
    world = evil.World(gravity=(0, -10))
    water = world.add_water((0, 0, 3, 3), particle_size=0.05)
    oil = water.add_liquid(density=0.5)
    ball = world.add(evil.Circle(0.3), at=(1.5, 1), density=0.75)
    water.fill((0, 0, 3, 1))
    water.fill((0, 1, 3, 2), liquid=oil)
    run(world, 6)
    assert ball.position.y == pytest.approx(1.0, abs=0.12)


@pytest.mark.parametrize(("viscosity", "least", "most"), [(0.0, 3.9, 4.0), (1.0, 2.5, 3.5), (20.0, 1.0, 1.8)])
def test_a_column_of_what_is_thicker_spreads_slower(viscosity: float, least: float, most: float) -> None:
    world = evil.World(gravity=(0, -10))
    water = world.add_water((0, 0, 4, 2.4), particle_size=0.05, viscosity=viscosity)
    water.fill((1.5, 0, 2.5, 1.5))
    run(world, 1)
    width = float(np.ptp(np.asarray(water.positions)[:, 0]))
    assert least < width < most


def test_a_thick_liquid_drags_a_body_along() -> None:
    speeds = []
    for viscosity in (0.0, 0.5):
        world = evil.World(gravity=(0, 0))
        water = world.add_water((0, 0, 6, 3), particle_size=0.05, viscosity=viscosity, open_sides="right")
        plate = world.add(evil.Rectangle(1, 0.05), at=(2, 1.5), density=1)
        water.fill((0, 0.5, 4, 2.5), velocity=(1, 0))
        run(world, 0.5)
        speeds.append(plate.velocity.x)
    assert speeds[1] > speeds[0] + 0.1
    assert speeds[1] < 1.1


def test_tension_draws_a_square_into_a_disc() -> None:
    world = evil.World(gravity=(0, 0))
    water = world.add_water((0, 0, 3, 3), particle_size=0.05, surface_tension=0.02, viscosity=0.02)
    water.fill((1, 1, 2, 2))
    run(world, 8)
    places = np.asarray(water.positions)
    far = np.hypot(*(places - places.mean(axis=0)).T)
    assert float(far.max()) == pytest.approx(1 / np.sqrt(np.pi), rel=0.1)  # a corner was at 0.71
    assert places.mean(axis=0) == pytest.approx((1.5, 1.5), abs=0.02)


def busy(threads: int = 1, instructions: str | None = None) -> tuple[evil.World, evil.Water]:
    world = evil.World(gravity=(0, -10), threads=threads)
    if instructions is not None:
        world._core.instruction_set = instructions
    water = world.add_water((0, 0, 5, 3), particle_size=0.05, surface_tension=0.01, open_sides="top")
    oil = water.add_liquid(density=0.6, viscosity=0.05)
    for k in range(9):
        shape = evil.Rectangle(0.4, 0.3) if k % 2 else evil.Circle(0.2)
        world.add(shape, at=(0.5 + 0.5 * k, 2.2), density=0.2 + 0.15 * (k % 6))
    world.add(evil.Rectangle(0.1, 1.6), at=(3.3, 0.6), kind="kinematic", angular_velocity=2)
    world.add(evil.Rectangle(7, 1), at=(2.5, -0.5), kind="static")
    water.fill((0, 0, 2.5, 1.5))
    water.fill((2.5, 0, 5, 1), liquid=oil)
    return world, water


def test_all_instruction_sets_and_any_threads_give_the_same_bits() -> None:
    sums = set()
    for threads, instructions in [(1, name) for name in _core.instruction_sets()] + [(3, None)]:
        world, _ = busy(threads, instructions)
        run(world, 1)
        sums.add(world.checksum())
    assert len(sums) == 1


def test_a_restored_water_goes_on_with_the_same_bits() -> None:
    world, _ = busy()
    run(world, 1)
    saved = world.snapshot()
    fresh = evil.World()
    fresh.restore(saved)
    for _ in range(90):
        world.step(DT)
        fresh.step(DT)
        assert world.checksum() == fresh.checksum()
    world.restore(saved)  # what a water found out on its way is forgotten
    run(world, 1.5)
    assert world.checksum() == fresh.checksum()


@pytest.mark.parametrize("light", [1e-38, 1e-6])
def test_a_liquid_that_weighs_next_to_nothing_beside_the_other(light: float) -> None:
    world = evil.World(gravity=(0, -10))
    water = world.add_water((0, 0, 2, 2), particle_size=0.05, density=light)
    heavy = water.add_liquid(density=1e6)
    water.fill((0, 0, 2, 0.5))
    water.fill((0, 0.5, 2, 1), liquid=heavy)
    for _ in range(60):
        world.step(1 / 60)
    assert abs(np.asarray(water.velocities)).max() < 20


@pytest.mark.parametrize("viscosity", [10, 100, 1e4])
def test_a_ball_in_what_is_very_thick_is_not_thrown_about(viscosity: float) -> None:
    world = evil.World(gravity=(0, -10))
    water = world.add_water((0, 0, 3, 2), particle_size=0.05, viscosity=viscosity)
    ball = world.add(evil.Circle(0.2), at=(0.8, 1.5), density=0.5)
    water.fill((0.3, 0.3, 1.3, 1.3))
    fastest = 0.0
    for _ in range(120):
        world.step(DT)
        fastest = max(fastest, ball.velocity.length, float(abs(np.asarray(water.velocities)).max()))
    assert fastest < 2.5  # it falls less than 0.3 m freely; the two threw each other about at up to 25 m/s


def test_a_spinning_ball_in_honey_and_the_honey_round_it_come_to_turn_alike() -> None:
    world = evil.World(gravity=(0, 0))
    water = world.add_water((0, 0, 2, 2), particle_size=0.05, viscosity=1)
    ball = world.add(evil.Circle(0.3), at=(1, 1), angular_velocity=10)
    water.fill((0, 0, 2, 2))
    for _ in range(6):
        world.step(DT)
    assert 0 < ball.angular_velocity < 8
    assert 0 < water.velocity_at((1, 1.4)).x * -1 < 0.4 * 10
