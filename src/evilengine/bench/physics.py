"""`evil bench physics`: what a step of each scene costs."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from typing import Any

from evilengine.bench.scene import STEP, Scene, stage
from evilengine.bench.timing import take_turns


@dataclass(frozen=True, slots=True, kw_only=True)
class Plan:
    """How scenes are measured."""

    steps: int = 100
    warm: int | None = None
    substeps: int = 4
    threads: int = 1
    size: int | None = None


class Ours:
    """A scene in this engine."""

    def __init__(self, scene: Scene, size: int, substeps: int, threads: int = 1, name: str = "evil") -> None:
        self.name = name
        self.staged = stage(scene, size, threads=threads)
        self._substeps = substeps

    def prepare(self) -> None:
        self.staged.prepare()

    def step(self) -> None:
        self.staged.world.step(STEP, self._substeps)


def measure(scenes: Iterable[Scene], plan: Plan, tell: Callable[[str], None]) -> Iterator[dict[str, Any]]:
    """Numbers of each scene, as soon as they are there."""
    for scene in scenes:
        size = scene.size if plan.size is None else plan.size
        tell(f"{scene.name} ...")
        ours = Ours(scene, size, plan.substeps, plan.threads)
        times = take_turns([ours], plan.steps, scene.warm if plan.warm is None else plan.warm)
        world = ours.staged.world
        yield {
            "scene": scene.name,
            "size": size,
            "bodies": len(world.bodies),
            "contacts": len(world.contacts.active),
            "engines": {name: {"min": one.least, "median": one.median} for name, one in times.items()},
        }
