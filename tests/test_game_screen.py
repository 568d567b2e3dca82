"""The screen of a game: pictures by a key or a call, full screen, and the graph of what frames cost."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from PIL import Image

import evilengine as evil
from evilengine.cli.film import Screen
from evilengine.game import Game
from evilengine.values.events import KeyEvent
from evilengine.values.tick import STEP


@pytest.fixture
def game(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    game = Game("My game: 2", size=(320, 180), headless=True)
    game.add(evil.Circle(0.5), colour="red")
    return game


def play(game, frames, first=0):
    for frame in range(first, first + frames):
        game.frame(frame * STEP)


def test_a_key_saves_pictures_and_never_writes_one_over_another(game, tmp_path, capsys):
    (tmp_path / "My-game-2-2.png").write_bytes(b"mine")
    for _ in range(2):
        game.device.tap("f12")
        play(game, 2)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["My-game-2-1.png", "My-game-2-2.png", "My-game-2-3.png"]
    assert (tmp_path / "My-game-2-2.png").read_bytes() == b"mine"
    said = capsys.readouterr().err.splitlines()
    assert said == ["My game: 2: saved My-game-2-1.png", "My game: 2: saved My-game-2-3.png"]
    with Image.open(tmp_path / "My-game-2-3.png") as picture:
        assert picture.size == (320, 180)
        assert picture.convert("RGB").getpixel((160, 90)) == (255, 0, 0)


def test_hints_over_the_game_are_on_no_picture_of_it(game, tmp_path):
    clean = game.screenshot(tmp_path / "a.png").read_bytes()
    game.scene.overlay("a hint", at=(0, 0), anchor="centre", size=40)
    game.frame_graph = True
    play(game, 1)
    assert game.screenshot(tmp_path / "b.png").read_bytes() == clean
    assert game.device.shown.tobytes() != game._plain_picture().tobytes()


def test_the_screen_says_for_a_while_where_the_picture_is(game):
    play(game, 1)
    game.device.tap("f12")
    play(game, 1, 1)
    assert any("saved My-game-2-1.png" in text.text for text in game.scene._overlay)
    play(game, 200, 2)
    assert not any(text.alive for text in game.scene._overlay)


def test_a_picture_that_is_taken_in_a_callback_is_of_the_end_of_the_step(game, tmp_path):
    seen = []
    game.timer.after(0, lambda: seen.append((game.screenshot("a.png"), (tmp_path / "a.png").stat().st_size)))
    game.step()
    assert seen[0][1] == 0
    with Image.open(seen[0][0]) as picture:
        assert picture.size == (320, 180)


def test_pictures_call_nobody_and_change_nothing(game):
    calls = []
    game.on_draw(lambda: calls.append(1))
    before = game.world.snapshot()
    game.screenshot()
    assert calls == []
    assert game.world.snapshot() == before


def test_a_picture_that_cannot_be_written_is_an_error_of_ours(game, tmp_path, monkeypatch, capsys):
    game.screenshot("a.png")
    for bad, error, words in (
        ("a.png", evil.AssetError, "is there already"),
        ("no/such/b.png", evil.AssetError, "cannot be written"),
        ("b.xyz", evil.Error, "xyz"),
        (7, evil.ArgumentTypeError, "must be the name of a file"),
        ("", evil.ArgumentTypeError, "must be the name of a file"),
        ("a\0b.png", evil.AssetError, "cannot be written"),
    ):
        with pytest.raises(error, match=words):
            game.screenshot(bad)
    assert os.listdir(tmp_path) == ["a.png"]

    def full(self, path):
        raise evil.AssetError("the disk is full")

    monkeypatch.setattr("evilengine.values.image.Image.save", full)
    game.device.tap("f12")
    play(game, 1)
    assert capsys.readouterr().err == "My game: 2: no picture: the disk is full\n"
    assert os.listdir(tmp_path) == ["a.png"]


def test_where_nothing_may_be_written_pictures_go_among_temporary_files(game, tmp_path, monkeypatch):
    open_file = Path.open

    def forbidden(path, *args):
        if path.parent == Path():
            raise PermissionError(13, "not here", str(path))
        return open_file(path, *args)

    monkeypatch.setattr(Path, "open", forbidden)
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path / "temporary"))
    (tmp_path / "temporary").mkdir()
    assert game.screenshot() == tmp_path / "temporary" / "My-game-2-1.png"


def test_a_key_fills_the_screen_and_nothing_is_stretched(game):
    game.camera.fit(16, 9)
    inside = game.camera.to_pixel((1, 0)).x - game.camera.to_pixel((0, 0)).x
    game.device.tap("f11")
    play(game, 2)
    assert game.fullscreen
    assert game.camera.size == game.device.size == (1920, 1080)
    right, up = game.camera.to_pixel((1, 0)).x - 960, 540 - game.camera.to_pixel((0, 1)).y
    assert right == up == inside * 6
    assert game.device.shown.size == (1920, 1080)
    game.device.tap("f11")
    play(game, 2, 2)
    assert not game.fullscreen
    assert game.camera.size == game.device.size == (320, 180)


def test_full_screen_may_be_asked_for_from_the_start():
    game = Game(size=(320, 180), headless=True, fullscreen=True)
    assert game.fullscreen
    game.step()
    assert game.camera.size == (1920, 1080)
    with pytest.raises(evil.ArgumentTypeError, match="True or False"):
        game.fullscreen = "yes"
    game.close()
    with pytest.raises(evil.DeviceError, match="closed"):
        game.fullscreen = False


def test_a_film_stays_as_large_as_it_was_asked_for():
    game = Game(size=(320, 180), device=Screen("film", (320, 180), (160, 90)), fullscreen=True)
    play(game, 2)
    assert game.device.shown.size == (160, 90)


def test_keys_of_the_window_can_be_others_or_none(game, tmp_path):
    game.screenshot_key, game.fullscreen_key = "p", None
    game.device.tap("f12")
    game.device.tap("f11")
    play(game, 2)
    assert (os.listdir(tmp_path), game.fullscreen, game.fullscreen_key) == ([], False, None)
    game.device.tap("p")
    play(game, 2, 2)
    assert os.listdir(tmp_path) == ["My-game-2-1.png"]
    with pytest.raises(evil.ArgumentError, match="screenshot_key"):
        game.screenshot_key = "f99"


def test_keys_of_the_window_work_while_the_game_is_paused_and_reach_it_too(game, tmp_path):
    game.paused = True
    heard = []
    game.on_event(lambda event: heard.append(event))
    game.device.tap("f12")
    play(game, 1)
    assert len(os.listdir(tmp_path)) == 1
    assert heard[0] == KeyEvent("f12", True)


def test_frames_say_what_they_cost(game):
    assert game.timings.last.total == 0
    play(game, 130)
    times = game.timings.last
    assert times.draw > 0
    assert times.total == pytest.approx(times.steps + times.collect + times.draw + times.present)
    assert len(game.timings.rows) == 120


def test_the_graph_shows_it(game):
    play(game, 60)
    plain = game.capture().tobytes()
    game.frame_graph = True
    game.timings.rows.append(type(game.timings.last)(20.0, 3.0, 2.0, 1.0))
    picture = game.capture()
    assert picture.tobytes() != plain
    bar = [tuple(picture.pixels[y, 320 - 13, part] for part in range(3)) for y in range(90, 168)]
    assert (0x86, 0xF7, 0xA0) in bar, "most of that frame were steps"
    game.frame_graph = False
    assert game.capture().tobytes() == plain
