"""Worlds with a character in them, for the tests."""

from __future__ import annotations

import math
from collections.abc import Callable

import evilengine as evil

STEP = 1 / 60
FEET = 0.75  # metres from a character's origin down


def flat(**options: object) -> tuple[evil.World, evil.Character]:
    """A world with a floor, and a character that stands on it at x = 0."""
    world = evil.World()
    world.add(evil.Rectangle(400, 1), at=(0, -0.5), kind="static")
    hero = world.add_character(at=(0, FEET + 0.005), **options)
    go(world, 5)
    assert hero.grounded
    return world, hero


def go(world: evil.World, steps: int, each: Callable[[], object] = lambda: None) -> None:
    for _ in range(steps):
        each()
        world.step(STEP)


def heights(world: evil.World, hero: evil.Character, steps: int) -> list[float]:
    track = []
    go(world, steps, lambda: track.append(hero.position.y))
    return track


def slope(degrees: float) -> evil.Polygon:
    """A ramp that starts at the origin and rises to the right, 20 m long."""
    end = evil.Vec2(20, 0).turned(math.radians(degrees))
    return evil.Polygon([(0, 0), (end.x, 0), end]) if degrees > 0 else evil.Polygon([(0, 0), end, (0, end.y)])
