"""Schedule: callbacks at planned times, from a heap (SPEC T2, A10)."""

from __future__ import annotations

import heapq
import math
from collections.abc import Callable
from typing import TypeAlias

from evilengine.values.checks import known_keywords, number
from evilengine.values.errors import ArgumentTypeError
from evilengine.values.tick import STEP

Callback: TypeAlias = Callable[[], object]

LONGEST = 1e9
"""Seconds, some thirty years: the furthest that an event can be planned; beyond it times lose their milliseconds."""

ROUNDING = 1e-6
"""Part of a step by which sums of decimal times may miss the step they mean: 3 * 0.1 is more than 0.3."""


class Event:
    """A callback that waits for its time; what `after`, `every` and `at` return."""

    __slots__ = ("__weakref__", "_call", "_interval", "_order", "_round", "_schedule", "_start", "_time")

    def __init__(self, schedule: Schedule, order: int, start: float, interval: float, call: Callback) -> None:
        self._schedule = schedule
        self._order = order
        self._start = start
        self._interval = interval  # 0: happens once
        self._round = 0
        self._time: float | None = None
        self._call = call

    @property
    def alive(self) -> bool:
        """True while the event will happen, for the first time or again."""
        return self._time is not None

    @property
    def time(self) -> float | None:
        """Simulated seconds at which it happens next; None when it is over or cancelled."""
        return self._time

    def cancel(self) -> None:
        """Make it not happen (again). Cancelling what is over already does nothing."""
        self._schedule._remove(self)

    def __repr__(self) -> str:
        when = "over" if self._time is None else f"at {self._time:g} s"
        again = f", every {self._interval:g} s" if self._interval else ""
        return f"<Event {when}{again}>"


class Schedule:
    """Events planned in simulated time, in the order of their times; those of one time in the order they were made.

    Time here is the count of fixed steps that `steps()` gives, so the same game plans and fires the same on every
    machine, and stands still while the game is paused.

    >>> world = evil.World(); schedule = Schedule(lambda: world.steps)
    >>> bell = schedule.after(0.5, lambda: print("ding"))
    >>> for _ in range(31):
    ...     schedule.run_due()
    ...     world.step()
    ding
    >>> bell.alive
    False
    """

    def __init__(self, steps: Callable[[], int]) -> None:
        self._steps = steps
        self._made = 0
        self._running = False
        self._heap: list[tuple[float, int, Event]] = []

    @property
    def time(self) -> float:
        """Simulated seconds since the start."""
        return self._steps() * STEP

    def __len__(self) -> int:
        """How many events wait."""
        return len(self._heap)

    @property
    def events(self) -> tuple[Event, ...]:
        """The events that wait, in the order in which they will happen."""
        return tuple(event for _, _, event in sorted(self._heap, key=lambda entry: entry[:2]))

    @known_keywords
    def after(self, seconds: float, call: Callback) -> Event:
        """Call `call()` once, `seconds` from now (0 or more; 0 is the next step)."""
        seconds = number(seconds, "timer.after", "seconds", least=0.0, most=LONGEST)
        return self._plan("timer.after", self.time + seconds, 0.0, call)

    @known_keywords
    def every(self, seconds: float, call: Callback) -> Event:
        """Call `call()` every `seconds`, the first time `seconds` from now, until it is cancelled.

        The rounds do not drift: the hundredth comes a hundred intervals after now. Refuses less than a step, 1/60.
        """
        seconds = number(seconds, "timer.every", "seconds", least=STEP, most=LONGEST)
        return self._plan("timer.every", self.time + seconds, seconds, call)

    @known_keywords
    def at(self, time: float, call: Callback) -> Event:
        """Call `call()` once when simulated time reaches `time`, at the next step if that has passed."""
        return self._plan("timer.at", number(time, "timer.at", "time", least=0.0, most=LONGEST), 0.0, call)

    def run_due(self) -> None:
        """Call what is due by now. Events made meanwhile wait for the next step, however soon they are planned.

        A callback may make and cancel events. If one raises, it counts as called, the rest stay due, and the exception
        goes through. What shall be destroyed and is gone already is passed over.
        """
        now = self._steps()
        self._running = True
        try:
            while self._heap and _first_step(self._heap[0][0]) <= now:
                _, _, event = heapq.heappop(self._heap)
                event._time = None
                if event._interval:
                    event._round += 1
                    self._push(event)
                if not is_over(event._call):
                    event._call()
        finally:
            self._running = False

    def clear(self) -> None:
        """Cancel every event."""
        for _, _, event in self._heap:
            event._time = None
        self._heap.clear()

    def _plan(self, owner: str, start: float, interval: float, call: Callback) -> Event:
        if not callable(call):
            raise ArgumentTypeError(f"{owner}: call={call!r} must be a function without arguments")
        event = Event(self, self._made, start, interval, call)
        self._made += 1
        self._push(event)
        return event

    def _push(self, event: Event) -> None:
        time = event._start + event._round * event._interval
        if self._running:
            time = max(time, self.time + STEP)
        event._time = round(time, 9)  # the same time however it was summed
        heapq.heappush(self._heap, (event._time, event._order, event))

    def _remove(self, event: Event) -> None:
        if event._time is not None:
            self._heap.remove((event._time, event._order, event))
            heapq.heapify(self._heap)
            event._time = None


def is_over(call: Callback) -> bool:
    """Is it the `destroy` of a thing that is gone already? Then nothing is left to do."""
    thing = getattr(call, "__self__", None)
    return getattr(call, "__name__", "") == "destroy" and getattr(thing, "alive", True) is False


def _first_step(time: float) -> int:
    """The first step that begins at `time` or later."""
    return math.ceil(time / STEP - ROUNDING)
