"""The graphics card's renderer: the pictures of `soft`, in few draw calls, and a way out when the driver fails.

It is tested on whatever driver there is; one that plays a graphics card on the processor will do.
"""

from __future__ import annotations

import gc
import math
import random
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from drawing import BLACK, GREEN, RED, Points, place, sprite, star
from drawing_gl import any_driver, difference, picture, sprites, unit_square
from golden_scenes import SCENES

import evilengine as evil
from evilengine import _core
from evilengine.renderer.gl import GlRenderer, moderngl_device
from evilengine.renderer.gl.moderngl_device import ModernGlDevice
from evilengine.renderer.soft import SoftRenderer
from evilengine.values.drawlist import DrawList
from evilengine.values.errors import ArgumentError
from evilengine.values.image import Image

CLOSE = 3
"""Levels of 255 that a pixel of one thing may differ from `soft`: both round, and textures are filtered to 8 bits."""

PILED = 10
"""The same where dozens of half-clear things lie on each other, and each rounds again."""

SPRITES = 5000


@pytest.fixture(scope="module")
def device() -> ModernGlDevice:
    return any_driver()


@pytest.fixture
def gl(device: ModernGlDevice) -> GlRenderer:
    return GlRenderer(device)


def like_soft(gl: GlRenderer, content: _core.DrawList, size: tuple[int, int], images: tuple[Image, ...] = ()) -> int:
    """How far the picture is from that of `soft`."""
    soft = SoftRenderer()
    for image in images:
        assert gl.upload(image) == soft.upload(image)
    frame = DrawList(size, 0xFF302018, content)
    return difference(picture(gl, frame), picture(soft, frame))


# ---- the same pictures ----


@pytest.mark.parametrize("name", SCENES)
def test_the_golden_pictures_of_soft_come_out_alike(gl: GlRenderer, name: str) -> None:
    soft = SoftRenderer()
    expected = picture(soft, SCENES[name](soft.upload))
    found = picture(gl, SCENES[name](gl.upload))
    assert difference(found, expected) <= CLOSE
    assert np.abs(found.astype(int) - expected).mean() < 0.1


def zoo(seed: int, upload: Any) -> DrawList:
    """Everything at once: fills, strokes, textures, at all sizes and places; ten textures, so that batches end."""
    rnd, content = random.Random(seed), _core.DrawList()
    textures = [upload(Image.of(13, 9, sprite(seed + number, 13, 9).tobytes())) for number in range(10)]
    meshes = [
        content.circle(5.0, colour=0xFF80C0FF),
        content.polygon(star(4, 9, 4)),
        content.polygon([(-8, -8), (8, -8), (8, 8), (-8, 8)], uvs=[(0, 0), (2, 0), (2, 1), (0, 1)]),
        content.polygon(star(60, 90, 70)),
    ]
    for _ in range(40):
        content.instance(
            rnd.choice(meshes),
            place(rnd.uniform(-10, 170), rnd.uniform(-10, 130), rnd.choice([0.05, 0.6, 1, 2.5]), rnd.uniform(0, 6)),
            tint=rnd.randrange(1 << 32),
            texture=rnd.choice([0, *textures]),
            outline=rnd.choice([0.0, 0.0, 0.0, 0.7, 3.0]),
            to_texture=place(rnd.uniform(-2, 2), rnd.uniform(-2, 2), rnd.choice([0.3, 1.0, 7.0]), rnd.uniform(0, 6)),
        )
    return DrawList((160, 120), 0xFF302018, content)


@pytest.mark.parametrize("seed", range(4))
def test_whatever_is_piled_up_comes_out_alike(device: ModernGlDevice, seed: int) -> None:
    soft, gl = SoftRenderer(), GlRenderer(device)
    expected, found = picture(soft, zoo(seed, soft.upload)), picture(gl, zoo(seed, gl.upload))
    assert difference(found, expected) <= PILED
    assert gl.draw_calls > 1


def test_a_large_intricate_shape_is_cut_into_cells_that_nobody_sees(gl: GlRenderer) -> None:
    for outline, angle in ((0.0, 0.3), (3.0, 0.3), (40.0, 0.1)):
        content = _core.DrawList()
        content.instance(content.polygon(star(150, 240, 180)), place(250.3, 190.7, 1.0, angle), outline=outline)
        assert like_soft(gl, content, (400, 300)) <= CLOSE, (outline, angle)


