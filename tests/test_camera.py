"""The camera: from the world to the screen and back."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from evilengine.scene.camera import Camera
from evilengine.values.errors import ArgumentError, ArgumentTypeError
from evilengine.values.vec2 import Vec2

metres = st.floats(-1000, 1000)
points = st.tuples(metres, metres)
cameras = st.builds(
    Camera,
    st.tuples(st.integers(1, 4000), st.integers(1, 4000)),
    position=points,
    zoom=st.floats(0.05, 50),
    angle=st.floats(-10, 10),
    view_height=st.none() | st.floats(0.5, 500),
)


def near(a: Vec2, b: tuple[float, float], within: float) -> bool:
    return math.dist(a, b) <= within


@given(st.integers(1, 4000), st.integers(1, 4000), st.integers(-5000, 5000), st.integers(-5000, 5000))
def test_the_default_camera_is_the_formula_of_the_thesis(w: int, h: int, x: int, y: int) -> None:
    assert Camera((w, h)).to_world((x, y)) == ((x - w / 2) / 50, -(y - h / 2) / 50)


@given(cameras, points)
def test_to_world_undoes_to_pixel(camera: Camera, p: tuple[float, float]) -> None:
    assert near(camera.to_world(camera.to_pixel(p)), p, 1e-8)


@given(cameras, st.tuples(st.floats(-5000, 5000), st.floats(-5000, 5000)))
def test_to_pixel_undoes_to_world(camera: Camera, pixel: tuple[float, float]) -> None:
    assert near(camera.to_pixel(camera.to_world(pixel)), pixel, 1e-6)


@given(cameras, points, st.sampled_from([1.0, 1.25, 2.0, 3.0]))
def test_the_matrix_is_to_pixel_at_the_screens_real_pixels(
    camera: Camera, p: tuple[float, float], scale: float
) -> None:
    w, h = camera.size
    a, b, c, d, tx, ty = camera.matrix((w * scale, h * scale), scale)  # type: ignore[arg-type]
    pixel = Vec2(a * p[0] + c * p[1] + tx, b * p[0] + d * p[1] + ty)
    assert near(pixel, camera.to_pixel(p) * scale, 1e-5 * max(1.0, camera.points_a_metre))


def test_a_camera_turned_left_turns_the_picture_right() -> None:
    camera = Camera((100, 100), angle=math.pi / 2)
    assert near(camera.to_pixel((1, 0)), (50, 100), 1e-9)


def test_view_height_shows_that_many_metres_on_any_screen() -> None:
    for height in (270, 540, 1080):
        camera = Camera((960, height), view_height=9)
        assert near(camera.to_world((480, 0)) - camera.to_world((480, height)), (0, 9), 1e-9)
        assert camera.view_height == pytest.approx(9)


@given(st.integers(10, 3000), st.integers(10, 3000), st.floats(0.1, 100), st.floats(0.1, 100))
def test_fit_shows_all_of_it_and_touches_two_sides(w: int, h: int, width: float, height: float) -> None:
    camera = Camera((w, h))
    camera.fit(width, height)
    x, y = camera.to_pixel((width / 2, height / 2))
    assert x <= w * (1 + 1e-12)
    assert y >= -1e-9 * h
    assert math.isclose(x, w) or math.isclose(y, 0, abs_tol=1e-9 * h)


def test_fit_follows_a_change_of_size() -> None:
    camera = Camera((960, 540))
    camera.fit(16, 9)
    assert camera.points_a_metre == 60
    camera.size = (480, 540)
    assert camera.points_a_metre == 30
    camera.view_height = None
    assert camera.points_a_metre == 50


def test_zoom_two_shows_half_as_much() -> None:
    camera = Camera((200, 100), zoom=2)
    assert camera.to_world((200, 50)) == (1, 0)
    assert camera.sees((0.99, 0))
    assert not camera.sees((1.01, 0))
    assert camera.sees((1.01, 0), margin=0.1)


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("zoom", 0),
        ("zoom", -1),
        ("zoom", math.nan),
        ("angle", math.inf),
        ("position", (math.nan, 0)),
        ("position", (1e9, 0)),
        ("view_height", 0),
        ("view_height", math.nan),
        ("size", (0, 10)),
        ("size", (math.inf, 10)),
    ],
)
def test_bad_values_are_refused_by_name_and_change_nothing(name: str, value: object) -> None:
    camera = Camera((300, 200), position=(1, 2), zoom=3, angle=0.5, view_height=7)
    before = camera.matrix()
    with pytest.raises(ArgumentError, match=name):
        setattr(camera, name, value)
    assert camera.matrix() == before
    with pytest.raises(ArgumentError, match=name):
        Camera(**{name: value})  # type: ignore[arg-type]


def test_wrong_types_and_unknown_words_are_named() -> None:
    with pytest.raises(ArgumentTypeError, match="zoom"):
        Camera(zoom="big")  # type: ignore[arg-type]
    with pytest.raises(ArgumentTypeError, match="did you mean 'zoom'"):
        Camera(zom=2)  # type: ignore[call-arg]
    with pytest.raises(ArgumentTypeError, match="to_pixel: point"):
        Camera().to_pixel("a")  # type: ignore[arg-type]
    with pytest.raises(ArgumentError, match="fit: height"):
        Camera().fit(1, -1)
