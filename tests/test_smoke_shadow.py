"""Smoke takes light away: what lies behind it is darker, and its own far side, softly."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import evilengine as evil


def a_game(density: float = 2.0, *, sun: bool = False, **looks: Any) -> evil.Game:
    """Smoke in the middle fifth of a wall; a lamp far on its left shines along the wall, or a sun does."""
    game = evil.Game(headless=True, size=(200, 120), renderer="soft", view_height=3)
    game.scene.background = "black"
    game.draw(evil.Rectangle(5, 3), colour="white", lit=True, layer=-1)
    smoke = game.add_smoke((-2.5, -1.5, 2.5, 1.5), cells=50, ramp=["#0000", "#0000"], **looks)
    np.asarray(smoke.density)[10:20, 20:30] = density
    game.ambient = 0.02
    if sun:
        game.add_light(direction=(1, 0), intensity=0.7)
    else:
        game.add_light(at=(-2.4, 0), radius=40, falloff=0, intensity=0.7)
    return game


def light_of(game: evil.Game) -> Any:
    """The wall's light, about linear."""
    return (np.asarray(game.capture().pixels)[..., 0] / 255.0) ** 2.2


@pytest.mark.parametrize("sun", [False, True])
def test_what_lies_behind_smoke_is_as_dark_as_beers_law_says(sun: bool) -> None:
    lit, clear = (light_of(a_game(density, sun=sun)) for density in (2.0, 0.0))
    left = (lit / clear)[60, 20]
    behind = (lit / clear)[60, 150]
    assert left == pytest.approx(1, abs=0.03)
    assert behind == pytest.approx(np.exp(-2.0), abs=0.06)  # a metre of a density of 2


def test_its_own_far_side_is_darker_and_darkness_grows_along_the_way() -> None:
    row = light_of(a_game())[60]
    assert (np.diff(row[82:118]) < 0.01).all()
    assert row[84] > 2.5 * row[116]


def test_the_shadow_has_soft_edges_and_ends_beside_the_smoke() -> None:
    lit, clear = (light_of(a_game(density, sun=True)) for density in (4.0, 0.0))
    column = (lit / clear)[:, 150]
    assert column[60] < 0.1
    assert column[20] > 0.95
    assert column[100] > 0.95
    edge = column[30:60]
    assert ((edge > 0.1) & (edge < 0.9)).sum() >= 3


def test_twice_the_shadow_is_twice_the_smoke_and_none_is_none() -> None:
    once, twice, thick = light_of(a_game(1.0)), light_of(a_game(1.0, shadow=2)), light_of(a_game(2.0))
    assert np.allclose(twice, thick, atol=0.01)
    assert once[60, 150] > twice[60, 150] + 0.05
    assert np.allclose(light_of(a_game(2.0, shadow=0)), light_of(a_game(0.0)))


def test_a_lamp_without_shadows_shines_through() -> None:
    game = a_game()
    for lamp in game.lights:
        lamp.shadows = False
    assert np.allclose(light_of(game), light_of(a_game(0.0)), atol=0.02)


def test_a_lamp_in_the_midst_shines_out_of_the_smoke_round_it() -> None:
    game = a_game(0.0)
    for lamp in game.lights:
        lamp.destroy()
    game.add_light(at=(0, 0), radius=4, size=2)
    clear = light_of(game)
    np.asarray(game.world.smokes[0].density)[10:20, 20:30] = 2.0
    assert np.allclose(light_of(game), clear, atol=0.01)


def test_a_lamp_beyond_the_picture_casts_them_too() -> None:
    game = a_game()
    for lamp in game.lights:
        lamp.at = (-40, 0)
        lamp.radius = 200
    row = light_of(game)[60]
    assert row[150] < 0.3 * row[20]


def test_a_still_lamp_follows_the_smoke() -> None:
    game = a_game(0.0)
    for lamp in game.lights:
        lamp.static = True
    before = light_of(game)
    np.asarray(game.world.smokes[0].density)[10:20, 20:30] = 2.0
    assert light_of(game)[60, 150] < 0.3 * before[60, 150]
    np.asarray(game.world.smokes[0].density)[:] = 0.0
    assert np.allclose(light_of(game), before)


@pytest.mark.parametrize("shadow", [-1, float("nan"), 101, "dark"])
def test_a_shadow_that_makes_no_sense_is_refused(shadow: Any) -> None:
    game = evil.Game(headless=True)
    with pytest.raises((evil.ArgumentError, evil.ArgumentTypeError), match="shadow"):
        game.add_smoke((0, 0, 1, 1), cells=8, shadow=shadow)
    assert game.world.smokes == ()
