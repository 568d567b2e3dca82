"""The scenes that benchmarks, the testbed and tests share, and `evil bench`."""

from __future__ import annotations

import json
import math
import sys
from pathlib import Path

import pytest

from evilengine.bench.peers import PEERS, found
from evilengine.bench.quality import corners_of, overlap, pyramid_quality
from evilengine.bench.scene import SCENES, Staged, find, stage
from evilengine.bench.timing import FEWEST, Times, take_turns
from evilengine.cli import main
from evilengine.values.errors import ArgumentError

BENCHMARK_BODIES = {
    "pyramid": 5050, "tumbler": 2025, "washer": 8100, "pile": 2000, "compounds": 3000, "smash": 9601, "spinner": 3039,
    "joint_grid": 9993,
}  # fmt: skip


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
    assert touched or name == "joint_grid", "whose circles pass through each other"
    assert len(world.bodies) > 10
    for body in world.bodies:
        assert math.hypot(*body.position) < 1000
        assert body.velocity.length < 500


@pytest.mark.parametrize("name", BENCHMARK_BODIES)
def test_a_scene_has_as_many_moving_bodies_as_the_benchmark_it_is_named_after(name: str) -> None:
    scene = find(name)
    bodies = stage(scene, scene.size).world.bodies
    assert sum(body.kind == "dynamic" for body in bodies) == BENCHMARK_BODIES[name]


def test_a_scene_that_is_not_there_is_answered_by_the_nearest() -> None:
    with pytest.raises(ArgumentError, match="did you mean 'tumbler'"):
        find("tumbla")


def test_a_ratio_is_of_rounds_that_ran_side_by_side() -> None:
    mine, theirs = Times([[1, 1], [2, 2], [9, 9]]), Times([[4, 4], [8, 8], [9, 9]])
    assert mine.ratio(theirs) == 0.25
    assert (mine.least, mine.median) == (1000, 2000)


def test_the_command_writes_its_numbers_to_a_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "numbers.json"
    words = [
        "bench",
        "physics",
        "--scene",
        "pyramid",
        "--size",
        "5",
        "--steps",
        "3",
        "--peer",
        "none",
        "--json",
        str(file),
    ]
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


def test_the_figures_of_a_pyramid_are_those_of_its_boxes() -> None:
    made = [(0.0, -1.0, 0.0), (0.0, 0.5, 0.0), (1.0, 0.5, 0.0), (0.5, 1.5, 0.0)]
    still = pyramid_quality(made, made)
    assert still == {"top_drop": 0, "overlap": 0, "sideways": 0, "tilt": 0}
    moved = [made[0], (0.0, 0.5, 0.0), (1.0, 0.48, 0.0), (0.8, 1.45, -0.1)]
    figures = pyramid_quality(made, moved)
    assert figures["top_drop"] == pytest.approx(0.05)
    assert figures["sideways"] == pytest.approx(0.3)
    assert figures["tilt"] == 0.1
    assert figures["overlap"] > 0.05, "the turned top is in the left box by more than it dropped"


def test_overlap_is_the_shortest_way_out() -> None:
    unit = corners_of((0, 0, 0))
    assert overlap(unit, corners_of((0.9, 0.3, 0))) == pytest.approx(0.1)
    assert overlap(unit, corners_of((1.2, 0, math.pi / 4))) == pytest.approx(0.5 + math.sqrt(0.5) - 1.2)
    assert overlap(unit, corners_of((1.01, 0, 0))) == 0


class Sleeper:
    """A runner that takes as long as it is told, on a clock of its own."""

    def __init__(self, name: str, seconds: float, clock: list[float]) -> None:
        self.name, self.seconds, self.clock, self.steps = name, seconds, clock, 0

    def prepare(self) -> None: ...

    def step(self) -> None:
        self.steps += 1
        self.clock[0] += self.seconds


def test_engines_take_turns_and_one_that_is_too_slow_is_left_out(monkeypatch: pytest.MonkeyPatch) -> None:
    clock = [0.0]
    monkeypatch.setattr("evilengine.bench.timing.time.perf_counter", lambda: clock[0])
    ours, quick, slow = (Sleeper(name, s, clock) for name, s in (("ours", 1), ("quick", 2), ("slow", 9)))
    times = take_turns([ours, quick, slow], steps=12, warm=20, patience=100)
    assert list(times) == ["ours", "quick"]
    assert (ours.steps, quick.steps, slow.steps) == (32, 32, 10)
    assert [len(each) for each in times["ours"].rounds] == [5, 5, 2]
    assert times["ours"].ratio(times["quick"]) == 0.5
    times = take_turns([ours, quick], steps=50, warm=0, patience=30)
    assert (len(times["ours"].rounds), len(times["quick"].rounds)) == (7, 3), "35 and 30 seconds"
    assert times["ours"].ratio(times["quick"]) == 0.5
    assert len(take_turns([slow], steps=50, warm=0, patience=30)["slow"].rounds) == FEWEST


@pytest.mark.parametrize("peer", PEERS)
@pytest.mark.parametrize(
    "name", ["pyramid", "tumbler", "compounds", "pile", "junkyard", "joint_grid", "spinner", "bridge", "ragdoll"]
)
def test_a_peer_makes_the_same_bodies_and_lets_them_fall_alike(peer: str, name: str) -> None:
    pytest.importorskip(peer)
    (kind,), _ = found([peer])
    scene = find(name)
    theirs, ours = kind(scene, scene.small), stage(scene, scene.small)
    for _ in range(10):
        theirs.prepare()
        theirs.step()
        ours.step()
    placed = [(*body.position, body.angle) for body in ours.world.bodies]
    assert len(theirs.placed()) == len(placed)
    differences = [math.dist(a[:2], b[:2]) for a, b in zip(theirs.placed(), placed, strict=True)]
    assert sorted(differences)[len(differences) // 2] < 0.02, "most fall freely or rest"


def test_a_peer_that_is_not_installed_is_said(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setitem(sys.modules, "pymunk", None)
    monkeypatch.delitem(sys.modules, "evilengine.bench.chipmunk", raising=False)
    words = ["bench", "physics", "--scene", "pyramid", "--size", "3", "--steps", "2", "--peer", "pymunk"]
    assert main(words) == 0
    assert "not installed, so not beside: pymunk" in capsys.readouterr().out
