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


def basin(wide: float, high: float, level: float, size: float = 0.05) -> tuple[evil.World, evil.Water]:
    """A tank with a floor and walls that bodies meet, too."""
    world, water = tank(wide, high, level, size)
    for shape, at in (
        (evil.Rectangle(wide + 2, 1), (wide / 2, -0.5)),
        (evil.Rectangle(1, high), (-0.5, high / 2)),
        (evil.Rectangle(1, high), (wide + 0.5, high / 2)),
    ):
        world.add(shape, at=at, kind="static")
    return world, water


def level_of(water: evil.Water, left: float, right: float) -> float:
    """Metres above the floor, between two walls, by how much there is."""
    x = np.asarray(water.positions)[:, 0]
    return float(((x > left) & (x < right)).sum()) * water.particle_size**2 / (right - left)


@pytest.mark.parametrize("density", [0.25, 0.5, 0.8])
def test_a_box_floats_upright_at_its_ideal_draft(density: float) -> None:
    side, wide = 0.6, 5.0
    world = evil.World(gravity=(0, -G))
    water = world.add_water((0, 0, wide, 3), particle_size=0.05)
    box = world.add(evil.Rectangle(1.4, side), at=(wide / 2, 1.5 + side * (0.5 - density) + 0.05), density=density)
    water.fill((0, 0, wide, 1.5))
    run(world, 4)
    drafts = []
    for _ in range(240):
        world.step(DT)
        surface = (water.count * 0.05**2 + (box.mass / 1.0)) / wide
        drafts.append(surface - (box.position.y - side / 2))
        assert abs(box.angle) < 0.2
    assert np.mean(drafts) == pytest.approx(side * density, abs=0.05)


def test_what_is_denser_sinks_to_the_floor() -> None:
    world, water = basin(4, 3, 1.5)
    stone = world.add(evil.Circle(0.25), at=(2, 1.2), density=2)
    run(world, 3)
    assert stone.position.y == pytest.approx(0.25, abs=0.03)
    assert water.count > 0


def test_a_body_held_in_deep_water_feels_its_buoyancy() -> None:
    lifts = []
    for aside in (0.0, 0.03, 0.06):  # wherever it lies between the cells
        world = evil.World(gravity=(0, -G))
        water = world.add_water((0, 0, 4, 3), particle_size=0.05)
        ball = world.add(evil.Circle(0.4), at=(2, 1 + aside), density=0.5)
        anchor = world.add(evil.Circle(0.05), at=(2, 1 + aside), kind="static", sensor=True)
        joint = world.add_joint(evil.joints.Weld(ball, anchor))
        water.fill((0, 0, 4, 2))
        run(world, 1)
        for _ in range(60):
            world.step(DT)
            lifts.append(joint.force.y + ball.mass * G)
    assert np.mean(lifts) == pytest.approx(np.pi * 0.4**2 * G, rel=0.03)


def test_two_tanks_joined_by_a_pipe_level_out() -> None:
    world = evil.World(gravity=(0, -G))
    water = world.add_water((0, 0, 4, 3), particle_size=0.05)
    world.add(evil.Rectangle(0.4, 2.6), at=(2, 1.7), kind="static")  # 0.4 m of pipe below it
    water.fill((0, 0, 1.8, 2))
    run(world, 12)
    assert level_of(water, 0, 1.8) == pytest.approx(level_of(water, 2.2, 4), abs=0.1)


def test_nothing_flows_through_a_wall() -> None:
    world = evil.World(gravity=(0, -G))
    water = world.add_water((0, 0, 4, 3), particle_size=0.05)
    world.add(evil.Rectangle(0.05, 3.2), at=(2, 1.5), angle=0.02, kind="static")  # half a cell thick
    water.fill((0, 0, 1.9, 2))
    count = water.count
    run(world, 5)
    x = np.asarray(water.positions)[:, 0]
    assert ((x < 2.1).sum(), water.count) == (count, count)


def test_a_moving_wall_pushes_all_of_it_along() -> None:
    world = evil.World(gravity=(0, -G))
    water = world.add_water((0, 0, 4, 3), particle_size=0.05)
    piston = world.add(evil.Rectangle(0.3, 3.4), at=(0.1, 1.5), kind="kinematic", velocity=(0.5, 0))
    water.fill((0, 0, 4, 0.7))
    for _ in range(240):
        world.step(DT)
        assert np.asarray(water.positions)[:, 0].min() > piston.position.x + 0.05
    assert piston.position.x == pytest.approx(2.1, abs=0.01)


def test_momentum_passes_from_water_to_a_free_body() -> None:
    world = evil.World(gravity=(0, 0))
    water = world.add_water((0, 0, 6, 3), particle_size=0.05)
    water.fill((0.5, 1, 2.5, 2), velocity=(3, 0))
    box = world.add(evil.Rectangle(0.5, 1), at=(3.2, 1.5), density=1)
    before = water.count * 0.05**2 * 3
    run(world, 0.5)
    now = float(np.asarray(water.velocities)[:, 0].sum()) * 0.05**2
    assert box.velocity.x > 0.5
    assert now + box.mass * box.velocity.x == pytest.approx(before, rel=0.1)
