"""Small pictures packed into pages: nobody's texels are lost, mixed or mistaken, whatever comes and goes."""

from __future__ import annotations

import random

import numpy as np
import pytest
from drawing import BLACK, Pixels, place, sprite
from drawing_gl import any_driver, difference, picture, unit_square
from hypothesis import given, settings
from hypothesis import strategies as st

from evilengine import _core
from evilengine.renderer.gl import GlRenderer
from evilengine.renderer.gl import atlas as atlases
from evilengine.renderer.gl.atlas import GUTTER, LARGEST, Skyline
from evilengine.renderer.gl.moderngl_device import ModernGlDevice
from evilengine.renderer.soft import SoftRenderer
from evilengine.values.drawlist import DrawList
from evilengine.values.image import Image

MANY = 20
"""Sprites enough in a row to be drawn from the atlas."""


@pytest.fixture
def device() -> ModernGlDevice:
    return any_driver()


@settings(deadline=None)
@given(st.lists(st.tuples(st.integers(1, 40), st.integers(1, 40)), max_size=60), st.integers(0, 60))
def test_rectangles_on_a_page_never_overlap_and_never_leave_it(sizes: list[tuple[int, int]], grow_at: int) -> None:
    page = Skyline(48)
    taken = np.zeros((96, 96), bool)
    for number, (width, height) in enumerate(sizes):
        if number == grow_at:
            page.grow()
        corner = page.take(width, height)
        if corner is None:
            continue
        left, low = corner
        assert left >= 0
        assert low >= 0
        assert left + width <= page.side
        assert low + height <= page.side
        part = taken[low : low + height, left : left + width]
        assert not part.any()
        part[:] = True


def test_equal_tiles_fill_a_page_to_the_last_texel() -> None:
    page = Skyline(64)
    assert all(page.take(16, 16) for _ in range(16))
    assert page.take(1, 1) is None
    page.grow()
    assert all(page.take(16, 16) for _ in range(48))


def noise(seed: int, width: int, height: int) -> Image:
    return Image.of(width, height, sprite(seed, width, height).tobytes())


def shown(renderer: GlRenderer | SoftRenderer, textures: list[int], sizes: list[tuple[int, int]]) -> Pixels:
    """Each picture at its own size, one below the other in columns."""
    content = _core.DrawList()
    square, x, y, widest = unit_square(content), 1, 1, 0
    for texture, (width, height) in zip(textures, sizes, strict=True):
        if y + height > 255:
            x, y, widest = x + widest + 1, 1, 0
        content.instance(square, (width, 0, 0, height, x, y), texture=texture)
        y, widest = y + height + 1, max(widest, width)
    return picture(renderer, DrawList((640, 256), BLACK, content))


def test_pictures_keep_their_texels_while_pages_grow_and_others_come_and_go(device: ModernGlDevice) -> None:
    gl, soft, dice = GlRenderer(device), SoftRenderer(), random.Random(4)
    held: dict[int, tuple[int, int]] = {}
    for turn in range(6):
        for number in range(40):
            size = dice.randrange(2, 60), dice.randrange(2, 60)
            image = noise(100 * turn + number, *size)
            texture = gl.upload(image)
            assert texture == soft.upload(image)
            held[texture] = size
        for texture in dice.sample(sorted(held), MANY):
            gl.release(texture)
            soft.release(texture)
            del held[texture]
        for texture in dice.sample(sorted(held), 5):
            held[texture] = dice.randrange(2, 60), dice.randrange(2, 60)
            image = noise(texture, *held[texture])
            gl.update(texture, image)
            soft.update(texture, image)
        some = dice.sample(sorted(held), min(len(held), 60))
        sizes = [held[texture] for texture in some]
        assert (shown(gl, some, sizes) == shown(soft, some, sizes)).all()
        assert gl.draw_calls == 1
    assert gl._pipeline._atlas.page(0).size[0] > atlases.FIRST_SIDE, "it grew"


def test_what_was_dropped_is_room_again_once_it_is_much(
    device: ModernGlDevice, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(atlases, "MOST_SIDE", 512)
    gl = GlRenderer(device)
    kept = [gl.upload(noise(number, 30, 30)) for number in range(MANY)]
    for number in range(300):
        gl.release(gl.upload(noise(number, 100, 90)))
    assert device.counts()["textures"] <= MANY + 1 + 2, (
        "the pictures' own, the data texture, and no more than two pages"
    )
    sizes = [(30, 30)] * MANY
    soft = SoftRenderer()
    for number in range(MANY):
        soft.upload(noise(number, 30, 30))
    assert (shown(gl, kept, sizes) == shown(soft, kept, sizes)).all()


def test_more_than_a_page_holds_takes_another_page_and_another_draw_call(
    device: ModernGlDevice, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(atlases, "MOST_SIDE", 512)
    gl = GlRenderer(device)
    textures = [gl.upload(noise(number, 200, 200)) for number in range(5)]
    content = _core.DrawList()
    square = unit_square(content)
    for texture in textures:
        for number in range(MANY):
            content.instance(square, place(10 + 3 * number, 10 * texture, 8), texture=texture)
    gl.draw(DrawList((80, 80), BLACK, content))
    assert gl.draw_calls == 2, "four fit on the first page"
    assert len(gl._pipeline._batcher.sprites) > 0


@pytest.mark.parametrize("scale", [0.2, 0.45, 0.9, 1.7, 6.0])
def test_neighbours_in_the_atlas_do_not_bleed_into_each_other(device: ModernGlDevice, scale: float) -> None:
    gl = GlRenderer(device)
    white, black = Image.of(10, 10, b"\xff" * 400), Image.of(10, 10, b"\0\0\0\xff" * 100)
    textures = [gl.upload(white if number % 2 else black) for number in range(40)]
    content = _core.DrawList()
    square = unit_square(content)
    for number in range(MANY):
        at = place(40 + 70 * (number % 5), 40 + 70 * (number // 5), 10 * scale, 0.31 * number)
        content.instance(square, at, texture=textures[2 * number % 40 + 1])
    found = picture(gl, DrawList((400, 320), 0xFFFFFFFF, content))
    assert gl.draw_calls == 1
    assert (found == 255).all(), "white on white"


def test_a_changed_picture_changes_in_place_and_a_larger_one_moves(device: ModernGlDevice) -> None:
    gl, soft = GlRenderer(device), SoftRenderer()
    textures = [gl.upload(noise(number, 20, 20)) for number in range(MANY)]
    for number in range(MANY):
        soft.upload(noise(number, 20, 20))
    sizes = [(20, 20)] * MANY
    for number, size in ((3, (20, 20)), (4, (31, 17)), (5, (LARGEST + 1, 3)), (5, (9, 9))):
        for renderer in (gl, soft):
            renderer.update(textures[number], noise(50 + number, *size))
        sizes[number] = size if size[0] <= LARGEST else (20, 20)
        found, expected = shown(gl, textures, sizes), shown(soft, textures, sizes)
        assert difference(found, expected) <= (0 if size[0] <= LARGEST else 40), "smaller copies of noise, once"


def test_a_picture_stands_in_a_frame_like_its_edge() -> None:
    texels = np.arange(24, dtype=np.uint8).reshape(2, 3, 4)
    found = np.frombuffer(atlases.framed(texels.tobytes(), 3, 2, GUTTER), np.uint8).reshape(6, 7, 4)
    assert (found == np.pad(texels, ((GUTTER, GUTTER), (GUTTER, GUTTER), (0, 0)), mode="edge")).all()
