"""Sensors see what overlaps them, of any kind, awake or asleep, and push nothing."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import evilengine as evil


@pytest.fixture
def world():
    return evil.World()


def ground(world):
    return world.add(evil.Rectangle(40, 1), at=(0, -0.5), kind="static")


def run(world, seconds):
    for _ in range(round(seconds * 60)):
        world.step()


@pytest.mark.parametrize("sensor_kind", ["static", "kinematic", "dynamic"])
@pytest.mark.parametrize("visitor_kind", ["static", "kinematic", "dynamic"])
def test_a_sensor_of_any_kind_sees_bodies_of_any_kind(sensor_kind, visitor_kind):
    world = evil.World(gravity=(0, 0))
    zone = world.add(evil.Circle(1), kind=sensor_kind, sensor=True)
    visitor = world.add(evil.Rectangle(1, 1), at=(0.5, 0), kind=visitor_kind)
    world.step()
    (visit,) = world.sensors.entered
    assert (visit.sensor, visit.visitor) == (zone, visitor)
    assert (visit.sensor_shape, visit.visitor_shape) == (zone.shapes[0], visitor.shapes[0])
    assert zone.visitors == (visitor,)
    assert not world.contacts.active
    visitor.position = (5, 0)
    world.step()
    assert world.sensors.left == (visit,)
    assert zone.visitors == ()
    assert (zone.position, zone.velocity) == ((0, 0), (0, 0))


def test_a_sensor_neither_pushes_nor_holds(world):
    world.add(evil.Rectangle(4, 4), kind="static", sensor=True)
    free = world.add(evil.Circle(0.5), at=(10, 3))
    through = world.add(evil.Circle(0.5), at=(0, 3))
    run(world, 1)
    assert through.position.y == free.position.y
    assert through.velocity == free.velocity


def test_sleepers_are_seen_and_sleep_on(world):
    ground(world)
    boxes = [world.add(evil.Rectangle(1, 1), at=(2 * x, 0.5)) for x in range(3)]
    run(world, 2)
    assert not any(box.awake for box in boxes)
    zone = world.add(evil.Rectangle(4, 1), at=(1.8, 0.6), kind="kinematic", sensor=True)
    world.step()
    assert [visit.visitor for visit in world.sensors.entered] == boxes
    zone.velocity = (0.8, 0)
    run(world, 1)
    assert not any(box.awake for box in boxes)
    assert zone.visitors == tuple(boxes[1:])


def test_a_body_in_a_sensor_falls_asleep_and_stays_seen(world):
    ground(world)
    zone = world.add(evil.Rectangle(4, 4), kind="static", sensor=True)
    box = world.add(evil.Rectangle(1, 1), at=(0, 0.5))
    run(world, 2)
    assert not box.awake
    assert box in zone.visitors
    box.awake = True
    box.position = (9, 0.5)
    world.step()
    assert box not in zone.visitors


def test_a_static_sensor_put_over_a_sleeper_sees_it(world):
    ground(world)
    box = world.add(evil.Rectangle(1, 1), at=(0, 0.5))
    zone = world.add(evil.Circle(1), at=(9, 5), kind="static", sensor=True)
    run(world, 2)
    assert not box.awake
    assert zone.visitors == ()
    zone.position = (0, 1)
    world.step()
    assert box in zone.visitors
    assert not box.awake
    zone.position = (9, 5)
    world.step()
    assert zone.visitors == ()


def test_sensors_do_not_see_each_other_and_heed_filters():
    world = evil.World(gravity=(0, 0))
    zone = world.add(evil.Circle(1), sensor=True, mask=2)
    world.add(evil.Circle(1), sensor=True, category=2)
    world.add(evil.Circle(1), category=4)
    seen = world.add(evil.Circle(1), category=2)
    world.step()
    assert zone.visitors == (seen,)


def test_a_sensor_on_a_solid_body_is_its_own(world):
    floor = ground(world)
    robot = world.add(evil.Rectangle(1, 1), at=(0, 0.5))
    eye = robot.add_shape(evil.Circle(2), sensor=True)
    ball = world.add(evil.Circle(0.3), at=(1.5, 0.3))
    run(world, 0.5)
    assert robot.visitors == (floor, ball)
    assert robot.mass == pytest.approx(1 + 3.14159265 * 4, rel=1e-3)
    assert {visit.sensor_shape for visit in world.sensors.inside} == {eye}


def test_becoming_a_sensor_ends_the_contact_and_begins_the_visit(world):
    floor = ground(world)
    box = world.add(evil.Rectangle(1, 1), at=(0, 0.499))
    run(world, 0.2)
    floor.sensor = True
    world.step()
    assert [(c.a, c.b) for c in world.contacts.ended] == [(floor, box)]
    assert [(v.sensor, v.visitor) for v in world.sensors.entered] == [(floor, box)]
    floor.sensor = False
    world.step()
    assert len(world.sensors.left) == len(world.contacts.begun) == 1


def test_enter_and_leave_are_told_to_the_body_with_the_sensor(world):
    zone = world.add(evil.Rectangle(4, 1), kind="static", sensor=True)
    ball = world.add(evil.Circle(0.2), at=(0, 2))
    told = []
    zone.on_enter(lambda visit: told.append(("in", visit.visitor)))
    zone.on_leave(lambda visit: told.append(("out", visit.visitor)))
    ball.on_enter(lambda visit: told.append("never"))
    run(world, 2)
    assert told == [("in", ball), ("out", ball)]


def test_what_is_destroyed_inside_has_left_and_a_callback_may_do_it(world):
    zone = world.add(evil.Rectangle(9, 1), kind="static", sensor=True)
    balls = [world.add(evil.Circle(0.2), at=(x, 2)) for x in (-1, 1)]
    left = []
    zone.on_enter(lambda visit: [ball.destroy() for ball in balls if ball.alive])
    zone.on_leave(lambda visit: left.append(visit.visitor.alive))
    run(world, 2)
    assert left == [False, False]
    zone.destroy()
    run(world, 0.1)


def test_the_pieces_of_a_concave_visitor_are_one_visit():
    world = evil.World(gravity=(0, 0))
    ring = evil.Polygon([(-2, -2), (2, -2), (2, 2), (1, 2), (1, -1), (-1, -1), (-1, 2), (-2, 2)])
    zone = world.add(evil.Rectangle(6, 1), kind="static", sensor=True)
    cup = world.add(ring, velocity=(0, 1))
    entered = left = 0
    for _ in range(240):
        world.step()
        entered += len(world.sensors.entered)
        left += len(world.sensors.left)
    assert (entered, left) == (1, 1)
    assert cup.position.y > 2.4
    assert zone.visitors == ()


@settings(max_examples=30, deadline=None)
@given(
    st.lists(st.tuples(st.floats(-3, 3), st.floats(-3, 3), st.floats(0.2, 1)), min_size=1, max_size=6),
    st.floats(0.3, 2),
)
def test_what_is_inside_is_what_overlaps(balls, radius):
    world = evil.World(gravity=(0, 0))
    zone = world.add(evil.Circle(radius), kind="static", sensor=True)
    made = [world.add(evil.Circle(r), at=(x, y), velocity=(-x, -y), group=-1) for x, y, r in balls]
    for _ in range(20):
        world.step(1 / 20)
        gaps = [ball.position.length - r - radius for ball, (_, _, r) in zip(made, balls, strict=True)]
        sure = [ball for ball, gap in zip(made, gaps, strict=True) if gap < -1e-4]
        maybe = [ball for ball, gap in zip(made, gaps, strict=True) if gap < 1e-4]
        assert set(sure) <= set(zone.visitors) <= set(maybe)


def test_visits_go_on_as_if_never_stopped_after_a_restore(world):
    ground(world)
    world.add(evil.Rectangle(3, 3), kind="static", sensor=True)
    for x in range(4):
        world.add(evil.Circle(0.3), at=(x / 2, 3 + x), restitution=0.7)
    for step in range(150):
        twin = evil.World.of(world.snapshot())
        twin.step()
        world.step()
        assert twin.snapshot() == world.snapshot(), step
        for name in ("entered", "left", "inside"):
            mine, other = (getattr(one.sensors, name) for one in (world, twin))
            assert [memoryview(v.bodies).tolist() for v in (mine, other)] == [memoryview(mine.bodies).tolist()] * 2
