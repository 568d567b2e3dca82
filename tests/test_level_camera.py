"""The camera in a level's words: where it looks and how closely, whom it follows, and where it stops."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

import evilengine as evil
from evilengine import script
from evilengine.game import saving
from evilengine.script.translate import translate


def game_of(text: str, folder: Path) -> evil.Game:
    (folder / "level.evil").write_text(text, encoding="utf-8")
    game = evil.Game(size=(240, 160), headless=True, renderer="soft", folder=folder, sound="none")
    game.load("level.evil")
    return game


HERO = "gravity 0 0; new circle ball 0.5 at 0 0 physicsOn velocity 6 0;\n"


def test_the_camera_is_placed_turned_and_brought_closer(tmp_path: Path) -> None:
    camera = game_of("camera at 3 1 zoom 2 angle 30;", tmp_path).camera
    assert (camera.position, camera.zoom) == ((3, 1), 2)
    assert camera.angle == pytest.approx(math.radians(30))


def test_it_goes_there_softly(tmp_path: Path) -> None:
    game = game_of("after 0.5 { camera at 4 0 zoom 3 over 1; }", tmp_path)
    seen = []
    for _ in range(10):
        game.step(12)
        seen.append(game.camera.position.x)
    assert seen == sorted(seen)
    assert 0 < seen[4] < 4
    assert (seen[0], seen[-1], game.camera.zoom) == (0, 4, 3)


def test_it_follows_within_its_zone_and_bounds(tmp_path: Path) -> None:
    game = game_of(HERO + "camera follows ball deadZone 2 1 smoothing 0 leftBottom -9 -9 rightTop 6 9;", tmp_path)
    game.step(20)
    assert game.camera.position.x == pytest.approx(20 * 6 / 60 - 1, abs=0.11)
    game.step(60)
    assert game.camera.position.x == pytest.approx(6 - 240 / 100), "what is to the right of its bounds is not seen"


def test_what_is_gone_is_not_followed(tmp_path: Path) -> None:
    game = game_of(HERO + "after 0.1 { destroy ball; } after 0.2 { camera follows ball zoom 2; }", tmp_path)
    game.step(30)
    assert (game.camera.following, game.camera.zoom) == (None, 2)


def test_a_saved_level_goes_on_with_its_camera(tmp_path: Path) -> None:
    text = HERO + "camera follows ball deadZone 2 1 leftBottom -9 -9 rightTop 60 9; after 0.5 { camera zoom 2 over 1; }"
    game = game_of(text, tmp_path)
    game.step(45)
    data = saving.to_bytes(game)
    other = evil.Game(size=(240, 160), headless=True, renderer="soft", folder=tmp_path, sound="none")
    saving.from_bytes(other, data, "saved")
    for each in (game, other):
        each.step(60)
    assert saving.to_bytes(other) == saving.to_bytes(game)


def test_a_level_as_python_has_the_same_camera() -> None:
    text = HERO + "camera follows ball deadZone 2 1 leftBottom -9 -9 rightTop 60 9 angle 20; camera zoom 2 over 1;"
    level, errors = script.check(text, "level.evil")
    assert not errors
    lines = translate(level)
    for line in (
        "game.camera.follow(ball, dead_zone=(2, 1))",
        "game.camera.bounds = (-9, -9, 60, 9)",
        "game.camera.angle = math.radians(20)",
        "game.camera.glide(zoom=2, seconds=1)",
    ):
        assert line in lines


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("camera zoom 0;", "zoom"),
        ("camera zoon 2;", "did you mean 'zoom'?"),
        ("camera smoothing 1;", "smoothing needs follows"),
        ("camera over 2;", "over needs at, zoom or angle"),
        ("camera leftBottom 0 0;", "leftBottom needs rightTop"),
        ("camera follows nobody;", "there is no thing called 'nobody'"),
        ("camera at 3;", "at needs two numbers"),
        ('camera at 3 0 colour "red";', "a camera has no colour"),
        ("camera zoom 1 zoom 2;", "zoom is said twice"),
        ("cammera zoom 2;", "did you mean 'camera'?"),
    ],
)
def test_mistakes_are_told_with_the_right_word(text: str, words: str) -> None:
    _, errors = script.check(text, "level.evil")
    assert words in "\n".join(map(str, errors))
