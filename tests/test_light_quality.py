"""The quality of light: what a machine has time for in a window, the same everywhere else."""

from __future__ import annotations

import pytest

import evilengine as evil
from evilengine.platform import HeadlessDevice
from evilengine.scene import Lights
from evilengine.values.frame import FrameTimes
from evilengine.values.governor import LOOKS, PATIENCE, SLOW, Governor
from evilengine.values.tick import STEP

COSTS = {"low": 1.0, "medium": 3.0, "high": 9.0}


@pytest.mark.parametrize(("rest", "quality"), [(0.5, "high"), (6.0, "medium"), (10.0, "low"), (40.0, "low")])
def test_the_best_quality_that_fits_into_a_frame_is_chosen(rest: float, quality: str) -> None:
    assert Governor(16.7).choose(COSTS, rest) == quality


def test_slow_frames_lower_the_quality_and_a_single_one_does_not() -> None:
    governor = Governor(16.7)
    governor.choose(COSTS, 1.0)
    for _ in range(10):
        assert governor.note(9.0, 10.0, 16.7) == "high"
        assert governor.note(9.0, 25.0, 25.0) == "high"
    governor.choose(COSTS, 1.0)
    qualities = [governor.note(9.0, 25.0, 25.0) for _ in range(SLOW)]
    assert qualities[-1] == "medium"
    assert qualities[0] == "high"


def test_frames_that_are_slow_for_another_reason_keep_their_light() -> None:
    governor = Governor(16.7)
    governor.choose(COSTS, 1.0)
    assert {governor.note(0.8, 40.0, 40.0) for _ in range(100)} == {"high"}


def test_quality_comes_back_when_there_is_room_and_seldom_to_and_fro() -> None:
    governor = Governor(16.7)
    governor.choose(COSTS, 20.0)
    changes = []
    for frame in range(4000):  # at medium there is room for high by what it cost at first; in truth it costs too much
        light = {"low": 1.0, "medium": 2.0, "high": 15.0}[governor.quality]
        before = governor.quality
        if governor.note(light, 2.0 + light, 16.7) != before:
            changes.append(frame)
    assert changes[0] >= PATIENCE - 1
    assert governor.quality in ("medium", "high")
    assert len(changes) < 14, changes
    waits = [b - a for a, b in zip(changes[1::2], changes[2::2], strict=False)]
    assert waits == sorted(waits), "it tries less and less often"


class Window:
    """A device that is none of the headless ones, whatever shows its pictures."""

    vsync = True

    def __init__(self) -> None:
        self._device = HeadlessDevice((160, 90))

    def __getattr__(self, name: str) -> object:
        return getattr(self._device, name)


def lit(device: object = None) -> evil.Game:
    game = evil.Game("Light", size=(160, 90), headless=True, renderer="soft", device=device)  # type: ignore[arg-type]
    game.draw(evil.Rectangle(20, 20), lit=True, outline=False)
    game.add_light(at=(0, 0))
    return game


def play(game: evil.Game, frames: int, light: float, rest: float) -> None:
    """Frames of which light and the rest take so many milliseconds."""
    note = game._light_quality.note

    class Told:
        def note(self, game: evil.Game) -> None:
            game.lights._cost = light
            game.timings.rows[-1] = FrameTimes(rest, light, 0.0, 0.0)
            note(game)

    game._light_quality = Told()  # type: ignore[assignment]
    for frame in range(frames):
        game.frame(game.timings.last.total + frame * STEP)


def test_a_game_in_a_window_takes_what_there_is_time_for(monkeypatch: pytest.MonkeyPatch) -> None:
    game = lit(Window())
    monkeypatch.setattr(Lights, "_measure", lambda lights: COSTS)
    assert (game.lights.quality, game.lights.present_quality) == ("auto", "medium")
    play(game, LOOKS, light=3.0, rest=1.0)
    assert game.lights.present_quality == "high"
    game.lights.quality = "low"
    play(game, LOOKS, light=1.0, rest=1.0)
    assert game.lights.present_quality == "low"


def test_without_a_window_the_quality_is_always_the_same(monkeypatch: pytest.MonkeyPatch) -> None:
    game = lit()
    monkeypatch.setattr(Lights, "_measure", lambda lights: COSTS)
    play(game, 40, light=30.0, rest=30.0)
    assert game.lights.present_quality == "medium"


def test_a_replay_in_a_window_keeps_its_quality(monkeypatch: pytest.MonkeyPatch, tmp_path) -> None:
    game = lit()
    recording = game.record(tmp_path / "game.evr")
    game.step(60)
    recording.close()
    again = lit(Window())
    monkeypatch.setattr(Lights, "_measure", lambda lights: COSTS)
    again.replay(tmp_path / "game.evr")
    play(again, 40, light=30.0, rest=30.0)
    assert again.lights.present_quality == "medium"


def test_each_quality_is_measured_once_there_is_light() -> None:
    game = lit()
    game.capture()
    costs = game.lights._measure()
    assert list(costs) == ["low", "medium", "high"]
    assert min(costs.values()) > 0


def test_the_light_of_all_views_is_measured() -> None:
    game = lit()
    game.lights.quality = "low"
    game.capture()
    one = game.lights._measure()["high"]
    game.split(*(game.add(evil.Circle(0.1), at=(x, 0)) for x in (-1, 0, 1, 2)))
    for view in game.views:
        view.area = "all"
    game.capture()
    assert len(game.lights._asked) == 4
    assert game.lights._cost is not None
    assert 2.0 * one < game.lights._measure()["high"] < 8.0 * one


def test_a_quality_that_there_is_not_is_refused() -> None:
    with pytest.raises(evil.ArgumentError, match=r"quality='best' must be one of"):
        lit().lights.quality = "best"