@pytest.mark.parametrize("scale", [1.0, 300.0, 1e5, 3e7])
def test_an_edge_is_where_it_should_be_however_far_the_camera_goes_in(gl: GlRenderer, scale: float) -> None:
    content = _core.DrawList()
    corner: Points = [(0, 0), (1000, 300), (900, 900), (-200, 1000)]
    content.instance(content.polygon(corner), (scale, 0, 0, scale, 20.25, 14.5))
    content.instance(content.circle(50.0), (scale, 0, 0, scale, 45 + 50 * scale, 20), tint=0x8040FFC0)
    assert like_soft(gl, content, (96, 64)) <= CLOSE


@pytest.mark.parametrize("radius", [0.2, 0.7, 1.5, 2.9, 3.1, 8.0, 40.0, 300.0])
def test_circles_of_every_size_are_round(gl: GlRenderer, radius: float) -> None:
    content = _core.DrawList()
    disc = content.circle(radius)
    for number in range(8):
        content.instance(disc, place(15.1 * number, 11.3 + 0.13 * number), tint=0xC0FFFFFF)
        content.instance(disc, (1, 0.3, -0.1, 0.4, 15.1 * number, 40 + 0.17 * number), tint=0xC0FFFFFF)
        content.instance(disc, place(15.1 * number, 70 + 0.13 * number), outline=0.5 + number)
    assert like_soft(gl, content, (120, 90)) <= CLOSE


def test_thin_and_tiny_polygons_keep_their_share_of_each_pixel(gl: GlRenderer) -> None:
    content = _core.DrawList()
    needle, speck = content.polygon([(0, 0), (60, 0.3), (60, 0.7)]), content.polygon(star(7, 0.4, 0.2))
    for number in range(12):
        content.instance(needle, place(30, 30, 1.0, 0.5 * number))
        content.instance(speck, place(70 + 2.3 * number, 10.4))
        content.instance(needle, (1, 1e-4, -1e-4, 1e-8, 70, 20.3 + 3 * number))  # all but flat
    assert like_soft(gl, content, (100, 60)) <= CLOSE


@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf, 3e38])
def test_what_is_nowhere_draws_nothing(gl: GlRenderer, value: float) -> None:
    content = _core.DrawList()
    square, disc = content.polygon([(0, 0), (9, 0), (9, 9)]), content.circle(3.0)
    for mesh in (square, disc):
        content.instance(mesh, (1, 0, 0, 1, value, 0))
        content.instance(mesh, (value, 0, 0, 1, 4, 4), outline=2.0)
    content.instance(square, (1, 0, 0, 1, 3, 3), outline=math.nan)
    assert picture(gl, DrawList((16, 16), BLACK, content))[..., :3].sum() == 0


def test_a_clear_background_stays_clear(gl: GlRenderer) -> None:
    content = _core.DrawList()
    content.instance(content.polygon([(0, 0), (8, 0), (8, 16), (0, 16)]), tint=0x80FF8040)
    gl.draw(DrawList((16, 16), 0, content))
    found = gl.capture().pixels
    assert tuple(found[4, 12, c] for c in range(4)) == (0, 0, 0, 0)
    assert np.abs(np.array([found[4, 4, c] for c in range(4)]) - (0x40, 0x80, 0xFF, 0x80)).max() <= 1


# ---- textures ----


def test_a_texture_at_its_own_size_is_copied_exactly(gl: GlRenderer) -> None:
    pixels, content = sprite(1, 21, 13), _core.DrawList()
    texture = gl.upload(Image.of(21, 13, pixels.tobytes()))
    content.instance(unit_square(content), (21, 0, 0, 13, 4, 3), texture=texture)
    assert (picture(gl, DrawList((40, 20), BLACK, content))[3:16, 4:25] == pixels).all()


