"""The collider's fast ways against plain ones: every pair is found, and eight manifolds at once are as one by one."""

from __future__ import annotations

import math
import random

import pytest

import evilengine as evil
from evilengine import _core
from evilengine.bench.scene import find, stage

STEP = 1 / 60
Bounds = tuple[int, float, float, float, float, int]


def crowd(seed: int, *, sizes: tuple[float, float], bodies: int = 250) -> evil.World:
    """Circles, boxes and polygons of 3 to 8 corners, alone or two on a body, thrown together without gravity."""
    rng = random.Random(seed)
    world = evil.World(gravity=(0, 0))
    side = math.sqrt(bodies) * 1.2
    for i in range(bodies):
        size = math.exp(rng.uniform(math.log(sizes[0]), math.log(sizes[1])))
        corners = rng.randint(3, 8)
        turn = rng.uniform(0, 2 * math.pi)
        ring = [
            (size * math.cos(turn + 2 * math.pi * k / corners), size * math.sin(turn + 2 * math.pi * k / corners))
            for k in range(corners)
        ]
        shape = rng.choice([evil.Circle(size), evil.Rectangle(size, rng.uniform(0.2, 2) * size), evil.Polygon(ring)])
        body = world.add(
            shape,
            at=(rng.uniform(0, side), rng.uniform(0, side)),
            angle=rng.uniform(-7, 7),
            kind="static" if i % 7 == 0 else "kinematic" if i % 11 == 0 else "dynamic",
        )
        if i % 5 == 0:
            body.add_shape(evil.Rectangle(size, size), offset=(size, 0.3 * size), angle=rng.uniform(-1, 1))
        if body.kind != "static":
            body.velocity = (rng.uniform(-9, 9), rng.uniform(-9, 9))
            body.angular_velocity = rng.uniform(-5, 5)
    return world


def meet(a: Bounds, b: Bounds) -> bool:
    return a[1] <= b[3] and b[1] <= a[3] and a[2] <= b[4] and b[2] <= a[4]


def plain_pairs(world: evil.World, bounds: list[Bounds]) -> set[tuple[int, int]]:
    """Each with each: those of two bodies, one of them dynamic, whose bounds meet."""
    dynamic = {body.slot for body in world.bodies if body.kind == "dynamic"}
    return {
        (i, j)
        for j, b in enumerate(bounds)
        for i, a in enumerate(bounds[:j])
        if a[0] != b[0] and (a[0] in dynamic or b[0] in dynamic) and meet(a, b)
    }


@pytest.mark.parametrize("sizes", [(0.5, 0.5), (0.2, 1.5), (0.02, 20.0)])
@pytest.mark.parametrize("instructions", _core.instruction_sets())
def test_every_pair_of_bounds_that_meet_is_found(sizes: tuple[float, float], instructions: str) -> None:
    world = crowd(1, sizes=sizes)
    world._core.instruction_set = instructions
    bounds = _core.bounds_of_pieces(world._core, STEP)
    found = _core.pairs_of_pieces(world._core, STEP)
    assert found == sorted(set(found))
    missing = plain_pairs(world, bounds) - set(found)
    assert set(found) <= plain_pairs(world, bounds)
    for a, b in missing:  # only what a much larger piece's own sides keep away
        assert abs(bounds[a][5] - bounds[b][5]) >= 2
    if sizes[0] == sizes[1]:
        assert not missing


def test_a_long_wall_aslant_has_no_contacts_with_what_lies_far_beside_it() -> None:
    world = evil.World(gravity=(0, 0))
    world.add(evil.Rectangle(40, 1), at=(0, 0), angle=math.pi / 4, kind="static")
    for x in range(-12, 13, 4):
        for y in range(-12, 13, 4):
            world.add(evil.Rectangle(0.5, 0.5), at=(x, y))
    near = {(0, i + 1) for i, body in enumerate(list(world.bodies)[1:]) if abs(body.position.x - body.position.y) < 1.5}
    assert set(_core.pairs_of_pieces(world._core, STEP)) == near


def test_pieces_of_one_body_and_bodies_that_nothing_moves_are_no_pairs() -> None:
    world = evil.World()
    for kind in ("static", "kinematic", "static"):
        world.add(evil.Rectangle(2, 2), kind=kind)
    two = world.add(evil.Circle(1), at=(50, 0))
    two.add_shape(evil.Circle(1), offset=(0.5, 0))
    assert _core.pairs_of_pieces(world._core, STEP) == []


