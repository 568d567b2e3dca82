"""Every kind of shape against every other: how deep they overlap, from both sides, and what questions find."""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

import evilengine as evil
from evilengine.world.shapes import ShapeDefinition

Points = npt.NDArray[np.float64]
Part = tuple[Points, float]  # a convex core, and how far its skin reaches

HEXAGON = [(0.9 * math.cos(k * math.pi / 3), 0.9 * math.sin(k * math.pi / 3)) for k in range(6)]
DOZEN = [(math.cos(k * math.pi / 6), 0.7 * math.sin(k * math.pi / 6)) for k in range(12)]
ARROW = [(-1.0, -1.0), (1.0, 0.0), (-1.0, 1.0), (-0.4, 0.0)]
CONVEX: list[ShapeDefinition] = [
    evil.Circle(0.7),
    evil.Rectangle(1.6, 0.9),
    evil.Rectangle(1.4, 1.0, rounding=0.25),
    evil.Triangle((-0.8, -0.6), (0.9, -0.5), (0.1, 0.9)),
    evil.Polygon(HEXAGON),
    evil.Polygon(DOZEN),  # of more corners than the eight that are looked at side by side
    evil.Polygon(HEXAGON, rounding=0.2),
    evil.Capsule((-0.7, 0.1), (0.6, -0.2), 0.35),
]
LINES = (evil.Segment, evil.Chain)
OTHERS: list[ShapeDefinition] = [
    evil.Segment((-0.9, -0.2), (0.8, 0.4)),
    evil.Chain([(-1.2, 0.3), (-0.2, 0.0), (0.5, 0.1), (1.1, -0.4)]),
    evil.Polygon(ARROW),
    evil.Polygon(ARROW, rounding=0.1),
    evil.Polygon([(-1, -1), (1, -1), (1, 1), (-1, 1)], holes=[[(-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)]]),
]
ALL = [*CONVEX, *OTHERS]
SOLID = [shape for shape in ALL if not isinstance(shape, LINES)]
PLACES = st.tuples(st.floats(-1.6, 1.6), st.floats(-1.6, 1.6), st.floats(-4, 4), st.floats(-4, 4))


# What they should find, without any of the engine's geometry


def parts_of(shape: ShapeDefinition, at: tuple[float, float] = (0.0, 0.0), angle: float = 0.0) -> list[Part]:
    if isinstance(shape, evil.Circle):
        local: list[Part] = [(np.zeros((1, 2)), shape.radius)]
    elif isinstance(shape, evil.Capsule | evil.Segment):
        local = [(np.array([shape.a, shape.b]), getattr(shape, "radius", 0.0))]
    else:
        rounding = getattr(shape, "rounding", 0.0)
        local = [(np.array(part), rounding) for part in shape._spec.parts]
    turn = np.array([[math.cos(angle), math.sin(angle)], [-math.sin(angle), math.cos(angle)]])
    return [(core @ turn + np.array(at), radius) for core, radius in local]


def edges_of(core: Points) -> list[tuple[Points, Points]]:
    return [(core[i], core[(i + 1) % len(core)]) for i in range(len(core))]


def distance_to(core: Points, point: Points) -> float:
    """From a point to a convex core; 0 inside it."""
    if len(core) > 2 and all(
        (b[0] - a[0]) * (point[1] - a[1]) >= (b[1] - a[1]) * (point[0] - a[0]) for a, b in edges_of(core)
    ):
        return 0.0
    return min(to_edge(a, b, point) for a, b in edges_of(core))


def to_edge(a: Points, b: Points, point: Points) -> float:
    edge, square = b - a, float((b - a) @ (b - a))
    part = min(max(float((point - a) @ edge) / square, 0.0), 1.0) if square > 0 else 0.0
    return float(np.hypot(*(a + part * edge - point)))


def separation(p: Part, q: Part) -> float:
    """Of two convex parts: how far apart their skins are; less than 0 by how far one must move to leave the other."""
    along = -math.inf
    for core, other in ((p[0], q[0]), (q[0], p[0])):
        for a, b in edges_of(core) if len(core) > 1 else []:
            normal = np.array([b[1] - a[1], a[0] - b[0]]) / np.hypot(*(b - a))
            along = max(along, float((other @ normal).min() - (core @ normal).max()))
    if -math.inf < along < 0:
        return along - p[1] - q[1]
    near = min(distance_to(core, point) for core, other in ((p[0], q[0]), (q[0], p[0])) for point in other)
    return near - p[1] - q[1]


def is_in(shape: ShapeDefinition, point: tuple[float, float]) -> float:
    """How far the point is from the nearest of its parts; 0 or less in one of them."""
    return min(distance_to(core, np.array(point)) - radius for core, radius in parts_of(shape))


# Contacts


def contacts_of(first: ShapeDefinition, second: ShapeDefinition, place: tuple[float, ...]) -> list[evil.Contact]:
    x, y, angle, other = place
    world = evil.World(gravity=(0, 0))
    world.add(first, angle=angle)
    world.add(second, at=(x, y), angle=other)
    world.step(1e-4)
    return list(world.contacts.active)


