"""Pictures with normals and with what glows, for tests, and a scene of them."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import numpy.typing as npt
import PIL.Image

import evilengine as evil

FLAT = (128, 128, 255)


def write(path: Path, pixels: npt.ArrayLike) -> None:
    """A picture of (rows, columns, 3 or 4) levels."""
    PIL.Image.fromarray(np.asarray(pixels).astype(np.uint8)).save(path)


def plain(path: Path, colour: tuple[int, ...], size: int = 16) -> None:
    """A picture of one colour."""
    write(path, np.full((size, size, len(colour)), colour))


def normal_colour(x: float, y: float) -> tuple[int, int, int]:
    """The colour of a normal whose parts across and up are these."""
    z = (1.0 - x * x - y * y) ** 0.5
    return (round(x * 127 + 128), round(y * 127 + 128), round(z * 127 + 128))


def dome(folder: Path, size: int = 64) -> None:
    """`dome.png`, a light disc, and its normals, as of half a ball."""
    y, x = np.mgrid[1 : -1 : size * 1j, -1 : 1 : size * 1j]
    inside = x * x + y * y < 1.0
    z = np.sqrt(np.where(inside, 1.0 - x * x - y * y, 0.0))
    alpha = np.where(inside, 255, 0)
    write(folder / "dome.normal.png", np.dstack([np.round(np.dstack([x, y, z]) * 127 + 128), alpha]))
    write(folder / "dome.png", np.dstack([np.full((size, size, 3), 210), alpha]))


def bricks(folder: Path) -> None:
    """`bricks.png`, 64 x 64, and its normals: each brick bulges a little."""
    row, column = np.mgrid[0:64, 0:64]
    across, down = (column + np.where(row // 16 % 2, 16, 0)) % 32 / 16.0 - 1.0, row % 16 / 8.0 - 1.0
    slope = np.dstack([0.6 * across**5, -0.6 * down**5, np.ones((64, 64))])
    normal = slope / np.linalg.norm(slope, axis=2, keepdims=True)
    joint = (np.abs(across) > 0.9) | (np.abs(down) > 0.8)
    write(folder / "bricks.normal.png", np.round(normal * 127 + 128))
    write(folder / "bricks.png", np.where(joint[..., None], (96, 90, 84), (168, 150, 132)))


def hut(folder: Path) -> None:
    """`hut.png` and `hut.glow.png`: two windows with light in them."""
    walls, light = np.full((32, 32, 4), (110, 90, 80, 255)), np.zeros((32, 32, 4))
    for left in (6, 19):
        walls[8:22, left : left + 7] = (60, 60, 70, 255)
        light[8:22, left : left + 7] = (255, 200, 90, 255)
    write(folder / "hut.png", walls)
    write(folder / "hut.glow.png", light)


def surfaces(folder: Path, renderer: str = "soft") -> evil.Game:
    """A wall of bricks, domes turned and mirrored, a hut and two coals, between a warm and a cold lamp."""
    dome(folder), bricks(folder), hut(folder)
    game = evil.Game("Surfaces", size=(320, 180), headless=True, renderer=renderer, gravity=(0, 0), folder=folder)
    game.camera.view_height = 9
    game.draw(evil.Rectangle(18, 10), texture="bricks.png", tile=2, lit=True, layer=-1)
    for number in range(3):
        turned = game.draw(evil.Circle(0.9), at=(-4 + 4 * number, -2), angle=0.7 * number, texture="dome.png", lit=True)
        turned.flip_x = number == 1
    game.draw(evil.Rectangle(2, 2), at=(5.5, 2.5), texture="hut.png", lit=True)
    game.draw(evil.Circle(0.25), at=(-5.5, 2.8), colour="#ff7733", lit=True, glow=1)
    game.draw(evil.Circle(0.25), at=(5, -3.2), colour="#5599ff80", lit=True, glow=3)
    game.add(evil.Rectangle(0.6, 1.6), at=(0, 1.2), kind="static", colour="#445566", lit=True)
    game.ambient = 0.08
    game.add_light(at=(-4, 1.5), colour="#ffb070", radius=9, intensity=1.3)
    game.add_light(at=(4, -1), colour="#7090ff", radius=9, intensity=1.3)
    return game
