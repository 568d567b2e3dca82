"""Particles meet what is behind them as drawings do, in both renderers; bursts that end by themselves, and waiting."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from drawing_gl import any_driver
from test_particles import picture, quiet

import evilengine as evil
from evilengine.game import Game
from evilengine.values.image import Image


def blends(renderer: str, folder: Path) -> Game:
    """Each blend over three colours: soft specks, discs, and pictures in rows."""
    Image.of(2, 2, b"\xff\xc0\x60\xa0" * 4).save(folder / "leaf.png")
    game = quiet(renderer=renderer, folder=folder, gravity=(0, 0))
    for place, colour in enumerate(("#203040", "#c06030", "#e0e0e0")):
        game.draw(evil.Rectangle(4.8, 1.0), at=(0, 1 - place), colour=colour)
    for place, blend in enumerate(("normal", "add", "multiply", "screen")):
        for row, looks in enumerate(({}, {"soft": False}, {"texture": "leaf.png"})):
            at = (-1.8 + 1.2 * place, 1.0 - row)
            game.add_particles(at=at, size=1.1, speed=0, life=9, colour="#ffa040c0", blend=blend, burst=1, **looks)
    game.step(2)
    return game


def test_the_blends_of_particles_are_those_of_drawings(tmp_path: Path) -> None:
    game = quiet(gravity=(0, 0))
    game.add_background("#406080")
    for place, blend in enumerate(("normal", "add", "multiply", "screen")):
        looks: dict[str, Any] = {"at": (-1.5 + place, 0), "colour": "#ffa040c0", "blend": blend}
        game.draw(evil.Circle(0.4), **{**looks, "at": (-1.5 + place, 1)})
        game.add_particles(size=0.8, speed=0, soft=False, burst=1, **looks)
    seen = picture(game)
    for place in range(4):
        x = 120 + round(50 * (-1.5 + place))
        assert tuple(seen[80, x]) == tuple(seen[30, x])


def test_every_blend_is_the_same_in_both_renderers(tmp_path: Path) -> None:
    any_driver()
    soft, gl = (picture(blends(renderer, tmp_path)).astype(int) for renderer in ("soft", "gl"))
    assert np.abs(soft - gl).max() <= 2
    assert len(np.unique(soft.reshape(-1, 4), axis=0)) > 100


def test_an_emitter_of_one_burst_goes_with_its_last_particle() -> None:
    game = quiet()
    puff = game.add_particles(life=0.2, burst=30, once=True)
    assert (puff.count, puff.rate) == (30, 0)
    game.step(10)
    assert puff.alive
    game.step(5)
    assert not puff.alive
    assert game.scene.emitters == ()


def test_one_that_does_not_run_waits() -> None:
    game = quiet()
    emitter = game.add_particles(rate=60, running=False)
    game.step(30)
    assert emitter.count == 0
    emitter.running = True
    game.step(30)
    assert emitter.count > 0
