"""Sprites on the graphics card: boxes drawn by a shader of their own, as `soft` draws them."""

from __future__ import annotations

import math
import random

import numpy as np
import pytest
from drawing import Pixels, place, sprite
from drawing_gl import any_driver, difference, picture, unit_square

from evilengine import _core
from evilengine.renderer.gl import GlRenderer
from evilengine.renderer.gl.moderngl_device import ModernGlDevice
from evilengine.renderer.soft import SoftRenderer
from evilengine.values.drawlist import DrawList
from evilengine.values.image import Image

SIZE = (320, 240)
GREY = 0xFF302018

ROUNDED = 2
"""Levels of 255 by which both renderers may round apart: `soft` measures in 1/256 pixel."""

FILTERED = 4
"""The same for textures at any scale: the card's filter has 8 bits for how near a texel is, and noise jumps by 255."""


@pytest.fixture(scope="module")
def device() -> ModernGlDevice:
    return any_driver()


@pytest.fixture
def gl(device: ModernGlDevice) -> GlRenderer:
    return GlRenderer(device)


def only_sprites(gl: GlRenderer) -> bool:
    """The last frame was one draw call of the sprite shader, and nothing went to the other."""
    return gl.draw_calls == 1 and len(gl._pipeline._batcher.quads) == 0


def both(gl: GlRenderer, content: _core.DrawList, images: tuple[Image, ...] = ()) -> tuple[Pixels, Pixels]:
    soft = SoftRenderer()
    for image in images:
        assert gl.upload(image) == soft.upload(image)
    frame = DrawList(SIZE, GREY, content)
    return picture(gl, frame), picture(soft, frame)


