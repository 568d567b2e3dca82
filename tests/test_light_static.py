"""Lights that stand still are worked out once, and look as they would each frame."""

from __future__ import annotations

import random
import time
from collections.abc import Callable
from pathlib import Path

import pytest
from lighting import lit_game
from surfaces import surfaces

import evilengine as evil
from evilengine.game import saving

Change = Callable[[evil.Game], object]


def hall(static: bool) -> evil.Game:
    """Stones that stand, balls that fall, and lamps of each kind."""
    chance = random.Random(4)
    game = lit_game(size=(240, 136))
    for _ in range(12):
        at = chance.uniform(-2.4, 2.4), chance.uniform(-1.3, 1.3)
        game.add(evil.Rectangle(0.4, 0.2), at=at, angle=chance.uniform(0, 3), kind="static", lit=True, tag="stone")
    for _ in range(3):
        game.add(evil.Circle(0.1), at=(chance.uniform(-2, 2), 1.2), velocity=(0.4, -1), lit=True)
    game.add_light(at=(-1.5, 0.9), radius=4, colour="#ffd0a0", static=static)
    game.add_light(at=(1.5, -0.9), radius=3, size=0.05, shadows=False, static=static)
    game.add_light(at=(0.4, 1), direction=(0, -1), cone=1.2, radius=3, static=static)
    game.add_light(direction=(1, -1), intensity=0.2, static=static)
    return game


def stone(game: evil.Game) -> evil.Body:
    return game.world.find("stone")


def set_of(name: str, value: object) -> Change:
    def change(game: evil.Game) -> None:
        setattr(next(iter(game.lights)), name, value)

    return change


def add_a_wall(game: evil.Game) -> None:
    game.add(evil.Rectangle(0.2, 2), at=(0, 0), kind="static", lit=True)


def move_a_stone(game: evil.Game) -> None:
    stone(game).position = (0.1, 0.2)


def turn_a_stone(game: evil.Game) -> None:
    stone(game).angle += 1


def shift(game: evil.Game) -> None:
    game.camera.position = (game.camera.position.x + 0.37, game.camera.position.y - 0.11)


CHANGES: dict[str, Change] = {
    "nothing": lambda game: None,
    "a wall is added": add_a_wall,
    "a stone is moved": move_a_stone,
    "a stone is turned": turn_a_stone,
    "a stone is taken away": lambda game: stone(game).destroy(),
    "a stone gets a shape more": lambda game: stone(game).add_shape(evil.Circle(0.3)),
    "a stone may fall": lambda game: setattr(stone(game), "kind", "dynamic"),
    "another category": lambda game: setattr(stone(game), "category", 2),
    "the lamp's place": set_of("at", (-1, 0.2)),
    "its radius": set_of("radius", 2.5),
    "its size": set_of("size", 0.6),
    "its falloff": set_of("falloff", 0.5),
    "its colour": set_of("colour", "#40ff80"),
    "its intensity": set_of("intensity", 2.5),
    "its mask": set_of("mask", 2),
    "no shadows": set_of("shadows", False),
    "off": set_of("on", False),
    "the camera moves": shift,
    "the camera jumps": lambda game: setattr(game.camera, "position", (30, 20)),
    "it zooms": lambda game: setattr(game.camera, "zoom", 1.3),
    "it turns": lambda game: setattr(game.camera, "angle", 0.2),
    "quality": lambda game: setattr(game.lights, "quality", "low"),
    "high quality": lambda game: setattr(game.lights, "quality", "high"),
}


@pytest.mark.parametrize("change", CHANGES.values(), ids=CHANGES.keys())
def test_they_look_as_they_would_each_frame_whatever_changes(change: Change) -> None:
    pictures = []
    for static in (False, True):
        game = hall(static)
        frames = [bytes(game.capture().pixels)]
        for number in range(4):
            if number == 1:
                change(game)
            game.step(5)
            frames.append(bytes(game.capture().pixels))
        pictures.append(frames)
    assert pictures[0] == pictures[1]


def test_the_camera_may_go_to_and_fro() -> None:
    games = [hall(static) for static in (False, True)]
    for x, y in [(0.1, 0), (0.5, 0.3), (0.5, 1.2), (-0.7, 1.1), (-0.7, -2), (4, 0), (3.9, 0.04), (0, 0)]:
        for game in games:
            game.camera.position = (x, y)
        assert bytes(games[0].capture().pixels) == bytes(games[1].capture().pixels)


def test_a_lamp_on_a_body_may_be_static_too() -> None:
    games = [hall(False), hall(False)]
    for game, static in zip(games, (False, True), strict=True):
        ball = next(body for body in game.world.bodies if body.kind == "dynamic")
        game.add_light(body=ball, radius=2, static=static)
        for _ in range(3):
            game.step(4)
            game.capture()
    assert bytes(games[0].capture().pixels) == bytes(games[1].capture().pixels)


def test_bumps_are_the_same(tmp_path: Path) -> None:
    game = surfaces(tmp_path)
    plain = bytes(game.capture().pixels)
    for light in game.lights:
        light.static = True
    for _ in range(2):
        assert bytes(game.capture().pixels) == plain


def test_a_light_in_the_place_of_another_shows_nothing_of_it() -> None:
    game = hall(True)
    game.capture()
    next(iter(game.lights)).destroy()
    game.add_light(at=(1.2, 1), radius=4, colour="#ffd0a0", static=True)
    other = hall(False)
    next(iter(other.lights)).destroy()
    other.add_light(at=(1.2, 1), radius=4, colour="#ffd0a0")
    assert bytes(game.capture().pixels) == bytes(other.capture().pixels)


def test_restored_lights_show_the_world_that_was_restored() -> None:
    game = hall(True)
    then, data = bytes(game.capture().pixels), saving.to_bytes(game)
    move_a_stone(game)
    assert bytes(game.capture().pixels) != then
    saving.from_bytes(game, data, "saved")
    assert bytes(game.capture().pixels) == then


def test_eight_of_them_cost_less_than_half() -> None:
    chance = random.Random(2)
    times = {}
    for static in (False, True):
        game = lit_game(size=(640, 360))
        for _ in range(60):
            at = chance.uniform(-6, 6), chance.uniform(-3, 3)
            game.add(evil.Rectangle(0.4, 0.2), at=at, angle=chance.uniform(0, 3), kind="static", lit=True)
        for number in range(8):
            game.add_light(at=(-5 + 1.4 * number, chance.uniform(-2, 2)), radius=3.5, static=static)
        game._collect()
        fastest = 1.0
        for _ in range(12):
            start = time.perf_counter()
            game._collect()
            fastest = min(fastest, time.perf_counter() - start)
        times[static] = fastest
    assert times[True] < 0.5 * times[False]


@pytest.mark.parametrize("static", [False, True])
def test_without_shadows_every_light_shines_through_everything(static: bool) -> None:
    game = hall(static)
    game.capture()
    game.lights.shadows = False
    shadowless = bytes(game.capture().pixels)
    for light in game.lights:
        light.shadows = False
    game.lights.shadows = True
    assert bytes(game.capture().pixels) == shadowless
    game.lights.shadows = False
    game.lights.clear()
    assert game.lights.shadows