@settings(max_examples=400, deadline=None)
@given(st.sampled_from(CONVEX), st.sampled_from(CONVEX), PLACES)
def test_a_contact_is_as_deep_as_the_overlap(
    first: ShapeDefinition, second: ShapeDefinition, place: tuple[float, ...]
) -> None:
    x, y, angle, other = place
    (one,), (two,) = parts_of(first, angle=angle), parts_of(second, (x, y), other)
    apart = separation(one, two)
    contacts = contacts_of(first, second, place)
    if apart > 0.001:
        assert not contacts
    if apart < -0.001:
        (contact,) = contacts
        # An edge is taken until another is 0.5 mm better, and in place of a corner when their directions differ by so
        # little that it costs a thousandth of the skins.
        assert contact.depth == pytest.approx(-apart, abs=0.0006 + 0.001 * (one[1] + two[1]))
        moved = [(core + (contact.depth + 0.002) * np.array(contact.normal), radius) for core, radius in (two,)]
        assert separation(one, moved[0]) > 0  # along its normal, that far is out


@settings(max_examples=300, deadline=None)
@given(st.sampled_from(ALL), st.sampled_from(ALL), PLACES)
def test_contacts_are_the_same_from_both_sides(
    first: ShapeDefinition, second: ShapeDefinition, place: tuple[float, ...]
) -> None:
    x, y, angle, other = place
    assume(not (isinstance(first, LINES) and isinstance(second, LINES)))  # which way out is anyone's guess
    there = contacts_of(first, second, place)
    world = evil.World(gravity=(0, 0))
    world.add(second, at=(x, y), angle=other)
    world.add(first, angle=angle)
    world.step(1e-4)
    back = list(world.contacts.active)
    deepest = [max((contact.depth for contact in each), default=0.0) for each in (there, back)]
    assert deepest[0] == pytest.approx(deepest[1], abs=0.001)


@settings(max_examples=200, deadline=None)
@given(st.sampled_from(ALL), st.sampled_from(ALL), PLACES)
def test_what_overlaps_comes_apart_without_a_bang(
    first: ShapeDefinition, second: ShapeDefinition, place: tuple[float, ...]
) -> None:
    x, y, angle, other = place
    world = evil.World(gravity=(0, 0), sleep=False)  # who falls asleep keeps no momentum
    bodies = [world.add(first, angle=angle), world.add(second, at=(x, y), angle=other)]
    for _ in range(30):
        world.step(1 / 60)
        for body in bodies:
            assert math.isfinite(body.position.x + body.position.y + body.angle + body.angular_velocity)
            assert body.velocity.length < 10
    momentum = bodies[0].mass * bodies[0].velocity + bodies[1].mass * bodies[1].velocity
    assert momentum.length < 1e-4 * (bodies[0].mass + bodies[1].mass)


# Questions


@pytest.mark.parametrize("shape", SOLID, ids=repr)
@settings(max_examples=40, deadline=None)
@given(point=st.tuples(st.floats(-2, 2), st.floats(-2, 2)))
def test_a_point_is_in_a_shape_or_as_far_from_it_as_from_its_parts(
    shape: ShapeDefinition, point: tuple[float, float]
) -> None:
    world = evil.World()
    body = world.add(shape, kind="static")
    away = is_in(shape, point)
    if abs(away) > 1e-5:
        assert world.bodies_at(point) == ((body,) if away < 0 else ())
    nearest = world.nearest(point)
    assert nearest is not None
    assert nearest.distance == pytest.approx(max(away, 0.0), abs=1e-5)


@pytest.mark.parametrize("shape", SOLID, ids=repr)
@settings(max_examples=40, deadline=None)
@given(
    start=st.tuples(st.floats(-2, 2), st.floats(-2, 2)),
    end=st.tuples(st.floats(-2, 2), st.floats(-2, 2)),
)
def test_a_ray_stops_where_the_shape_begins(
    shape: ShapeDefinition, start: tuple[float, float], end: tuple[float, float]
) -> None:
    assume(is_in(shape, start) > 1e-3 and math.dist(start, end) > 0.01)
    world = evil.World()
    world.add(shape, kind="static")
    hit = world.ray_cast(start, end)
    way = [tuple(np.array(start) + t * (np.array(end) - np.array(start))) for t in np.linspace(0, 1, 101)]
    if hit is None:
        assert all(is_in(shape, point) > -1e-3 for point in way)
        return
    assert abs(is_in(shape, hit.point)) < 1e-4
    assert all(is_in(shape, point) > -1e-3 for k, point in enumerate(way) if k / 100 < hit.fraction)
    assert hit.normal.length == pytest.approx(1.0)
    assert hit.normal.dot(evil.Vec2(end[0] - start[0], end[1] - start[1])) < 0
