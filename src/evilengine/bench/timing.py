"""How long steps take: engines in turn, a few steps each, so that a machine's moods fall on all of them alike."""

from __future__ import annotations

import math
import statistics
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Protocol

FEWEST = 3
"""Rounds that a ratio is the median of."""


class Runner(Protocol):
    """A scene in one engine: `prepare` is what the scene does before a step, `step` is what is timed."""

    name: str

    def prepare(self) -> None: ...

    def step(self) -> None: ...


@dataclass(slots=True)
class Times:
    """Seconds of each timed step of one engine, round by round."""

    rounds: list[list[float]] = field(default_factory=list)

    @property
    def steps(self) -> list[float]:
        return [seconds for each in self.rounds for seconds in each]

    @property
    def least(self) -> float:
        """Milliseconds of the fastest step."""
        return 1e3 * min(self.steps)

    @property
    def median(self) -> float:
        """Milliseconds of the middle step."""
        return 1e3 * statistics.median(self.steps)

    def ratio(self, other: Times) -> float:
        """This one's time as a part of the other's: the median over rounds that ran side by side."""
        pairs = zip(self.rounds, other.rounds, strict=False)
        return statistics.median(sum(mine) / sum(theirs) for mine, theirs in pairs)


def timed(runner: Runner, steps: int) -> list[float]:
    """Seconds of each of so many steps."""
    clock, times = time.perf_counter, []
    for _ in range(steps):
        runner.prepare()
        start = clock()
        runner.step()
        times.append(clock() - start)
    return times


def take_turns(
    runners: Sequence[Runner], steps: int, warm: int, *, turn: int = 5, patience: float = math.inf
) -> dict[str, Times]:
    """Let all runners make `warm` steps, then `steps` that are timed, `turn` at a time, in turn.

    Which runner comes first changes from round to round. When the first of `runners` has been timed for `patience`
    seconds, that is enough for all, once there are FEWEST rounds. Another is left out when it would need longer for its
    steps before it is timed, and has fewer rounds when it needs longer for those that are; its ratio is of the rounds
    that it has.
    """
    first = runners[0]
    ready = [runner for runner in runners if _warmed(runner, warm, math.inf if runner is first else patience)]
    times = {runner.name: Times() for runner in ready}
    done = 0
    while done < steps:
        now = min(turn, steps - done)
        for runner in ready:
            times[runner.name].rounds.append(timed(runner, now))
        ready = [runner for runner in ready if runner is first or sum(times[runner.name].steps) < patience]
        ready.append(ready.pop(0))
        done += now
        rounds = times[first.name].rounds
        if len(rounds) >= FEWEST and sum(times[first.name].steps) > patience:
            break
    return times


def _warmed(runner: Runner, steps: int, patience: float) -> bool:
    """Make the steps, unless they would take too long."""
    done, spent = 0, 0.0
    while done < steps:
        now = min(10, steps - done)
        last = sum(timed(runner, now))
        done, spent = done + now, spent + last
        if spent + last / now * (steps - done) > patience:
            return False
    return True


def best(call: Callable[[], object], repeats: int) -> float:
    """Seconds of the fastest of so many calls."""
    clock, least = time.perf_counter, float("inf")
    for _ in range(repeats):
        start = clock()
        call()
        least = min(least, clock() - start)
    return least
