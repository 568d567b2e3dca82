"""Clock: wall time in, whole steps out (SPEC T1)."""

from __future__ import annotations

from evilengine.values.checks import number
from evilengine.values.tick import STEP, Tick

MOST_STEPS = 6
"""Steps a frame may catch up on. A machine that draws fewer than ten frames a second plays in slow motion; without a
limit each late frame would owe more steps, which would make the next one later still, until nothing is drawn at all."""

FURTHEST = 1e12
"""Seconds from the origin: a clock that says more than thirty thousand years is broken."""

ROUNDING = 1e-6
"""Part of a step that a frame may come early. Sums of 1/60 fall short of a whole step in their last bits, and a screen
at 60 frames a second would then take 0 and 2 steps by turns."""


class Clock:
    """Turns wall time into fixed steps, and what is left over into a place between two steps for drawing.

    It reads no clock itself: whoever owns the frame says what time it is, so a test or a film plays at any speed.

    >>> clock = Clock()
    >>> clock.advance(0.0), clock.advance(2.5 * STEP)
    (Tick(steps=0, alpha=0.0, dropped=0.0), Tick(steps=2, alpha=0.5, dropped=0.0))
    """

    def __init__(self) -> None:
        self._before: float | None = None
        self._owed = 0.0  # steps, 0 to 1: time seen and not yet simulated

    def advance(self, now: float, speed: float = 1.0) -> Tick:
        """The steps due at `now`, seconds from any origin. Time that runs backwards counts as standing still.

        `speed` is how much of the time since the last frame the game lives through: at 0.5, two frames make a step.
        """
        elapsed = self._elapsed(now) * speed
        owed = self._owed + elapsed / STEP
        due = int(owed + ROUNDING)
        steps = min(due, MOST_STEPS)
        self._owed = min(max(owed - due, 0.0), 1.0)
        return Tick(steps, self._owed, (due - steps) * STEP)

    def hold(self, now: float) -> Tick:
        """The tick of a frame that stands still: no steps, and the picture is that of the last step.

        The time that passes while holding is forgotten; `advance` goes on from the picture that is shown.

        >>> clock = Clock()
        >>> clock.hold(-60.0).alpha, clock.hold(0.0).steps, clock.advance(STEP / 2)
        (1.0, 0, Tick(steps=1, alpha=0.5, dropped=0.0))
        """
        self._elapsed(now)
        self._owed = 1.0
        return Tick(0, 1.0)

    def _elapsed(self, now: float) -> float:
        now = number(now, "Clock", "now", least=-FURTHEST, most=FURTHEST)
        elapsed = 0.0 if self._before is None else max(now - self._before, 0.0)
        self._before = now
        return elapsed
