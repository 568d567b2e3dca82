"""Scenes: they switch and restart, everything of the one before is gone, and saves, resumes and replays know them."""

from __future__ import annotations

import gc
import weakref

import pytest

import evilengine as evil
from evilengine.game import Game, saving


def ring() -> None:
    """A function that a save finds again."""


def make(tmp_path=None):
    """A menu that passes on to play when a key is pressed; play ends by itself, and r begins it again."""
    game = Game("Scenes", size=(320, 180), headless=True, folder=tmp_path)
    game.told = []

    @game.on_update
    def always(dt):
        game.told.append("always")

    @game.scenes
    def menu():
        game.text("space", anchor="centre", at=(0, 0))
        game.camera.zoom = 2.0

        @game.on_key_press
        def begin(key):
            game.told.append("menu key")
            game.go("play", 2)

    @game.scenes
    def play(count=1):
        game.world.gravity = (0, -5)
        game.add(evil.Rectangle(9, 1), at=(0, -2), kind="static")
        for n in range(count):
            game.add(evil.Circle(0.4), at=(n, game.random.uniform(1, 2)), tag=f"ball {n}", touchable=True)
        game.timer.every(0.25, ring)

        @game.on_key_press
        def pressed(key):
            game.told.append("play key")
            if key == "r":
                game.restart()

    return game


def test_everything_of_the_scene_before_is_gone():
    game = make()
    game.go("play", 3)
    game.add_background("red")
    ball = game.world.find("ball 1")
    drawing, text = ball.drawings[0], game.text("here")
    event, alone = game.timer.every(1, ring), game.draw(evil.Circle(1))
    force = ball.add_force(evil.Spring(to=(0, 5)))
    ball.on_collide(lambda contact: game.told.append("hit"))
    game.camera.position, game.tilt, game.speed = (3, 4), True, 0.5
    game.device.touch(1, "began", at=game.camera.to_pixel(ball.position))
    game.step(20)
    assert len(game._grabs.state()) == 1
    game.go("menu")
    assert [each.alive for each in (ball, drawing, text, event, alone, force)] == [False] * 6
    assert (len(game.world.bodies), len(game.scene), len(game.timer), len(game.world.forces)) == (0, 0, 0, 0)
    assert (game.world.gravity, game.camera.position, game.camera.zoom) == (evil.World().gravity, (0, 0), 2.0)
    assert (game.tilt, game.speed, game.paused, game.world.steps, game.timer.time) == (False, 1.0, False, 0, 0.0)
    assert game.scene.background == make().scene.background
    assert len(game._grabs.state()) == 0
    with pytest.raises(evil.StaleReferenceError):
        ball.position  # noqa: B018
    game.step(5)
    assert "hit" not in game.told


def test_callbacks_of_a_scene_end_with_it_and_those_of_the_game_stay():
    game = make()
    game.go("menu")
    game.device.tap("space")
    game.step()
    game.device.tap("a")
    game.step()
    assert game.told == ["menu key", "always", "play key", "always"]
    assert game.scenes.present == "play"
    assert len(game.world.bodies) == 3


def test_what_the_game_was_told_before_it_began_lasts(levels):
    game = Game("Own", size=(320, 180), headless=True, folder=levels)
    game.world.gravity, game.tilt = (0, -2), True
    game.camera.fit(4, 3)
    game.add_background("navy")
    game.load("one.evil")
    own = game.on_key_release(lambda key: None)
    begun = (game.camera._fit, game.scene.background)
    assert game.world.gravity == (0, -3)
    game.step()
    game.on_key_release(lambda key: None)
    game.camera.fit(9, 9)
    game.add_background("red")
    game.tilt = False
    game.scenes("empty")(lambda: None)
    game.go("empty")
    assert (game.world.gravity, game.tilt, list(game.on_key_release)) == ((0, -2), True, [own])
    assert (game.camera._fit, game.scene.background) == begun
    game.go("one.evil")
    assert game.world.gravity == (0, -3)


def test_a_scene_asked_for_in_a_step_begins_when_the_step_is_over():
    game = make()
    seen = []

    @game.scenes
    def other():
        seen.append(("other", game.world.steps))

    game.go("play")
    game.on_update(lambda dt: game.go("other"))
    game.on_update(lambda dt: seen.append(("still", len(game.world.bodies))))
    game.step()
    assert seen == [("still", 2), ("other", 0)]
    assert len(game.world.bodies) == 0


def test_of_several_scenes_asked_for_in_a_step_the_last_one_begins():
    game = make()
    begun = []
    for name in ("a", "b"):
        game.scenes(name)(lambda name=name: begun.append(name))
    game.go("play")
    game.timer.after(0, lambda: (game.go("a"), game.go("b"), game.go("a")))
    game.step()
    assert begun == ["a"]


