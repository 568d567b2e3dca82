"""Text in lines: wrapping, alignment, kerning, colours, fonts of files, and all of it saved."""

from __future__ import annotations

import io
import itertools
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from PIL import ImageFont
from stage import Stage

import evilengine as evil
from evilengine.assets.fonts import Fonts
from evilengine.scene.typeset import layout, typeset
from evilengine.values.font import Font, Glyph
from evilengine.values.image import Image


def square_font(kerning: float = 0.0) -> Font:
    """Letters of 10 pixels, spaces of 5; an `o` after a `T` comes closer by `kerning`."""
    letter, space = Glyph(10, (0, -10, 10, 0), (0, 0, 1, 1)), Glyph(5, (0, 0, 0, 0), (0, 0, 0, 0))
    glyphs = dict.fromkeys("abcdefTo?", letter) | {" ": space}
    return Font(10, 10, 12, Image.of(1, 1, b"\xff" * 4), glyphs, lambda a, b: -kerning if a + b == "To" else 0.0)


def placed(text: str, font: Font | None = None, **options: object) -> list[tuple[float, float]]:
    """Left and top of each glyph that is drawn."""
    block = typeset(font or square_font(), [(text, 0)], 0.0, **{"align": 0.0, **options})  # type: ignore[arg-type]
    boxes = np.frombuffer(block.boxes.get(0, b""), np.float32).reshape(-1, 8)
    return [(float(x), float(y)) for x, y in boxes[:, :2]]


def test_lines_break_at_spaces_and_leave_the_space_out() -> None:
    assert placed("ab cd ef", width=46) == [(0, 0), (10, 0), (25, 0), (35, 0), (0, 12), (10, 12)]
    assert placed("ab cd", width=44) == [(0, 0), (10, 0), (0, 12), (10, 12)]


def test_a_word_that_is_too_wide_breaks_inside() -> None:
    assert placed("abcdef a", width=25) == [(0, 0), (10, 0), (0, 12), (10, 12), (0, 24), (10, 24), (0, 36)]


def test_a_letter_that_is_too_wide_alone_has_a_line_of_its_own() -> None:
    assert placed("ab", width=3) == [(0, 0), (0, 12)]


def test_lines_end_together_or_lie_in_the_middle() -> None:
    assert placed("abc\na", align=1.0) == [(0, 0), (10, 0), (20, 0), (20, 12)]
    assert placed("abc\na", align=0.5)[-1] == (10, 12)
    assert placed("a", align=1.0, width=50) == [(40, 0)]


def test_pairs_come_closer_where_the_font_says_so() -> None:
    assert placed("To") == [(0, 0), (10, 0)]
    assert placed("ToT", square_font(3.0)) == [(0, 0), (7, 0), (17, 0)]
    assert typeset(square_font(3.0), [("T", 0), ("o", 1)], 0.0, align=0.0).width == 17


@given(st.text("ab cd\n", max_size=60), st.floats(10, 200))
def test_no_line_is_wider_than_it_may_be_and_no_letter_is_lost(text: str, width: float) -> None:
    places = placed(text, width=width)
    assert len(places) == sum(letter not in " \n" for letter in text)
    assert all(x + 10 <= width + 1e-6 for x, _ in places)
    assert places == sorted(places, key=lambda place: (place[1], place[0]))


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """With a typeface in a file: the one that Pillow brings."""
    face = ImageFont.load_default(20)
    assert isinstance(face, ImageFont.FreeTypeFont)
    assert isinstance(face.path, io.BytesIO)
    (tmp_path / "title.ttf").write_bytes(face.path.getvalue())
    return tmp_path


def ink(image: Image) -> np.ndarray[tuple[int, ...], np.dtype[np.bool_]]:
    return np.asarray(image.pixels)[..., :3].max(axis=2) > 128