@pytest.mark.parametrize("size", [(64, 64), (63, 41), (1, 5), (200, 3)])
def test_pictures_of_any_size_are_alike_when_drawn_small_and_large(gl: GlRenderer, size: tuple[int, int]) -> None:
    image, content = Image.of(*size, sprite(6, *size).tobytes()), _core.DrawList()
    square = unit_square(content)
    for number in range(20):
        side = 1.5**number / 4
        content.instance(square, (side, 0.1, -0.1, 0.7 * side, 9 * number % 60, 5), texture=1, tint=0xC0FFFFFF)
    assert like_soft(gl, content, (64, 64), (image,)) <= PILED


def test_the_far_side_of_a_picture_does_not_bleed_into_its_edge(gl: GlRenderer) -> None:
    pixels = np.zeros((4, 4, 4), np.uint8)
    pixels[..., 3] = 255
    pixels[0] = 255
    texture, content = gl.upload(Image.of(4, 4, pixels.tobytes())), _core.DrawList()
    content.instance(unit_square(content), (64, 0, 0, 64, 0, 0), texture=texture)
    found = picture(gl, DrawList((64, 64), BLACK, content))
    assert (found[56:, :, 0] == 0).all()
    assert (found[:8, :, 0] == 255).all()


def test_a_texture_matrix_repeats_and_scrolls(gl: GlRenderer) -> None:
    pixels, content = sprite(4, 8, 8), _core.DrawList()
    texture = gl.upload(Image.of(8, 8, pixels.tobytes()))
    content.instance(unit_square(content), (32, 0, 0, 32, 0, 0), texture=texture, to_texture=(4, 0, 0, 4, 0.25, 0.5))
    found = picture(gl, DrawList((32, 32), BLACK, content))
    assert (found == np.roll(np.tile(pixels, (4, 4, 1)), (-4, -2), axis=(0, 1))).all()


def test_textures_are_updated_released_and_never_mistaken_for_each_other(gl: GlRenderer) -> None:
    red, green = (Image.of(1, 1, bytes(colour)) for colour in ((255, 0, 0, 255), (0, 255, 0, 255)))
    first = gl.upload(red)
    gl.release(first)
    second = gl.upload(green)
    assert second not in (0, first)
    content = _core.DrawList()
    square = content.polygon([(0, 0), (8, 0), (8, 8), (0, 8)])
    content.instance(square, texture=first)
    content.instance(square, place(8, 0), texture=second)
    content.instance(square, place(16, 0), texture=4_000_000_000)
    found = picture(gl, DrawList((24, 8), BLACK, content))
    assert [tuple(found[4, x, :3]) for x in (4, 12, 20)] == [(255,) * 3, (0, 255, 0), (255,) * 3]
    gl.update(second, red)
    assert tuple(picture(gl, DrawList((24, 8), BLACK, content))[4, 12, :3]) == (255, 0, 0)
    for use in (gl.release, lambda texture: gl.update(texture, red)):
        with pytest.raises(ArgumentError, match=f"texture={first} is not one"):
            use(first)


def test_a_picture_too_large_for_the_card_is_held_smaller(device: ModernGlDevice, monkeypatch: Any) -> None:
    monkeypatch.setattr(device, "most_pixels", 64)
    gl, content = GlRenderer(device), _core.DrawList()
    pixels = np.zeros((10, 200, 4), np.uint8)
    pixels[:, :100], pixels[:, 100:] = (255, 0, 0, 255), (0, 0, 255, 255)
    texture = gl.upload(Image.of(200, 10, pixels.tobytes()))
    content.instance(unit_square(content), (60, 0, 0, 20, 0, 0), texture=texture)
    found = picture(gl, DrawList((60, 20), BLACK, content))
    assert tuple(found[10, 10]) == (255, 0, 0, 255)
    assert tuple(found[10, 50]) == (0, 0, 255, 255)


# ---- what goes to the card, and what is held there ----


def test_thousands_of_sprites_are_one_draw_call_and_two_uploads_the_first_of_which_is_not_repeated(
    gl: GlRenderer, monkeypatch: Any
) -> None:
    writes: list[str] = []
    for name in ("_Buffer", "_Texture"):
        kind = getattr(moderngl_device, name)

        def write(self: Any, *args: Any, real: Any = kind.write, name: str = name, **options: Any) -> None:
            writes.append(name)
            real(self, *args, **options)

        monkeypatch.setattr(kind, "write", write)
    texture = gl.upload(Image.of(4, 4, sprite(1, 4, 4).tobytes()))
    writes.clear()
    content = sprites([texture], SPRITES)
    for expected in (["_Buffer", "_Texture"], ["_Buffer"], ["_Buffer"]):
        gl.draw(DrawList((64, 48), BLACK, content))
        assert (gl.draw_calls, writes) == (1, expected)
        writes.clear()


