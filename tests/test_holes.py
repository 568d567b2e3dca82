"""Polygons with holes: refused, split, weighed, met, asked, saved, drawn."""

from __future__ import annotations

import math
import pickle
import random
from fractions import Fraction

import pytest
from drawing_gl import any_driver, difference, picture
from hypothesis import given, settings
from hypothesis import strategies as st
from stage import BLACK, RED, Stage
from test_shapes_geometry import Corners, exact_area, exact_turn, float32, star_shaped, untangled

import evilengine as evil
from evilengine import _core
from evilengine.renderer.gl import GlRenderer
from evilengine.renderer.soft import SoftRenderer
from evilengine.scene import Camera, Scene

SQUARE = [(0.0, 0.0), (3.0, 0.0), (3.0, 3.0), (0.0, 3.0)]
MIDDLE = [(1.0, 1.0), (2.0, 1.0), (2.0, 2.0), (1.0, 2.0)]
FRAME = evil.Polygon(SQUARE, holes=[MIDDLE])


def ring(outer: float, inner: float, n: int = 48, rounding: float = 0.0) -> evil.Polygon:
    def circle(radius: float) -> Corners:
        return [(radius * math.cos(2 * math.pi * k / n), radius * math.sin(2 * math.pi * k / n)) for k in range(n)]

    return evil.Polygon(circle(outer), holes=[circle(inner)], rounding=rounding)


# Refused


@pytest.mark.parametrize(
    ("holes", "says"),
    [
        ([[(1, 1), (5, 1), (2, 2)]], "edges 1-2 and 0-1 of holes[0] cross or touch"),
        ([[(0, 1), (1, 1), (1, 2)]], "edges 3-0 and 0-1 of holes[0] cross or touch"),
        ([MIDDLE, [(2, 1.2), (2.5, 1.2), (2.5, 2)]], "edges 1-2 of holes[0] and 0-1 of holes[1] cross or touch"),
        ([[(9, 1), (10, 1), (9, 2)]], "holes[0] lies outside the outline"),
        ([[(-1, -1), (4, -1), (4, 4), (-1, 4)]], "holes[0] lies outside the outline"),
        ([[(0.5, 0.5), (2.5, 0.5), (2.5, 2.5), (0.5, 2.5)], MIDDLE], "holes[1] lies within holes[0]"),
        ([[(1, 1), (2, 1)]], "2 corners of holes[0] are too few"),
        ([[(1, 1), (2, 2), (1.5, 1.5)]], "corners of holes[0] lie in one line"),
        ([[(1, 1), (2, 1), (1, math.nan)]], "corner 2 (1, nan) of holes[0] must be finite"),
        ([[(1, 1), (2, 1), (1, 1)]], "corners 0 (1, 1) of holes[0] and 2 (1, 1) of holes[0] are nearer"),
    ],
)
def test_a_hole_that_cannot_be_is_described(holes: list[Corners], says: str) -> None:
    with pytest.raises(evil.ShapeError, match=r"^Polygon: ") as error:
        evil.Polygon(SQUARE, holes=holes)
    assert says in str(error.value)


@pytest.mark.parametrize("holes", [3, [3], [(1, 1), (2, 1), (2, 2)], ["abc"], None])
def test_holes_that_are_no_lists_of_points_are_a_type_error(holes: object) -> None:
    with pytest.raises(evil.ArgumentTypeError, match="holes"):
        evil.Polygon(SQUARE, holes=holes)  # type: ignore[arg-type]


def test_holes_may_run_either_way_round_and_are_kept_clockwise() -> None:
    turned = evil.Polygon(SQUARE[::-1], holes=[MIDDLE[:1] + MIDDLE[:0:-1]])
    assert turned.holes == FRAME.holes == (((1, 1), (1, 2), (2, 2), (2, 1)),)
    assert FRAME.corners == tuple(SQUARE)
    assert FRAME.area == 8.0


def test_a_definition_with_holes_is_a_value() -> None:
    again = evil.Polygon(SQUARE, holes=[MIDDLE])
    assert again == FRAME
    assert hash(again) == hash(FRAME)
    assert evil.Polygon(SQUARE) != FRAME
    rounded = evil.Polygon(SQUARE, holes=[MIDDLE], rounding=0.1)
    assert pickle.loads(pickle.dumps(rounded)) == rounded
    assert eval(repr(rounded), {"Polygon": evil.Polygon}) == rounded


