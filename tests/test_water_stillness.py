"""Still water stays still whatever stands in it, and lifts a body the same wherever it lies between the cells."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import evilengine as evil

BOX, BALL = evil.Rectangle(1, 1), evil.Circle(0.5)


def pool() -> tuple[evil.World, evil.Water]:
    """Ten metres wide, four deep, cells of 0.2 m; floor and walls are bodies."""
    world = evil.World()
    world.add(evil.Rectangle(14, 1), at=(0, -3.5), kind="static")
    for x in (-5.5, 5.5):
        world.add(evil.Rectangle(1, 8), at=(x, 0), kind="static")
    return world, world.add_water((-5, -3, 5, 3), particle_size=0.1)


@pytest.mark.parametrize(
    ("shape", "at", "angle"),
    [
        (BOX, (4.5, -1.5), 0.0),  # along a wall, on the lines between cells
        (BOX, (4.5, -1.43), 0.0),
        (BOX, (4.43, -1.43), 0.0),  # less than a cell from it
        (BOX, (4.4, -1.43), 0.3),
        (BOX, (0.04, -2.5), 0.0),  # on the floor
        (BOX, (0.04, -2.4), 0.0),
        (BOX, (4.5, -2.5), 0.0),  # in a corner
        (BALL, (4.5, -1.43), 0.0),
    ],
)
@pytest.mark.parametrize("kind", ["static", "dynamic"])
def test_still_water_round_what_stands_close_to_a_wall(shape: Any, at: Any, angle: float, kind: str) -> None:
    world, water = pool()
    body = world.add(shape, at=at, angle=angle, kind=kind, density=2)
    if kind == "dynamic":  # held where it is: then the water presses on it, too
        anchor = world.add(evil.Circle(0.05), at=at, kind="static", sensor=True)
        world.add_joint(evil.joints.Weld(body, anchor))
    water.fill((-5, -3, 5, 1))
    for _ in range(150):
        world.step()
    assert abs(np.asarray(water.velocities)).max() < 0.03


def lift(shape: Any, area: float, aside: float) -> float:
    """What a held body loses of its weight, as a share of what it displaces; cells of 0.1 m."""
    world = evil.World(gravity=(0, -10))
    water = world.add_water((0, 0, 4, 3), particle_size=0.05)
    place = (2 + 0.7 * aside, 1 + aside)
    body = world.add(shape, at=place, density=0.5)
    anchor = world.add(evil.Circle(0.05), at=place, kind="static", sensor=True)
    joint = world.add_joint(evil.joints.Weld(body, anchor))
    water.fill((0, 0, 4, 2))
    lifts = []
    for k in range(60):
        world.step(1 / 60)
        if k >= 30:
            lifts.append(joint.force.y + 10 * body.mass)
    return float(np.mean(lifts)) / (10 * area)


@pytest.mark.parametrize(
    ("shape", "area"),
    [(evil.Circle(0.2), np.pi * 0.04), (evil.Rectangle(0.37, 0.37), 0.37**2), (evil.Rectangle(1, 0.4), 0.4)],
)
def test_a_body_of_four_cells_is_lifted_alike_wherever_it_lies_between_them(shape: Any, area: float) -> None:
    lifts = [lift(shape, area, aside) for aside in np.arange(5) * 0.02]
    assert max(lifts) - min(lifts) < 0.07  # by its pressure alone it was up to 0.26
    assert np.mean(lifts) == pytest.approx(1, abs=0.06)


@pytest.mark.parametrize(
    ("shape", "area", "submerged"),  # how much of it is under water when its centre is so far above the surface
    [
        (evil.Rectangle(1.4, 0.6), 0.84, lambda up: 1.4 * (0.3 - up)),
        (evil.Triangle((-0.7, -0.3), (0.7, -0.3), (0, 0.6)), 0.63, lambda up: 0.63 - 0.7 / 0.9 * (0.6 + up) ** 2),
    ],
)
def test_what_is_light_lies_no_deeper_than_it_must(shape: Any, area: float, submerged: Any) -> None:
    world = evil.World(gravity=(0, -10))
    water = world.add_water((0, 0, 5, 3), particle_size=0.05)
    body = world.add(shape, at=(2.5, 1.6), density=0.25)
    water.fill((0, 0, 5, 1.5))
    shares = []
    for k in range(480):
        world.step(1 / 60)
        if k >= 180:
            surface = (water.volume + body.mass) / 5
            shares.append(submerged(body.position.y - surface) / body.mass)
    assert body.mass == pytest.approx(0.25 * area)
    assert np.mean(shares) == pytest.approx(1, abs=0.1)  # by its pressure alone it was 1.22, and 0.75