@pytest.mark.parametrize("name", [None, "title.ttf"])
def test_pairs_stand_as_the_typefaces_gpos_table_says(folder: Path, name: str | None) -> None:
    kerning = Fonts(folder).load(100, name).kerning
    # Of Pillow's typeface, in thousandths of its size, as its GPOS table has them in classes.
    table = {"AV": -60, "To": -62, "LT": -134, "VA": -44, "oo": 0, "11": 0}
    assert {pair: kerning(*pair) for pair in table} == {pair: round(part / 10) for pair, part in table.items()}
    assert kerning("T", "\xf6") == kerning("T", "o")  # which the typeface lacks, and is put together
    assert kerning("T", " ") == kerning(" ", "V") == 0.0
    assert {kerning(a, b) % 1 for a in "AVTLo" for b in "AVTLo"} == {0.0}


def test_a_kerned_text_is_narrower_by_its_pairs(folder: Path) -> None:
    font = Fonts(folder).load(60)
    apart = sum(font.glyphs[letter].advance for letter in "AVAToLT")
    pairs = sum(font.kerning(*pair) for pair in itertools.pairwise("AVAToLT"))
    assert pairs < -12
    _, (width, _) = layout(font, "AVAToLT")
    assert width == apart + pairs


def test_letters_of_a_file_are_made_when_they_are_asked_for(folder: Path) -> None:
    fonts = Fonts(folder)
    first = fonts.load(20, "title.ttf", "abc")
    assert fonts.load(20, "title.ttf", "cab\n") is first
    assert "\u0416" not in first.glyphs
    second = fonts.load(20, "title.ttf", "\u0416")
    assert {"\u0416", "a"} <= second.glyphs.keys()
    assert fonts.load(20) is fonts.load(20, None, "\u0416")


def test_a_game_shows_text_in_a_typeface_of_its_own(folder: Path) -> None:
    game = evil.Game(headless=True, renderer="soft", size=(300, 200), folder=folder)
    game.add_background("black")
    text = game.text("Wide words wrap", font="title.ttf", size=30, width=150, align="right", at=(10, 10))
    rows, columns = np.nonzero(ink(game.capture()))
    assert columns.max() < 160
    assert rows.max() > 50  # at least two lines
    text.width = None
    assert np.nonzero(ink(game.capture()))[0].max() < 50


def test_pieces_have_colours_of_their_own(folder: Path) -> None:
    game = evil.Game(headless=True, renderer="soft", size=(300, 60), folder=folder)
    game.add_background("black")
    text = game.text(["a", ("b", "red"), ("c", "#0000ff")], colour="lime", size=40, at=(10, 5))
    assert text.text == "abc"
    pixels = np.asarray(game.capture().pixels)[..., :3].astype(int)
    middles = [int(np.nonzero(pixels[..., part] > 200)[1].mean()) for part in (1, 0, 2)]
    assert middles == sorted(middles)
    text.text = "plain"
    assert np.asarray(game.capture().pixels)[..., 0].max() < 60


def test_saved_texts_come_back_with_font_width_and_colours(folder: Path) -> None:
    game = evil.Game("T", headless=True, renderer="soft", size=(300, 100), folder=folder)
    game.text(["10 ", ("coins", "gold")], font="title.ttf", width=120, align="centre", at=(20, 10), size=26)
    game.step()
    picture = game.capture().tobytes()
    game.save("t", folder=folder)
    other = evil.Game("T", headless=True, renderer="soft", size=(300, 100), folder=folder)
    other.resume("t", folder=folder)
    assert other.capture().tobytes() == picture


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"font": "titel.ttf"}, "there is no such file .* did you mean 'title.ttf'"),
        ({"font": "not.ttf"}, "this is no typeface that can be read"),
        ({"font": 3}, "font=3 must be the name of a font file"),
        ({"width": 0}, "width=0 must be"),
        ({"align": "middle"}, "align='middle' must be one of"),
    ],
)
def test_bad_words_about_letters_are_named(folder: Path, options: dict[str, object], words: str) -> None:
    (folder / "not.ttf").write_bytes(b"This is a letter to nobody.")
    game = evil.Game(headless=True, renderer="soft", folder=folder)
    with pytest.raises(evil.Error, match=words):
        game.text("a", **options)
    with pytest.raises(evil.Error, match="'no'"):
        Stage().scene.text([("a", "no")])
