"""Many bodies at once: added, written and pushed from arrays."""

from __future__ import annotations

import array
import math

import numpy as np
import pytest

import evilengine as evil
from evilengine.values.errors import ArgumentError, ArgumentTypeError, ShapeError, StaleReferenceError

PLACES = [(0.5, 1.0), (2.25, -3.0), (4.0, 0.125)]


def as_every_kind_of_array(rows):
    """The same numbers as each thing that may be given for an array of points."""
    flat = [number for row in rows for number in row]
    return {
        "list": [tuple(row) for row in rows],
        "Vec2s": [evil.Vec2(*row) for row in rows],
        "float32": np.array(rows, np.float32),
        "float64": np.array(rows, np.float64),
        "column-major": np.asfortranarray(np.array(rows, np.float64)),
        "every other row": np.repeat(np.array(rows, np.float32), 2, axis=0)[::2],
        "backwards": np.array(rows[::-1], np.float32)[::-1],
        "array": array.array("d", flat),
        "memoryview": memoryview(np.array(rows, np.float32)),
        "big columns": np.array([[*row, 9.0] for row in rows])[:, :2],
    }


@pytest.fixture
def world():
    return evil.World(gravity=(0, 0))


@pytest.fixture
def balls(world):
    return world.add_many(evil.Circle(0.5), [(3 * i, 0) for i in range(4)])


@pytest.mark.parametrize("kind", as_every_kind_of_array(PLACES))
def test_bodies_are_added_where_any_kind_of_array_says(world, kind):
    added = world.add_many(evil.Rectangle(1, 1), as_every_kind_of_array(PLACES)[kind])
    assert [tuple(body.position) for body in added] == PLACES


def test_bodies_added_at_once_are_those_added_one_by_one():
    options = {"density": 3, "friction": 0.2, "restitution": 0.4, "damping": 0.9, "tag": "stone"}
    shapes = [evil.Circle(0.5), evil.Polygon([(0, 0), (1, 0), (0, 1)])]
    one, many = evil.World(), evil.World()
    rows = [((i * 2.5, i % 3), 0.3 * i, (i, -1), 0.1 * i) for i in range(20)]
    for at, angle, velocity, spin in rows:
        one.add(shapes, at=at, angle=angle, velocity=velocity, angular_velocity=spin, **options)
    at, angles, velocities, spins = (list(column) for column in zip(*rows, strict=True))
    added = many.add_many(shapes, at, angles=angles, velocities=velocities, angular_velocities=spins, **options)
    for _ in range(30):
        one.step()
        many.step()
    assert many.snapshot() == one.snapshot()
    assert [shape.definition for shape in added[7].shapes] == shapes
    assert many.find("stone") is added[0]


def test_added_bodies_are_a_list_of_handles_made_when_asked_for(world, balls):
    assert (len(balls), balls[1:3]) == (4, [balls[1], balls[2]])
    assert balls[2] is balls[-2] is next(body for body in world.bodies if body.slot == 2)
    assert np.asarray(balls.slots).tolist() == [0, 1, 2, 3]
    assert np.asarray(balls.slots).dtype == np.uint32
    balls[1].destroy()
    world.add(evil.Circle(1), at=(50, 50))
    assert not balls[1].alive, "whoever took the place is not it"
    with pytest.raises(IndexError):
        balls[4]
    with pytest.raises(ArgumentTypeError, match="whole number or a slice"):
        balls["first"]