# Split


@st.composite
def polygons_with_holes(draw: st.DrawFn) -> tuple[Corners, list[Corners]]:
    """Random holes in random outlines. On whole numbers, many corners are level with each other."""
    chance = random.Random(draw(st.integers(0, 2**32)))
    if draw(st.booleans()):
        outline = [(0.0, 0.0), (18.0, 0.0), (18.0, 18.0), (0.0, 18.0)]
        if draw(st.booleans()):
            outline = [(3 * x, 3 * y) for x, y in untangled(chance, 12)]
    else:
        outline = [(10 * x, 10 * y) for x, y in star_shaped(chance, draw(st.integers(3, 30)), 0.6)]
    if _core.polygon_problem(outline) is not None:
        outline = [(-9.0, -9.0), (9.0, -9.0), (9.0, 9.0), (-9.0, 9.0)]
    holes: list[Corners] = []
    for _ in range(draw(st.integers(1, 8))):
        x, y = chance.randrange(-9, 18), chance.randrange(-9, 18)
        if draw(st.booleans()):
            hole = [(x + a / 2, y + b / 2) for a, b in untangled(chance, chance.randrange(3, 8))]
        else:
            hole = float32([(x + 2 * a, y + 2 * b) for a, b in star_shaped(chance, chance.randrange(3, 12), 0.8)])
        if _core.polygon_problem(outline, [*holes, hole]) is None:
            holes.append(hole)
    return outline, holes


@settings(max_examples=300, deadline=None)
@given(polygons_with_holes())
def test_triangles_and_parts_fill_all_but_the_holes_without_new_corners(polygon: tuple[Corners, list[Corners]]) -> None:
    outline, holes = polygon
    corners = [*outline, *(corner for hole in holes for corner in hole)]
    area = abs(exact_area(outline)) - sum((abs(exact_area(hole)) for hole in holes), Fraction(0))

    triangles = _core.triangulate(outline, holes)
    assert len(triangles) == len(corners) + 2 * len(holes) - 2
    areas = [exact_area([corners[i] for i in triangle]) for triangle in triangles]
    assert min(areas) > 0  # counter-clockwise, and none without area
    assert sum(areas) == area  # with the right sum, positive triangles cannot overlap
    edges = [frozenset((t[k], t[(k + 1) % 3])) for t in triangles for k in range(3)]
    rings, first = set(), 0
    for each in (outline, *holes):
        rings |= {frozenset((first + i, first + (i + 1) % len(each))) for i in range(len(each))}
        first += len(each)
    assert all(edges.count(edge) == (1 if edge in rings else 2) for edge in edges)

    total = Fraction(0)
    for part in _core.split_convex(outline, holes):
        shape = [corners[i] for i in part]
        assert len(set(part)) == len(part) >= 3
        assert all(exact_turn(shape[k - 2], shape[k - 1], shape[k]) == 1 for k in range(len(shape)))
        total += exact_area(shape)
    assert total == area


def test_many_holes_take_a_blink() -> None:
    holes = [[(x + a, y + b) for a, b in ((0.2, 0.2), (0.8, 0.3), (0.5, 0.8))] for x in range(36) for y in range(36)]
    outline = [(-1.0, -1.0), (37.0, -1.0), (37.0, 37.0), (-1.0, 37.0)]
    corners = 4 + 3 * len(holes)
    assert len(_core.triangulate(outline, holes)) == corners + 2 * len(holes) - 2


# Weighed


@pytest.mark.parametrize("density", [1.0, 2.5])
def test_mass_inertia_and_centre_are_the_outline_s_less_the_holes(density: float) -> None:
    outline = [(0, 0), (5, 0), (6, 4), (2, 5), (-1, 3)]
    holes = [[(0.5, 0.5), (2, 0.7), (1, 2)], [(3, 1), (4.5, 2), (4, 3.5), (3, 3)]]
    parts = [_core.polygon_mass(outline, density), *(_core.polygon_mass(hole, density) for hole in holes)]
    signs = [1, -1, -1]
    mass = sum(s * m for s, (m, _, _) in zip(signs, parts, strict=True))
    centre = [sum(s * m * c[k] for s, (m, _, c) in zip(signs, parts, strict=True)) / mass for k in (0, 1)]
    inertia = sum(s * (i + m * math.dist(c, centre) ** 2) for s, (m, i, c) in zip(signs, parts, strict=True))
    body = evil.World().add(evil.Polygon(outline, holes=holes), density=density)
    assert body.mass == pytest.approx(mass, rel=1e-6)
    assert body.inertia == pytest.approx(inertia, rel=1e-6)
    assert tuple(body.centre) == pytest.approx(centre, rel=1e-6)


