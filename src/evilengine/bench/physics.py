"""`evil bench physics`: what a step of each scene costs, here and in the peers."""

from __future__ import annotations

import math
import os
import time
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Any

from evilengine.bench.peers import CannotMakeError, Peer, Placed
from evilengine.bench.scene import STEP, Scene, stage
from evilengine.bench.timing import Runner, Times, take_turns

Tell = Callable[[str], None]
Numbers = dict[str, Any]
"""What goes into the JSON file: words, numbers, lists and dictionaries of these."""

OURS = "evil"


@dataclass(frozen=True, slots=True, kw_only=True)
class Plan:
    """How scenes are measured."""

    steps: int | None = None
    warm: int | None = None
    substeps: int = 4
    threads: tuple[int, ...] = (1,)
    size: int | None = None
    patience: float = 10.0
    """Seconds that an engine is timed for at most, and that a peer may take for the steps before; the pyramid's are all
    made, since how still it stands afterwards is measured too."""


class Ours:
    """A scene in this engine."""

    def __init__(self, scene: Scene, size: int, substeps: int, threads: int = 1, name: str = OURS) -> None:
        self.name = name
        self.staged = stage(scene, size, threads=threads)
        self._substeps = substeps

    def prepare(self) -> None:
        self.staged.prepare()

    def step(self) -> None:
        self.staged.world.step(STEP, self._substeps)

    def placed(self) -> list[Placed]:
        return [(*body.position, body.angle) for body in self.staged.world.bodies]


@dataclass(slots=True)
class Measured:
    """A scene after its steps."""

    scene: Scene
    size: int
    ours: Ours
    runners: Sequence[Any]
    times: dict[str, Times]
    left_out: list[str]

    def numbers(self) -> Numbers:
        mine = self.times[OURS]
        world = self.ours.staged.world
        return {
            "scene": self.scene.name,
            "size": self.size,
            "bodies": len(world.bodies),
            "contacts": len(world.contacts.active),
            "steps": len(mine.steps),
            "engines": {
                name: {"min": one.least, "median": one.median, "ours_to_it": mine.ratio(one)}
                for name, one in self.times.items()
            },
            "left_out": self.left_out,
        }


def measure(scene: Scene, plan: Plan, peers: Iterable[type[Peer]], tell: Tell) -> Measured:
    """One scene in all engines, step by step in turn."""
    size = scene.size if plan.size is None else plan.size
    warm = scene.warm if plan.warm is None else plan.warm
    steps = scene.steps if plan.steps is None else plan.steps
    tell(f"{scene.name}: made, and {warm} steps before the {steps} that count")
    first, *more = plan.threads
    ours = Ours(scene, size, plan.substeps, first)
    runners: list[Runner] = [ours, *(Ours(scene, size, plan.substeps, n, f"{n} threads") for n in more)]
    if scene.name == "pyramid" and plan.substeps == 4:
        runners.append(Ours(scene, size, 8, first, "8 substeps"))
    left_out = []
    for kind in peers:
        try:
            runners.append(kind(scene, size, plan.substeps))
        except CannotMakeError as problem:
            tell(str(problem))
            left_out.append(kind.name)
    start = time.perf_counter()
    times = take_turns(runners, steps, warm, patience=math.inf if scene.name == "pyramid" else plan.patience)
    slow = [runner.name for runner in runners if runner.name not in times]
    if slow:
        tell(f"{scene.name}: {', '.join(slow)} left out, too slow to wait for (--patience waits longer)")
    tell(f"{scene.name}: {time.perf_counter() - start:.1f} s")
    runners = [runner for runner in runners if runner.name in times]
    return Measured(scene, size, ours, runners, times, left_out + slow)


def threads_to_try(threads: int | None) -> tuple[int, ...]:
    """What was asked for; else one, and two where there are two processors."""
    if threads is not None:
        return (threads,)
    return (1, 2) if (os.cpu_count() or 1) > 1 else (1,)
