"""The window of `evil play`, on a device whose player follows a script."""

from __future__ import annotations

import itertools
import os
import shutil
import subprocess
import sys

import pytest

from evilengine.cli.player import HINT_SECONDS, WATCH_SECONDS, Player
from evilengine.platform import HeadlessDevice
from evilengine.values.tick import STEP

LEVEL = "tilt on;\nnew walls 16 9;\nnew circle ball 0.5 at 0 3 physicsOn;\n"
WATCH = round(WATCH_SECONDS / STEP) + 2
"""Frames after which a changed file has been noticed."""


class Scripted(HeadlessDevice):
    """Its player does one thing a frame, and closes the window after the last."""

    def __init__(self):
        super().__init__((320, 180))
        self.vsync = True  # nobody need wait
        self.script = iter(())

    def poll(self):
        if next(self.script, "over") == "over":
            self.close()
        return super().poll()


def play(path, script):
    """Play `path` at sixty frames a second; the generator `script(player, device)` goes on a frame each `yield`."""
    count = itertools.count()
    device = Scripted()
    player = Player(path, device=device, clock=lambda: next(count) * STEP)
    device.script = script(player, device)
    player.play()
    assert not device.is_open
    return player


def rewrite(path, text):
    before = path.stat()
    path.write_text(text)
    os.utime(path, ns=(before.st_atime_ns, before.st_mtime_ns + 1_000_000))


def frames(count):
    return itertools.repeat(None, count)


@pytest.fixture
def level(tmp_path):
    path = tmp_path / "level.evil"
    path.write_text(LEVEL)
    return path


def test_it_plays_until_the_window_is_closed(level):
    def script(player, device):
        yield from frames(30)

    assert 28 <= play(level, script).game.world.steps <= 30


def test_it_stops_after_the_seconds_it_was_given(level):
    count = itertools.count()
    device = Scripted()
    device.script = frames(10_000)
    player = Player(level, device=device, seconds=1.0, clock=lambda: next(count) * STEP)
    player.play()
    assert 55 <= player.game.world.steps <= 61


def test_escape_quits(level):
    def script(player, device):
        yield from frames(5)
        device.tap("escape")
        yield from frames(1000)

    assert play(level, script).game.world.steps <= 6


@pytest.mark.parametrize("key", ["f2", "p"])
def test_a_key_pauses_and_goes_on(level, key):
    counts = []

    def script(player, device):
        yield from frames(10)
        device.tap(key)
        yield
        counts.append(player.game.world.steps)
        yield from frames(30)
        counts.append(player.game.world.steps)
        device.tap(key)
        yield from frames(10)
        counts.append(player.game.world.steps)

    play(level, script)
    assert counts[0] == counts[1]
    assert counts[2] - counts[1] in (9, 10, 11)


@pytest.mark.parametrize("key", ["f3", "period"])
def test_a_key_makes_one_step_while_paused_and_none_otherwise(level, key):
    counts = []

    def script(player, device):
        yield
        device.tap("p")
        yield
        for _ in range(3):
            counts.append(player.game.world.steps)
            device.tap(key)
            yield from frames(2)
        device.tap("p")
        yield
        device.tap(key)
        steps = player.game.world.steps
        yield
        assert player.game.world.steps <= steps + 2

    play(level, script)
    assert counts == [counts[0], counts[0] + 1, counts[0] + 2]


def test_f1_shows_the_debug_view_which_outlives_a_new_beginning(level):
    seen = []

    def script(player, device):
        yield
        device.tap("f1")
        yield
        seen.append(player.game.debug)
        device.tap("r")
        yield from frames(3)
        seen.append((player.game.world.steps < 5, player.game.debug))
        device.tap("f1")
        yield
        seen.append(player.game.debug)

    play(level, script)
    assert seen == [True, (True, True), False]


def test_starting_again_begins_the_level_anew_in_the_same_window(level):
    games = []

    def script(player, device):
        yield from frames(60)
        games.append(player.game)
        device.tap("r")
        yield from frames(3)
        games.append(player.game)
        assert player.game.device is device

    play(level, script)
    first, second = games
    assert first is not second
    assert first.world.steps > 50 > 5 > second.world.steps


def test_a_changed_level_is_loaded_again(level):
    def script(player, device):
        yield from frames(5)
        rewrite(level, LEVEL + "new circle 0.3 at 1 1 physicsOn;\n")
        yield from frames(WATCH)
        assert len([body for body in player.game.world.bodies if body.kind == "dynamic"]) == 2

    play(level, script)


def test_a_changed_level_with_errors_is_shown_with_them_and_the_old_one_plays_on(level, capsys):
    def script(player, device):
        yield from frames(5)
        old = player.game
        plain = device.shown.tobytes()
        rewrite(level, LEVEL + "new circel 0.3 at 1 1 physicsOn;\n")
        yield from frames(WATCH)
        assert player.game is old
        assert "level.evil:4:5: error" in player._failure.text
        assert device.shown.tobytes() != plain
        steps = old.world.steps
        yield from frames(10)
        assert old.world.steps > steps
        rewrite(level, LEVEL)
        yield from frames(WATCH)
        assert player.game is not old
        assert player._failure is None

    play(level, script)
    assert "did you mean 'circle'" in capsys.readouterr().err


def test_a_level_that_vanishes_for_a_moment_plays_on(level):
    def script(player, device):
        yield
        old = player.game
        level.unlink()
        yield from frames(WATCH)
        assert player.game is old
        level.write_text(LEVEL + "new circle 0.3 at 1 1 physicsOn;\n")
        yield from frames(WATCH)
        assert player.game is not old

    play(level, script)


def test_a_hint_says_the_keys_and_goes_away(level):
    level.write_text("view 16 9;\n")
    colours = []

    def script(player, device):
        for count in (2, round(HINT_SECONDS / STEP)):
            yield from frames(count)
            shown = device.shown.tobytes()
            colours.append(len({shown[at : at + 4] for at in range(0, len(shown), 4)}))

    play(level, script)
    assert colours[0] > 10
    assert colours[1] == 1


@pytest.mark.skipif(not shutil.which("xvfb-run"), reason="needs xvfb-run, a screen in memory")
def test_a_real_window_plays_without_a_word(level):
    command = ["xvfb-run", "-a", sys.executable, "-m", "evilengine", "play", str(level), "--seconds", "0.5"]
    done = subprocess.run(command, capture_output=True, text=True, timeout=60)
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")


def test_a_game_in_python_starts_again_from_its_first_line(tmp_path):
    path = tmp_path / "game.py"
    path.write_text(
        "import evilengine as evil\ngame = evil.Game('Mine', size=(320, 180))\n"
        "game.add(evil.Circle(0.5))\nrunning = True\n"
        "try:\n    game.run()\nexcept Exception:\n    raise SystemExit('swallowed')\n"
    )
    games = []

    def script(player, device):
        yield from frames(20)
        games.append(player.game)
        device.tap("r")
        yield from frames(5)
        assert player.game is games[0], "letters belong to the game"
        device.tap("f5")
        yield from frames(5)
        games.append(player.game)
        assert device.title == "Mine"

    play(path, script)
    assert games[0] is not games[1]
    assert games[1].world.steps < 10


def test_an_exception_in_a_game_closes_the_window(tmp_path):
    path = tmp_path / "game.py"
    path.write_text(
        "import evilengine as evil\ngame = evil.Game()\n@game.on_update\ndef fail(dt):\n    1 / 0\ngame.run()\n"
    )
    device = HeadlessDevice((320, 180))
    with pytest.raises(ZeroDivisionError):
        Player(path, device=device).play()
    assert not device.is_open
