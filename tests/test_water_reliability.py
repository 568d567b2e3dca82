"""Water under ill treatment: nothing blows up, leaks, or leaves as not-a-number."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import pytest

import evilengine as evil

DT = 1 / 60


def tank(wide: float, high: float, size: float = 0.05) -> tuple[evil.World, evil.Water]:
    world = evil.World(gravity=(0, -10))
    return world, world.add_water((0, 0, wide, high), particle_size=size)


def watch(world: evil.World, water: evil.Water, steps: int, before: Callable[[int], None] = lambda k: None) -> float:
    """Steps on; all stays in its box. The fastest that a particle was."""
    fastest, count = 0.0, water.count
    left, bottom, right, top = water.area
    for k in range(steps):
        before(k)
        world.step(DT)
        places, speeds = np.asarray(water.positions), np.asarray(water.velocities)
        assert np.isfinite(speeds).all()
        assert (places >= (left, bottom)).all()
        assert (places <= (right, top)).all()
        fastest = max(fastest, float(np.hypot(*speeds.T).max()))
    assert water.count == count
    assert all(math.isfinite(body.position.y) for body in world.bodies)
    return fastest


def test_a_body_that_is_far_faster_than_a_cell_a_step() -> None:
    world, water = tank(6, 4)
    ram = world.add(evil.Circle(0.3), at=(-1, 0.8), kind="kinematic", velocity=(60, 0))
    water.fill((0, 0, 6, 1.5))

    def again(k: int) -> None:
        if k % 20 == 0:
            ram.position = (-1, 0.8)

    assert watch(world, water, 80, again) < 150


def test_a_shot_into_water_is_slowed() -> None:
    world, water = tank(6, 4)
    world.add(evil.Rectangle(8, 1), at=(3, -0.5), kind="static")
    ball = world.add(evil.Circle(0.3), at=(3, 3.5), velocity=(0, -100), density=2, bullet=True)
    water.fill((0, 0, 6, 1.5))
    watch(world, water, 60)
    assert ball.velocity.length < 20


def test_a_sealed_box_filled_to_the_brim_is_silent() -> None:
    world, water = tank(2, 2)
    water.fill((0, 0, 2, 2))
    assert watch(world, water, 60) < 0.01


def test_a_sealed_box_filled_over_the_brim() -> None:
    world, water = tank(2, 2)
    water.fill((0, 0, 2, 2))
    world.add(evil.Circle(0.5), at=(1, 1), density=0.5)  # where water was
    assert watch(world, water, 120) < 50


def test_a_sealed_box_that_gets_smaller() -> None:
    world, water = tank(2, 2)
    water.fill((0, 0, 2, 2))
    world.add(evil.Rectangle(3, 1), at=(1, 2.6), kind="kinematic", velocity=(0, -0.3))
    assert watch(world, water, 120) < 10


@pytest.mark.parametrize("speed", [0.3, 1, 3])
def test_a_body_in_a_sealed_box_that_is_squeezed(speed: float) -> None:
    world, water = tank(2, 2)
    water.fill((0, 0, 2, 2))
    world.add(evil.Circle(0.5), at=(1, 1), density=0.5)  # where water was, too
    world.add(evil.Rectangle(3, 1), at=(1, 2.6), kind="kinematic", velocity=(0, -speed))
    assert watch(world, water, 120) < 50  # it shot off at thousands of metres a second


def test_bodies_jammed_in_a_corner() -> None:
    world, water = tank(3, 3)
    for shape, at in ((evil.Rectangle(5, 1), (1.5, -0.5)), (evil.Rectangle(1, 4), (-0.5, 1.5))):
        world.add(shape, at=at, kind="static")
    for k in range(24):
        shape = evil.Rectangle(0.4, 0.3) if k % 2 else evil.Circle(0.2)
        world.add(shape, at=(0.3 + 0.3 * (k % 4), 0.3 + 0.35 * (k // 4)), density=0.3 + 0.3 * (k % 5))
    world.add(evil.Rectangle(1, 4), at=(2.6, 1.5), kind="kinematic", velocity=(-0.8, 0))
    water.fill((0, 0, 3, 1.5))
    assert watch(world, water, 120) < 80


@pytest.mark.parametrize("cells", [2, 3, 5, 17])
def test_small_boxes(cells: int) -> None:
    world, water = tank(0.2 * cells, 0.2 * cells, 0.1)
    water.fill((0, 0, 0.2 * cells, 0.1 * cells))
    assert watch(world, water, 60) < 2


def test_a_large_box_costs_what_lies_in_it() -> None:
    world, water = tank(102.4, 102.4)
    assert water.cells == (1024, 1024)
    water.fill((40, 0, 44, 2))
    water.fill((50, 90, 51, 91))
    assert watch(world, water, 30) < 12


def test_water_that_a_body_buries_comes_back() -> None:
    world, water = tank(2, 2)
    water.fill((0, 0, 2, 1))
    lid = world.add(evil.Rectangle(5, 5), at=(1, 1), kind="static")
    watch(world, water, 30)
    lid.destroy()
    watch(world, water, 30)


def test_what_is_written_from_outside_may_be_anything() -> None:
    world, water = tank(2, 2)
    water.fill((0, 0, 2, 1))
    world.add(evil.Circle(0.3), at=(1, 1), density=0.5)

    def spoil(k: int) -> None:
        places, speeds = np.asarray(water.positions), np.asarray(water.velocities)
        places[k % 50] = math.nan
        places[60] = 1e30
        speeds[3] = math.inf
        speeds[4] = -1e30

    watch(world, water, 30, spoil)


@pytest.mark.parametrize("density", [1e-4, 1e4])
def test_bodies_far_lighter_and_far_heavier(density: float) -> None:
    world, water = tank(3, 2)
    world.add(evil.Rectangle(5, 1), at=(1.5, -0.5), kind="static")
    body = world.add(evil.Circle(0.3), at=(1.5, 0.8), density=density)
    water.fill((0, 0, 3, 1))
    watch(world, water, 90)
    assert (body.position.y < 0.4) == (density > 1)


@pytest.mark.parametrize("dt", [1e-4, 0.25, 1.0])
def test_short_and_long_steps(dt: float) -> None:
    world, water = tank(2, 2)
    world.add(evil.Circle(0.2), at=(1.5, 0.5), density=0.5)
    water.fill((0, 0, 1, 1))
    for _ in range(40):
        world.step(dt)
    assert np.isfinite(np.asarray(water.positions)).all()


def test_open_sides_let_it_go() -> None:
    world = evil.World(gravity=(0, -10))
    water = world.add_water((0, 0, 2, 2), particle_size=0.05, open_sides=("left", "right", "bottom"))
    water.fill((0.5, 0.5, 1.5, 1.5))
    for _ in range(90):
        world.step(DT)
    assert water.count == 0


def test_a_sleeping_body_wakes_when_water_comes() -> None:
    world, water = tank(6, 3)
    world.add(evil.Rectangle(8, 1), at=(3, -0.5), kind="static")
    world.add(evil.Rectangle(1, 6), at=(6.5, 3), kind="static")
    crate = world.add(evil.Rectangle(0.5, 0.5), at=(5, 0.25), density=0.3)
    for _ in range(90):
        world.step(DT)
    assert not crate.awake
    water.fill((0, 0, 2, 2))
    for _ in range(180):  # the first wave has gone by
        world.step(DT)
    assert crate.awake
    assert crate.position.y > 0.35


def test_a_heap_of_light_bodies_on_water_presses_none_of_it_away() -> None:
    world, water = tank(7, 6)
    for shape, at in (
        (evil.Rectangle(9, 1), (3.5, -0.5)),
        (evil.Rectangle(1, 10), (-0.5, 4)),
        (evil.Rectangle(1, 10), (7.5, 4)),
    ):
        world.add(shape, at=at, kind="static")
    for k in range(100):
        shape = evil.Rectangle(0.3, 0.3) if k % 2 else evil.Circle(0.15)
        world.add(shape, at=(0.3 + 0.345 * (k % 19), 2.1 + 0.35 * (k // 19)), density=0.3 + 0.1 * (k % 6))
    water.fill((0, 0, 7, 1.8))
    watch(world, water, 150)
    assert np.asarray(water.positions)[:, 1].mean() > 0.85  # it fills 1.8 m
