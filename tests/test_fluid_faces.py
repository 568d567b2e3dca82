"""What all handles of fluids have in common: misspelt attributes, and questions about one point or many."""

from __future__ import annotations

import array
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import evilengine as evil


def all_of_it() -> tuple[evil.World, evil.Smoke, evil.Water]:
    world = evil.World()
    smoke, water = world.add_smoke((0, 0, 4, 4), cells=8), world.add_water((0, 0, 4, 4), particle_size=0.2)
    water.fill((0, 0, 4, 2))
    return world, smoke, water


HANDLES: dict[str, Callable[[evil.Smoke, evil.Water], Any]] = {
    "bouyancy": lambda smoke, _: smoke,
    "feul": lambda smoke, _: smoke.add_source(radius=0.2, at=(1, 1)),
    "visosity": lambda _, water: water,
    "runing": lambda _, water: water.pour((1, 1), 0.1),
    "densty": lambda _, water: water.add_liquid(),
}


@pytest.mark.parametrize("name", HANDLES)
def test_a_misspelt_attribute_is_an_error(name: str) -> None:
    _, smoke, water = all_of_it()
    with pytest.raises(AttributeError, match=name):
        setattr(HANDLES[name](smoke, water), name, 1)


ASKED = ("Smoke.density_at", "Smoke.temperature_at", "Smoke.velocity_at", "Water.is_in", "Water.velocity_at",
         "Water.density_at", "Water.depth_at")  # fmt: skip


def asked(name: str) -> Callable[[Any], Any]:
    _, smoke, water = all_of_it()
    owner, method = name.split(".")
    ask: Callable[[Any], Any] = getattr({"Smoke": smoke, "Water": water}[owner], method)
    return ask


@pytest.mark.parametrize("name", ASKED)
def test_one_point_has_one_answer_and_many_have_many(name: str) -> None:
    ask = asked(name)
    one, other = ask((1, 1)), ask((1, 3))
    for point in (evil.Vec2(1, 1), [1, 1], np.array([1, 1]), np.array([1, 1], np.float32)):
        assert ask(point) == one
    points = np.array([[1, 1], [1, 3]])
    for many in (points, points.astype(np.float32), np.repeat(points, 2, axis=0)[::2], points.tolist(),
                 [evil.Vec2(1, 1), evil.Vec2(1, 3)], ((1, 1), (1, 3)), memoryview(points.astype(float)),
                 (point for point in points.tolist())):  # fmt: skip
        assert ask(many) == [one, other]
    assert ask([]) == ask(np.empty((0, 2))) == []


@pytest.mark.parametrize("name", ASKED)
@pytest.mark.parametrize("points", [None, "ab", 3, [1, 2, 3], np.ones((2, 3)), array.array("f", [1, 2, 3, 4]),
                                    (float("nan"), 1), [(1, 1), (1, "x")]])  # fmt: skip
def test_what_is_no_point_is_said(name: str, points: Any) -> None:
    with pytest.raises((evil.ArgumentError, evil.ArgumentTypeError), match=f"{name}: points"):
        asked(name)(points)
