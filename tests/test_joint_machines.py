"""What is built of joints: gears, pulleys, welds that bend, a bridge, a ragdoll. Each against its mechanics."""

from __future__ import annotations

import itertools
import math

import pytest

import evilengine as evil

G = 10.0


def run(world: evil.World, seconds: float) -> None:
    for _ in range(round(60 * seconds)):
        world.step(1 / 60)


def wheels_on(world: evil.World, radii: tuple[float, ...]) -> tuple[list[evil.Body], list[evil.joints.Hinge]]:
    frame = world.add(evil.Rectangle(1, 1), at=(0, -5), kind="static")
    x, wheels, hinges = 0.0, [], []
    for before, radius in itertools.pairwise((0.0, *radii)):
        x += before + radius
        wheels.append(world.add(evil.Circle(radius), at=(x, 0), group=-1))
        hinges.append(world.add_joint(evil.joints.Hinge(frame, wheels[-1], at=(x, 0))))
    return wheels, hinges


def test_gears_keep_their_ratios_for_a_minute_to_a_hundredth_of_a_radian() -> None:
    world = evil.World(gravity=(0, 0), sleep=False)
    wheels, hinges = wheels_on(world, (1.0, 0.5, 1.5))
    for a, b in itertools.pairwise(wheels):
        radius_a, radius_b = (body.shapes[0].definition.radius for body in (a, b))  # type: ignore[union-attr]
        world.add_joint(evil.joints.Gear(a, b, ratio=-radius_a / radius_b))
    hinges[0].motor_speed, hinges[0].max_torque = 3.0, 50.0
    wheels[2].angular_damping = 0.5  # a load
    run(world, 60)
    turned = wheels[0].angle
    assert turned == pytest.approx(180, rel=0.02)
    assert wheels[1].angle == pytest.approx(-2 * turned, abs=0.01)
    assert wheels[2].angle == pytest.approx(turned / 1.5, abs=0.01)


def test_a_gear_passes_torque_on_as_its_ratio_says() -> None:
    world = evil.World(gravity=(0, 0), sleep=False)
    (large, small), _ = wheels_on(world, (1.0, 0.5))
    world.add_joint(evil.joints.Gear(large, small, ratio=-2))
    for _ in range(60):
        large.apply_torque(2)
        world.step(1 / 60)
    # The small wheel turns twice as fast: seen from the large one its inertia counts four times.
    assert large.angular_velocity == pytest.approx(2 / (large.inertia + 4 * small.inertia), rel=1e-3)
    assert small.angular_velocity == pytest.approx(-2 * large.angular_velocity, rel=1e-3)


@pytest.mark.parametrize("ratio", [1.0, 2.0, 3.0])
def test_weights_on_a_pulley_fall_as_atwood_found(ratio: float) -> None:
    world = evil.World(gravity=(0, -G), sleep=False)
    a = world.add(evil.Circle(0.2), at=(-2, 0), mass=1)
    b = world.add(evil.Circle(0.2), at=(2, 0), mass=5)
    pulley = world.add_joint(evil.joints.Pulley(a, b, (-2, 8), (2, 8), ratio=ratio))
    length = pulley.total_length
    run(world, 0.5)
    # a rises `ratio` times as fast as b sinks: (m_a r + m_b / r) a_a = (m_b / r - m_a) g r, as a_b = a_a / r
    rise = G * (5 / ratio - 1) / (1 + 5 / ratio**2)
    assert a.velocity.y == pytest.approx(0.5 * rise, rel=0.01)
    assert b.velocity.y == pytest.approx(-0.5 * rise / ratio, rel=0.01)
    assert (8 - a.position.y) + ratio * (8 - b.position.y) == pytest.approx(length, abs=0.002)


def test_a_pulley_in_balance_hangs_still() -> None:
    world = evil.World(gravity=(0, -G), sleep=False)
    a = world.add(evil.Circle(0.2), at=(-2, 0), mass=3)
    b = world.add(evil.Circle(0.2), at=(2, 0), mass=6)
    world.add_joint(evil.joints.Pulley(a, b, (-2, 8), (2, 8), ratio=2))
    run(world, 10)
    assert abs(a.position.y) < 0.01
    assert abs(a.velocity.y) < 0.005


