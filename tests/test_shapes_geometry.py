"""Polygons: what is refused, areas and masses, triangles, convex parts, hulls."""

from __future__ import annotations

import contextlib
import math
import random
import time
from collections.abc import Callable
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

import evilengine.values.errors as errors
from evilengine import _core

Corner = tuple[float, float]
Corners = list[Corner]
SQUARE = [(0, 0), (1, 0), (1, 1), (0, 1)]
L_SHAPE = [(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)]


def exact_turn(a: Corner, b: Corner, c: Corner) -> int:
    """-1, 0 or +1 by fractions, which never round."""
    ax, ay, bx, by, cx, cy = map(Fraction, (*a, *b, *c))
    area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
    return (area > 0) - (area < 0)


def exact_area(corners: Corners) -> Fraction:
    pairs = zip(corners, corners[1:] + corners[:1], strict=True)
    return sum((Fraction(a[0]) * Fraction(b[1]) - Fraction(a[1]) * Fraction(b[0]) for a, b in pairs), Fraction(0)) / 2


def segments_meet(
    p: tuple[float, float], q: tuple[float, float], r: tuple[float, float], s: tuple[float, float]
) -> bool:
    if max(p[0], q[0]) < min(r[0], s[0]) or max(r[0], s[0]) < min(p[0], q[0]):
        return False
    if max(p[1], q[1]) < min(r[1], s[1]) or max(r[1], s[1]) < min(p[1], q[1]):
        return False
    return exact_turn(p, q, r) * exact_turn(p, q, s) <= 0 and exact_turn(r, s, p) * exact_turn(r, s, q) <= 0


def is_simple(corners: Corners) -> bool:
    """By comparing every edge with every other, exactly."""
    n = len(corners)
    edges = [(corners[i], corners[(i + 1) % n]) for i in range(n)]
    for i in range(n):
        a, b, c = corners[i], corners[(i + 1) % n], corners[(i + 2) % n]
        if exact_turn(a, b, c) == 0 and (a[0] - b[0]) * (c[0] - b[0]) + (a[1] - b[1]) * (c[1] - b[1]) > 0:
            return False
        for j in range(i + 2, n):
            if (j + 1) % n != i and segments_meet(*edges[i], *edges[j]):
                return False
    return True


def float32(corners: Corners) -> Corners:
    return [(float(np.float32(x)), float(np.float32(y))) for x, y in corners]


def star_shaped(chance: random.Random, n: int, roughness: float = 0.9) -> Corners:
    """A random simple polygon: corners at rising angles round the origin."""
    angles = sorted(chance.uniform(0, 2 * math.pi) for _ in range(n))
    radii = [chance.uniform(1 - roughness, 1) for _ in angles]
    return float32([(r * math.cos(a), r * math.sin(a)) for r, a in zip(radii, angles, strict=True)])


def comb(teeth: int) -> Corners:
    """A straight back and sharp teeth: half the corners are reflex, and the back's lie in one line."""
    top = [(float(i), 3.0 if i % 2 else 1.0) for i in range(2 * teeth, -1, -1)]
    return [(float(i), 0.0) for i in range(2 * teeth + 1)] + top


def spiral(turns: int, n: int) -> Corners:
    """Two arms round each other: hardly any corner sees another."""
    outer = [(math.cos(t) * (1 + t), math.sin(t) * (1 + t)) for t in np.linspace(0, turns * 2 * math.pi, n)]
    inner = [(math.cos(t) * (0.5 + t), math.sin(t) * (0.5 + t)) for t in np.linspace(0, turns * 2 * math.pi, n)]
    return float32(outer + inner[::-1])


@st.composite
def polygons(draw: st.DrawFn) -> Corners:
    """Simple polygons of many kinds, in both directions; those on small integers have straight corners."""
    chance = random.Random(draw(st.integers(0, 2**32)))
    kind = draw(st.sampled_from(["star", "spiky", "integers", "comb", "spiral", "far", "thin"]))
    if kind == "integers":  # random corners on a small grid, untangled by reversing runs until no edges meet
        corners = untangled(chance, draw(st.integers(3, 12)))
    elif kind == "comb":
        corners = comb(draw(st.integers(1, 10)))
    elif kind == "spiral":
        corners = spiral(draw(st.integers(1, 3)), draw(st.integers(20, 60)))
    else:
        corners = star_shaped(chance, draw(st.integers(3, 40)), 0.999 if kind == "spiky" else 0.7)
        if kind == "far":
            corners = float32([(x + 5000, y - 3000) for x, y in corners])
        if kind == "thin":
            corners = float32([(100 * x, 0.01 * y) for x, y in corners])
    assume(_core.polygon_problem(corners) is None)
    return corners[::-1] if draw(st.booleans()) else corners


