"""Text on the screen: where it hangs, how it changes, what it refuses."""

from __future__ import annotations

import math

import pytest
from stage import Stage

import evilengine as evil
from evilengine.scene import Scene
from evilengine.values.errors import ArgumentError, StaleReferenceError


@pytest.fixture
def stage() -> Stage:
    return Stage()


def lit_box(pixels: memoryview) -> tuple[int, int, int, int] | None:
    """Left, top, right, bottom of what is white."""
    height, width, _ = pixels.shape
    found = [(x, y) for y in range(height) for x in range(width) if pixels[y, x, 0] == 255]
    if not found:
        return None
    return (
        min(x for x, _ in found),
        min(y for _, y in found),
        max(x for x, _ in found) + 1,
        max(y for _, y in found) + 1,
    )


@pytest.mark.parametrize(
    ("anchor", "box"),
    [
        ("top left", (10, 5, 30, 25)),
        ("top right", (170, 5, 190, 25)),
        ("bottom left", (10, 75, 30, 95)),
        ("bottom right", (170, 75, 190, 95)),
        ("top", (100, 5, 120, 25)),
        ("centre", (100, 45, 120, 65)),
    ],
)
def test_text_hangs_on_its_anchor(stage: Stage, anchor: str, box: tuple[int, int, int, int]) -> None:
    stage.scene.text("ab", at=(10, 5), size=20, anchor=anchor)
    assert lit_box(stage.show()) == box


def test_text_keeps_its_size_in_points_on_a_finer_screen(stage: Stage) -> None:
    stage.scene.text("ab", at=(10, 5), size=20)
    assert lit_box(stage.show(size=(400, 200))) == (20, 10, 60, 50)


def test_text_can_be_changed_hidden_and_destroyed(stage: Stage) -> None:
    text = stage.scene.text("a", at=(0, 0), size=20)
    text.text = 777  # type: ignore[assignment]
    assert text.text == "777"
    assert lit_box(stage.show()) == (0, 0, 30, 20)  # letters that the font lacks are drawn as its question mark
    text.text = "a\nb c"
    assert lit_box(stage.show()) == (0, 0, 30, 40)
    text.visible = False
    assert lit_box(stage.show()) is None
    text.visible = True
    text.destroy()
    assert lit_box(stage.show()) is None
    assert not text.alive
    with pytest.raises(StaleReferenceError, match=r"this Text \('a\\nb c'\) was destroyed"):
        text.text = "b"
    with pytest.raises(StaleReferenceError):
        text.destroy()


def test_text_lies_over_the_world(stage: Stage) -> None:
    stage.scene.add(evil.Rectangle(4, 2), colour="red", layer=9)
    stage.scene.text("a", at=(0, 0), size=20)
    assert lit_box(stage.show()) is not None
    assert stage.show()[10, 5, 1] == 255


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"at": "x"}, "at='x'"),
        ({"at": (0, 1e9)}, "at=.0, 1000000000.0. must be at most"),
        ({"size": 0}, "size=0"),
        ({"size": math.nan}, "size=nan"),
        ({"colour": "no"}, "colour='no'"),
        ({"anchor": "up"}, "anchor='up'"),
        ({"sized": 3}, "did you mean 'size'"),
    ],
)
def test_bad_words_about_text_are_named(stage: Stage, options: dict[str, object], words: str) -> None:
    with pytest.raises(evil.Error, match=words):
        stage.scene.text("a", **options)  # type: ignore[arg-type]
    assert lit_box(stage.show()) is None


def test_text_without_fonts_says_what_is_missing() -> None:
    with pytest.raises(ArgumentError, match="no fonts"):
        Scene(evil.World()).text("a")
