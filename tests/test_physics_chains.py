"""Chains: joints in a row are solved as one, so neither length nor load nor swinging stretches them."""

from __future__ import annotations

import math

import pytest

import evilengine as evil

STEP = 1 / 60
LINK = 0.5


def chain(world, links, *, along=(1.0, 0.0), load=0.0, held=True):
    """Links in a row from the origin along a direction, with a ball at the end; the joints from first to last."""
    x, y = along
    angle = math.atan2(y, x)
    last = world.add(evil.Circle(0.1), kind="static") if held else None
    joints = []
    for n in range(links):
        at = evil.Vec2(x, y) * (LINK * n)
        link = world.add(evil.Rectangle(LINK, 0.1), at=at + evil.Vec2(x, y) * (0.5 * LINK), angle=angle, mass=1)
        if last is not None:
            joints.append(world.add_joint(evil.joints.Hinge(last, link, at=at)))
        last = link
    if load:
        end = evil.Vec2(x, y) * (LINK * links)
        ball = world.add(evil.Circle(0.4), at=end, mass=load)
        joints.append(world.add_joint(evil.joints.Hinge(last, ball, at=end)))
    return joints


def gaps(joints):
    return sum((joint.at_a - joint.at_b).length for joint in joints)


def energy(world):
    return sum(
        0.5 * body.mass * body.velocity.length**2
        + 0.5 * body.inertia * body.angular_velocity**2
        + 9.81 * body.mass * body.position.y
        for body in world.bodies
        if body.kind == "dynamic"
    )


@pytest.mark.parametrize(("links", "load"), [(50, 0), (50, 50), (200, 0)])
def test_a_chain_that_is_let_go_level_swings_without_stretching(links, load):
    world = evil.World()
    joints = chain(world, links, load=load)
    widest = 0.0
    for _ in range(900):
        world.step(STEP)
        widest = max(widest, gaps(joints))
    assert widest < 0.04 * LINK * links


@pytest.mark.parametrize(("links", "load", "share"), [(40, 100, 0.005), (40, 1000, 0.05), (200, 0, 0.005)])
def test_a_chain_with_a_heavy_ball_hangs_still(links, load, share):
    world = evil.World()
    joints = chain(world, links, along=(0.0, -1.0), load=load)
    for _ in range(600):
        world.step(STEP)
    assert gaps(joints) < share * LINK * links
    assert max(body.velocity.length for body in world.bodies) < 0.2


def test_a_chain_swings_without_gaining_energy():
    world = evil.World()
    chain(world, 20)
    start = energy(world)
    most = -math.inf
    for _ in range(600):
        world.step(STEP)
        most = max(most, energy(world))
    fallen = 9.81 * 20 * 0.5 * LINK * 20  # from level to hanging down
    assert most - start < 0.005 * fallen


def test_a_chain_between_two_walls_is_taut():
    world = evil.World()
    joints = chain(world, 20)
    wall = world.add(evil.Circle(0.1), at=(LINK * 20, 0), kind="static")
    joints.append(world.add_joint(evil.joints.Hinge(joints[-1].b, wall, at=(LINK * 20, 0))))
    for _ in range(300):
        world.step(STEP)
    assert gaps(joints) < 5e-3 * LINK * 20  # there is no slack: it can only sag by opening its joints
    assert min(body.position.y for body in world.bodies) > -0.5


def test_a_chain_that_flies_free_keeps_its_momentum_and_spin():
    world = evil.World(gravity=(0, 0))
    joints = chain(world, 12, held=False)
    first, *others = list(world.bodies)
    for last, link in zip([first, *others], others, strict=False):
        joints.append(world.add_joint(evil.joints.Hinge(last, link, at=0.5 * (last.position + link.position))))
    for n, body in enumerate(world.bodies):
        body.velocity = (math.sin(n), math.cos(2 * n))

    def spin():
        return sum(
            body.mass * (body.position.x * body.velocity.y - body.position.y * body.velocity.x)
            + body.inertia * body.angular_velocity
            for body in world.bodies
        )

    def momentum():
        return sum((body.mass * body.velocity for body in world.bodies), evil.Vec2(0, 0))

    world.step(STEP)
    spun, moved = spin(), momentum()
    for _ in range(300):
        world.step(STEP)
    assert (momentum() - moved).length < 1e-4
    assert spin() == pytest.approx(spun, rel=2e-3)
    assert gaps(joints) < 0.01 * LINK * 12


