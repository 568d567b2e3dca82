"""Coverage, strokes and colours of the software renderer, against exact geometry."""

from __future__ import annotations

import math
import random

import numpy as np
import numpy.typing as npt
import pytest
from drawing import (
    BLACK,
    BLUE,
    GREEN,
    RED,
    WHITE,
    Cover,
    Points,
    coverage,
    filled,
    picture,
    place,
    star,
)

from evilengine import _core
from evilengine.renderer.soft import SoftRenderer
from evilengine.values.drawlist import DrawList


def exact_coverage(points: Points, size: tuple[int, int]) -> npt.NDArray[np.float64]:
    """Area of the polygon inside each pixel, by cutting it to the pixel (Sutherland and Hodgman 1974)."""

    def cut(polygon: Points, axis: int, at: float, keep_above: bool) -> Points:
        result: Points = []
        for a, b in zip(polygon, polygon[1:] + polygon[:1], strict=True):
            inside_a, inside_b = ((p[axis] >= at) == keep_above or p[axis] == at for p in (a, b))
            if inside_a:
                result.append(a)
            if inside_a != inside_b:
                t = (at - a[axis]) / (b[axis] - a[axis])
                result.append((a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])))
        return result

    areas = np.zeros((size[1], size[0]))
    for y in range(size[1]):
        row = cut(cut(points, 1, y, True), 1, y + 1, False)
        for x in range(size[0]):
            piece = cut(cut(row, 0, x, True), 0, x + 1, False) if row else []
            pairs = zip(piece, piece[1:] + piece[:1], strict=True)
            areas[y, x] = abs(sum(a[0] * b[1] - a[1] * b[0] for a, b in pairs)) / 2
    return areas


# ---- coverage ----


@pytest.mark.parametrize("seed", range(12))
def test_a_triangle_covers_each_pixel_by_the_exact_area(seed: int) -> None:
    rnd = random.Random(seed)
    points = [(rnd.randrange(20 * 256) / 256, rnd.randrange(14 * 256) / 256) for _ in range(3)]
    expected = 255 * exact_coverage(points, (20, 14))
    assert np.abs(filled(points, (20, 14)) - expected).max() <= 1.5


@pytest.mark.parametrize("points", [
    [(1.5, 1.25), (18.75, 2.5), (17.25, 12.5), (9.5, 4.75), (3.25, 12.75)],  # a concave one
    [(2.0, 3.0), (18.0, 3.0), (18.0, 11.0), (2.0, 11.0)],  # on the edges of pixels
    [(3.3125, 3.40625), (3.5, 3.40625), (3.5, 3.5), (3.3125, 3.5)],  # within one pixel
    [(0.0, 6.0), (20.0, 6.0078125), (20.0, 6.0234375), (0.0, 6.015625)],  # thin and nearly level
])  # fmt: skip
def test_polygons_of_all_kinds_cover_the_exact_area(points: Points) -> None:
    assert np.abs(filled(points, (20, 14)) - 255 * exact_coverage(points, (20, 14))).max() <= 1.5


def test_winding_the_other_way_makes_no_difference() -> None:
    points = [(1.3, 2.2), (17.9, 4.1), (8.2, 12.6)]
    assert (filled(points, (20, 14)) == filled(points[::-1], (20, 14))).all()


@pytest.mark.parametrize("radius", [0.4, 1.0, 2.5, 7.0, 30.0, 90.0])
def test_a_circle_has_its_area_and_its_symmetry(radius: float) -> None:
    side = 2 * math.ceil(radius) + 4
    content = _core.DrawList()
    content.instance(content.circle(radius), place(side / 2, side / 2))
    found = coverage(content, (side, side))
    assert found.sum() / 255 == pytest.approx(math.pi * radius * radius, rel=0.002, abs=0.02)
    for other in (found[::-1], found[:, ::-1], found.T):
        assert np.abs(found - other).max() <= 2


def test_a_circles_edge_lies_on_the_circle_to_a_fiftieth_of_a_pixel() -> None:
    radius = 400.0
    content = _core.DrawList()
    content.instance(content.circle(radius), place(-200, 32))
    row = coverage(content, (256, 64))[30:34] / 255  # nearly upright there: the covered width is where the edge lies
    for y, found in zip(range(30, 34), row.sum(axis=1), strict=True):
        assert found == pytest.approx(math.sqrt(radius**2 - (y + 0.5 - 32) ** 2) - 200, abs=0.03)


def test_an_ellipse_has_its_area() -> None:
    content = _core.DrawList()
    content.instance(content.circle(1.0), (20, 5, -4, 9, 32, 32))
    assert coverage(content, (64, 64)).sum() / 255 == pytest.approx(math.pi * (20 * 9 + 5 * 4), rel=0.002)


def test_moving_by_whole_pixels_moves_the_picture() -> None:
    def draw(x: float, y: float) -> Cover:
        content = _core.DrawList()
        content.instance(content.polygon(star(5, 9, 4)), place(x, y))
        return coverage(content, (40, 30))

    assert (draw(12.25, 11.5)[:25, :33] == draw(19.25, 16.5)[5:, 7:]).all()


@pytest.mark.parametrize("offset", [(-14.0, 3.0), (9.0, -8.5), (52.0, 30.25), (-3.5, 38.0)])
def test_what_reaches_out_of_the_target_is_cut_there(offset: tuple[float, float]) -> None:
    def draw(size: tuple[int, int], shift: float) -> Cover:
        content = _core.DrawList()
        x, y = offset[0] + shift, offset[1] + shift
        content.instance(content.polygon([(0, 0), (20, 4), (15, 18), (3, 11)]), place(x, y))
        content.instance(content.circle(8.0), place(x + 3, y + 4), outline=2.5)
        return coverage(content, size)

    assert np.abs(draw((64, 48), 0) - draw((128, 112), 32)[32:80, 32:96]).max() <= 2


