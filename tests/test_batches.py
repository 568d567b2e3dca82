"""Draw lists as quads in few draw calls: what a graphics card is given, without one."""

from __future__ import annotations

import math

import numpy as np
import pytest
from drawing import BLUE, GREEN, RED, WHITE, Points, place, star
from hypothesis import given, settings
from hypothesis import strategies as st

import evilengine as evil
from evilengine import _core
from evilengine.renderer.gl.pipeline import INSTANCE, MIXES, ROW, SPRITE
from evilengine.values.errors import ArgumentError

SQUARE: Points = [(-8, -8), (8, -8), (8, 8), (-8, 8)]
SIZE = (640, 480)
EDGES, PIXEL_EDGES = 1, 2

Batch = tuple[int, int, tuple[int, ...], bool]


def words(batcher: _core.Batcher) -> np.ndarray:
    return np.frombuffer(batcher.quads, np.uint32).reshape(-1, INSTANCE.stride // 4)


def texels(batcher: _core.Batcher) -> np.ndarray:
    both = bytes(batcher.shapes) + bytes(batcher.edges)
    return np.frombuffer(both, np.float32).reshape(-1, 4)


def textured(textures: list[int], batcher: _core.Batcher) -> list[Batch]:
    content = _core.DrawList()
    square = content.polygon(SQUARE)
    for number, texture in enumerate(textures):
        content.instance(square, place(20 + number % 30 * 20, 20), texture=texture)
    return batcher.collect(content, *SIZE)


def test_what_blends_otherwise_is_a_draw_call_of_its_own_and_what_adds_is_not() -> None:
    batcher, content = _core.Batcher(), _core.DrawList()
    square = content.polygon([(0, 0), (4, 0), (4, 4), (0, 4)])
    for blend in (0, 1, 0, 2, 2, 3, 1):
        content.instance(square, blend=blend)
    batches = batcher.collect(content, 64, 64)
    assert [(first, count, look // 2) for first, count, _, look in batches] == [
        (0, 3, 0),
        (3, 2, 2),
        (5, 1, 3),
        (6, 1, 0),
    ]
    with pytest.raises(evil.ArgumentError, match="blend must be"):
        content.instance(square, blend=4)


def test_things_of_one_texture_are_one_draw_call() -> None:
    batcher = _core.Batcher()
    crate = batcher.hold()
    assert textured([crate] * 500, batcher) == [(0, 500, (crate,), 0)]


def test_what_has_no_texture_goes_along_with_what_has_one() -> None:
    batcher = _core.Batcher()
    crate = batcher.hold()
    assert textured([0, crate, 0, crate, 0], batcher) == [(0, 5, (crate,), 0)]
    assert textured([0, 0], batcher) == [(0, 2, (), 0)]


def test_a_draw_call_mixes_eight_textures_in_any_order_and_the_ninth_begins_another() -> None:
    batcher = _core.Batcher()
    held = [batcher.hold() for _ in range(MIXES[-1] + 1)]
    assert textured(held[:-1] * 3, batcher) == [(0, 24, tuple(held[:-1]), 0)]
    assert textured(held + held[:1], batcher) == [
        (0, 8, tuple(held[:8]), 0),
        (8, 2, (held[8], held[0]), 0),
    ]


def test_a_texture_that_was_dropped_or_never_was_is_not_drawn_with() -> None:
    batcher = _core.Batcher()
    crate = batcher.hold()
    batcher.drop(crate)
    assert textured([crate, 7, 4_000_000_000], batcher) == [(0, 3, (), 0)]
    with pytest.raises(ArgumentError, match=f"texture={crate} is not one"):
        batcher.drop(crate)
    assert batcher.hold() != crate


def test_what_lies_outside_the_picture_or_is_clear_costs_nothing() -> None:
    batcher, content = _core.Batcher(), _core.DrawList()
    square, disc = content.polygon(SQUARE), content.circle(8.0)
    for mesh in (square, disc):
        for x, y in ((-9, 100), (649, 100), (100, -9), (100, 489), (math.nan, 5), (5, math.inf), (3e38, 3e38)):
            content.instance(mesh, (1, 0, 0, 1, x, y))
            content.instance(mesh, (0.5, 0, 0, 0.5, x, y), outline=1.0)
        content.instance(mesh, place(100, 100), tint=0x00FFFFFF)
        content.instance(mesh, place(100, 100), outline=math.nan)
    assert batcher.collect(content, *SIZE) == []
    assert len(batcher.quads) == 0


def test_meshes_go_to_the_card_again_only_when_they_change() -> None:
    batcher, content = _core.Batcher(), _core.DrawList()
    square = content.polygon(SQUARE)
    content.instance(square, place(50, 50))
    batcher.collect(content, *SIZE)
    first = batcher.revision
    content.instance(square, place(90, 50), outline=2.0, tint=RED)
    batcher.collect(content, *SIZE)
    assert batcher.revision == first, "more instances are no reason"

    same = _core.DrawList()
    same.instance(same.polygon(SQUARE), place(10, 10))
    batcher.collect(same, *SIZE)
    assert batcher.revision == first, "nor is another list with the same meshes"

    content.circle(4.0)
    batcher.collect(content, *SIZE)
    assert batcher.revision > first


def test_memory_that_somebody_looks_at_stays_as_it_is() -> None:
    batcher, content = _core.Batcher(), _core.DrawList()
    content.instance(content.polygon(SQUARE), place(50, 50))
    batcher.collect(content, *SIZE)
    views = [memoryview(data) for data in (batcher.quads, batcher.shapes)]
    before = [bytes(view) for view in views]
    for _ in range(3):
        for number in range(300):
            content.instance(content.polygon(star(3 + number % 5, 9, 4)), place(number, 60))
        batcher.collect(content, *SIZE)
    assert [bytes(view) for view in views] == before
    assert views[0].readonly


def test_an_intricate_shape_that_is_large_is_cut_into_cells_with_few_edges_each() -> None:
    batcher, content = _core.Batcher(), _core.DrawList()
    content.instance(content.polygon(star(400, 230, 200)), place(320, 240))
    batcher.collect(content, *SIZE)
    quads = words(batcher)
    assert len(quads) > 50
    assert quads[:, 21].max() < 100, "of the 800 edges"
    content.clear()
    content.instance(content.polygon(star(400, 12, 10)), place(320, 240))
    batcher.collect(content, *SIZE)
    (small,) = words(batcher)
    assert (small[23] & 15, small[21]) == (EDGES, 800)


def test_facets_are_for_colours_and_texture_coordinates_that_differ_from_triangle_to_triangle() -> None:
    for colours, uvs, expected in (
        (None, None, False),
        (None, [(0, 0), (2, 0), (2, 1), (0, 1)], False),
        (None, [(0, 0), (2, 0), (1, 1), (0, 1)], True),
        ([RED, GREEN, BLUE, WHITE], None, True),
    ):
        batcher, content = _core.Batcher(), _core.DrawList()
        content.instance(content.polygon(SQUARE, colours=colours, uvs=uvs), place(50, 50))
        assert [batch[3] for batch in batcher.collect(content, *SIZE)] == [expected], (colours, uvs)


EXTREMES = [0.0, -0.0, 1e-30, 1e-7, 0.3, -1.0, 17.5, 1e4, -3e9, 1e20, 3e38, math.inf, -math.inf, math.nan]
number = st.one_of(st.sampled_from(EXTREMES), st.floats(width=32), st.floats(-100, 100, width=32))
matrix = st.tuples(number, number, number, number, number, number)
finite = st.floats(-1e6, 1e6, width=32)
colour = st.integers(0, 0xFFFFFFFF)


@settings(max_examples=200, deadline=None)
@given(
    points=st.lists(st.tuples(finite, finite), min_size=3, max_size=40),
    colours=st.lists(colour, min_size=40, max_size=40),
    radius=st.floats(0, 1e9, width=32),
    uses=st.lists(st.tuples(st.integers(0, 3), matrix, matrix, number, st.integers(0, 2), colour), max_size=6),
    size=st.tuples(st.integers(1, 700), st.integers(1, 400)),
)
def test_whatever_is_drawn_every_quad_names_texels_that_there_are(
    points: Points,
    colours: list[int],
    radius: float,
    uses: list[tuple[int, tuple[float, ...], tuple[float, ...], float, int, int]],
    size: tuple[int, int],
) -> None:
    batcher, content = _core.Batcher(), _core.DrawList()
    batcher.hold()
    meshes = [
        content.polygon(points),
        content.polygon(points, colours=colours[: len(points)]),
        content.circle(radius),
        content.polygon(points, triangles=[0, 1, 2, 2, 1, 0, 0, 0, 0], colours=colours[: len(points)]),
    ]
    for mesh, to_pixel, to_texture, outline, texture, tint in uses:
        content.instance(meshes[mesh], to_pixel, tint=tint, texture=texture, outline=outline, to_texture=to_texture)
    batches = batcher.collect(content, *size)
    quads, shapes, edges = words(batcher), len(batcher.shapes) // 16, len(batcher.edges) // 16
    assert [first for first, *_ in batches] == [0, *np.cumsum([count for _, count, *_ in batches])[:-1]][: len(batches)]
    assert sum(count for _, count, *_ in batches) == len(quads)
    assert shapes % ROW == edges % ROW == 0
    for quad in quads:
        first, count, facet, how = (int(word) for word in quad[20:24])
        if how & 15 == EDGES:
            assert first + count <= shapes
        elif how & 15 == PIXEL_EDGES:
            assert shapes <= first <= first + count <= shapes + edges
            assert np.isfinite(texels(batcher)[first : first + count]).all()
        assert facet + 10 * (how >> 16) <= shapes


# ---- sprites ----

WEIRD = st.sampled_from([0.0, 1.0, -1.0, 20.0, 1e-30, 3e38, -3e38, math.nan, math.inf])


@settings(deadline=None, max_examples=60)
@given(st.lists(st.tuples(*[WEIRD] * 6), min_size=1, max_size=8), st.lists(st.tuples(*[WEIRD] * 6), max_size=4))
def test_no_matrix_gets_a_number_into_a_sprite_that_is_none(
    matrices: list[tuple[float, ...]], textures: list[tuple[float, ...]]
) -> None:
    batcher, content = _core.Batcher(), _core.DrawList()
    picture = batcher.hold()
    for texture in (0, picture):
        batcher.place(texture, 0, [(2, 2, 16, 16, 1, 1, 15, 15, 1), (22, 2, 8, 8, 0, 0, 8, 8, 0)])
    square = content.polygon([(0, 0), (1, 0), (1, 1), (0, 1)], uvs=[(0, 0), (1, 0), (1, 1), (0, 1)])
    for number in range(40):
        content.instance(square, place(100 + number, 100, 12.0, 0.1 * number), texture=picture)
        if number % 20 == 0:
            for matrix in matrices:
                content.instance(square, matrix, texture=picture)
            for matrix in textures:
                content.instance(square, place(50, 50, 9.0), texture=picture, to_texture=matrix)
    batches = batcher.collect(content, *SIZE)
    rows = np.frombuffer(batcher.sprites, np.float32).reshape(-1, SPRITE.stride // 4)
    assert np.isfinite(rows[:, :16]).all()
    assert len(rows) == sum(batch[2] for batch in batches if batch[0] == "sprites")
    assert len(rows) > 0


def test_a_place_for_a_picture_that_nobody_holds_is_refused() -> None:
    with pytest.raises(ArgumentError, match=r"Batcher\.place: texture=1 was never held"):
        _core.Batcher().place(1, 0, [])
