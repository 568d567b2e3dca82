"""Plays with the world at random, the way no person would, and watches that its promises hold.

Whatever is asked of it: it never crashes, no NaN leaves a step, counts agree, an error leaves the world as it was,
a stale handle says so and never becomes another object, and a restored snapshot is the same world to the last bit.
"""

from __future__ import annotations

import math
import os
from collections.abc import Callable
from typing import TypeVar

import pytest
from hypothesis import HealthCheck, settings
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, invariant, precondition, rule, run_state_machine_as_test

import evilengine as evil

T = TypeVar("T")
DT = 1 / 60
ROUNDS = int(os.environ.get("EVIL_FUZZ", "0"))  # how many games to play by chance; 0: a hundred, always the same

# Mostly what a game would say, sometimes what breaks careless code.
plain = st.floats(-20, 20, width=32)
size = st.floats(0.0625, 5, width=32)
odd = st.sampled_from([0.0, -0.0, 1e-45, 1e-30, -1e-6, 1e6, 1e30, 3e38, -3e38, 1e300, math.inf, -math.inf, math.nan])
number = st.one_of(plain, plain, plain, odd)
length = st.one_of(size, size, size, size, odd)
point = st.one_of(st.tuples(plain, plain), st.tuples(plain, plain), st.tuples(number, number))
fraction = st.one_of(st.floats(0, 1, width=32), st.floats(0, 1, width=32), odd)

shape = st.one_of(
    st.builds(lambda radius: lambda: evil.Circle(radius), length),
    st.builds(lambda width, height: lambda: evil.Rectangle(width, height), length, length),
    st.builds(lambda a, b, c: lambda: evil.Triangle(a, b, c), point, point, point),
    st.builds(lambda corners: lambda: evil.Polygon(corners), st.lists(point, max_size=8)),
    st.builds(lambda mass: lambda: evil.Particle(mass=mass), length),
)
kind = st.sampled_from(["dynamic", "dynamic", "dynamic", "static", "kinematic"])


