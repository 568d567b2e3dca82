"""Pictures and fonts: found, decoded once, and clear errors for files that are not what they should be."""

from __future__ import annotations

import contextlib
import struct
import zlib
from pathlib import Path

import numpy as np
import PIL.Image
import pytest

from evilengine.assets import Fonts, Images
from evilengine.assets.images import MAX_PIXELS, MAX_SIDE
from evilengine.values.errors import ArgumentError, ArgumentTypeError, AssetError, Error
from evilengine.values.image import Image


def pixel(image: Image, x: int, y: int) -> tuple[int, ...]:
    return tuple(int(image.pixels[y, x, c]) for c in range(4))


@pytest.fixture
def art(tmp_path: Path) -> Path:
    PIL.Image.new("RGBA", (5, 3), (10, 20, 30, 40)).save(tmp_path / "crate.png")
    return tmp_path


# ---- images ----


def test_an_image_is_found_by_name_and_decoded_once(art: Path) -> None:
    images = Images(art)
    crate = images.load("crate.png")
    assert crate.size == (5, 3)
    assert pixel(crate, 4, 2) == (10, 20, 30, 40)
    assert images.load("crate.png") is crate
    assert images.load(art / "crate.png") is crate
    assert images.load("./crate.png") is crate


def test_folders_are_searched_in_order(art: Path) -> None:
    (art / "high").mkdir()
    PIL.Image.new("RGB", (9, 9)).save(art / "high" / "crate.png")
    PIL.Image.new("RGB", (2, 2)).save(art / "ball.png")
    images = Images(art / "high", art)
    assert images.load("crate.png").size == (9, 9)
    assert images.load("ball.png").size == (2, 2)


def test_a_forgotten_image_is_decoded_anew(art: Path) -> None:
    images = Images(art)
    images.load("crate.png")
    PIL.Image.new("RGB", (7, 7)).save(art / "crate.png")
    assert images.load("crate.png").size == (5, 3)
    images.forget("crate.png")
    assert images.load("crate.png").size == (7, 7)


@pytest.mark.parametrize("ending", ["png", "jpg", "webp", "gif", "bmp", "tga", "tiff"])
def test_common_formats_are_read(tmp_path: Path, ending: str) -> None:
    PIL.Image.new("RGB", (8, 8), (200, 100, 50)).save(tmp_path / f"a.{ending}")
    found = pixel(Images(tmp_path).load(f"a.{ending}"), 4, 4)
    assert np.abs(np.subtract(found, (200, 100, 50, 255))).max() <= 4


@pytest.mark.parametrize(
    ("mode", "colour", "expected"),
    [
        ("1", 1, (255, 255, 255, 255)),
        ("L", 77, (77, 77, 77, 255)),
        ("LA", (77, 128), (77, 77, 77, 128)),
        ("I;16", 0x8000, (128, 128, 128, 255)),
        ("CMYK", (0, 0, 0, 0), (255, 255, 255, 255)),
        ("F", 0.5, (127, 127, 127, 255)),
    ],
)
def test_every_colour_mode_becomes_straight_rgba(
    tmp_path: Path, mode: str, colour: float | tuple[int, ...], expected: tuple[int, ...]
) -> None:
    PIL.Image.new(mode, (4, 4), colour).save(tmp_path / "a.tiff")
    found = pixel(Images(tmp_path).load("a.tiff"), 1, 1)
    assert np.abs(np.subtract(found, expected)).max() <= 1


def test_sixteen_bits_of_a_png_become_eight(tmp_path: Path) -> None:
    values = np.array([[0, 0x00FF, 0x4000, 0xFFFF]], np.uint16)
    PIL.Image.fromarray(values).save(tmp_path / "deep.png")
    assert [pixel(Images(tmp_path).load("deep.png"), x, 0)[0] for x in range(4)] == [0, 0, 0x40, 0xFF]


def test_a_palette_keeps_its_transparent_colour(tmp_path: Path) -> None:
    picture = PIL.Image.new("P", (2, 1))
    picture.putpalette([255, 0, 0, 0, 255, 0])
    picture.putdata([0, 1])
    picture.save(tmp_path / "a.png", transparency=1)
    image = Images(tmp_path).load("a.png")
    assert pixel(image, 0, 0) == (255, 0, 0, 255)
    assert pixel(image, 1, 0)[3] == 0


def test_a_photo_taken_sideways_stands_upright(tmp_path: Path) -> None:
    exif = PIL.Image.Exif()
    exif[0x0112] = 6  # the camera was turned: rows run downwards on the left
    PIL.Image.new("RGB", (8, 4), "white").save(tmp_path / "a.jpg", exif=exif)
    assert Images(tmp_path).load("a.jpg").size == (4, 8)


