"""Recordings: what the player did in every step, and sums of what came of it, written while it happens.

    "EVILPLAY"  version (u32)  length of the file, 0 until it is closed (u64)  records ...        little-endian

Before each step comes a byte whose bits say what follows it: the inputs, where they are not those of the step before
(deflated, with those as a dictionary), and the size of the screen, where it changed. After a step may come sums: a byte
whose bits say which are others than before, and those. Further records have a length: what the recording begins with, a
saved game that was resumed in between, a scene that was gone to, the end. Every second a seal holds the checksum of all
records before it. Each step is handed to the system before it is made, so a recording outlives the crash that it is to
explain; it just has no end, and no length.
"""

from __future__ import annotations

import json
import logging
import math
import struct
import weakref
import zlib
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any

from evilengine.save import inputs as inputs_code
from evilengine.save.files import read_whole
from evilengine.values.errors import DamagedSaveError, SaveError
from evilengine.values.inputs import Inputs

MAGIC = b"EVILPLAY"
VERSION = 1
_HEAD = struct.Struct("<8sIQ")
LARGEST = 1 << 30  # bytes of a file, and of a saved game in it
LARGEST_INPUTS = 1 << 20  # bytes of one step's; a forged file may not ask for all memory

INPUTS, SIZE = 1, 2  # bits of the byte before a step
SUMS = 0x20  # and a bit for each of MODULES
HEADER, STATE, RESUMED, SEAL, END, VISIT = 0x80, 0x81, 0x82, 0x83, 0x84, 0x85

STEPS_A_SEAL = 60

MODULES = ("bodies", "contacts", "forces", "timers", "random")
"""What is summed, in the order in which a difference is told."""

Sums = tuple[int, ...]
"""32 bits of each of MODULES."""
NO_SUMS: Sums = (0,) * len(MODULES)


@dataclass(frozen=True, slots=True)
class Visited:
    """A scene that was gone to between two steps."""

    name: str
    arguments: tuple[Any, ...]
    source: str | None
    """Of a level that was read from its file then."""
    inside: bool
    """Was it asked for by the step itself, which asks again when it is played?"""
    sounds: str


@dataclass(frozen=True, slots=True)
class Step:
    """One step of a recording."""

    inputs: Inputs
    size: tuple[float, float]
    """Of the screen, in logical points."""
    sums: Sums | None = None
    """After the step; None where none were taken."""
    between: tuple[bytes | Visited, ...] = ()
    """Saved games that were resumed, and scenes that were gone to, when the step was over and before the next."""


