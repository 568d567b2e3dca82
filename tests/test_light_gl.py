"""Light on the graphics card: the pictures of `soft`."""

from __future__ import annotations

import numpy as np
import pytest
from drawing_gl import any_driver
from lighting import lamps_and_shadows

from evilengine.renderer.gl import GlRenderer
from evilengine.renderer.soft import SoftRenderer

CLOSE = 3
"""Levels of 255 that a pixel of something lit may differ from `soft`: light and colour are each rounded once more."""


@pytest.fixture
def gl() -> GlRenderer:
    return GlRenderer(any_driver())


@pytest.mark.parametrize("quality", ["low", "medium", "high"])
def test_a_lit_scene_looks_as_soft_draws_it(gl: GlRenderer, quality: str) -> None:
    game = lamps_and_shadows()
    game.lights.quality = quality
    frame = game._collect()
    soft = SoftRenderer()
    soft.draw(frame)
    gl.draw(frame)
    found, expected = np.array(gl.pixels).astype(int), np.array(soft.pixels).astype(int)
    assert np.abs(found - expected).max() <= CLOSE
    assert expected[..., 0].std() > 20, "there is light and shadow"


def test_a_light_map_is_given_back(gl: GlRenderer) -> None:
    before = gl.device.counts()
    other = GlRenderer(gl.device)
    other.draw(lamps_and_shadows()._collect())
    other.close()
    assert gl.device.counts() == before


def test_what_is_not_lit_keeps_its_pixels(gl: GlRenderer) -> None:
    game = lamps_and_shadows()
    for drawing in game.walls:
        drawing.lit = False
    for body in game.world.bodies:
        for drawing in body.drawings:
            drawing.lit = False
    gl.draw(game._collect())
    dark = bytes(gl.pixels)
    game.lights.clear()
    gl.draw(game._collect())
    assert bytes(gl.pixels) == dark