def test_a_rounded_ring_weighs_what_its_fine_outline_weighs() -> None:
    shape = evil.Polygon(SQUARE, holes=[MIDDLE], rounding=0.2)
    outline, holes = shape._spec.drawn
    assert holes == FRAME.holes  # its corners turn inward, as seen from what is solid: they stay sharp
    body = evil.World().add(shape)
    assert body.mass == pytest.approx(_core.signed_area(outline) - 1, rel=1e-3)
    assert body.mass == pytest.approx(8 - (4 - math.pi) * 0.04, rel=1e-6)
    assert tuple(body.centre) == pytest.approx((1.5, 1.5))
    mirrored = evil.World().add(shape)
    mirrored.apply_matrix(evil.Mat4.scale(-1, 1))
    assert mirrored.mass == pytest.approx(body.mass)
    assert mirrored.inertia == pytest.approx(body.inertia)


# Met and asked


def test_a_ball_lies_inside_a_ring() -> None:
    world = evil.World()
    world.add(evil.Rectangle(20, 1), at=(0, -0.5), kind="static")
    hoop = world.add(ring(2.0, 1.7), at=(0, 2.0), friction=0.9, angle=0.07)
    ball = world.add(evil.Circle(0.4), at=(0, 2.0))
    for _ in range(300):
        world.step(1 / 60)
    assert ball.position.y == pytest.approx(hoop.position.y - 1.3, abs=0.02)
    assert abs(ball.position.x - hoop.position.x) < 0.15
    assert hoop.position.y == pytest.approx(2.0, abs=0.02)


@pytest.mark.parametrize("rounding", [0.0, 0.05])
def test_what_is_in_the_hole_touches_nothing(rounding: float) -> None:
    world = evil.World(gravity=(0, 0))
    frame = world.add(evil.Polygon(SQUARE, holes=[MIDDLE], rounding=rounding))
    ball = world.add(evil.Circle(0.45), at=(1.5, 1.5))
    for _ in range(10):
        world.step(1 / 60)
    assert not list(world.contacts.active)
    assert tuple(ball.position) == (1.5, 1.5)
    ball.velocity = (3, 0)
    for _ in range(60):
        world.step(1 / 60)
    assert ball.position.x - frame.position.x < 1.6  # the frame was pushed along


def test_queries_see_the_hole() -> None:
    world = evil.World()
    frame = world.add(FRAME, kind="static")
    assert world.bodies_at((1.5, 1.5)) == ()
    assert world.bodies_at((0.5, 1.5)) == (frame,)
    assert world.ray_cast((1.1, 1.1), (1.9, 1.9)) is None
    hit = world.ray_cast((1.5, 1.5), (1.5, -9))
    assert hit is not None
    assert (hit.body, tuple(hit.point), tuple(hit.normal)) == (frame, (1.5, 1.0), (0.0, 1.0))
    nearest = world.nearest((1.5, 1.3))
    assert nearest is not None
    assert nearest.distance == pytest.approx(0.3)
    assert world.overlapping(evil.Circle(0.4), at=(1.5, 1.5)) == ()
    assert world.overlapping(evil.Circle(0.6), at=(1.5, 1.5)) == (frame,)


# Saved


