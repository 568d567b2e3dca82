"""A world's threads: the same bits with any number of them, and no harm from what else a process does."""

from __future__ import annotations

import os

import pytest

import evilengine as evil


def pile(threads: int) -> evil.World:
    """Enough of everything that each loop of a step has several chunks."""
    world = evil.World(threads=threads)
    world.add(evil.Rectangle(200, 1), at=(0, -0.5), kind="static")
    for i in range(1200):
        shape = evil.Circle(0.4) if i % 3 else evil.Rectangle(0.8, 0.7)
        world.add(shape, at=(i % 60 * 0.85 - 25 + 0.1 * (i // 60 % 3), 0.5 + i // 60 * 0.9), angle=0.1 * (i % 7))
    return world


def after_a_while(threads: int, steps: int = 40) -> int:
    world = pile(threads)
    for _ in range(steps):
        world.step(1 / 60)
    return world.checksum()


def test_any_number_of_threads_gives_the_same_bits() -> None:
    assert len({after_a_while(threads) for threads in (1, 2, 3, 7)}) == 1


@pytest.mark.skipif(not hasattr(os, "fork"), reason="processes do not split here")
@pytest.mark.skipif(os.environ.get("EVIL_SANITIZED") == "thread", reason="ThreadSanitizer's processes do not split")
def test_a_process_that_forks_goes_on_stepping_on_both_sides() -> None:
    world = pile(threads=3)
    world.step(1 / 60)
    child = os.fork()
    if child == 0:
        try:
            world.step(1 / 60)
            del world
            code = after_a_while(threads=2, steps=2) == after_a_while(threads=1, steps=2)
        finally:
            os._exit(0 if code else 1)
    world.step(1 / 60)
    assert os.waitpid(child, 0)[1] == 0


def test_worlds_with_threads_come_and_go() -> None:
    for threads in (1, 2, 256) * 5:
        world = evil.World(threads=threads)
        assert world.threads == threads
        world.step(1 / 60)
