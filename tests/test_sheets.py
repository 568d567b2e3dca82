"""Sheets: frames out of one picture, animations by the world's steps, mirrored pictures, borders, tiles, blending."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import PIL.Image
import pytest

import evilengine as evil
from evilengine.assets.pictures import cut
from evilengine.scene import Drawing, DrawnBody
from evilengine.values.image import Image
from evilengine.values.sheet import Grid

COLOURS = [(255, 0, 0, 255), (0, 255, 0, 255), (0, 0, 255, 255), (255, 255, 0, 255)]


@pytest.fixture
def game(tmp_path: Path) -> evil.Game:
    strip = PIL.Image.new("RGBA", (40, 10))
    for frame, colour in enumerate(COLOURS):
        strip.paste(colour, (frame * 10, 0, frame * 10 + 10, 10))
    strip.save(tmp_path / "strip.png")
    halves = PIL.Image.new("RGBA", (10, 10), COLOURS[0])
    halves.paste(COLOURS[2], (5, 0, 10, 10))
    halves.save(tmp_path / "halves.png")
    frame = PIL.Image.new("RGBA", (30, 30), COLOURS[0])
    frame.paste(COLOURS[1], (10, 10, 20, 20))
    frame.save(tmp_path / "frame.png")
    game = evil.Game(headless=True, renderer="soft", folder=tmp_path, size=(200, 100), gravity=(0, 0))
    game.add_background("black")
    return game


def at(game: evil.Game, x: float, y: float) -> tuple[int, ...]:
    column, row = game.camera.to_pixel((x, y))
    pixels = game.capture().pixels
    return tuple(pixels[int(row), int(column), part] for part in range(3))


def sheet(**options: object) -> evil.Sheet:
    return evil.Sheet("strip.png", 4, fps=60, **options)  # type: ignore[arg-type]


def frames_shown(drawing: Drawing, game: evil.Game, steps: int) -> list[int]:
    shown = []
    for _ in range(steps):
        shown.append(drawing.frame)
        game.step()
    return shown


def test_a_sheet_shows_its_first_frame_as_large_as_it_is(game: evil.Game) -> None:
    coin = game.sprite(sheet())
    assert coin.frame == 0
    assert not coin.playing
    assert at(game, 0, 0) == (255, 0, 0)
    assert at(game, 0.09, 0.09) == (255, 0, 0)
    assert at(game, 0.15, 0) == (0, 0, 0)


def test_neighbouring_frames_never_shine_through_however_large_it_is_drawn(game: evil.Game) -> None:
    coin = game.sprite(sheet(), height=1.6)
    coin.frame = 1
    row = np.asarray(game.capture().pixels)[50, :, :3]
    seen = {tuple(int(part) for part in pixel) for pixel in row}
    assert all(red == blue == 0 for red, _, blue in seen)


@pytest.mark.parametrize(
    ("course", "expected"),
    [("loop", [1, 2, 3, 1, 2, 3, 1, 2]), ("once", [1, 2, 3, 3, 3, 3, 3, 3]), ("back", [1, 2, 3, 2, 1, 2, 3, 2])],
)
def test_an_animation_takes_its_course(game: evil.Game, course: str, expected: list[int]) -> None:
    coin = game.sprite(sheet(animations={"spin": evil.Animation([1, 2, 3], course=course)}), animation="spin")
    assert coin.animation == "spin"
    assert frames_shown(coin, game, 8) == expected
    assert coin.playing == (course != "once")


def test_what_is_drawn_is_the_frame_that_is_said(game: evil.Game) -> None:
    coin = game.sprite(sheet())
    coin.play(fps=30)
    for _ in range(8):
        assert at(game, 0, 0) == COLOURS[coin.frame][:3]
        game.step()


def test_playing_what_plays_goes_on_and_restart_begins_anew(game: evil.Game) -> None:
    coin = game.sprite(sheet())
    for _ in range(2):
        coin.play()
        game.step()
    assert coin.frame == 2
    coin.play(restart=True)
    assert coin.frame == 0
    coin.play(start=3 / 60, restart=True)
    assert coin.frame == 3
    coin.stop()
    game.step(5)
    assert (coin.frame, coin.playing) == (3, False)


def test_animations_stand_while_the_game_is_paused_and_go_on_after(game: evil.Game) -> None:
    coin = game.sprite(sheet())
    coin.play(fps=60)
    game.paused = True
    for count in range(5):
        game.frame(count / 60)
    assert coin.frame == 0


def test_a_saved_game_goes_on_in_the_middle_of_an_animation(game: evil.Game, tmp_path: Path) -> None:
    ball = game.add(
        evil.Circle(0.5), texture=sheet(animations={"a": [3, 1, 2]}), animation="a", flip_x=True, blend="add", tag="b"
    )
    frame = game.sprite("frame.png", size=(1, 0.5), slice=10, at=(1, 0))
    game.step(2)
    picture = game.capture().tobytes()
    game.save("here", folder=tmp_path)
    game.step(2)
    other = evil.Game(headless=True, renderer="soft", folder=tmp_path, size=(200, 100))
    for each in (game, other):
        each.resume("here", folder=tmp_path)
        body = each.world.find("b")
        assert isinstance(body, DrawnBody)
        (drawing,) = body.drawings
        assert (drawing.frame, drawing.animation, drawing.flip_x, drawing.blend) == (2, "a", True, "add")
        assert each.capture().tobytes() == picture
    assert (ball.drawings[0].frame, ball.drawings[0].texture) == (2, sheet(animations={"a": [3, 1, 2]}))
    assert frame.alive


def test_clearing_the_scene_forgets_the_clips(game: evil.Game) -> None:
    for _ in range(2):
        game.sprite(sheet()).play()
        assert len(game.scene._clips) == 2
        game.scene.clear()
        assert len(game.scene._clips) == 0


def test_mirrored_pictures_change_their_sides(game: evil.Game) -> None:
    halves = game.sprite("halves.png", height=1)
    assert at(game, -0.3, 0) == (255, 0, 0)
    halves.flip_x = True
    assert at(game, -0.3, 0) == (0, 0, 255)
    assert halves.flip_x
    assert not halves.flip_y
    halves.flip_y = True
    halves.place((0, 0), math.pi / 2)
    assert at(game, 0, -0.3) == (0, 0, 255)


def test_sliced_pictures_keep_their_borders(game: evil.Game) -> None:
    game.sprite("frame.png", size=(2, 1), slice=10)
    for x in (-0.95, -0.85, 0.85, 0.95):
        assert at(game, x, 0) == (255, 0, 0)  # 10 points wide: 0.2 m
    for x in (-0.7, -0.3, 0, 0.7):
        assert at(game, x, 0) == (0, 255, 0)
    assert at(game, 0, 0.35) == (255, 0, 0)


def test_sliced_borders_shrink_where_they_do_not_fit(game: evil.Game) -> None:
    game.sprite("frame.png", size=(0.2, 1), slice=(10, 0, 10, 0))
    assert at(game, 0.05, 0) == (255, 0, 0)


def test_tiles_are_laid_again_and_again(game: evil.Game) -> None:
    game.draw(evil.Rectangle(2, 1), texture="halves.png", tile=1)
    assert [at(game, x, 0) for x in (-0.75, -0.25, 0.25, 0.75)] == [(255, 0, 0), (0, 0, 255)] * 2
    disc = game.draw(evil.Circle(0.5), texture="halves.png", tile=(0.5, 1), at=(3, 0))
    assert disc.texture_matrix[0] == pytest.approx(2)


@pytest.mark.parametrize("renderer", ["soft", "gl"])
@pytest.mark.parametrize(
    ("blend", "expected"),
    [
        ("normal", (127, 60, 60)),  # half of (200, 40, 80) over (54, 80, 40)
        ("add", (154, 100, 80)),
        ("multiply", (48, 46, 26)),
        ("screen", (133, 94, 74)),
    ],
)
def test_colours_meet_as_their_blend_says(renderer: str, blend: str, expected: tuple[int, int, int]) -> None:
    game = evil.Game(headless=True, renderer=renderer, size=(64, 64))
    game.add_background("#365028")
    game.draw(evil.Circle(0.5), colour="#c8285080", blend=blend)
    pixels = game.capture().pixels
    for part in range(3):
        assert abs(pixels[32, 32, part] - expected[part]) <= 1
    assert pixels[32, 32, 3] == 255


def test_light_added_to_light_is_white_and_never_wraps(game: evil.Game) -> None:
    for _ in range(3):
        game.draw(evil.Circle(0.5), colour="#ff9060", blend="add")
    assert at(game, 0, 0) == (255, 255, 255)


def test_a_grid_leaves_out_margin_and_spacing() -> None:
    pixels = np.zeros((7, 10, 4), np.uint8)
    pixels[2:5, 2:4] = 1
    pixels[2:5, 6:8] = 2
    first, second = cut(Image.of(10, 7, pixels.tobytes()), Grid("", 2, 1, 2, 2))
    assert first.size == second.size == (2, 3)
    assert set(first.tobytes()) == {1}
    assert set(second.tobytes()) == {2}


def test_dense_screens_take_the_dense_sheet(game: evil.Game, tmp_path: Path) -> None:
    PIL.Image.new("RGBA", (80, 20), COLOURS[3]).save(tmp_path / "strip@2x.png")
    game._pictures.scale = 2.0
    coin = game.sprite(sheet())
    assert game._pictures.size(sheet().grid) == (10, 10)
    assert at(game, 0.0, 0.0) == (255, 255, 0)
    assert coin.frame == 0


def test_a_sheet_whose_file_changed_shows_its_new_frames(game: evil.Game, tmp_path: Path) -> None:
    coin = game.sprite(sheet())
    coin.frame = 2
    PIL.Image.new("RGBA", (80, 20), COLOURS[3]).save(tmp_path / "strip.png")
    assert game.reload_images() == []
    assert at(game, 0, 0) == (255, 255, 0)
    PIL.Image.new("RGBA", (81, 20), COLOURS[1]).save(tmp_path / "strip.png")
    assert "do not divide into 4 x 1 frames" in game.reload_images()[0]
    assert at(game, 0, 0) == (255, 255, 0)


@pytest.mark.parametrize(
    ("bad", "words"),
    [
        (lambda game: evil.Sheet("strip.png", 0), "columns=0 must be"),
        (lambda game: evil.Sheet("strip.png", 4, fps=0), "fps=0"),
        (lambda game: evil.Sheet("strip.png", 2, animations={"a": [2]}), "there is no frame 2, only 0 to 1"),
        (lambda game: evil.Sheet("strip.png", 2, animations={"a": []}), r"frames=\[\] must be numbers"),
        (lambda game: evil.Sheet("strip.png", 2, colums=3), "did you mean 'columns'"),  # type: ignore[call-arg]
        (lambda game: evil.Animation([0], course="twice"), "course='twice' must be one of"),
        (lambda game: game.sprite(evil.Sheet("strip.png", 3)), "40 x 10 pixels do not divide"),
        (lambda game: game.sprite(evil.Sheet("stip.png", 3)), "did you mean 'strip.png'"),
        (lambda game: game.sprite(sheet(animations={"walk": [1]}), animation="wlak"), "did you mean 'walk'"),
        (lambda game: game.sprite("strip.png", animation="walk"), "animation='walk' needs texture=evil.Sheet"),
        (lambda game: game.sprite("strip.png").play(), "has no frames"),
        (lambda game: setattr(game.sprite(sheet()), "frame", 4), "frame=4 must be 0 to 3"),
        (lambda game: game.sprite("frame.png", slice=4), "slice=4 needs a size"),
        (lambda game: game.sprite("frame.png", size=(1, 1), slice=15), "must leave something in the middle"),
        (lambda game: game.sprite("frame.png", size=(1, 1), height=2), "contradict each other"),
        (lambda game: game.draw(evil.Circle(1), tile=1), "tile=1 needs a texture"),
        (lambda game: game.draw(evil.Circle(1), blend="ad"), "did you mean 'add'"),
        (lambda game: game.draw(evil.Circle(1), lit="no"), "lit='no' must be True or False"),
        (lambda game: game.draw(evil.Circle(1), texture="frame.png", slice=4), "slice=4 is for a Rectangle"),
        (lambda game: game.draw(evil.Rectangle(1, 1), slice=4), "slice=4 needs a texture"),
        (lambda game: game.add_light(at=(0, 0), on="off"), "on='off' must be True or False"),
        (lambda game: game.camera.follow(None, deadzone=(1, 1)), r"Camera.follow\(\) got an unknown argument deadzone"),
    ],
)
def test_bad_words_about_sheets_are_named(game: evil.Game, bad: object, words: str) -> None:
    with pytest.raises(evil.Error, match=words):
        bad(game)  # type: ignore[operator]
