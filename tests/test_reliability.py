"""Long runs, crowded beginnings, sizes and speeds at the edge of what a float holds: nothing explodes, nothing leaks.

The soak is a hundred thousand steps with EVIL_SOAK=100000 (some minutes); without it a twentieth of that.
"""

from __future__ import annotations

import contextlib
import math
import os
import random
import resource
import sys

import pytest

import evilengine as evil

STEP = 1 / 60
SOAK = int(os.environ.get("EVIL_SOAK", "5000"))
SANITIZED = bool(os.environ.get("EVIL_SANITIZED"))
CROWD = 300 if SANITIZED else 1000  # under the sanitizers a thousand take two minutes


def finite(world: evil.World) -> bool:
    """Is every number that the world gives out a number?"""
    arrays = (world.bodies.positions, world.bodies.angles, world.bodies.velocities, world.bodies.matrices)
    everything = (number for array in arrays for number in memoryview(array).cast("B").cast("f"))
    return all(map(math.isfinite, everything)) and all(
        math.isfinite(number) for contact in world.contacts.active for number in (*contact.point, *contact.normal)
    )


def fastest(world: evil.World) -> float:
    return max((body.velocity.length for body in world.bodies), default=0.0)


@pytest.mark.parametrize(("kind", "count"), [("circle", 200), ("rectangle", 200), ("mixed", CROWD)])
def test_bodies_made_in_one_point_come_apart_without_an_explosion(kind, count):
    dice = random.Random(1)
    world = evil.World()
    world.add(evil.Rectangle(400, 1), at=(0, -0.5), kind="static")
    for n in range(count):
        box = evil.Rectangle(dice.uniform(0.3, 0.7), dice.uniform(0.3, 0.7))
        round_one = kind == "circle" or (kind == "mixed" and n % 2)
        world.add(evil.Circle(dice.uniform(0.15, 0.35)) if round_one else box, at=(0, 3))
    greatest = 0.0
    for step in range(200):
        world.step(STEP)
        if step % 10 == 0:
            greatest = max(greatest, fastest(world))
            assert finite(world)
    # Layer pushes layer at 3 m/s, and a thousand lie sixteen deep. Without calm_buried, circles left at 230 m/s.
    assert greatest < 40, "metres a second: they are pushed apart, not shot"
    dynamic = [body for body in world.bodies if body.kind == "dynamic"]
    assert all(-0.5 < body.position.y < 60 and abs(body.position.x) < 120 for body in dynamic)
    assert sum(contact.depth > 0.1 for contact in world.contacts.active) < 0.05 * count, "and lie beside each other"


SIZES = (1e-3, 0.02, 1.0, 50.0, 1e4)
MASSES = (1e-9, 1e-3, 1.0, 1e6, 1e12)


@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("mass", MASSES)
def test_huge_and_tiny_bodies_among_ordinary_ones_stay_numbers(size, mass):
    world = evil.World()
    world.add(evil.Rectangle(100, 1), at=(0, -0.5), kind="static")
    for n in range(6):
        world.add(evil.Rectangle(1, 1), at=(n - 3, 0.5))
    for shape in (evil.Circle(size / 2), evil.Rectangle(size, size)):
        try:
            world.add(shape, at=(0.3, 1.5 + size), mass=mass)
        except evil.ShapeError:
            continue  # heavier to turn than a float can tell
    for _ in range(120):
        world.step(STEP)
        assert finite(world)


@pytest.mark.parametrize("speed", [1e3, 1e5, 1e8, 3e38])
@pytest.mark.parametrize("spin", [0.0, 1e4, 1e8])
def test_speeds_at_the_edge_are_refused_or_stay_numbers(speed, spin):
    world = evil.World()
    world.add(evil.Rectangle(100, 1), at=(0, -0.5), kind="static")
    for at, way in (((0, 5), (0, -1)), ((-5, 1), (1, 0)), ((3, 8), (-0.6, -0.8))):
        body = world.add(evil.Rectangle(1, 0.5), at=at)
        for change in (
            lambda body=body, way=way: setattr(body, "velocity", (way[0] * speed, way[1] * speed)),
            lambda body=body: setattr(body, "angular_velocity", spin),
            lambda body=body: body.apply_impulse((speed, -speed), at=(0.1, 0.2)),
            lambda body=body: body.apply_force((speed, speed)),
            lambda body=body: body.apply_torque(speed),
        ):
            with contextlib.suppress(evil.ArgumentError):  # what is more than a world holds is refused
                change()
    for _ in range(60):
        world.step(STEP)
        assert finite(world)
    assert all(abs(part) <= 1.01e7 for body in world.bodies for part in body.position), "none leaves the world"