class Recorder:
    """Writes a recording. `header` says what it begins with, as plain values; `state` is a saved game to begin with.

    When the file cannot be written any more, a line of notice says so and the game goes on without it.
    """

    def __init__(self, path: Path, header: dict[str, Any], state: bytes | None = None) -> None:
        self.path = path
        self.steps = 0
        self._checksum = 0
        self._inputs = b""
        self._size = (0.0, 0.0)
        self._sums = NO_SUMS
        self._open = True
        try:
            self._file = path.open("wb")
        except OSError as problem:
            raise SaveError(f"{path} cannot be written: {problem.strerror or problem}") from problem
        self._finalizer = weakref.finalize(self, self._file.close)
        self._file.write(_HEAD.pack(MAGIC, VERSION, 0))
        self._record(HEADER, json.dumps(header, allow_nan=False, sort_keys=True).encode())
        if state is not None:
            self._record(STATE, zlib.compress(state))

    @property
    def is_open(self) -> bool:
        """False once it was closed, or the file could not be written."""
        return self._open

    def begin_step(self, inputs: Inputs, size: tuple[float, float]) -> None:
        """Write what the player does in the step that begins now."""
        if self.steps % STEPS_A_SEAL == 0 and self.steps:
            self._seal()
        step = bytearray(1)
        encoded = inputs_code.encode(inputs)
        if encoded != self._inputs:
            changes = _deflate(encoded, self._inputs)
            step[0] |= INPUTS
            step += struct.pack("<I", len(changes)) + changes
            self._inputs = encoded
        if size != self._size:
            step[0] |= SIZE
            step += struct.pack("<2d", *size)
            self._size = size
        self.steps += 1
        self._put(step, flush=True)

    def end_step(self, sums: Sums) -> None:
        """Write what came of the step."""
        changed = [(bit, new) for bit, (new, old) in enumerate(zip(sums, self._sums, strict=True)) if new != old]
        mask = sum(1 << bit for bit, _ in changed)
        self._put(struct.pack(f"<B{len(changed)}I", SUMS | mask, *(new for _, new in changed)))
        self._sums = sums

    def resumed(self, state: bytes) -> None:
        """Write that this saved game was resumed."""
        self._record(RESUMED, zlib.compress(state))

    def visited(self, to: Visited) -> None:
        """Write that this scene was gone to."""
        self._record(VISIT, json.dumps(asdict(to), allow_nan=False, sort_keys=True).encode())

    def close(self) -> None:
        """Write the end. Closing twice does nothing."""
        if self._open:
            self._seal()
            self._record(END, struct.pack("<Q", self.steps))
            self._seal()
            try:
                self._file.flush()
                length = self._file.tell()
                self._file.seek(0)
                self._file.write(_HEAD.pack(MAGIC, VERSION, length))
            except OSError as problem:
                self._give_up(f"{self.path} cannot be written: {problem.strerror or problem}; it has no end")
            self._give_up("")

    def _seal(self) -> None:
        self._put(struct.pack("<BI", SEAL, self._checksum))

    def _record(self, kind: int, data: bytes) -> None:
        self._put(struct.pack("<BI", kind, len(data)) + data)

    def _put(self, data: bytes | bytearray, *, flush: bool = False) -> None:
        if not self._open:
            return
        self._checksum = zlib.crc32(data, self._checksum)
        try:
            self._file.write(data)
            if flush:
                self._file.flush()
        except OSError as problem:
            self._give_up(f"{self.path} cannot be written any more: {problem.strerror or problem}; it ends here")

    def _give_up(self, why: str) -> None:
        self._open = False
        self._finalizer.detach()
        try:
            self._file.close()
        except OSError as problem:
            why = why or f"{self.path} cannot be written: {problem.strerror or problem}"
        if why:
            logging.getLogger("evilengine").warning("%s", why)


@dataclass(frozen=True, slots=True)
class Replay:
    """A recording that was read."""

    name: str
    header: dict[str, Any]
    state: bytes | None
    """The saved game that it begins with; None for one that begins with a level or a program."""
    steps: tuple[Step, ...]
    between: tuple[bytes | Visited, ...]
    """What was resumed and gone to before the first step."""
    complete: bool
    """False when it breaks off: whoever recorded it crashed or was killed."""

    @staticmethod
    def read(path: Path) -> Replay:
        """The recording in the file `path`. Raises SaveError for what is none, or was changed since."""
        data = read_whole(path, LARGEST)
        if data[: len(MAGIC)] != MAGIC or len(data) < _HEAD.size:
            raise DamagedSaveError(f"{path.name} is not a recording of a game")
        _, version, length = _HEAD.unpack_from(data)
        if version != VERSION:
            raise SaveError(
                f"{path.name} was recorded by another version of the engine (its format is {version}, this engine knows"
                f" {VERSION})"
            )
        try:
            replay = _Parser(data, path.name).replay()
        except (ValueError, TypeError, KeyError, struct.error, zlib.error) as problem:
            raise DamagedSaveError(f"{path.name} is damaged: {problem}") from problem
        if length != (len(data) if replay.complete else 0):
            raise DamagedSaveError(f"{path.name} is damaged: it is not as long as it was")
        return replay


class _CutShortError(Exception):
    """The file ends within a record."""


