"""Water gets under what lies on the ground: films, where the grid sees no way in."""

from __future__ import annotations

import numpy as np
import pytest
from tank import pool, run

import evilengine as evil

LYING = {
    "box": (evil.Rectangle(1, 1), 0.5),
    "plank": (evil.Rectangle(3, 0.5), 0.25),
    "ball": (evil.Circle(0.5), 0.5),
    "capsule": (evil.Capsule((-0.5, 0), (0.5, 0), 0.3), 0.3),
    "hexagon": (evil.Polygon([(0.3, -0.5), (0.6, 0), (0.3, 0.5), (-0.3, 0.5), (-0.6, 0), (-0.3, -0.5)]), 0.5),
}


@pytest.mark.parametrize("rim", [0.0, 0.5])
@pytest.mark.parametrize("name", LYING)
def test_what_is_light_rises_from_the_floor_of_a_pool_that_is_filled(name: str, rim: float) -> None:
    world, water = pool(rim)
    shape, up = LYING[name]
    body = world.add(shape, at=(0.5, -3 + up), density=0.4)
    run(world, 1)
    water.fill((-4, -3, 4, 0))
    run(world, 12)  # what is wide takes its time: water has to get under it
    assert body.position[1] > -0.6


def test_what_is_heavy_stays_there() -> None:
    world, water = pool()
    body = world.add(evil.Rectangle(1, 1), at=(0.5, -2.5), density=1.5)
    water.fill((-4, -3, 4, 0))
    run(world, 5)
    assert body.position == pytest.approx((0.5, -2.5), abs=0.05)


@pytest.mark.parametrize("side", [-1, 1])
def test_a_ball_in_a_corner_rises(side: float) -> None:
    world, water = pool()
    body = world.add(evil.Circle(0.5), at=(3.5 * side, -2.5), density=0.4)
    water.fill((-4, -3, 4, 0))
    run(world, 8)
    assert body.position[1] > -0.6


def test_a_crate_in_shallow_water_stays_until_there_is_enough_to_float_it() -> None:
    world, water = pool()
    body = world.add(evil.Rectangle(1, 1), at=(0.5, -2.5), density=0.6)
    water.fill((-4, -3, 4, -2.6))
    run(world, 3)
    assert body.position == pytest.approx((0.5, -2.5), abs=0.05)
    water.fill((-4, -2.5, 4, -0.5))
    run(world, 6)
    assert body.position[1] > -1.5


def test_a_piston_rests_on_water_that_cannot_leave() -> None:
    world, water = pool()
    piston = world.add(evil.Rectangle(7.96, 1), at=(0, 0), density=3)
    water.fill((-4, -3, 4, -1))
    run(world, 6)
    above = np.asarray(water.positions)[:, 1] > piston.position[1]
    assert piston.position[1] - 0.5 == pytest.approx(-1, abs=0.2)
    assert not above.any()


def test_a_hull_that_is_closed_floats_on_the_air_in_it() -> None:
    world, water = pool()
    hull = evil.Polygon(
        [(-1, -0.5), (1, -0.5), (1, 0.5), (-1, 0.5)], holes=[[(-0.8, -0.3), (0.8, -0.3), (0.8, 0.3), (-0.8, 0.3)]]
    )
    boat = world.add(hull, at=(0, -2), density=1.2)
    water.fill((-4, -3, 4, 0))
    run(world, 6)
    assert boat.position[1] > -0.7


def test_films_have_the_same_bits_with_any_threads_and_after_a_restore() -> None:
    def sums(threads: int, restored: bool) -> int:
        world, water = pool(threads=threads)
        for k in range(8):
            world.add(evil.Rectangle(0.6, 0.6), at=(-3 + 0.7 * k, -2.7), density=0.5)
            world.add(evil.Circle(0.3), at=(-3 + 0.7 * k, -2.1), density=0.3)
        water.fill((-4, -3, 4, 0))
        run(world, 1)
        if restored:
            world.restore(world.snapshot())
        run(world, 1)
        return world.checksum()

    assert sums(1, False) == sums(2, False) == sums(1, True)
