"""Nothing fast passes through what is in its way (SPEC C8)."""

from __future__ import annotations

import itertools
import math

import pytest

import evilengine as evil
from evilengine.world.shapes import ShapeDefinition

BULLETS: list[ShapeDefinition] = [
    evil.Circle(0.05),
    evil.Circle(0.002),
    evil.Rectangle(0.1, 0.1),
    evil.Rectangle(1, 0.02),
    evil.Rectangle(0.02, 1),
    evil.Capsule((-0.4, 0), (0.4, 0), 0.01),
    evil.Segment((-0.2, 0), (0.2, 0)),
    evil.Polygon([(0, 0), (0.3, 0.05), (0, 0.1)]),
    evil.Rectangle(0.2, 0.2, rounding=0.05),
]
WALLS: list[ShapeDefinition] = [
    evil.Rectangle(0.01, 400),
    evil.Segment((0, -200), (0, 200)),
    evil.Chain([(0, -200), (0, 0.013), (0, 200)]),
    evil.Capsule((0, -200), (0, 200), 0.005),
]


@pytest.mark.parametrize("wall", WALLS, ids=repr)
@pytest.mark.parametrize("shape", BULLETS, ids=repr)
def test_a_bullet_at_1000_metres_a_second_never_passes_a_wall_of_a_centimetre(
    shape: ShapeDefinition, wall: ShapeDefinition
) -> None:
    for i, spin in enumerate((0, 3, -40, 400)):
        world = evil.World(gravity=(0, 0))
        world.add(wall, at=(10, 0), kind="static")
        bullet = world.add(
            shape, at=(0.37 * i, 0.011 * i), angle=0.3 * i, velocity=(1000, 20 * i), angular_velocity=spin, bullet=True
        )
        for _ in range(20):
            world.step(1 / 60)
            assert bullet.centre.x < 10
        assert bullet.velocity.x < 100


@pytest.mark.parametrize("kind", ["kinematic", "dynamic"])
@pytest.mark.parametrize("wall_speed", [-300, -20, 40, 300])
@pytest.mark.parametrize("shape", BULLETS[:4] + BULLETS[6:7], ids=repr)
def test_a_bullet_does_not_pass_a_wall_that_moves(shape: ShapeDefinition, wall_speed: float, kind: str) -> None:
    world = evil.World(gravity=(0, 0))
    options = {"density": 1e6} if kind == "dynamic" else {}
    wall = world.add(evil.Rectangle(0.01, 400), at=(12, 0), kind=kind, velocity=(wall_speed, 0), **options)
    bullet = world.add(shape, at=(0.4, 0.1), velocity=(1000, 0), bullet=True)
    for _ in range(20):
        world.step(1 / 60)
        assert bullet.centre.x < wall.position.x


def test_a_bullet_that_hangs_still_is_not_passed_by_a_wall() -> None:
    world = evil.World(gravity=(0, 0))
    wall = world.add(evil.Rectangle(0.01, 400), at=(-7, 0), kind="kinematic", velocity=(1000, 0))
    bullet = world.add(evil.Circle(0.02), at=(0, 0), bullet=True)
    for _ in range(5):
        world.step(1 / 60)
        assert bullet.position.x > wall.position.x or wall.position.x < 0


@pytest.mark.parametrize("shape", [evil.Circle(0.05), evil.Rectangle(0.1, 0.1), evil.Rectangle(0.6, 0.02)], ids=repr)
@pytest.mark.parametrize("speeds", [(1000, -1000), (1000, -30), (400, 0)])
def test_two_bullets_head_on_meet(shape: ShapeDefinition, speeds: tuple[float, float]) -> None:
    world = evil.World(gravity=(0, 0))
    left = world.add(shape, at=(-9.1, 0), velocity=(speeds[0], 0), bullet=True, restitution=1)
    right = world.add(shape, at=(9.3, 0), velocity=(speeds[1], 0), bullet=True, restitution=1)
    for _ in range(20):
        world.step(1 / 60)
        assert left.centre.x < right.centre.x
    assert left.velocity.x < right.velocity.x  # they part


@pytest.mark.parametrize("shape", [evil.Rectangle(0.1, 0.1), evil.Rectangle(1.5, 0.02), evil.Circle(0.03)], ids=repr)
def test_what_is_no_bullet_is_held_by_what_stands_still(shape: ShapeDefinition) -> None:
    for speed in (30, 120, 1000):
        world = evil.World(gravity=(0, 0))
        world.add(evil.Segment((0, -9), (0, 9)), at=(10, 0), kind="static")
        body = world.add(shape, at=(0.2, 0.1), angle=0.4, velocity=(speed, 0), angular_velocity=9)
        for _ in range(40):
            world.step(1 / 60)
            assert body.centre.x < 10