class _Parser:
    """Takes a file apart, as far as it goes."""

    def __init__(self, data: bytes, name: str) -> None:
        self._data, self._name = data, name
        self._at = self._checked = _HEAD.size
        self._checksum = 0  # of the bytes up to `_checked`
        self._header: dict[str, Any] | None = None
        self._state: bytes | None = None
        self._steps: list[Step] = []
        self._inputs = b""
        self._now = Inputs()
        self._size = (0.0, 0.0)
        self._sums = NO_SUMS
        self._between: list[bytes | Visited] = []
        self._summed = self._ended = False

    def replay(self) -> Replay:
        complete = False
        try:
            while self._at < len(self._data):
                complete = self._record()
        except _CutShortError:
            complete = False
        if self._header is None:
            raise ValueError("it has no beginning")
        return Replay(self._name, self._header, self._state, tuple(self._steps), tuple(self._between), complete)

    def _record(self) -> bool:
        """Take in one record; True for the seal that comes after the end."""
        start = self._at
        kind = self._take(1)[0]
        if self._ended and kind != SEAL:
            raise ValueError("it goes on after its end")
        if kind <= INPUTS | SIZE:
            self._step(kind)
        elif SUMS <= kind < 2 * SUMS:
            self._take_sums(kind & (SUMS - 1))
        elif kind == SEAL:
            self._checksum = zlib.crc32(self._data[self._checked : start], self._checksum)
            self._checked = start
            if self._whole() != self._checksum:
                raise ValueError(f"something was changed before step {len(self._steps) + 1}")
            return self._ended
        else:
            self._long_record(kind, self._take(self._whole()))
        return False

    def _step(self, bits: int) -> None:
        if self._header is None:
            raise ValueError("it has no beginning")
        if bits & INPUTS:
            self._inputs = _inflate(self._take(self._whole()), LARGEST_INPUTS, self._inputs)
            self._now = inputs_code.decode(self._inputs)
        if bits & SIZE:
            self._size = struct.unpack("<2d", self._take(16))
            if not all(math.isfinite(side) and side >= 1.0 for side in self._size):
                raise ValueError("a screen without a size")
        self._steps.append(Step(self._now, self._size))
        self._summed = False

    def _take_sums(self, mask: int) -> None:
        if not self._steps or self._summed:
            raise ValueError("sums of no step")
        self._sums = tuple(self._whole() if mask >> bit & 1 else old for bit, old in enumerate(self._sums))
        self._steps[-1] = replace(self._steps[-1], sums=self._sums)
        self._summed = True

    def _long_record(self, kind: int, data: bytes) -> None:
        match kind:
            case _ if kind == HEADER and self._header is None:
                header = json.loads(data)
                if not isinstance(header, dict):
                    raise ValueError("it has no beginning")
                self._header = header
            case _ if kind == STATE and self._state is None and not self._steps:
                self._state = _inflate_save(data)
            case _ if kind in (RESUMED, VISIT):
                what = _inflate_save(data) if kind == RESUMED else _visited(data)
                if self._steps:
                    last = self._steps[-1]
                    self._steps[-1] = replace(last, between=(*last.between, what))
                else:
                    self._between.append(what)
            case _ if kind == END and struct.unpack("<Q", data) == (len(self._steps),):
                self._ended = True
            case _:
                raise ValueError(f"a record of kind {kind} is where none can be")

    def _whole(self) -> int:
        (value,) = struct.unpack("<I", self._take(4))
        return int(value)

    def _take(self, count: int) -> bytes:
        part = self._data[self._at : self._at + count]
        if len(part) < count:
            raise _CutShortError
        self._at += count
        return part


def _visited(data: bytes) -> Visited:
    row = json.loads(data)
    source = row["source"]
    if not (isinstance(row["name"], str) and (source is None or isinstance(source, str))):
        raise ValueError("a scene without a name")
    return Visited(row["name"], tuple(row["arguments"]), source, bool(row["inside"]), str(row["sounds"]))


# Raw deflate in a small window: what one step holds is short, and the dictionary is at most as long.
_WINDOW, _MEMORY = -10, 2


def _deflate(data: bytes, before: bytes) -> bytes:
    packer = zlib.compressobj(6, zlib.DEFLATED, _WINDOW, _MEMORY, zdict=before[-1024:])
    return packer.compress(data) + packer.flush()


def _inflate(data: bytes, most: int, before: bytes) -> bytes:
    return _unpacked(zlib.decompressobj(_WINDOW, zdict=before[-1024:]), data, most)


def _inflate_save(data: bytes) -> bytes:
    return _unpacked(zlib.decompressobj(), data, LARGEST)


def _unpacked(unpacker: Any, data: bytes, most: int) -> bytes:
    whole: bytes = unpacker.decompress(data, most)
    if not unpacker.eof or unpacker.unused_data:
        raise ValueError("a record that is not whole")
    return whole
