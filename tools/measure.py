#!/usr/bin/env python3
"""The engine's numbers on this machine: what a call, a frame and an import cost, and how still a stack stands.

python tools/measure.py        prints one number a line
"""

from __future__ import annotations

import subprocess
import sys
import time
import timeit
from collections.abc import Callable
from importlib.resources import files

import evilengine as evil

SECONDS_A_STEP = 1 / 60


def import_ms() -> float:
    """Milliseconds of `import evilengine` in a fresh process, beyond bare Python's own start."""

    def best(code: str) -> float:
        times = []
        for _ in range(7):
            start = time.perf_counter()
            subprocess.run([sys.executable, "-c", code], check=True)
            times.append(time.perf_counter() - start)
        return min(times)

    return (best("import evilengine") - best("pass")) * 1e3


def nanoseconds(call: Callable[[], object]) -> float:
    """Nanoseconds of one call, the loop's own share taken out."""
    rounds = 200_000

    def best(function: Callable[[], object]) -> float:
        return min(timeit.repeat(function, number=rounds, repeat=5))

    return (best(call) - best(lambda: None)) / rounds * 1e9


def stack_drift() -> float:
    """Metres that the top of ten stacked boxes wanders from where it settled, over a minute."""
    world = evil.World()
    world.add(evil.Rectangle(20, 1), at=(0, -0.5), kind="static")
    boxes = [world.add(evil.Rectangle(1, 1), at=(0, 0.5 + level)) for level in range(10)]
    for _ in range(120):
        world.step(SECONDS_A_STEP)
    settled = boxes[-1].position
    furthest = 0.0
    for _ in range(60 * 60):
        world.step(SECONDS_A_STEP)
        furthest = max(furthest, (boxes[-1].position - settled).length)
    return furthest


def frame_ms() -> float:
    """Milliseconds of one step and picture of Prototype 1 at 960 x 540, software renderer; median of 120."""
    game = evil.Game("Prototype 1", size=(960, 540), headless=True, renderer="soft")
    game.load(str(files("evilengine.examples") / "prototype1.evil"))
    times = []
    for _ in range(120):
        start = time.perf_counter()
        game.step()
        game.capture()
        times.append(time.perf_counter() - start)
    return sorted(times)[len(times) // 2] * 1e3


def main() -> None:
    body = evil.World().add(evil.Circle(1))
    print(f"import evilengine                {import_ms():8.1f} ms")
    print(f"body.position                    {nanoseconds(lambda: body.position):8.0f} ns")
    print(f"body.apply_force((0, 1))         {nanoseconds(lambda: body.apply_force((0, 1))):8.0f} ns")
    print(f"a frame of Prototype 1, 960x540  {frame_ms():8.2f} ms")
    print(f"drift of ten boxes in a minute   {stack_drift() * 1e3:8.3f} mm")


if __name__ == "__main__":
    main()
