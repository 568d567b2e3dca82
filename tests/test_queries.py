"""Queries: the same answers as asking every body alone, whatever happened to the world before."""

from __future__ import annotations

import gc
import math
import random
import weakref
from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import evilengine as evil

SHAPES = (
    evil.Circle(0.4),
    evil.Rectangle(1.2, 0.5),
    evil.Triangle((-0.5, -0.4), (0.6, -0.3), (0, 0.7)),
    evil.Polygon([(-0.8, -0.8), (0.8, -0.8), (0.8, 0.8), (0, -0.2), (-0.8, 0.8)]),  # concave: two pieces or more
    evil.Capsule((-0.4, 0), (0.4, 0.2), 0.25),
    evil.Rectangle(0.9, 0.6, rounding=0.15),
    evil.Segment((-0.6, 0), (0.6, 0.1)),
)
SOLID = SHAPES[:-1]
KINDS = ("static", "kinematic", "dynamic")


def crowd(seed: int, count: int, size: float = 6.0) -> evil.World:
    """A world of many small bodies, some of them moved, changed, destroyed and added again after a first question."""
    chance = random.Random(seed)
    world = evil.World(gravity=(0, -3))

    def add() -> evil.Body:
        at = (chance.uniform(-size, size), chance.uniform(-size, size))
        return world.add(chance.choice(SHAPES), at=at, angle=chance.uniform(0, 7), kind=chance.choice(KINDS))

    bodies = [add() for _ in range(count)]
    world.ray_cast((-9, 0), (9, 0))
    for _ in range(count // 4):
        body = chance.choice(bodies)
        if chance.random() < 0.5:
            body.position = (chance.uniform(-size, size), chance.uniform(-size, size))
        elif chance.random() < 0.3:
            body.sensor = not body.sensor
        elif chance.random() < 0.5:
            body.kind = chance.choice(KINDS)
        elif len(bodies) > 2:
            bodies.remove(body)
            body.destroy()
            bodies.append(add())
        if chance.random() < 0.3:
            world.bodies_at((0, 0))
        if chance.random() < 0.1:
            world.step(1 / 60)
    return world


def alone(world: evil.World, ask: Callable[..., object]) -> list[tuple[evil.Body, object]]:
    """What `ask(ignore=...)` says of each body when all others are ignored, in creation order."""
    bodies = tuple(world.bodies)
    answers = []
    for body in bodies:
        answer = ask(ignore=[other for other in bodies if other != body])
        if answer:
            answers.append((body, answer))
    return answers


points = st.tuples(st.floats(-8, 8, width=32), st.floats(-8, 8, width=32))
seeds = st.integers(0, 10**6)


@settings(max_examples=40, deadline=None)
@given(seeds, points, points)
def test_a_ray_meets_the_first_of_what_it_meets_alone(seed: int, start: evil.Point, end: evil.Point) -> None:
    world = crowd(seed, 40)
    each = [hit for _, hit in alone(world, lambda ignore: world.ray_cast(start, end, ignore=ignore))]
    hit = world.ray_cast(start, end)
    assert hit == min(each, key=lambda one: one.fraction, default=None)  # min keeps the first: the order of creation
    if hit is not None:
        assert 0 <= hit.fraction <= 1
        assert hit.normal.length == pytest.approx(1, abs=1e-5)
        along = evil.Vec2(*end) - start
        assert hit.normal.dot(along) <= 1e-5 * (1 + along.length)
        assert hit.point == pytest.approx(evil.Vec2(*start) + along * hit.fraction, abs=1e-4)
    assert [one.body for one in world.ray_cast_all(start, end)] == [
        one.body for one in sorted(each, key=lambda one: one.fraction)
    ]


@settings(max_examples=40, deadline=None)
@given(seeds, points, st.sampled_from(SHAPES), st.floats(-4, 4))
def test_points_and_overlaps_find_whom_they_find_alone(
    seed: int, at: evil.Point, shape: evil.Circle, angle: float
) -> None:
    world = crowd(seed, 40)
    assert world.bodies_at(at) == tuple(
        body for body, _ in alone(world, lambda ignore: world.bodies_at(at, ignore=ignore))
    )
    assert world.overlapping(shape, at=at, angle=angle) == tuple(
        body for body, _ in alone(world, lambda ignore: world.overlapping(shape, at=at, angle=angle, ignore=ignore))
    )
    each = [near for _, near in alone(world, lambda ignore: world.nearest(at, ignore=ignore))]
    near = world.nearest(at)
    assert near == min(each, key=lambda one: one.distance)
    assert near is not None
    if near.distance == 0:
        assert near.body in world.bodies_at(at)
    else:
        assert (near.point - at).length == pytest.approx(near.distance, abs=1e-5)
        assert world.nearest(at, within=near.distance * 0.999) is None
        assert not world.bodies_at(at)


@settings(max_examples=60, deadline=None)
@given(seeds, points, points, st.sampled_from(SOLID), st.floats(-4, 4))
def test_a_shape_meets_the_first_of_what_it_meets_alone_and_just_touches_it(
    seed: int, start: evil.Point, end: evil.Point, shape: evil.Circle, angle: float
) -> None:
    world = crowd(seed, 30)
    way = evil.Vec2(*end) - start

    def cast(ignore: object = None) -> evil.RayHit | None:
        return world.shape_cast(shape, start, end, angle=angle, ignore=ignore)

    each = [hit for _, hit in alone(world, lambda ignore: cast(ignore))]
    hit = cast()
    assert hit == min(each, key=lambda one: one.fraction, default=None)
    everything = world.shape_cast_all(shape, start, end, angle=angle)
    assert [one.body for one in everything] == [one.body for one in sorted(each, key=lambda one: one.fraction)]
    at_first = set(world.overlapping(shape, at=start, angle=angle))
    free = 1.0 if hit is None else hit.fraction
    for part in (
        0.3,
        0.7,
        0.999,
    ):  # on the way there it overlaps nobody that it did not leave or slide along from the start
        there = world.overlapping(shape, at=evil.Vec2(*start) + way * (free * part), angle=angle)
        assert set(there) <= at_first
    if hit is not None and hit.fraction > 0:
        others = [body for body in world.bodies if body != hit.body]
        met = evil.Vec2(*start) + way * hit.fraction - hit.normal * 0.004
        if hit.shape.definition != SHAPES[-1]:  # a segment is hardly overlapped
            assert world.overlapping(shape, at=met, angle=angle, ignore=others) == (hit.body,)
        assert hit.normal.dot(way) < 0
        assert hit.normal.length == pytest.approx(1, abs=1e-4)
        assert world.nearest(hit.point, ignore=others).distance < 0.01


def test_a_shape_that_rests_on_the_ground_can_be_moved_along_it_but_not_into_it() -> None:
    world = evil.World()
    ground = world.add(evil.Rectangle(20, 1), at=(0, -0.5), kind="static")
    post = world.add(evil.Rectangle(1, 1), at=(5, 0.5), kind="static")
    box = evil.Rectangle(1, 1)
    assert world.shape_cast(box, (0, 0.5), (3, 0.5)) is None
    assert world.shape_cast(box, (0, 0.5), (0, 3)) is None
    assert world.shape_cast(box, (0, 0.4), (0, 3)) is None, "out of it"
    along = world.shape_cast(box, (0, 0.5), (8, 0.5))
    assert along.body is post
    assert along.fraction == pytest.approx(0.5, abs=1e-3)
    for start in ((0, 0.5), (0, 0.4)):
        into = world.shape_cast(box, start, (0, -3))
        assert (into.body, into.fraction, into.normal) == (ground, 0, (0, 1))
    tilted = world.shape_cast(box, (0, 3), (0, 0), angle=math.pi / 4)
    assert 3 * (1 - tilted.fraction) == pytest.approx(math.sqrt(0.5), abs=2e-3)


@pytest.mark.parametrize("kind", [np.float32, np.float64, "strided", list])
def test_a_batch_says_what_each_question_says_alone(kind: object) -> None:
    world = crowd(7, 60)
    chance = np.random.default_rng(3)
    starts, ends = chance.uniform(-8, 8, (50, 2)), chance.uniform(-8, 8, (50, 2))
    starts, ends = starts.astype(np.float32), ends.astype(np.float32)
    if kind is list:
        given_starts, given_ends = starts.tolist(), ends.tolist()
    elif kind == "strided":
        given_starts, given_ends = np.asfortranarray(starts), ends[::-1].copy()[::-1]
    else:
        given_starts, given_ends = starts.astype(kind), ends.astype(kind)

    hits = world.ray_casts(given_starts, given_ends)
    assert list(hits) == [world.ray_cast(a, b) for a, b in zip(starts.tolist(), ends.tolist(), strict=True)]
    assert {-1} < set(hits.bodies.tolist()), "some rays meet nothing, some do"
    for i, hit in enumerate(hits):
        if hit is None:
            assert (hits.bodies[i], hits.shapes[i], hits.fractions[i]) == (-1, -1, 1)
            assert np.array_equal(np.asarray(hits.points)[i], ends[i])
        else:
            assert (hits.bodies[i], hits.shapes[i]) == (hit.body.slot, hit.shape.slot)
            assert tuple(np.asarray(hits.normals)[i]) == hit.normal

    angles = [0.1 * i for i in range(50)]
    casts = world.shape_casts(SHAPES[1], given_starts, given_ends, angle=angles)
    ways = zip(starts.tolist(), ends.tolist(), angles, strict=True)
    assert list(casts) == [world.shape_cast(SHAPES[1], a, b, angle=angle) for a, b, angle in ways]
    assert list(world.nearest_each(given_starts)) == [world.nearest(at) for at in starts.tolist()]
    assert list(world.bodies_at_each(given_starts)) == [world.bodies_at(at) for at in starts.tolist()]
    found = world.overlapping_each(SHAPES[1], given_starts, angle=0.3)
    assert list(found) == [world.overlapping(SHAPES[1], at=at, angle=0.3) for at in starts.tolist()]
    assert found.starts[len(found)] == len(found.bodies) > 0


def test_the_answer_is_the_same_with_every_instruction_set() -> None:
    from evilengine import _core

    answers = set()
    for name in _core.instruction_sets():
        world = crowd(11, 200, size=20)
        world._core.instruction_set = name
        angles = np.linspace(0, 2 * math.pi, 300)
        ends = np.stack([30 * np.cos(angles), 30 * np.sin(angles)], axis=1)
        hits = world.ray_casts((0.1, 0.2), ends)
        answers.add((bytes(hits.points), bytes(hits.bodies), bytes(world.nearest_each(ends).points)))
    assert len(answers) == 1


def test_many_rays_are_the_same_on_any_number_of_threads() -> None:
    ends = [(30 * math.cos(0.002 * i), 30 * math.sin(0.002 * i)) for i in range(3000)]
    answers = set()
    for threads in (1, 2, 4):
        world = evil.World(threads=threads)
        world.restore(crowd(12, 200, size=20).snapshot())
        hits = world.ray_casts((0.1, 0.2), ends)
        answers.add((bytes(hits.points), bytes(hits.normals), bytes(hits.bodies)))
    assert len(answers) == 1


def test_two_at_the_same_place_are_told_by_who_came_first() -> None:
    world = evil.World()
    for _ in range(3):  # slots are used again, creation goes on
        world.add(evil.Circle(1))
    first = world.add(evil.Rectangle(1, 4), at=(5, 0))
    next(iter(world.bodies)).destroy()
    world.add(evil.Rectangle(1, 4), at=(5, 0))  # has a lower slot than `first`
    assert world.ray_cast((2, 0), (9, 0)).body is first
    assert world.nearest((5, 9)).body is first
    assert next(hit.body for hit in world.ray_cast_all((2, 0), (9, 0))) is first


def test_what_a_question_is_about() -> None:
    world = evil.World()
    wall = world.add(evil.Rectangle(1, 4), at=(3, 0), kind="static")
    box = world.add(evil.Rectangle(1, 1), at=(5, 0))
    lift = world.add(evil.Rectangle(1, 1), at=(7, 0), kind="kinematic")
    everything = {"start": (0, 0), "end": (9, 0)}
    assert world.ray_cast(**everything).body is wall
    assert world.ray_cast(**everything, kind="dynamic").body is box
    assert world.ray_cast(**everything, kind=("dynamic", "kinematic"), ignore=box).body is lift
    assert world.ray_cast(**everything, ignore=world.bodies) is None
    assert [hit.body for hit in world.ray_cast_all(**everything, kind=["static", "kinematic"])] == [wall, lift]
    assert world.bodies_at((5, 0), kind="static") == ()
    assert world.overlapping(evil.Rectangle(9, 1), at=(5, 0), ignore=[wall, lift]) == (box,)
    assert world.nearest((0, 0), kind="kinematic").body is lift
    assert world.ray_casts((0, 0), [(9, 0)], kind="dynamic")[0].body is box


@pytest.mark.parametrize(
    ("ask", "says"),
    [
        (
            lambda w: w.ray_cast((0, 0), (1, 0), kind="dynamc"),
            "kind='dynamc' must be one of .*; did you mean 'dynamic'",
        ),
        (lambda w: w.ray_cast((0, 0), (1, 0), kind=[]), "empty"),
        (lambda w: w.ray_cast((0, 0), (1, 0), kind=3), "kind=3"),
        (lambda w: w.nearest((0, 0), within=-1), "within=-1"),
        (lambda w: w.nearest((0, 1e9)), "within 1e\\+07 metres"),
        (lambda w: w.ray_cast((0, 0), (1, 0), ignore="me"), "ignore must be a Body"),
        (lambda w: w.ray_cast((0, 0), (1, 0), ignore=evil.World().add(evil.Circle(1))), "another world"),
        (lambda w: w.ray_casts([(0, 0)], [(1, 1), (2, 2)]), "starts and ends must be as many; got 1 and 2"),
        (lambda w: w.ray_casts(np.zeros((4, 3)), (0, 0)), "starts must have two columns, x and y"),
        (lambda w: w.ray_casts(np.zeros((4, 2), np.complex64), (0, 0)), "starts is a buffer of format 'Zf'"),
        (lambda w: w.ray_casts([(0, 0), (0, math.nan)], (0, 0)), r"starts\[1\]=.* must be .*finite"),
        (lambda w: w.ray_casts(np.array([[0, 0], [0, 2e7]]), (0, 0)), r"starts\[1\]=\(0, 20000000\) .* within 1e7"),
        (lambda w: w.ray_casts("ab", (0, 0)), "starts must be an array of points, or a list of them; got str"),
        (lambda w: w.bodies_at_each(np.full((3, 2), np.inf)), r"points\[0\]=\(inf, inf\) must be finite"),
        (
            lambda w: w.overlapping_each(evil.Circle(1), [(0, 0)] * 2, angle=[1, 2, 3]),
            "points and angles must be as many",
        ),
        (lambda w: w.shape_cast(3, (0, 0), (1, 1)), "shape must be a shape"),
        (lambda w: w.shape_cast(evil.Circle(1), (0, 0), (1, 1), angle=math.inf), "angle=inf"),
        (lambda w: w.shape_casts(evil.Circle(1), (0, 0), [(1, 1)] * 2, angle=[1] * 3), "ways and angles"),
        (lambda w: w.overlapping_each(evil.Circle(1), (0, 0), angle="x"), "angle='x' must be a number"),
    ],
)
def test_a_question_that_makes_no_sense_is_refused(ask: Callable[[evil.World], object], says: str) -> None:
    with pytest.raises(evil.Error, match=says):
        ask(evil.World())


def test_a_question_to_an_empty_world_finds_nothing() -> None:
    world = evil.World()
    assert world.ray_cast((0, 0), (1, 1)) is None
    assert world.nearest((0, 0)) is None
    assert len(world.ray_casts([], [])) == 0
    assert world.ray_casts((0, 0), np.zeros((2, 2)))[1] is None
    ball = world.add(evil.Circle(1))
    assert world.bodies_at((0, 0)) == (ball,)
    ball.destroy()
    assert world.bodies_at((0, 0)) == ()


def test_a_ray_inside_a_concave_shape_does_not_meet_its_seams() -> None:
    world = evil.World()
    cross = [(1, 1), (1, 3), (-1, 3), (-1, 1), (-3, 1), (-3, -1), (-1, -1), (-1, -3), (1, -3), (1, -1), (3, -1), (3, 1)]
    body = world.add(evil.Polygon(cross))
    assert world.ray_cast((-2.5, 0), (9, 0.1)) is None
    assert world.ray_cast((0, -2.5), (0.1, 9)) is None
    hits = world.ray_cast_all((-9, 2), (9, 2))
    assert [hit.body for hit in hits] == [body]
    assert hits[0].point.x == pytest.approx(-1)


def test_the_index_follows_what_a_callback_does() -> None:
    world = evil.World(gravity=(0, 0))
    ball = world.add(evil.Circle(0.5), at=(-2, 0), velocity=(5, 0))
    world.add(evil.Rectangle(1, 1), kind="static")
    seen = []

    @ball.on_collide
    def moved_away(contact: evil.Contact) -> None:
        at = ball.position
        seen.append(world.bodies_at(at) == (ball,))
        ball.position = (50, 50)
        seen.append(world.bodies_at(at) == ())
        seen.append(world.nearest((50, 60)).body is ball)

    for _ in range(60):
        world.step(1 / 60)
    assert seen == [True, True, True]


def test_a_restore_is_seen_at_once() -> None:
    world = crowd(5, 30)
    data = world.snapshot()
    before = bytes(world.ray_casts((0, 0), [(9, y) for y in range(-9, 9)]).points)
    for body in tuple(world.bodies)[::2]:
        body.destroy()
    assert bytes(world.ray_casts((0, 0), [(9, y) for y in range(-9, 9)]).points) != before
    world.restore(data)
    assert bytes(world.ray_casts((0, 0), [(9, y) for y in range(-9, 9)]).points) == before


def test_questions_change_nothing() -> None:
    asked, silent = crowd(9, 40), crowd(9, 40)
    for _ in range(20):
        asked.ray_cast((-9, 0), (9, 1))
        asked.nearest_each([(0, 0), (3, 3)])
        asked.overlapping(evil.Circle(2))
        asked.step()
        silent.step()
    assert asked.snapshot() == silent.snapshot()


def test_a_hit_of_a_destroyed_body_is_stale() -> None:
    world = evil.World()
    ball = world.add(evil.Circle(1), at=(3, 0), tag="ball")
    hit, hits, found = world.ray_cast((0, 0), (9, 0)), world.ray_casts((0, 0), [(9, 0)]), world.bodies_at_each([(3, 0)])
    ball.destroy()
    world.add(evil.Circle(1), at=(3, 0))  # takes the same slot
    for body in (hit.body, hits[0].body, found[0][0]):
        assert not body.alive
        with pytest.raises(evil.StaleReferenceError):
            body.position  # noqa: B018
    assert hit.point == (2, 0), "what it knew itself stays"
    with pytest.raises(IndexError):
        hits[1]
    assert hits[-1].fraction == hit.fraction


def test_a_hit_keeps_no_world_alive_in_a_cycle() -> None:
    world = evil.World()
    ball = world.add(evil.Circle(1), at=(3, 0))
    ball.hit = world.ray_cast((0, 0), (9, 0))
    ball.hits = world.ray_casts((0, 0), [(9, 0)])
    watch = weakref.ref(world)
    del world, ball
    gc.collect()
    assert watch() is None


def test_columns_outlive_their_table() -> None:
    world = evil.World()
    world.add(evil.Circle(1), at=(3, 0))
    points = np.asarray(world.ray_casts((0, 0), [(9, 0)] * 1000).points)
    gc.collect()
    assert (points == (2, 0)).all()
    assert not points.flags.writeable


def test_the_index_lives_through_the_packing_of_corners() -> None:
    world = evil.World()
    boxes = [world.add(evil.Rectangle(1, 1), at=(2 * x, 0), kind="static") for x in range(400)]
    assert world.ray_cast((798, 9), (798, -9)).body is boxes[-1]
    for box in boxes[:-1]:  # most corners are dead now: the pool is packed, and the last box's lie elsewhere
        box.destroy()
    hit = world.ray_cast((798, 9), (798, -9))
    assert (hit.body, hit.point) == (boxes[-1], (798, 0.5))


def test_a_slot_that_was_free_when_the_index_was_put_in_order_has_no_place_in_it() -> None:
    world = evil.World(gravity=(0, 0))
    balls = [world.add(evil.Circle(0.4), at=(n, 0)) for n in range(200)]
    assert world.bodies_at((7, 0)) == (balls[7],)
    for ball in balls[100:] + balls[:100:2]:
        ball.destroy()
    balls = balls[1:100:2]
    for n, ball in enumerate(balls):  # neighbours no longer: the order is worn out
        ball.position = (37 * n % 100, n % 7 * 40)
    assert world.bodies_at(balls[7].position) == (balls[7],)
    balls += [world.add(evil.Circle(0.4), at=(n, -9)) for n in range(3)]  # in slots that once had a place
    assert all(world.bodies_at(ball.position) == (ball,) for ball in balls)


def test_what_a_body_is_to_others_is_known_to_the_next_question() -> None:
    world = evil.World()
    wall = world.add(evil.Rectangle(1, 4), at=(5, 0), kind="static", category=1)
    assert world.ray_cast((0, 0), (10, 0), mask=1)
    wall.category = 2
    assert world.ray_cast((0, 0), (10, 0), mask=1) is None
    wall.shapes[0].category = 4
    assert world.ray_cast((0, 0), (10, 0), mask=4)
    wall.sensor = True
    assert world.ray_cast((0, 0), (10, 0)) is None
    assert world.ray_cast((0, 0), (10, 0), sensors=True)


@pytest.mark.parametrize("at", [(3e38, 0), (0, -3e38), (3.4e38, -3.4e38), (1e30, 1e30), (2e7, 0)])
def test_nobody_is_beyond_the_world_and_no_shape_can_be_put_there(at: tuple[float, float]) -> None:
    world = crowd(4, 30)
    assert world.bodies_at(at) == ()
    assert world.bodies_at_each([at])[0] == ()
    with pytest.raises(evil.ArgumentError, match=r"within 1e(\+0)?7 metres of the origin"):
        world.overlapping(evil.Rectangle(1e5, 1e5), at=at)
    with pytest.raises(evil.ArgumentError, match=r"within 1e(\+0)?7 metres of the origin"):
        world.overlapping_each(evil.Circle(1), at=[(0, 0), at])
