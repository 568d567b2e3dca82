"""Every public name of a world and of what is in it, found by looking, called with whatever comes: nothing breaks.

New methods and properties are in this test from the day they land. What is refused is refused with an error of ours (or
with Python's own for a wrong number of arguments), and leaves the world as it was; what is done leaves it fit to step.
"""

from __future__ import annotations

import inspect
import math
import os
from array import array
from collections.abc import Callable
from typing import Any

from hypothesis import HealthCheck, settings
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, rule, run_state_machine_as_test

import evilengine as evil

ROUNDS = int(os.environ.get("EVIL_FUZZ", "0"))

plain = st.floats(-10, 10, width=32)
odd = st.sampled_from([0.0, 1e-30, 1e6, 3e38, -3e38, 1e300, math.inf, math.nan])
number = st.one_of(plain, plain, plain, st.integers(-3, 300), odd)
point = st.tuples(number, number)
size = st.floats(0.0625, 3, width=32)
shapes = st.one_of(
    st.builds(evil.Circle, size),
    st.builds(evil.Rectangle, size, size),
    st.builds(lambda a, r: evil.Capsule((-a, 0), (a, 0), r), size, size),
    st.builds(lambda a: evil.Segment((-a, 0), (a, 0.5)), size),
    st.builds(lambda a: evil.Chain([(-a, 0), (0, -a), (a, 0)]), size),
    st.just(evil.Polygon([(0, 0), (2, 0), (2, 1), (1, 0.4), (0, 1)])),
    st.builds(lambda mass: evil.Particle(mass=mass), size),
)
forces = st.one_of(
    st.builds(lambda to, k: evil.Spring(to=to, stiffness=k, rest_length=1), st.tuples(plain, plain), size),
    st.builds(evil.Gravity, st.tuples(plain, plain)),
    st.builds(lambda k: evil.Drag(k), size),
)
PICKED = object()
"""Stands for a body, shape, force or joint of the world, by the number beside it."""
picked = st.tuples(st.just(PICKED), st.integers(0, 999))
words = st.sampled_from(["dynamic", "static", "kinematic", "tag", "", "ball"])
buffers = st.one_of(
    st.lists(plain, max_size=6).map(lambda values: array("f", values)),
    st.lists(st.tuples(plain, plain), max_size=4),
    st.lists(st.integers(-1, 40), max_size=4).map(lambda values: array("I", [abs(value) for value in values])),
)
value = st.one_of(
    number, number, point, point, picked, picked, shapes, forces, words, buffers, st.none(), st.booleans()
)

SKIPPED = {"of"}  # makes another world
SLOW = {"step": 8, "substeps": 8}


def keywords_of(function: Callable[..., Any]) -> list[str]:
    """The names that it takes, as far as it says."""
    try:
        return [each for each in inspect.signature(function).parameters if each not in ("self", "cls")]
    except ValueError:
        return []


class Caller(RuleBasedStateMachine):
    def __init__(self) -> None:
        super().__init__()
        world = self.world = evil.World()
        ground = world.add(evil.Rectangle(20, 1), at=(0, -1), kind="static")
        first = world.add(evil.Circle(0.5), at=(0, 2))
        second = world.add([evil.Rectangle(1, 1), evil.Circle(0.3)], at=(2, 2))
        world.add_force(evil.Spring(to=first, stiffness=5, rest_length=1), [second])
        world.add_joint(evil.joints.Hinge(first, second, at=(1, 2)))
        world.step()
        self.kept: list[Any] = [ground, first, second]

    def objects(self) -> list[Any]:
        """Whatever can be asked for something, handles of what is gone among them."""
        world = self.world
        bodies = list(world.bodies)[:40]
        parts = [shape for body in bodies[:8] for shape in body.shapes]
        return [world, world.bodies, world.contacts, world.joints, *bodies, *parts, *world.forces[:8],
                *list(world.joints)[:8], *world.contacts.active[:3], *self.kept]  # fmt: skip

    def resolved(self, given: Any) -> Any:
        if isinstance(given, tuple) and given and given[0] is PICKED:
            things = self.objects()[4:]
            return things[given[1] % len(things)]
        return given

    def attempt(self, what: str, action: Callable[[], Any]) -> Any:
        before = self.world.checksum()
        refused: Exception | None = None
        try:
            result = action()
        except (evil.Error, TypeError, AttributeError) as error:
            refused, result = error, None
        if isinstance(refused, evil.Error):
            assert str(refused), what
            assert self.world.checksum() == before, f"{what}: changed by what was refused: {refused}"
        elif refused is not None:  # Python's own: arguments that are missing, what cannot be set
            expected = ("argument", "no setter", "can't set", "has no attribute", "not callable", "read-only")
            assert any(each in str(refused) for each in expected), f"{what}: {type(refused).__name__}: {refused}"
        if isinstance(result, (evil.Body, evil.Shape, evil.Force)) and len(self.kept) < 60:
            self.kept.append(result)
        return result

    @rule(which=st.integers(0, 999), name=st.integers(0, 999), given=st.lists(value, max_size=3), named=value,
          chosen=st.integers(0, 99), by_name=st.booleans())  # fmt: skip
    def call(self, which: int, name: int, given: list[Any], named: Any, chosen: int, by_name: bool) -> None:
        things = self.objects()
        thing = things[which % len(things)]
        names = [each for each in dir(type(thing)) if not each.startswith("_") and each not in SKIPPED]
        word = names[name % len(names)]
        what = f"{type(thing).__name__}.{word}"
        arguments = [self.resolved(each) for each in given]
        attribute = inspect.getattr_static(type(thing), word)
        if not callable(attribute) and not isinstance(attribute, (staticmethod, classmethod)):
            if arguments and isinstance(thing, (evil.World, evil.Body, evil.Shape, evil.Force)):
                self.attempt(f"{what} = {arguments[0]!r}", lambda: setattr(thing, word, arguments[0]))
            else:
                self.attempt(what, lambda: getattr(thing, word))
            return
        options = {}
        if by_name:
            known = keywords_of(getattr(thing, word))
            if known:
                options[known[chosen % len(known)]] = self.resolved(named)
        self.attempt(f"{what}(*{arguments!r}, **{options!r})", lambda: getattr(thing, word)(*arguments, **options))
        self.kept = self.kept[-60:]

    @rule(make=shapes, at=st.tuples(plain, plain))
    def add(self, make: Any, at: Any) -> None:
        if len(self.world.bodies) < 60:
            self.kept.append(self.world.add(make, at=at))

    @rule()
    def step(self) -> None:
        self.world.step()
        for body in self.world.bodies:
            assert all(map(math.isfinite, (*body.position, *body.velocity, body.angle, body.angular_velocity)))

    @rule()
    def come_back(self) -> None:
        data = self.world.snapshot()
        self.world.restore(data)
        assert self.world.snapshot() == data


def test_every_public_call_with_whatever_comes() -> None:
    run_state_machine_as_test(
        Caller,
        settings=settings(
            max_examples=ROUNDS or 60,
            stateful_step_count=40,
            derandomize=not ROUNDS,
            database=None,
            deadline=None,
            suppress_health_check=list(HealthCheck),
        ),
    )
