"""Capsules, segments, chains and rounded corners: weighed, resting, asked, saved, drawn, refused."""

from __future__ import annotations

import math
import pickle

import pytest

import evilengine as evil
from evilengine import _core
from evilengine.world.shapes import ShapeDefinition

ROUND = [
    evil.Capsule((-1, 0), (1, 0), 0.5),
    evil.Capsule((0.3, -0.7), (0.9, 1.2), 0.25),
    evil.Rectangle(2, 1, rounding=0.2),
    evil.Polygon([(0, 0), (2, 0), (2, 2), (1, 0.6), (0, 2)], rounding=0.1),
    evil.Triangle((0, 0), (2, 0), (1, 1.5), rounding=0.15),
]
KINDS: list[ShapeDefinition] = [
    *ROUND,
    evil.Circle(0.4),
    evil.Rectangle(1, 0.6),
    evil.Rectangle(2, 1, rounding=0.5),
    evil.Segment((-0.5, 0.1), (0.7, 0)),
    evil.Chain([(-1, 0.2), (0, 0), (1, 0.2)]),
]


def rests(shape: ShapeDefinition, ground: ShapeDefinition, at: tuple[float, float], **options: float) -> evil.Body:
    world = evil.World()
    world.add(ground, kind="static")
    body = world.add(shape, at=at, **options)  # type: ignore[arg-type]
    for _ in range(300):
        world.step(1 / 60)
    return body


@pytest.mark.parametrize("shape", ROUND, ids=repr)
def test_a_skin_weighs_what_its_fine_outline_weighs(shape: ShapeDefinition) -> None:
    body = evil.World().add(shape, density=2.0)
    mass, inertia, centre = _core.polygon_mass(shape._spec.drawn[0], 2.0)
    assert body.mass == pytest.approx(mass, rel=1e-3)
    assert body.inertia == pytest.approx(inertia, rel=2e-3)
    assert tuple(body.centre) == pytest.approx(centre, abs=1e-3)
    assert shape._spec.area == pytest.approx(body.mass / 2, rel=1e-5)


def test_a_capsule_weighs_as_a_bar_between_two_half_discs() -> None:
    assert evil.World().add(evil.Capsule((0, 0), (3, 0), 0.5)).mass == pytest.approx(3 + math.pi / 4)


def test_lines_weigh_as_rods_a_centimetre_thick() -> None:
    world = evil.World()
    rod = world.add(evil.Segment((0, 0), (2, 0)))
    assert (rod.mass, rod.inertia) == (pytest.approx(0.02), pytest.approx(0.02 * 4 / 12))
    square = world.add(evil.Chain([(0, 0), (1, 0), (1, 1), (0, 1)], loop=True), at=(9, 0))
    assert square.mass == pytest.approx(0.04)
    assert tuple(square.centre) == pytest.approx((9.5, 0.5))


@pytest.mark.parametrize(
    ("shape", "height"),
    [
        (evil.Capsule((-1, 0), (1, 0), 0.5), 0.5),
        (evil.Rectangle(1, 1, rounding=0.2), 0.5),
        (evil.Rectangle(2, 1, rounding=0.5), 0.5),
        (evil.Polygon([(-1, 0), (1, 0), (1, 2), (0, 0.6), (-1, 2)], rounding=0.1), 0.0),
        (evil.Segment((-1, 0), (1, 0)), 0.0),
        (evil.Chain([(-1, 0), (0, 0.5), (1, 0)]), 0.0),
    ],
    ids=repr,
)
@pytest.mark.parametrize(
    "ground",
    [
        evil.Rectangle(20, 2),
        evil.Segment((-10, 1), (10, 1)),
        evil.Capsule((-10, 0), (10, 0), 1),
        evil.Chain([(-10, 1), (-3, 1), (0, 1), (3, 1), (10, 1)]),
        evil.Rectangle(20, 2, rounding=0.3),
    ],
    ids=repr,
)
def test_each_kind_rests_flat_on_each_ground(shape: ShapeDefinition, height: float, ground: ShapeDefinition) -> None:
    body = rests(shape, ground, (0.4, 2 + height))
    bare = (evil.Segment, evil.Chain)  # two lines without thickness keep a centimetre apart, or neither would be on top
    gap = 0.01 if isinstance(shape, bare) and isinstance(ground, bare) else 0.0
    assert body.position.y == pytest.approx(1 + height + gap, abs=0.006)
    assert body.angle == pytest.approx(0, abs=0.002)
    assert not body.awake


def test_a_ball_rests_on_a_corner_free_rounding_where_a_circle_of_that_radius_would_be() -> None:
    world = evil.World(gravity=(0, 0))
    world.add(evil.Rectangle(2, 2, rounding=0.5), kind="static")
    ball = world.add(evil.Circle(0.2), at=(1, 1))  # over the corner's middle: 0.5 * sqrt(2) from where its arc begins
    world.step(1 / 60)
    assert not world.contacts.active
    ball.velocity = (-1, -1)
    for _ in range(60):
        world.step(1 / 60)
    gap = math.hypot(ball.position.x - 0.5, ball.position.y - 0.5) - 0.7
    assert gap == pytest.approx(0, abs=0.006)


def test_end_to_end_capsules_touch_by_their_caps() -> None:
    world = evil.World(gravity=(0, 0))
    left = world.add(evil.Capsule((-1, 0), (1, 0), 0.5), at=(-2, 0), velocity=(1, 0))
    right = world.add(evil.Capsule((-1, 0), (1, 0), 0.5), at=(2, 0), velocity=(-1, 0))
    for _ in range(120):
        world.step(1 / 60)
    assert right.position.x - left.position.x == pytest.approx(3, abs=0.01)
    assert abs(left.position.y) < 1e-5
    assert abs(left.angle) < 1e-5


