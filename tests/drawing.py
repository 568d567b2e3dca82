"""Drawing small pictures with the software renderer, for its tests."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from evilengine import _core

BLACK, WHITE, RED, GREEN, BLUE = 0xFF000000, 0xFFFFFFFF, 0xFF0000FF, 0xFF00FF00, 0xFFFF0000
TURN = 6.283185307179586

Pixels = npt.NDArray[np.uint8]
Cover = npt.NDArray[np.int64]
Points = list[tuple[float, float]]


def picture(
    content: _core.DrawList, size: tuple[int, int], raster: _core.Raster | None = None, **options: Any
) -> Pixels:
    pixels = bytearray(size[0] * size[1] * 4)
    (raster or _core.Raster()).draw(content, pixels, *size, **options)
    return np.frombuffer(bytes(pixels), np.uint8).reshape(size[1], size[0], 4)


def coverage(content: _core.DrawList, size: tuple[int, int]) -> Cover:
    """White on black: how much of each pixel is covered, 0..255."""
    return picture(content, size)[..., 0].astype(np.int64)


def filled(points: Points, size: tuple[int, int]) -> Cover:
    content = _core.DrawList()
    content.instance(content.polygon(points))
    return coverage(content, size)


def place(x: float, y: float, scale: float = 1.0, angle: float = 0.0) -> tuple[float, ...]:
    """A matrix for DrawList.instance; the engine's own sine, so that golden pictures do not depend on a machine's."""
    sine, cosine = _core.sincos(angle)
    return (scale * cosine, scale * sine, -scale * sine, scale * cosine, x, y)


def star(tips: int, outer: float, inner: float) -> Points:
    corners = []
    for i in range(2 * tips):
        sine, cosine = _core.sincos(i * TURN / (2 * tips))
        radius = outer if i % 2 else inner
        corners.append((radius * cosine, radius * sine))
    return corners


def sprite(seed: int, width: int, height: int) -> Pixels:
    """An opaque picture of noise."""
    pixels = np.random.default_rng(seed).integers(0, 256, (height, width, 4), dtype=np.uint8)
    pixels[..., 3] = 255
    return pixels