def test_the_first_frame_of_an_animation_counts(tmp_path: Path) -> None:
    frames = [PIL.Image.new("RGB", (4, 4), colour) for colour in ("red", "lime")]
    frames[0].save(tmp_path / "a.gif", save_all=True, append_images=frames[1:])
    assert pixel(Images(tmp_path).load("a.gif"), 0, 0) == (255, 0, 0, 255)


def test_a_missing_image_is_named_with_its_folder_and_the_nearest_name(art: Path) -> None:
    with pytest.raises(AssetError, match=r"image 'carte\.png': there is no such file in .*did you mean 'crate\.png'"):
        Images(art).load("carte.png")
    with pytest.raises(OSError, match="no such file"):
        Images(art).load("nowhere/crate.png")


@pytest.mark.parametrize(
    ("name", "data", "reason"),
    [
        ("text.png", b"once upon a time", "no picture that can be read .*once upon"),
        ("empty.png", b"", "it is empty"),
        ("vector.svg", b"<svg xmlns='http://www.w3.org/2000/svg'/>", "no picture that can be read"),
        ("program.eps", b"%!PS-Adobe-3.0 EPSF-3.0\n%%BoundingBox: 0 0 9 9\n", "no picture that can be read"),
    ],
)
def test_a_file_that_is_no_picture_says_so(tmp_path: Path, name: str, data: bytes, reason: str) -> None:
    (tmp_path / name).write_bytes(data)
    with pytest.raises(AssetError, match=f"image '{name}' .*{reason}"):
        Images(tmp_path).load(name)


@pytest.mark.parametrize("ending", ["png", "jpg", "webp", "gif", "bmp"])
@pytest.mark.parametrize("part", [0.1, 0.5, 0.95])
def test_a_picture_cut_short_is_an_error_that_names_it(tmp_path: Path, ending: str, part: float) -> None:
    whole = tmp_path / f"whole.{ending}"
    PIL.Image.fromarray(np.random.default_rng(1).integers(0, 256, (64, 64, 3), dtype=np.uint8)).save(whole)
    (tmp_path / f"cut.{ending}").write_bytes(whole.read_bytes()[: int(part * whole.stat().st_size)])
    with pytest.raises(AssetError, match=rf"image 'cut\.{ending}'"):
        Images(tmp_path).load(f"cut.{ending}")


@pytest.mark.parametrize("ending", ["png", "jpg", "webp", "gif", "tiff"])
def test_damaged_pictures_raise_nothing_but_asset_errors(tmp_path: Path, ending: str) -> None:
    file = tmp_path / f"a.{ending}"
    PIL.Image.fromarray(np.random.default_rng(2).integers(0, 256, (40, 40, 3), dtype=np.uint8)).save(file)
    data, rng = file.read_bytes(), np.random.default_rng(3)
    for _ in range(60):
        damaged = bytearray(data)
        for at in rng.integers(0, min(len(data), 400), 4):
            damaged[at] = rng.integers(256)
        file.write_bytes(damaged)
        with contextlib.suppress(AssetError):
            assert Images(tmp_path).load(file.name).size > (0, 0)


def png_header(width: int, height: int) -> bytes:
    def chunk(name: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))

    header = chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0))
    return b"\x89PNG\r\n\x1a\n" + header + chunk(b"IDAT", zlib.compress(bytes(1000))) + chunk(b"IEND", b"")


@pytest.mark.parametrize("size", [(MAX_SIDE + 1, 1), (9000, 9000), (16000, 16000), (100_000, 100_000), (2**31 - 1, 5)])
def test_a_picture_too_large_for_memory_is_refused_before_it_is_decoded(tmp_path: Path, size: tuple[int, int]) -> None:
    assert size[0] > MAX_SIDE or size[0] * size[1] > MAX_PIXELS
    (tmp_path / "bomb.png").write_bytes(png_header(*size))
    with pytest.raises(AssetError, match=r"image 'bomb\.png'"):
        Images(tmp_path).load("bomb.png")


@pytest.mark.parametrize("name", ["", ".", "\0", "a" * 5000])
def test_names_that_are_no_files_are_refused(art: Path, name: str) -> None:
    with pytest.raises(AssetError, match="image"):
        Images(art).load(name)


def test_a_name_that_is_no_text_is_a_type_error(art: Path) -> None:
    with pytest.raises(ArgumentTypeError, match="name=7 must be a file name"):
        Images(art).load(7)  # type: ignore[arg-type]


# ---- saving ----


@pytest.mark.parametrize("ending", ["png", "webp", "tga", "tiff"])
def test_a_saved_image_comes_back_the_same(tmp_path: Path, ending: str) -> None:
    data = np.random.default_rng(4).integers(0, 256, (6, 9, 4), dtype=np.uint8)
    data[..., 3] |= 1  # lossless WebP may change what nobody sees
    path = Image.of(9, 6, data.tobytes()).save(tmp_path / f"a.{ending}")
    assert (np.asarray(Images(tmp_path).load(path.name).pixels) == data).all()
    assert [file.name for file in tmp_path.iterdir()] == [f"a.{ending}"]