def test_a_restored_world_has_the_holes_and_goes_on_bit_for_bit() -> None:
    def build() -> evil.World:
        world = evil.World()
        world.add(evil.Rectangle(20, 1), at=(0, -0.5), kind="static")
        world.add(ring(2.0, 1.6, 12, rounding=0.02), at=(0, 3), angle=0.3)
        world.add(evil.Circle(0.4), at=(0, 3), velocity=(1, 0))
        return world

    world = build()
    for _ in range(30):
        world.step(1 / 60)
    data = world.snapshot()
    other = evil.World()
    other.restore(data)
    shape = list(other.bodies)[1].shapes[0]
    body = list(world.bodies)[1]
    assert shape.outline == body.shapes[0].outline
    assert len(shape.outline[-1][0]) == 12
    for _ in range(30):
        world.step(1 / 60)
        other.step(1 / 60)
    assert other.checksum() == world.checksum()
    shape.density = body.shapes[0].density = 2.0  # weighed anew from what was restored
    assert shape.body.inertia == body.inertia


# Drawn

WINDOW = evil.Polygon([(-1, -0.8), (1, -0.8), (1, 0.8), (-1, 0.8)], holes=[[(-0.5, -0.5), (0.5, -0.5), (0, 0.5)]])


def test_the_picture_is_open_where_the_hole_is() -> None:
    stage = Stage()
    body = stage.add(WINDOW)
    stage.scene.add(body.shapes[0], colour="red")
    stage.scene.add(WINDOW, at=(0, 9), colour="red")  # by itself; shares the mesh
    assert stage.at(0, 0) == BLACK
    assert stage.at(-0.3, 0.3) == stage.at(0.7, 0) == stage.at(0, 0.6) == stage.at(0, -0.6) == RED
    body.angle = math.pi
    assert stage.at(0, 0) == BLACK
    assert stage.at(0.3, 0.3) == BLACK
    assert stage.at(0.3, -0.4) == RED


def test_the_line_round_a_shape_goes_round_its_holes() -> None:
    stage = Stage()
    drawing = stage.scene.add(WINDOW, colour="red", outline=True)
    assert stage.at(0, -0.5) not in (BLACK, RED)
    assert stage.at(0, -0.65) == RED  # no line joins the hole to the outline
    drawing.outline = False
    assert stage.at(0, -0.52) == RED


def test_the_debug_view_shows_holes() -> None:
    stage = Stage()
    stage.add(WINDOW)
    stage.scene.debug = True
    stage.scene.debug_view.legend = False  # which takes most of so small a picture
    assert stage.at(0.25, 0)[1] > 100 > stage.at(0.6, 0)[1]


def test_colours_and_texture_points_are_one_for_each_corner_those_of_holes_last() -> None:
    stage = Stage()
    stage.scene.add(WINDOW, colours=["red"] * 4 + ["blue"] * 3)
    near, far = stage.at(0, -0.52), stage.at(0, -0.77)
    assert near[2] > 220 > 40 > far[2]
    assert far[0] > 220 > 40 > near[0]
    assert stage.at(0, 0) == BLACK
    with pytest.raises(evil.ArgumentError, match="colours holds 4, but the shape has 7 corners"):
        stage.scene.add(WINDOW, colours=["red"] * 4)
    points = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)] + [(0.25, 0.25)] * 3
    stage.scene.add(WINDOW, texture="halves.png", texture_points=points, layer=1)
    assert stage.at(0.95, 0) != BLACK


def test_a_saved_scene_has_its_holes() -> None:
    stage = Stage()
    stage.scene.add(WINDOW, colour="red", outline=True)
    saved = _core.SavedScene(stage.scene._core.snapshot(stage.world._core)[0])
    expected = bytes(stage.show())
    other = Stage()
    other.scene._core.restore(saved, other.world._core, [], [])
    assert bytes(other.show()) == expected


@pytest.mark.parametrize("angle", [0.0, 0.4])
def test_the_graphics_card_draws_holes_as_soft_does(angle: float) -> None:
    world = evil.World()
    scene = Scene(world, background="black")
    scene.add(ring(1.8, 1.2), at=(-2, 0), colour="orange")
    scene.add(ring(1.8, 0.9), at=(2, 0), colour="orange", outline=True)
    scene.add(WINDOW, at=(-2, 0), angle=angle, colours=["#c06060"] * 4 + ["#6060c0"] * 3)
    scene.add(evil.Polygon(SQUARE, holes=[MIDDLE], rounding=0.3), at=(1, -1), angle=angle, colour="#4060ff")
    frame = scene.collect(Camera((400, 200)), 1.0)
    soft, gl = picture(SoftRenderer(), frame), picture(GlRenderer(any_driver()), frame)
    assert difference(soft, gl) <= 3
