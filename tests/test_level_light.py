"""Levels say what shines: lights, the ambient light, and what is lit."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import pytest
from player import level_game, play
from surfaces import plain

import evilengine as evil
from evilengine import script
from evilengine.game import Game, replaying, saving
from evilengine.save import Replay
from evilengine.script.translate import translate
from evilengine.values.colour import to_colour

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


SURFACES = """
ambient "#102030";
shadows off;
draw rectangle wall 20 12 at 0 0 texture "wall.png" normalMap "wall.normal.png" layer -1 lit;
new circle coal 0.5 at 0 2 physicsOn lit glow 2 glowMap "wall.png";
new light window at -2 3 texture "wall.png" angle 30 radius 3 static;
after 0.5s { set coal glow 0.5; shadows on; ambient 0.3; }
"""


def surfaces_of(folder: Path) -> Game:
    plain(folder / "wall.png", (200, 180, 160))
    plain(folder / "wall.normal.png", (128, 128, 255))
    return game_of(SURFACES, folder)


def test_surfaces_shadows_and_slides_reach_the_engine(tmp_path: Path) -> None:
    game = surfaces_of(tmp_path)
    (window,) = game.lights
    assert window.texture is not None
    assert window.texture.endswith("wall.png")
    assert (window.angle, window.static, window.radius) == (pytest.approx(math.radians(30)), True, 3)
    assert (game.ambient, game.lights.shadows) == (to_colour("#102030", "test", "colour"), False)
    (coal,) = game.levels[0]["coal"].drawings
    assert coal.glow == 2
    assert coal.glow_map is not None
    wall = game.levels[0]["wall"]
    assert wall.normal_map is not None
    assert wall.normal_map.endswith("wall.normal.png")
    game.step(40)
    assert (coal.glow, game.lights.shadows, game.ambient) == (0.5, True, 0.3)


def test_a_saved_level_keeps_surfaces_and_shadows(tmp_path: Path) -> None:
    game = surfaces_of(tmp_path)
    game.step(10)
    data = saving.to_bytes(game)
    other = Game("Light", size=(240, 160), headless=True, renderer="soft", folder=tmp_path)
    saving.from_bytes(other, data, "saved")
    assert saving.to_bytes(other) == data
    assert not other.lights.shadows
    for each in (game, other):
        each.step(60)
    assert bytes(other.capture().pixels) == bytes(game.capture().pixels)


def recorded(path: Path, target: Path) -> bytes:
    """The last picture of a level that is played and recorded."""
    game = level_game(path)
    game._recorder = replaying.record(game, target, level=True)
    play(game, 0, 90)
    picture = bytes(game.capture().pixels)
    game.close()
    return picture


@pytest.mark.parametrize("text", [LEVEL, SURFACES], ids=["lights", "surfaces"])
def test_a_recording_with_lights_is_played_again_to_the_last_pixel(tmp_path: Path, text: str) -> None:
    surfaces_of(tmp_path)
    (tmp_path / "played.evil").write_text(text)
    picture = recorded(tmp_path / "played.evil", tmp_path / "played.evr")
    game = replaying.game_of(Replay.read(tmp_path / "played.evr"), headless=True)
    playback = game._playback = replaying.play(game, Replay.read(tmp_path / "played.evr"))
    while not playback.over:
        game.step()
    assert playback.difference is None
    assert bytes(game.capture().pixels) == picture


def test_a_game_that_was_resumed_goes_on_as_if_never_stopped(tmp_path: Path) -> None:
    game = surfaces_of(tmp_path)
    for light in game.lights:
        light.static = True
    game.step(20)
    game.capture()  # what stands still is worked out in one of the two
    other = Game("Light", size=(240, 160), headless=True, renderer="soft", folder=tmp_path)
    saving.from_bytes(other, saving.to_bytes(game), "saved")
    for _ in range(4):
        for each in (game, other):
            each.step(15)
        assert bytes(other.capture().pixels) == bytes(game.capture().pixels)


def test_a_level_as_python_has_the_same_surfaces(tmp_path: Path) -> None:
    game = surfaces_of(tmp_path)
    level, errors = script.check(SURFACES, "level.evil", folder=tmp_path)
    assert not errors
    names: dict[str, Any] = {"__name__": "translated"}
    exec(compile(translate(level), "translated.py", "exec"), names)
    other = Game("Light", size=(240, 160), headless=True, renderer="soft", folder=tmp_path)
    names["build"](other)
    for _ in range(2):
        assert bytes(other.capture().pixels) == bytes(game.capture().pixels)
        for each in (game, other):
            each.step(40)
    (window,) = other.lights
    assert (other.lights.shadows, window.static, window.angle) == (True, True, pytest.approx(math.radians(30)))


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("ambient dark;", "ambient needs a number"),
        ("ambient 5;", "ambient"),
        ("new light at 0 0 temperature 12;", "temperature"),
        ("new light at 0 0 brightness 2;", "intensity"),
        ("new lamp at 0 0;", "light"),
        ("new circle 1 at 0 0 lit 3;", "3"),
        ("shadows;", "shadows is on or off"),
        ("shadows true;", "did you mean 'on'?"),
        ('ambient "sort of blue";', "colour"),
        ("new circle 1 at 0 0 lit glow 100;", "64"),
        ("new circle 1 at 0 0 bumps 3;", "normalMap"),
        ("new light at 0 0 baked;", "static"),
        ("new light towards 30 cone 20;", "say where it is, as in: at 0 3"),
        ('new light at 0 0 towards 30 angle 20 texture "wall.png";', "towards and angle exclude each other"),
        ("draw circle 1 at 0 0 frames 3;", "as in: frames 4 1"),
        ('background "hills.png" tall;', "as in: tall 6"),
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
