"""Recordings: played again, all comes out as it did; where it does not, the step and the part are said."""

from __future__ import annotations

import errno
import os
import random
from dataclasses import replace

import pytest
from player import EXAMPLES, LEVELS, RICH, level_game, play, state

import evilengine as evil
from evilengine.game import Game, replaying
from evilengine.save import Recorder, Replay, inputs
from evilengine.save.replay import STEPS_A_SEAL
from evilengine.values.events import KEYBOARD_KEYS, PHASES, POINTER_BUTTONS, SensorEvent
from evilengine.values.inputs import Inputs, Keys, Pad, Pointer, Tilt, Touch
from evilengine.values.vec2 import Vec2


@pytest.fixture
def rich(tmp_path):
    path = tmp_path / "rich.evil"
    path.write_text(RICH)
    return path


def recorded(path, target, steps):
    """A level at `path`, played by the scripted player and recorded in `target`."""
    game = level_game(path)
    game._recorder = replaying.record(game, target, level=True)
    play(game, 0, steps)
    game.close()
    return game


def played_again(target):
    replay = Replay.read(target)
    game = replaying.game_of(replay, headless=True)
    playback = game._playback = replaying.play(game, replay)
    while not playback.over:
        game.step()
    return game, playback


def seen(game):
    world, picture, *_ = state(game)
    return world, picture, game.random.getstate()


# All as recorded ------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", LEVELS)
def test_an_example_is_played_again_to_the_last_bit(name, tmp_path):
    first = recorded(EXAMPLES / name, tmp_path / "r.evr", 250)
    second, playback = played_again(tmp_path / "r.evr")
    assert playback.difference is None
    assert seen(first) == seen(second)


def test_a_level_with_everything_is_played_again_to_the_last_bit(rich, tmp_path):
    first = recorded(rich, tmp_path / "r.evr", 600)
    rich.unlink()  # the recording holds the level
    second, playback = played_again(tmp_path / "r.evr")
    assert (playback.difference, playback.replay.complete, len(playback.replay.steps)) == (None, True, 600)
    assert seen(first) == seen(second)


def test_tilt_pads_wheel_and_a_window_of_another_size_are_in_it(tmp_path):
    path = tmp_path / "tilt.evil"
    path.write_text("view 16 9;\ntilt on;\nnew walls 15 8;\nnew circle ball 0.5 at 0 0 physicsOn touchable;\n")
    game = level_game(path)
    game._recorder = replaying.record(game, tmp_path / "r.evr", level=True)
    device = game.device
    for step in range(120):
        if step % 10 == 0:
            device.tilt(0.1 * (step % 7) - 0.3, -0.9, 0.2)
        if step == 20:
            device.resize((200, 300))
        if step == 30:
            device.pointer((90, 140), button="left", down=True)
        if 30 < step < 60:
            device.pointer((90 + step, 140))
        if step == 60:
            device.pointer(button="left", down=False)
            device.pad("left_x", -0.8)
            device.wheel(2)
        game.step()
    game.close()
    again, playback = played_again(tmp_path / "r.evr")
    assert playback.difference is None
    assert again.world.snapshot() == game.world.snapshot()
    assert again.camera.size == (200, 300)
    assert again.inputs == game.inputs


def test_the_players_own_hands_count_again_when_the_recording_is_over(rich, tmp_path):
    recorded(rich, tmp_path / "r.evr", 20)
    replay = Replay.read(tmp_path / "r.evr")
    game = replaying.game_of(replay, headless=True)
    game._playback = replaying.play(game, replay)
    game.device.key("right", down=True)
    game.step(20)
    assert not game.keys["right"]
    game.step()
    assert game.keys["right"]


def test_what_is_recorded_while_a_recording_is_played_is_the_same(rich, tmp_path):
    recorded(rich, tmp_path / "r.evr", 100)
    replay = Replay.read(tmp_path / "r.evr")
    game = replaying.game_of(replay, headless=True)
    game._playback = replaying.play(game, replay)
    game._recorder = replaying.record(game, tmp_path / "again.evr", level=True)
    game.step(100)
    game.close()
    again = Replay.read(tmp_path / "again.evr")
    assert [replace(step, between=()) for step in again.steps] == list(replay.steps)


# Games in Python ------------------------------------------------------------------------------------------------------


def python_game():
    game = Game("Recorded", size=(320, 180), headless=True)
    game.add(evil.Rectangle(12, 1), at=(0, -2), kind="static")
    game.ball = game.add(evil.Circle(0.5), at=(0, 2), touchable=True, tag="ball")

    @game.on_key_press
    def pressed(key):
        game.ball.apply_impulse((game.random.uniform(-1, 1), 3))

    return game


def press(game, steps):
    for step in range(steps):
        if step % 7 == 0:
            game.device.tap("space")
        game.step()


def test_a_python_game_records_and_plays_itself(tmp_path):
    game = python_game()
    with pytest.raises(evil.ArgumentTypeError, match=r"Game\.record: path=3"):
        game.record(3)
    recording = game.record(tmp_path / "r.evr")
    press(game, 50)
    recording.close()
    press(game, 10)
    again = python_game()
    playback = again.replay(tmp_path / "r.evr")
    again.step(50)
    assert (playback.over, playback.made, playback.difference) == (True, 50, None)
    assert again.ball.velocity != (0, 0)


