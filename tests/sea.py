"""Games with water as it is seen: particles put where a picture wants them, on either renderer."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

import evilengine as evil

SIZE = 0.1  # metres between particles
AREA = (-4.0, -2.5, 4.0, 2.5)

Place = Callable[[Any, Any], Any]
"""Which of these columns and rows, metres, hold liquid."""


def pool(x: Any, y: Any) -> Any:
    return y < -0.5 + 0 * x


def wave(x: Any, y: Any) -> Any:
    return y < -1.0 + 1.2 * np.exp(-(((x + 1.5) / 0.8) ** 2)) + 0.12 * np.sin(3 * x)


def jet(x: Any, y: Any) -> Any:
    """A pool, a jet of three particles, one of a single particle, a ball and drops."""
    thick = abs(y - (1.6 - 0.25 * (x + 3.2) ** 2)) < 0.15
    thin = abs(y - (2.2 - 0.1 * (x + 1.0) ** 2)) < 0.051
    ball = (x - 2.6) ** 2 + (y - 0.6) ** 2 < 0.4**2
    drops = (np.round(x / SIZE - 0.5) % 9 == 4) & (np.round(y / SIZE - 0.5) % 9 == 4) & (x > 0.8) & (y > -1)
    return (y < -1.8) | (thick & (x > -3.2) & (x < 1)) | (thin & (x > -2.5) & (x < 2.5)) | ball | drops


def scenery(game: evil.Game, lit: bool = False) -> None:
    """Stripes behind, a floor and a rock, and what swims."""
    game.scene.background = "#1c2436"
    for place in range(17):
        game.draw(
            evil.Rectangle(0.22, 5), at=(-4 + 0.5 * place, 0), colour="#3a4a6b" if place % 2 else "#5a4a3a",
            lit=lit, layer=-1,
        )  # fmt: skip
    game.add(evil.Rectangle(8, 0.6), at=(0, -2.4), kind="static", colour="#4a5068")
    game.add(evil.Rectangle(0.8, 1.6), at=(2.9, -1.6), angle=0.3, kind="static", colour="#4a5068")
    game.add(evil.Rectangle(0.8, 0.8), at=(-2.4, -0.5), angle=0.15, colour="#f2a65a")
    game.add(evil.Circle(0.35), at=(0.6, -1.2), colour="#7aa7f7")


def pour(game: evil.Game, place: Place, *, noise: float = 0.0, **options: Any) -> evil.Water:
    """Water in the game where `place` says, each particle off its place by up to `noise` of the spacing."""
    water = game.add_water(AREA, particle_size=SIZE, open_sides="top", **options)
    columns = np.arange(AREA[0] + SIZE / 2, AREA[2], SIZE)
    rows = np.arange(AREA[1] + SIZE / 2, AREA[3], SIZE)
    x, y = (each.ravel() for each in np.meshgrid(columns, rows))
    inside = place(x, y)
    for left, bottom in np.stack([x[inside], y[inside]], axis=-1) - SIZE / 2:
        water.fill((left, bottom, left + SIZE, bottom + SIZE))
    positions = np.asarray(water.positions)
    positions += np.random.default_rng(1).uniform(-noise, noise, positions.shape) * SIZE
    return water


def game_of(renderer: str = "soft", size: tuple[int, int] = (320, 200)) -> evil.Game:
    """A game as large as the area of its water."""
    game = evil.Game(headless=True, size=size, renderer=renderer, view_height=5)
    game.scene.background = "#1c2436"
    return game


def pixels(game: evil.Game) -> Any:
    return np.asarray(game.capture().pixels)[..., :3].astype(int)