def test_a_scene_may_pass_on_to_another_but_not_in_circles():
    game = make()
    game.scenes("first")(lambda: game.go("menu"))
    game.scenes("ping")(lambda: game.go("pong"))
    game.scenes("pong")(lambda: game.go("ping"))
    game.go("first")
    assert game.scenes.present == "menu"
    with pytest.raises(evil.Error, match="passed on to each other"):
        game.go("ping")
    game.go("play")
    game.step(3)
    assert game.scenes.present == "play"


def test_restart_begins_the_scene_again_with_its_arguments():
    game = make()
    game.go("play", 4)
    first = [body.position.x for body in game.world.bodies]
    game.step(30)
    game.restart()
    assert [body.position.x for body in game.world.bodies] == first
    assert (game.world.steps, len(game.timer), game.scenes.present) == (0, 1, "play")


def test_a_scene_that_fails_to_begin_leaves_nothing_half_built():
    game = make()

    @game.scenes
    def broken():
        game.add(evil.Circle(1))
        game.on_draw(lambda: None)
        game.timer.after(1, ring)
        raise RuntimeError("no")

    game.go("play")
    with pytest.raises(RuntimeError, match="no"):
        game.go("broken")
    assert (len(game.world.bodies), len(game.timer), len(game.on_draw)) == (0, 0, 0)
    game.go("menu")
    game.step()


def test_what_cannot_be_gone_to_is_said_and_the_scene_plays_on(tmp_path):
    game = make(tmp_path)
    (tmp_path / "bad.evil").write_text("new circel 1 at 0 0;\n")
    game.go("play")
    for bad, error, words in (
        (("plya",), evil.ArgumentError, "did you mean 'play'"),
        (("none.evil",), evil.AssetError, "none.evil"),
        (("bad.evil",), evil.LevelError, "circel"),
        ((7,), evil.ArgumentTypeError, "must be the name of a scene"),
        (("play", object()), evil.ArgumentTypeError, "can be saved"),
        (("play", float("nan")), evil.ArgumentTypeError, "can be saved"),
    ):
        with pytest.raises(error, match=words):
            game.go(*bad)
    with pytest.raises(evil.ArgumentError, match="sounds='loud' must be one of"):
        game.go("menu", sounds="loud")
    assert (game.scenes.present, len(game.world.bodies)) == ("play", 2)


def test_scenes_are_made_once_and_have_names():
    game = make()
    with pytest.raises(evil.ArgumentError, match="already"):
        game.scenes("menu")(lambda: None)
    with pytest.raises(evil.ArgumentError, match="cannot be called"):
        game.scenes(lambda: None)
    with pytest.raises(evil.ArgumentError, match="cannot be called"):
        game.scenes("x.evil")(lambda: None)
    with pytest.raises(evil.ArgumentTypeError, match="must be a function"):
        game.scenes("x")(7)
    assert (list(game.scenes), len(game.scenes), "menu" in game.scenes) == (["menu", "play"], 2, True)
    with pytest.raises(evil.Error, match="no scene has begun"):
        game.restart()


def test_sounds_end_with_their_scene_or_go_on_as_asked():
    game = make()
    game.audio.add("hum", [0.1] * 48000)
    game.go("play")

    def start():
        return game.audio.play("hum", loop=True)

    one = start()
    game.go("menu")
    assert not one.alive
    two = start()
    game.go("play", sounds="keep")
    assert two.alive
    game.restart()
    assert not two.alive


def test_a_hundred_restarts_keep_nothing_of_the_scenes_before():
    game = make()
    game.go("play", 5)
    gone = [weakref.ref(body) for body in game.world.bodies]
    counts = set()
    for _ in range(100):
        game.step()
        game.restart()
        gc.collect(0)
        counts.add((len(game.on_key_press), len(game.world._handles), len(game.scene._core), len(game.timer)))
    gc.collect()
    assert len(counts) == 1
    assert [each() for each in gone] == [None] * 6


# Levels -------------------------------------------------------------------------------------------------------------


@pytest.fixture
def levels(tmp_path):
    (tmp_path / "one.evil").write_text('gravity 0 -3;\nnew circle ball 0.5 at 0 2 physicsOn tag "one";\n')
    (tmp_path / "two.evil").write_text(
        "seed 3;\nnew walls 15 8;\nevery 0.1 times 3 { new circle 0.3 at random(-3, 3) 0 physicsOn; }\n"
        'new circle late 0.2 at 0 1 physicsOn;\non key "k" { impulse late 1 1; }\n'
    )
    return tmp_path