def test_a_chain_that_was_saved_in_its_swing_goes_on_to_the_bit():
    world = evil.World()
    chain(world, 20, load=5)
    for _ in range(50):
        world.step(STEP)
    saved = world.snapshot()
    for _ in range(50):
        world.step(STEP)
    once = world.checksum()
    world.restore(saved)
    for _ in range(50):
        world.step(STEP)
    assert world.checksum() == once


def bridge(world, planks, *, friction=0.0):
    """Planks of a metre in a row between two walls, as long as the way between them; their joints."""
    wall = world.add(evil.Rectangle(0.2, 0.2), kind="static")
    before, joints = wall, []
    driven = {"motor_speed": 0, "max_torque": friction} if friction else {}
    for n in range(planks + 1):
        plank = wall if n == planks else world.add(evil.Rectangle(1, 0.25), at=(n + 0.5, -0.125))
        joints.append(world.add_joint(evil.joints.Hinge(before, plank, at=(n, -0.125), **driven)))
        before = plank
    return joints


@pytest.mark.parametrize("friction", [0, 200])
@pytest.mark.parametrize(("planks", "boxes", "density"), [(20, 5, 1), (30, 10, 1), (30, 10, 10), (40, 8, 20)])
def test_a_bridge_bears_boxes_and_does_not_throw_them(planks, boxes, density, friction):
    world = evil.World()
    joints = bridge(world, planks, friction=friction)
    box = evil.Rectangle(1, 1)
    middle = 0.5 * planks - 0.75 * (boxes - 1)
    load = [world.add(box, at=(middle + 1.5 * n, 1 + n % 3), density=density) for n in range(boxes)]
    for step in range(900):
        world.step(STEP)
        if step > 300:
            assert max(body.velocity.y for body in load) < 6.0
    assert min(body.position.y for body in load) > -0.25 * planks
    assert gaps(joints) < 0.04 * planks


def test_a_motor_in_a_chain_turns_it_and_limits_hold():
    world = evil.World(gravity=(0, 0))
    last = world.add(evil.Circle(0.1), kind="static")
    joints = []
    for n in range(6):
        link = world.add(evil.Rectangle(LINK, 0.1), at=(LINK * (n + 0.5), 0))
        drive = {"motor_speed": 1, "max_torque": 50} if n == 0 else {"limits": (-0.1, 0.1)}
        joints.append(world.add_joint(evil.joints.Hinge(last, link, at=(LINK * n, 0), **drive)))
        last = link
    for _ in range(240):
        world.step(STEP)
        assert all(abs(joint.angle) < 0.2 for joint in joints[1:])  # they give way a little
    assert joints[0].angle == pytest.approx(4.0, abs=0.1)
    assert gaps(joints) < 0.01 * LINK * 6


def test_a_joint_in_a_chain_tells_the_load_that_it_bears():
    world = evil.World()
    joints = chain(world, 10, along=(0.0, -1.0), load=5)
    for _ in range(300):
        world.step(STEP)
    for n, joint in enumerate(joints):
        assert joint.force.length == pytest.approx(9.81 * (10 - n + 5), rel=0.01)


def test_a_net_of_hinges_that_hangs_from_a_few_does_not_whip_itself_up():
    world = evil.World(gravity=(0, -10), sleep=False)
    size, ball, bodies = 100, evil.Circle(0.4), []
    for column in range(size):
        for row in range(size):
            held = row == 0 and abs(column - size // 2) <= 3
            body = world.add(ball, at=(column, -row), kind="static" if held else "dynamic", mask=0)
            if row > 0:
                world.add_joint(evil.joints.Hinge(bodies[-1], body, at=(column, 0.5 - row)))
            if column > 0:
                world.add_joint(evil.joints.Hinge(bodies[-size], body, at=(column - 0.5, -row)))
            bodies.append(body)
    for _ in range(100):
        world.step(STEP)
    assert max(body.velocity.length for body in bodies) < 10.0
    assert max((joint.at_a - joint.at_b).length for joint in world.joints) < 1.0
