"""What frames cost: four numbers for each of the last two seconds' frames."""

from __future__ import annotations

import time
from collections import deque

from evilengine.values.frame import FrameTimes

FRAMES = 120


class Timings:
    """The last frames' times. `timings.last` is the newest; `timings.rows` has them all, the oldest first.

    >>> timings = Timings(); timings.begin(); timings.steps(); timings.collected(); timings.drawn(); timings.shown()
    >>> len(timings.rows), timings.last.total < 1000
    (1, True)
    """

    def __init__(self) -> None:
        self.rows: deque[FrameTimes] = deque(maxlen=FRAMES)
        self._marks = [0.0] * 4
        self._before = 0.0

    @property
    def last(self) -> FrameTimes:
        """The frame before this one; zeros before the first."""
        return self.rows[-1] if self.rows else FrameTimes(0.0, 0.0, 0.0, 0.0)

    def begin(self) -> None:
        """A frame begins."""
        self._before = time.perf_counter()
        self._marks = [0.0] * 4

    def steps(self) -> None:
        """Its steps are made."""
        self._mark(0)

    def collected(self) -> None:
        """The list of what to draw is made."""
        self._mark(1)

    def drawn(self) -> None:
        """The picture is drawn."""
        self._mark(2)

    def shown(self) -> None:
        """It is on the screen: the frame is over."""
        self._mark(3)
        self.rows.append(FrameTimes(*self._marks))

    def _mark(self, part: int) -> None:
        now = time.perf_counter()
        self._marks[part] = (now - self._before) * 1e3
        self._before = now