@pytest.mark.parametrize(
    ("arguments", "error", "said"),
    [
        ({"positions": [(0, 0), (1, math.nan)]}, ArgumentError, r"positions\[1\]=.*finite"),
        ({"positions": np.array([[0, 0], [0, np.inf]])}, ArgumentError, r"positions\[1\]=\(0, inf\) must be finite"),
        ({"positions": [(0, 0), (9e6, 9e6)]}, ArgumentError, r"positions\[1\]=.*within 1e7 metres"),
        ({"positions": [(0, 0), 7]}, ArgumentTypeError, r"positions\[1\]=7 must be a point"),
        ({"positions": [(0, 0), ("a", "b")]}, ArgumentTypeError, r"positions\[1\]=.*must be a point"),
        ({"positions": "ab"}, ArgumentTypeError, "positions must be an array of points"),
        ({"positions": b"abcd"}, ArgumentTypeError, "positions must be an array of points"),
        ({"positions": 5}, ArgumentTypeError, "positions must be an array of points"),
        ({"positions": None}, ArgumentTypeError, "positions must be an array of points"),
        ({"positions": np.zeros((2, 3))}, ArgumentError, "positions must have two columns"),
        ({"positions": np.zeros(3)}, ArgumentError, "positions must have two columns"),
        ({"positions": np.zeros((1, 2, 2))}, ArgumentError, "positions must have two columns"),
        ({"positions": np.array([[None, 0]])}, ArgumentTypeError, "buffer of format 'O'"),
        ({"positions": np.zeros((2, 2), np.complex64)}, ArgumentTypeError, "buffer of format 'Zf'"),
        ({"positions": np.zeros((2, 2), ">f4")}, ArgumentTypeError, "buffer of format '>f'"),
        ({"positions": PLACES, "angles": [0, 1]}, ArgumentError, "angles has 2 values for 3 positions"),
        ({"positions": PLACES, "angles": []}, ArgumentError, "angles has 0 values for 3 positions"),
        ({"positions": PLACES, "angles": [0, 1, True]}, ArgumentTypeError, r"angles\[2\]=True must be a number"),
        ({"positions": PLACES, "velocities": [(0, 0), (1, 1), (2e5, 0)]}, ArgumentError, r"velocities\[2\].*1e5 m/s"),
        ({"positions": PLACES, "angular_velocities": [0, -1e5, 0]}, ArgumentError, r"angular_velocities\[1\]=-100000"),
        ({"positions": PLACES, "density": -1}, ArgumentError, "density=-1"),
        ({"positions": PLACES, "density": 1e-30}, ShapeError, "the body would weigh"),
        ({"positions": PLACES, "tag": 5}, ArgumentTypeError, "tag=5"),
        ({"positions": PLACES, "position": 5}, ArgumentTypeError, "did you mean 'positions'"),
    ],
)
def test_adding_many_is_refused_with_the_place_and_nothing_is_added(world, arguments, error, said):
    world.add(evil.Circle(1))
    before = world.snapshot()
    with pytest.raises(error, match=said):
        world.add_many(evil.Circle(0.5), **arguments)
    assert world.snapshot() == before


def test_none_at_all_may_be_added(world):
    assert len(world.add_many(evil.Circle(1), [])) == len(world.bodies) == 0
    assert len(world.add_many(evil.Circle(1), np.zeros((0, 2)))) == 0


def test_a_value_that_was_checked_once_is_checked_again_when_it_is_another(world):
    for _ in range(3):
        world.add(evil.Circle(1), density=1, bullet=True)
    with pytest.raises(ArgumentTypeError, match="bullet=1 "):
        world.add(evil.Circle(1), density=1, bullet=1)
    with pytest.raises(ArgumentTypeError, match="density=True"):
        world.add(evil.Circle(1), density=True, bullet=True)
    changing = np.array(1.0)
    world.add(evil.Circle(1), density=changing)
    changing[...] = -1.0
    with pytest.raises(ArgumentError, match="density="):
        world.add(evil.Circle(1), density=changing)


# -- writing --


@pytest.mark.parametrize("kind", as_every_kind_of_array(PLACES))
def test_positions_are_written_from_any_kind_of_array(world, balls, kind):
    world.bodies.set_positions(as_every_kind_of_array(PLACES)[kind], [3, 0, 2])
    assert [tuple(balls[i].position) for i in (3, 0, 2, 1)] == [*PLACES, (3, 0)]


def test_all_bodies_are_written_by_a_row_for_each_slot(world, balls):
    balls[1].destroy()
    there = np.array(world.bodies.positions)
    world.bodies.set_positions(there + (0, 5))
    assert [tuple(ball.position) for ball in world.bodies] == [(0, 5), (6, 5), (9, 5)]
    world.bodies.set_angles([0.5, 9, 1.5, -0.5])
    assert [ball.angle for ball in world.bodies] == [0.5, 1.5, -0.5]
    world.bodies.set_velocities(np.ones((4, 2)))
    world.bodies.set_angular_velocities(array.array("f", [1, 2, 3, 4]))
    assert [ball.velocity for ball in world.bodies] == [(1, 1)] * 3
    assert [ball.angular_velocity for ball in world.bodies] == [1, 3, 4]
    assert world.bodies.velocities[2] == (1, 1)
    assert world.bodies.positions[2] == evil.Vec2(6, 5)


@pytest.mark.parametrize(
    "indices", [[2, 0], (2, 0), np.array([2, 0]), np.array([2, 0], np.uint8), array.array("l", [2, 0])]
)
def test_bodies_are_named_by_slots_of_any_kind(world, balls, indices):
    world.bodies.set_velocities([(1, 0), (0, 2)], indices)
    assert [ball.velocity for ball in balls] == [(0, 2), (0, 0), (1, 0), (0, 0)]


