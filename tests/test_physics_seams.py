"""No ghost hits: what slides over tiles side by side does not feel where they meet."""

from __future__ import annotations

import math

import pytest

import evilengine as evil

STEP = 1 / 60


@pytest.mark.parametrize("speed", [2.0, 8.0, 20.0])
@pytest.mark.parametrize("kind", ["box", "disc", "capsule", "hexagon"])
def test_what_slides_over_tiles_is_not_held_up_by_their_edges(kind, speed):
    shape = {
        "box": evil.Rectangle(1, 1),
        "disc": evil.Circle(0.5),
        "capsule": evil.Capsule((-0.5, 0), (0.5, 0), 0.5),
        "hexagon": evil.Polygon([evil.Vec2(math.sqrt(1 / 3), 0).turned(n * math.pi / 3) for n in range(6)]),
    }[kind]
    world = evil.World()
    for n in range(-2, 90):
        world.add(evil.Rectangle(1, 1), at=(n, -0.5), kind="static", friction=0)
    body = world.add(shape, at=(0, 0.5), velocity=(speed, 0), friction=0)
    for _ in range(round(80 / speed * 60)):
        world.step(STEP)
        assert body.velocity.x == pytest.approx(speed, rel=2e-3)
        assert abs(body.velocity.y) < 0.05
        assert body.position.y == pytest.approx(0.5, abs=0.02)
