"""A tank for water: solid floor and walls, as tests of what lies and swims in it want."""

from __future__ import annotations

import evilengine as evil


def pool(rim: float = 0.0, threads: int = 1) -> tuple[evil.World, evil.Water]:
    """A tank of 8 m by 6 m; its walls stand `rim` metres inside the water's area."""
    world = evil.World(threads=threads)
    water = world.add_water((-4 - rim, -3 - rim, 4 + rim, 3), particle_size=0.1)
    world.add(evil.Rectangle(10, 1), at=(0, -3.5), kind="static")
    for x in (-4.5, 4.5):
        world.add(evil.Rectangle(1, 10), at=(x, 0), kind="static")
    return world, water


def run(world: evil.World, seconds: float) -> None:
    for _ in range(round(60 * seconds)):
        world.step()