@pytest.mark.parametrize("restitution", [0.0, 0.5, 1.0])
def test_a_bullet_bounces_by_its_restitution_in_the_step_after_it_was_stopped(restitution: float) -> None:
    world = evil.World(gravity=(0, 0))
    world.add(evil.Rectangle(0.01, 400), at=(10, 0), kind="static")
    bullet = world.add(evil.Circle(0.05), velocity=(1000, 0), bullet=True, restitution=restitution)
    world.step(1 / 60)
    assert bullet.velocity.x == pytest.approx(1000)
    assert bullet.position.x == pytest.approx(10 - 0.005 - 0.05, abs=0.012)
    world.step(1 / 60)
    assert bullet.velocity.x == pytest.approx(-1000 * restitution, abs=5)


def test_a_thrown_body_off_centre_cannot_squeeze_its_weight_past() -> None:
    """A long arm whose centre of mass lies at one end, and which turns as it flies."""
    world = evil.World(gravity=(0, 0))
    world.add(evil.Rectangle(0.01, 400), at=(10, 0), kind="static")
    axe = world.add([evil.Rectangle(1, 0.02)], velocity=(900, 0), angular_velocity=70, bullet=True)
    axe.add_shape(evil.Circle(0.1), offset=(0.5, 0), density=20)
    for _ in range(30):
        world.step(1 / 60)
        assert axe.centre.x < 10
        assert axe.to_world((-0.5, 0)).x < 10.2


def test_sliding_fast_over_tiles_is_not_stopped() -> None:
    world = evil.World()
    for i in range(100):
        world.add(evil.Rectangle(1, 1), at=(i + 0.5, -0.5), kind="static")
    box = world.add(evil.Rectangle(0.1, 0.1), at=(1, 0.05), velocity=(60, 0), friction=0, bullet=True)
    for i in range(90):
        world.step(1 / 60)
        assert box.position.x == pytest.approx(1 + (i + 1), abs=0.01)


def test_a_bullet_hits_the_first_of_several_walls_and_pushes_it() -> None:
    world = evil.World(gravity=(0, 0))
    walls = [world.add(evil.Rectangle(0.01, 4), at=(5 + 2 * i, 0)) for i in range(3)]
    bullet = world.add(evil.Circle(0.05), velocity=(600, 0), bullet=True, mass=0.02)
    for _ in range(10):
        world.step(1 / 60)
    assert bullet.position.x < walls[0].position.x
    assert walls[0].velocity.x > 10
    before = 0.02 * 600
    after = 0.02 * bullet.velocity.x + sum(wall.mass * wall.velocity.x for wall in walls)
    assert after == pytest.approx(before, rel=1e-4)


def test_a_fast_body_lands_where_a_slow_one_would_rest() -> None:
    world = evil.World()
    world.add(evil.Segment((-5, 0), (5, 0)), kind="static")
    body = world.add(evil.Rectangle(0.2, 0.2), at=(0, 8), velocity=(0, -30))
    for _ in range(300):
        world.step(1 / 60)
        assert body.position.y > 0
    assert body.position.y == pytest.approx(0.1, abs=0.006)
    assert math.cos(4 * body.angle) == pytest.approx(1, abs=1e-3)


def test_sensors_and_joined_bodies_are_no_walls() -> None:
    world = evil.World(gravity=(0, 0))
    world.add(evil.Rectangle(0.01, 400), at=(5, 0), kind="static", sensor=True)
    bullet = world.add(evil.Circle(0.05), velocity=(1000, 0), bullet=True)
    world.step(1 / 60)
    assert bullet.position.x == pytest.approx(1000 / 60, rel=1e-3)


@pytest.mark.parametrize("spin", [-1000, 0, 300])
@pytest.mark.parametrize("angle", [0, 1.2])
def test_a_turning_wall_does_not_sweep_over_a_bullet_that_slides_along_it(angle: float, spin: float) -> None:
    """The bullet goes away from where the wall was, the wall comes after it, faster."""
    shapes = [evil.Rectangle(0.05, 0.02), evil.Segment((-0.05, 0), (0.05, 0)), evil.Circle(0.01)]
    for shape, start in itertools.product(shapes, (-3, -8.17, -11)):
        world = evil.World(gravity=(0, 0))
        wall = world.add(evil.Rectangle(0.01, 60), kind="kinematic", angular_velocity=6, angle=0.1)
        bullet = world.add(shape, at=(start, 0.3), velocity=(1000, 0), angle=angle, angular_velocity=spin, bullet=True)
        for _ in range(12):
            world.step(1 / 60)
            assert wall.to_local(bullet.centre).x < 0
