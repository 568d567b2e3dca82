"""Levels say where water is, which liquids, and how it comes and goes."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from evilengine import level, script
from evilengine.game import Game, saving
from evilengine.script.translate import translate
from evilengine.world.world import World

LEVEL = """
new water pool 8 4 at 0 0 particleSize 0.2 openTop viscosity 0.01 surfaceTension 0.1 density 1.1 colour "teal"
    shades "#66ccff66" "#003355ee" clarity 2 refraction 0.5 waves 0.2 rim 0.3 foam 0.5 unlit layer 2;
new liquid oil in pool density 0.8 viscosity 0.02 surfaceTension 0.3 colour "gold";
new rectangle can 0.3 0.3 at 0 1.2 moving velocity 0.5 0;
fill pool 8 2 at 0 -1;
fill pool 2 1 -3 0.6 liquid oil velocity 1 0;
fill pool 1 0.5 at 3 1 angle 45;
pour pool as tap at 2 1.5 rate 0.5 velocity 0 -2 radius 0.4;
pour pool as spill at 0 -0.3 rate 0.6 follows can liquid oil idle;
drain pool as hatch 1 0.4 at 3 -1.8 rate 0.5;
after 0.3 { set tap rate 1; set tap velocity 1 -1; set hatch rate 2; set spill idle off; set oil density 0.7;
    set pool viscosity 0.5; set pool colour "navy"; }
