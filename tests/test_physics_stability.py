"""What stands keeps standing, what slides slides as it should: slopes, stacks, houses of cards, an arch, chains."""

from __future__ import annotations

import itertools
import math

import pytest

import evilengine as evil

G = 9.81
STEP = 1 / 60


def run(world, seconds):
    for _ in range(round(seconds * 60)):
        world.step(STEP)


def on_slope(shape, slope, friction, lift):
    """A long slope downhill to the right, and `shape` on it, `lift` over its surface."""
    world = evil.World()
    world.add(evil.Rectangle(400, 1), at=(0, 0), angle=-slope, kind="static", friction=friction)
    body = world.add(shape, at=evil.Vec2(0, 0.5 + lift).turned(-slope), angle=-slope, friction=friction)
    return world, body


@pytest.mark.parametrize("friction", [0.2, 0.5, 0.8, 1.2])
@pytest.mark.parametrize("margin", [-0.03, -0.005])
def test_a_block_holds_on_a_slope_below_its_friction_angle(friction, margin):
    slope = math.atan(friction) + margin
    world, block = on_slope(evil.Rectangle(2, 0.5), slope, friction, 0.25)
    run(world, 1)
    settled = block.position
    run(world, 9)
    assert (block.position - settled).length < 2e-3
    assert block.velocity.length < 1e-3


@pytest.mark.parametrize("friction", [0.0, 0.2, 0.5, 0.8])
@pytest.mark.parametrize("margin", [0.02, 0.1, 0.3])
def test_a_block_slides_on_a_slope_as_gravity_less_friction_says(friction, margin):
    slope = math.atan(friction) + margin
    world, block = on_slope(evil.Rectangle(2, 0.5), slope, friction, 0.25)
    run(world, 0.5)
    before = block.velocity.length
    run(world, 1.5)
    pull = G * (math.sin(slope) - friction * math.cos(slope))
    assert (block.velocity.length - before) / 1.5 == pytest.approx(pull, rel=0.01, abs=2e-3)
    assert block.angle == pytest.approx(-slope, abs=2e-3)


def test_a_disc_rolls_down_a_slope_at_two_thirds_of_its_pull():
    world, disc = on_slope(evil.Circle(0.5), 0.3, 0.9, 0.5)
    run(world, 2)
    assert disc.velocity.length == pytest.approx(2 / 3 * G * math.sin(0.3) * 2, rel=0.01)
    assert disc.angular_velocity == pytest.approx(-disc.velocity.length / 0.5, rel=0.01)


def test_what_slides_on_the_level_stops_where_friction_says():
    world = evil.World()
    world.add(evil.Rectangle(400, 1), at=(0, -0.5), kind="static", friction=0.4)
    box = world.add(evil.Rectangle(1, 1), at=(0, 0.5), velocity=(8, 0), friction=0.4)
    run(world, 4)
    assert box.position.x == pytest.approx(8**2 / (2 * 0.4 * G), rel=0.02)


# What stands ----------------------------------------------------------------------------------------------------------


def ground(world, friction=0.6):
    return world.add(evil.Rectangle(60, 1), at=(0, -0.5), kind="static", friction=friction)


@pytest.mark.parametrize("ratio", [1, 10, 100])
def test_a_heavy_box_stands_on_a_light_one(ratio):
    world = evil.World()
    ground(world)
    light = world.add(evil.Rectangle(1, 1), at=(0, 0.5), mass=1)
    heavy = world.add(evil.Rectangle(1, 1), at=(0, 1.5), mass=ratio)
    run(world, 20)
    assert (light.position - (0, 0.5)).length < 0.03
    assert (heavy.position - (0, 1.5)).length < 0.05
    assert max(abs(light.angle), abs(heavy.angle)) < 0.01


@pytest.mark.parametrize(("height", "load"), [(3, 100), (10, 10)])
def test_a_stack_of_light_boxes_carries_a_heavy_one(height, load):
    world = evil.World()
    ground(world)
    masses = [1] * (height - 1) + [load]
    boxes = [world.add(evil.Rectangle(1, 1), at=(0, 0.5 + n), mass=mass) for n, mass in enumerate(masses)]
    run(world, 20)
    for n, box in enumerate(boxes):
        assert abs(box.position.x) < 0.05
        assert box.position.y == pytest.approx(0.5 + n, abs=0.15), "soft contacts give way a little"
        assert abs(box.angle) < 0.02
    assert all(above.position.y - below.position.y > 0.9 for below, above in itertools.pairwise(boxes))


LEAN = math.radians(20)


