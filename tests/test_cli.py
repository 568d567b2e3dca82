"""The `evil` command, driven as a person in a terminal would."""

from __future__ import annotations

import argparse
import importlib.util
import io
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest
from PIL import Image

import evilengine
from evilengine.cli import COMMANDS, doctor, film, main, options, sources
from evilengine.cli.stage import perform
from evilengine.platform import HeadlessDevice
from evilengine.renderer.report import Graphics, graphics
from evilengine.values.errors import ArgumentError


@pytest.fixture
def here(tmp_path, monkeypatch):
    """An empty folder to run commands in."""
    monkeypatch.chdir(tmp_path)
    return tmp_path


class Steps:
    """A stage that plays some steps, with `act` before each."""

    def __init__(self, steps, act=lambda game: None):
        self.steps = steps
        self.act = act

    def open(self, title, size):
        return HeadlessDevice(size, title=title)

    def run(self, game):
        self.game = game
        for _ in range(self.steps):
            self.act(game)
            game.step()


@pytest.fixture
def no_screen(monkeypatch):
    for name in ("DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER"):
        monkeypatch.delenv(name, raising=False)


@pytest.fixture
def level(here):
    """A level in which a ball falls."""
    path = here / "ball.evil"
    path.write_text('new walls 16 9;\nnew circle 0.5 at 0 3 physicsOn colour "red";\n')
    return path


def fail_with(monkeypatch, error):
    def run(args):
        raise error

    monkeypatch.setattr("evilengine.cli.examples.run", run)


# the command itself


@pytest.mark.parametrize("words", [[], ["--help"], ["-h"], ["help"]])
def test_help_lists_every_command_with_a_line(words, capsys):
    assert main(words) == 0
    lines = capsys.readouterr().out.splitlines()
    for name in COMMANDS:
        (line,) = (line for line in lines if line.startswith(f"  {name} "))
        assert len(line.split()) > 3
        assert len(line) < 120


@pytest.mark.parametrize("name", COMMANDS)
def test_each_command_explains_itself(name, capsys):
    assert main([name, "--help"]) == 0
    told = capsys.readouterr().out
    assert main(["help", name]) == 0
    assert capsys.readouterr().out == told
    assert told.startswith(f"usage: evil {name}")


def test_version_is_the_package_version(capsys):
    assert main(["--version"]) == 0
    assert capsys.readouterr().out == f"evil {evilengine.__version__}\n"
    written = tomllib.loads((Path(__file__).parent.parent / "pyproject.toml").read_text())
    assert written["project"]["version"] == evilengine.__version__


def test_an_unknown_command_is_answered_with_the_nearest(capsys):
    assert main(["pley"]) == 2
    said = capsys.readouterr()
    assert said.out == ""
    assert "'pley'" in said.err
    assert "did you mean 'play'?" in said.err


def test_help_on_an_unknown_command_is_wrong_usage(capsys):
    assert main(["help", "rendr"]) == 2
    assert "did you mean 'render'?" in capsys.readouterr().err


def test_unknown_arguments_are_wrong_usage(capsys):
    assert main(["examples", "--nonsense"]) == 2
    assert "--nonsense" in capsys.readouterr().err


def test_an_error_of_ours_is_one_line_and_exit_code_1(monkeypatch, capsys):
    fail_with(monkeypatch, ArgumentError("the moon is full"))
    assert main(["examples"]) == 1
    assert capsys.readouterr().err == "evil: the moon is full\n"


def test_debug_shows_where_an_error_comes_from(monkeypatch, capsys):
    fail_with(monkeypatch, ArgumentError("the moon is full"))
    assert main(["--debug", "examples"]) == 1
    said = capsys.readouterr().err
    assert "Traceback" in said
    assert said.endswith("evil: the moon is full\n")


def test_an_interrupt_is_quiet(monkeypatch, capsys):
    fail_with(monkeypatch, KeyboardInterrupt())
    assert main(["examples"]) == 130
    assert capsys.readouterr() == ("", "")


def test_it_runs_as_a_module():
    done = subprocess.run([sys.executable, "-m", "evilengine", "--version"], capture_output=True, text=True)
    assert (done.returncode, done.stdout) == (0, f"evil {evilengine.__version__}\n")


def test_a_reader_who_stops_reading_causes_no_traceback():
    command = f"{sys.executable} -m evilengine help | true"
    done = subprocess.run(["bash", "-c", command], capture_output=True, text=True)
    assert done.stderr == ""


