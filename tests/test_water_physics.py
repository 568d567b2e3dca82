"""The water against physics: it keeps its volume, lies flat, carries what is lighter."""

from __future__ import annotations

import numpy as np
import pytest

import evilengine as evil

DT = 1 / 60
G = 10.0


def tank(wide: float, high: float, level: float, size: float = 0.05) -> tuple[evil.World, evil.Water]:
    world = evil.World(gravity=(0, -G))
    water = world.add_water((0, 0, wide, high), particle_size=size)
    water.fill((0, 0, wide, level))
    return world, water


def run(world: evil.World, seconds: float) -> None:
    for _ in range(round(seconds / DT)):
        world.step(DT)


def energy(water: evil.Water) -> float:
    """Joules a kilogram, above that of all of it on the floor."""
    places, speeds = np.asarray(water.positions, dtype=float), np.asarray(water.velocities, dtype=float)
    return float((speeds**2).sum(axis=1).mean() / 2 + G * places[:, 1].mean())


def test_water_at_rest_stays_flat_and_silent() -> None:
    world, water = tank(4, 2, 1)
    before = np.array(water.positions)
    run(world, 5)
    assert abs(np.asarray(water.velocities)).max() < 1e-3
    assert abs(np.sort(np.asarray(water.positions)[:, 1]) - np.sort(before[:, 1])).max() < 0.01


def test_a_breaking_dam_keeps_its_volume_and_gains_no_energy() -> None:
    world = evil.World(gravity=(0, -G))
    water = world.add_water((0, 0, 8, 5), particle_size=0.05)
    assert water.fill((0, 0, 3, 3)) == 3600
    last, below = energy(water), []
    for second in range(20):
        run(world, 1)
        now = energy(water)
        assert now < last * 1.01
        last = now
        # what lies deep lies as close as at rest
        if second >= 10:
            below.append((np.asarray(water.positions)[:, 1] < 0.6).sum() * 0.05**2 / (8 * 0.6))
    assert water.count == 3600
    assert np.mean(below) == pytest.approx(1, abs=0.02)
