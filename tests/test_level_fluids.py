"""Levels say where smoke and fire are, and where they come from."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from evilengine import level, script
from evilengine.game import Game, saving
from evilengine.script.translate import translate
from evilengine.world.world import World

LEVEL = """
new smoke air 8 6 at 0 3 cells 32 openTop openLeft buoyancy 0.8 vorticity 2 viscosity 0.001 diffusion 0.002 cooling 0.4
    vanishing 0.1 burning 2 heat 1.5 soot 0.2 weight 0.3 breeze 0.5 0 breezePull 1 slippery fine colour "slategrey"
    shades "#0000" "#6668" "#ddde" fireShades "black" "indigo" "white" opacity 3 glow 2 lightRadius 5 shadow 0.5
    unlit layer 2;
new rectangle floor 9 1 at 0 -0.5;
new circle lamp 0.2 at 1 2.5 physicsOn gravityScale 0;
new source flame in air at 0 0.5 radius 0.3 fuel 3 temperature 1 rate 0.5 velocity 0 1;
new source tail in air follows lamp at 0 0.3 wide 0.4 tall 0.2 angle 30 rate 2 colour "orange" idle;
after 0.3 { set tail idle off; set tail rate 3; set flame fuel 1; set air breeze -1 0; set air cooling 2; }
after 0.8 { destroy lamp; destroy flame; }
"""


def game_of(text: str, folder: Path) -> Game:
    (folder / "level.evil").write_text(text)
    game = Game("Fluids", size=(240, 160), headless=True, renderer="soft", folder=folder)
    game.load("level.evil")
    return game


def fields(game: Game) -> list[bytes]:
    return [np.asarray(field).tobytes() for each in game.world.smokes for field in (each.density, each.velocity)]


def test_every_word_reaches_the_engine(tmp_path: Path) -> None:
    game = game_of(LEVEL, tmp_path)
    air, flame, tail = (game.levels[0][name] for name in ("air", "flame", "tail"))
    assert (air.area, air.cells) == ((-4, 0, 4, 6), (32, 24))
    assert (air.open_sides, air.quality) == (("left", "top"), "high")
    assert [air.buoyancy, air.vorticity, air.cooling, air.fade, air.burning, air.heat, air.soot, air.weight] == (
        pytest.approx([0.8, 2, 0.4, 0.1, 2, 1.5, 0.2, 0.3])
    )
    assert [air.viscosity, air.diffusion, air.wind_pull, *air.wind] == pytest.approx([0.001, 0.002, 1, 0.5, 0])
    (look,) = game.scene.gases.state()
    assert (len(look["ramp"]), len(look["fire"])) == (3, 3)
    assert (look["opacity"], look["glow"], look["light_radius"], look["shadow"]) == (3, 2, 5, 0.5)
    assert (flame.fuel, flame.temperature, flame.rate, flame.velocity) == (3, 1, 0.5, (0, 1))
    assert (tail.body, tail.running, tail.rate) == (game.levels[0]["lamp"], False, 2)


def test_unlit_smoke_is_seen_in_the_dark_and_covers_lower_layers(tmp_path: Path) -> None:
    def brightness(words: str) -> float:
        text = 'background "black"; ambient 0; new light at 9 9; view 4 4;'
        text += 'draw rectangle 4 4 at 0 0 colour "black" layer 1;'
        text += 'new smoke air 4 4 cells 8 colour "white" ' + words + "; new source in air radius 1 rate 60;"
        game = game_of(text, tmp_path)
        game.step(20)
        return float(np.asarray(game.capture().pixels)[70:90, 110:130, :3].mean())

    assert brightness("unlit layer 2") > 100
    assert brightness("layer 2") < 5
    assert brightness("unlit") < 5


def test_fluids_are_changed_and_destroyed_while_it_plays(tmp_path: Path) -> None:
    game = game_of(LEVEL, tmp_path)
    air, flame, tail = (game.levels[0][name] for name in ("air", "flame", "tail"))
    game.step(30)
    assert (tail.running, tail.rate, flame.fuel, air.wind, air.cooling) == (True, 3, 1, (-1, 0), 2)
    assert air.mass > 0.05
    game.step(30)
    assert (tail.alive, flame.alive, air.alive) == (False, False, True)
    assert not air.sources


def test_a_saved_level_goes_on_with_its_smoke(tmp_path: Path) -> None:
    game = game_of(LEVEL + "new smoke 2 2 at 9 9 cells 4;", tmp_path)
    game.step(10)
    data = saving.to_bytes(game)
    other = Game("Fluids", size=(240, 160), headless=True, renderer="soft", folder=tmp_path)
    saving.from_bytes(other, data, "saved")
    assert saving.to_bytes(other) == data
    for each in (game, other):
        each.step(50)
    assert not other.levels[0]._top.things["flame"].alive
    assert fields(other) == fields(game)
    assert bytes(other.capture().pixels) == bytes(game.capture().pixels)


def test_the_level_and_its_python_are_the_same(tmp_path: Path) -> None:
    first = game_of(LEVEL, tmp_path)
    second = Game("Fluids", size=(240, 160), headless=True, renderer="soft", folder=tmp_path)
    module: dict[str, Any] = {"__name__": "translated"}
    exec(translate(script.read_file(tmp_path / "level.evil")), module)
    module["build"](second)
    for _ in range(2):
        for game in (first, second):
            game.step(35)
        assert fields(first) == fields(second)
        assert bytes(first.capture().pixels) == bytes(second.capture().pixels)


def test_a_source_of_smoke_that_is_gone_is_none(tmp_path: Path) -> None:
    """In the level, and in its Python: nothing is made, and what speaks of it does nothing."""
    text = "new smoke air 4 4 cells 8; new circle ball 1; after 0.1 { destroy air; destroy ball; }"
    text += "after 0.2 { new source late in air follows ball radius 1; set late rate 3; destroy late; }"
    game = game_of(text, tmp_path)
    module: dict[str, Any] = {"__name__": "translated"}
    exec(translate(script.read_file(tmp_path / "level.evil")), module)
    other = Game("Fluids", headless=True, folder=tmp_path)
    module["build"](other)
    for each in (game, other):
        each.step(20)
        assert (each.world.smokes, len(each.world.bodies)) == ((), 0)


def test_a_world_alone_has_smoke_without_looks() -> None:
    world = World()
    built = level.build(script.read(LEVEL), world)
    for _ in range(30):
        world.step()
    assert built["air"].mass > 0.01
    assert math.isfinite(built["air"].mass)


def test_a_level_that_makes_smoke_for_ever_stays_playable(tmp_path: Path) -> None:
    game = game_of("every 0.02 { new smoke 2 2 cells 4; }", tmp_path)
    game.step(60)
    assert len(game.world.smokes) == 16


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("new smoke;", "smoke takes 2 numbers"),
        ("new smoke 4;", "as in: new smoke air 8 6"),
        ("new smoke 4 4 cells 1;", "cells is from 2 to 1024"),
        ("new smoke 4 4 cells 8.5;", "whole number"),
        ("new smoke 4 4 wind 1 0;", "did you mean 'breeze'?"),
        ("new smoke 4 4 ramp 3;", "did you mean 'shades'?"),
        ("new smoke 4 4 fade 1;", "'vanishing'"),
        ("new smoke 4 4 bouyancy 1;", "did you mean 'buoyancy'?"),
        ("new smoke 4 4 openSide;", "did you mean 'open"),
        ('new smoke 4 4 shades "red";', "shades needs two colours"),
        ('new smoke 4 4 shades "red", "blue";', "no comma between colours"),
        ('new smoke 4 4 shades "red" "bleu";', "did you mean 'blue'?"),
        ("new smoke 4 4 viscosity -1;", "viscosity is from 0"),
        ("new gas air 4 4;", "did you mean 'smoke'?"),
        ("new source radius 1;", "a source needs in"),
        ("new source in nowhere radius 1;", "there is no smoke called 'nowhere'"),
        ("new circle ball 1; new source in ball radius 1;", "'ball' is a thing, and this needs smoke"),
        ("new smoke air 4 4; new source in air;", "needs a radius, or wide and tall"),
        ("new smoke air 4 4; new source in air wide 2;", "needs a radius, or wide and tall"),
        ("new smoke air 4 4; new source in air radius 1 wide 2 tall 1;", "has no wide"),
        ("new smoke air 4 4; new source in air radius 1 angle 3;", "has no angle"),
        ("new smoke air 4 4; new source 3 in air radius 1;", "no number here"),
        ("new smoke air 4 4; new source s in air radius 1; set s radius 2;", "a source has no radius to change"),
        ("new smoke air 4 4; new source s in air radius 1; set s radius 2;", "of a source, set changes rate, temp"),
        ("new smoke air 4 4; set air cells 2;", "cannot be changed"),
        ("new smoke air 4 4; set air cells 2;", "of smoke, set changes buoyancy"),
        ("new smoke air 4 4; new source s in air radius 1; set s idle;", "idle is on or off"),
        ("new smoke air 4 4; impulse air 1 0;", "'air' is smoke, and this needs a thing"),
        ("new smoke air 4 4; set air rate 3;", "smoke has no rate to change"),
    ],
)
def test_what_is_wrong_is_said_with_what_was_meant(text: str, words: str) -> None:
    _, errors = script.check(text, "level.evil")
    assert words in "\n".join(map(str, errors))
    assert all("level.evil:1:" in str(error) for error in errors)
