"""Levels say what shines: lights, the ambient light, and what is lit."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

import evilengine as evil
from evilengine import script
from evilengine.game import Game, saving
from evilengine.script.translate import translate

LEVEL = """
draw rectangle wall 20 12 at 0 0 colour "#887766" layer -1 lit;
new circle ball 0.5 at 0 2 physicsOn lit;
ambient 0.05;
new light lamp at -2 3 colour "orange" temperature 2700 intensity 2 radius 6 softness 0.4 falloff 1;
new light follows ball at 0 0.7 towards -90 cone 40 noShadows;
new light moon towards -45 intensity 0.3;
every 0.5s { set lamp radius 3; set lamp intensity 1; }
after 1s { destroy moon; }
"""


def game_of(text: str, folder: Path) -> Game:
    (folder / "level.evil").write_text(text)
    game = Game("Light", size=(240, 160), headless=True, renderer="soft", folder=folder)
    game.load("level.evil")
    return game


def test_every_word_reaches_the_engine(tmp_path: Path) -> None:
    game = game_of(LEVEL, tmp_path)
    lamp, spot, moon = game.lights
    assert [light.kind for light in game.lights] == ["lamp", "spot", "sun"]
    assert game.ambient == 0.05
    assert (lamp.at, lamp.intensity, lamp.radius, lamp.falloff, lamp.temperature) == ((-2, 3), 2, 6, 1, 2700)
    assert lamp.size == pytest.approx(0.4)
    assert spot.body is game.levels[0]["ball"]
    assert (spot.shadows, spot.cone) == (False, pytest.approx(math.radians(40)))
    assert moon.angle == pytest.approx(math.radians(-45))
    assert all(drawing.lit for drawing in game.levels[0]["ball"].drawings)


def test_lights_are_named_changed_and_destroyed(tmp_path: Path) -> None:
    game = game_of(LEVEL, tmp_path)
    lamp, _, moon = game.lights
    game.step(90)
    assert (lamp.radius, lamp.intensity, moon.alive) == (3, 1, False)


def test_a_saved_level_goes_on_with_its_lights(tmp_path: Path) -> None:
    game = game_of(LEVEL, tmp_path)
    game.step(20)
    data = saving.to_bytes(game)
    other = Game("Light", size=(240, 160), headless=True, renderer="soft", folder=tmp_path)
    saving.from_bytes(other, data, "saved")
    assert saving.to_bytes(other) == data
    for each in (game, other):
        each.step(60)
    assert bytes(other.capture().pixels) == bytes(game.capture().pixels)
    assert len(other.lights) == 2


def test_a_level_as_python_has_the_same_light(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    level, errors = script.check(LEVEL, "level.evil")
    assert not errors
    text = translate(level)
    assert "game.add_light(" in text
    assert "game.ambient = 0.05" in text
    assert "evil.Vec2(1, 0).turned(" in text


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("ambient dark;", "ambient needs a number"),
        ("ambient 5;", "ambient"),
        ("new light at 0 0 temperature 12;", "temperature"),
        ("new light at 0 0 brightness 2;", "intensity"),
        ("new lamp at 0 0;", "light"),
        ("new circle 1 at 0 0 lit 3;", "3"),
    ],
)
def test_mistakes_are_told_with_the_right_word(text: str, words: str) -> None:
    _, errors = script.check(text, "level.evil")
    assert words in "\n".join(map(str, errors))


def test_a_level_with_light_still_loads_as_any_game_does(tmp_path: Path) -> None:
    game = game_of("new light;", tmp_path)
    (only,) = game.lights
    assert isinstance(only.position, evil.Vec2)
    assert only.position == (0, 0)