after 0.8 { destroy can; destroy tap; destroy hatch; }
"""


def game_of(text: str, folder: Path) -> Game:
    (folder / "level.evil").write_text(text)
    game = Game("Water", size=(240, 160), headless=True, renderer="soft", folder=folder)
    game.load("level.evil")
    return game


def water_of(game: Game) -> list[bytes]:
    return [np.asarray(each.positions).tobytes() for each in game.world.waters]


def test_every_word_reaches_the_engine(tmp_path: Path) -> None:
    game = game_of(LEVEL, tmp_path)
    pool, oil, tap, spill, hatch = (game.levels[0][name] for name in ("pool", "oil", "tap", "spill", "hatch"))
    assert (pool.cells, pool.open_sides) == ((20, 10), ("top",))
    assert pool.area == pytest.approx((-4, -2, 4, 2))
    plain = pool.liquids[0]
    assert [plain.density, plain.viscosity, plain.surface_tension] == pytest.approx([1.1, 0.01, 0.1])
    assert [oil.density, oil.viscosity, oil.surface_tension] == pytest.approx([0.8, 0.02, 0.3])
    assert (plain.colour.hex, oil.colour.hex) == ("#008080", "#ffd700")
    assert (plain.count > 400, oil.count) == (True, 50)
    assert (tap.velocity, tap.rate, tap.drains, tap.liquid) == ((0, -2), 0.5, False, plain)
    assert (spill.running, spill.liquid, spill.body) == (False, oil, game.levels[0]["can"])
    assert (hatch.rate, hatch.drains, hatch.running) == (0.5, True, True)
    (look,) = game.scene.waters.state()
    assert [look[word] for word in ("clarity", "refraction", "waves", "foam", "layer", "lit")] == (
        pytest.approx([2, 0.5, 0.2, 0.5, 2, False])
    )
    assert look["rim"] == pytest.approx(0.3)
    assert len(look["ramp"]) == 2


def test_water_is_changed_while_it_plays(tmp_path: Path) -> None:
    game = game_of(LEVEL, tmp_path)
    pool, oil, tap, spill, hatch = (game.levels[0][name] for name in ("pool", "oil", "tap", "spill", "hatch"))
    game.step(30)
    assert (tap.rate, tap.velocity, hatch.rate, spill.running) == (1, (1, -1), 2, True)
    assert (oil.density, pool.viscosity, pool.colour.hex) == (pytest.approx(0.7), 0.5, "#000080")
    game.step(30)
    assert (tap.alive, hatch.alive, spill.alive, pool.alive) == (False, False, False, True)
    assert oil.count > 50


def test_a_saved_level_goes_on_with_its_water(tmp_path: Path) -> None:
    game = game_of(LEVEL, tmp_path)
    game.step(10)
    data = saving.to_bytes(game)
    other = Game("Water", size=(240, 160), headless=True, renderer="soft", folder=tmp_path)
    saving.from_bytes(other, data, "saved")
    assert saving.to_bytes(other) == data
    for each in (game, other):
        each.step(45)
    assert water_of(other) == water_of(game)
    assert bytes(other.capture().pixels) == bytes(game.capture().pixels)
    assert not other.levels[0]._top.things["tap"].alive


def test_the_level_and_its_python_are_the_same(tmp_path: Path) -> None:
    first = game_of(LEVEL, tmp_path)
    second = Game("Water", size=(240, 160), headless=True, renderer="soft", folder=tmp_path)
    module: dict[str, Any] = {"__name__": "translated"}
    exec(translate(script.read_file(tmp_path / "level.evil")), module)
    module["build"](second)
    for _ in range(2):
        for game in (first, second):
            game.step(30)
        assert water_of(first) == water_of(second)
        assert bytes(first.capture().pixels) == bytes(second.capture().pixels)


def test_what_is_about_a_water_that_is_gone_does_nothing(tmp_path: Path) -> None:
    """In the level, and in its Python."""
    text = "new water pool 4 4; new liquid oil in pool density 0.8; new circle ball 1 at 9 9;"
    text += "after 0.1 { destroy pool; destroy ball; } after 0.2 { fill pool 1 1; new liquid tar in pool;"
    text += "pour pool as tap at 0 0 rate 1 liquid oil; set tap rate 2; drain pool as hatch 1 1; destroy hatch;"
    text += "set oil density 0.5; pour pool at 0 0 rate 1 follows ball; }"
    game = game_of(text, tmp_path)
    module: dict[str, Any] = {"__name__": "translated"}
    exec(translate(script.read_file(tmp_path / "level.evil")), module)
    other = Game("Water", headless=True, folder=tmp_path)
    module["build"](other)
    for each in (game, other):
        each.step(20)
        assert (each.world.waters, len(each.world.bodies)) == ((), 0)


def test_a_world_alone_has_water_without_looks() -> None:
    world = World()
    built = level.build(script.read(LEVEL), world)
    for _ in range(30):
        world.step()
    assert built["pool"].volume > 17


@pytest.mark.parametrize(
    ("text", "most"),
    [
        ("every 0.02 { new water 2 2 particleSize 0.5; }", 16),
        ("new water pool 2 2 particleSize 0.5; every 0.02 { new liquid in pool; fill pool 1 1; drain pool 1 1; }", 1),
    ],
)
def test_a_level_that_makes_water_for_ever_stays_playable(text: str, most: int, tmp_path: Path) -> None:
    game = game_of(text, tmp_path)
    game.step(60)
    assert len(game.world.waters) == most
    assert len(game.world.waters[0].liquids) in (1, 16)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("new water;", "water takes 2 numbers"),
        ("new water 4 4 particleSize 0;", "particleSize is from 0.005"),
        ("new water 4 4 cells 30;", "did you mean 'particleSize'?"),
        ("new water 4 4 tension 1;", "did you mean 'surfaceTension'?"),
        ("new water 4 4 viscostiy 1;", "did you mean 'viscosity'?"),
        ("new water 4 4 ramp 1;", "did you mean 'shades'?"),
        ("new water 4 4 density 0;", "density is more than 0"),
        ("new pool 4 4;", "did you mean 'water'?"),
        ("new oil in pool;", "did you mean 'liquid'?"),
        ("new liquid oil;", "a liquid needs in"),
        ("new liquid oil in nowhere;", "there is no water called 'nowhere'"),
        ("new smoke air 4 4; new liquid oil in air;", "'air' is smoke, and this needs water"),
        ("fill;", "fill needs the name of a water"),
        ("fill pool 1 1;", "there is no water called 'pool'"),
        ("new circle ball 1; fill ball 1 1;", "'ball' is a thing, and this needs water"),
        ("new water pool 4 4; fill pool 1;", "a fill takes 2 numbers"),
        ("new water pool 4 4; fill pool 1 1 rate 3;", "a filling has no rate"),
        ("new water pool 4 4; pour pool at 0 0;", "a pour needs rate"),
        ("new water pool 4 4; pour pool rate 1;", "a pour needs at"),
        ("new water pool 4 4; pour pool 3 at 0 0 rate 1;", "no number here"),
        ("new water pool 4 4; pour pool at 0 0 rate -1;", "rate is from 0"),
        ("new water pool 4 4; pour pool as at 0 0 rate 1;", "'at' is a word of the language"),
        ("new water pool 4 4; pour pool as; ", "as needs a name"),
        ("new water pool 4 4; pour pool at 0 0 rate 1 liquid pool;", "'pool' is water, and this needs a liquid"),
        ("new water pool 4 4; drain pool;", "a drain takes 2 numbers"),
        ("new water pool 4 4; drain pool 1 1 velocity 1 0;", "a drain has no velocity"),
        ("new water pool 4 4; drain pool as hatch 1 1; set hatch velocity 1 0;", "a drain has no velocity to change"),
        ("new water pool 4 4; new liquid oil in pool; destroy oil;", "'oil' is a liquid, and this needs a thing"),
        ("new water pool 4 4; set pool clarity 3;", "clarity cannot be changed later"),
        ("new water pool 4 4; flood pool 1 1;", "did you mean 'fill'?"),
        ("new water pool 4 4; pour pool as pool at 0 0 rate 1;", "the name 'pool' is taken"),
    ],
)
def test_what_is_wrong_is_said_with_what_was_meant(text: str, words: str) -> None:
    _, errors = script.check(text, "level.evil")
    assert words in "\n".join(map(str, errors))
    assert all("level.evil:1:" in str(error) for error in errors)