class WorldMachine(RuleBasedStateMachine):
    def __init__(self) -> None:
        super().__init__()
        self.world = evil.World(gravity=(0, -9.81))
        self.order: list[evil.Body] = []  # living bodies, in order of creation
        self.number: dict[evil.Body, int] = {}  # every handle ever given out: which thing it stood for
        self.things = 0
        self.dead: list[evil.Body] = []
        self.forces: list[evil.Force] = []
        self.saved: tuple[bytes, int, list[int]] | None = None  # a snapshot, its checksum, the things in it

    def attempt(self, action: Callable[[], T]) -> T | None:
        """Do it, or be refused with an error of ours and a world that is as it was."""
        before = self.world.checksum()
        refused: evil.Error | None = None
        try:
            return action()
        except evil.Error as error:
            refused = error
        assert str(refused)
        assert self.world.checksum() == before, f"changed by what was refused: {refused}"
        return None

    def born(self, body: evil.Body | None) -> None:
        if body is not None:
            assert body not in self.number, "a handle was given out twice"
            self.number[body] = self.things = self.things + 1
            self.order.append(body)

    def one_of(self, handles: list[T], choice: int) -> T:
        return handles[choice % len(handles)]

    # Making things

    @rule(make=shape, at=point, angle=number, kind=kind, velocity=point, spin=number)
    def add(
        self, make: Callable[[], evil.Shape], at: object, angle: float, kind: str, velocity: object, spin: float
    ) -> None:
        body = self.attempt(
            lambda: self.world.add(make(), at=at, angle=angle, kind=kind, velocity=velocity, angular_velocity=spin)
        )
        self.born(body)

    @rule(make=shape, density=length, friction=fraction, restitution=fraction, damping=fraction, scale=number)
    def add_odd_material(
        self,
        make: Callable[[], evil.Shape],
        density: float,
        friction: float,
        restitution: float,
        damping: float,
        scale: float,
    ) -> None:
        material = {"density": density, "friction": friction, "restitution": restitution, "damping": damping}
        body = self.attempt(lambda: self.world.add(make(), gravity_scale=scale, **material))
        self.born(body)

    @precondition(lambda self: self.order)
    @rule(make=shape, choice=st.integers(0, 99), offset=point, angle=number)
    def add_shape(self, make: Callable[[], evil.Shape], choice: int, offset: object, angle: float) -> None:
        body = self.one_of(self.order, choice)
        shapes = len(body.shapes)
        added = self.attempt(lambda: body.add_shape(make(), offset=offset, angle=angle))
        assert len(body.shapes) == shapes + (added is not None)

    @precondition(lambda self: self.order)
    @rule(
        choice=st.integers(0, 99),
        other=st.integers(0, 99),
        to=point,
        stiffness=number,
        rest=length,
        kind=st.integers(0, 5),
    )
    def add_force(self, choice: int, other: int, to: object, stiffness: float, rest: float, kind: int) -> None:
        body = self.one_of(self.order, choice)
        makers: list[Callable[[], evil.Force]] = [
            lambda: evil.Spring(to=to, stiffness=stiffness, rest_length=rest, damping=0.5),
            lambda: evil.Spring(to=self.one_of(self.order, other), stiffness=stiffness, rest_length=rest),
            lambda: evil.Gravity(to),
            lambda: evil.ConstantForce(to),
            lambda: evil.Drag(),
            lambda: evil.Medium((-5, -5, 5, 5)),
        ]
        force = self.attempt(lambda: body.add_force(makers[kind]()))
        if force is not None:
            self.forces.append(force)

    # Changing things

    @precondition(lambda self: self.order)
    @rule(choice=st.integers(0, 99), name=st.sampled_from(["position", "velocity"]), value=point)
    def set_vector(self, choice: int, name: str, value: object) -> None:
        body = self.one_of(self.order, choice)
        self.attempt(lambda: setattr(body, name, value))

    @precondition(lambda self: self.order)
    @rule(choice=st.integers(0, 99), name=st.sampled_from(["angle", "angular_velocity"]), value=number)
    def set_number(self, choice: int, name: str, value: float) -> None:
        body = self.one_of(self.order, choice)
        self.attempt(lambda: setattr(body, name, value))

    @precondition(lambda self: self.order)
    @rule(
        choice=st.integers(0, 99),
        push=point,
        at=st.none() | point,
        verb=st.sampled_from(["apply_force", "apply_impulse"]),
    )
    def push(self, choice: int, push: object, at: object, verb: str) -> None:
        body = self.one_of(self.order, choice)
        self.attempt(lambda: getattr(body, verb)(push, at=at))

    @precondition(lambda self: self.order)
    @rule(choice=st.integers(0, 99), torque=number)
    def turn(self, choice: int, torque: float) -> None:
        body = self.one_of(self.order, choice)
        self.attempt(lambda: body.apply_torque(torque))

    @precondition(lambda self: self.order)
    @rule(choice=st.integers(0, 99), entries=st.lists(number, min_size=15, max_size=17))
    def apply_matrix(self, choice: int, entries: list[float]) -> None:
        body = self.one_of(self.order, choice)
        self.attempt(lambda: body.apply_matrix(entries))

    @precondition(lambda self: self.order)
    @rule(choice=st.integers(0, 99), kind=kind)
    def change_kind(self, choice: int, kind: str) -> None:
        body = self.one_of(self.order, choice)
        self.attempt(lambda: setattr(body, "kind", kind))

    @precondition(lambda self: self.order)
    @rule(
        choice=st.integers(0, 99),
        which=st.integers(0, 9),
        name=st.sampled_from(["friction", "restitution", "density"]),
        value=fraction,
    )
    def change_shape(self, choice: int, which: int, name: str, value: float) -> None:
        shapes = self.one_of(self.order, choice).shapes
        if shapes:
            self.attempt(lambda: setattr(shapes[which % len(shapes)], name, value))

    @precondition(lambda self: self.order)
    @rule(choice=st.integers(0, 99), which=st.integers(0, 9))
    def destroy_shape(self, choice: int, which: int) -> None:
        body = self.one_of(self.order, choice)
        shapes = body.shapes
        if not shapes:
            return
        shape = shapes[which % len(shapes)]
        if self.attempt(lambda: shape.destroy() or True):
            assert len(body.shapes) == len(shapes) - 1
            with pytest.raises(evil.StaleReferenceError):
                _ = shape.body

    @precondition(lambda self: self.forces and self.order)
    @rule(choice=st.integers(0, 99), body=st.integers(0, 99))
    def share_force(self, choice: int, body: int) -> None:
        force = self.one_of(self.forces, choice)
        self.attempt(lambda: self.world.add_force(force, [self.one_of(self.order, body)]))

    @precondition(lambda self: self.forces)
    @rule(
        choice=st.integers(0, 99),
        name=st.sampled_from(["stiffness", "rest_length", "damping", "linear", "quadratic"]),
        value=number,
    )
    def change_force(self, choice: int, name: str, value: float) -> None:
        force = self.one_of(self.forces, choice)
        if hasattr(type(force), name):
            self.attempt(lambda: setattr(force, name, value))

    @rule(gravity=point)
    def set_gravity(self, gravity: object) -> None:
        self.attempt(lambda: setattr(self.world, "gravity", gravity))

    @rule(steps=st.integers(1, 8), substeps=st.integers(1, 4))
    def step(self, steps: int, substeps: int) -> None:
        for _ in range(steps):
            self.world.step(DT, substeps=substeps)

    @rule(dt=odd.filter(lambda dt: not 0 < dt < 1), substeps=st.sampled_from([-1, 0, 4]))
    def step_of_no_length(self, dt: float, substeps: int) -> None:
        before = self.world.checksum()
        with pytest.raises(evil.Error):
            self.world.step(dt, substeps=substeps)
        assert self.world.checksum() == before

    # Ending things

    @precondition(lambda self: self.order)
    @rule(choice=st.integers(0, 99))
    def destroy(self, choice: int) -> None:
        body = self.one_of(self.order, choice)
        body.destroy()
        self.order.remove(body)
        self.dead.append(body)

    @precondition(lambda self: self.forces)
    @rule(choice=st.integers(0, 99))
    def destroy_force(self, choice: int) -> None:
        force = self.forces.pop(choice % len(self.forces))
        try:
            force.destroy()
        except evil.StaleReferenceError:
            return  # it went with its body
        with pytest.raises(evil.StaleReferenceError):
            force.destroy()

    @precondition(lambda self: self.dead)
    @rule(choice=st.integers(0, 99))
    def use_a_stale_handle(self, choice: int) -> None:
        body = self.one_of(self.dead, choice)
        before = self.world.checksum()
        assert not body.alive
        for use in (
            lambda: body.position,
            lambda: setattr(body, "velocity", (1, 0)),
            lambda: body.apply_impulse((1, 0)),
            lambda: body.add_shape(evil.Circle(1)),
            lambda: body.add_force(evil.Drag()),
            lambda: body.shapes,
            body.destroy,
        ):
            with pytest.raises(evil.StaleReferenceError):
                use()
        assert self.world.checksum() == before

    # Asking

    @rule(start=point, end=point)
    def ray_cast(self, start: object, end: object) -> None:
        hit = self.attempt(lambda: self.world.ray_cast(start, end))
        if hit is not None:
            assert hit.body.alive
            assert 0 <= hit.fraction <= 1
            assert math.isclose(hit.normal.length, 1, abs_tol=1e-4)

    @rule(at=point, make=shape)
    def bodies_near(self, at: object, make: Callable[[], evil.Shape]) -> None:
        for found in (
            self.attempt(lambda: self.world.bodies_at(at)),
            self.attempt(lambda: self.world.overlapping(make(), at=at)),
        ):
            assert all(body.alive for body in found or ())

    # Keeping and going back

    @rule()
    def save(self) -> None:
        self.saved = (self.world.snapshot(), self.world.checksum(), [self.number[body] for body in self.order])

    @precondition(lambda self: self.saved)
    @rule()
    def restore(self) -> None:
        assert self.saved is not None
        data, checksum, things = self.saved
        before = self.order
        self.world.restore(data)
        assert self.world.checksum() == checksum
        assert self.world.snapshot() == data

        # A handle stays good if its thing is in the snapshot; one that was destroyed, or made since, is stale for ever.
        self.order = list(self.world.bodies)
        for body, thing in zip(self.order, things, strict=True):
            assert self.number.setdefault(body, thing) == thing
        for body in before:
            assert body.alive == (self.number[body] in things)
        self.dead += [body for body in before if not body.alive]
        assert not any(body.alive for body in self.dead)
        self.forces = list(self.world.forces)

    @rule()
    def another_world_goes_on_alike(self) -> None:
        twin = evil.World()
        twin.restore(self.world.snapshot())
        for _ in range(3):
            twin.step(DT)
            self.world.step(DT)
        assert twin.checksum() == self.world.checksum()

    @rule(position=st.floats(0, 1), flip=st.integers(1, 255), cut=st.booleans())
    def damaged_snapshot(self, position: float, flip: int, cut: bool) -> None:
        data = bytearray(self.world.snapshot())
        place = min(int(position * len(data)), len(data) - 1)
        if cut:
            del data[place:]
        else:
            data[place] ^= flip
        before = self.world.checksum()
        with pytest.raises(evil.SnapshotError):
            self.world.restore(bytes(data))
        assert self.world.checksum() == before

    # What always holds

    @invariant()
    def counts_agree(self) -> None:
        assert len(self.world.bodies) == len(self.order)
        assert list(self.world.bodies) == self.order
        assert all(body.alive for body in self.order)

    @invariant()
    def every_number_is_finite(self) -> None:
        for body in self.order:
            numbers = (*body.position, *body.velocity, *body.centre, body.angle, body.angular_velocity)
            assert all(map(math.isfinite, numbers)), body
            assert body.mass > 0, "a body that cannot be moved weighs infinitely much"
            assert (body.mass == math.inf) == (body.kind != "dynamic")

    @invariant()
    def contacts_make_sense(self) -> None:
        for contact in self.world.contacts.active:  # of the last step: a body may have been destroyed since
            assert contact.a in self.number
            assert contact.b in self.number
            assert all(map(math.isfinite, (*contact.point, *contact.normal, contact.depth, contact.impulse)))
            assert math.isclose(contact.normal.length, 1, abs_tol=1e-4)


def test_the_world_keeps_its_promises_whatever_is_asked_of_it() -> None:
    run_state_machine_as_test(
        WorldMachine,
        settings=settings(
            max_examples=ROUNDS or 100,
            stateful_step_count=50,
            derandomize=not ROUNDS,
            database=None,
            deadline=None,
            suppress_health_check=list(HealthCheck),
        ),
    )
