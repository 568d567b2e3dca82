"""Levels that go on to others, start again and slow down: the words, and what is said of those that make no sense."""

from __future__ import annotations

import pytest

import evilengine as evil
from evilengine.game import Game


@pytest.fixture
def levels(tmp_path):
    (tmp_path / "one.evil").write_text('gravity 0 -3;\nnew circle ball 0.5 at 0 2 physicsOn tag "one";\n')
    (tmp_path / "two.evil").write_text(
        "seed 3;\nnew walls 15 8;\nevery 0.1 times 3 { new circle 0.3 at random(-3, 3) 0 physicsOn; }\n"
        'new circle late 0.2 at 0 1 physicsOn;\non key "k" { impulse late 1 1; }\n'
    )
    return tmp_path


def test_a_level_goes_on_to_another_and_starts_again(levels):
    (levels / "door.evil").write_text(
        'on key "g" { go "two.evil"; } on key "r" { restart; pace 0.5; }\nnew circle 0.3 at 0 0 physicsOn;\n'
        'on key "x" { go "gone.evil"; }\n'
    )
    (levels / "gone.evil").write_text("view 16 9;\n")
    game = Game("Levels", size=(320, 180), headless=True, folder=levels)
    game.load("door.evil")
    game.step(9)
    game.device.tap("r")
    game.step()
    assert (game.scenes.present, game.world.steps, len(game.world.bodies), game.speed) == ("door.evil", 0, 1, 1.0)
    (levels / "gone.evil").unlink()
    game.device.tap("x")
    with pytest.raises(evil.LevelError, match=r"door.evil:3:[^$]*gone.evil"):
        game.step()
    game.device.tap("g")
    game.step()
    assert game.scenes.present == "two.evil"


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("restart;", "restart stands in a block"),
        ('go "two.evil";', "go stands in a block"),
        ('on key "r" { go two.evil; }', "a file name stands in quotes"),
        ('on key "r" { go "two"; }', "'two' is no level"),
        ('on key "r" { go "twi.evil"; }', "did you mean 'two.evil'?"),
        ('on key "r" { go "../two.evil"; }', "is not a file in the level's folder"),
        ('on key "r" { restart 3; }', "has no place here"),
        ("pace 9;", "pace is from 0.05 to 4"),
        ("speed 0.5;", "did you mean 'pace'?"),
        ("pace;", "pace needs a number"),
    ],
)
def test_words_of_a_level_that_make_no_sense_are_explained(text, told, levels):
    (levels / "bad.evil").write_text(text)
    with pytest.raises(evil.LevelError) as caught:
        Game("Levels", size=(320, 180), headless=True, folder=levels).go("bad.evil")
    assert told in str(caught.value)


def test_a_level_without_a_game_goes_nowhere(levels):
    from evilengine import level, script

    world = evil.World()
    level.build(
        script.read('new circle ball 1 at 0 0 physicsOn; on collide ball { restart; pace 0.5; go "b.evil"; }'), world
    )
    world.add(evil.Circle(1), at=(0.5, 0))
    world.step()
    assert len(world.bodies) == 2