@pytest.mark.parametrize("stiffness", [20.0, 100.0, 500.0])
def test_a_weld_bends_as_far_as_its_stiffness_says(stiffness: float) -> None:
    world = evil.World(gravity=(0, -G), sleep=False)
    wall = world.add(evil.Rectangle(1, 1), kind="static")
    shelf = world.add(evil.Rectangle(2, 0.1), at=(1.5, 0), density=1)
    weld = world.add_joint(evil.joints.Weld(wall, shelf, at=(0.5, 0), stiffness=stiffness, damping=stiffness / 5))
    run(world, 20)
    # Balance: stiffness x angle = weight x arm x cos(angle). By hand from the right side, as the angle is small.
    angle = 0.0
    for _ in range(60):
        angle = -shelf.mass * G * 1.0 * math.cos(angle) / stiffness
    assert weld.angle == pytest.approx(angle, rel=0.01)
    assert abs(shelf.angular_velocity) < 1e-3


def test_a_beam_of_welds_bends_more_towards_its_root_and_springs_back() -> None:
    world = evil.World(gravity=(0, -G), sleep=False)
    wall = world.add(evil.Rectangle(1, 1), kind="static")
    parts = [world.add(evil.Rectangle(0.5, 0.1), at=(0.75 + 0.5 * i, 0), group=-1) for i in range(6)]
    welds = [
        world.add_joint(evil.joints.Weld(a, b, at=(0.5 + 0.5 * i, 0), stiffness=80, damping=8))
        for i, (a, b) in enumerate(itertools.pairwise((wall, *parts)))
    ]
    run(world, 15)
    bends = [-weld.angle for weld in welds]
    assert all(a > b > 0 for a, b in itertools.pairwise(bends))
    world.gravity = (0, 0)
    run(world, 15)
    assert max(abs(weld.angle) for weld in welds) < 0.002


def test_a_bridge_with_a_load_hangs_still_and_in_one_piece() -> None:
    world = evil.World(gravity=(0, -G))
    planks = [world.add(evil.Rectangle(0.5, 0.15), at=(-4.75 + 0.5 * i, 0), density=2) for i in range(20)]
    banks = [world.add(evil.Rectangle(2, 1), at=(x, -0.4), kind="static") for x in (-6.2, 6.2)]
    ends = zip([banks[0], *planks], [*planks, banks[1]], strict=True)
    hinges = [world.add_joint(evil.joints.Hinge(a, b, at=(-5 + 0.5 * i, 0))) for i, (a, b) in enumerate(ends)]
    boxes = [world.add(evil.Rectangle(0.8, 0.8), at=(x, 1), density=3) for x in (-1.5, 0, 1.5)]
    run(world, 32)  # it swings for a while, as nothing but friction under the boxes damps it
    assert not any(body.awake for body in (*planks, *boxes))
    assert all(-3 < box.position.y < 1 for box in boxes), "the loads lie on it"
    assert max((hinge.at_a - hinge.at_b).length for hinge in hinges) < 0.02, "nothing gapes"


def ragdoll(world: evil.World, x: float, y: float) -> list[evil.Body]:
    """A trunk, a head, and arms and legs of two parts each, that bend as far as joints of people do."""

    def part(ax: float, ay: float, bx: float, by: float, radius: float) -> evil.Body:
        return world.add(evil.Capsule((ax, ay), (bx, by), radius), at=(x, y), density=1, friction=0.6)

    trunk, head = part(0, -0.3, 0, 0.3, 0.18), part(0, 0.6, 0, 0.62, 0.15)
    parts = [trunk, head]
    world.add_joint(evil.joints.Hinge(trunk, head, at=(x, y + 0.45), limits=(-0.6, 0.6)))
    for side in (-1, 1):
        for top, reach, limits in ((0.3, 0.3, (-1.5, 1.5)), (-0.45, 0.4, (-1.2, 1.2))):
            upper = part(0.1 * side, top, 0.1 * side, top - reach, 0.08)
            lower = part(0.1 * side, top - reach - 0.05, 0.1 * side, top - 2 * reach, 0.07)
            world.add_joint(evil.joints.Hinge(trunk, upper, at=(x + 0.1 * side, y + top), limits=limits))
            world.add_joint(evil.joints.Hinge(upper, lower, at=(x + 0.1 * side, y + top - reach), limits=(-1.8, 0.05)))
            parts += [upper, lower]
    return parts


def test_ragdolls_come_to_rest_and_fall_asleep() -> None:
    world = evil.World(gravity=(0, -G))
    world.add(evil.Rectangle(40, 1), at=(0, -0.5), kind="static")
    parts = [part for i in range(3) for part in ragdoll(world, 2.5 * i - 2.5, 2 + i)]
    for head in parts[1::10]:
        head.velocity = (3, 0)  # or one of them lands on its feet, and stands
    run(world, 15)
    assert not any(part.awake for part in parts)
    assert max((joint.at_a - joint.at_b).length for joint in world.joints) < 0.02
    assert all(0 < part.centre.y < 1 for part in parts)
