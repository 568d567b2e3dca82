"""Where libFuzzer starts from: snapshots of small worlds, which the core reads as a stranger's, and a few lives."""

from __future__ import annotations

import random
from pathlib import Path

import evilengine as evil

HEAD, TAIL = 20, 8  # bytes round a snapshot's payload, which the target seals anew


def worlds() -> list[evil.World]:
    """One of each thing that a snapshot may hold."""
    empty, pile, tied = evil.World(), evil.World(), evil.World()
    for world in (pile, tied):
        world.add(evil.Rectangle(20, 1), at=(0, -0.5), kind="static")
    for n in range(4):
        pile.add(evil.Circle(0.5) if n % 2 else evil.Rectangle(1, 1), at=(0.1 * n, 0.5 + n))
    pile.add(evil.Polygon([(0, 0), (2, 0), (2, 1), (1, 0.4), (0, 1)]), at=(4, 1), tag="dented")
    a, b = tied.add(evil.Capsule((-1, 0), (1, 0), 0.3), at=(0, 3)), tied.add(evil.Particle(mass=1), at=(2, 3))
    tied.add_joint(evil.joints.Hinge(a, b, at=(1, 3), limits=(-1, 1)))
    tied.add_force(evil.Spring(to=(0, 5), stiffness=20, rest_length=1), [a])
    tied.add_force(evil.Medium((-5, 0, 5, 2), linear=3))
    for world in (pile, tied):
        for _ in range(30):
            world.step()
    return [empty, pile, tied, with_fluids()]


def with_fluids() -> evil.World:
    """Smoke over a basin into which a tap pours, with something that swims."""
    world = evil.World()
    world.add(evil.Rectangle(4, 1), at=(0, -0.5), kind="static")
    world.add(evil.Rectangle(0.4, 0.2), at=(0, 0.6), density=0.4)
    world.add_smoke((-1, 0, 1, 2), cells=(8, 8)).add_source(evil.Circle(0.2), at=(0, 0.3), rate=2, temperature=1)
    water = world.add_water((-1, 0, 1, 1), particle_size=0.1)
    water.add_liquid(density=0.8)
    water.fill((-1, 0, 1, 0.4))
    water.pour((0, 0.8), rate=0.2)
    water.drain((0.6, 0, 1, 0.1))
    for _ in range(10):
        world.step()
    return world


def write(folder: Path) -> None:
    """Put them into a folder, for libFuzzer to change."""
    for number, world in enumerate(worlds()):
        data = world.snapshot()
        (folder / f"world-{number}").write_bytes(b"\0" + data)
        (folder / f"sealed-{number}").write_bytes(b"\1" + data[HEAD:-TAIL])
    dice = random.Random(1)
    for number in range(8):
        (folder / f"life-{number}").write_bytes(b"\2" + dice.randbytes(600))