def untangled(chance: random.Random, n: int) -> Corners:
    corners = list({(float(chance.randrange(6)), float(chance.randrange(6))) for _ in range(n)})
    chance.shuffle(corners)
    for _ in range(60):  # two-opt: where two edges meet, reversing what is between shortens the tour
        m = len(corners)
        crossing = next(
            (
                (i, j)
                for i in range(m)
                for j in range(i + 2, m)
                if (j + 1) % m != i and segments_meet(corners[i], corners[i + 1], corners[j], corners[(j + 1) % m])
            ),
            None,
        )
        if crossing is None:
            break
        i, j = crossing
        corners[i + 1 : j + 1] = corners[i + 1 : j + 1][::-1]
    return corners


# What is refused


@pytest.mark.parametrize(
    ("corners", "words"),
    [
        ([], "0 corners are too few"),
        ([(0, 0), (1, 0)], "2 corners are too few"),
        ([(i, i * i) for i in range(4097)], "4097 corners are too many; at most 4096"),
        ([(0, 0), (math.nan, 0), (0, 1)], "corner 1 (nan, 0) must be finite"),
        ([(0, 0), (1, 0), (0, math.inf)], "corner 2 (0, inf) must be finite"),
        ([(0, 0), (10**400, 0), (0, 1)], "corner 1 (inf, 0) must be finite"),
        ([(0, 0), (100001, 0), (0, 1)], "corner 1 (100001, 0) is too far out"),
        ([(0, 0), (1, 0), (0, 1), (0, 0)], "corners 0 (0, 0) and 3 (0, 0) are nearer than"),
        ([(0, 0), (1, 0), (0.5, 0.5), (1, 1), (0, 1), (0.5, 0.5)], "corners 2 (0.5, 0.5) and 5 (0.5, 0.5)"),
        ([(0, 0), (1, 0), (1, 1e-6), (0, 1)], "nearer than 1e-05 metres"),
        ([(0, 0), (1, 1), (2, 2)], "lie in one line"),
        ([(0, 0), (1, 0), (0, 1), (1, 1)], "edges 1-2 and 3-0 cross or touch"),
        ([(0, 0), (2, 0), (1, 0), (1, 1)], "edges 0-1 and 1-2 cross or touch"),
        ([(0, 0), (2, 0), (2, 2), (1, 0), (0, 2)], "edges 0-1 and 3-4 cross or touch"),
        ([(0, 0), (1000, 0), (500, 5e-6)], "lie in one line, or nearly"),
    ],
)
def test_a_polygon_that_cannot_be_is_described(corners: Corners, words: str) -> None:
    problem = _core.polygon_problem(corners)
    assert problem is not None
    assert words in problem
    for use in (_core.triangulate, _core.split_convex):
        with pytest.raises(errors.ShapeError) as caught:
            use(corners)
        assert words in str(caught.value)


@pytest.mark.parametrize("corners", [SQUARE, SQUARE[::-1], L_SHAPE, [(0, 0), (1, 0), (2, 0), (2, 1)], comb(5)])
def test_a_good_polygon_is_not_refused(corners: Corners) -> None:
    assert _core.polygon_problem(corners) is None


@pytest.mark.parametrize(
    "points", [None, 3, "corners", b"corners", {1: 2}, [1, 2, 3], [(0, 0), (1, 0), (1,)], [(0, 0), "ab", (1, 1)]]
)
def test_what_is_no_list_of_points_is_a_type_error(points: object) -> None:
    with pytest.raises(errors.ArgumentTypeError, match="points"):
        _core.polygon_problem(points)


@given(st.integers(0, 2**32), st.integers(3, 9))
def test_crossings_are_found_exactly_as_by_comparing_every_edge(seed: int, n: int) -> None:
    chance = random.Random(seed)
    corners = list({(float(chance.randrange(5)), float(chance.randrange(5))) for _ in range(n)})
    chance.shuffle(corners)
    assume(len(corners) >= 3)
    assert (_core.polygon_problem(corners) is None) == is_simple(corners)


def test_a_corner_one_unit_in_the_last_place_short_of_an_edge_is_told_from_one_on_it_or_past_it() -> None:
    chance = random.Random(7)
    answers = set()
    for _ in range(200):
        (ax, ay), (bx, by) = a, b = float32(
            [(chance.uniform(-3, -2), chance.uniform(-3, -2)), (2.0 + chance.random(), 3.0)]
        )
        t = chance.random()
        ((x, y),) = float32([(ax + t * (bx - ax), ay + t * (by - ay))])
        for steps in range(-2, 3):
            tip = (x, y + steps * float(np.spacing(np.float32(y))))
            corners = [a, (9.0, -3.0), (9.0, 0.0), tip, (9.0, 1.0), b]
            answers.add(_core.polygon_problem(corners) is None)
            assert (_core.polygon_problem(corners) is None) == is_simple(corners)
    assert answers == {True, False}


