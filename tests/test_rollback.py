"""Rollback (docs/rollback.md): two who hear of each other late live in one world."""

from __future__ import annotations

import random
import re
from pathlib import Path
from typing import Any

import pytest

import evilengine as evil
from evilengine.cli import sources

PAGE = Path(__file__).resolve().parent.parent / "docs" / "rollback.md"


def session_class() -> Any:
    """The class as the page has it."""
    names: dict[str, Any] = {}
    exec(re.findall(r"```python\n(.*?)```", PAGE.read_text(), re.DOTALL)[0], names)
    return names["Session"]


def world_of_many_things() -> evil.World:
    """Walls, crates on a rope, a blob, water, and a hero for each player."""
    world = evil.World()
    for x, y, w, h in ((0, -0.5, 40, 1), (-12, 4, 1, 10), (12, 4, 1, 10)):
        world.add(evil.Rectangle(w, h), at=(x, y), kind="static")
    for i in range(12):
        world.add(evil.Rectangle(0.7, 0.7), at=(-1 + i % 3, 0.4 + i // 3 * 0.75))
    hook = world.add(evil.Circle(0.1), at=(5, 8), kind="static")
    world.add_joint(evil.joints.Rope(hook, world.add(evil.Circle(0.5), at=(8, 6), density=3)))
    evil.soft.blob(world, (-6, 4), pieces=8)
    world.add_force(evil.Medium((6, 0, 11, 2), density=1.5, linear=1))
    for x in (-4, 4):
        world.add_character(at=(x, 1))
    return world


def act(world: evil.World, player: int, deed: tuple[int, bool]) -> None:
    hero = world.characters[player]
    hero.move(deed[0])
    hero.jump() if deed[1] else hero.let_go()


def deeds_of(player: int) -> list[tuple[int, bool]]:
    chance = random.Random(player)
    deeds: list[tuple[int, bool]] = []
    while len(deeds) < 240:
        deeds += [(chance.choice([-1, 0, 1]), chance.random() < 0.3)] * chance.randint(3, 20)
    return deeds[:240]


@pytest.mark.parametrize("late", [0, 3, 17])
def test_two_who_hear_of_each_other_late_live_in_one_world(late: int) -> None:
    deeds = [deeds_of(0), deeds_of(1)]
    at_once = world_of_many_things()
    for both in zip(*deeds, strict=True):
        for player, deed in enumerate(both):
            act(at_once, player, deed)
        at_once.step(1 / 60)

    sessions = [session_class()(world_of_many_things(), me, act, idle=(0, False)) for me in (0, 1)]
    chance, waiting = random.Random(late), ([], [])  # type: tuple[random.Random, tuple[list[Any], list[Any]]]
    repeated = 0
    for step in range(240):
        for me, session in enumerate(sessions):
            waiting[1 - me].append((step + late, session.advance(deeds[me][step])))
        for session, messages in zip(sessions, waiting, strict=True):
            while messages and messages[0][0] <= step and chance.random() < 0.8:
                session.hear(*messages.pop(0)[1])
            repeated += session.wrong is not None
    for session, messages in zip(sessions, waiting, strict=True):
        for _, message in messages:
            session.hear(*message)
        session.catch_up()
        assert session.world.checksum() == at_once.checksum()
    assert repeated > 10, "the test means something"


def test_the_example_ends_where_a_game_that_hears_at_once_does() -> None:
    text = sources.example("15_rollback").path.read_text()

    def end(late: int) -> tuple[int, str]:
        names: dict[str, Any] = {}
        exec(text.replace("LATE, DT = 12", f"LATE, DT = {late}").replace("game.run()", ""), names)
        for _ in range(125):  # some steps after red's turn at 100 is heard of
            names["game"].step()
        return names["world"].checksum(), names["report"].text

    prompt, delayed = end(1), end(12)
    assert prompt[0] == delayed[0]
    assert "went back 12 steps" in delayed[1]
