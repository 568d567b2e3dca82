"""`evil play` saves when its window closes or it is told to end, and `--resume` goes on from there."""

from __future__ import annotations

import itertools
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

import evilengine as evil
from evilengine.cli import autosave, main
from evilengine.cli.player import Player
from evilengine.game import saving
from evilengine.platform import HeadlessDevice
from evilengine.values.tick import STEP

LEVEL = (
    "seed 4;\nnew walls 16 9;\nlet n 0;\nevery 0.5 { new circle 0.2 at random(-5, 5) 3 physicsOn; set n (n + 1); }\n"
)


@pytest.fixture(autouse=True)
def saves(monkeypatch, tmp_path):
    monkeypatch.setenv("EVILENGINE_SAVES", str(tmp_path / "saves"))
    return tmp_path / "saves" / "autosave"


@pytest.fixture
def level(tmp_path):
    path = tmp_path / "level.evil"
    path.write_text(LEVEL)
    return path


class Closing(HeadlessDevice):
    """A window that its player closes after so many frames."""

    def __init__(self, frames):
        super().__init__((320, 180))
        self.vsync = True
        self.frames = frames

    def poll(self):
        self.frames -= 1
        if self.frames < 0:
            self.close()
        return super().poll()


def play(path, frames=30, **options):
    count = itertools.count()
    player = Player(path, device=Closing(frames), clock=lambda: next(count) * STEP, **options)
    assert player.play() == 0
    return player.game


def test_a_closed_window_is_resumed_where_it_was(level):
    first = play(level, 90)
    stopped = first.world.steps
    second = play(level, 60, resume=True)
    assert 85 <= stopped < second.world.steps
    other = evil.Game(headless=True)
    saving.resume(other, *autosave.slot_of(level))
    assert other.world.snapshot() == second.world.snapshot()
    assert play(level, 30).world.steps < 40, "without --resume it begins anew"


def test_the_hint_of_the_player_is_no_part_of_the_saved_game(level):
    game = play(level, 30)
    assert game.scene.overlay is not None
    other = evil.Game(headless=True)
    saving.resume(other, *autosave.slot_of(level))
    assert other.scene._texts == other.scene._overlay == []
    assert len(other.timer) == 1


def test_two_levels_of_one_name_have_a_save_each(level, tmp_path):
    (tmp_path / "other").mkdir()
    other = tmp_path / "other" / "level.evil"
    other.write_text("new circle ball 0.5 at 0 0;\n")
    play(level, 90)
    play(other, 20)
    assert len(play(level, 2, resume=True).world.bodies) > 1
    assert len(play(other, 2, resume=True).world.bodies) == 1


def test_a_level_that_changed_goes_on_as_it_was_saved_and_says_so(level, capsys):
    play(level, 30)
    level.write_text("new circle 0.5 at 0 0;\n")
    game = play(level, 2, resume=True)
    assert game.levels[0].script.text == LEVEL
    assert "level.evil has changed since" in capsys.readouterr().err


def test_resuming_what_was_never_played_is_one_line(level, capsys, monkeypatch):
    with pytest.raises(evil.SaveError, match="nothing is saved"):
        play(level, 2, resume=True)
    assert main(["play", "--resume"]) == 1
    assert "nothing was played yet" in capsys.readouterr().err


def test_without_a_name_the_game_played_last_is_resumed(level, tmp_path, saves):
    other = tmp_path / "other.evil"
    other.write_text("new circle ball 0.5 at 0 0;\n")
    for number, path in enumerate((other, level)):
        play(path, 5)
        os.utime(autosave.slot_of(path)[1], (number, number))
    assert autosave.newest() == level.resolve()
    level.unlink()
    with pytest.raises(evil.SaveError, match=r"level\.evil, which was played last, is not there"):
        autosave.newest()


