"""How smoke is seen: as thick as it is, lit by lamps, shining where it burns; the same in a saved game."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from drawing_gl import any_driver

import evilengine as evil


def a_game(renderer: str = "soft", **options: Any) -> tuple[evil.Game, evil.Smoke]:
    game = evil.Game(headless=True, size=(160, 160), renderer=renderer, view_height=4)
    game.camera.position = (0, 2)
    game.scene.background = "#000000"
    smoke = game.add_smoke((-2, 0, 2, 4), cells=32, colour="white", **options)
    return game, smoke


def pixels(game: evil.Game) -> Any:
    return np.asarray(game.capture().pixels)[..., :3].astype(int)


@pytest.mark.parametrize("renderer", ["soft", "gl"])
def test_smoke_is_seen_where_it_is_and_the_thicker_the_better(renderer: str) -> None:
    if renderer == "gl":
        any_driver()
    game, smoke = a_game(renderer)
    density = np.asarray(smoke.density)
    density[4:8, 4:8], density[20:28, 20:28] = 0.3, 3.0
    game.step()
    picture = pixels(game)
    thin, thick, none = picture[130, 30], picture[40, 120], picture[130, 120]
    assert (none == 0).all()
    assert 40 < thin[0] < 160
    assert thick.min() > 200


@pytest.mark.parametrize("renderer", ["soft", "gl"])
def test_no_cell_is_seen_by_itself(renderer: str) -> None:
    """The edge of a slanting cloud is a straight line, not the stairs of its cells."""
    if renderer == "gl":
        any_driver()
    game, smoke = a_game(renderer, opacity=1, lit=False)
    row, column = np.mgrid[0:32, 0:32]
    np.asarray(smoke.density)[:, :] = 8.0 * (column > 0.5 * row + 6)
    game.step(1)
    bright = pixels(game)[30:130, :, 0] / 255.0
    edge = (bright > 0.5).argmax(axis=1)
    edge = edge - (bright[range(100), edge] - 0.5) / (bright[range(100), edge] - bright[range(100), edge - 1])
    straight = np.polyval(np.polyfit(np.arange(100), edge, 1), np.arange(100))
    assert abs(edge - straight).max() < 0.25 * 5  # pixels; a cell has 5


def test_smoke_reaches_what_is_solid_and_ends_there() -> None:
    game, smoke = a_game(opacity=50, lit=False)
    game.add(evil.Rectangle(2, 2), at=(0, 2), kind="static", colour="#000000", layer=-1)
    game.step(1)
    np.asarray(smoke.density)[:, :] = 5.0
    game.step(1)
    row = pixels(game)[80, :, 0]
    assert row[:40].min() > 200, "up to its face"
    assert row[46:114].max() < 10, "and not behind it"


def test_smoke_takes_the_light_of_lamps_and_fire_shines_by_itself() -> None:
    game, smoke = a_game(light_radius=0, cooling=0)
    np.asarray(smoke.density)[:, :] = 3.0
    game.step()
    plain = pixels(game)[80, 80].sum()
    game.ambient = 0.1
    assert pixels(game)[80, 80].sum() < 0.4 * plain
    np.asarray(smoke.temperature)[14:18, 14:18] = 2.0
    game.step()
    assert pixels(game)[80, 80][0] > 200


def test_a_fire_lights_what_is_round_it_and_goes_out() -> None:
    game, smoke = a_game(cooling=5, glow=3)
    game.ambient = 0.05
    game.draw(evil.Rectangle(4, 4), at=(0, 2), colour="white", lit=True, layer=-1)
    before = pixels(game)[80, 30].sum()
    np.asarray(smoke.temperature)[12:20, 12:20] = 2.0
    game.step()
    burning = pixels(game)[80, 30].sum()
    assert burning > before + 30
    game.step(300)
    assert pixels(game)[80, 30].sum() < before + 10


def test_a_fire_has_its_lamp_whether_anybody_looks_or_not() -> None:
    game, smoke = a_game()
    np.asarray(smoke.temperature)[12:20, 12:20] = 2.0
    game.step()
    lamps = len(game.lights)
    assert lamps == 1
    pixels(game)
    assert len(game.lights) == lamps, "drawing makes none"


def test_each_fire_of_a_smoke_has_its_own_lamp(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path))
    game, smoke = a_game()
    torches = [smoke.add_source(at=(x, 1), radius=0.2, fuel=5, temperature=1) for x in (-1.5, 1.5)]
    smoke.add_source(at=(0, 1), radius=0.2, rate=1)
    game.step(10)
    assert sorted(round(light.at.x, 1) for light in game.lights) == [-1.5, 1.5]
    game.save("torches")
    torches[0].destroy()
    np.asarray(smoke.temperature)[:, :16] = 0.0
    game.step(1)
    assert [round(light.at.x, 1) for light in game.lights if light.on] == [1.5]
    game.resume("torches")
    game.step(10)
    assert sorted(round(light.at.x, 1) for light in game.lights) == [-1.5, 1.5]


def test_a_lamp_that_was_put_out_by_hand_stays_out_and_others_are_left_alone() -> None:
    game, smoke = a_game()
    smoke.add_source(at=(0, 1), radius=0.3, fuel=5, temperature=1)
    game.step(10)
    game.lights.clear()
    own = game.add_light(at=(1, 1), radius=2)
    game.step(10)
    assert list(game.lights) == [own]
    assert own.at == evil.Vec2(1, 1)


def test_colours_of_two_sources_stay_apart() -> None:
    game, smoke = a_game()
    smoke.add_source(at=(-1, 2), radius=0.4, rate=20, colour="red")
    smoke.add_source(at=(1, 2), radius=0.4, rate=20, colour="blue")
    game.step(20)
    picture = pixels(game)
    left, right = picture[80, 40], picture[80, 120]
    assert left[0] > 150 > 60 > left[2]
    assert right[2] > 150 > 60 > right[0]


def test_a_saved_game_shows_the_same_smoke(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path))
    game, smoke = a_game(ramp=["#0000", "#8f8", "#fff"])
    smoke.add_source(at=(0, 0.5), radius=0.4, rate=5, temperature=1, fuel=3)
    game.step(40)
    file = "fire"
    game.save(file)
    before = pixels(game)
    game.step(20)
    game.resume(file)
    assert np.array_equal(pixels(game), before)
    other = evil.Game(headless=True, size=(160, 160), renderer="soft", view_height=4)
    other.resume(file)
    assert np.array_equal(pixels(other), before)
    game.step(10)
    other.step(10)
    assert np.array_equal(pixels(game), pixels(other))


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"opacity": 0}, "opacity=0"),
        ({"glow": -1}, "glow=-1"),
        ({"ramp": ["red"]}, "two or more colours"),
        ({"ramp": "red"}, "two or more colours"),
        ({"fire": ["red", "hot"]}, "fire"),
        ({"opacitty": 1}, "did you mean 'opacity'"),
        ({"layer": 0.5}, "layer"),
        ({"lit": "no"}, "lit='no' must be True or False"),
    ],
)
def test_looks_that_make_no_sense_leave_nothing_behind(given: dict[str, Any], message: str) -> None:
    game = evil.Game(headless=True)
    with pytest.raises((evil.ArgumentError, evil.ArgumentTypeError), match=message):
        game.add_smoke((0, 0, 1, 1), cells=8, **given)
    assert game.world.smokes == ()
    assert len(game.scene) == 0
