"""Recordings of reported faults (.evr beside this file): each plays to its end without the fault.

`evil play LEVEL --record tests/issues/0042_what_was_wrong.evr` makes one. A later engine may move things differently on
purpose, so a recording that ends elsewhere than it did is no fault by itself.
"""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from evilengine.game import replaying
from evilengine.save import Replay

RECORDINGS = sorted(Path(__file__).parent.glob("*.evr"))


@pytest.mark.parametrize("path", RECORDINGS, ids=lambda path: path.stem)
def test_a_recorded_fault_does_not_happen_again(path: Path) -> None:
    replay = Replay.read(path)
    game = replaying.game_of(replay, headless=True)
    game._playback = playback = replaying.play(game, replay)
    while not playback.over:
        game.step()
    assert game.capture().size == tuple(replay.header["size"])
    assert all(math.isfinite(number) for body in game.world.bodies for number in (*body.position, *body.velocity))


def test_there_are_recordings() -> None:
    assert RECORDINGS
