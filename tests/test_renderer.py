"""The software renderer bears whatever comes, gives the same bits everywhere, and keeps its promises to Python."""

from __future__ import annotations

import math
import random
from collections.abc import Callable

import pytest
from drawing import (
    BLACK,
    BLUE,
    GREEN,
    RED,
    Points,
    coverage,
    picture,
    place,
    sprite,
    star,
)
from hypothesis import given, settings
from hypothesis import strategies as st

from evilengine import _core
from evilengine.renderer import open_renderer
from evilengine.renderer.soft import SoftRenderer
from evilengine.values.drawlist import DrawList
from evilengine.values.errors import ArgumentError, ArgumentTypeError

SETS = ("plain", "base", "sse2", "avx2")


# ---- whatever comes ----


def zoo(seed: int) -> tuple[_core.DrawList, _core.Raster]:
    """Everything at once: fills, strokes, ramps, textures, at all sizes and places."""
    rnd, raster, content = random.Random(seed), _core.Raster(), _core.DrawList()
    texture = raster.upload(sprite(seed, 13, 9).tobytes(), 13, 9)
    ring = star(4, 9, 4)
    meshes = [
        content.circle(5.0, colour=0xFF80C0FF),
        content.polygon(ring),
        content.polygon(ring, colours=[RED, GREEN, BLUE, 0x40FFFFFF] * 2),
        content.polygon([(-8, -8), (8, -8), (8, 8), (-8, 8)], uvs=[(0, 0), (2, 0), (2, 1), (0, 1)]),
    ]
    for _ in range(60):
        content.instance(
            rnd.choice(meshes),
            place(
                rnd.uniform(-10, 130), rnd.uniform(-10, 100), rnd.choice([0.05, 0.6, 1.0, 2.5, 40]), rnd.uniform(0, 6)
            ),
            tint=rnd.randrange(1 << 32),
            texture=rnd.choice([0, texture]),
            outline=rnd.choice([0.0, 0.0, 0.0, 0.7, 3.0]),
            to_texture=place(rnd.uniform(-2, 2), rnd.uniform(-2, 2), rnd.choice([0.3, 1.0, 7.0]), rnd.uniform(0, 6)),
        )
    return content, raster


def test_every_instruction_set_gives_the_same_bits() -> None:
    ran = []
    for seed in range(8):
        content, raster = zoo(seed)
        expected = picture(content, (123, 91), raster)
        for instructions in SETS:
            try:
                found = picture(content, (123, 91), raster, instructions=instructions)
            except ArgumentError:
                continue  # not of this machine
            ran.append(instructions)
            assert (found == expected).all(), (seed, instructions)
    assert ran


def test_drawing_twice_gives_the_same_picture() -> None:
    content, raster = zoo(9)
    assert (picture(content, (123, 91), raster) == picture(content, (123, 91), raster)).all()


EXTREMES = [0.0, -0.0, 1e-30, 1e-7, 0.3, -1.0, 17.5, 1e4, -3e9, 1e20, 3e38, math.inf, -math.inf, math.nan]
number = st.one_of(st.sampled_from(EXTREMES), st.floats(width=32), st.floats(-100, 100, width=32))
matrix = st.tuples(number, number, number, number, number, number)
finite = st.floats(-1e6, 1e6, width=32)


@settings(max_examples=150, deadline=None)
@given(
    points=st.lists(st.tuples(finite, finite), min_size=3, max_size=9),
    colours=st.lists(st.integers(0, 0xFFFFFFFF), min_size=9, max_size=9),
    radius=st.floats(0, 1e9, width=32),
    uses=st.lists(
        st.tuples(st.integers(0, 3), matrix, matrix, number, st.integers(0, 2), st.integers(0, 0xFFFFFFFF)), max_size=6
    ),
    size=st.tuples(st.integers(1, 70), st.integers(1, 40)),
)
def test_nothing_that_is_drawn_can_crash(
    points: Points,
    colours: list[int],
    radius: float,
    uses: list[tuple[int, tuple[float, ...], tuple[float, ...], float, int, int]],
    size: tuple[int, int],
) -> None:
    raster, content = _core.Raster(), _core.DrawList()
    raster.upload(sprite(0, 5, 3).tobytes(), 5, 3)
    meshes = [
        content.polygon(points),
        content.polygon(points, colours=colours[: len(points)]),
        content.circle(radius),
        content.polygon(points, triangles=[0, 1, 2, 2, 1, 0, 0, 0, 0], colours=colours[: len(points)]),
    ]
    for mesh, to_pixel, to_texture, outline, texture, tint in uses:
        content.instance(meshes[mesh], to_pixel, tint=tint, texture=texture, outline=outline, to_texture=to_texture)
    first = picture(content, size, raster)
    assert (first[..., 3] == 255).all()
    assert (first == picture(content, size, raster)).all()


