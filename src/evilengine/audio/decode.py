"""Sound files to samples, by miniaudio: the only file that knows it. A browser would decode its own."""

from __future__ import annotations

import math
from array import array
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType

from evilengine.audio.containers import DamagedError, check, format_of
from evilengine.values.errors import AssetError

MAX_BYTES = 2**29
"""Half a gigabyte; the whole file is held while it plays."""

MAX_VALUES = 2**25
"""Samples of all channels in a sound that is decoded whole: 128 MB, five minutes in stereo. Music may be longer."""

MAX_RATE = 192_000
BLOCK = 8192  # frames decoded at once


@dataclass(frozen=True, slots=True)
class SoundFile:
    """A sound file that has been read and checked, not decoded."""

    name: str
    path: Path
    kind: str
    data: bytes
    channels: int
    """1 or 2: what has more is mixed down to two."""
    rate: int
    frames: int

    @property
    def seconds(self) -> float:
        """Infinite where the file does not tell."""
        return self.frames / self.rate if self.frames else math.inf

    def blocks(self) -> Iterator[array[float]]:
        """The samples, interleaved, from the start, some at a time."""
        miniaudio = _miniaudio(self.name)
        try:
            yield from miniaudio.stream_memory(
                self.data, miniaudio.SampleFormat.FLOAT32, self.channels, self.rate, frames_to_read=BLOCK
            )
        except miniaudio.MiniaudioError as problem:
            raise self._error(f"the file is damaged: {problem}") from None

    def decode(self) -> array[float]:
        """All samples, interleaved. Raises AssetError where the file is damaged, cut short, or too long for this."""
        if self.frames * self.channels > MAX_VALUES:
            raise self._too_long()
        samples = array("f")
        for block in self.blocks():
            samples.extend(block)
            if len(samples) > MAX_VALUES:
                raise self._too_long()
        if not samples:
            raise self._error("it holds no samples")
        self._require_all(len(samples))
        return samples

    def try_out(self) -> None:
        """Raise AssetError where `blocks` would not give all of it."""
        blocks = self.blocks()
        count = len(next(blocks, ()))
        if count == 0:
            raise self._error("it holds no samples")
        if self.kind == "flac":  # its length in the header is the only check that it has from outside
            self._require_all(count + sum(len(block) for block in blocks))

    def _require_all(self, values: int) -> None:
        frames = values // self.channels
        if frames < self.frames:
            raise self._error(f"it is cut short or damaged: {frames} frames of {self.frames} can be read")

    def _too_long(self) -> AssetError:
        seconds = MAX_VALUES / self.channels / self.rate
        return self._error(f"a sound may last {seconds:.0f} s; play longer ones with game.audio.music()")

    def _error(self, reason: str) -> AssetError:
        return AssetError(f"sound {self.name!r} ({self.path}): {reason}")


def open_sound(path: Path, name: str) -> SoundFile:
    """Read the file at `path` and check it. Raises AssetError that says why if it cannot be played."""
    try:
        size = path.stat().st_size
        if size > MAX_BYTES:
            raise DamagedError(f"{size / 1e6:.0f} MB; at most {MAX_BYTES / 1e6:.0f} MB can be played")
        data = path.read_bytes()
        kind = format_of(data)
        check(data, kind)
        channels, rate, frames = _header(data, kind, name)
    except DamagedError as problem:
        raise AssetError(f"sound {name!r} ({path}): {problem}") from None
    except OSError as problem:
        if isinstance(problem, AssetError):
            raise
        raise AssetError(f"sound {name!r} ({path}): {problem.strerror or problem}") from problem
    except MemoryError:
        raise AssetError(f"sound {name!r} ({path}): there is not enough memory for it") from None
    return SoundFile(name, path, kind, data, min(channels, 2), rate, frames)


def _header(data: bytes, kind: str, name: str) -> tuple[int, int, int]:
    """Channels, rate and frames that a file's header tells of."""
    miniaudio = _miniaudio(name)
    read = {"wav": "wav_get_info", "ogg": "vorbis_get_info", "mp3": "mp3_get_info", "flac": "flac_get_info"}
    try:
        info = getattr(miniaudio, read[kind])(data)
    except miniaudio.MiniaudioError as problem:
        raise DamagedError(f"its header is damaged or cut short: {problem}") from None
    if not 1 <= info.sample_rate <= MAX_RATE:
        raise DamagedError(f"{info.sample_rate} samples a second; at most {MAX_RATE} can be played")
    if info.nchannels < 1:
        raise DamagedError("its header tells of no channel")
    return info.nchannels, info.sample_rate, info.num_frames


def _miniaudio(name: str) -> ModuleType:
    try:
        import miniaudio
    except ImportError as problem:
        raise AssetError(f"sound {name!r}: miniaudio, which decodes sounds, cannot be loaded: {problem}") from None
    module: ModuleType = miniaudio
    return module
