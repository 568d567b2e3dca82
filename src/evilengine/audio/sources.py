"""What voices play: samples, decoded once by name, and music that is decoded while it plays."""

from __future__ import annotations

from array import array
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from evilengine import _core
from evilengine.audio.decode import SoundFile, open_sound
from evilengine.values.errors import AssetError
from evilengine.values.files import find_file

AHEAD = 2**17
"""Frames of music decoded ahead, 2.7 s at 48 kHz: so long may the game be busy with something else."""

AT_FIRST = 2**14
"""Frames decoded before music starts."""

A_FRAME = 2**12
"""Frames decoded at most in one step of the game: faster than they are played, too few to be felt."""


@dataclass(frozen=True, slots=True)
class Loaded:
    """A sound in memory."""

    name: str
    sample: _core.Sample

    @property
    def seconds(self) -> float:
        return self.sample.frames / self.sample.rate


class Sounds:
    """Finds sounds in folders and decodes each once. Names are relative to the folders, which are searched in order."""

    def __init__(self, *folders: Path) -> None:
        self.folders = folders or (Path(),)
        self._loaded: dict[Path, Loaded] = {}
        self._made: dict[str, Loaded] = {}
        self._opened: dict[Path, SoundFile] = {}

    def add(self, name: str, samples: array[float], *, channels: int, rate: float) -> None:
        """Keep a sound that the game made itself; it comes before a file of that name."""
        self._made[name] = Loaded(name, _core.Sample(samples, channels=channels, rate=rate))

    def load(self, name: str | Path) -> Loaded:
        """The sound called `name`. Raises AssetError that says why if it cannot be played."""
        if isinstance(name, str) and name in self._made:
            return self._made[name]
        path = find_file(name, self.folders, "sound").absolute()
        if path not in self._loaded:
            file = open_sound(path, str(name))
            self._loaded[path] = Loaded(str(name), _core.Sample(file.decode(), channels=file.channels, rate=file.rate))
        return self._loaded[path]

    def open(self, name: str | Path) -> SoundFile:
        """The sound called `name`, to be decoded while it plays."""
        path = find_file(name, self.folders, "sound").absolute()
        if path not in self._opened:
            file = open_sound(path, str(name))
            file.try_out()
            self._opened.clear()  # one at a time: whole files are large
            self._opened[path] = file
        return self._opened[path]


class Music:
    """Decodes a file into a stream, round and round if it loops."""

    def __init__(self, file: SoundFile, *, loop: bool, skip: float = 0.0) -> None:
        self.stream = _core.Stream(channels=file.channels, rate=file.rate, capacity=AHEAD)
        self._file = file
        self._loop = loop
        self._blocks: Iterator[array[float]] | None = file.blocks()
        self._rest = array("f")  # decoded, and not yet written
        self._skip = round(skip * file.rate) * file.channels  # values
        self._heard_any = False
        self.fill(AT_FIRST)

    def fill(self, most: int) -> None:
        """Decode up to `most` frames more, as many as there is room for."""
        left = min(most, self.stream.room) * self._file.channels
        while left > 0 and (block := self._next()):
            self.stream.write(block[:left])
            self._rest = block[left:]
            left -= min(left, len(block))

    def _next(self) -> array[float]:
        """Samples to write; none when the music is over."""
        while not self._rest and self._blocks is not None:
            self._rest = self._decoded()
            skipped = min(self._skip, len(self._rest))
            self._skip -= skipped
            self._rest = self._rest[skipped:]
        return self._rest

    def _decoded(self) -> array[float]:
        assert self._blocks is not None
        try:
            block = next(self._blocks, None)
        except AssetError:  # damaged in the middle: what came before it has been heard
            block = None
        if block is not None:
            self._heard_any = True
            return block
        again = self._loop and self._heard_any
        self._blocks, self._heard_any = self._file.blocks() if again else None, False
        if not again:
            self.stream.finish()
        return array("f")
