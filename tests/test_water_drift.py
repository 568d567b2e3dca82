"""Bodies that the water's cells are too large to see float, sink and drift all the same."""

from __future__ import annotations

import numpy as np
import pytest
from tank import pool, run

import evilengine as evil

SMALL = [
    evil.Circle(0.03),
    evil.Circle(0.07),
    evil.Circle(0.13),
    evil.Rectangle(0.2, 0.1),
    evil.Polygon([(0, 0), (0.2, 0), (0.1, 0.2)]),
]


@pytest.mark.parametrize("shape", SMALL)
def test_corks_rise_and_pebbles_sink(shape: object) -> None:
    world, water = pool()
    water.fill((-4, -3, 4, 0))
    corks = [world.add(shape, at=(-3 + 0.77 * k, -1.5), density=0.4) for k in range(8)]
    pebbles = [world.add(shape, at=(-2.7 + 0.77 * k, -1), density=2.5) for k in range(8)]
    run(world, 6)
    assert all(-0.25 < cork.position[1] < 0.2 for cork in corks)
    assert all(pebble.position[1] < -2.7 for pebble in pebbles)


def test_one_as_dense_as_water_stays_where_it_is() -> None:
    world, water = pool()
    water.fill((-4, -3, 4, 0))
    body = world.add(evil.Circle(0.06), at=(0, -1.5), density=1)
    run(world, 3)
    assert body.position == pytest.approx((0, -1.5), abs=0.3)


def test_one_that_sleeps_on_the_floor_wakes_when_water_comes() -> None:
    world, water = pool()
    cork = world.add(evil.Circle(0.06), at=(2, -2.9), density=0.3)
    run(world, 3)
    assert not cork.awake
    water.fill((-4, -3, -2, 2))
    run(world, 8)
    assert cork.position[1] > -2.4


def test_a_stream_takes_it_along_and_loses_what_it_gives() -> None:
    world = evil.World(gravity=(0, 0))
    water = world.add_water((-4, -3, 4, 3), particle_size=0.1)
    water.fill((-2, -1, 2, 1), velocity=(1, 0))
    body = world.add(evil.Circle(0.08), at=(0, 0.03), density=3)
    before = water.count * 0.01
    run(world, 1.5)
    after = float(np.asarray(water.velocities)[:, 0].sum()) * 0.01 + body.mass * body.velocity[0]
    assert body.velocity[0] > 0.1
    assert after == pytest.approx(before, rel=0.03)