def grid(content: _core.DrawList, texture: int, scale: float, stretch: float = 1.0, tint: int = 0xFFFFFFFF) -> None:
    """Boxes that touch nobody, each turned by another angle, at another part of a pixel."""
    square, dice = unit_square(content), random.Random(5)
    step = 1.5 * scale * max(stretch, 1.0) + 4.0
    columns, rows = max(int(SIZE[0] / step), 1), max(int(SIZE[1] / step), 1)
    for number in range(max(columns * rows, 40)):
        at = (number % columns + 0.5) * step + dice.random(), (number // columns % rows + 0.5) * step + dice.random()
        a, b, c, d, x, y = place(*at, scale, dice.uniform(0, math.tau))
        c, d = stretch * c, stretch * d
        matrix = a, b, c, d, x - 0.5 * (a + c), y - 0.5 * (b + d)
        content.instance(square, matrix, texture=texture, tint=tint)
        if number == columns * rows - 1 and number >= 20:
            return


@pytest.mark.parametrize("stretch", [1.0, 0.3, 2.5])
@pytest.mark.parametrize("scale", [6.0, 11.0, 33.0])
def test_boxes_cover_exactly_the_pixels_that_they_should_with_their_corners(
    gl: GlRenderer, scale: float, stretch: float
) -> None:
    content = _core.DrawList()
    grid(content, 0, scale, stretch)
    found, expected = both(gl, content)
    assert only_sprites(gl)
    assert difference(found, expected) <= ROUNDED


@pytest.mark.parametrize("scale", [8.0, 21.0, 40.0, 90.0])
def test_pictures_of_opaque_noise_are_alike_at_all_scales_and_angles(gl: GlRenderer, scale: float) -> None:
    image, content = Image.of(32, 32, sprite(3, 32, 32).tobytes()), _core.DrawList()
    grid(content, 1, scale, tint=0xC0FFE0C0)
    found, expected = both(gl, content, (image,))
    assert only_sprites(gl)
    assert difference(found, expected) <= FILTERED
    assert np.abs(found.astype(int) - expected).mean() < 0.2


def disc(side: int, margin: float) -> Image:
    """White within a soft edge; so many texels at its sides are clear."""
    away = np.hypot(*(np.mgrid[0:side, 0:side] - (side - 1) / 2))
    pixels = np.full((side, side, 4), 255, np.uint8)
    pixels[..., 3] = np.clip(255 * (side / 2 - margin - away + 0.5), 0, 255)
    return Image.of(side, side, pixels.tobytes())


@pytest.mark.parametrize("margin", [0.0, 1.0, 2.0, 6.0])
@pytest.mark.parametrize("scale", [13.0, 32.0, 45.0])
def test_what_is_clear_at_its_sides_needs_no_edges_and_nobody_sees_it(
    gl: GlRenderer, scale: float, margin: float
) -> None:
    content = _core.DrawList()
    grid(content, 1, scale)
    found, expected = both(gl, content, (disc(32, margin),))
    assert only_sprites(gl)
    assert difference(found, expected) <= 2


def test_pictures_that_are_mirrored_cut_out_and_turned_are_alike(gl: GlRenderer) -> None:
    image, content = Image.of(24, 16, sprite(8, 24, 16).tobytes()), _core.DrawList()
    square = unit_square(content)
    part = content.polygon([(0, 0), (1, 0), (1, 1), (0, 1)], uvs=[(0.25, 0.5), (0.5, 0.5), (0.5, 0.75), (0.25, 0.75)])
    matrices = [(-1, 0, 0, 1, 1, 0), (1, 0, 0, -1, 0, 1), (0.5, 0, 0, 0.5, 0.25, 0.1), (0, 1, 1, 0, 0, 0)]
    matrices.append(place(0.5, 0.1, 0.5, 0.6))
    for number in range(40):
        at = place(30 + 40 * (number % 7), 25 + 38 * (number // 7), 20.0, 0.3 * number)
        content.instance(
            part if number % 3 == 0 else square, at, texture=1, to_texture=matrices[number % len(matrices)]
        )
    found, expected = both(gl, content, (image,))
    assert only_sprites(gl)
    assert difference(found, expected) <= FILTERED


def test_the_order_of_painting_is_kept_between_sprites_and_everything_else(gl: GlRenderer) -> None:
    content, dice = _core.DrawList(), random.Random(2)
    square, ball = unit_square(content), content.circle(6.0)
    for run in (40, 3, 17, 1, 15, 16):
        for _ in range(run):
            at = dice.uniform(0, 60), dice.uniform(0, 60)
            content.instance(square, place(*at, 20, dice.uniform(0, 6)), tint=dice.randrange(1 << 24) | 0xFF000000)
        content.instance(ball, place(dice.uniform(0, 60), dice.uniform(0, 60)), tint=0x80FFFFFF)
    found, expected = both(gl, content)
    assert gl.draw_calls == 6, "40, what follows it, 17, what follows it with 15, 16, and the last ball"
    assert difference(found, expected) <= 8, "dozens of half-covered edges on each other, each rounded"


def test_sprites_add_multiply_and_screen_as_others_do(gl: GlRenderer) -> None:
    content = _core.DrawList()
    square = unit_square(content)
    for blend in range(4):
        for number in range(20):
            at = place(10 + 15 * number, 20 + 50 * blend, 22, 0.2 * number)
            content.instance(square, at, tint=0x60FF8040, blend=blend)
    found, expected = both(gl, content)
    assert gl.draw_calls == 3, "what adds goes along with what covers"
    assert difference(found, expected) <= 3


@pytest.mark.parametrize("matrix", [
    (30, 0, 12, 30, 50, 50),  # askew
    (30, 0, 0, 1.2, 50, 50),  # thin
    (30, 0, 0, 0, 50, 50),  # flat
    (9e4, 0, 0, 9e4, -4e4, -4e4),  # immense
])  # fmt: skip
def test_boxes_that_are_no_sprites_are_drawn_all_the_same(gl: GlRenderer, matrix: tuple[float, ...]) -> None:
    content = _core.DrawList()
    square = unit_square(content)
    for _ in range(20):
        content.instance(square, matrix)
    found, expected = both(gl, content)
    assert len(gl._pipeline._batcher.sprites) == 0
    assert difference(found, expected) <= ROUNDED


def test_a_picture_that_repeats_or_is_large_is_drawn_from_its_own_texture(gl: GlRenderer) -> None:
    images = (Image.of(8, 8, sprite(1, 8, 8).tobytes()), Image.of(600, 4, sprite(2, 600, 4).tobytes()))
    content = _core.DrawList()
    square = unit_square(content)
    for number in range(20):
        content.instance(square, place(20 + 12 * number, 40, 16), texture=1, to_texture=(3, 0, 0, 3, 0, 0))
        content.instance(square, place(20 + 12 * number, 90, 16), texture=2)
    found, expected = both(gl, content, images)
    assert len(gl._pipeline._batcher.sprites) == 0
    assert difference(found, expected) <= FILTERED
