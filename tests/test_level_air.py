"""Levels say what lies behind, between and before things: background, plane, lens and particles."""

from __future__ import annotations

from pathlib import Path

import pytest

import evilengine as evil
from evilengine import level, script
from evilengine.game import Game, saving
from evilengine.script.translate import translate
from evilengine.values.image import Image

LEVEL = """
background "sky.png";
background "hills.png" parallax 0.3 tall 4;
draw circle moon 1 at 2 1 colour "white" layer -2;
plane -2 parallax 0.5 tint "#406080" fog "#ffffff40" fogAbove "#ffffff00" blur 2;
lens bloom 0.6 threshold 0.8 exposure 1.2 contrast 1.1 saturation 0.9 tint "#fff0d8" vignette 0.4 filmGrain 0.02 filmic;
new rectangle floor 8 1 at 0 -2;
new circle ball 0.5 at 0 2 physicsOn velocity 1 0;
new particles trail follows ball at 0 -0.5 rate 60 towards 180 cone 30 flying 2 lasting 0.7 size 0.2 endSize 0.02
    colour "orange" fade "#ff000000" glowing sharp stretch 0.02 varies 0.3 gravityScale 0.1 drag 1 breeze 1 0
    bouncing ending layer 2;
new particles snow wide 8 tall 1 at 0 3 rate 30 texture "sky.png" spin 90 colour "white";
on collide ball floor { set trail rate 5; destroy snow; }
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    for name, colour in (("sky.png", b"\x40\x60\x90\xff"), ("hills.png", b"\x20\x30\x20\xff")):
        Image.of(8, 4, colour * 32).save(tmp_path / name)
    return tmp_path


def game_of(text: str, folder: Path) -> Game:
    (folder / "level.evil").write_text(text)
    game = Game("Air", size=(240, 160), headless=True, renderer="soft", folder=folder)
    game.load("level.evil")
    return game


def problems(text: str) -> str:
    _, errors = script.check(text, "level.evil")
    return "\n".join(map(str, errors))


def test_every_word_reaches_the_engine(folder: Path) -> None:
    game = game_of(LEVEL, folder)
    assert [(each.parallax, each.blur) for each in game.layers] == [(0.3, 0.0), (0.5, 2.0)]
    assert game.layers[-2].fog == [(1, 1, 1, 64 / 255), (1, 1, 1, 0)]
    post = game.post
    assert (post.bloom, post.bloom_threshold, post.tone_mapping, post.vignette) == (0.6, 0.8, "filmic", 0.4)
    trail, snow = game.scene.emitters
    assert trail.body is game.levels[0]["ball"]
    assert (trail.rate, trail.speed, trail.life, trail.size) == (60, (2, 2), (0.7, 0.7), (0.2, 0.02))
    assert (trail.blend, trail.soft, trail.collide, trail.dies, trail.layer) == ("add", False, True, True, 2)
    assert trail.direction == pytest.approx(3.14159265, rel=1e-6)
    assert (snow.area, snow.texture) == ((8, 1), "sky.png")


def test_emitters_are_named_changed_and_destroyed(folder: Path) -> None:
    game = game_of(LEVEL, folder)
    trail, snow = game.scene.emitters
    game.step(20)
    assert trail.count > 15
    game.step(60)
    assert (trail.rate, snow.alive) == (5, False)


def test_a_saved_level_goes_on_with_its_emitters(folder: Path) -> None:
    game = game_of(LEVEL, folder)
    game.step(20)
    data = saving.to_bytes(game)
    other = Game("Air", size=(240, 160), headless=True, renderer="soft", folder=folder)
    saving.from_bytes(other, data, "saved")
    assert saving.to_bytes(other) == data
    for each in (game, other):
        each.step(60)
    assert saving.to_bytes(other) == saving.to_bytes(game)
    assert bytes(other.capture().pixels) == bytes(game.capture().pixels)


def test_the_level_and_its_python_are_the_same(folder: Path) -> None:
    first = game_of(LEVEL, folder)
    second = Game("Air", size=(240, 160), headless=True, renderer="soft", folder=folder)
    module: dict[str, object] = {"__name__": "translated"}
    exec(translate(script.read_file(folder / "level.evil")), module)
    module["build"](second)  # type: ignore[operator]
    for game in (first, second):
        game.step(80)
    assert bytes(first.capture().pixels) == bytes(second.capture().pixels)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("plane parallax 0.3;", "plane needs a layer"),
        ("plane -2.5 parallax 0.3;", "whole number"),
        ("plane -2 paralax 0.3;", "did you mean 'parallax'?"),
        ("plane -2 bloom 0.3;", "has no bloom"),
        ("lens glow 0.3;", "did you mean 'bloom'?"),
        ("lens bloom 9;", "bloom is from 0 to 3"),
        ('background "red" parallax 0.3;', "parallax is for pictures, and red is a colour"),
        ("background;", "background needs a colour"),
        ("new emitter fire rate 5;", "did you mean 'particles'?"),
        ("new particles fire 3 rate 5;", "no number here"),
        ("new particles fire lifetime 5;", "did you mean 'lasting'?"),
        ("new particles fire lasting 0;", "lasting is from 0.01"),
        ("new particles fire follows ball;", "ball"),
        ("new particles fire rate 5; set fire size 3;", "size"),
        ("new particles fire rate 5; set fire raet 3;", "did you mean 'rate'?"),
        ("new particles fire rate 5; impulse fire 0 3;", "fire"),
    ],
)
def test_what_is_wrong_is_said_with_what_was_meant(text: str, words: str) -> None:
    assert words in problems(text)


def test_a_world_alone_has_no_use_for_looks(folder: Path) -> None:
    (folder / "level.evil").write_text(LEVEL)
    world = evil.World()
    level.build(script.read_file(folder / "level.evil"), world)
    assert len(world.bodies) == 2


def test_a_level_that_makes_particles_for_ever_stays_playable(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("evilengine.level.level.MAX_BODIES", 50)
    game = game_of("every 0.02 { new particles rate 1; }", folder)
    game.step(300)
    assert len(game.scene.emitters) <= 51