def test_a_python_game_is_resumed_when_it_runs(tmp_path, capsys):
    path = tmp_path / "game.py"
    path.write_text(
        "import evilengine as evil\n"
        "game = evil.Game('Mine', size=(320, 180))\n"
        "ball = game.add(evil.Circle(0.5), at=(0, 3))\n"
        "def ring():\n    ball.apply_impulse((0.1, 0))\n"
        "game.timer.every(0.25, ring)\n"
        "game.run()\n"
    )
    stopped = play(path, 40).world.steps
    game = play(path, 40, resume=True)
    assert game.world.steps > stopped + 30
    assert game.world.find("x") is None
    assert next(iter(game.world.bodies)).velocity.x > 0.4
    assert capsys.readouterr().err == ""


def test_a_game_that_cannot_be_saved_says_why_in_one_line(tmp_path, capsys):
    path = tmp_path / "game.py"
    path.write_text("import evilengine as evil\ngame = evil.Game()\ngame.timer.every(1, lambda: None)\ngame.run()\n")
    play(path, 3)
    told = capsys.readouterr().err
    assert told.count("\n") == 1
    assert told.startswith("evil: game.py cannot be resumed later: Game.save: game.timer, <Event at 1 s, every 1 s>")


def test_a_game_that_failed_is_not_saved(tmp_path, saves):
    path = tmp_path / "game.py"
    path.write_text(
        "import evilengine as evil\ngame = evil.Game()\n@game.on_update\ndef f(dt):\n    1 / 0\ngame.run()\n"
    )
    with pytest.raises(ZeroDivisionError):
        play(path, 3)
    assert not saves.exists()


def test_a_film_may_begin_where_the_window_was_closed(level, tmp_path):
    play(level, 200)
    assert main(["play", str(level), "--film", str(tmp_path / "new.png"), "--seconds", "0.1", "--size", "160x90"]) == 0
    resumed = [
        "play",
        str(level),
        "--resume",
        "--film",
        str(tmp_path / "later.png"),
        "--seconds",
        "0.1",
        "--size",
        "160x90",
    ]
    assert main(resumed) == 0
    assert (tmp_path / "new.png").read_bytes() != (tmp_path / "later.png").read_bytes()


PLAYER = """
import sys
from pathlib import Path
from evilengine.cli.player import Player
from evilengine.platform import HeadlessDevice

class Device(HeadlessDevice):
    def show(self, pixels, size):
        super().show(pixels, size)
        print("frame", flush=True)

sys.exit(Player(Path(sys.argv[1]), device=Device((160, 90)), resume=len(sys.argv) > 2).play())
"""


@pytest.mark.skipif(sys.platform == "win32", reason="signals")
@pytest.mark.parametrize(("number", "code"), [(signal.SIGTERM, 143), (signal.SIGINT, 130)])
def test_told_to_end_the_game_is_saved_first(number, code, level):
    process = subprocess.Popen([sys.executable, "-c", PLAYER, str(level)], stdout=subprocess.PIPE, text=True)
    assert process.stdout is not None
    for _ in range(20):
        process.stdout.readline()
    process.send_signal(number)
    process.stdout.read()
    process.stdout.close()
    assert process.wait(timeout=30) == code
    game = evil.Game(headless=True)
    saving.resume(game, *autosave.slot_of(level))
    assert game.world.steps >= 15


@pytest.mark.skipif(sys.platform == "win32", reason="kill -9 is a signal")
def test_killed_outright_the_save_before_is_still_there(level):
    play(level, 40)
    steps = play(level, 2, resume=True).world.steps
    process = subprocess.Popen([sys.executable, "-c", PLAYER, str(level), "resume"], stdout=subprocess.PIPE, text=True)
    assert process.stdout is not None
    process.stdout.readline()
    time.sleep(0.05)
    process.kill()
    process.stdout.close()
    process.wait()
    game = evil.Game(headless=True)
    saving.resume(game, *autosave.slot_of(level))
    assert game.world.steps == steps


def test_the_slot_of_a_file_with_an_odd_name_is_a_name(tmp_path):
    for name in ("ä ö.evil", "x" * 200 + ".evil", "..evil", "日本.py"):
        assert autosave.slot_of(Path(name))[1].suffix == ".evs"
