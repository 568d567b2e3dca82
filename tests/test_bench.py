"""The scenes that benchmarks, the testbed and tests share, and `evil bench`."""

from __future__ import annotations

import json
import math
from pathlib import Path

import pytest

from evilengine import _core
from evilengine.bench.scene import SCENES, Staged, find, stage
from evilengine.bench.timing import Times
from evilengine.cli import main
from evilengine.values.errors import ArgumentError

BENCHMARK_BODIES = {"pyramid": 5050, "tumbler": 2025, "washer": 8100, "pile": 2000, "compounds": 3000, "smash": 9600}


def played(name: str, steps: int, size: int | None = None) -> Staged:
    scene = find(name)
    staged = stage(scene, scene.small if size is None else size)
    for _ in range(steps):
        staged.step()
    return staged


@pytest.mark.parametrize("name", SCENES)
def test_a_scene_plays_for_three_seconds_and_stays_sound(name: str) -> None:
    staged, touched = played(name, 0), False
    world = staged.world
    for _ in range(180):
        staged.step()
        touched = touched or bool(world.contacts.active)
    assert touched
    assert len(world.bodies) > 10
    for body in world.bodies:
        assert math.hypot(*body.position) < 1000
        assert body.velocity.length < 500


@pytest.mark.parametrize("name", SCENES)
def test_a_scene_gives_the_same_bits_on_every_instruction_set(name: str) -> None:
    sums = set()
    for instructions in _core.instruction_sets():
        staged = played(name, 0)
        staged.world._core.instruction_set = instructions
        for _ in range(90):
            staged.step()
        sums.add(staged.world.checksum())
    assert len(sums) == 1


@pytest.mark.parametrize("name", BENCHMARK_BODIES)
def test_a_scene_has_as_many_moving_bodies_as_the_benchmark_it_is_named_after(name: str) -> None:
    scene = find(name)
    bodies = stage(scene, scene.size).world.bodies
    assert sum(body.kind == "dynamic" for body in bodies) == BENCHMARK_BODIES[name] + (name == "smash")


def test_a_scene_that_is_not_there_is_answered_by_the_nearest() -> None:
    with pytest.raises(ArgumentError, match="did you mean 'tumbler'"):
        find("tumbla")


def test_a_ratio_is_of_rounds_that_ran_side_by_side() -> None:
    mine, theirs = Times([[1, 1], [2, 2], [9, 9]]), Times([[4, 4], [8, 8], [9, 9]])
    assert mine.ratio(theirs) == 0.25
    assert (mine.least, mine.median) == (1000, 2000)


def test_the_command_writes_its_numbers_to_a_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "numbers.json"
    words = ["bench", "physics", "--scene", "pyramid", "--size", "5", "--steps", "3", "--json", str(file)]
    assert main(words) == 0
    (result,) = json.loads(file.read_text())["scenes"]
    assert (result["scene"], result["bodies"]) == ("pyramid", 16)
    assert 0 < result["engines"]["evil"]["min"] <= result["engines"]["evil"]["median"]
    assert "pyramid" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("words", "code", "said"),
    [
        (["--scene", "pyramyd"], 1, "did you mean 'pyramid'"),
        (["--steps", "0"], 2, "'0' must be a whole number"),
        (["--threads", "two"], 2, "'two' must be a whole number"),
        (["--size", "5"], 1, "--size is of one scene"),
        (["--scene", "pyramid", "--json", "no/such/folder/x.json"], 1, "there is no folder"),
    ],
)
def test_the_command_refuses_what_it_cannot_do(
    words: list[str], code: int, said: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["bench", "physics", *words]) == code
    assert said in capsys.readouterr().err
