"""Whatever is done to a picture, one thing after the other, both renderers do the same to it."""

from __future__ import annotations

import random
from pathlib import Path

import numpy as np
import pytest
from drawing_gl import any_driver

import evilengine as evil
from evilengine.game import Game
from evilengine.values.image import Image

WIDTH, HEIGHT = 160, 96


def noise(folder: Path) -> None:
    """A picture of soft and hard changes: what is smooth shows where levels are lost, what is not shines."""
    down, across = np.mgrid[:HEIGHT, :WIDTH]
    pixels = np.full((HEIGHT, WIDTH, 4), 255, np.uint8)
    pixels[..., 0] = 40 + across * 80 // WIDTH
    pixels[..., 1] = 30 + down * 60 // HEIGHT
    pixels[..., 2] = 20 + (across + down) * 70 // (WIDTH + HEIGHT)
    sparks = np.random.default_rng(4).integers(0, [HEIGHT, WIDTH], size=(60, 2))
    pixels[sparks[:, 0], sparks[:, 1], :3] = 255
    pixels[30:50, 100:130, :3] = (255, 214, 120)
    Image.of(WIDTH, HEIGHT, pixels.tobytes()).save(folder / "noise.png")


def stacked(renderer: str, folder: Path, seed: int, **post: object) -> np.ndarray:
    """The same picture, pixel by pixel, behind a stack of effects that `seed` chooses."""
    chances = random.Random(seed)
    game = Game("Stack", size=(WIDTH, HEIGHT), headless=True, renderer=renderer, folder=folder, seed=1)
    game.sprite("noise.png", size=(WIDTH / 50, HEIGHT / 50), layer=-3)
    if chances.random() < 0.7:
        game.layers[-3].blur = chances.uniform(0.5, 30)
    if chances.random() < 0.7:
        game.layers[-2].shafts.at = (chances.uniform(-1, 1), chances.uniform(-1, 1))
        game.layers[-2].shafts.strength = chances.uniform(0.3, 2)
        game.layers[-2].fog = "#8fa3b840"
    if chances.random() < 0.5:
        game.layers[-1].blur = chances.uniform(0.5, 4)
    game.post.bloom, game.post.bloom_threshold = chances.choice((0.3, 1, 3)), chances.choice((0.2, 0.6))
    for name, value in post.items():
        setattr(game.post, name, value)
    game.step(3)
    return np.asarray(game.capture().pixels).astype(int)


@pytest.mark.parametrize("seed", range(8))
def test_blur_shafts_and_bloom_one_over_the_other_are_the_same_in_both_renderers(tmp_path: Path, seed: int) -> None:
    any_driver()
    noise(tmp_path)
    soft, gl = (stacked(renderer, tmp_path, seed) for renderer in ("soft", "gl"))
    assert np.abs(soft - gl).max() <= 1


@pytest.mark.parametrize("seed", range(8, 14))
def test_steep_tones_over_a_stack_bring_no_difference_to_light(tmp_path: Path, seed: int) -> None:
    any_driver()
    noise(tmp_path)
    steep = {"exposure": 1.6, "contrast": 1.5, "saturation": 1.4, "vignette": 0.4, "grain": 0.03}
    soft, gl = (stacked(renderer, tmp_path, seed, tone_mapping="filmic", **steep) for renderer in ("soft", "gl"))
    assert np.abs(soft - gl).max() <= 2
    assert (soft != gl).mean() < 0.02


def test_a_picture_that_is_blurred_widely_keeps_its_light(tmp_path: Path) -> None:
    any_driver()
    for renderer in ("soft", "gl"):
        game = Game("Even", size=(WIDTH, HEIGHT), headless=True, renderer=renderer, folder=tmp_path)
        game.add_background("#13579b")
        game.draw(evil.Circle(0.1), at=(9, 9), layer=-2)
        game.layers[-2].blur = 200
        shown = np.asarray(game.capture().pixels)[..., :3]
        assert (shown == (0x13, 0x57, 0x9B)).all()
