"""How loud and from which side a sound is heard: distance, pan, and the gains that follow (SPEC S2)."""

from __future__ import annotations

import math
from dataclasses import dataclass

from evilengine._core import sincos  # the same bits on every machine
from evilengine.values.vec2 import Vec2

Gains = tuple[float, float, float, float]
"""Left to left, left to right, right to left, right to right; a sound with one channel uses the first two."""

NEAR = 5.0
"""Metres within which a sound is as loud as can be: half of what a screen shows. Beyond, it falls as 1/distance."""

FAR = 500.0
"""Metres beyond which a sound gets no softer: a hundredth, hardly heard."""


ORIGIN = Vec2(0.0, 0.0)


@dataclass(frozen=True, slots=True)
class Listener:
    """Where sounds are heard: in the middle of what the camera shows, turned as it is. Metres, radians."""

    position: Vec2 = ORIGIN
    angle: float = 0.0
    others: tuple[Listener, ...] = ()
    """Whoever hears as well, such as a second player: each sound is heard by the one who is nearest to it."""


def from_place(place: Vec2, listener: Listener) -> tuple[float, float]:
    """Loudness (1 near by) and pan (-1 left .. 1 right) of a sound at `place`.

    >>> from_place(Vec2(3.0, 0.0), Listener())[0], from_place(Vec2(-20.0, 0.0), Listener())[0]
    (1.0, 0.25)
    >>> from_place(Vec2(-20.0, 0.0), Listener(others=(Listener(Vec2(-20.0, 0.0)),)))
    (1.0, 0.0)
    """
    if listener.others:
        ways = [(place - each.position, each) for each in (listener, *listener.others)]
        _, listener = min(ways, key=lambda way: way[0].dot(way[0]))
    apart = place - listener.position
    if listener.angle:
        apart = apart.turned(-listener.angle)
    distance = math.sqrt(apart.x * apart.x + apart.y * apart.y)
    return NEAR / min(max(distance, NEAR), FAR), apart.x / (distance + NEAR)


def gains(volume: float, pan: float, channels: int) -> Gains:
    """Equal power at any pan. In the middle a sound with two channels stays as it is, one with one sounds as loud.

    >>> [round(gain, 3) for gain in gains(1.0, 0.0, 1)], [round(gain, 3) for gain in gains(1.0, 0.0, 2)]
    ([0.707, 0.707, 0.0, 0.0], [1.0, 0.0, 0.0, 1.0])
    """
    pan = max(-1.0, min(1.0, pan))
    if channels == 1:
        right, left = sincos((pan + 1.0) * math.pi / 4)
        return volume * left, volume * right, 0.0, 0.0
    share, rest = sincos(abs(pan) * math.pi / 2)  # the far side goes over to the near one
    kept, moved = volume * rest, volume * share
    return (volume, 0.0, moved, kept) if pan < 0 else (kept, moved, 0.0, volume)
