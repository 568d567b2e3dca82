"""What lies on the floor of a pool, or against its wall, is not sucked fast: liquid presses in the gap too."""

from __future__ import annotations

from typing import Any

import pytest

import evilengine as evil

SHAPES = [evil.Rectangle(1.1, 0.8), evil.Circle(0.4), evil.Capsule((-0.3, 0), (0.3, 0), 0.4)]


def pool(world: evil.World, surface: float = 1.0) -> evil.Water:
    """Ten metres wide, its floor at -3: a body, as are its walls."""
    world.add(evil.Rectangle(14, 1), at=(0, -3.5), kind="static")
    for side in (-1, 1):
        world.add(evil.Rectangle(1, 8), at=(5.5 * side, 0), kind="static")
    water = world.add_water((-5, -3, 5, 3), particle_size=0.1)
    water.fill((-5, -3, 5, surface))
    return water


@pytest.mark.parametrize("gap", [0.0, 0.04, 0.1, 0.2])
@pytest.mark.parametrize("shape", SHAPES, ids=["box", "ball", "capsule"])
def test_a_light_body_rises_from_the_floor(shape: Any, gap: float) -> None:
    world = evil.World()
    body = world.add(shape, at=(0, -2.6 + gap), density=0.25)
    pool(world)
    for _ in range(150):
        world.step()
    assert body.position.y > 0.5


def test_a_light_body_rises_along_a_wall_that_it_touches() -> None:
    world = evil.World()
    body = world.add(evil.Rectangle(1, 1), at=(4.5, -1.5), density=0.3, friction=1)
    pool(world)
    for _ in range(150):
        world.step()
    assert body.position.y > 0.4


def test_the_floor_carries_what_the_water_does_not() -> None:
    world = evil.World()
    block = world.add(evil.Rectangle(1, 1), at=(0, -2.5), density=2.0)
    pool(world)
    for _ in range(120):
        world.step()
    assert block.position.y == pytest.approx(-2.5, abs=0.02)
    carried = 60 * sum(each.impulse for each in world.contacts.active if block in (each.a, each.b))
    assert carried == pytest.approx(9.81 * (2 - 1), rel=0.25)