# Triangles


@settings(max_examples=200)
@given(polygons())
def test_triangles_fill_the_polygon_without_new_corners(corners: Corners) -> None:
    triangles = _core.triangulate(corners)
    assert len(triangles) == len(corners) - 2
    assert all(0 <= i < len(corners) for triangle in triangles for i in triangle)
    areas = [exact_area([corners[i] for i in triangle]) for triangle in triangles]
    assert min(areas) > 0  # counter-clockwise, and none without area
    assert sum(areas) == abs(exact_area(corners))  # with the right sum, positive triangles cannot overlap
    edges = [frozenset((t[k], t[(k + 1) % 3])) for t in triangles for k in range(3)]
    n = len(corners)
    outline = {frozenset((i, (i + 1) % n)) for i in range(n)}
    assert all(edges.count(edge) == (1 if edge in outline else 2) for edge in edges)


def test_straight_corners_get_triangles_too() -> None:
    corners = [(0, 0), (1, 0), (2, 0), (3, 0), (0, 3)]
    areas = [float(exact_area([corners[i] for i in t])) for t in _core.triangulate(corners)]
    assert sorted(areas) == [1.5, 1.5, 1.5]


@given(st.lists(st.tuples(st.floats(-10, 10, width=32), st.floats(-10, 10, width=32)), max_size=12))
def test_any_points_are_either_triangulated_or_refused(corners: Corners) -> None:
    if _core.polygon_problem(corners) is None:
        assert len(_core.triangulate(corners)) == len(corners) - 2
    else:
        with pytest.raises(errors.ShapeError):
            _core.triangulate(corners)


@given(
    st.lists(
        st.one_of(
            st.none(), st.text(max_size=3), st.tuples(st.floats(), st.floats()), st.lists(st.floats(), max_size=3)
        ),
        max_size=6,
    )
)
@pytest.mark.parametrize("function", [_core.polygon_problem, _core.signed_area, _core.polygon_mass, _core.is_convex])
def test_nothing_that_looks_like_points_crashes(function: Callable[[object], object], points: object) -> None:
    with contextlib.suppress(errors.Error):
        function(points)


@pytest.mark.parametrize(
    "make", [lambda: comb(1023), lambda: spiral(6, 2048), lambda: star_shaped(random.Random(1), 4096)]
)
def test_the_largest_polygons_take_a_blink(make: Callable[[], Corners]) -> None:
    corners = make()
    start = time.perf_counter()
    problem = _core.polygon_problem(corners)
    assert time.perf_counter() - start < 1.0
    if problem is None:
        start = time.perf_counter()
        assert len(_core.triangulate(corners)) == len(corners) - 2
        assert len(_core.split_convex(corners)) >= 1
        assert time.perf_counter() - start < 2.0


# Convex parts


@settings(max_examples=200)
@given(polygons())
def test_parts_are_convex_and_fill_the_polygon_without_new_corners(corners: Corners) -> None:
    parts = _core.split_convex(corners)
    total = Fraction(0)
    for part in parts:
        shape = [corners[i] for i in part]
        assert len(set(part)) == len(part) >= 3
        turns = [exact_turn(shape[k - 2], shape[k - 1], shape[k]) for k in range(len(shape))]
        assert turns == [1] * len(turns)  # convex, counter-clockwise, and no corner for nothing
        total += exact_area(shape)
    assert total == abs(exact_area(corners))
    ordered = corners if exact_area(corners) > 0 else corners[::-1]
    reflex = sum(exact_turn(ordered[k - 2], ordered[k - 1], ordered[k]) < 0 for k in range(len(ordered)))
    assert (reflex + 1) // 2 + 1 <= len(parts) <= 2 * reflex + 1 or (reflex == 0 and len(parts) == 1)


def test_a_convex_polygon_stays_whole_and_loses_its_straight_corners() -> None:
    assert _core.split_convex([(0, 0), (1, 0), (2, 0), (2, 1), (0, 1)]) in (
        [[0, 2, 3, 4]],
        [[2, 3, 4, 0]],
        [[3, 4, 0, 2]],
        [[4, 0, 2, 3]],
    )


