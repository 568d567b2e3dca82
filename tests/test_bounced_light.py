"""High quality: light that surfaces send on, against rays followed one by one; corners keep ambient light out."""

from __future__ import annotations

import math

import numpy as np
import pytest
from lighting import GAMMA, light_of, lit_game
from surfaces import normal_colour, plain

import evilengine as evil
from evilengine import _core
from evilengine.game import saving

WALLS = [((0, -1.7), (6.4, 0.2)), ((-3.1, 0), (0.2, 3.6)), ((0.6, -0.4), (0.3, 1.2)), ((1.9, 0.7), (1.0, 0.2))]


def yard(**options):
    """A floor, a wall and two slabs, with a lamp over them and no ambient light; and their colours."""
    game = lit_game(**options)
    game.lights.quality = "high"
    colours = ["#ffffff", "#ff2010", "#30c040", "#c0c0c0"]
    for (at, sides), colour in zip(WALLS, colours, strict=True):
        game.add(evil.Rectangle(*sides), at=at, kind="static", colour=colour, outline=False)
    game.add_light(at=(-0.9, 0.3), size=0.1, radius=6, falloff=1, intensity=1.5)
    return game, colours


def share_of(colour):
    """What of the light that falls on it a body of this colour sends back: nine tenths of what white paint would."""
    return 0.9 * np.array([int(colour[n : n + 2], 16) / 255 for n in (1, 3, 5)]) ** GAMMA


def followed(point, direct, places, colours, rays=720):
    """The mean of what rays from the point meet: a surface's share of the light in the air just before it."""
    turn = 2 * np.pi * (np.arange(rays) + 0.5) / rays
    way = np.stack([np.cos(turn), np.sin(turn)], axis=-1)
    step = places[0, 1, 0] - places[0, 0, 0]
    found, on = np.zeros((rays, 3)), np.ones(rays, bool)
    for far in np.arange(0, 7, 0.25 * step):
        at = point + far * way
        before = (at - step * way - places[0, 0]) / (step, -step)  # in the air alone
        column, row = (np.clip(np.rint(before[:, n]).astype(int), 0, direct.shape[1 - n] - 1) for n in (0, 1))
        for (middle, sides), colour in zip(WALLS, colours, strict=True):
            hit = on & np.all(np.abs(at - middle) < np.array(sides) / 2, axis=-1)
            found[hit] = direct[row[hit], column[hit]] * share_of(colour)
            on &= ~hit
    return found.mean(axis=0)


def test_bounced_light_is_the_mean_of_what_rays_meet():
    game, colours = yard()
    light, places = light_of(game)
    game.lights.bounce = 0
    direct, _ = light_of(game)
    for point in [(-2.6, 0.0), (-2.0, -1.2), (0, 0.9), (-0.2, -1.4), (1.4, -0.9), (2.4, 0.1)]:
        row, column = np.argmin(np.abs(places[:, 0, 1] - point[1])), np.argmin(np.abs(places[0, :, 0] - point[0]))
        bounced = light[row, column] - direct[row, column]
        expected = followed(places[row, column], direct, places, colours)
        assert bounced == pytest.approx(expected, rel=0.12, abs=0.004), point


def test_walls_colour_what_is_near_them():
    game, _ = yard()
    light, places = light_of(game)
    at = lambda x, y: light[np.argmin(np.abs(places[:, 0, 1] - y)), np.argmin(np.abs(places[0, :, 0] - x))]  # noqa: E731
    beside_the_red, beside_the_green = at(-2.8, 0.5), at(0.36, -0.5)
    assert beside_the_red[0] > 1.3 * beside_the_red[1]
    assert beside_the_green[1] > 1.03 * beside_the_green[0]


def test_no_light_gets_into_a_closed_room():
    game = lit_game()
    game.lights.quality = "high"
    for at, sides in [((0, 1), (2.1, 0.1)), ((0, -1), (2.1, 0.1)), ((1, 0), (0.1, 2.1)), ((-1, 0), (0.1, 2.1))]:
        game.add(evil.Rectangle(*sides), at=at, kind="static", colour="white")
    turned = game.add(evil.Rectangle(3, 0.02), at=(-2.4, 0), angle=0.6, kind="static", colour="white")
    game.add_light(at=(0, 1.5), radius=20, falloff=0, intensity=3)
    light, places = light_of(game)
    room = np.all(np.abs(places) < 0.9, axis=-1)
    assert light[room].max() == 0
    assert turned.alive


def test_ambient_light_is_whole_in_the_open_and_less_in_corners():
    game = lit_game()
    game.ambient = 0.25
    game.lights.quality = "high"
    open_air = light_of(game)[0]
    assert np.abs(open_air - 0.25).max() < 0.002
    game.add(evil.Rectangle(6.4, 0.6), at=(0, -1.5), kind="static")
    game.add(evil.Rectangle(0.6, 3), at=(-2.9, 0), kind="static")
    light, places = light_of(game)
    column = np.argmin(np.abs(places[0, :, 0] + 2.5))
    rows = [np.argmin(np.abs(places[:, 0, 1] - y)) for y in (-1.15, -0.9, -0.5, 0.4)]
    up = light[rows, column, 0]
    assert np.all(np.diff(up) > 0), up
    assert up[0] < 0.75 * up[-1]
    assert light.max() <= open_air.max() * 1.01


