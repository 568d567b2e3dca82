#!/usr/bin/env python3
"""Draw the pictures of the example "prototype2": python tools/draw_prototype2.py

Stone, wood and iron out of noise: value noise, summed over octaves, bent into grain, cracks and blocks, and lit from
the upper left by its own slope. The same numbers each time.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import numpy.typing as npt
from PIL import Image

FOLDER = Path(__file__).resolve().parent.parent / "src" / "evilengine" / "examples" / "prototype2"
Field = npt.NDArray[np.float64]
Rgb = tuple[float, float, float]


def noise(width: int, height: int, cell: float, seed: int, stretch: float = 1.0) -> Field:
    """Smooth noise from 0 to 1, with a bump each `cell` pixels, `stretch` times as long as high."""
    chance = np.random.default_rng(seed)
    total: Field = np.zeros((height, width), np.float64)
    weight = 0.0
    for octave in range(5):
        across, down = max(cell * stretch / 2**octave, 1.0), max(cell / 2**octave, 1.0)
        grid = chance.random((int(height / down) + 3, int(width / across) + 3))
        y, x = np.arange(height) / down, np.arange(width) / across
        j, i = y.astype(int), x.astype(int)
        v, u = y - j, x - i
        v, u = (v * v * (3 - 2 * v))[:, None], (u * u * (3 - 2 * u))[None, :]
        upper = grid[j][:, i] * (1 - u) + grid[j][:, i + 1] * u
        lower = grid[j + 1][:, i] * (1 - u) + grid[j + 1][:, i + 1] * u
        total = total + (upper * (1 - v) + lower * v) * 0.5**octave
        weight += 0.5**octave
    return np.asarray(total / weight, np.float64)


def relief(height: Field, strength: float) -> Field:
    """How light falls on a surface from the upper left: 1 where it is flat."""
    down, across = np.gradient(height)
    light: Field = np.asarray(1.0 + strength * (across + down), np.float64)
    return light


def edges(width: int, height: int, reach: float) -> Field:
    """0 on the rim of a picture, 1 farther in than `reach` pixels."""
    x = np.minimum(np.arange(width) + 0.5, width - np.arange(width) - 0.5)[None, :]
    y = np.minimum(np.arange(height) + 0.5, height - np.arange(height) - 0.5)[:, None]
    inside: Field = np.asarray(np.clip(np.minimum(x, y) / reach, 0.0, 1.0), np.float64)
    return inside


def blocks(width: int, height: int, wide: int, high: int, seed: int) -> tuple[Field, Field]:
    """Bricks in courses: how far in a pixel is from its brick's rim (0 to 1), and each brick's own shade."""
    y, x = np.indices((height, width)).astype(float)
    bent = 5.0 * (noise(width, height, 40, seed) - 0.5)
    course = np.floor((y + bent) / high)
    x = x + bent + wide / 2 * (course % 2)
    column = np.floor(x / wide)
    from_x = np.minimum(x - column * wide, (column + 1) * wide - x)
    from_y = np.minimum(y + bent - course * high, (course + 1) * high - y - bent)
    shade = np.random.default_rng(seed).random(4096)[((course * 57 + column * 13) % 4096).astype(int)]
    return np.clip(np.minimum(from_x, from_y) / 5.0, 0.0, 1.0), shade


def painted(colour: Rgb, light: Field, other: Rgb | None = None, share: Field | None = None) -> Field:
    """A colour in light, mixed with another by `share`."""
    base = np.array(colour)[None, None, :] * np.ones((*light.shape, 1))
    if other is not None and share is not None:
        base = base + (np.array(other) - base) * share[..., None]
    return base * light[..., None]


def save(name: str, rgb: Field) -> None:
    pixels = (np.clip(rgb, 0.0, 1.0) * 255.0 + 0.5).astype(np.uint8)
    image = Image.fromarray(pixels, "RGB").quantize(256, method=Image.Quantize.MEDIANCUT)
    Image.fromarray(pixels, "RGB").quantize(palette=image, dither=Image.Dither.FLOYDSTEINBERG).save(
        FOLDER / name, optimize=True
    )


def save_normals(name: str, height: Field) -> None:
    """Which way a surface faces whose points stand so many pixels out of the picture: red right, green up, blue out."""
    down, across = np.gradient(height)
    slope = np.dstack([-across, down, np.ones_like(height)])
    normal = slope / np.linalg.norm(slope, axis=2, keepdims=True)
    Image.fromarray((normal * 127.0 + 128.5).astype(np.uint8), "RGB").save(FOLDER / name, optimize=True)


def hall() -> None:
    """The wall behind it all: old bricks, two arched windows with a moon behind them, light falling in."""
    width, height = 960, 540
    rim, shade = blocks(width, height, 84, 34, 3)
    rough = noise(width, height, 60, 5)
    light = (0.55 + 0.35 * shade + 0.5 * (rough - 0.5)) * (0.45 + 0.55 * rim) * relief(6 * rim + 14 * rough, 0.18)
    wall = painted((0.20, 0.22, 0.30), light, (0.13, 0.20, 0.17), np.clip(2.2 * rough - 1.0, 0, 1))
    y, x = np.indices((height, width)).astype(float)
    glow = np.zeros((height, width))
    for middle in (300.0, 660.0):
        half, sill, spring = 62.0, 300.0, 150.0
        far = np.hypot(x - middle, y - spring)
        inside = np.where(y < spring, half - far, np.minimum(half - abs(x - middle), sill - y))
        frame = np.clip((inside + 16) / 3, 0, 1) * np.clip((3 - inside) / 3, 0, 1)
        stone = painted(
            (0.34, 0.35, 0.42), relief(8 * np.clip(inside + 16, 0, 16) + 10 * rough, 0.05) * (0.7 + 0.4 * rough)
        )
        wall += (stone - wall) * frame[..., None]
        pane = np.clip(inside / 2, 0, 1)
        bars = np.clip(np.minimum(abs(x - middle), abs((y - 60) % 72 - 36)) - 2.5, 0, 1)
        down = np.clip((y - 80) / 220, 0, 1)[..., None]
        sky = np.array((0.20, 0.30, 0.52)) * (1 - down) + np.array((0.62, 0.70, 0.82)) * down
        sky = sky * (0.75 + 0.5 * noise(width, height, 90, 9, 2.0))[..., None]
        wall += (sky * bars[..., None] - wall) * pane[..., None]
        slant = x - middle - 0.55 * (y - spring)  # a shaft of light, falling to the right
        beam = np.clip(1 - abs(slant) / (half + 0.12 * np.clip(y - spring, 0, None)), 0, 1)
        glow += beam**0.7 * np.clip((y - spring) / 120, 0, 1) * np.clip(1.25 - (y - spring) / 400, 0, 1)
    wall += (
        0.16 * glow[..., None] * np.array((0.75, 0.85, 1.0)) * (0.7 + 0.6 * noise(width, height, 120, 12))[..., None]
    )
    corner = ((x / width - 0.5) ** 2 + 0.8 * (y / height - 0.45) ** 2)[..., None]
    save("hall.png", wall * (1.12 - 1.1 * corner))


def beam(name: str, width: int, height: int, seed: int) -> None:
    """Dressed stone in one row: floor and shelves."""
    rim, shade = blocks(width, height, 96, height, seed)
    rough = noise(width, height, 26, seed + 1)
    light = (0.75 + 0.3 * shade + 0.6 * (rough - 0.5)) * (0.5 + 0.5 * rim) * relief(5 * rim + 10 * rough, 0.22)
    top = np.clip(1 - np.arange(height) / 9.0, 0, 1)[:, None]  # worn by feet, and lit
    moss = np.clip(3.2 * noise(width, height, 34, seed + 2) - 1.6 - 0.02 * np.arange(height)[:, None], 0, 1)
    save(name, painted((0.38, 0.39, 0.46), light + 0.35 * top, (0.26, 0.40, 0.22), moss))


def crate() -> None:
    side = 128
    grain = noise(side, side, 9, 21, 7.0)
    y, x = np.indices((side, side)).astype(float)
    plank = np.minimum(y % 25.6, 25.6 - y % 25.6)
    tone = np.random.default_rng(4).random(8)[(y / 25.6).astype(int)]
    light = (0.62 + 0.25 * tone + 0.55 * (grain - 0.5)) * np.clip(0.35 + plank / 4, 0, 1)
    rim = 64 * edges(side, side, 64.0)  # pixels from the rim
    frame = (rim < 20) | (abs(x - y) < 9)
    turned = np.where(abs(x - side / 2) > abs(y - side / 2), grain.T, grain)
    light = np.where(frame, 0.85 + 0.5 * (turned - 0.5), light)
    gap = np.clip(np.minimum(abs(rim - 20), np.where(rim < 20, 9, abs(abs(x - y) - 9))) / 2.5, 0.35, 1)
    light = light * gap * (0.45 + 0.55 * edges(side, side, 4.0)) * relief(14 * grain, 0.10)
    wood = painted((0.72, 0.47, 0.26), light)
    for at_x in (10, side - 11):
        for at_y in (10, side - 11):
            far = np.hypot(x - at_x, y - at_y)
            wood[far < 3.4] = np.array((0.55, 0.55, 0.58)) * (0.6 + 0.12 * (at_x - x + at_y - y + 6)[far < 3.4, None])
    save("crate.png", wood)


def boulder() -> None:
    side = 128
    y, x = np.indices((side, side)).astype(float)
    u, v = (x - 63.5) / 64, (y - 63.5) / 64
    z = np.sqrt(np.clip(1 - u * u - v * v, 0, 1))
    rough = noise(side, side, 26, 31)
    ridge = 1 - abs(2 * noise(side, side, 40, 33) - 1)  # where noise crosses its middle: cracks
    crack = np.clip((ridge - 0.93) / 0.05, 0, 1)
    light = (0.55 + 0.3 * z) * relief(16 * rough, 0.1) * (1 - 0.5 * crack)
    save_normals("boulder.normal.png", 50 * z + 16 * rough - 2 * crack)
    save(
        "boulder.png",
        painted((0.50, 0.48, 0.47), light * (0.7 + 0.6 * rough), (0.36, 0.42, 0.30), np.clip(2 * rough - 1, 0, 1)),
    )


def iron() -> None:
    side = 128
    y, x = np.indices((side, side)).astype(float)
    u, v = (x - 63.5) / 64, (y - 63.5) / 64
    far = np.hypot(u, v)
    rust = np.clip(2.6 * noise(side, side, 22, 41) - 1.2, 0, 1)
    ring = np.clip(1 - abs(far - 0.78) / 0.05, 0, 1)
    ball = 50 * np.sqrt(np.clip(1 - u * u - v * v, 0, 1))
    save_normals("iron.normal.png", ball - 3 * ring)
    light: Field = np.full((side, side), 0.8)
    light = light * (1 - 0.45 * ring) * (0.85 + 0.3 * noise(side, side, 7, 43))
    for spoke in range(8):
        angle = spoke * np.pi / 4 + 0.2
        bolt = np.hypot(u - 0.89 * np.cos(angle), v - 0.89 * np.sin(angle))
        light = np.where(bolt < 0.055, 1.05 - 3.0 * (u - 0.89 * np.cos(angle) + v - 0.89 * np.sin(angle)), light)
    save("iron.png", painted((0.42, 0.44, 0.50), light, (0.52, 0.27, 0.14), 0.8 * rust))


def rock() -> None:
    side = 128
    rough = noise(side, side, 30, 51)
    layers = 0.5 + 0.5 * np.sin(np.indices((side, side))[0] / 5.5 + 9 * noise(side, side, 60, 53))
    light = (
        (0.7 + 0.25 * layers + 0.5 * (rough - 0.5)) * relief(20 * rough, 0.14) * (0.7 + 0.3 * edges(side, side, 8.0))
    )
    save_normals("rock.normal.png", 20 * rough + 3 * layers)
    save("rock.png", painted((0.46, 0.44, 0.50), light, (0.62, 0.52, 0.40), np.clip(2.4 * layers * rough - 0.5, 0, 1)))


def plank() -> None:
    width, height = 256, 32
    grain = noise(width, height, 7, 61, 12.0)
    light = (0.7 + 0.7 * (grain - 0.5)) * (0.5 + 0.5 * edges(width, height, 3.0)) * relief(10 * grain, 0.12)
    save("plank.png", painted((0.62, 0.42, 0.25), light))


if __name__ == "__main__":
    FOLDER.mkdir(exist_ok=True)
    hall()
    beam("floor.png", 1000, 60, 71)
    beam("shelf.png", 300, 28, 81)
    for draw in (crate, boulder, iron, rock, plank):
        draw()
    for path in sorted(FOLDER.glob("*.png")):
        print(path.relative_to(FOLDER.parent), path.stat().st_size)