@pytest.mark.parametrize(
    ("corners", "fewest"),
    [
        (L_SHAPE, 2),
        ([(1, 0), (2, 0), (2, 1), (3, 1), (3, 2), (2, 2), (2, 3), (1, 3), (1, 2), (0, 2), (0, 1), (1, 1)], 3),  # a plus
        ([(0, 0), (3, 0), (3, 1), (2, 1), (2, 2), (1, 2), (1, 1), (0, 1)], 2),  # a T upside down
        ([(0, 0), (4, 0), (2, 1)], 1),
        ([(0, 0), (2, 1), (4, 0), (2, 4)], 2),  # an arrow head
    ],
)
def test_well_known_shapes_split_into_as_few_parts_as_can_be(corners: Corners, fewest: int) -> None:
    assert len(_core.split_convex(corners)) == fewest


def test_convexity_is_told_either_way_round() -> None:
    assert _core.is_convex(SQUARE)
    assert _core.is_convex(SQUARE[::-1])
    assert _core.is_convex([(0, 0), (1, 0), (2, 0), (2, 1)])
    assert not _core.is_convex(L_SHAPE)
    assert not _core.is_convex(L_SHAPE[::-1])


# Area and mass


@given(polygons())
def test_areas_are_exact_to_a_rounding(corners: Corners) -> None:
    assert _core.signed_area(corners) == pytest.approx(float(exact_area(corners)), rel=1e-9)
    assert _core.signed_area(corners[::-1]) == pytest.approx(-_core.signed_area(corners), rel=1e-9)


def test_masses_of_simple_shapes_are_those_of_the_textbook() -> None:
    assert _core.circle_mass(2.0, 3.0)[:2] == pytest.approx((12 * math.pi, 24 * math.pi))
    mass, inertia, centre = _core.polygon_mass([(1, 1), (5, 1), (5, 4), (1, 4)], 2.0)  # (w^2 + h^2) m / 12
    assert (mass, inertia) == pytest.approx((24.0, 24.0 * (16 + 9) / 12))
    assert centre == (3.0, 2.5)
    mass, inertia, centre = _core.polygon_mass([(0, 0), (3, 0), (0, 6)])  # m (a^2 + b^2) / 18 for a right triangle
    assert (mass, inertia) == pytest.approx((9.0, 9.0 * (9 + 36) / 18))
    assert centre == (1.0, 2.0)


@given(polygons())
def test_a_polygon_weighs_as_much_as_its_parts(corners: Corners) -> None:
    mass, inertia, centre = _core.polygon_mass(corners, 1.5)
    parts = [_core.polygon_mass([corners[i] for i in part], 1.5) for part in _core.split_convex(corners)]
    size = max(max(abs(x - centre[0]), abs(y - centre[1])) for x, y in corners)
    rounding = 4e-7 * (size + max(abs(centre[0]), abs(centre[1])))  # the centres are floats
    assert sum(p[0] for p in parts) == pytest.approx(mass, rel=1e-9)
    for axis in (0, 1):
        assert sum(p[0] * p[2][axis] for p in parts) / mass == pytest.approx(centre[axis], abs=rounding)
    about_centre = sum(p[1] + p[0] * ((p[2][0] - centre[0]) ** 2 + (p[2][1] - centre[1]) ** 2) for p in parts)
    assert about_centre == pytest.approx(inertia, rel=1e-5, abs=mass * rounding * size)


def test_mass_does_not_depend_on_where_the_polygon_lies() -> None:
    far = [(x + 65536, y - 32768) for x, y in L_SHAPE]
    near_mass, near_inertia, near_centre = _core.polygon_mass(L_SHAPE)
    mass, inertia, centre = _core.polygon_mass(far)
    assert (mass, inertia) == pytest.approx((near_mass, near_inertia), rel=1e-12)
    assert centre == pytest.approx((near_centre[0] + 65536, near_centre[1] - 32768), abs=0.01)


# Hull


@given(st.lists(st.tuples(st.integers(-6, 6), st.integers(-6, 6)), max_size=20))
def test_the_hull_holds_every_point_and_turns_left_everywhere(points: list[tuple[int, int]]) -> None:
    hull = [points[i] for i in _core.convex_hull(points)]
    assert set(hull) <= set(points)
    assert len(set(hull)) == len(hull)
    if len(hull) < 3:  # all in one place or line
        assert len({exact_turn(hull[0], hull[-1], p) for p in points} - {0}) == 0 if points else hull == []
        return
    for k in range(len(hull)):
        a, b = hull[k - 1], hull[k]
        assert exact_turn(hull[k - 2], a, b) == 1
        assert all(exact_turn(a, b, p) >= 0 for p in points)


def test_the_hull_of_a_line_is_its_ends() -> None:
    assert _core.convex_hull([(1, 1), (3, 3), (2, 2), (0, 0)]) == [3, 1]