def test_light_comes_the_same_from_every_side():
    game = lit_game()
    game.lights.quality = "high"
    for at, angle in [((1, 0), 0), ((-1, 0), 0), ((0, 1), np.pi / 2), ((0, -1), np.pi / 2)]:
        game.add(evil.Rectangle(0.2, 0.8), at=at, angle=angle, kind="static", colour="white")
    game.add_light(at=(0, 0), radius=5, falloff=1)
    light, places = light_of(game)
    game.lights.bounce = 0
    bounced = (light - light_of(game)[0])[..., 0]
    x, y = places[..., 0], places[..., 1]
    inner = np.max(np.abs(places), axis=-1) < 0.85
    means = [bounced[inner & half].mean() for half in (x < 0, x > 0, y < 0, y > 0, x > y, x < y, x > -y, x < -y)]
    assert min(means) > 0.2
    assert means == pytest.approx(np.full(8, np.mean(means)), rel=0.05)


@pytest.mark.parametrize("instructions", _core.instruction_sets())
@pytest.mark.parametrize("threads", [1, 3])
def test_bounced_light_has_the_same_bits_on_every_instruction_set_and_for_any_number_of_threads(instructions, threads):
    game, _ = yard(threads=threads)
    game.world._core.instruction_set = instructions
    one, _ = yard()
    assert _core.light_map(game._collect().content) == _core.light_map(one._collect().content)


@pytest.mark.parametrize("size", [(16, 9), (40, 300), (640, 20)])
def test_pictures_of_any_shape_have_bounced_light(size):
    game, _ = yard(size=size)
    light, _ = light_of(game)
    assert np.isfinite(light).all()


@pytest.mark.parametrize("turn", [0, 1, 2, 3])
def test_bumps_face_the_walls_that_send_light_on(tmp_path, turn):
    """A lit wall beside a floor that the lamp itself does not reach: slopes that face it are the brighter ones."""
    for name, x in (("near", 0.7), ("far", -0.7)):
        plain(tmp_path / f"{name}.png", normal_colour(*evil.Vec2(x, 0.0).turned(turn * math.pi / 2)))
    game = evil.Game(size=(240, 240), headless=True, renderer="soft", gravity=(0, 0), folder=tmp_path)
    game.lights.quality, game.ambient = "high", 0
    around = evil.Vec2(1.0, 0.0).turned(turn * math.pi / 2)
    side = around.turned(math.pi / 2)
    game.add(evil.Rectangle(0.3, 6), at=around * 2, angle=turn * math.pi / 2, kind="static", colour="white", lit=True)
    game.add_light(at=around * 1.6 + side * 1.5, direction=around, cone=2.5, radius=3, intensity=3)
    shown = {}
    for name in ("near", "far", None):
        game.draw(evil.Rectangle(4, 4), normal_map=name and f"{name}.png", colour="white", lit=True, outline=False)
        shown[name] = int(game.capture().pixels[120, 120, 0])
    assert shown["near"] > shown[None] + 10 > shown["far"] + 20


def test_how_much_bodies_send_on_is_saved_with_the_game():
    game, _ = yard()
    game.lights.bounce = 0.4
    other, _ = yard()
    saving.from_bytes(other, saving.to_bytes(game), "other")
    assert other.lights.bounce == 0.4
    with pytest.raises(evil.ArgumentError, match="bounce=-1"):
        game.lights.bounce = -1


def test_what_glows_lights_what_is_round_it_and_casts_shadows():
    game = lit_game()
    game.lights.quality = "high"
    sign = game.draw(evil.Rectangle(0.6, 0.6), at=(-2, 0), colour="#ff8000", outline=False)
    assert light_of(game)[0].max() == 0
    sign.glow = 1.0
    light, places = light_of(game)
    away = np.hypot(places[..., 0] + 2, places[..., 1])
    red = [light[(away > d - 0.1) & (away < d + 0.1), 0].mean() for d in (0.6, 1.0, 1.5, 2.2)]
    assert np.all(np.diff(red) < 0)
    seen = np.arctan2(0.3, 1.2) / np.pi  # the share of all directions in which it lies, from its side
    row, column = np.argmin(np.abs(places[:, 0, 1])), np.argmin(np.abs(places[0, :, 0] + 0.5))
    assert light[row, column, 0] == pytest.approx(seen, rel=0.15)
    assert light[row, column, 1] == pytest.approx(light[row, column, 0] * (128 / 255) ** GAMMA, rel=0.1)
    game.add(evil.Rectangle(0.1, 3), at=(-1, 0), kind="static", colour="black")
    shaded, _ = light_of(game)
    assert shaded[row, column].max() < 0.05 * light[row, column, 0]
