"""Whatever changes in how bodies meet: nothing breaks, and a restored world goes on as if it had never stopped."""

from __future__ import annotations

import math

from hypothesis import given, settings
from hypothesis import strategies as st

import evilengine as evil

SHAPES = (evil.Circle(0.5), evil.Rectangle(1, 0.6), evil.Polygon([(-1, -1), (1, -1), (1, 1), (0, 0), (-1, 1)]))
spots = st.tuples(st.floats(-3, 3), st.floats(0, 4))
traits = st.one_of(
    st.tuples(st.just("category"), st.integers(1, 7)),
    st.tuples(st.just("mask"), st.integers(0, 7)),
    st.tuples(st.just("group"), st.integers(-2, 2)),
    st.tuples(st.just("sensor"), st.booleans()),
    st.tuples(st.just("one_way"), st.sampled_from([None, True, (1, 0), (0, -1)])),
    st.tuples(st.just("surface_speed"), st.floats(-9, 9)),
    st.tuples(st.just("kind"), st.sampled_from(["static", "kinematic", "dynamic"])),
    st.tuples(st.just("position"), spots),
    st.tuples(st.just("awake"), st.booleans()),
    st.tuples(st.just("destroy"), st.none()),
    st.tuples(st.just("medium"), st.floats(0, 3)),
)
moves = st.lists(st.tuples(st.integers(0, 7), st.booleans(), traits), max_size=12)


def change(world, which, of_shape, name, value):
    bodies = list(world.bodies)
    if not bodies:
        return
    body = bodies[which % len(bodies)]
    if name == "destroy":
        body.destroy()
    elif name == "medium":
        carrier = body if of_shape else None
        world.add_force(evil.Medium((-2, -1, 2, 2), density=value, linear=1, velocity=(value, 0), body=carrier))
    elif of_shape and name in ("category", "mask", "group", "sensor", "one_way", "surface_speed"):
        setattr(body.shapes[0], name, value)
    else:
        setattr(body, name, value)


def told(world):
    contacts, sensors, events = world.contacts, world.sensors, world.events
    lists = [
        contacts.begun,
        contacts.ended,
        contacts.hit,
        contacts.active,
        sensors.entered,
        sensors.left,
        sensors.inside,
    ]
    return [memoryview(each.shapes).tolist() for each in lists] + [
        [body.slot for body in each] for each in (events.slept, events.woke)
    ]


@settings(max_examples=60, deadline=None)
@given(st.lists(st.tuples(st.integers(0, 2), spots), min_size=2, max_size=8), moves)
def test_whatever_changes_a_restored_world_goes_on_alike(made, changes):
    world = evil.World()
    world.add(evil.Rectangle(12, 1), at=(0, -0.5), kind="static")
    for number, at in made:
        world.add(SHAPES[number], at=at)
    inside, touching = set(), set()
    for which, of_shape, (name, value) in [*changes, *[(0, False, ("awake", True))] * 3]:
        change(world, which, of_shape, name, value)
        twin = evil.World.of(world.snapshot())
        for _ in range(4):
            world.step()
            twin.step()
            assert told(twin) == told(world)
            for known, begun, ended, now in (
                (touching, world.contacts.begun, world.contacts.ended, world.contacts.active),
                (inside, world.sensors.entered, world.sensors.left, world.sensors.inside),
            ):
                rows = [{tuple(row) for row in memoryview(each.shapes).tolist()} for each in (begun, ended, now)]
                known |= rows[0]
                known -= rows[1] - rows[0]
                assert known == rows[2]  # what began and has not ended is what is
        assert twin.snapshot() == world.snapshot()
        for body in world.bodies:
            assert all(math.isfinite(value) for value in (*body.position, body.angle, *body.velocity))