def test_a_level_is_a_scene(levels):
    game = make(levels)
    game.go("one.evil")
    assert (game.scenes.present, len(game.levels), game.world.gravity) == ("one.evil", 1, (0, -3))
    game.go("two.evil")
    assert (game.scenes.present, len(game.levels), game.world.gravity) == ("two.evil", 1, evil.World().gravity)
    assert game.world.find("one") is None
    game.step(30)
    before = game.world.snapshot()
    (levels / "two.evil").unlink()
    game.restart()
    game.step(30)
    assert game.world.snapshot() == before, "a level that starts again plays the same, by its seed"
    with pytest.raises(evil.ArgumentError, match="takes no arguments"):
        game.go("one.evil", 3)


def test_a_level_that_was_loaded_by_itself_can_start_again(levels):
    game = make(levels)
    game.load("one.evil")
    game.step(30)
    game.restart()
    assert (game.scenes.present, game.world.steps, len(game.world.bodies)) == ("one.evil", 0, 1)


# Saving -------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("elsewhere", [None, "menu", "play", "one.evil"])
@pytest.mark.parametrize("saved", ["play", "two.evil"])
def test_a_resume_goes_to_the_scene_that_was_saved(saved, elsewhere, levels):
    first = make(levels)
    first.go(saved, *([3] if saved == "play" else []))
    first.step(25)
    first.speed = 0.5
    data = saving.to_bytes(first)
    second = make(levels)
    second.random.seed(99)
    if elsewhere is not None:
        second.go(elsewhere)
        second.step(7)
    saving.from_bytes(second, data, "x.evs")
    assert second.scenes.present == saved
    assert second.speed == 0.5
    for game in (first, second):
        game.device.tap("k")
        game.step(40)
        game.restart()
        game.step(20)
    assert first.world.snapshot() == second.world.snapshot()
    assert first.capture().tobytes() == second.capture().tobytes()
    assert second.told.count("play key") == (saved == "play")


def test_a_save_of_a_scene_that_is_not_there_changes_nothing():
    first = make()
    first.scenes("secret")(lambda: None)
    first.go("secret")
    data = saving.to_bytes(first)
    second = make()
    second.go("play", 2)
    second.step(9)
    before = second.world.snapshot()
    with pytest.raises(evil.SaveError, match="'secret', which this game does not have"):
        saving.from_bytes(second, data, "x.evs")
    assert (second.world.snapshot(), second.scenes.present) == (before, "play")


def test_a_save_without_a_scene_leaves_the_scene():
    first = make()
    first.add(evil.Circle(1))
    data = saving.to_bytes(first)
    second = make()
    second.go("play", 2)
    saving.from_bytes(second, data, "x.evs")
    assert (second.scenes.present, len(second.world.bodies), len(second.on_key_press)) == (None, 1, 0)


# Replays ------------------------------------------------------------------------------------------------------------


def drive(game, hands=True):
    """Scenes gone to inside steps (by keys), between them (by hand), and by a level."""
    if hands:
        game.go("menu")
    game.step(5)
    for count in range(120):
        if hands and count in (3, 60, 61, 90):
            game.device.tap("r" if count == 60 else "space")
        if hands and count == 40:
            game.restart()
        if hands and count == 80:
            game.go("two.evil")
        if hands and count == 100:
            game.paused = True
            game.frame(0.0)
            game.restart()
        if hands and count == 110:
            game.go("play", 3)
        game.step()


def test_scenes_are_replayed_whether_steps_or_hands_asked_for_them(levels):
    first = make(levels)
    first.record(levels / "r.evr")
    drive(first)
    first.close()
    (levels / "two.evil").unlink()  # the recording holds the level
    second = make(levels)
    playback = second.replay(levels / "r.evr")
    drive(second, hands=False)
    assert (playback.over, playback.difference) == (True, None)
    assert second.world.snapshot() == first.world.snapshot()
    assert second.scenes.present == "play"


def test_hands_that_do_the_same_again_do_it_once(levels):
    first = make(levels)
    first.record(levels / "r.evr")
    drive(first)
    first.close()
    second = make(levels)
    playback = second.replay(levels / "r.evr")
    drive(second)
    assert (playback.over, playback.difference) == (True, None)
    assert second.world.snapshot() == first.world.snapshot()


def test_hands_cannot_go_elsewhere_while_a_recording_plays(levels):
    first = make(levels)
    first.go("play")
    first.step(5)
    first.record(levels / "r.evr")
    first.step(30)
    first.close()
    second = make(levels)
    playback = second.replay(levels / "r.evr")  # of a game that had begun: it starts with a saved game
    assert second.scenes.present == "play"
    second.step(10)
    second.go("menu")
    assert second.scenes.present == "play"
    second.step(20)
    assert (playback.over, playback.difference) == (True, None)
    second.go("menu")
    assert second.scenes.present == "menu"
