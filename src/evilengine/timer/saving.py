"""What a saved game keeps of a schedule, and the schedule that comes of it."""

from __future__ import annotations

import heapq
from collections.abc import Callable
from typing import Any

from evilengine.timer.schedule import Callback, Event, Schedule
from evilengine.values.checks import number


def state_of(schedule: Schedule, name_of: Callable[[Callback, str], Any]) -> dict[str, Any]:
    """Every event that waits, its function as `name_of(function, where)` calls it."""
    rows = [
        [event._order, event._start, event._interval, event._round, event._time, name_of(event._call, repr(event))]
        for event in schedule.events
    ]
    return {"made": schedule._made, "events": rows}


def read(schedule: Schedule, state: dict[str, Any], find: Callable[[Any], Callback]) -> Callable[[], None]:
    """Read what `state_of` gave, and return what puts it in place; nothing changes before that is called.

    An event that is the same as one that waits now is that one: who holds it can go on asking and cancelling.
    """
    made = int(state["made"])
    waiting = {event._order: event for event in schedule.events}
    heap: list[tuple[float, int, int, Event, Callback]] = []
    for order, start, interval, rounds, time, name in state["events"]:
        start, interval, time = (number(each, "timer", "time", least=0.0) for each in (start, interval, time))
        call, known = find(name), waiting.get(order)
        if known is None or (known._start, known._interval) != (start, interval):
            known = Event(schedule, int(order), start, interval, call)
        heap.append((time, int(order), int(rounds), known, call))

    def put() -> None:
        schedule.clear()
        for time, order, rounds, event, call in heap:
            event._call, event._round, event._time = call, rounds, time
            schedule._heap.append((time, order, event))
        heapq.heapify(schedule._heap)
        schedule._made = made

    return put
