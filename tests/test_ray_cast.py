"""Rays at the limits: from far away, and at what has no extent."""

from __future__ import annotations

import pytest

import evilengine as evil


@pytest.mark.parametrize("shape", [evil.Circle(1), evil.Rectangle(2, 2), evil.Triangle((-1, -1), (1, -1), (0, 1))])
@pytest.mark.parametrize("far", [10.0, 1e4, 1e6])
def test_a_ray_from_far_away_meets_its_target_to_the_millimetre(shape: evil.Shape, far: float) -> None:
    world = evil.World()
    target = world.add(shape, at=(3, 0), kind="static")
    hit = world.ray_cast((3, far), (3, -far))
    assert hit is not None
    assert hit.body is target
    assert hit.point == pytest.approx((3, 1), abs=1e-3)
    assert hit.normal.length == pytest.approx(1)
    assert hit.normal.y > 0


def test_a_particle_has_no_extent_for_a_ray_to_meet() -> None:
    world = evil.World()
    world.add(evil.Particle(mass=1), at=(2, 0))
    assert world.ray_cast((0, 0), (4, 0)) is None


def test_a_ray_from_beyond_the_edge_of_the_world_is_refused() -> None:
    world = evil.World()
    with pytest.raises(evil.ArgumentError, match=r"World.ray_cast: start=\(0, 1e\+30\) must be within"):
        world.ray_cast((0, 1e30), (0, 0))