def test_a_recording_may_begin_in_the_middle_with_a_game_that_can_be_saved(tmp_path):
    game = python_game()
    press(game, 33)
    game.record(tmp_path / "r.evr")
    press(game, 40)
    game.close()
    again = python_game()
    playback = again.replay(tmp_path / "r.evr")
    assert again.world.steps == 33
    again.step(40)
    assert (playback.over, playback.difference) == (True, None)
    assert again.world.snapshot() == game.world.snapshot()


def test_a_game_that_began_already_cannot_play_a_beginning(tmp_path):
    game = python_game()
    game.record(tmp_path / "r.evr")
    game.step(3)
    game.close()
    other = python_game()
    other.step()
    with pytest.raises(evil.Error, match="begins with the first step; this game has made 1"):
        other.replay(tmp_path / "r.evr")


def saver(folder):
    game = python_game()

    @game.on_key_press
    def keys(key):
        if key == "s":
            game.save("here", folder=folder)
        if key == "r":
            game.resume("here", folder=folder)

    return game


def test_games_that_were_resumed_while_recorded_are_resumed_again_without_the_disk(tmp_path):
    game = saver(tmp_path / "saves")
    game.record(tmp_path / "r.evr")
    for step in range(60):
        if step in (5, 30):
            game.device.tap("s")
        if step in (20, 45, 50):
            game.device.tap("r")
        if step % 7 == 0:
            game.device.tap("space")
        game.step()
    game.close()
    again = saver(tmp_path / "nothing here")
    playback = again.replay(tmp_path / "r.evr")
    again.step(60)
    assert playback.difference is None
    assert again.world.snapshot() == game.world.snapshot()
    assert not (tmp_path / "nothing here").exists(), "playing a recording saves nothing"


# Differences ----------------------------------------------------------------------------------------------------------


def rewritten(replay, target, steps):
    recorder = Recorder(target, replay.header, replay.state)
    for step in steps:
        recorder.begin_step(step.inputs, step.size)
        if step.sums is not None:
            recorder.end_step(step.sums)
        for resumed in step.between:
            recorder.resumed(resumed)
    recorder.close()


@pytest.mark.parametrize("at", [1, 37, 200])
def test_a_doctored_recording_is_caught_at_the_step(at, rich, tmp_path):
    recorded(rich, tmp_path / "r.evr", 250)
    replay = Replay.read(tmp_path / "r.evr")
    steps = list(replay.steps)
    doctored = replace(steps[at - 1].inputs, pressed=("space",) if not steps[at - 1].inputs.pressed else ())
    steps[at - 1] = replace(steps[at - 1], inputs=doctored)
    rewritten(replay, tmp_path / "doctored.evr", steps)
    _, playback = played_again(tmp_path / "doctored.evr")
    assert playback.difference is not None
    assert playback.difference.step == at
    assert playback.difference.modules[0] == "bodies"
    assert str(playback.difference).startswith(f"step {at} (")


@pytest.mark.parametrize(
    ("part", "change"),
    [
        ("random", lambda game: game.random.random()),
        ("timers", lambda game: game.timer.after(99, lambda: None)),
        ("forces", lambda game: setattr(game.world, "gravity", game.world.gravity * 1.0000002)),
        ("bodies", lambda game: setattr(game.ball, "tag", "other")),
    ],
)
def test_the_part_of_the_engine_that_differs_first_is_named(part, change, tmp_path):
    game = python_game()
    game.record(tmp_path / "r.evr")
    press(game, 60)
    game.close()
    again = python_game()

    @again.on_update
    def meddle(dt):
        if again.world.steps == 41:
            change(again)

    playback = again.replay(tmp_path / "r.evr")
    again.step(60)
    assert playback.difference is not None
    assert playback.difference.step == 42
    assert part in playback.difference.modules
    if part in ("random", "timers"):
        assert playback.difference.modules == (part,)


def test_a_large_world_is_summed_more_seldom(tmp_path):
    game = Game("Many", headless=True)
    for number in range(700):
        game.world.add(evil.Circle(0.1), at=(number, 0))
    game.record(tmp_path / "r.evr")
    game.step(12)
    game.close()
    steps = Replay.read(tmp_path / "r.evr").steps
    assert [number for number, step in enumerate(steps, 1) if step.sums] == [3, 6, 9, 12]


# Bad input ------------------------------------------------------------------------------------------------------------


