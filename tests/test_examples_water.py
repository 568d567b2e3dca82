"""The examples with water: what floats, what turns, what swims."""

from __future__ import annotations

import sys
from collections.abc import Callable
from typing import Any

import pytest

import evilengine as evil
from evilengine.cli import sources
from evilengine.cli.stage import perform
from evilengine.platform import HeadlessDevice


class Played:
    """A stage that plays an example and lets `act` see the game and the script's own names before each step."""

    def __init__(
        self, name: str, steps: int, act: Callable[[evil.Game, Any], None] = lambda game, script: None
    ) -> None:
        self._steps, self._act = steps, act
        perform(sources.example(name).path, self)

    def open(self, title: str, size: tuple[int, int]) -> HeadlessDevice:
        return HeadlessDevice(size, title=title)

    def run(self, game: evil.Game) -> None:
        script = sys.modules["__main__"]
        for _ in range(self._steps):
            self._act(game, script)
            game.step()
        self.names = dict(vars(script))


def test_crates_of_three_woods_float_at_three_depths_and_the_duck_bobs_upright() -> None:
    under: dict[float, list[float]] = {}
    tilts: list[float] = []
    heights: list[float] = []

    def watch(game: evil.Game, script: Any) -> None:
        if game.world.steps == 0:
            script.spout.running = script.outlet.running = False  # still water, to measure in
        if game.world.steps < 240:
            return
        crates = [body for body in game.world.bodies if body.tag == "crate"]
        floats = sum(body.mass for body in [*crates, script.duck])  # as much water makes room for them
        level = -3.4 + (script.pool.volume + floats) / 11
        for crate in crates:
            density = round(crate.mass / (script.WIDE * script.HIGH), 2)
            under.setdefault(density, []).append((level - crate.position.y) / script.HIGH + 0.5)
        tilts.append(script.duck.angle)
        heights.append(script.duck.position.y)

    Played("pool", 360, watch)
    drafts = {density: sum(each) / len(each) for density, each in under.items()}
    assert sorted(drafts) == [0.25, 0.5, 0.8]
    for density, draft in drafts.items():
        assert draft == pytest.approx(density, abs=0.14), "as much of it is under water as it weighs"
    assert drafts[0.25] + 0.15 < drafts[0.5] < drafts[0.8] - 0.15
    assert max(abs(tilt) for tilt in tilts) < 0.5
    assert max(heights) - min(heights) > 0.01, "it bobs"


def test_the_duck_rights_itself() -> None:
    def turn_over(game: evil.Game, script: Any) -> None:
        if game.world.steps == 60:
            script.duck.angle = 1.5

    played = Played("pool", 360, turn_over)
    assert abs(played.names["duck"].angle) < 0.6


def test_the_wheel_is_turned_by_the_stream_alone() -> None:
    turned = Played("pool", 420).names["wheel"].angle
    assert abs(turned) > 6.0, "once round in seven seconds, and more"

    def dry(game: evil.Game, script: Any) -> None:
        script.spout.running = False

    assert abs(Played("pool", 420, dry).names["wheel"].angle) < 0.5


def test_as_much_water_goes_as_comes() -> None:
    names = Played("pool", 900).names
    assert names["pool"].volume == pytest.approx(names["FULL"], rel=0.02)


def test_fish_come_to_a_finger() -> None:
    def touch(game: evil.Game, script: Any) -> None:
        if game.world.steps == 120:
            game.device.touch(1, "began", at=game.camera.to_pixel((3, -1)))  # type: ignore[attr-defined]

    alone = Played("tilt_aquarium", 300).names["shoal"]
    called = Played("tilt_aquarium", 300, touch).names["shoal"]

    def away(fish: evil.Body) -> float:
        return (fish.position - evil.Vec2(3, -1)).length

    assert sum(map(away, called)) < 3 * 1.3
    assert sum(map(away, called)) < 0.5 * sum(map(away, alone))


def test_water_runs_to_the_side_that_is_down_and_oil_floats_on_it() -> None:
    def tilt(game: evil.Game, script: Any) -> None:
        game.device.tilt(1, 0)  # type: ignore[attr-defined]

    names = Played("tilt_aquarium", 420, tilt).names
    tank, oil = names["tank"], names["oil"]
    kinds = [tank.kinds[k] for k in range(tank.count)]
    across = [tank.positions[k][0] for k in range(tank.count)]
    of_oil = [x for x, kind in zip(across, kinds, strict=True) if kind == 1]
    of_water = [x for x, kind in zip(across, kinds, strict=True) if kind == 0]
    assert len(of_oil) == oil.count
    assert sum(of_water) / len(of_water) > sum(of_oil) / len(of_oil) + 2
    assert names["ball"].position.x < names["chest"].position.x - 2, "what is light is up, what is heavy down"
