"""Saved games: what was saved goes on as if it had never stopped, byte for byte, in this process and in another."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest
from player import EXAMPLES, LEVELS, RICH, digest, let_go, level_game, play, resumed, state

import evilengine as evil
from evilengine.game import Game, saving


@pytest.fixture
def rich(tmp_path):
    path = tmp_path / "rich.evil"
    path.write_text(RICH)
    return path


@pytest.mark.parametrize("name", LEVELS)
@pytest.mark.parametrize("stop", [0, 1, 25, 130])
def test_the_examples_go_on_as_if_they_had_never_stopped(name, stop):
    path = EXAMPLES / name
    game = level_game(path)
    play(game, 0, stop)
    data = saving.to_bytes(game)
    same, other = (
        resumed(data, level_game(path)),
        resumed(data, Game("Saved", size=(320, 180), headless=True, folder=EXAMPLES)),
    )
    let_go(game)
    for each in (game, same, other):
        play(each, 180, 300)
    assert state(game) == state(same) == state(other)


@pytest.mark.parametrize("stop", [0, 20, 60, 111, 200, 700])
def test_a_level_with_everything_goes_on_as_if_it_had_never_stopped(rich, stop):
    game = level_game(rich)
    play(game, 0, stop)
    data = saving.to_bytes(game)
    other = resumed(data, Game("Saved", size=(320, 180), headless=True))
    assert saving.to_bytes(other) == data, "what is saved is what was resumed"
    let_go(game)
    for each in (game, other):
        play(each, 720, 960)
    assert state(game) == state(other)


def test_a_game_can_be_taken_back_to_where_it_was_saved(rich):
    game = level_game(rich)
    play(game, 0, 50)
    data = saving.to_bytes(game)
    let_go(game)
    play(game, 60, 200)
    first = state(game)
    for _ in range(2):
        resumed(data, let_go(game))
        play(game, 60, 200)
        assert state(game) == first


OTHER_PROCESS = """
import hashlib, sys
sys.path.insert(0, sys.argv[1])
import player
game = player.Game("Saved", size=(320, 180), headless=True, folder=player.EXAMPLES)
game.resume("other", folder=sys.argv[2])
player.play(game, 180, 400)
print(player.digest(game))
"""


@pytest.mark.parametrize("name", ["prototype1.evil", "06_rounds.evil", "rich"])
def test_another_process_goes_on_as_if_it_had_never_stopped(name, rich, tmp_path):
    game = level_game(rich if name == "rich" else EXAMPLES / name)
    play(game, 0, 150)
    game.save("other", folder=tmp_path / "saves")
    let_go(game)
    play(game, 180, 400)
    command = [sys.executable, "-c", OTHER_PROCESS, str(Path(__file__).parent), str(tmp_path / "saves")]
    done = subprocess.run(command, capture_output=True, text=True, timeout=60, env=os.environ | {"PYTHONHASHSEED": "5"})
    assert done.stdout.strip() == digest(game), done.stderr


# Games in Python ------------------------------------------------------------------------------------------------------


class Wind(evil.Force):
    def __init__(self, strength):
        self.strength = strength
        self.blown = 0

    def apply(self, bodies, dt):
        self.blown += 1
        for body in bodies:
            body.apply_force((self.strength, 0))


heard = []


def ring():
    heard.append("ring")


def bump(contact):
    heard.append("bump")
    if contact.a.alive and contact.a.kind == "dynamic":
        contact.a.apply_impulse((0, 1))


def drift(dt):
    heard.append("drift")


def lift(time):
    return (4, -1 + 0.5 * (time % 2))


def python_game(title="Python"):
    game = Game(title, size=(320, 180), headless=True, seed=3)
    game.ground = game.add(evil.Rectangle(12, 1), at=(0, -2), kind="static", tag="ground")
    game.ball = game.add(evil.Circle(0.5), at=(0, 2), restitution=0.5, tag="ball", touchable=True)
    game.lift = game.add(evil.Rectangle(1, 0.2), at=(4, -1), kind="kinematic", tag="lift")
    return game


def furnish(game):
    game.ball.on_collide(bump)
    game.ball.on_update(drift)
    game.lift.follow(lift)
    game.world.add_force(Wind(0.3), [game.ball])
    game.world.add_force(evil.Spring(to=(0, 3), stiffness=0.5), [game.ball])
    game.event = game.timer.every(0.5, ring)
    game.timer.after(1.5, game.ground.destroy)
    game.sign = game.draw(evil.Triangle((0, 0), (1, 0), (0, 1)), at=(-3, 1), colour="gold", layer=2)
    game.ball.draw(evil.Rectangle(0.2, 0.6), colour="#00000080", layer=3)
    game.words = game.text("ready", at=(8, 8), colour="lime")
    game.camera.zoom, game.camera.angle, game.camera.position = 1.3, 0.2, (0.5, 0.25)
    game.add_background("navy")
    game.random.random()
    game.random.gauss()
    return game


def run(game, steps):
    for _ in range(steps):
        if game.ball.position.y < -4:
            game.ball.position = (game.random.uniform(-1, 1), 2)
        game.step()


def test_a_game_that_shall_destroy_what_is_gone_already_can_be_saved():
    game = Game("Saved", headless=True)
    ball, box = game.add(evil.Circle(1)), game.add(evil.Rectangle(1, 1))
    game.timer.after(0.5, ball.destroy)
    game.timer.after(0.5, box.destroy)
    ball.destroy()
    other = resumed(saving.to_bytes(game), Game("Saved", headless=True))
    assert saving.to_bytes(other) == saving.to_bytes(game)
    game.step(60)
    other.step(60)
    assert state(game) == state(other)
    assert len(other.world.bodies) == 0


def test_a_python_game_goes_on_with_its_timers_callbacks_motions_and_forces():
    game = furnish(python_game())
    run(game, 40)
    data = saving.to_bytes(game)
    heard.clear()
    run(game, 120)
    first, told = state(game), list(heard)
    assert set(told) == {"ring", "bump", "drift"}
    other = resumed(data, python_game())
    heard.clear()
    run(other, 120)
    assert state(other) == first
    assert heard == told


def test_handles_of_what_is_the_same_stay_good_and_others_are_stale(tmp_path):
    game = furnish(python_game())
    game.save("here", folder=tmp_path)
    later = game.add(evil.Circle(0.2), at=(1, 1))
    later_sign, later_words = game.draw(evil.Circle(1)), game.text("later")
    game.event.cancel()
    game.words.text, game.sign.layer = "changed", 7
    eye = game.ball.drawings[1]
    game.step(10)
    game.resume("here", folder=tmp_path)
    assert game.ball.position == (0, 2)
    assert game.ball is game.world.find("ball")
    assert (game.words.text, game.sign.layer, game.sign.alive) == ("ready", 2, True)
    assert [drawing == eye for drawing in game.ball.drawings] == [False, True]
    assert [later.alive, later_sign.alive, later_words.alive] == [False, False, False]
    assert game.event.alive is False, "an event that was cancelled is another one"
    assert len(game.timer) == 2


def test_an_event_that_still_waits_keeps_its_handle(tmp_path):
    game = furnish(python_game())
    game.save("here", folder=tmp_path)
    game.step(10)
    game.resume("here", folder=tmp_path)
    assert game.event.alive
    game.event.cancel()
    assert len(game.timer) == 1


@pytest.mark.parametrize(
    ("where", "do"),
    [
        ("game.timer, <Event at 1 s>: the function .*<lambda>", lambda game: game.timer.after(1.0, lambda: None)),
        ("on_collide of <DrawnBody 1 'ball'", lambda game: game.ball.on_collide(lambda contact: None)),
        ("on_update of <DrawnBody 1 'ball'", lambda game: game.ball.on_update(lambda dt: None)),
        ("the motion that <DrawnBody 2 'lift'", lambda game: game.lift.follow(lambda time: (4, 0))),
    ],
)
def test_a_function_without_a_name_is_an_error_that_says_which(where, do, tmp_path):
    game = python_game()
    game.save("here", folder=tmp_path)
    do(game)
    with pytest.raises(evil.SaveError, match=where):
        game.save("here", folder=tmp_path)
    game.resume("here", folder=tmp_path)


def test_a_force_of_a_class_without_a_name_is_an_error_that_says_which():
    class Local(evil.Force):
        def apply(self, bodies, dt):
            pass

    game = python_game()
    game.world.add_force(Local())
    with pytest.raises(evil.SaveError, match=r"Local .*cannot be saved: define .*Local at the top"):
        saving.to_bytes(game)


def test_registered_functions_come_back_and_missing_ones_leave_the_game_alone():
    def setup(game, log):
        return game.register("note it", lambda: log.append(game.world.steps))

    first, second = [], []
    game = python_game()
    game.timer.every(0.1, setup(game, first))
    data = saving.to_bytes(game)
    other = python_game()
    other.step(5)
    before = state(other)
    with pytest.raises(evil.SaveError, match=r"needs the function 'note it'; call game\.register\('note it', \.\.\.\)"):
        saving.from_bytes(other, data, "test.evs")
    assert state(other) == before
    setup(other, second)
    resumed(data, other)
    game.step(30)
    other.step(30)
    assert first == second == [6, 12, 18, 24]


def test_inside_a_callback_saving_and_resuming_wait_for_the_end_of_the_step(tmp_path):
    game = python_game()

    @game.on_key_press
    def key(key):
        if key == "s":
            game.save("here", folder=tmp_path)
            assert not (tmp_path / "here.evs").exists()
        if key == "r":
            game.resume("here", folder=tmp_path)
            assert game.world.steps == 19

    game.step(4)
    game.device.tap("s")
    game.step()
    after, place = game.world.steps, game.ball.position
    game.step(14)
    game.device.tap("r")
    game.step()
    assert (game.world.steps, game.ball.position) == (after, place) == (5, place)


def test_what_the_player_held_is_let_go_of(tmp_path):
    game = python_game()
    released, touches = [], []
    game.on_key_release(released.append)
    game.on_touch(lambda touch: touches.append((touch.phase, touch.cancelled)))
    game.device.key("right", down=True)
    game.device.touch(1, "began", at=game.camera.to_pixel(game.ball.position))
    game.step(3)
    assert len(game.ball.forces) == 1
    data = saving.to_bytes(game)
    assert len(game.ball.forces) == 1, "saving changes nothing"
    other = python_game()
    other.on_key_release(released.append)
    other.on_touch(lambda touch: touches.append((touch.phase, touch.cancelled)))
    resumed(data, other)
    assert other.keys["right"]
    touches.clear()
    other.step()
    assert (released, touches) == (["right"], [("ended", True)])
    assert not other.keys["right"]
    assert other.ball.forces == ()


def test_paused_tilt_and_the_window_are_as_they_should_be(tmp_path):
    game = python_game()
    game.tilt = True
    game.device.tilt(1, 0)
    game.step(2)
    game.paused = True
    data = saving.to_bytes(game)
    other = resumed(data, Game("Python", size=(640, 360), headless=True))
    assert (other.paused, other.tilt, other.camera.size) == (True, True, (640, 360))
    assert other.world.gravity == game.world.gravity
    other.step(5)
    game.step(5)
    assert other.world.snapshot() == game.world.snapshot()


def test_images_come_back_by_name_and_a_missing_one_leaves_the_game_alone(tmp_path):
    evil.Image.of(2, 2, bytes(range(16))).save(tmp_path / "a.png")
    evil.Image.of(1, 1, bytes((255, 0, 0, 255))).save(tmp_path / "b.png")
    game = Game("Images", size=(64, 64), headless=True, folder=tmp_path)
    game.draw(evil.Rectangle(1, 1), texture="b.png")
    game.add(evil.Rectangle(1, 1), texture="a.png", at=(0, 0.5)).drawings[0].texture_matrix = (0.5, 0, 0, 0.5, 0, 0)
    data = saving.to_bytes(game)
    other = Game("Images", size=(64, 64), headless=True, folder=tmp_path)
    other.text("fonts take numbers of textures too")
    other.capture()
    resumed(data, other)
    assert other.capture().tobytes() == game.capture().tobytes()
    assert next(iter(other.world.bodies)).drawings[0].texture == "a.png"
    (tmp_path / "b.png").unlink()
    third = Game("Images", size=(64, 64), headless=True, folder=tmp_path)
    with pytest.raises(evil.SaveError, match=r"b\.png"):
        saving.from_bytes(third, data, "test.evs")
    assert len(third.world.bodies) == 0
