"""`evil play --record` and `evil replay`, as a person in a terminal would use them."""

from __future__ import annotations

import itertools
import shutil
import subprocess
import sys

import pytest
from PIL import Image

from evilengine.cli import main
from evilengine.cli.player import Player
from evilengine.platform import HeadlessDevice
from evilengine.save import Replay
from evilengine.values.tick import STEP

GAME = """
import evilengine as evil
game = evil.Game("Mine", size=(320, 180))
ball = game.add(evil.Circle(0.5), at=(0, {height}))
@game.on_key_press
def pressed(key):
    ball.apply_impulse((1, 0))
    if key == "x":
        1 / 0
game.run()
"""


@pytest.fixture
def here(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for name in ("DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER"):
        monkeypatch.delenv(name, raising=False)
    (tmp_path / "level.evil").write_text("new walls 16 9;\nnew circle ball 0.5 at 0 3 physicsOn touchable;\n")
    (tmp_path / "game.py").write_text(GAME.format(height=2))
    return tmp_path


class Hands(HeadlessDevice):
    """A window whose player presses space now and then, and closes it after so many frames."""

    def __init__(self, frames, keys=None):
        super().__init__((320, 180))
        self.vsync = True
        self.keys = keys or {}
        self.count = itertools.count()
        self.frames = frames

    def poll(self):
        frame = next(self.count)
        if frame in self.keys:
            self.tap(self.keys[frame])
        if frame >= self.frames:
            self.close()
        return super().poll()


def record(path, target, frames=50, keys=None, **options):
    count = itertools.count()
    device = Hands(frames, keys or {10: "space", 30: "space"})
    player = Player(path, device=device, record=target, clock=lambda: next(count) * STEP, **options)
    player.play()
    return player.game


def test_a_level_is_recorded_and_played_again(here, capsys):
    game = record(here / "level.evil", here / "r.evr")
    (here / "level.evil").unlink()
    assert main(["replay", "r.evr"]) == 0
    steps = game.world.steps
    assert capsys.readouterr().out == f"r.evr: {steps} steps ({steps * STEP:.1f} s), all as recorded\n"


def test_a_game_in_python_is_recorded_and_played_again(here, capsys):
    record(here / "game.py", here / "r.evr")
    assert main(["replay", "r.evr", "--headless"]) == 0
    assert "all as recorded" in capsys.readouterr().out


def test_a_resumed_game_is_recorded_and_played_again(here, capsys):
    for name in ("level.evil", "game.py"):
        record(here / name, here / "first.evr")
        record(here / name, here / "second.evr", resume=True)
        assert Replay.read(here / "second.evr").state is not None
        assert main(["replay", "second.evr", "--headless"]) == 0
        assert "all as recorded" in capsys.readouterr().out


def test_starting_again_starts_another_recording(here):
    record(here / "level.evil", here / "r.evr", frames=60, keys={20: "r", 40: "f5"})
    assert [len(Replay.read(here / name).steps) > 10 for name in ("r.evr", "r-2.evr", "r-3.evr")] == [True] * 3


def test_a_film_of_a_recording(here, capsys):
    record(here / "level.evil", here / "r.evr", frames=60)
    assert main(["replay", "r.evr", "-o", "film.webp", "--size", "160x90", "--fps", "30"]) == 0
    with Image.open(here / "film.webp") as film:
        assert film.size == (160, 90)
        assert 20 <= film.n_frames <= 32
    assert main(["replay", "r.evr", "-o", "film.mp4"]) == 1
    assert "film.mp4 must end in" in capsys.readouterr().err


def test_a_film_is_recorded_too(here, capsys):
    assert (
        main(["play", "level.evil", "--record", "r.evr", "--film", "a.png", "--seconds", "1", "--size", "160x90"]) == 0
    )
    assert main(["replay", "r.evr"]) == 0
    assert "all as recorded" in capsys.readouterr().out


def test_a_game_that_changed_must_be_named_and_its_difference_is_told(here, capsys):
    record(here / "game.py", here / "r.evr")
    (here / "game.py").write_text(GAME.format(height=2.5))
    assert main(["replay", "r.evr"]) == 1
    assert "another game.py" in capsys.readouterr().err
    assert main(["replay", "r.evr", "game.py"]) == 1
    out, err = capsys.readouterr()
    assert "game.py has changed since" in err
    assert "first differs from the recording at step 1 (0.02 s) in bodies" in out


def test_a_game_that_was_moved_is_played_where_it_is(here, capsys):
    record(here / "game.py", here / "r.evr")
    (here / "elsewhere").mkdir()
    (here / "game.py").rename(here / "elsewhere" / "game.py")
    assert main(["replay", "r.evr"]) == 1
    assert "which is not there; name it" in capsys.readouterr().err
    assert main(["replay", "r.evr", "elsewhere/game.py"]) == 0


def test_a_fault_happens_again_when_its_recording_is_played(here, capsys):
    with pytest.raises(ZeroDivisionError):
        record(here / "game.py", here / "r.evr", keys={25: "x"})
    assert Replay.read(here / "r.evr").complete, "the player closed it"
    with pytest.raises(ZeroDivisionError):
        main(["replay", "r.evr"])


def test_a_program_that_records_itself_does_not_write_over_its_recording(here, capsys):
    source = GAME.format(height=2).replace("game.run()", "game.record('own.evr')\ngame.run()")
    (here / "game.py").write_text(source)
    record(here / "game.py", None)
    data = (here / "own.evr").read_bytes()
    assert main(["replay", "own.evr"]) == 0
    assert "all as recorded" in capsys.readouterr().out
    assert (here / "own.evr").read_bytes() == data


def test_what_cannot_be_played_again_is_one_line(here, capsys):
    (here / "bad.evr").write_bytes(b"not a recording")
    for words, told in (
        (["replay", "bad.evr"], "is not a recording"),
        (["replay", "none.evr"], "there is no file none.evr"),
        (["play", "level.evil", "--record", "r.webp"], "must end in .evr"),
        (["play", "level.evil", "--record", "no/folder/r.evr", "--film", "a.png"], "cannot be written"),
    ):
        assert main(words) == 1
        err = capsys.readouterr().err
        assert told in err
        assert err.count("\n") == 1


@pytest.mark.skipif(not shutil.which("xvfb-run"), reason="needs xvfb-run, a screen in memory")
def test_a_real_window_plays_a_recording(here):
    record(here / "level.evil", here / "r.evr", frames=30)
    command = ["xvfb-run", "-a", sys.executable, "-m", "evilengine", "replay", "r.evr"]
    done = subprocess.run(command, capture_output=True, text=True, timeout=60)
    assert (done.returncode, done.stderr) == (0, "")
    assert "all as recorded" in done.stdout