@pytest.mark.parametrize("gravity", [(0, -1e6), (1e6, 0), (0, -1e-30)])
@pytest.mark.parametrize("dt", [1e-7, 1 / 60, 1.0])
def test_any_gravity_and_any_step_stay_numbers(gravity, dt):
    world = evil.World(gravity=gravity)
    world.add(evil.Rectangle(100, 1), at=(0, -0.5), kind="static")
    for n in range(20):
        world.add(evil.Circle(0.5) if n % 2 else evil.Rectangle(1, 1), at=(n % 5, n // 5 + 0.5), restitution=n / 20)
    for substeps in (1, 4, 64):
        for _ in range(10):
            world.step(dt, substeps)
            assert finite(world)


class Zoo:
    """A world in which things come and go: bodies of all shapes, forces, joints, questions, saves."""

    def __init__(self, seed: int) -> None:
        self.dice = random.Random(seed)
        self.world = evil.World()
        for at, size in (((0, -0.5), (40, 1)), ((-20, 10), (1, 22)), ((20, 10), (1, 22))):
            self.world.add(evil.Rectangle(*size), at=at, kind="static")
        self.bodies: list[evil.Body] = []
        self.saved = self.world.snapshot()
        self.most = 120

    def shape(self):
        dice, size = self.dice, self.dice.uniform(0.1, 0.8)
        return dice.choice(
            [
                lambda: evil.Circle(size),
                lambda: evil.Rectangle(2 * size, size),
                lambda: evil.Capsule((-size, 0), (size, 0), 0.5 * size),
                lambda: evil.Polygon([evil.Vec2(size, 0).turned(n * math.tau / 5) for n in range(5)]),
                lambda: evil.Polygon([(0, 0), (2 * size, 0), (2 * size, size), (size, 0.4 * size), (0, size)]),
            ]
        )()

    def live(self) -> None:
        """One step, with what a busy game does round it."""
        dice, world = self.dice, self.world
        self.bodies = [body for body in self.bodies if body.alive]
        if len(self.bodies) < self.most and dice.random() < 0.5:
            body = world.add(self.shape(), at=(dice.uniform(-15, 15), dice.uniform(4, 18)), restitution=dice.random())
            self.bodies.append(body)
            if dice.random() < 0.2:
                body.add_shape(evil.Circle(0.2), offset=(0.3, 0.1))
        if len(self.bodies) > 20:
            one, other = dice.sample(self.bodies, 2)
            what = dice.randrange(40)
            if what < 8:
                one.destroy()
            elif what < 12:
                one.apply_impulse((dice.uniform(-3, 3), dice.uniform(0, 6)))
            elif what == 12:
                one.add_force(evil.Spring(to=other, stiffness=20, rest_length=1))
            elif what == 13 and len(world.forces) > 10:
                world.forces[0].destroy()
            elif what in (14, 15):
                world.add_joint(evil.joints.Distance(one, other, stiffness=30, damping=1))
            elif what in (16, 17) and len(world.joints) > 10:
                next(iter(world.joints)).destroy()
            elif what == 18:
                world.ray_cast((-30, dice.uniform(0, 9)), (30, dice.uniform(0, 9)))
            elif what == 19:
                world.overlapping(evil.Circle(1), at=one.position)
            elif what == 20:
                one.kind = dice.choice(["dynamic", "static", "kinematic"])
            elif what == 21 and dice.random() < 0.2:
                world.restore(self.saved if dice.random() < 0.5 else world.snapshot())
        world.step(STEP)


def resident() -> float:
    """Megabytes that this process holds now."""
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * resource.getpagesize() / 1e6


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="asks Linux how much memory a process holds")
def test_a_world_in_which_things_come_and_go_holds_no_more_memory_in_the_end():
    zoo = Zoo(seed=3)
    for _ in range(SOAK // 5):
        zoo.live()
    before = resident()
    for step in range(SOAK):
        zoo.live()
        if step % 500 == 0:
            assert finite(zoo.world)
    if not SANITIZED:  # AddressSanitizer keeps what is let go of for a while
        assert resident() - before < 12, "megabytes"
    assert len(zoo.world.bodies) < 140
    assert len(zoo.world._handles) < 300
    assert len(zoo.world._shape_handles) < 600
    assert len(zoo.world.snapshot()) < 1_000_000


def test_the_same_life_comes_out_the_same():
    sums = []
    for _ in range(2):
        zoo = Zoo(seed=8)
        for _ in range(600):
            zoo.live()
        sums.append(zoo.world.checksum())
    assert sums[0] == sums[1]


def test_small_bodies_alone_at_the_edge_of_the_world_are_no_riddle():
    world = evil.World(gravity=(0, 0))
    for x, y in ((7e6, 7e6), (-7e6, 7e6), (7e6, -6.9e6)):
        world.add(evil.Circle(0.01), at=(x, y), velocity=(-1, 0))
    for _ in range(30):
        world.step(STEP)
        assert finite(world)
