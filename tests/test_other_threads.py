"""Other threads of Python: they run while a large world steps, and what they ask of it waits; nothing goes wrong."""

from __future__ import annotations

import random
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager

import pytest

import evilengine as evil

BALLS = [(i % 30 * 0.9, 1 + i // 30 * 0.9) for i in range(400)]  # enough that a step lets other threads run


def pile(balls: list[tuple[float, float]] = BALLS) -> evil.World:
    world = evil.World()
    world.add(evil.Rectangle(60, 1), at=(13, -0.5), kind="static")
    world.add_many(evil.Circle(0.4), balls, tag="ball")
    return world


@contextmanager
def meanwhile(*works: Callable[[], object]) -> Iterator[None]:
    """Each of `works` again and again in a thread of its own; what one of them raises comes out at the end."""
    over = threading.Event()
    wrong: list[BaseException] = []

    def loop(work: Callable[[], object]) -> None:
        try:
            while not over.is_set():
                work()
        except BaseException as error:
            wrong.append(error)

    threads = [threading.Thread(target=loop, args=(work,)) for work in works]
    for thread in threads:
        thread.start()
    try:
        yield
    finally:
        over.set()
        for thread in threads:
            thread.join()
    if wrong:
        raise wrong[0]


def most_ticks_in_a_call(call: Callable[[], object]) -> int:
    """How often another thread came to run while `call` did: where it keeps the GIL, never."""
    ticks = 0

    def tick() -> None:
        nonlocal ticks
        ticks += 1
        time.sleep(0)

    most, before = 0, sys.getswitchinterval()
    sys.setswitchinterval(30)  # so that nobody is made to hand over the GIL
    try:
        with meanwhile(tick):
            for _ in range(40):
                seen = ticks
                call()
                most = max(most, ticks - seen)
                time.sleep(0.001)
    finally:
        sys.setswitchinterval(before)
    return most


def test_others_run_while_a_large_world_steps() -> None:
    assert most_ticks_in_a_call(pile()._core.sums) == 0  # which shows that the measure can fail
    core = pile()._core
    assert most_ticks_in_a_call(lambda: core.step(1 / 60, 32)) > 0


def test_others_run_while_many_rays_are_cast() -> None:
    world = pile()
    ends = [(x * 0.01, -1.0) for x in range(2000)]
    assert most_ticks_in_a_call(lambda: world.ray_casts((10, 50), ends)) > 0


def test_who_only_looks_changes_nothing_and_sees_whole_steps() -> None:
    alone, watched = pile(), pile()
    ball = watched.find("ball")
    assert ball is not None
    snapshots: list[bytes] = []

    def compare() -> None:
        state = watched.snapshot()
        assert evil.World.of(state).snapshot() == state
        snapshots.append(state)

    works = (
        lambda: (ball.position, ball.velocity, ball.awake, hash(ball), ball == ball),
        lambda: watched.ray_casts((0, 30), [(x, 0) for x in range(600)]),
        lambda: watched.overlapping(evil.Circle(2), at=(10, 3)),
        lambda: [contact.point for contact in watched.contacts.active],
        compare,
    )
    whole = set()
    with meanwhile(*works):
        for _ in range(30):
            watched.step()
    for _ in range(30):
        whole.add(alone.snapshot())
        alone.step()
    assert watched.checksum() == alone.checksum()
    assert set(snapshots) <= whole | {alone.snapshot()}


def test_others_may_change_the_world_between_the_steps() -> None:
    world = pile()
    start = world.snapshot()
    chance = random.Random(5)

    def come_and_go() -> None:
        body = world.add(evil.Circle(0.3), at=(chance.uniform(0, 25), 20), tag="guest")
        body.apply_impulse((1, 2))
        body.position = (chance.uniform(0, 25), 15)
        body.destroy()
        with pytest.raises(evil.StaleReferenceError):
            body.position = (0, 0)

    def push() -> None:
        body = world.find("ball")
        assert body is not None
        body.velocity = (0, 1)
        body.friction = chance.random()
        world.gravity = (0, -chance.uniform(5, 10))

    def tie() -> None:
        a, b = world.add(evil.Circle(0.2), at=(0, 30)), world.add(evil.Circle(0.2), at=(1, 30))
        world.add_joint(evil.joints.Distance(a, b)).destroy()
        a.destroy()
        b.destroy()

    with meanwhile(come_and_go, push, tie):
        for _ in range(60):
            world.step()
    assert len(world.bodies) == len(BALLS) + 1
    world.restore(start)
    assert world.snapshot() == start


def test_others_may_take_the_world_back_between_the_steps() -> None:
    world = pile()
    start = world.snapshot()
    with meanwhile(lambda: world.restore(start)):
        for _ in range(40):
            world.step()
            assert all(body.alive for body in world.bodies)
    world.restore(start)
    assert world.snapshot() == start


def test_a_thread_that_asks_gets_its_turn_while_another_only_steps() -> None:
    world = pile()
    looks = 0

    def step() -> None:
        for _ in range(5):
            world.step()

    with meanwhile(step):
        until = world.steps + 200
        while world.steps < until and looks < 20:
            looks += 1
    assert looks == 20


def test_two_worlds_in_two_threads_live_as_each_does_alone() -> None:
    def life() -> int:
        world = pile()
        for _ in range(40):
            world.step()
        return world.checksum()

    alone = life()
    found: list[int] = []
    threads = [threading.Thread(target=lambda: found.append(life())) for _ in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert found == [alone, alone]


def test_two_threads_cannot_step_one_world_at_once() -> None:
    world = pile()
    inside, go_on = threading.Event(), threading.Event()

    def wait(dt: float) -> None:
        inside.set()
        assert go_on.wait(10)

    body = next(iter(world.bodies))
    body.on_update(wait)
    thread = threading.Thread(target=world.step)
    thread.start()
    assert inside.wait(10)
    with pytest.raises(evil.ArgumentError, match="another thread is in the middle of this world's step"):
        world.step()
    go_on.set()
    thread.join()
    assert world.steps == 1


def test_callbacks_and_python_forces_have_their_world_to_themselves() -> None:
    class Wind(evil.Force):
        def apply(self, bodies: tuple[evil.Body, ...], dt: float) -> None:
            for body in bodies[:20]:
                body.apply_force((1, 0))

    def life() -> int:
        world = pile()
        world.add_force(Wind())
        heard: list[float] = []
        for body in list(world.bodies)[1:50]:
            body.on_collide(lambda contact: heard.append(contact.a.position.x))
        with meanwhile(lambda: world.steps, lambda: sum(range(1000))):
            for _ in range(25):
                world.step()
        assert heard
        return hash((world._core.checksum(), tuple(heard)))

    assert life() == life()


def test_threads_that_never_end_do_no_harm_when_python_does() -> None:
    program = """
import threading, time, evilengine as evil
world = evil.World(threads=2)
world.add_many(evil.Circle(0.4), [(i % 40 * 0.85, i // 40) for i in range(800)])
def step():
    while True: world.step()
def look():
    while True: world.checksum(), world.steps
for loop in (step, look, look): threading.Thread(target=loop, daemon=True).start()
time.sleep(0.1)
"""
    ended = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=60)
    assert ended.returncode == 0, ended.stderr


class Number:
    """A number that changes the world while it is read."""

    def __init__(self, meddle: Callable[[], object]) -> None:
        self.meddle = meddle

    def __float__(self) -> float:
        self.meddle()
        return 0.5


class Pair:
    """A point that does so too."""

    def __init__(self, meddle: Callable[[], object]) -> None:
        self.meddle = meddle

    def __len__(self) -> int:
        return 2

    def __getitem__(self, i: int) -> float:
        self.meddle()
        return 0.5


def setting(name: str) -> Callable[[evil.Body, Number, Pair], object]:
    point = name in ("position", "velocity", "scale", "one_way")
    return lambda body, number, pair: setattr(body, name, pair if point else number)


USES: dict[str, Callable[[evil.Body, Number, Pair], object]] = {
    **{name: setting(name) for name in ("position", "velocity", "scale", "one_way", "angle", "angular_velocity")},
    **{name: setting(name) for name in ("friction", "damping", "mass", "surface_speed")},
    "density of a shape": lambda body, number, pair: setattr(body.shapes[0], "density", number),
    "friction of a shape": lambda body, number, pair: setattr(body.shapes[0], "friction", number),
    "one_way of a shape": lambda body, number, pair: setattr(body.shapes[0], "one_way", pair),
    "apply_force": lambda body, number, pair: body.apply_force(pair, pair),
    "apply_impulse": lambda body, number, pair: body.apply_impulse(pair, pair),
    "apply_torque": lambda body, number, pair: body.apply_torque(number),
    "apply_angular_impulse": lambda body, number, pair: body.apply_angular_impulse(number),
    "velocity_at": lambda body, number, pair: body.velocity_at(pair),
    "to_local": lambda body, number, pair: body.to_local(pair),
    "to_world": lambda body, number, pair: body.to_world(pair),
    "apply_matrix": lambda body, number, pair: body.apply_matrix([number, *evil.Mat4.identity()[1:]]),
}


@pytest.mark.parametrize("use", USES.values(), ids=USES)
@pytest.mark.parametrize("meddling", ["grow", "destroy", "step"])
def test_a_value_that_meddles_with_the_world_while_it_is_read_does_no_harm(
    use: Callable[[evil.Body, Number, Pair], object], meddling: str
) -> None:
    world = evil.World()
    body = world.add(evil.Circle(0.5))
    body.add_shape(evil.Circle(0.5), offset=(1, 0))

    def meddle() -> None:
        if meddling == "grow":
            world.add_many(evil.Circle(0.1), [(float(i), 50.0) for i in range(500)])
        elif meddling == "step":
            world.step()
        elif body.alive:
            body.destroy()

    try:
        use(body, Number(meddle), Pair(meddle))
    except evil.StaleReferenceError:
        assert meddling == "destroy"
    except evil.ShapeError:
        assert use in (USES["scale"], USES["apply_matrix"])  # which a circle refuses
    else:
        assert meddling != "destroy"
    world.add(evil.Circle(1))
    world.step()