def test_everything_is_given_back_when_a_renderer_is_closed_or_forgotten(device: ModernGlDevice) -> None:
    device = any_driver()  # one of its own: what other tests left is given back at a time of Python's choosing
    assert device.counts() == {}
    for close in (True, False):
        gl = GlRenderer(device)
        kept = [gl.upload(Image.of(5, 3, sprite(number, 5, 3).tobytes())) for number in range(5)]
        gl.update(kept[0], Image.of(2, 2, bytes(16)))
        gl.release(kept[1])
        for size in ((30, 20), (60, 40)):
            content = sprites(kept, 50)
            for number in range(400):  # more meshes than one row of the data texture holds
                content.instance(content.polygon(star(3 + number % 4, 5, 2)), place(number % 60, 9), outline=1.0)
            gl.draw(DrawList(size, BLACK, content))
        assert device.counts() == {"buffers": 2, "targets": 1, "textures": 4 + 3}, "pictures, target, shapes, atlas"
        if close:
            gl.close()
        del gl
        gc.collect()
        with device:
            assert device.counts() == {}


def test_views_of_an_earlier_frame_keep_their_picture(gl: GlRenderer) -> None:
    content = _core.DrawList()
    gl.draw(DrawList((8, 4), RED, content))
    small, captured = gl.pixels, gl.capture()
    assert (small.shape, small.readonly) == ((4, 8, 4), True)
    gl.draw(DrawList((16, 9), GREEN, content))
    assert gl.pixels.shape == (9, 16, 4)
    assert bytes(small[0, 0, c] for c in range(4)) == b"\xff\0\0\xff"
    assert captured.tobytes() == b"\xff\0\0\xff" * 32


@pytest.mark.parametrize("size", [(0, 5), (5, -1), (1_000_000, 5)])
def test_a_target_of_impossible_size_is_refused(gl: GlRenderer, size: tuple[int, int]) -> None:
    with pytest.raises(ArgumentError, match=r"DrawList\.size"):
        gl.draw(DrawList(size, BLACK, _core.DrawList()))


# ---- a game ----


def test_a_game_draws_alike_on_the_card_and_in_software() -> None:
    pictures = []
    for renderer in ("gl", "soft"):
        game = evil.Game("Drawn twice", size=(320, 200), headless=True, renderer=renderer)
        game.add(evil.Rectangle(6, 0.5), at=(0, -1.5), kind="static", colour="slategray")
        game.add(evil.Polygon([(0, 0), (2, 0), (2, 2), (1, 0.6), (0, 2)]), at=(-2, 0), colour="tomato")
        game.add(evil.Circle(0.5), at=(1, 1), colour="gold")
        game.text("Evil", at=(10, 10), size=20)
        game.debug = True
        game.step(30)
        pictures.append(np.array(game.capture().pixels))
        if renderer == "gl" and game.renderer.name == "soft":
            pytest.skip("no driver draws without a window")
        game.close()
    assert difference(*pictures) <= PILED


def test_borders_of_a_picture_shown_small_are_the_same_on_the_card_and_in_software(tmp_path: Path) -> None:
    """Rows that only touch a slice are coloured by the slice that they lie in."""
    across = 5 * np.indices((48, 48))
    chequers = 127 + 128 * ((across[0] // 25 + across[1] // 25) % 2)
    Image.of(48, 48, np.dstack([*across, chequers, np.full((48, 48), 255)]).astype(np.uint8).tobytes()).save(
        tmp_path / "frame.png"
    )
    pictures = []
    for renderer in ("gl", "soft"):
        game = evil.Game(size=(64, 48), headless=True, renderer=renderer, folder=tmp_path, view_height=2.4)
        game.sprite("frame.png", size=(0.9, 0.6), slice=10)
        pictures.append(np.array(game.capture().pixels))
        if renderer == "gl" and game.renderer.name == "soft":
            pytest.skip("no driver draws without a window")
    assert difference(*pictures) <= CLOSE
