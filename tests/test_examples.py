"""Every example that ships is played: it runs, it moves, it shows something, and it does so again alike."""

from __future__ import annotations

import os
import subprocess
import sys

import numpy as np
import pytest

from evilengine.cli import sources
from evilengine.cli.stage import perform
from evilengine.platform import HeadlessDevice

EXAMPLES = sources.examples()
GAMES = [example for example in EXAMPLES if example.path.suffix == ".py"]


class Seconds:
    """A stage that plays a few seconds and keeps the game and its last picture."""

    def __init__(self, seconds, act=lambda game: None):
        self.steps = round(60 * seconds)
        self.act = act

    def open(self, title, size):
        return HeadlessDevice(size, title=title)

    def run(self, game):
        self.first = game.capture()
        for _ in range(self.steps):
            self.act(game)
            game.step()
        self.last = game.capture()
        self.game = game


def play(name, seconds, act=lambda game: None):
    stage = Seconds(seconds, act)
    perform(sources.example(name).path, stage)
    return stage


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda example: example.name)
def test_it_runs_moves_and_shows_something(example):
    stage = play(example.name, 3)
    assert len(stage.game.world.bodies) > 1
    assert len(stage.game.scene) > 3
    colours = {bytes(stage.last.tobytes()[at : at + 4]) for at in range(0, len(stage.last.tobytes()), 4 * 97)}
    assert len(colours) >= 4
    assert stage.first.tobytes() != stage.last.tobytes()


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda example: example.name)
def test_it_plays_the_same_twice(example):
    assert play(example.name, 3).game.world.checksum() == play(example.name, 3).game.world.checksum()


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda example: example.name)
def test_nothing_leaves_the_picture(example):
    """After a while everything is still in the room or was destroyed; nothing fell through a wall."""
    game = play(
        example.name, 8, lambda game: game.device.tilt(*((1, -1) if game.world.steps % 240 < 120 else (-1, -1)))
    ).game
    for body in game.world.bodies:
        assert abs(body.position.x) < 30
        assert abs(body.position.y) < 30


@pytest.mark.parametrize("example", GAMES, ids=lambda example: example.name)
def test_it_is_short_enough_to_read(example):
    a_whole_game = sources.things_of(example.path).exists()
    assert 15 <= len(example.path.read_text().splitlines()) < (150 if a_whole_game else 61)


@pytest.mark.parametrize("example", GAMES, ids=lambda example: example.name)
def test_it_runs_as_a_module_without_a_screen(example):
    screenless = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}
    done = subprocess.run(
        [sys.executable, "-m", f"evilengine.examples.{example.name}"],
        capture_output=True,
        text=True,
        env={**screenless, "SDL_VIDEODRIVER": ""},
        timeout=240,
    )
    assert done.returncode == 0, done.stderr
    assert "screen" in done.stderr


def test_bodies_rain_and_land():
    stage = play("bodies", 8)
    assert any(body.tag == "ball" for body in stage.game.world.bodies)


def test_the_chain_of_springs_holds_and_swings():
    links = [body for body in play("springs", 6).game.world.bodies if body.kind == "dynamic"]
    assert len(links) == 6
    assert all(body.position.y < 4 for body in links)
    assert max(body.position.length for body in links) < 20


def test_a_tap_bursts_a_balloon():
    tapped = []

    def tap(game):
        if game.world.steps == 30:
            balloon = next(body for body in game.world.bodies if body.tag == "balloon")
            game.device.touch(1, "began", at=game.camera.to_pixel(balloon.position))
            tapped.append(balloon)

    play("touch", 1, tap)
    assert [balloon.alive for balloon in tapped] == [False]


class Tower:
    """The tower example, played by a hand that knows when to let go: `play` lets `act(game, tower)` see each step."""

    def __init__(self, seconds, act):
        self.rounds = []

        def watch(game):
            tower = sys.modules["__main__"].tower  # the script that plays
            if tower not in self.rounds:
                self.rounds.append(tower)
            act(game, tower)

        self.game = play("tower", seconds, watch).game


def press(game, key="space"):
    game.device.key(key, down=True)
    game.device.key(key, down=False)


def test_the_tower_plays_by_itself_until_somebody_comes():
    heard = set()
    shown = Tower(12, lambda game, tower: heard.update(sound.name for sound in game.audio.sounds))
    (alone,) = shown.rounds
    assert not alone.somebody
    assert alone.points >= 3
    assert {"tower/music.ogg", "tower/thud.ogg"} <= heard

    def come(game, tower):
        if game.world.steps == 300:
            game.device.touch(1, "began", at=(240, 360))

    first, second = Tower(8, come).rounds
    assert not first.somebody
    assert second.somebody
    assert second.points == 0  # it waits for the player


def test_a_good_hand_builds_a_tower_and_a_bad_one_loses_its_hearts():
    def play_well(game, tower):
        if not tower.somebody:
            press(game)
        else:
            standing = [thing.position.x for thing in tower.things if thing is not tower.falling]
            drift = 0.35 * (1 if tower.crane.x > last[0] else -1)
            if abs(tower.crane.x + drift - (standing[-1] if standing else 0)) < 0.1 and tower.held.alive:
                press(game)
            last[0] = tower.crane.x

    last = [0.0]
    good = Tower(20, play_well).rounds[-1]
    assert good.somebody
    assert good.points >= 8
    assert good.climbed > 0.5  # the camera went along

    def play_badly(game, tower):
        if not tower.somebody or tower.over_for > 1 or (tower.hearts and abs(tower.crane.x) > 2.7):
            press(game)

    shown, lost, again = Tower(11, play_badly).rounds
    assert not shown.somebody
    assert (lost.hearts, lost.points) == (0, 0)
    assert again.hearts > 0
    assert again.somebody


def test_the_hero_is_steered_over_the_hills_and_the_bear_after_a_tab():
    def steer(game):
        if game.world.steps == 0:
            game.device.key("right", down=True)
        if game.world.steps == 120:
            game.device.key("tab", down=True)

    stage = play("hero", 4, steer)
    fox, bear = stage.game.world.characters
    assert fox.velocity.x == 0, "it stands since the tab"
    assert fox.position.x > -9
    assert bear.velocity.x > 4
    assert bear.position.x > -16


def test_the_second_prototype_is_lit_by_moon_and_fire():
    game = play("prototype2", 1).game
    assert len(game.lights) == 7
    lit = np.array(game.capture().pixels).astype(int)
    for light in game.lights:
        light.on = False
    dark = np.array(game.capture().pixels).astype(int)
    assert lit[..., :3].mean() > 1.2 * dark[..., :3].mean()
    red, blue = lit[..., 0] - dark[..., 0], lit[..., 2] - dark[..., 2]
    assert red[380:500, 470:500].mean() > blue[380:500, 470:500].mean()  # by the fire
    assert blue[340:400, 720:800].mean() > red[340:400, 720:800].mean()  # in the beam of the moon
