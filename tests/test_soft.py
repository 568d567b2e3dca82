"""Soft things (SPEC P7): a rope hangs as a chain does, a blob and a jelly give, spring back and keep their shape."""

from __future__ import annotations

import itertools
import math

import pytest

import evilengine as evil


def run(world: evil.World, seconds: float) -> None:
    for _ in range(round(60 * seconds)):
        world.step(1 / 60)


def ground() -> evil.World:
    world = evil.World(gravity=(0, -10))
    world.add(evil.Rectangle(40, 1), at=(0, -0.5), kind="static")
    return world


def size(soft: evil.soft.Soft) -> tuple[float, float]:
    """Width and height over its bodies' middles."""
    xs, ys = zip(*(body.centre for body in soft.bodies), strict=True)
    return max(xs) - min(xs), max(ys) - min(ys)


def area(soft: evil.soft.Soft) -> float:
    """Inside the outline, by the shoelace formula."""
    points = [body.centre for body in soft.outline]
    return 0.5 * sum(a.x * b.y - a.y * b.x for a, b in zip(points, [*points[1:], points[0]], strict=True))


def test_a_rope_between_two_hooks_hangs_in_a_catenary() -> None:
    world = evil.World(gravity=(0, -10))
    length, pieces = 6.0, 24
    rope = evil.soft.rope(world, (0, 0), (length, 0), pieces=pieces, thickness=0.05, damping=0.2)
    left, right = (world.add(evil.Circle(0.05), at=(x, 0), kind="kinematic") for x in (0, length))
    world.add_joint(evil.joints.Hinge(left, rope.first, at=(0, 0)))
    world.add_joint(evil.joints.Hinge(right, rope.last, at=(length, 0)))
    right.velocity = (-1, 0)
    run(world, 2)
    right.velocity = (0, 0)
    run(world, 12)
    span = right.position.x
    assert span == pytest.approx(4, abs=0.01)
    # A chain of length s over a span d hangs as a cosh(x / a), where 2 a sinh(d / 2a) = s: found by halving.
    low, high = 0.1, 100.0
    for _ in range(100):
        a = 0.5 * (low + high)
        low, high = (a, high) if 2 * a * math.sinh(span / (2 * a)) > length else (low, a)
    sag = a * (math.cosh(span / (2 * a)) - 1)
    assert -min(body.centre.y for body in rope.bodies) == pytest.approx(sag, rel=0.03)


def test_a_rope_that_holds_a_weight_does_not_stretch_and_one_that_is_weak_breaks_once() -> None:
    for strength, holds in ((None, True), (8.0, False)):
        world = evil.World(gravity=(0, -10))
        hook = world.add(evil.Circle(0.1), at=(0, 0), kind="static")
        rope = evil.soft.rope(world, (0, 0), (0, -3), pieces=10, breaking_force=strength)
        load = world.add(evil.Circle(0.3), at=(0, -3.3), mass=1)
        world.add_joint(evil.joints.Hinge(hook, rope.first, at=(0, 0)))
        world.add_joint(evil.joints.Hinge(rope.last, load, at=(0, -3)))
        run(world, 4)
        if holds:
            assert load.position.y == pytest.approx(-3.3, abs=0.05)
            assert all(joint.alive for joint in rope.joints)
        else:
            assert load.position.y < -10
            assert not all(joint.alive for joint in rope.joints)


@pytest.mark.parametrize("frequency", [3.0, 6.0])
def test_a_blob_gives_where_it_lands_and_springs_back(frequency: float) -> None:
    world = ground()
    blob = evil.soft.blob(world, (0, 4), radius=1, frequency=frequency)
    whole, flattest = area(blob), 10.0
    for _ in range(360):
        world.step(1 / 60)
        flattest = min(flattest, size(blob)[1])
    width, height = size(blob)
    assert flattest < 0.9 * height < 0.95 * width, "it gave more as it landed than it does at rest"
    assert area(blob) == pytest.approx(whole, rel=0.35)
    world.gravity = (0, 0)
    run(world, 6)
    assert size(blob) == pytest.approx((size(blob)[0],) * 2, rel=0.1), "it is round again"


def test_a_stiffer_blob_is_flattened_less() -> None:
    heights = []
    for frequency in (2.0, 4.0, 8.0):
        world = ground()
        blob = evil.soft.blob(world, (0, 1), radius=1, frequency=frequency)
        run(world, 6)
        heights.append(size(blob)[1])
    assert heights == sorted(heights)
    assert heights[0] < 0.95 * heights[2]


def test_a_jelly_stands_bears_a_load_and_keeps_its_order() -> None:
    world = ground()
    jelly = evil.soft.jelly(world, (0, 1.1), width=3, height=2, columns=6, rows=4, frequency=8)
    run(world, 4)
    alone = size(jelly)
    load = world.add(evil.Rectangle(1, 0.5), at=(0, 3), density=2)
    run(world, 8)
    loaded = size(jelly)
    assert loaded[1] < alone[1]
    assert load.position.y > 1.2, "it is on top"
    rows = [[body.centre.y for body in jelly.bodies[6 * row : 6 * row + 6]] for row in range(4)]
    assert all(max(lower) < min(upper) + 0.3 for lower, upper in itertools.pairwise(rows))
    assert max(body.velocity.length for body in jelly.bodies) < 0.1
    load.destroy()
    run(world, 8)
    assert size(jelly)[1] == pytest.approx(alone[1], rel=0.03), "it springs back"


def test_a_soft_thing_knows_its_parts_and_goes_as_one() -> None:
    world = ground()
    blob = evil.soft.blob(world, (0, 2), pieces=12, density=0.5, tag="blob")
    assert len(blob.bodies) == 13
    assert all(body.tag == "blob" for body in blob.bodies)
    assert blob.centre.y == pytest.approx(2, abs=1e-5)
    before = blob.centre
    blob.bodies[3].destroy()
    assert blob.alive
    assert blob.centre != before
    blob.destroy()
    assert not blob.alive
    assert len(world.bodies) == 1
    assert len(world.joints) == 0


def test_soft_things_come_out_of_a_snapshot_to_the_bit() -> None:
    world = ground()
    evil.soft.blob(world, (0, 2))
    evil.soft.jelly(world, (4, 2), columns=4, rows=3)
    evil.soft.rope(world, (-5, 3), (-2, 3), breaking_force=5)
    run(world, 0.5)
    twin = evil.World.of(world.snapshot())
    run(world, 1)
    run(twin, 1)
    assert world.checksum() == twin.checksum()