@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf, 3e38])
def test_an_instance_whose_place_is_no_number_draws_nothing(value: float) -> None:
    content = _core.DrawList()
    mesh = content.polygon([(0, 0), (9, 0), (9, 9)])
    content.instance(mesh, (1, 0, 0, 1, value, 0))
    content.instance(content.circle(3.0), (1, 0, 0, 1, value, 0), outline=2.0)
    content.instance(mesh, (1, 0, 0, 1, 3, 3), outline=math.nan)
    assert coverage(content, (16, 16)).sum() == 0


def test_a_shape_far_larger_than_the_target_fills_it() -> None:
    content = _core.DrawList()
    content.instance(content.circle(1e7), place(16, 16))
    assert (coverage(content, (32, 32)) == 255).all()
    content.clear()
    content.instance(content.polygon([(-1e9, -1e9), (1e9, -1e9), (1e9, 1e9), (-1e9, 1e9)]))
    assert (coverage(content, (32, 32)) == 255).all()


def test_a_shape_smaller_than_a_pixel_covers_its_share() -> None:
    content = _core.DrawList()
    content.instance(content.circle(0.25), place(4.5, 4.5))
    found = coverage(content, (9, 9))
    assert found.sum() == found[4, 4] == pytest.approx(255 * math.pi / 16, abs=2)


@pytest.mark.parametrize("make", [
    lambda content: content.polygon([(0, 0), (1, 0)]),
    lambda content: content.polygon([(0, 0), (1, 0), (0, math.nan)]),
    lambda content: content.polygon([(0, 0), (1, 0), (0, 1)], uvs=[(0, 0)]),
    lambda content: content.polygon([(0, 0), (1, 0), (0, 1)], colours=[1, 2, -3]),
    lambda content: content.polygon([(0, 0), (1, 0), (0, 1)], colours=[1, 2, 1 << 32]),
    lambda content: content.polygon([(0, 0), (1, 0), (0, 1)], triangles=[0, 1, 3]),
    lambda content: content.polygon([(0, 0), (1, 0), (0, 1)], triangles=[0, 1]),
    lambda content: content.circle(-1.0),
    lambda content: content.circle(math.inf),
    lambda content: content.instance(0),
    lambda content: content.instance(content.circle(1.0), (1, 0, 0)),
])  # fmt: skip
def test_a_draw_list_refuses_what_does_not_fit_and_stays_as_it_was(make: Callable[[_core.DrawList], object]) -> None:
    content = _core.DrawList()
    with pytest.raises((ArgumentError, ArgumentTypeError)):
        make(content)
    assert (content.instance_count, content.vertex_count) in {(0, 0), (0, 1)}


def test_a_mesh_of_before_a_clear_is_refused() -> None:
    content = _core.DrawList()
    mesh = content.circle(1.0)
    content.clear()
    with pytest.raises(ArgumentError, match="since the last clear"):
        content.instance(mesh)


def test_pixels_of_the_wrong_size_are_refused() -> None:
    raster, content = _core.Raster(), _core.DrawList()
    for pixels, width, height in ((bytearray(63), 4, 4), (bytearray(0), 0, 4), (bytearray(4), -1, -1)):
        with pytest.raises(ArgumentError):
            raster.draw(content, pixels, width, height)
    with pytest.raises(ArgumentTypeError, match="writable"):
        raster.draw(content, bytes(64), 4, 4)
    with pytest.raises(ArgumentError):
        raster.upload(bytes(4), 2, 2)


# ---- the renderer ----


def test_pixels_show_the_last_frame_and_old_views_survive_a_new_size() -> None:
    renderer, content = SoftRenderer(), _core.DrawList()
    renderer.draw(DrawList((8, 4), RED, content))
    small = renderer.pixels
    assert small.shape == (4, 8, 4)
    assert small.readonly
    renderer.draw(DrawList((16, 9), GREEN, content))
    assert renderer.pixels.shape == (9, 16, 4)
    assert bytes(small[0, 0, c] for c in range(4)) == b"\xff\0\0\xff"


def test_a_capture_stays_while_drawing_goes_on() -> None:
    renderer, content = SoftRenderer(), _core.DrawList()
    renderer.draw(DrawList((8, 4), RED, content))
    captured = renderer.capture()
    renderer.draw(DrawList((8, 4), GREEN, content))
    assert captured.tobytes() == b"\xff\0\0\xff" * 32


@pytest.mark.parametrize("size", [(0, 5), (5, -1), (100_000, 5)])
def test_a_target_of_impossible_size_is_refused(size: tuple[int, int]) -> None:
    with pytest.raises(ArgumentError, match=r"DrawList\.size"):
        SoftRenderer().draw(DrawList(size, BLACK, _core.DrawList()))


def test_open_renderer_knows_its_names() -> None:
    assert isinstance(open_renderer("soft"), SoftRenderer)
    assert open_renderer("auto").name in ("gl", "soft")
    with pytest.raises(ArgumentError, match="did you mean 'soft'"):
        open_renderer("sotf")
