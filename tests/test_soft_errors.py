"""Soft things that cannot be made: the error says why, and the world is as it was."""

from __future__ import annotations

from collections.abc import Callable

import pytest

import evilengine as evil


@pytest.mark.parametrize(
    ("make", "says"),
    [
        (lambda w: evil.soft.rope(w, (0, 0), (4, 0), breaking_force=-1), "breaking_force=-1"),
        (lambda w: evil.soft.rope(w, (0, 0), (4, 0), friction=-1), "friction=-1"),
        (lambda w: evil.soft.rope(w, (0, 0), (0, 0)), "two different points"),
        (lambda w: evil.soft.blob(w, (0, 0), frequency="soft"), "soft.blob: frequency='soft' must be a number"),
        (lambda w: evil.soft.blob(w, (0, 0), frequency=4000), "frequency=4000"),
        (lambda w: evil.soft.blob(w, (0, 0), damping_ratio=-1), "damping_ratio=-1"),
        (lambda w: evil.soft.jelly(w, (0, 0), frequency=float("nan")), "soft.jelly: frequency=nan"),
        (lambda w: evil.soft.jelly(evil.Game(headless=True), (0, 0)), "must be a World; that of a game is game.world"),
        (lambda w: evil.soft.jelly(w, (0, 0), columns=100, rows=100), "at most 1000"),
        (lambda w: evil.soft.jelly(w, (0, 0), breaking_force=0), "breaking_force=0"),
    ],
)
def test_what_cannot_be_made_leaves_the_world_as_it_was(make: Callable[[evil.World], object], says: str) -> None:
    world = evil.World()
    world.add(evil.Rectangle(1, 1))
    before = world.snapshot()
    with pytest.raises(evil.Error, match=says):
        make(world)
    assert world.snapshot() == before