def card_house(world, storeys, lean=LEAN):
    """Tents of two cards each that lean on each other; flat cards lie across their tops and carry the next storey."""
    long, thick = 1.0, 0.04
    half = 0.5 * (long * math.sin(lean) + thick * math.cos(lean))  # of what a leaning card takes up across
    high = long * math.cos(lean) + thick * math.sin(lean)
    card = evil.Rectangle(thick, long)
    cards = []
    for storey in range(storeys):
        tents, y = storeys - storey, storey * (high + thick)
        for tent in range(tents):
            x = (tent - (tents - 1) / 2) * 4 * half
            for side in (-1, 1):
                at = (x + side * half, y + high / 2)
                cards.append(world.add(card, at=at, angle=side * lean, friction=0.8))
            if tent < tents - 1:
                at = (x + 2 * half, y + high + thick / 2)
                cards.append(world.add(evil.Rectangle(4 * half - 0.01, thick), at=at, friction=0.8))
    return cards


@pytest.mark.parametrize("storeys", [1, 3, 5])
def test_a_house_of_cards_stands(storeys):
    world = evil.World()
    ground(world, 0.8)
    cards = card_house(world, storeys)
    start = [card.position for card in cards]
    run(world, 20)
    assert max((card.position - at).length for card, at in zip(cards, start, strict=True)) < 0.1


def test_an_arch_stands_on_its_own():
    """Seventeen stones of a half circle, a fifth as thick as it is wide: thicker than a tenth stands (Heyman 1969)."""
    world = evil.World()
    ground(world, 0.8)
    inner, outer, count = 4.0, 5.0, 17
    stones, start = [], []
    for n in range(count):
        angles = (math.pi * n / count, math.pi * (n + 1) / count)
        corners = [(r * math.cos(a), r * math.sin(a)) for r, a in
                   ((inner, angles[0]), (outer, angles[0]), (outer, angles[1]), (inner, angles[1]))]  # fmt: skip
        stones.append(world.add(evil.Polygon(corners), friction=0.8))
        start.append(stones[-1].centre)
    run(world, 20)
    moved = [(stone.centre - at).length for stone, at in zip(stones, start, strict=True)]
    assert max(moved) < 0.1
    stones[count // 2].destroy()
    run(world, 5)
    assert min(stone.centre.y for stone in stones if stone.alive) < 1.0
    assert max(stone.centre.y for stone in stones if stone.alive) < 4.0, "and falls without its keystone"


# Joints ---------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("length", [0.5, 2.0])
@pytest.mark.parametrize("swing", [0.05, 0.6])
def test_a_pendulum_swings_with_the_period_of_its_length(length, swing):
    """T = 2 pi sqrt(I / m g L), and for wide swings 1 + a^2/16 + 11 a^4/3072 times that."""
    world = evil.World()
    pivot = world.add(evil.Circle(0.05), kind="static")
    at = evil.Vec2(0, -length).turned(swing)
    bob = world.add(evil.Circle(0.2), at=at, mass=3)
    world.add_joint(evil.joints.Hinge(pivot, bob, at=(0, 0)))
    inertia = bob.inertia + bob.mass * length**2
    period = 2 * math.pi * math.sqrt(inertia / (bob.mass * G * length)) * (1 + swing**2 / 16 + 11 * swing**4 / 3072)
    crossings, before, furthest = [], at.x, 0.0
    while len(crossings) < 21:
        world.step(STEP)
        now = bob.position.x
        if before * now < 0:
            crossings.append(world.time - STEP * now / (now - before))
        before, furthest = now, max(furthest, abs(bob.position.length - length))
    assert (crossings[-1] - crossings[0]) / 10 == pytest.approx(period, rel=5e-3)
    assert furthest < 0.01 * length


def test_two_masses_on_a_rod_spin_about_their_centre():
    world = evil.World(gravity=(0, 0))
    light = world.add(evil.Circle(0.2), at=(-2, 0), mass=1, velocity=(0, -8))
    heavy = world.add(evil.Circle(0.2), at=(1, 0), mass=2, velocity=(0, 4))
    world.add_joint(evil.joints.Distance(light, heavy))

    def angular_momentum():
        return sum(body.mass * body.centre.cross(body.velocity) for body in (light, heavy))

    before = angular_momentum()
    for _ in range(1200):
        world.step(STEP)
        assert (light.centre - heavy.centre).length == pytest.approx(3, rel=5e-3)
        assert ((light.centre + heavy.centre * 2) / 3).length < 1e-2
    assert angular_momentum() == pytest.approx(before, rel=1e-4)


@pytest.mark.parametrize("load", [1, 10, 50])
def test_a_long_chain_does_not_stretch(load):
    world = evil.World()
    above = world.add(evil.Circle(0.1), kind="static")
    link = evil.Rectangle(0.1, 0.5)
    last, links = above, 40
    for n in range(links):
        body = world.add(link, at=(0, -0.25 - 0.5 * n), mass=1)
        world.add_joint(evil.joints.Hinge(last, body, at=(0, -0.5 * n)))
        last = body
    weight = world.add(evil.Circle(0.4), at=(0, -0.5 * links), mass=load)
    world.add_joint(evil.joints.Hinge(last, weight, at=(0, -0.5 * links)))
    longest = 0.0
    for _ in range(900):
        world.step(STEP)
        longest = max(longest, -weight.position.y)
    assert longest < 1.05 * 0.5 * links
    assert weight.position.length > 0.9 * 0.5 * links
