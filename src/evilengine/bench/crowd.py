"""The crowd of `evil bench draw`: the same sprites for everybody who draws them."""

from __future__ import annotations

import random
from typing import NamedTuple

from evilengine.values.image import Image

SIZE = (1280, 720)
SIDE = 32  # pixels of a sprite
METRE = 50.0  # pixels


class Sprite(NamedTuple):
    """Where it begins, in pixels from the lower left, and how it goes: pixels and radians a second."""

    x: float
    y: float
    vx: float
    vy: float
    spin: float


def crowd(count: int, *, turning: bool) -> list[Sprite]:
    """The same sprites for everybody."""
    dice = random.Random(count)
    return [
        Sprite(
            dice.uniform(0, SIZE[0]),
            dice.uniform(0, SIZE[1]),
            dice.uniform(-60, 60),
            dice.uniform(-60, 60),
            dice.uniform(-3, 3) if turning else 0.0,
        )
        for _ in range(count)
    ]


def picture() -> Image:
    """What all of them show: a disc with soft edges on nothing."""
    middle = (SIDE - 1) / 2
    pixels = bytearray()
    for y in range(SIDE):
        for x in range(SIDE):
            away = ((x - middle) ** 2 + (y - middle) ** 2) ** 0.5
            pixels += bytes((255 - 6 * y, 120 + 4 * x, 90, max(0, min(255, round(255 * (middle - away))))))
    return Image.of(SIDE, SIDE, pixels)
