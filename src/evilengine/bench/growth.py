"""How a step's time grows with the number of bodies: 1000 to 64,000, heaped up and far apart."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from evilengine.bench.physics import Numbers, Ours, Tell
from evilengine.bench.scene import Scene, find
from evilengine.bench.scenes import heap
from evilengine.bench.timing import take_turns
from evilengine.world.world import World

SIZES = tuple(1000 * 2**k for k in range(7))
WARM, STEPS = 60, 20
DEEP = 8
"""Stones above each other in the heap, whatever its size: it settles within a second, and only its width grows."""


def heaped(world: World, size: int) -> None:
    heap(world, size, size // DEEP)


WAYS: dict[str, Scene] = {
    "pile": replace(find("pile"), fill=heaped),
    "sparse": find("sparse"),
}


def growth(name: str, tell: Tell, threads: int = 1) -> Iterator[Numbers]:
    """Milliseconds of a step and nanoseconds a body, size by size."""
    scene = WAYS[name]
    for size in SIZES:
        tell(f"growth: {name} of {size}")
        ours = Ours(scene, size, 4, threads)
        times = take_turns([ours], STEPS, WARM)[ours.name]
        yield {
            "scene": name,
            "bodies": size,
            "contacts": len(ours.staged.world.contacts.active),
            "min": times.least,
            "ns_a_body": 1e6 * times.least / size,
        }