def test_bodies_are_named_by_themselves_and_by_their_list(world, balls):
    world.bodies.set_angles([1, 2], [balls[3], balls[1]])
    assert [ball.angle for ball in balls] == [0, 2, 0, 1]
    world.bodies.set_angles([5, 6, 7, 8], balls)
    assert [ball.angle for ball in balls] == [5, 6, 7, 8]
    world.bodies.set_angles([0.5], balls.slots[2:3])
    assert balls[2].angle == 0.5


def test_writing_in_bulk_is_writing_one_by_one():
    def stack():
        world = evil.World()
        world.add(evil.Rectangle(40, 1), at=(0, -0.5), kind="static")
        boxes = world.add_many(evil.Rectangle(1, 1), [(0.3 * (i % 2), 0.5 + i) for i in range(12)])
        for _ in range(20):
            world.step()
        return world, boxes

    (one, single), (many, boxes) = stack(), stack()
    places = [(i - 6, 3 + i) for i in range(12)]
    for i, body in enumerate(single):
        body.position = places[i]
        body.angle = 0.1 * i
        body.velocity = (i, 0)
        body.angular_velocity = -i
        body.apply_force((i, 2), (0, 1))
        body.apply_impulse((1, i))
    bodies = many.bodies
    bodies.set_positions(places, boxes)
    bodies.set_angles([0.1 * i for i in range(12)], boxes)
    bodies.set_velocities([(i, 0) for i in range(12)], boxes)
    bodies.set_angular_velocities([-i for i in range(12)], boxes)
    bodies.apply_forces([(i, 2) for i in range(12)], boxes, [(0, 1)] * 12)
    bodies.apply_impulses([(1, i) for i in range(12)], boxes)
    assert many.snapshot() == one.snapshot()
    for _ in range(20):
        one.step()
        many.step()
    assert many.snapshot() == one.snapshot()


def asleep():
    world = evil.World()
    world.add(evil.Rectangle(100, 1), at=(0, -0.5), kind="static")
    piles = [world.add_many(evil.Rectangle(1, 1), [(x, 0.5 + i) for i in range(2)]) for x in (0, 20, 40)]
    while any(body.awake for pile in piles for body in pile):
        world.step()
        assert world.steps < 600
    return world, piles


def test_what_is_moved_wakes_with_what_it_touches_and_nobody_else():
    world, (left, middle, right) = asleep()
    world.bodies.set_positions([(0, 5)], [left[1]])
    assert [[body.awake for body in pile] for pile in (left, middle, right)] == [[True, True], [False] * 2, [False] * 2]
    world.bodies.apply_forces([(1, 0)], [right[0]])
    world.bodies.apply_impulses([(1, 0)], [middle[1]])
    assert (right[0].awake, right[1].awake, middle[1].awake) == (True, False, True)


def test_what_is_written_as_it_was_sleeps_on():
    world, piles = asleep()
    before = world.snapshot()
    world.bodies.set_positions(world.bodies.positions)
    world.bodies.set_angles(world.bodies.angles)
    world.bodies.set_velocities(world.bodies.velocities)
    world.bodies.set_angular_velocities([0] * 7)
    assert world.snapshot() == before
    assert not any(body.awake for pile in piles for body in pile)


def test_a_body_named_twice_is_pushed_twice(world, balls):
    world.bodies.apply_impulses([(1, 0), (2, 0)], [1, 1])
    assert balls[1].velocity.x == pytest.approx(3 / balls[1].mass)


