"""The water of `evil bench fluid`: a dam that breaks over bodies, and the frame of a game that has everything in it."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any

from evilengine.bench.gas import Plan, time_of
from evilengine.bench.scene import STEP
from evilengine.bench.timing import Runner
from evilengine.world.shapes import Circle, Rectangle
from evilengine.world.world import World

Numbers = dict[str, Any]
Tell = Callable[[str], None]

COUNTS = (10_000, 20_000, 50_000)
PARTICLE = 0.1  # metres
BODIES = 12
OURS = "evil"
WARM, STEPS = 60, 120
"""From where the wave reaches the bodies to where it comes back from the other wall, at 20,000 particles."""

FRAME_CELLS, FRAME_PARTICLES, FRAME_BODIES = 256, 10_000, 200


class Dam:
    """A column of water twice as high as it is wide, let go at the end of a tank in which boxes and balls stand."""

    def __init__(self, particles: int, threads: int, name: str) -> None:
        self.name = name
        self.world = world = World((0.0, -9.81), threads=threads)
        wide = PARTICLE * math.sqrt(particles / 2)
        self.water = world.add_water((0, 0, 4 * wide, 2.5 * wide), particle_size=PARTICLE)
        self.water.fill((0, 0, wide, 2 * wide))
        world.add(Rectangle(4 * wide, 1), at=(2 * wide, -0.5), kind="static")
        world.add(Rectangle(0.2 * wide, 0.4 * wide), at=(2.2 * wide, 0.2 * wide), kind="static")
        for k in range(BODIES):
            side = (0.08 + 0.02 * (k % 3)) * wide
            shape = Circle(0.5 * side) if k % 2 else Rectangle(side, side)
            world.add(shape, at=((1.3 + 0.15 * k) * wide, 0.8 * wide), density=(0.3, 0.6, 2.0)[k % 3])

    def prepare(self) -> None: ...

    def step(self) -> None:
        self.world.step(STEP)


class GameFrame:
    """Smoke, water and a heap of bodies in one world."""

    name = OURS

    def __init__(self, threads: int = 1) -> None:
        self.world = world = World((0.0, -9.81), threads=threads)
        smoke = world.add_smoke((0, 0, 8, 8), cells=FRAME_CELLS)
        smoke.add_source(at=(4, 0.8), radius=0.5, rate=4, temperature=1)
        wide = PARTICLE * math.sqrt(FRAME_PARTICLES / 2)
        self.water = world.add_water((10, 0, 10 + 3 * wide, 1.5 * wide), particle_size=PARTICLE)
        self.water.fill((10, 0, 10 + 2 * wide, wide))
        world.add(Rectangle(60, 1), at=(10, -0.5), kind="static")
        for k in range(FRAME_BODIES):  # some in the smoke, some into the water, most on a heap
            x = (2.5, 13.0, -5.0, -8.0)[k % 4] + 0.5 * (k // 4 % 5)
            world.add(Rectangle(0.4, 0.4) if k % 2 else Circle(0.2), at=(x, 4 + 0.5 * (k // 20)), density=0.5)

    def prepare(self) -> None: ...

    def step(self) -> None:
        self.world.step(STEP)


def measure(counts: Sequence[int], plan: Plan, tell: Tell) -> list[Numbers]:
    """A row for each number of particles."""
    rows = []
    for count in counts:
        tell(f"water of {count} particles")
        first, *more = plan.threads
        dams = [Dam(count, first, OURS), *(Dam(count, n, f"{OURS}, {n} threads") for n in more)]
        times = plan.take_turns(dams, STEPS, WARM)
        engines = {
            name: {"min": one.least, "median": one.median, "times_ours": 1.0 / times[OURS].ratio(one)}
            for name, one in times.items()
        }
        rows.append({"particles": dams[0].water.count, "bodies": BODIES, "engines": engines})
    return rows


def measure_frame(plan: Plan, tell: Tell) -> Numbers:
    """Steps of a game that has everything, on one thread."""
    tell("a frame of a game: smoke, water and bodies")
    frame = GameFrame()
    runners: list[Runner] = [frame]
    times = plan.take_turns(runners, STEPS, WARM)[OURS]
    return {
        "cells": FRAME_CELLS,
        "particles": frame.water.count,
        "bodies": FRAME_BODIES,
        "min": times.least,
        "median": times.median,
    }


def table_of(rows: Sequence[Numbers]) -> str:
    """A number of particles a line."""
    from evilengine.bench.report import table

    names = list(rows[0]["engines"])
    lines = [["particles", *names, "ns a particle"]]
    for row in rows:
        mine = row["engines"][OURS]
        lines.append(
            [
                f"{row['particles']:,}",
                *(time_of(row["engines"].get(name), first=name == OURS) for name in names),
                f"{1e6 * mine['median'] / row['particles']:.0f}",
            ]
        )
    said = f"ms a step of water, least / median (and times one thread's), a dam that breaks over {BODIES} bodies"
    return f"{said}\n{table(lines)}"


def said_of(frame: Numbers) -> str:
    """The frame of a game in a line."""
    what = f"{frame['cells']} x {frame['cells']} cells of smoke, {frame['particles']:,} particles of water"
    times = f"{frame['min']:.2f} / {frame['median']:.2f}"
    return f"a game's step with {what} and {frame['bodies']} bodies, ms on one thread, least / median: {times}"
