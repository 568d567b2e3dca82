"""Scenes with lights for tests, and the exact answer to how much of a light a point sees."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

import evilengine as evil
from evilengine import _core

Floats = npt.NDArray[np.float64]

GAMMA = 64 / 29
"""What core/light/light_map.hpp takes for the screen's."""


def lit_game(size: tuple[int, int] = (320, 180), **options: Any) -> evil.Game:
    """A game at 50 points a metre with a white wall that is lit behind everything."""
    game = evil.Game("Light", size=size, headless=True, renderer="soft", gravity=(0, 0), **options)
    game.draw(evil.Rectangle(200, 200), colour="white", lit=True, layer=-1, outline=False)
    game.ambient = 0
    return game


def light_of(game: evil.Game) -> tuple[Floats, Floats]:
    """The frame's light: (rows, columns, 3) linear, and where in the world each texel's middle lies."""
    content = game._collect().content
    found = _core.light_map(content)
    assert found is not None, "nothing is lit"
    width, height, step, x, y, (texels, *_) = found
    factors = np.frombuffer(texels, np.float16).reshape(height, width, 4)[..., :3].astype(np.float64)
    columns, rows = np.meshgrid(x + step * np.arange(width), y + step * np.arange(height))
    places = np.stack([columns - game.camera.size[0] / 2, game.camera.size[1] / 2 - rows], axis=-1) / 50.0
    return factors**GAMMA, places + np.array(game.camera.position)


def seen(point: Floats, middle: Floats, size: float, shapes: list[Floats], rays: int = 500) -> float:
    """The share of a lamp, a disc seen as a line across, that no convex polygon hides from the point: by many rays."""
    way = middle - point
    across = np.array([-way[1], way[0]]) / np.hypot(*way)
    ends = middle + across * size * (2 * (np.arange(rays) + 0.5)[:, None] / rays - 1)
    hidden = np.zeros(rays, bool)
    for corners in shapes:
        for a, b in zip(corners, np.roll(corners, -1, axis=0), strict=True):
            ray, edge = ends - point, b - a
            cross = ray[:, 0] * edge[1] - ray[:, 1] * edge[0]
            cross = np.where(cross == 0, 1e-12, cross)
            along = ((a - point)[0] * edge[1] - (a - point)[1] * edge[0]) / cross
            beside = ((a - point)[0] * ray[:, 1] - (a - point)[1] * ray[:, 0]) / cross
            hidden |= (along > 0) & (along < 1) & (beside >= 0) & (beside <= 1)
    return 1.0 - hidden.mean()


def corners_of(body: evil.Body, sides: tuple[float, float]) -> Floats:
    """The world corners of a rectangle."""
    half = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]) * np.array(sides) / 2
    c, s = np.cos(body.angle), np.sin(body.angle)
    return half @ np.array([[c, s], [-s, c]]) + np.array(body.position)


def circle_corners(body: evil.Body, radius: float) -> Floats:
    """A circle as many corners."""
    turn = np.arange(96) * 2 * np.pi / 96
    return np.array(body.position) + radius * np.stack([np.cos(turn), np.sin(turn)], axis=-1)


class Lamplight(evil.Game):
    """What the golden picture shows: a wall, a floor, crates, balls and a plank, lit by two lamps and a spot."""

    def __init__(self) -> None:
        super().__init__("Lamplight", size=(320, 180), headless=True, renderer="soft", gravity=(0, 0))
        self.camera.view_height = 9
        back = self.draw(evil.Rectangle(20, 12), colour="#8a7f74", lit=True, layer=-1, outline=False)
        self.walls = [back]
        self.add(evil.Rectangle(19, 1.2), at=(0, -4.2), kind="static", colour="#6b7a5c", lit=True)
        self.add(evil.Rectangle(1.2, 1.2), at=(-2, -3), angle=0.3, colour="#b98b5a", lit=True)
        self.add(evil.Rectangle(1, 1), at=(-5, 0), colours=["#c98", "#b98b5a", "#a64", "#dba"], lit=True)
        self.add(evil.Circle(0.7), at=(2.5, -1), colour="#c0504d", lit=True)
        self.add(evil.Circle(0.3), at=(4.5, 2), colour="#4d80c0", lit=True)
        self.add(evil.Rectangle(0.25, 3), at=(0.8, 1.4), angle=-0.4, colour="#9a9a9a", lit=True)
        self.add(evil.Rectangle(1.2, 0.2, rounding=0.1), at=(5.5, -2), colour="#9a9a9a", lit=True)
        self.add(evil.Circle(0.25), at=(-6.5, 3.2), colour="#ffffff")  # not lit
        self.ambient = 0.06
        self.add_light(at=(-1.5, 1.5), temperature=2700, radius=9, size=0.35, intensity=2)
        self.add_light(at=(6, 3), colour="#86a8ff", radius=8, size=0.15, intensity=1.5)
        self.add_light(at=(-6.5, 3.2), direction=(1, -3), cone=0.7, colour="#d0ffb0", radius=10, intensity=1.2)


def lamps_and_shadows() -> Lamplight:
    """That game, with its first frame due."""
    return Lamplight()
