"""Inputs as bytes: what the player did in a step, exactly, and always the same bytes for the same Inputs."""

from __future__ import annotations

import math
import struct
from collections.abc import Callable, Iterable
from typing import TypeVar

from evilengine.values.events import PHASES, Finger, Reading, SensorEvent, key_name
from evilengine.values.inputs import Inputs, Keys, Pad, Pointer, Tilt, Touch
from evilengine.values.vec2 import Vec2

T = TypeVar("T")

_VECTORS = struct.Struct("<8d")


def encode(inputs: Inputs) -> bytes:
    """The bytes of `inputs`.

    >>> inputs = Inputs(keys=Keys(("left",)), pressed=("left",), wheel=Vec2(0, -0.5))
    >>> decode(encode(inputs)) == inputs
    True
    """
    out = bytearray()
    pointer, tilt = inputs.pointer, inputs.tilt
    for words in (inputs.keys.held, inputs.pressed, inputs.released):
        _put_words(out, words)
    text = inputs.text.encode("utf-8", "surrogatepass")
    out += struct.pack("<I", len(text)) + text
    out += _VECTORS.pack(*pointer.at, *pointer.previous, *pointer.pixel, *pointer.previous_pixel)
    for words in (pointer.buttons, pointer.pressed, pointer.released):
        _put_words(out, words)
    out += struct.pack("<2d", *inputs.wheel)
    for touches in (inputs.touches, inputs.touch_events):
        out += struct.pack("<H", len(touches))
        for touch in touches:
            _put_touch(out, touch)
    out += struct.pack("<2d2?", *tilt.direction, tilt.changed, tilt.shaken)
    _put_reading(out, tilt.reading)
    out += struct.pack("<H", len(inputs.pads))
    for pad in inputs.pads:
        out += struct.pack("<q6d", pad.number, *pad.left, *pad.right, pad.left_trigger, pad.right_trigger)
        _put_words(out, (pad.name, *pad.buttons))
    out += struct.pack("<H", len(inputs.sensors))
    for event in inputs.sensors:
        _put_words(out, (event.sensor,))
        out += struct.pack("<3d", *event.values)
    return bytes(out)


def decode(data: bytes) -> Inputs:
    """The Inputs that `data` are the bytes of. Raises ValueError for bytes that `encode` cannot have made."""
    read = _Reader(data)
    inputs = Inputs(
        keys=Keys(read.keys()),
        pressed=read.keys(),
        released=read.keys(),
        text=read.bytes(read.whole("<I")).decode("utf-8", "surrogatepass"),
        pointer=Pointer(read.vector(), read.vector(), read.vector(), read.vector(), *(read.words() for _ in range(3))),
        wheel=read.vector(),
        touches=read.several(read.touch),
        touch_events=read.several(read.touch),
        tilt=read.tilt(),
        pads=read.several(read.pad),
        sensors=read.several(read.sensor),
    )
    read.end()
    return inputs


def _put_words(out: bytearray, words: Iterable[str]) -> None:
    words = tuple(words)
    out += struct.pack("<H", len(words))
    for word in words:
        letters = word.encode("utf-8", "surrogatepass")
        out += struct.pack("<H", len(letters)) + letters


def _put_touch(out: bytearray, touch: Touch) -> None:
    _put_finger(out, touch.finger)
    out += struct.pack("<B?", PHASES.index(touch.phase), touch.cancelled)
    out += _VECTORS.pack(*touch.at, *touch.previous, *touch.pixel, *touch.previous_pixel)


def _put_finger(out: bytearray, finger: Finger) -> None:
    _put_words(out, (finger if isinstance(finger, str) else "", "" if isinstance(finger, str) else str(finger)))


def _put_reading(out: bytearray, reading: Reading | None) -> None:
    out += struct.pack("<?", reading is not None)
    if reading is not None:
        out += struct.pack("<3d", *reading)


class _Reader:
    """Takes bytes apart; whatever they are, nothing is raised but ValueError."""

    def __init__(self, data: bytes) -> None:
        self._data = data
        self._at = 0

    def bytes(self, count: int) -> bytes:
        part = self._data[self._at : self._at + count]
        if len(part) != count:
            raise ValueError("inputs are cut short")
        self._at += count
        return part

    def end(self) -> None:
        if self._at != len(self._data):
            raise ValueError("inputs are too long")

    def whole(self, layout: str) -> int:
        (value,) = struct.unpack(layout, self.bytes(struct.calcsize(layout)))
        return int(value)

    def flag(self) -> bool:
        value = self.whole("<B")
        if value > 1:
            raise ValueError("neither yes nor no")
        return value == 1

    def number(self) -> float:
        (value,) = struct.unpack("<d", self.bytes(8))
        if not math.isfinite(value):
            raise ValueError("a number that is none")
        return float(value)

    def vector(self) -> Vec2:
        return Vec2(self.number(), self.number())

    def three(self) -> Reading:
        return self.number(), self.number(), self.number()

    def words(self) -> tuple[str, ...]:
        return self.several(lambda: self.bytes(self.whole("<H")).decode("utf-8", "surrogatepass"))

    def keys(self) -> tuple[str, ...]:
        return tuple(key_name(word, "inputs", "key") for word in self.words())

    def several(self, one: Callable[[], T]) -> tuple[T, ...]:
        return tuple(one() for _ in range(self.whole("<H")))

    def finger(self) -> Finger:
        name, number = self.words()
        return int(number) if number else name

    def touch(self) -> Touch:
        finger, phase, cancelled = self.finger(), PHASES[self._below(len(PHASES))], self.flag()
        return Touch(finger, phase, self.vector(), self.vector(), self.vector(), self.vector(), cancelled)

    def tilt(self) -> Tilt:
        direction, changed, shaken = self.vector(), self.flag(), self.flag()
        return Tilt(direction, self.three() if self.flag() else None, changed, shaken)

    def pad(self) -> Pad:
        number, left, right = self.whole("<q"), self.vector(), self.vector()
        left_trigger, right_trigger = self.number(), self.number()
        name, *buttons = self.words() or ("",)
        return Pad(number, name, left, right, left_trigger, right_trigger, tuple(buttons))

    def sensor(self) -> SensorEvent:
        (name,) = self.words()
        return SensorEvent(name, self.three())

    def _below(self, limit: int) -> int:
        value = self.whole("<B")
        if value >= limit:
            raise ValueError("no such phase")
        return value
