"""The quality of light that a game in a window chooses for itself, from what its frames cost (SPEC G4)."""

from __future__ import annotations

from typing import TYPE_CHECKING

from evilengine.platform import HeadlessDevice
from evilengine.values.governor import LOOKS, Governor
from evilengine.values.tick import STEP

if TYPE_CHECKING:
    from evilengine.game.game import Game


class LightQuality:
    """What looks at each frame of a game when it is over.

    Where nobody watches a screen, pictures must come out the same again: no clock has a say in them there.
    """

    def __init__(self) -> None:
        self._governor = Governor(1e3 * STEP)
        self._rests: list[float] = []

    def note(self, game: Game) -> None:
        """A frame is over."""
        lights, replay = game.lights, game._playback
        if lights.quality != "auto" or isinstance(game.device, HeadlessDevice) or not (replay is None or replay.over):
            return
        if lights._cost is None:  # nothing was lit
            return
        times = game.timings.last
        busy = times.steps + times.collect + times.draw + (0.0 if game.device.vsync else times.present)
        if self._governor.chosen:
            lights._present = self._governor.note(lights._cost, busy, times.total)
            return
        self._rests.append(busy - lights._cost)
        if len(self._rests) == LOOKS:
            lights._present = self._governor.choose(lights._measure(), max(min(self._rests), 0.0))
