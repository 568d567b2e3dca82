"""What one frame cost."""

from __future__ import annotations

from typing import NamedTuple


class FrameTimes(NamedTuple):
    """Milliseconds of a frame's parts, in their order."""

    steps: float
    """Callbacks and the world's steps."""
    collect: float
    """What is seen, as a list."""
    draw: float
    """The list, as a picture."""
    present: float
    """The picture, on the screen; with a screen that sets the pace, most of it is waiting."""

    @property
    def total(self) -> float:
        """All of it."""
        return sum(self)
