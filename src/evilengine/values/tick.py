"""Tick: what one frame owes to time, worked out by the timer and followed by the game."""

from __future__ import annotations

from dataclasses import dataclass

STEP = 1.0 / 60.0
"""Seconds that one step simulates, on every machine: a step that varied would play differently on each."""


SLOWEST, FASTEST = 0.05, 4.0
"""How fast a game's time may go. Faster, and a frame owes more steps than a slow machine may catch up on."""


@dataclass(frozen=True, slots=True)
class Tick:
    """One frame's share of time."""

    steps: int
    """Fixed steps to simulate in this frame: usually 1, 0 on a fast screen, several after a slow frame."""
    alpha: float
    """Where the picture stands between the last two steps: 0 draws the earlier one, 1 the later."""
    dropped: float = 0.0
    """Seconds that were let go, because catching up on them would have made the next frame later still."""