def test_a_jpeg_shows_the_image_on_black(tmp_path: Path) -> None:
    Image.of(8, 8, bytes([255, 255, 255, 0] * 64)).save(tmp_path / "a.jpg")
    assert pixel(Images(tmp_path).load("a.jpg"), 4, 4) == (0, 0, 0, 255)


def test_saving_replaces_the_old_file_or_leaves_it(tmp_path: Path) -> None:
    image, path = Image.of(1, 1, bytes(4)), tmp_path / "a.png"
    path.write_text("old")
    with pytest.raises(ArgumentError, match=r"'\.pmg' must be one of .*did you mean '\.png'"):
        image.save(tmp_path / "a.pmg")
    assert path.read_text() == "old"
    image.save(path)
    assert path.read_bytes().startswith(b"\x89PNG")
    assert path.stat().st_mode & 0o044 == 0o044 & ~_mask()


def _mask() -> int:
    import os

    mask = os.umask(0)
    os.umask(mask)
    return mask


@pytest.mark.parametrize("path", ["nowhere/a.png", "folder.png", "a\0.png", "file/a.png"])
def test_a_path_that_cannot_be_written_is_an_asset_error(tmp_path: Path, path: str) -> None:
    (tmp_path / "folder.png").mkdir()
    (tmp_path / "file").write_text("")
    with pytest.raises(AssetError, match="cannot write"):
        Image.of(1, 1, bytes(4)).save(tmp_path / path)
    assert sorted(file.name for file in tmp_path.iterdir()) == ["file", "folder.png"]


def test_a_picture_its_format_cannot_hold_leaves_no_file(tmp_path: Path) -> None:
    with pytest.raises(AssetError, match=r"cannot write .*a\.webp"):
        Image.of(17_000, 1, bytes(4 * 17_000)).save(tmp_path / "a.webp")  # WebP ends at 16383
    assert list(tmp_path.iterdir()) == []


# ---- fonts ----


def test_a_font_has_ascii_latin_letters_and_a_box() -> None:
    font = Fonts().load(16)
    assert set(map(chr, range(0x20, 0x7F))) <= font.glyphs.keys()
    assert set("åäöÅÄÖéèüñçøæßÿ\ufffd") <= font.glyphs.keys()
    assert font.ascent < font.line_height


def test_glyphs_stay_within_the_picture_and_match_its_pixels() -> None:
    for size in (4, 11, 16, 48):
        font = Fonts().load(size)
        alpha = np.asarray(font.image.pixels)[..., 3]
        for character, glyph in font.glyphs.items():
            u0, v0, u1, v1 = glyph.texture
            height, width = alpha.shape
            left, top, right, bottom = u0 * width, v0 * height, u1 * width, v1 * height
            assert (right - left, bottom - top) == pytest.approx(
                (glyph.box[2] - glyph.box[0], glyph.box[3] - glyph.box[1])
            )
            cell = alpha[round(top) : round(bottom), round(left) : round(right)]
            rim = np.concatenate([cell[0], cell[-1], cell[:, 0], cell[:, -1]])
            assert not rim.any(), f"{character!r} at {size} reaches out of its box"
            assert cell.any() == (character not in " \xa0")


def test_glyphs_do_not_overlap_in_the_picture() -> None:
    font = Fonts().load(20)
    taken = np.zeros((font.image.height, font.image.width), int)
    for glyph in font.glyphs.values():
        u0, v0, u1, v1 = glyph.texture
        height, width = taken.shape
        taken[round(v0 * height) : round(v1 * height), round(u0 * width) : round(u1 * width)] += 1
    assert taken.max() == 1


def test_accents_stand_above_their_letter() -> None:
    glyphs = Fonts().load(32).glyphs
    for plain, accented in ("aå", "oö", "AÄ", "eé", "nñ"):
        assert glyphs[accented].box[1] < glyphs[plain].box[1]
        assert glyphs[accented].advance == glyphs[plain].advance
        assert glyphs[accented].box[3] == glyphs[plain].box[3]


def test_each_size_is_made_once() -> None:
    fonts = Fonts()
    assert fonts.load(16) is fonts.load(16.2)
    assert fonts.load(17) is not fonts.load(16)
    assert fonts.load(32).line_height > fonts.load(16).line_height


@pytest.mark.parametrize("size", [0, 3, 513, -1, float("nan"), float("inf"), "16"])
def test_impossible_sizes_are_refused(size: float) -> None:
    with pytest.raises(Error, match="size="):
        Fonts().load(size)