def test_stacked_capsules_and_rounded_boxes_stand() -> None:
    world = evil.World()
    world.add(evil.Segment((-10, 0), (10, 0)), kind="static")
    shapes = [evil.Rectangle(1, 0.6, rounding=0.1), evil.Capsule((-0.5, 0), (0.5, 0), 0.3)]
    stack = [world.add(shapes[i % 2], at=(0, 0.3 + 0.6 * i)) for i in range(8)]
    for _ in range(300):
        world.step(1 / 60)
    for i, body in enumerate(stack):
        assert body.position.y == pytest.approx(0.3 + 0.6 * i, abs=0.05)
        assert abs(body.position.x) < 0.02


@pytest.mark.parametrize("shape", ROUND, ids=repr)
def test_points_and_rays_meet_the_skin(shape: ShapeDefinition) -> None:
    world = evil.World()
    body = world.add(shape, kind="static", at=(3, -2), angle=0.4)
    cos, sin = math.cos(0.4), math.sin(0.4)
    centre = body.centre
    for x, y in shape._spec.drawn[0]:
        edge = evil.Vec2(3 + cos * x - sin * y, -2 + sin * x + cos * y)
        out, inside = centre + 1.01 * (edge - centre), centre + 0.99 * (edge - centre)
        if isinstance(shape, evil.Polygon) and len(shape.corners) == 5:
            continue  # its notch is not seen from its centre
        assert not world.bodies_at(out)
        assert world.bodies_at(inside) == (body,)
        far = centre + 5 * (edge - centre)
        hit = world.ray_cast(far, centre)
        assert hit is not None
        assert (hit.point - edge).length < 0.01
        assert hit.normal.dot(edge - centre) > 0
        assert world.ray_cast(inside, centre) is None


def test_a_segment_is_hit_from_both_sides_and_has_no_inside() -> None:
    world = evil.World()
    world.add(evil.Segment((-1, 0), (1, 0)), kind="static")
    above, below = world.ray_cast((0.5, 1), (0.5, -1)), world.ray_cast((0.5, -1), (0.5, 1))
    assert above is not None
    assert below is not None
    assert (above.normal, below.normal) == (evil.Vec2(0, 1), evil.Vec2(0, -1))
    assert world.ray_cast((1.5, 1), (1.5, -1)) is None
    assert world.bodies_at((0.5, 1e-4)) == ()


@pytest.mark.parametrize("shape", KINDS, ids=repr)
def test_a_restored_world_goes_on_bit_for_bit(shape: ShapeDefinition) -> None:
    world = evil.World()
    world.add(evil.Chain([(-5, 1), (0, 0), (5, 1)]), kind="static")
    for i in range(4):
        world.add(shape, at=(0.3 * i, 1.5 + 1.2 * i), angle=0.2 * i)
    for _ in range(40):
        world.step(1 / 60)
    data = world.snapshot()
    for _ in range(40):
        world.step(1 / 60)
    expected = world.checksum()
    other = evil.World()
    other.restore(data)
    for _ in range(40):
        other.step(1 / 60)
    assert other.checksum() == expected


@pytest.mark.parametrize("shape", KINDS, ids=repr)
def test_definitions_are_equal_when_they_say_the_same(shape: ShapeDefinition) -> None:
    again = pickle.loads(pickle.dumps(shape))
    assert again == shape
    assert hash(again) == hash(shape)
    assert repr(again) == repr(shape)
    assert repr(eval(repr(shape), vars(evil))) == repr(shape)


def test_rounding_keeps_the_edges_where_they_are() -> None:
    box = evil.World().add(evil.Rectangle(2, 1, rounding=0.2), kind="static")
    assert evil.Rectangle(2, 1, rounding=0.2).corners == evil.Rectangle(2, 1).corners
    hit = box.world.ray_cast((5, 0.1), (0, 0.1))
    assert hit is not None
    assert hit.point.x == pytest.approx(1)


def test_round_things_are_not_squeezed() -> None:
    body = evil.World().add(evil.Capsule((-1, 0), (1, 0), 0.5))
    with pytest.raises(evil.ShapeError, match="round"):
        body.scale = (2, 1)
    body.scale = (2, 2)
    assert body.shapes[0].outline == ("capsule", ((-2, 0), (2, 0)), 1)


@pytest.mark.parametrize(
    ("make", "says"),
    [
        (lambda: evil.Capsule((0, 0), (0, 0), 1), "nearer than 0.0001 metres"),
        (lambda: evil.Capsule((0, 0), (1, 0), 0), "radius=0 must be"),
        (lambda: evil.Segment((0, 0), (math.nan, 0)), "must be finite"),
        (lambda: evil.Chain([(0, 0)]), "needs 2 points or more; got 1"),
        (lambda: evil.Chain([(0, 0), (1, 0)], loop=True), "needs 3 points or more; got 2"),
        (lambda: evil.Chain([(0, 0), (1, 0), (0, 1), (0, 0)], loop=True), "joins the last to the first"),
        (lambda: evil.Chain([(0, 0), (1, 0), (1, math.inf)]), "point 2 must be finite"),
        (lambda: evil.Rectangle(1, 2, rounding=0.6), "at most 0.5"),
        (lambda: evil.Polygon([(0, 0), (1, 0), (0, 1)], rounding=0.5), "at most about 0.29"),
    ],
)
def test_a_wrong_shape_says_what_is_wrong(make: object, says: str) -> None:
    with pytest.raises(evil.ShapeError if "finite" not in says else evil.Error, match=says):
        make()  # type: ignore[operator]
