"""The parts that a game's steps are made in."""

from __future__ import annotations

import pytest

import evilengine as evil


def tower(game, boxes, heavy):
    """Unit boxes on each other and one more on top, that much heavier; the one on top."""
    game.world.sleep = False
    game.add(evil.Rectangle(20, 1), at=(0, -0.5), kind="static")
    for n in range(boxes):
        game.add(evil.Rectangle(1, 1), at=(0, n + 0.5), mass=1)
    return game.add(evil.Rectangle(1, 1), at=(0, boxes + 0.5), mass=heavy)


@pytest.mark.parametrize(("boxes", "heavy", "substeps"), [(19, 1, 8), (5, 100, 8), (10, 100, 16)])
def test_more_parts_bear_high_towers_and_heavy_things_on_light_ones(boxes, heavy, substeps):
    game = evil.Game(headless=True)
    top = tower(game, boxes, heavy)
    game.substeps = substeps
    game.step(1200)
    assert top.position.y > boxes + 0.4
    assert abs(top.position.x) < 0.05


def test_a_scene_begins_with_the_parts_that_the_game_was_told_first():
    game = evil.Game(headless=True)

    @game.scenes
    def play():
        game.add(evil.Circle(1))

    game.substeps = 8
    game.go("play")
    game.substeps = 2
    game.restart()
    assert game.substeps == 8


def test_a_saved_game_keeps_its_parts(tmp_path):
    game = evil.Game(headless=True)
    game.add(evil.Circle(1), at=(0, 3))
    game.substeps = 12
    game.save("kept", folder=tmp_path)
    game.substeps = 4
    game.resume("kept", folder=tmp_path)
    assert game.substeps == 12


@pytest.mark.parametrize("wrong", [0, 257, 4.0, True, "4", None])
def test_what_is_no_number_of_parts_is_refused(wrong):
    game = evil.Game(headless=True)
    with pytest.raises(evil.ArgumentError, match=r"Game: substeps=.* must be a whole number from 1 to 256"):
        game.substeps = wrong
    assert game.substeps == 4
