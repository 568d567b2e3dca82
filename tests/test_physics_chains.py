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
    assert widest < 0.02 * LINK * links


def test_a_chain_with_a_ball_a_thousand_times_as_heavy_hangs_still():
    world = evil.World()
    joints = chain(world, 40, along=(0.0, -1.0), load=1000)
    for _ in range(300):
        world.step(STEP)
    assert gaps(joints) < 1e-3 * LINK * 40
    assert max(body.velocity.length for body in world.bodies) < 1e-3


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
    assert gaps(joints) < 1e-3 * LINK * 20  # there is no slack: it could only sag by opening its joints
    assert min(body.position.y for body in world.bodies) > -0.03


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
