"""Water: liquid of particles in a box."""

from __future__ import annotations

import numpy as np

import evilengine as evil

DT = 1 / 60


def test_liquid_falls_stays_in_its_box_and_out_of_bodies() -> None:
    world = evil.World(gravity=(0, -10))
    water = world.add_water((0, 0, 4, 3), particle_size=0.1)
    rock = world.add(evil.Rectangle(1, 0.5), at=(2, 0.6), kind="static")
    assert water.fill((1, 1.5, 3, 2.5)) == 200
    before = np.array(water.positions)
    for _ in range(120):
        world.step(DT)
    after = np.array(water.positions)
    assert after[:, 1].mean() < before[:, 1].mean() - 0.3
    assert (after >= 0).all()
    assert (after <= (4, 3)).all()
    inside = (abs(after - (rock.position.x, rock.position.y)) < (0.45, 0.2)).all(axis=1)
    assert not inside.any()


def test_nothing_is_filled_twice_nor_where_a_body_is() -> None:
    world = evil.World()
    water = world.add_water((0, 0, 2, 2), particle_size=0.1)
    world.add(evil.Rectangle(0.8, 0.8), at=(1, 1), kind="static")
    assert water.fill((0, 0, 2, 2)) == 400 - 64
    assert water.fill((0, 0, 2, 2)) == 0
