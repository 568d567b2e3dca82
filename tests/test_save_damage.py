"""Saved games that are damaged, forged or of another time: refused, or played, and the game is never broken."""

from __future__ import annotations

import json
import random

import pytest
from player import RICH, level_game, play, resumed

import evilengine as evil
from evilengine.game import saving
from evilengine.game.saving import SAVED_GAME


@pytest.fixture
def rich(tmp_path):
    path = tmp_path / "rich.evil"
    path.write_text(RICH)
    return path


@pytest.fixture
def small(tmp_path):
    path = tmp_path / "small.evil"
    path.write_text('new circle ball 0.5 at 0 0 physicsOn;\nlet n 1;\nevery 1 { set n (n + 1); }\ntext "{n}" at 5 5;\n')
    return path


def test_a_save_cut_or_flipped_at_any_byte_is_refused_and_changes_nothing(small):
    game = level_game(small)
    game.step(3)
    data = saving.to_bytes(game)
    game.step(2)
    before = saving.to_bytes(game)
    refused = 0
    for at in range(len(data)):
        changed = bytearray(data)
        changed[at] ^= 1 << at % 8
        for bad in (data[:at], bytes(changed)):
            try:
                saving.from_bytes(game, bad, "test.evs")
            except evil.SaveError:
                refused += 1
    assert refused == 2 * len(data) > 5000
    assert saving.to_bytes(game) == before


def forged(data, rng):
    """The save with something in it changed, and a checksum that fits."""
    sections = SAVED_GAME.read(data, "test.evs")
    name = rng.choice(["game", "game", "game", "game", "world", "drawings", "random", "inputs"])
    if name != "game":
        part = bytearray(sections[name])
        part[rng.randrange(len(part))] ^= 1 << rng.randrange(8)
        sections[name] = bytes(part[: rng.choice([len(part), rng.randrange(len(part))])])
        return SAVED_GAME.write(sections)
    state = json.loads(sections["game"])
    places = []

    def walk(node):
        items = node.items() if isinstance(node, dict) else enumerate(node) if isinstance(node, list) else ()
        for key, value in items:
            places.append((node, key))
            walk(value)

    walk(state)
    node, key = rng.choice(places)
    if isinstance(node, dict) and rng.random() < 0.2:
        del node[key]
    else:
        node[key] = rng.choice(
            [None, -1, 0, 1, 2.5, 1e300, "x", "os:system", [], {}, True, [0], ["body", 99], 10**30, [[[]]]]
        )
    return SAVED_GAME.write(sections | {"game": json.dumps(state).encode()})


@pytest.mark.parametrize("seed", [0, 1, 2, 3, 9, 31, 58])
def test_a_forged_save_is_refused_or_plays_but_never_breaks_the_game(rich, seed):
    rng = random.Random(seed)
    game = level_game(rich)
    play(game, 0, 70)
    data = saving.to_bytes(game)
    before = saving.to_bytes(game)
    refused = 0
    for _ in range(150):
        try:
            saving.from_bytes(game, forged(data, rng), "test.evs")
        except evil.SaveError:
            refused += 1
            assert saving.to_bytes(game) == before, "a refused save changes nothing"
        else:
            try:
                game.step(3)
                game.capture()
            except (evil.Error, KeyError):  # a level whose numbers or names were taken away may fail as levels do
                pass
            resumed(data, game)
            before = saving.to_bytes(game)
    assert refused > 30


def test_a_save_of_a_level_that_cannot_be_read_any_more_says_so(small):
    game = level_game(small)
    sections = SAVED_GAME.read(saving.to_bytes(game), "x")
    state = json.loads(sections["game"])
    state["levels"][0]["text"] = "new circel 1 at 0 0;"
    data = SAVED_GAME.write(sections | {"game": json.dumps(state).encode()})
    with pytest.raises(evil.SaveError, match=r"cannot read.*circel"):
        saving.from_bytes(game, data, "x")
