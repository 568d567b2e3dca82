"""Gas and bodies push each other: as fast as physics says, both ways, and calmly however light a body is."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import evilengine as evil

DT = 1 / 60


def a_walled_box(**options: Any) -> tuple[evil.World, evil.Smoke]:
    world = evil.World(gravity=(0, -10))
    smoke = world.add_smoke((0, 0, 2, 2), cells=32, **options)
    for x in (-0.05, 2.05):
        world.add(evil.Rectangle(0.1, 6), at=(x, 1), kind="static")
    for y in (-0.05, 2.05):
        world.add(evil.Rectangle(4, 0.1), at=(1, y), kind="static")
    return world, smoke


@pytest.mark.parametrize("quality", ["fast", "high"])
@pytest.mark.parametrize("density", [0.3, 1.0, 5.0])
def test_what_falls_takes_the_gas_round_it_along(quality: str, density: float) -> None:
    """A disc must move as much gas as it displaces: it begins to fall with g * mass / (mass + displaced)."""
    world = evil.World(gravity=(0, -10))
    world.add_smoke((-4, -4, 4, 4), cells=128, weight=1, quality=quality)
    ball = world.add(evil.Circle(0.4), at=(0, 0), density=density)
    world.step(DT)
    speeds = []
    for _ in range(4):
        speeds.append(ball.velocity.y)
        world.step(DT)
    found = (ball.velocity.y - speeds[0]) / (4 * DT)
    assert found == pytest.approx(-10 * density / (density + 1), rel=0.12)


@pytest.mark.parametrize(
    ("quality", "density", "weight"),
    [
        ("fast", 0.05, 1.0),
        ("fast", 0.01, 1.0),
        ("fast", 0.05, 5.0),
        ("fast", 0.001, 5.0),
        ("high", 0.05, 1.0),
        ("high", 0.01, 1.0),
        ("high", 0.05, 5.0),
    ],
)
@pytest.mark.parametrize("seed", [0, 1])
def test_light_bodies_are_never_much_faster_than_the_gas_that_carries_them(
    quality: str, density: float, weight: float, seed: int
) -> None:
    """They were thrown about at 100 m/s where gas flowed at 4, near walls and each other most of all."""
    world, smoke = a_walled_box(weight=weight, quality=quality)
    smoke.add_source(at=(1, 0.3), radius=0.2, temperature=2, rate=1)
    dice = np.random.default_rng(seed)
    shapes = (
        evil.Circle(0.1),
        evil.Rectangle(0.3, 0.1),
        evil.Rectangle(0.15, 0.15),
        evil.Capsule((-0.1, 0), (0.1, 0), 0.05),
    )
    bodies = [
        world.add(shapes[k % 4], at=dice.uniform(0.15, 1.85, 2), angle=dice.uniform(0, 3), density=density)
        for k in range(6)
    ]
    gas = 0.0
    for _ in range(150):
        world.step(DT)
        gas = max(gas, float(np.abs(np.asarray(smoke.velocity)).max()))
        assert max(body.velocity.length for body in bodies) < 2 * gas + 2


def test_a_body_cut_by_the_side_of_the_box_stays_calm() -> None:
    world = evil.World(gravity=(0, 0))
    smoke = world.add_smoke((0, 0, 2, 2), cells=32, weight=1)
    half_out = world.add(evil.Rectangle(0.6, 0.3), at=(0, 1), density=0.05)
    stirrer = world.add(evil.Rectangle(0.5, 0.1), at=(1.2, 1), kind="kinematic", angular_velocity=3)
    for _ in range(120):
        world.step(DT)
        assert half_out.velocity.length < 1.5
    assert stirrer.angle > 5
    assert np.isfinite(np.asarray(smoke.velocity)).all()


def test_what_a_body_loses_the_gas_gets() -> None:
    """A plate that is stopped by gas gives it its momentum; not to the digit, as some leaves by the open sides."""
    world = evil.World(gravity=(0, 0))
    smoke = world.add_smoke((0, 0, 4, 4), cells=64, weight=1, open_sides="all")
    plate = world.add(evil.Rectangle(1.0, 0.2), at=(2, 2), density=5, velocity=(2, 0))
    for _ in range(10):
        world.step(DT)
    lost = plate.mass * (2 - plate.velocity.x)
    velocity = np.asarray(smoke.velocity)[..., 0]
    columns, rows = np.meshgrid((np.arange(64) + 0.5) / 16, (np.arange(64) + 0.5) / 16)
    outside = (abs(columns - plate.position.x) > 0.56) | (abs(rows - plate.position.y) > 0.1)
    got = float(velocity[outside].sum()) / 16**2
    assert lost > 0.1
    assert 0.5 * lost < got < 1.3 * lost


def test_a_disc_that_turns_drags_gas_round() -> None:
    world = evil.World(gravity=(0, 0))
    smoke = world.add_smoke((0, 0, 2, 2), cells=64)
    world.add(evil.Circle(0.3), at=(1, 1), kind="kinematic", angular_velocity=10)
    for _ in range(30):
        world.step(DT)
    assert smoke.velocity_at((1, 1.35)).x < -0.1
    assert smoke.velocity_at((1.35, 1)).y > 0.1


def test_a_pump_in_one_sealed_room_moves_nothing_in_the_next() -> None:
    world = evil.World(gravity=(0, 0))
    smoke = world.add_smoke((0, 0, 2, 1), cells=(64, 32), weight=1)
    world.add(evil.Rectangle(0.1, 2), at=(1, 0.5), kind="static")
    piston = world.add(evil.Rectangle(0.1, 2), at=(0.8, 0.5), kind="kinematic", velocity=(-0.5, 0))
    ball = world.add(evil.Circle(0.1), at=(1.5, 0.5), density=0.1)
    for _ in range(40):
        world.step(DT)
    velocity = np.asarray(smoke.velocity)
    assert piston.position.x < 0.5
    assert np.abs(velocity[:, :10]).max() > 0.1, "it pumps"
    assert np.abs(velocity[:, 40:]).max() < 1e-3
    assert ball.velocity.length < 1e-3


def test_a_body_of_another_kind_is_seen_at_once() -> None:
    """Gas pushed none that became dynamic where it stood, before something moved it."""
    world = evil.World(gravity=(0, 0))
    smoke = world.add_smoke((0, 0, 4, 2), cells=64, open_sides="left right", wind=(2, 0), wind_pull=5, weight=1)
    ball = world.add(evil.Circle(0.2), at=(1, 1), density=0.5, kind="static")
    for _ in range(30):
        world.step(DT)
    assert smoke.velocity_at((1, 1)).length < 0.3
    ball.kind = "dynamic"
    for _ in range(5):
        world.step(DT)
    assert ball.velocity.x > 0.1


SHAPES = {
    "concave": lambda: evil.Polygon([(-0.3, -0.3), (0.3, -0.3), (0.3, 0.3), (0, -0.1), (-0.3, 0.3)]),
    "capsule": lambda: evil.Capsule((-0.2, 0), (0.2, 0), 0.12),
    "segment": lambda: evil.Segment((-0.3, 0), (0.3, 0)),
    "chain": lambda: evil.Chain([(-0.3, 0.1), (0, -0.1), (0.3, 0.1)]),
    "thin": lambda: evil.Rectangle(0.6, 0.01),
}


@pytest.mark.parametrize("shape", SHAPES)
def test_gas_goes_round_every_shape(shape: str) -> None:
    world = evil.World(gravity=(0, 0))
    smoke = world.add_smoke((-1, -1, 1, 1), cells=48, open_sides="bottom top", wind=(0, 1), wind_pull=5)
    world.add(SHAPES[shape](), at=(0, 0), kind="static")
    for _ in range(60):
        world.step(DT)
    past, beside = smoke.velocity_at((0.15, 0.0)), smoke.velocity_at((0.8, 0.0))
    assert abs(past.y) < 0.5 * beside.y, "it is in the way"
    assert beside.y > 0.8


def test_two_bodies_on_one_joint_and_a_stack_ride_it_out() -> None:
    world, smoke = a_walled_box(weight=0.1)
    smoke.add_source(at=(1.6, 0.3), radius=0.2, temperature=2, rate=1)
    boxes = [world.add(evil.Rectangle(0.2, 0.2), at=(0.5, 0.1 + 0.2 * k), density=2) for k in range(4)]
    hook = world.add(evil.Circle(0.03), at=(1.5, 1.8), kind="static")
    lamp = world.add(evil.Circle(0.08), at=(1.5, 1.2), density=0.5)
    world.add_joint(evil.joints.Distance(hook, lamp))
    for _ in range(240):
        world.step(DT)
    assert all(box.position.y == pytest.approx(0.1 + 0.2 * k, abs=0.02) for k, box in enumerate(boxes))
    assert math.dist(lamp.position, hook.position) == pytest.approx(0.6, abs=0.02)