@pytest.mark.parametrize(
    ("call", "error", "said"),
    [
        (lambda b: b.set_positions([(0, 0)]), ArgumentError, "1 values for 6 rows .* name the bodies with indices="),
        (lambda b: b.set_positions([(0, 0)], [1, 2]), ArgumentError, "1 values for 2 indices"),
        (lambda b: b.set_positions([(9, 9), (0, math.inf)], [1, 2]), ArgumentError, r"values\[1\]="),
        (lambda b: b.set_positions([(9, 9), (0, 0)], [1, 4]), ArgumentError, r"indices\[1\]=4 is no body's slot"),
        (lambda b: b.set_positions([(9, 9), (0, 0)], [1, 99]), ArgumentError, r"indices\[1\]=99 is no body's slot"),
        (lambda b: b.set_positions([(9, 9), (0, 0)], [1, -1]), ArgumentError, r"indices\[1\]=-1 must be the slot"),
        (lambda b: b.set_positions([(9, 9)], [10**30]), ArgumentError, r"indices\[0\]=-1 must be the slot"),
        (lambda b: b.set_positions([(9, 9)], [0.5]), ArgumentTypeError, r"indices\[0\] must be the slot"),
        (lambda b: b.set_positions([(9, 9)], [True]), ArgumentTypeError, r"indices\[0\] must be the slot"),
        (lambda b: b.set_positions([(9, 9)], np.zeros(1)), ArgumentTypeError, "indices is a buffer of format 'd'"),
        (lambda b: b.set_positions([(9, 9)], np.zeros((1, 1), int)), ArgumentError, "indices must have one dimension"),
        (lambda b: b.set_positions([(9, 9)], 3), ArgumentTypeError, "indices must be an array of slots"),
        (lambda b: b.set_angles([1, "a"], [0, 1]), ArgumentTypeError, r"values\[1\]='a' must be a number"),
        (lambda b: b.set_angles(np.zeros((1, 2)), [0, 1]), ArgumentError, "values must have one dimension"),
        (lambda b: b.set_velocities([(9, 9), (1, 1)], [0, 5]), ArgumentError, r"indices\[1\]=5 is a static body"),
        (
            lambda b: b.set_angular_velocities([9, 2e4], [0, 1]),
            ArgumentError,
            r"values\[1\]=20000 must be finite and at",
        ),
        (lambda b: b.apply_forces([(9, 9)], [0], [(0, 0), (1, 1)]), ArgumentError, "2 points for 1 values"),
        (lambda b: b.apply_impulses([(9, 9), (math.nan, 0)], [0, 1]), ArgumentError, r"values\[1\]="),
        (lambda b: b.apply_forces([(9, 9)], [0], points=[(0, math.nan)]), ArgumentError, r"points\[0\]="),
        (lambda b: b.set_angles([1], index=[0]), ArgumentTypeError, "did you mean 'indices'"),
    ],
)
def test_writing_is_refused_with_the_place_and_nothing_is_written(world, balls, call, error, said):
    world.add(evil.Circle(1), at=(0, 9)).destroy()  # slot 4 is free
    slot_4 = world.add(evil.Circle(1), at=(0, 9))
    world.add(evil.Rectangle(9, 1), at=(0, -9), kind="static")
    slot_4.destroy()
    before = world.snapshot()
    with pytest.raises(error, match=said):
        call(world.bodies)
    assert world.snapshot() == before


def test_bodies_of_another_world_and_of_the_past_are_refused(world, balls):
    other = evil.World().add_many(evil.Circle(1), [(0, 0)])
    with pytest.raises(ArgumentError, match="another world"):
        world.bodies.set_angles([1], other)
    with pytest.raises(ArgumentError, match="another world"):
        world.bodies.set_angles([1], [other[0]])
    balls[2].destroy()
    with pytest.raises(StaleReferenceError, match=r"indices\[2\] is a Body that was destroyed"):
        world.bodies.set_angles([1] * 4, balls)
    with pytest.raises(StaleReferenceError):
        world.bodies.set_angles([1], [balls[2]])


def test_the_views_can_be_indexed_and_are_buffers_without_a_copy(world, balls):
    view = world.bodies.positions
    assert (view[1], view[-1], len(view)) == (evil.Vec2(3, 0), evil.Vec2(9, 0), 4)
    table = np.asarray(view)
    assert (table.shape, table.dtype, table.flags.writeable) == ((4, 2), np.float32, False)
    world.bodies.set_positions([(7, 7)], [1])
    assert table[1].tolist() == [7, 7], "the same memory"
    with pytest.raises(IndexError):
        view[4]


def test_shapes_know_what_they_were_made_from_after_others_took_their_place(world):
    first = world.add_many([evil.Circle(1), evil.Rectangle(1, 2)], [(0, 0), (5, 0)])
    first[0].destroy()
    box = world.add(evil.Rectangle(3, 3), at=(9, 9))
    assert [shape.definition for shape in box.shapes] == [evil.Rectangle(3, 3)]
    data = world.snapshot()
    world.add(evil.Circle(7), at=(20, 20))
    world.restore(data)
    assert [shape.definition for shape in box.shapes] == [evil.Rectangle(3, 3)]
    assert [shape.definition for shape in first[1].shapes] == [evil.Circle(1), evil.Rectangle(1, 2)]
    assert len(world._definitions) == 3


@pytest.mark.parametrize("number", [np.float32, np.float64, np.int32])
def test_questions_take_the_numbers_of_numpy_as_well_as_pythons(number):
    world = evil.World()
    wall = world.add(evil.Rectangle(1, 4), at=(5, 0), kind="static")
    for start in ((number(0), number(0)), np.zeros(2, number), np.zeros((1, 2), number)):
        assert world.ray_casts(start, [(10, 0)])[0].body is wall
    assert world.bodies_at_each(np.array([[5, 0], [0, 0]], number)).starts.tolist() == [0, 1, 1]
    for angle in (number(1), np.array(1, number), np.array([1], number)):
        assert world.overlapping_each(evil.Circle(1), [(5, 0)], angle=angle)[0] == (wall,)