@pytest.fixture
def short(tmp_path):
    path = tmp_path / "short.evil"
    path.write_text("new circle 1 at 0 0;\n")
    game = level_game(path)
    game._recorder = replaying.record(game, tmp_path / "r.evr", level=True)
    for key in ("a", "b"):
        game.device.tap(key)
        game.step(STEPS_A_SEAL // 2 + 2)
    game.close()
    return tmp_path / "r.evr"


def test_a_recording_cut_or_flipped_at_any_byte_is_refused(short):
    data = short.read_bytes()
    for at in range(len(data)):
        changed = bytearray(data)
        changed[at] ^= 1 << at % 8
        for bad in (data[:at], bytes(changed)):
            short.write_bytes(bad)
            with pytest.raises(evil.SaveError):
                Replay.read(short)


def test_a_recording_without_an_end_holds_the_steps_that_it_has(short):
    whole = Replay.read(short)
    data = short.read_bytes()
    data = data[:12] + bytes(8) + data[20:]  # as it is while it is written
    found = set()
    for at in range(len(data)):
        short.write_bytes(data[:at])
        try:
            cut = Replay.read(short)
        except evil.SaveError:
            continue
        assert not cut.complete
        assert [step.inputs for step in cut.steps] == [step.inputs for step in whole.steps[: len(cut.steps)]]
        found.add(len(cut.steps))
    assert found == set(range(len(whole.steps) + 1))


def test_a_recording_outlives_the_crash_that_it_is_to_explain(tmp_path):
    game = python_game()
    game.record(tmp_path / "r.evr")

    @game.on_key_press
    def crash(key):
        if key == "c":
            raise ZeroDivisionError

    press(game, 30)
    game.device.tap("c")
    with pytest.raises(ZeroDivisionError):
        game.step()
    replay = Replay.read(tmp_path / "r.evr")  # nobody has closed it
    assert not replay.complete
    assert replay.steps[-1].inputs.pressed == ("c",)
    game.close()


def test_other_files_and_other_versions_are_refused(tmp_path):
    path = tmp_path / "r.evr"
    for data in (b"", b"EVIL", b"\x89PNG\r\n\x1a\n" + bytes(100)):
        path.write_bytes(data)
        with pytest.raises(evil.SaveError, match="is not a recording"):
            Replay.read(path)
    path.write_bytes(b"EVILPLAY\x02\0\0\0" + bytes(8))
    with pytest.raises(evil.SaveError, match="another version"):
        Replay.read(path)
    with pytest.raises(evil.SaveError, match="there is no file"):
        Replay.read(tmp_path / "none.evr")


def test_a_full_disk_ends_the_recording_and_not_the_game(tmp_path, caplog):
    game = python_game()
    recording = game.record(tmp_path / "r.evr")
    game.step(5)

    class Full:
        def write(self, data):
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

        close = flush = lambda self: None

    file, recording._file = recording._file, Full()
    game.step(5)
    file.close()
    assert game.world.steps == 10
    assert not recording.is_open
    assert len(caplog.messages) == 1
    assert "cannot be written any more" in caplog.messages[0]
    with pytest.raises(evil.SaveError, match="cannot be written"):
        game.record(tmp_path / "no such folder" / "r.evr")


# Inputs as bytes ------------------------------------------------------------------------------------------------------


def any_inputs(rng):
    def vector():
        return Vec2(rng.choice([0.0, -0.0, 1e-300, rng.uniform(-1e6, 1e6)]), rng.uniform(-1, 1))

    def some(words):
        return tuple(rng.sample(words, rng.randrange(3)))

    def touch():
        finger = rng.choice([0, 7, -3, "mouse", "ü", "12"])
        return Touch(finger, rng.choice(PHASES), *(vector() for _ in range(4)), rng.random() < 0.5)

    keys = list(KEYBOARD_KEYS)
    reading = rng.choice([None, (0.1, -0.9, rng.uniform(-1, 1))])
    return Inputs(
        keys=Keys(some(keys)), pressed=some(keys), released=some(keys), text=rng.choice(["", "ä€", "a\0b", "\ud800"]),
        pointer=Pointer(*(vector() for _ in range(4)), *(some(list(POINTER_BUTTONS)) for _ in range(3))),
        wheel=vector(), touches=tuple(touch() for _ in range(rng.randrange(3))),
        touch_events=tuple(touch() for _ in range(rng.randrange(3))),
        tilt=Tilt(vector(), reading, rng.random() < 0.5, rng.random() < 0.5),
        pads=tuple(Pad(n, "pad", vector(), vector(), 0.5, 1.0, ("a", "b")) for n in range(rng.randrange(3))),
        sensors=(SensorEvent("gyroscope", (1.0, 2.0, 3.0)),) * rng.randrange(2),
    )  # fmt: skip


def test_inputs_come_back_from_their_bytes_exactly():
    rng = random.Random(1)
    for _ in range(300):
        some = any_inputs(rng)
        data = inputs.encode(some)
        assert inputs.decode(data) == some
        assert inputs.encode(inputs.decode(data)) == data, "signs of zero too"


def test_bytes_that_are_no_inputs_raise_nothing_but_value_errors():
    rng = random.Random(2)
    for _ in range(200):
        data = bytearray(inputs.encode(any_inputs(rng)))
        for _ in range(rng.randrange(1, 4)):
            data[rng.randrange(len(data))] = rng.randrange(256)
        try:
            again = inputs.decode(bytes(data[: rng.choice([len(data), rng.randrange(len(data))])]))
        except ValueError:
            continue
        assert isinstance(again, Inputs)
