"""Where the mix goes: to a sound card, to a file, or nowhere."""

from __future__ import annotations

import wave
from collections.abc import Callable
from pathlib import Path
from typing import Protocol

from evilengine import _core
from evilengine.audio.sources import A_FRAME, AHEAD
from evilengine.values.errors import AssetError, DeviceError
from evilengine.values.tick import STEP

RATE = _core.MIX_RATE
FRAMES_A_STEP = round(RATE * STEP)
"""Frames of sound in one step of the game: 800."""

RENDERED_AT_ONCE = 8192
"""Frames; streams are filled up in between."""


class Closing(Protocol):
    """What a sound card is for `Card`: something to close."""

    def close(self) -> None: ...


OpenCard = Callable[[int, int, object, int], Closing]
"""Opens a sound card: the address of its callback, the address to call it with, what to keep alive, the rate."""


class Output:
    """Nowhere: every sound plays, nobody hears it, nothing is computed. The other outputs derive from it."""

    name = "none"
    live = False
    """Is it heard while the game goes, at the pace of the clock on the wall?"""

    def __init__(self, reason: str = "") -> None:
        self.mixer: _core.Mixer | None = None
        self.reason = reason
        """Why there is no sound; empty when there is, or when none was asked for."""

    def open(self) -> None:
        """Make the mixer, at the first sound. Never raises: where it cannot, there is none, and `reason` says why."""

    def when(self, step: int) -> int:
        """The frame of the mix that an order given in this step is for; 0: as soon as possible."""
        return 0

    def update(self, step: int, fill: Callable[[int], None]) -> None:
        """Once a step or frame of the game; `fill` decodes so many frames for each stream, as far as there is room."""
        fill(A_FRAME)

    def close(self) -> None:
        """Let go of the card, finish the file."""


class Card(Output):
    """A sound card."""

    name = "card"
    live = True

    def __init__(self, open_card: OpenCard) -> None:
        super().__init__()
        self._open_card = open_card
        self._card: Closing | None = None

    def open(self) -> None:
        if self._card is not None or self.reason:
            return
        mixer = _core.Mixer()
        try:
            self._card = self._open_card(mixer.callback, mixer.address, mixer, RATE)
        except DeviceError as problem:
            self.reason = str(problem)
            return
        self.mixer = mixer

    def close(self) -> None:
        if self._card is not None:
            self._card.close()
        self._card, self.mixer = None, None
        self.reason = self.reason or "it was closed"


class WavFile(Output):
    """A wav file of 16 bits: step for step what the game sounded like, the same bytes every time."""

    name = "wav"

    def __init__(self, path: str | Path) -> None:
        super().__init__()
        try:
            self._bytes = Path(path).open("wb")  # noqa: SIM115  (close() closes it)
        except OSError as problem:
            raise AssetError(f"sound file {str(path)!r} cannot be written: {problem.strerror or problem}") from problem
        self._file = wave.open(self._bytes, "wb")  # noqa: SIM115
        self._file.setnchannels(2)
        self._file.setsampwidth(2)
        self._file.setframerate(RATE)
        self._late = _core.MIX_LATENCY
        self._step = 0
        self._fill: Callable[[int], None] | None = None
        self.mixer = _core.Mixer()

    def when(self, step: int) -> int:
        return step * FRAMES_A_STEP

    def update(self, step: int, fill: Callable[[int], None]) -> None:
        self._step, self._fill = step, fill
        fill(AHEAD)
        self._render(step * FRAMES_A_STEP)

    def _render(self, end: int) -> None:
        while self.mixer is not None and self.mixer.clock < end:
            frames = min(RENDERED_AT_ONCE, end - self.mixer.clock)
            pcm = self.mixer.render_pcm(frames)
            skipped = min(self._late, frames)  # the limiter's delay is no part of the game
            self._late -= skipped
            self._file.writeframesraw(pcm[4 * skipped :])
            if self._fill is not None:
                self._fill(AHEAD)

    def close(self) -> None:
        if self.mixer is None:
            return
        self._render(self._step * FRAMES_A_STEP + _core.MIX_LATENCY)
        self.mixer = None
        self._file.close()
        self._bytes.close()