@pytest.mark.parametrize("text", ["", "960", "960x", "x540", "0x0", "-5x10", "0x9", "99999x10", "1e3x5"])
def test_a_size_that_is_none_is_refused(text):
    with pytest.raises(argparse.ArgumentTypeError, match="WIDTHxHEIGHT"):
        options.size(text)


@pytest.mark.parametrize("text", ["nan", "inf", "-1", "0", "soon", "1e9"])
def test_a_time_that_is_none_is_refused(text):
    with pytest.raises(argparse.ArgumentTypeError, match="seconds"):
        options.seconds(text)


# examples


def test_examples_lists_each_with_what_it_is(capsys):
    assert main(["examples"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert [line.split()[0] for line in lines] == [example.name for example in sources.examples()]
    assert all(len(line.split()) > 3 for line in lines)
    assert "prototype1" in capsys.readouterr().out or any(line.startswith("prototype1 ") for line in lines)


def test_an_example_can_be_copied_but_never_over_a_file(here, capsys):
    assert main(["examples", "--copy", "prototype1"]) == 0
    copied = here / "prototype1.evil"
    assert copied.read_text() == sources.example("prototype1").path.read_text()
    assert capsys.readouterr().out == "prototype1.evil\n"
    copied.write_text("mine")
    assert main(["examples", "--copy", "prototype1"]) == 1
    assert copied.read_text() == "mine"
    assert "exists already" in capsys.readouterr().err
    assert main(["examples", "--copy", "prototype1", "--to", "other/folder"]) == 0
    assert (here / "other" / "folder" / "prototype1.evil").exists()


def test_an_example_is_copied_with_its_pictures_and_sounds(here, capsys):
    assert main(["examples", "--copy", "tower", "--to", "mine"]) == 0
    assert (here / "mine" / "08_tower.py").exists()
    assert (here / "mine" / "tower" / "crate.png").read_bytes()[1:4] == b"PNG"
    assert main(["render", "mine/08_tower.py", "-o", "tower.png", "--at", "0.1"]) == 0
    (here / "mine" / "08_tower.py").unlink()
    assert main(["examples", "--copy", "tower", "--to", "mine"]) == 1
    assert "exists already" in capsys.readouterr().err
    assert not (here / "mine" / "08_tower.py").exists()


def test_an_unknown_example_is_answered_with_the_nearest(here, capsys):
    assert main(["examples", "--copy", "prototipe1"]) == 1
    assert "did you mean 'prototype1'?" in capsys.readouterr().err
    assert list(here.iterdir()) == []


def test_the_number_of_an_example_may_be_left_out():
    for example in sources.examples():
        assert sources.example(example.name.lstrip("0123456789").lstrip("_")) == example


# doctor


def test_doctor_says_what_it_found(capsys):
    assert main(["doctor"]) == 0
    told = capsys.readouterr().out
    for subject in ("Python", "EvilEngine", "core", "renderer", "devices", "pictures", "fonts"):
        assert f" {subject} " in told
    assert evilengine.__version__ in told


@pytest.mark.parametrize(("found", "told", "advice"), [
    (Graphics("A real card", "1.0", False, ""), "gl: A real card, 1.0 (auto takes it)", ""),
    (Graphics("llvmpipe", "1.0", True, ""), "gl: llvmpipe, 1.0 (a program on the processor, so auto takes soft)", ""),
    (Graphics("", "", False, "no driver; apt install one"), "gl: no driver, so auto takes soft", "apt install one"),
])  # fmt: skip
def test_doctor_names_the_driver_that_draws(monkeypatch, found, told, advice):
    monkeypatch.setattr("evilengine.renderer.report.graphics", lambda: found)
    (finding,) = (each for each in doctor.examine() if each.found.startswith("gl:"))
    assert finding.found == told
    assert advice in finding.advice


def test_doctor_asks_the_real_driver_and_survives_having_none(monkeypatch):
    found = graphics()
    assert bool(found.renderer) != bool(found.problem)
    monkeypatch.setattr("evilengine.renderer.gl.moderngl_device.make_headless", lambda: 1 / 0)
    assert graphics() == Graphics("", "", False, "division by zero")


@pytest.mark.parametrize("there", [True, False])
def test_doctor_says_when_letters_are_not_kerned(monkeypatch, there):
    monkeypatch.setattr(importlib.util, "find_spec", lambda name: object() if there else None)
    advised = [each.advice for each in doctor.examine() if "uharfbuzz" in each.advice]
    assert len(advised) == (not there)


def test_doctor_survives_a_check_that_fails(monkeypatch, capsys):
    def broken():
        raise OSError("the floor is lava")

    monkeypatch.setitem(doctor.CHECKS, "renderer", broken)
    assert main(["doctor"]) == 0
    told = capsys.readouterr().out
    assert "! renderer   cannot be used: OSError: the floor is lava" in told
    assert "-> install it again" in told
    assert " fonts " in told


def test_doctor_says_what_to_do_about_a_missing_screen(no_screen):
    (finding,) = (each for each in doctor.examine() if "no screen" in each.found)
    assert finding.advice


# new


def test_a_new_game_runs_as_it_is(here, capsys):
    assert main(["new", "space_cats"]) == 0
    assert sorted(path.name for path in (here / "space_cats").iterdir()) == ["README.md", "game.py", "level.evil"]
    assert main(["check", "space_cats/level.evil"]) == 0
    assert main(["render", "space_cats/game.py", "-o", "cats.png", "--at", "1", "--size", "320x180"]) == 0
    with Image.open("cats.png") as picture:
        assert picture.size == (320, 180)


def test_a_new_game_can_be_played_with_keys(here):
    main(["new", "cats"])
    stage = Steps(90, lambda game: game.device.key("right", down=True))
    perform(here / "cats" / "game.py", stage)
    (ball,) = (body for body in stage.game.world.bodies if body.touchable)
    assert ball.position.x > 1


def test_new_never_writes_into_a_folder_that_exists(here, capsys):
    (here / "mine").mkdir()
    (here / "mine" / "game.py").write_text("precious")
    assert main(["new", "mine"]) == 1
    assert "exists already" in capsys.readouterr().err
    assert (here / "mine" / "game.py").read_text() == "precious"


@pytest.mark.parametrize("name", ["", "..", 'a"b', "x\ny", "{}", "semi;colon"])
def test_new_refuses_names_that_cannot_be_a_folder_and_a_title(here, name, capsys):
    assert main(["new", name]) == 1
    assert "evil" in capsys.readouterr().err
    assert list(here.iterdir()) == []


# render


def frames_of(path):
    with Image.open(path) as picture:
        shown = []
        for number in range(picture.n_frames):
            picture.seek(number)
            shown.append(picture.convert("RGB").tobytes())
        return shown


@pytest.mark.parametrize("ending", ["webp", "gif", "png"])
def test_a_film_has_the_size_and_the_length_that_were_asked_for(level, ending, capsys):
    command = ["render", "ball.evil", "-o", f"film.{ending}", "--size", "160x90", "--seconds", "0.5", "--fps", "10"]
    assert main(command) == 0
    assert capsys.readouterr() == (f"film.{ending}\n", "")
    with Image.open(f"film.{ending}") as picture:
        assert picture.size == (160, 90)
    shown = frames_of(f"film.{ending}")
    assert len(shown) == 5
    assert len(set(shown)) == 5


@pytest.mark.parametrize("size", [(1, 1), (7, 3), (16, 600), (8192, 16)])
def test_a_picture_may_have_any_size(level, size):
    for ending in ("png", "webp"):
        name = f"picture.{ending}"
        assert main(["render", "ball.evil", "-o", name, "--at", "0.1", "--size", "{}x{}".format(*size)]) == 0
        with Image.open(name) as picture:
            assert picture.size == size


def test_a_picture_shows_the_moment_that_was_asked_for(level):
    for name, moment in (("a", "0"), ("b", "0"), ("c", "0.5")):
        assert main(["render", "ball.evil", "-o", f"{name}.png", "--at", moment, "--size", "160x90"]) == 0
    a, b, c = (frames_of(f"{name}.png")[0] for name in "abc")
    assert a == b != c


def test_another_size_shows_the_same_in_other_pixels(level):
    main(["render", "ball.evil", "-o", "large.png", "--at", "0", "--size", "960x540"])
    main(["render", "ball.evil", "-o", "small.png", "--at", "0", "--size", "240x135"])
    main(["render", "ball.evil", "-o", "high.png", "--at", "0", "--size", "240x300"])
    for name, ball in (("large", (480, 120)), ("small", (120, 30)), ("high", (120, 30 + 165 // 2))):
        with Image.open(f"{name}.png") as picture:
            assert picture.convert("RGB").getpixel(ball)[0] > 200


def test_the_debug_view_can_be_rendered(level):
    main(["render", "ball.evil", "-o", "plain.png"])
    main(["render", "ball.evil", "-o", "debug.png", "--debug-view"])
    assert frames_of("plain.png") != frames_of("debug.png")


def test_a_film_of_a_level_with_tilt_sways_unless_told_not_to(level):
    level.write_text("tilt on;\n" + level.read_text())
    for name, tilt in (("swayed", "sway"), ("upright", "off")):
        assert main(["render", "ball.evil", "-o", f"{name}.png", "--at", "1", "--tilt", tilt]) == 0
    assert frames_of("swayed.png") != frames_of("upright.png")


def test_the_hand_that_sways_goes_to_both_sides_at_one_g():
    readings = [film.sway(second / 10) for second in range(51)]
    assert max(x for x, _ in readings) > 0.8
    assert min(x for x, _ in readings) < -0.8
    assert all(x * x + y * y == pytest.approx(1) for x, y in readings)


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["-o", "film.mp4"], "must end in"),
        (["-o", "film"], "must end in"),
        (["-o", "a.png", "--at", "1", "--seconds", "1"], "give one of them"),
        (["-o", "no/such/folder/a.png"], "no/such/folder"),
        (["-o", "a.webp", "--seconds", "3600", "--fps", "120"], "frames"),
    ],
)
def test_what_cannot_be_rendered_is_one_clear_line(level, words, said, capsys):
    assert main(["render", "ball.evil", *words]) == 1
    told = capsys.readouterr().err
    assert said in told
    assert told.count("\n") == told.count("evil: ") == 1


@pytest.mark.parametrize("name", ["nowhere.evil", "nowhere.py", "nowhere", "."])
def test_what_is_not_there_is_one_clear_line(here, name, capsys):
    assert main(["render", name, "-o", "a.png"]) == 1
    assert name in capsys.readouterr().err
    assert list(here.iterdir()) == []


def test_a_level_with_errors_tells_them_all_and_makes_no_film(level, capsys):
    level.write_text("new rectangel 1 1 0 0;\nnew circle -1 0 0;\n")
    assert main(["render", "ball.evil", "-o", "film.webp"]) == 1
    told = capsys.readouterr().err
    assert "ball.evil:1:5" in told
    assert "ball.evil:2:" in told
    assert not (level.parent / "film.webp").exists()


def test_a_game_in_python_can_be_rendered(here):
    (here / "helper.py").write_text("COLOUR = 'red'\n")
    (here / "game.py").write_text(
        "import evilengine as evil\nfrom helper import COLOUR\n"
        "game = evil.Game(size=(200, 100))\ngame.add(evil.Circle(0.5), colour=COLOUR)\ngame.run()\n"
    )
    assert main(["render", "game.py", "-o", "a.png", "--at", "0"]) == 0
    with Image.open("a.png") as picture:
        assert picture.size == (200, 100)
        assert picture.convert("RGB").getpixel((100, 50))[0] > 200


def test_an_error_in_a_game_names_its_line(here, capsys):
    (here / "game.py").write_text("import evilengine as evil\n\ngame = evil.Game()\ngame.add(evil.Circle(-1))\n")
    assert main(["render", "game.py", "-o", "a.png"]) == 1
    told = capsys.readouterr().err
    assert "radius=-1" in told
    assert "game.py:4" in told


def test_a_game_that_never_runs_is_an_error(here, capsys):
    (here / "game.py").write_text("import evilengine as evil\ngame = evil.Game()\n")
    assert main(["render", "game.py", "-o", "a.png"]) == 1
    assert "game.run()" in capsys.readouterr().err


# play


def test_without_a_screen_play_says_so_makes_a_film_and_ends_well(level, no_screen, capsys):
    assert main(["play", "ball.evil", "--seconds", "0.2", "--size", "160x90"]) == 0
    said, path = capsys.readouterr().out.splitlines()
    assert "no screen" in said
    assert path == "ball.webp"
    assert len(frames_of(path)) == 6


def test_play_makes_a_film_where_it_is_told_to(level, capsys):
    assert main(["play", "ball.evil", "--film", "here.gif", "--seconds", "0.2", "--size", "160x90"]) == 0
    assert capsys.readouterr().out == "here.gif\n"
    assert len(frames_of("here.gif")) == 6


def test_a_bar_fills_on_a_terminal_only():
    class Terminal(io.StringIO):
        def isatty(self):
            return True

    terminal = Terminal()
    bar = film.Bar("film", terminal)
    for part in (0.0, 0.001, 0.5, 1.0):
        bar(part)
    lines = terminal.getvalue().split("\r")
    assert [line.count("#") for line in lines] == [0, 0, 20, 40]
    assert lines[-1].endswith("100%\n")