# ---- strokes ----


@pytest.mark.parametrize("width", [0.5, 1.0, 2.0, 3.75, 9.0])
@pytest.mark.parametrize("angle", [0.0, 0.3, 1.1])
def test_a_stroked_square_is_a_frame_of_even_width(width: float, angle: float) -> None:
    content = _core.DrawList()
    side = 40.0
    square = content.polygon([(-20, -20), (20, -20), (20, 20), (-20, 20)])
    content.instance(square, place(40, 40, angle=angle), outline=width)
    found = coverage(content, (80, 80))
    assert found.sum() / 255 == pytest.approx((side + width) ** 2 - (side - width) ** 2, rel=0.004)
    assert found[40, 40] == 0


def test_a_stroke_is_as_wide_in_pixels_whatever_the_scale() -> None:
    for scale in (0.5, 4.0, 20.0):
        content = _core.DrawList()
        content.instance(content.circle(20 / scale), place(32, 32, scale), outline=3.0)
        assert coverage(content, (64, 64)).sum() / 255 == pytest.approx(2 * math.pi * 20 * 3, rel=0.003)


def test_a_stroked_ellipse_is_as_wide_all_round() -> None:
    content = _core.DrawList()
    content.instance(content.circle(1.0), (40, 0, 0, 15, 64, 32), outline=4.0)
    found = coverage(content, (128, 64)) / 255
    assert found[32, :64].sum() == pytest.approx(4, abs=0.05)
    assert found[:32, 64].sum() == pytest.approx(4, abs=0.05)


def test_joins_of_a_stroke_show_no_seams() -> None:
    content = _core.DrawList()
    corners = [(20 * math.cos(i * math.tau / 7), 20 * math.sin(i * math.tau / 7)) for i in range(7)]
    content.instance(content.polygon(corners), place(32, 32), outline=8.0)
    found = coverage(content, (64, 64))
    for x, y in corners:  # each corner of the path lies 4 pixels within the stroke
        assert (found[round(y + 31) : round(y + 33), round(x + 31) : round(x + 33)] == 255).all()


def test_a_sharp_corner_is_rounded_and_does_not_shoot_out() -> None:
    content = _core.DrawList()
    content.instance(content.polygon([(10, 31.5), (40, 30.5), (40, 32.5)]), outline=4.0)
    found = coverage(content, (64, 64))
    assert found[:, :7].sum() == 0
    assert found[31, 9] > 200


# ---- colour ----


def test_half_transparent_white_over_black_is_half_grey() -> None:
    content = _core.DrawList()
    content.instance(content.polygon([(2, 2), (10, 2), (10, 10), (2, 10)]), tint=0x80FFFFFF)
    assert tuple(picture(content, (12, 12))[5, 5]) == (128, 128, 128, 255)


def test_later_instances_lie_on_top() -> None:
    content = _core.DrawList()
    square = content.polygon([(0, 0), (8, 0), (8, 8), (0, 8)])
    content.instance(square, tint=RED)
    content.instance(square, place(4, 0), tint=GREEN)
    found = picture(content, (12, 8))
    assert tuple(found[4, 3]) == (255, 0, 0, 255)
    assert tuple(found[4, 5]) == (0, 255, 0, 255)


def test_corner_colours_run_evenly_across() -> None:
    content = _core.DrawList()
    band = content.polygon([(0, 0), (64, 0), (64, 8), (0, 8)], colours=[BLACK, WHITE, WHITE, BLACK])
    content.instance(band)
    expected = [(x + 0.5) / 64 * 255 for x in range(64)]
    assert np.abs(picture(content, (64, 8))[4, :, 0] - expected).max() <= 0.51


@pytest.mark.parametrize("angle", [0.0, 0.4, 2.0])
def test_triangles_of_one_shape_meet_without_a_seam(angle: float) -> None:
    content = _core.DrawList()
    points = star(6, 22, 9)
    content.instance(content.polygon(points, colours=[WHITE, 0xFFFFFFFE] * 6), place(32, 32, angle=angle))
    flat = _core.DrawList()
    flat.instance(flat.polygon(points), place(32, 32, angle=angle))
    assert np.abs(coverage(content, (64, 64)) - coverage(flat, (64, 64))).max() <= 1


def test_each_corner_of_a_square_shows_its_colour() -> None:
    content = _core.DrawList()
    square = content.polygon([(0, 0), (32, 0), (32, 32), (0, 32)], colours=[RED, GREEN, BLUE, WHITE])
    content.instance(square)
    found = picture(content, (32, 32)).astype(int)
    corners = {(0, 0): (255, 0, 0), (31, 0): (0, 255, 0), (31, 31): (0, 0, 255), (0, 31): (255, 255, 255)}
    for (x, y), colour in corners.items():
        assert np.abs(found[y, x, :3] - colour).max() <= 9


def test_a_transparent_background_gives_straight_colour_when_captured() -> None:
    content = _core.DrawList()
    content.instance(content.polygon([(0, 0), (8, 0), (8, 8), (0, 8)]), tint=0x80FF8000)
    renderer = SoftRenderer()
    renderer.draw(DrawList((16, 8), 0, content))
    found = np.asarray(renderer.capture().pixels)
    assert np.abs(found[4, 4].astype(int) - (0, 128, 255, 128)).max() <= 1
    assert tuple(found[4, 12]) == (0, 0, 0, 0)
