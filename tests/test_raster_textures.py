"""Textures of the software renderer: exact where they can be, means where not."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from drawing import (
    BLACK,
    Pixels,
    picture,
    place,
    sprite,
)

from evilengine import _core
from evilengine.renderer.soft import SoftRenderer
from evilengine.values.drawlist import DrawList
from evilengine.values.errors import ArgumentError
from evilengine.values.image import Image


def textured(pixels: Pixels, to_pixel: tuple[float, ...], size: tuple[int, int], **kwargs: object) -> Pixels:
    """The picture on the unit square, whose v runs down as the target's y does."""
    raster, content = _core.Raster(), _core.DrawList()
    texture = raster.upload(pixels.tobytes(), pixels.shape[1], pixels.shape[0])
    unit = [(0, 0), (1, 0), (1, 1), (0, 1)]
    content.instance(content.polygon(unit, uvs=unit), to_pixel, texture=texture, **kwargs)
    return picture(content, size, raster)


def test_a_texture_at_its_own_size_is_copied_exactly() -> None:
    pixels = sprite(1, 21, 13)
    assert (textured(pixels, (21, 0, 0, 13, 4, 3), (40, 20))[3:16, 4:25] == pixels).all()


def test_a_texture_half_a_pixel_off_is_the_mean_of_neighbours() -> None:
    pixels = sprite(2, 20, 12).astype(int)
    found = textured(pixels.astype(np.uint8), (20, 0, 0, 12, 4.5, 3), (40, 20))[3:15, 5:24].astype(int)
    assert np.abs(found - (pixels[:, :-1] + pixels[:, 1:]) / 2).max() <= 1


@pytest.mark.parametrize(("matrix", "change"), [
    ((0, 16, -16, 0, 20, 4), lambda p: np.rot90(p, -1)),
    ((-16, 0, 0, -16, 20, 20), lambda p: np.rot90(p, 2)),
    ((-16, 0, 0, 16, 20, 4), np.fliplr),
])  # fmt: skip
def test_a_texture_turned_by_quarters_is_exact(matrix: tuple[float, ...], change: Callable[[Pixels], Pixels]) -> None:
    pixels = sprite(3, 16, 16)
    assert (textured(pixels, matrix, (24, 24))[4:20, 4:20] == change(pixels)).all()


def test_the_far_side_of_a_picture_does_not_bleed_into_its_edge() -> None:
    pixels = np.zeros((4, 4, 4), np.uint8)
    pixels[..., 3] = 255
    pixels[0] = 255  # a white top row over black
    found = textured(pixels, (64, 0, 0, 64, 0, 0), (64, 64))
    assert (found[56:, :, 0] == 0).all()
    assert (found[:8, :, 0] == 255).all()


def test_a_texture_matrix_beyond_the_picture_repeats_it() -> None:
    pixels = sprite(4, 8, 8)
    found = textured(pixels, (32, 0, 0, 32, 0, 0), (32, 32), to_texture=(4, 0, 0, 4, 0, 0))
    assert (found == np.tile(pixels, (4, 4, 1))).all()


def test_a_texture_matrix_scrolls() -> None:
    pixels = sprite(5, 16, 16)
    found = textured(pixels, (16, 0, 0, 16, 0, 0), (16, 16), to_texture=(1, 0, 0, 1, 0.25, 0.5))
    assert (found == np.roll(pixels, (-8, -4), axis=(0, 1))).all()


@pytest.mark.parametrize("size", [(64, 64), (63, 41)])
def test_a_picture_drawn_small_is_the_mean_of_all_its_pixels(size: tuple[int, int]) -> None:
    pixels = sprite(6, *size)
    found = textured(pixels, (1, 0, 0, 1, 0, 0), (1, 1))[0, 0].astype(int)
    assert np.abs(found - pixels.reshape(-1, 4).mean(axis=0)).max() <= 3


def test_a_fine_checkerboard_drawn_at_a_third_is_grey_and_does_not_shimmer() -> None:
    board = np.indices((96, 96)).sum(axis=0) % 2 * 255
    pixels = np.dstack([board, board, board, np.full_like(board, 255)]).astype(np.uint8)
    found = textured(pixels, (32, 0, 0, 32, 2.3, 1.7), (40, 40))[4:32, 5:32, 0].astype(int)
    assert np.abs(found - 127.5).max() <= 2


def test_transparent_texels_leave_no_fringe() -> None:
    pixels = np.zeros((8, 8, 4), np.uint8)
    pixels[:, :, 1] = 255  # bright green where nothing can be seen
    pixels[2:6, 2:6] = (255, 0, 0, 255)
    found = textured(pixels, (80, 0, 0, 80, 0, 0), (80, 80))
    assert found[..., 1].max() == 0


def test_tint_multiplies_a_texture() -> None:
    pixels = np.full((4, 4, 4), 255, np.uint8)
    assert tuple(textured(pixels, (8, 0, 0, 8, 0, 0), (8, 8), tint=0xFF204080)[4, 4]) == (0x80, 0x40, 0x20, 255)


def test_a_circle_shows_the_middle_of_its_texture() -> None:
    raster, content = _core.Raster(), _core.DrawList()
    pixels = sprite(7, 32, 32)
    texture = raster.upload(pixels.tobytes(), 32, 32)
    content.instance(content.circle(1.0), (16, 0, 0, -16, 16, 16), texture=texture)  # y up, as in the world
    assert (picture(content, (32, 32), raster)[8:24, 8:24] == pixels[8:24, 8:24]).all()


def test_texture_ids_are_never_given_out_twice() -> None:
    renderer = SoftRenderer()
    red, green = (Image.of(1, 1, bytes(colour)) for colour in ((255, 0, 0, 255), (0, 255, 0, 255)))
    first = renderer.upload(red)
    renderer.release(first)
    second = renderer.upload(green)
    assert second not in (0, first)
    content = _core.DrawList()
    square = content.polygon([(0, 0), (8, 0), (8, 8), (0, 8)])
    content.instance(square, texture=first)
    content.instance(square, place(8, 0), texture=second)
    content.instance(square, place(16, 0), texture=4_000_000_000)
    renderer.draw(DrawList((24, 8), BLACK, content))
    found = renderer.capture().pixels
    assert [tuple(found[4, x, c] for c in range(3)) for x in (4, 12, 20)] == [(255,) * 3, (0, 255, 0), (255,) * 3]
    renderer.update(second, red)
    renderer.draw(DrawList((24, 8), BLACK, content))
    assert tuple(renderer.capture().pixels[4, 12, c] for c in range(3)) == (255, 0, 0)
    for use in (renderer.release, lambda texture: renderer.update(texture, red)):
        with pytest.raises(ArgumentError, match=f"texture={first} is not one"):
            use(first)
