"""The smoke of `evil bench fluid`: a plume among eight posts and a ball that goes to and fro, and what a step costs."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Any, Protocol

from evilengine.bench.gas_peers import PEERS, Divergence
from evilengine.bench.scene import STEP
from evilengine.bench.timing import Runner, Times, best, take_turns
from evilengine.values.errors import DeviceError
from evilengine.world.shapes import Circle
from evilengine.world.world import World

Numbers = dict[str, Any]

SIZES = (128, 256, 512)
SIDE = 4.0  # metres of the box
FAST, HIGH, STAM = "evil fast", "evil high", "Stam in C"
RISEN = 60
"""Steps until the plume is among the posts."""
WARM, STEPS = 10, 40
BYTES_A_CELL = 2 * (16 + 2 * 4 + 4)
"""What a step reads and writes at the least: density, heat, fuel and room, two velocities and the pressure."""
COPIED = 1 << 26  # bytes: far more than caches hold


class Gas(Protocol):
    """A smoke in one engine; its step is timed, and the divergence before and after its projection can be asked for."""

    name: str

    def prepare(self) -> None: ...

    def step(self) -> None: ...

    def divergence(self) -> Divergence: ...


class Ours:
    """Nine obstacles, of which one moves; a plume rises from below."""

    def __init__(self, cells: int, quality: str, threads: int, name: str) -> None:
        self.name = name
        self.world = world = World((0.0, -9.81), threads=threads)
        self.smoke = world.add_smoke((0, 0, SIDE, SIDE), cells=cells, quality=quality)
        self.smoke.add_source(at=(0.5 * SIDE, 0.1 * SIDE), radius=0.06 * SIDE, rate=4, temperature=1)
        for k in range(8):
            world.add(Circle(0.03 * SIDE), at=((0.15 + 0.1 * k) * SIDE, (0.55 + 0.05 * (k % 3)) * SIDE), kind="static")
        self._ball = world.add(Circle(0.08 * SIDE), at=(0.5 * SIDE, 0.4 * SIDE), kind="kinematic")
        for _ in range(RISEN):
            self.prepare()
            self.step()

    def prepare(self) -> None:
        self._ball.velocity = (0.2 * SIDE * math.cos(2 * STEP * self.world.steps), 0)

    def step(self) -> None:
        self.world.step(STEP)

    def divergence(self) -> Divergence:
        self.smoke._gathering()
        self.prepare()
        self.step()
        return self.smoke._gathering()


class Stam:
    """The thesis's method in C++, in the same box without obstacles: a jet of density, a hundred sweeps a step."""

    name = STAM

    def __init__(self, cells: int) -> None:
        self.world = World((0.0, -9.81))
        self.smoke = self.world.add_smoke(
            (0, 0, SIDE, SIDE), cells=cells, method="stam", viscosity=1e-4, diffusion=1e-4, cooling=0
        )
        self.smoke.add_source(at=(0.5 * SIDE, 0.1 * SIDE), radius=0.06 * SIDE, rate=4, velocity=(0, 3))

    def prepare(self) -> None: ...

    def step(self) -> None:
        self.world.step(STEP)

    divergence = Ours.divergence


@dataclass(frozen=True, slots=True, kw_only=True)
class Plan:
    """How fluids are measured."""

    steps: int | None = None
    warm: int | None = None
    threads: Sequence[int] = (1,)
    patience: float = 10.0
    """Seconds that one is timed for at most, and that a peer may take for the steps before."""

    def take_turns(self, runners: Sequence[Runner], steps: int = STEPS, warm: int = WARM) -> dict[str, Times]:
        """All of them, step by step in turn."""
        return take_turns(
            runners, self.steps or steps, warm if self.warm is None else self.warm, patience=self.patience
        )


def measure(
    sizes: Sequence[int], plan: Plan, peers: Iterable[str], tell: Callable[[str], None]
) -> tuple[list[Numbers], list[str]]:
    """A row for each size, and who is not beside and why."""
    rows: list[Numbers] = []
    missing: dict[str, None] = {}
    speed = copy_speed()
    for cells in sizes:
        tell(f"smoke of {cells} x {cells} cells")
        runners, without = _runners(cells, plan.threads, peers)
        missing |= dict.fromkeys(without)
        times = plan.take_turns(runners)
        missing |= dict.fromkeys(f"{one.name} (too slow to wait for)" for one in runners if one.name not in times)
        rows.append(
            {
                "cells": cells,
                "floor": 1e3 * BYTES_A_CELL * cells * cells / speed,
                "engines": {one.name: _figures(one, times) for one in runners if one.name in times},
            }
        )
    return rows, list(missing)


def _runners(cells: int, threads: Sequence[int], peers: Iterable[str]) -> tuple[list[Gas], list[str]]:
    first, *more = threads
    runners: list[Gas] = [Ours(cells, "fast", first, FAST)]
    runners += [Ours(cells, "fast", n, f"{FAST}, {n} threads") for n in more]
    runners += [Ours(cells, "high", first, HIGH), Stam(cells)]
    missing = []
    for name in peers:
        try:
            runners.append(PEERS[name](cells))
        except (ImportError, DeviceError) as problem:
            missing.append(f"{name} ({problem})")
    return runners, missing


def _figures(one: Gas, times: dict[str, Times]) -> Numbers:
    before, after = one.divergence()
    mine = times[one.name]
    return {
        "min": mine.least,
        "median": mine.median,
        "times_ours": 1.0 / times[FAST].ratio(mine),
        "divergence_left": after / before if before > 0.0 else 0.0,
    }


def copy_speed() -> float:
    """Bytes a second that copying moves through this machine's memory, read and written."""
    source, target = memoryview(bytearray(COPIED)), memoryview(bytearray(COPIED))

    def copy() -> None:
        target[:] = source

    return 2 * COPIED / best(copy, 7)


def tables_of(rows: Sequence[Numbers]) -> str:
    """An engine a line, a size a column: times, then what the projection leaves of the divergence."""
    from evilengine.bench.report import table

    names = list(dict.fromkeys(name for row in rows for name in row["engines"]))
    head = ["", *(f"{row['cells']} x {row['cells']}" for row in rows)]
    times = [[name, *(time_of(row["engines"].get(name), first=name == FAST) for row in rows)] for name in names]
    floors = [f"{row['floor']:.3f} ({row['floor'] / row['engines'][FAST]['min']:.2f})" for row in rows]
    left = [[name, *(_left(row["engines"].get(name)) for row in rows)] for name in names]
    return (
        f"ms a step of smoke, least / median (and how many times as long as {FAST} takes), by cells\n"
        + table([head, *times, ["copying as much memory", *floors]])
        + "\n\ndivergence that the projection leaves, root mean square, in parts of what was there\n"
        + table([head, *left])
    )


def time_of(one: Numbers | None, *, first: bool) -> str:
    """Least and median, and how many times as long as the first one takes."""
    if one is None:
        return "-"
    times = "" if first else f" ({one['times_ours']:.2f})"
    return f"{one['min']:.2f} / {one['median']:.2f}{times}"


def _left(one: Numbers | None) -> str:
    return "-" if one is None else f"{100 * one['divergence_left']:.2f}%"