def test_pairs_are_found_a_long_way_from_the_middle_of_the_world() -> None:
    world = evil.World(gravity=(0, 0))
    for x in (-6e6, 0.0, 6e6):
        world.add(evil.Rectangle(4, 4), at=(x, 6e6))
        world.add(evil.Circle(2), at=(x + 3, 6e6))
    assert _core.pairs_of_pieces(world._core, STEP) == [(0, 1), (2, 3), (4, 5)]


def test_a_thousand_bodies_in_one_point_are_half_a_million_pairs() -> None:
    world = evil.World()
    for _ in range(1000):
        world.add(evil.Circle(0.5))
    assert len(_core.pairs_of_pieces(world._core, STEP)) == 1000 * 999 // 2


@pytest.mark.parametrize("haste", [0.05, 1.0])
@pytest.mark.parametrize("sizes", [(0.3, 0.6), (0.05, 20.0)])
@pytest.mark.parametrize("instructions", _core.instruction_sets())
def test_pairs_that_are_kept_over_steps_are_those_that_are_found_anew(
    instructions: str, sizes: tuple[float, float], haste: float
) -> None:
    world = crowd(2, sizes=sizes, bodies=120)
    world._core.instruction_set = instructions
    world.add(evil.Rectangle(30, 0.5), at=(5, 5), angle=0.7, kind="static")
    for body in world.bodies:
        if body.kind != "static":
            body.velocity, body.angular_velocity = haste * body.velocity, haste * body.angular_velocity
    movers = [body for body in world.bodies if body.kind == "dynamic"]
    for step in range(90):
        if step % 30 == 10:  # what changes by hand is seen at once, too
            movers.pop().destroy()
            movers[step].position = (3.0, 3.0)
            movers[step + 1].kind = "static"
            world.add(evil.Circle(0.4), at=(4, 4))
        anew = _core.pairs_of_pieces(world._core, STEP)
        world.step(STEP)
        assert [(row[0], row[1]) for row in _core.manifolds_of_pairs(world._core, STEP, True)] == anew


@pytest.mark.parametrize("scene", ["pyramid", "tumbler", "pile", "crowd"])
def test_manifolds_of_eight_pairs_at_once_are_those_of_one_pair_at_a_time(scene: str) -> None:
    step, world = stage_of(scene)
    compared = 0
    for _ in range(12):
        for _ in range(10):
            step()
        for wide, plain in zip(
            _core.manifolds_of_pairs(world._core, STEP, True),
            _core.manifolds_of_pairs(world._core, STEP, False),
            strict=True,
        ):
            assert wide[:3] == plain[:3]
            assert len(wide[5]) == len(plain[5])
            if wide[5]:
                assert wide[3:5] == pytest.approx(plain[3:5], abs=2e-5)
            for p, q in zip(wide[5], plain[5], strict=True):
                assert p[3] == q[3]
                assert p[:3] == pytest.approx(q[:3], abs=5e-5)
            compared += bool(wide[5])
    assert compared > 300


def stage_of(scene: str):  # type: ignore[no-untyped-def]
    if scene == "crowd":
        world = crowd(3, sizes=(0.3, 1.2), bodies=400)
        world.gravity = (0, -3)
        return lambda: world.step(STEP), world
    staged = stage(find(scene), find(scene).small)
    return staged.step, staged.world


@pytest.mark.parametrize("change", ["friction", "restitution"])
def test_a_material_that_changes_counts_from_the_next_step_on(change: str) -> None:
    world = evil.World()
    slope = world.add(evil.Rectangle(40, 1), angle=-0.3, kind="static")
    box = world.add(evil.Rectangle(1, 1), at=(0, 1.05), angle=-0.3, friction=0.8)
    slope.friction = 0.8
    for _ in range(60):
        world.step()
    assert box.velocity.length < 0.01
    setattr(box.shapes[0], change, 0.0 if change == "friction" else 1.0)
    box.velocity = (0, 0) if change == "friction" else (0, -3)
    for _ in range(3):
        world.step()
    assert (box.velocity.x > 0.1) if change == "friction" else (box.velocity.y > 1.0)
