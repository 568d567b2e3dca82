"""The scene: what is drawn where, how it looks, and in which order."""

from __future__ import annotations

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from stage import BLACK, BLUE, GREEN, RED, SQUARE, Stage

import evilengine as evil
from evilengine.scene import Drawing, Scene
from evilengine.values.colour import PALETTE, STONE, Colour, to_colour
from evilengine.values.errors import ArgumentError, ArgumentTypeError, ShapeError, StaleReferenceError


@pytest.fixture
def stage() -> Stage:
    return Stage()


# What is drawn where ------------------------------------------------------------------------------------------------


def test_a_drawing_on_a_body_is_where_the_body_is(stage: Stage) -> None:
    body = stage.add(at=(1, 0.2))
    body.draw(colour="red")
    assert stage.at(1, 0.2) == RED
    assert stage.at(0.45, 0.2) == BLACK
    body.position = (-1, 0)
    assert stage.at(-1, 0) == RED
    assert stage.at(1, 0.2) == BLACK


def test_a_drawing_without_a_body_has_its_own_matrix(stage: Stage) -> None:
    drawing = stage.scene.add(SQUARE, at=(-1, 0), colour="red")
    assert drawing.body is None
    assert stage.at(-1, 0) == RED
    drawing.place((1, 0), math.pi / 4, scale=0.5)
    assert stage.at(-1, 0) == BLACK
    assert stage.at(1.3, 0) == RED  # a corner of the square, half a metre wide and turned
    assert stage.at(1.23, 0.23) == BLACK
    drawing.matrix = evil.Mat4.translation(0, 0.3) @ evil.Mat4.scale(3, 0.2)
    assert stage.at(-1.4, 0.3) == RED
    assert drawing.matrix == evil.Mat4.translation(0, 0.3) @ evil.Mat4.scale(3, 0.2)


def test_a_picture_half_way_between_two_steps_shows_things_half_way(stage: Stage) -> None:
    body = stage.add(evil.Rectangle(0.2, 0.2), velocity=(60, 0))
    body.draw(colour="red")
    stage.world.step(1 / 60)
    assert [stage.at(x, 0, alpha=0.0) for x in (0, 0.5, 1)] == [RED, BLACK, BLACK]
    assert [stage.at(x, 0, alpha=0.5) for x in (0, 0.5, 1)] == [BLACK, RED, BLACK]
    assert [stage.at(x, 0, alpha=1.0) for x in (0, 0.5, 1)] == [BLACK, BLACK, RED]


@pytest.mark.parametrize(("turn", "half"), [(0.4, 0.2), (3.0, 1.5), (-3.0, -1.5), (3.6, (3.6 - math.tau) / 2)])
def test_a_picture_between_two_steps_turns_things_the_shorter_way(stage: Stage, turn: float, half: float) -> None:
    body = stage.add(evil.Rectangle(1.6, 0.1), angular_velocity=turn * 60)
    body.draw(colour="red")
    stage.world.step(1 / 60)
    x, y = 0.7 * math.cos(half), 0.7 * math.sin(half)
    assert stage.at(x, y, alpha=0.5) == RED
    assert stage.at(-y, x, alpha=0.5) == BLACK


def test_a_body_put_elsewhere_by_hand_does_not_glide_there(stage: Stage) -> None:
    body = stage.add(at=(-1, 0))
    body.draw(colour="red")
    stage.world.step(1 / 60)
    body.position = (1, 0)
    assert [stage.at(x, 0, alpha=0.5) for x in (-1, 0, 1)] == [BLACK, BLACK, RED]


def test_a_drawing_follows_its_shapes_matrix_and_its_bodys(stage: Stage) -> None:
    body = stage.add(evil.Rectangle(0.4, 0.4))
    body.draw(colour="red")
    body.shapes[0].apply_matrix(evil.Mat4.translation(1, 0))
    assert [stage.at(x, 0) for x in (0, 1)] == [BLACK, RED]
    body.apply_matrix(evil.Mat4.scale(1.5, 1.5))
    assert [stage.at(x, 0) for x in (1, 1.5, 1.75)] == [BLACK, RED, RED]


def test_the_camera_and_the_pictures_size_decide_where_it_is_in_pixels(stage: Stage) -> None:
    stage.scene.add(SQUARE, at=(1, 0), colour="red")
    pixels = stage.show(size=(400, 200))
    assert pixels.shape == (200, 400, 4)
    assert tuple(pixels[100, 300, part] for part in range(3)) == RED
    assert tuple(pixels[100, 240, part] for part in range(3)) == BLACK
    stage.camera.position = (1, 0)
    assert stage.at(1, 0) == RED


def test_circles_triangles_and_concave_polygons_fill_their_shape(stage: Stage) -> None:
    stage.scene.add(evil.Circle(0.4), at=(-1.5, 0), colour="red")
    assert [stage.at(x, 0) for x in (-1.5, -1.15, -1.05)] == [RED, RED, BLACK]
    corner = evil.Polygon([(0, 0), (1, 0), (1, 0.2), (0.2, 0.2), (0.2, 0.8), (0, 0.8)])
    stage.scene.add(corner, at=(0, -0.5), colour="red")
    assert [stage.at(*p) for p in ((0.1, 0.2), (0.9, -0.4), (0.5, 0))] == [RED, RED, BLACK]


def test_a_particle_is_seen_as_a_speck(stage: Stage) -> None:
    stage.add(evil.Particle(), at=(1, 0)).draw(colour="red")
    stage.scene.add(evil.Particle(), at=(-1, 0), colour="red")
    assert [stage.at(x, 0) for x in (-1, 0, 1)] == [RED, BLACK, RED]


# Looks --------------------------------------------------------------------------------------------------------------


def test_colours_can_be_given_to_each_corner(stage: Stage) -> None:
    stage.scene.add(evil.Rectangle(4, 2), colours=["red", "blue", "blue", "red"])
    left, middle, right = (stage.at(x, 0) for x in (-1.95, 0, 1.95))
    assert left[0] > 240 > 20 > left[2]
    assert right[2] > 240 > 20 > right[0]
    assert abs(middle[0] - middle[2]) < 10


def test_a_texture_spreads_over_the_shapes_box_with_its_top_row_on_top(stage: Stage) -> None:
    drawing = stage.scene.add(SQUARE, texture="halves.png")
    assert (stage.at(-0.4, 0), stage.at(0.4, 0)) == (RED, BLUE)
    drawing.texture = "rows.png"
    assert drawing.texture == "rows.png"
    assert (stage.at(0, 0.4), stage.at(0, -0.4)) == (RED, BLUE)
    drawing.texture = None
    assert drawing.texture is None
    assert stage.at(0, 0) == (255, 255, 255)


def test_a_texture_can_be_mapped_by_points_and_by_a_matrix(stage: Stage) -> None:
    swapped = [(1, 1), (0, 1), (0, 0), (1, 0)]  # for the corners left bottom, right bottom, right top, left top
    drawing = stage.scene.add(SQUARE, texture="halves.png", texture_points=swapped)
    assert (stage.at(-0.4, 0), stage.at(0.4, 0)) == (BLUE, RED)
    drawing.texture_matrix = evil.Mat4.translation(1, 0) @ evil.Mat4.scale(-1, 1)
    assert (stage.at(-0.4, 0), stage.at(0.4, 0)) == (RED, BLUE)
    assert drawing.texture_matrix == evil.Mat4.translation(1, 0) @ evil.Mat4.scale(-1, 1)


def test_a_colour_tints_the_texture(stage: Stage) -> None:
    stage.scene.add(SQUARE, texture="halves.png", colour="#800000")
    assert (stage.at(-0.4, 0), stage.at(0.4, 0)) == ((128, 0, 0), BLACK)


def test_looks_can_be_changed_after_creation(stage: Stage) -> None:
    drawing = stage.add().draw(colour="red", lit=True)
    assert (drawing.colour, drawing.visible, drawing.layer, drawing.lit) == (Colour(1, 0, 0), True, 0, True)
    drawing.colour = "blue"  # type: ignore[assignment]
    assert stage.at(0, 0) == BLUE
    drawing.visible = False
    assert stage.at(0, 0) == BLACK
    drawing.visible, drawing.lit = True, False
    assert stage.at(0, 0) == BLUE
    assert drawing.colour == to_colour("blue", "", "")
    assert not drawing.lit


def test_what_has_no_looks_takes_the_palette_in_turn_and_what_stands_still_is_stone(stage: Stage) -> None:
    bodies = [stage.add(kind=kind) for kind in ("dynamic", "static", "kinematic", "dynamic")]
    colours = [body.draw().colour.hex for body in bodies]
    assert colours == [PALETTE[0].hex, STONE.hex, PALETTE[1].hex, PALETTE[2].hex]
    assert [body.drawings[0].outline for body in bodies] == [True, False, True, True]


def test_an_outline_is_a_darker_line_along_the_edge(stage: Stage) -> None:
    drawing = stage.scene.add(SQUARE, colour="red", outline=True)
    edge = stage.at(0.49, 0)
    assert 100 < edge[0] < 250
    assert stage.at(0, 0) == RED
    drawing.outline = False
    assert not drawing.outline
    assert stage.at(0.49, 0) == RED


# Order --------------------------------------------------------------------------------------------------------------


def test_higher_layers_lie_over_lower_ones_and_later_drawings_over_earlier(stage: Stage) -> None:
    red = stage.scene.add(SQUARE, colour="red")
    green = stage.scene.add(SQUARE, colour="lime", layer=-1)
    assert stage.at(0, 0) == RED
    blue = stage.scene.add(SQUARE, colour="blue")
    assert stage.at(0, 0) == BLUE
    red.layer = 1
    assert stage.at(0, 0) == RED
    green.layer = 1
    assert stage.at(0, 0) == GREEN
    green.visible = red.visible = False
    assert stage.at(0, 0) == BLUE
    assert (red.layer, green.layer, blue.layer) == (1, 1, 0)


@given(
    st.lists(
        st.tuples(st.just("add"), st.integers(-2, 2))
        | st.tuples(st.just("drop"), st.integers(0, 30))
        | st.tuples(st.just("move"), st.integers(0, 99))
        | st.tuples(st.just("show"), st.just(0)),
        max_size=30,
    )
)
@settings(max_examples=60, deadline=None)
def test_the_drawing_on_top_is_the_last_of_the_highest_layer(steps: list[tuple[str, int]]) -> None:
    stage = Stage()
    alive: list[tuple[Drawing, int]] = []  # with the number that is its colour
    for count, (what, number) in enumerate(steps, 1):
        if what == "add":
            alive.append((stage.scene.add(SQUARE, colour=(count / 255, 0, 0), layer=number), count))
        elif what == "drop" and alive:
            alive.pop(number % len(alive))[0].destroy()
        elif what == "move" and alive:
            alive[number % len(alive)][0].layer = number // 20 - 2
        elif what == "show":
            stage.show()
    top = max(alive, key=lambda pair: (pair[0].layer, pair[1]), default=(None, 0))[1]
    assert stage.at(0, 0) == (top, 0, 0)
    assert len(stage.scene) == len(alive)


# Bad input ----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("options", "error", "words"),
    [
        ({"colour": "rde"}, ArgumentError, "did you mean 'red'"),
        ({"colour": 7}, ArgumentTypeError, "Scene.add: colour=7"),
        ({"colours": ["red"]}, ArgumentError, "colours holds 1, but the shape has 4 corners"),
        ({"colours": ["red"] * 3 + ["x"]}, ArgumentError, "colours='x'"),
        ({"texture": "none.png"}, evil.AssetError, "none.png"),
        ({"texture": 3}, ArgumentTypeError, "texture=3"),
        ({"texture_points": [(0, 0)]}, ArgumentError, "texture_points holds 1"),
        ({"texture_points": [(0, 0), (0, 1), (1, 1), (math.nan, 0)]}, ArgumentError, "texture_points"),
        ({"texture_matrix": (1, 2)}, ArgumentTypeError, "texture_matrix"),
        ({"matrix": [math.nan] * 16}, ArgumentError, "matrix"),
        ({"matrix": [1.0] * 16}, ArgumentError, "last row"),
        ({"at": (math.inf, 0)}, ArgumentError, "Scene.add: at="),
        ({"at": "here"}, ArgumentTypeError, "Scene.add: at='here'"),
        ({"angle": math.nan}, ArgumentError, "angle"),
        ({"layer": 1.5}, ArgumentTypeError, "layer=1.5"),
        ({"layer": 10**9}, ArgumentError, "layer"),
        ({"body": "crate"}, ArgumentTypeError, "body='crate' must be a Body"),
        ({"colr": "red"}, ArgumentTypeError, "did you mean 'colour'"),
    ],
)  # fmt: skip
def test_a_bad_argument_is_named_and_nothing_is_drawn(
    stage: Stage, options: dict[str, object], error: type[Exception], words: str
) -> None:
    with pytest.raises(error, match=words):
        stage.scene.add(SQUARE, **options)  # type: ignore[arg-type]
    assert (len(stage.scene), stage.scene._core.mesh_count) == (0, 0)
    body = stage.add()
    if "body" not in options:
        with pytest.raises(error, match=words):
            body.draw(**options)
    assert body.drawings == []


def test_the_wrong_kind_of_shape_or_handle_is_a_type_error(stage: Stage) -> None:
    drawing = stage.scene.add(SQUARE)
    for wrong in (7, "circle", drawing, stage.add(), evil.Circle, None):
        with pytest.raises(ArgumentTypeError, match=r"Scene\.add: shape"):
            stage.scene.add(wrong)  # type: ignore[arg-type]
    with pytest.raises(ArgumentTypeError, match="must be a Body"):
        stage.scene.add(SQUARE, body=drawing)  # type: ignore[arg-type]
    with pytest.raises(ArgumentTypeError, match="must be a World"):
        Scene("world")  # type: ignore[arg-type]
    with pytest.raises(ArgumentError, match="has none"):
        stage.scene.add(evil.Circle(1), colours=["red"])


def test_a_body_that_is_gone_or_of_another_world_cannot_be_drawn_on(stage: Stage) -> None:
    body, shape = stage.add(), stage.add().shapes[0]
    with pytest.raises(ArgumentError, match="another world"):
        Stage().scene.add(SQUARE, body=body)
    with pytest.raises(ArgumentError, match="another body"):
        stage.scene.add(shape, body=body)
    body.destroy()
    with pytest.raises(StaleReferenceError):
        stage.scene.add(SQUARE, body=body)
    with pytest.raises(StaleReferenceError):
        body.draw()


def test_the_core_itself_refuses_what_is_no_polygon(stage: Stage) -> None:
    core = stage.scene._core
    for corners in ([], [(0, 0), (1, 0)], [(0, 0), (1, 1), (1, 0), (0, 1)], [(0, 0), (0, 1), (1, 0)], [(0, 0)] * 3):
        with pytest.raises(ShapeError):
            core.add_polygon(corners)
    assert core.mesh_count == 0


def test_no_camera_and_no_moment_can_crash_a_frame(stage: Stage) -> None:
    for x in (0.0, 1e7, -1e7):
        stage.add(at=(x, 0)).draw()
    stage.scene.add(SQUARE, matrix=[1e30, 0, 0, 1e30, 1e30, -1e30])
    stage.scene.debug = True
    stage.world.step()
    for zoom in (1e-6, 1.0, 1e6):
        for position in ((0, 0), (1e7, -1e7)):
            stage.camera.zoom, stage.camera.position = zoom, position  # type: ignore[assignment]
            for alpha in (0.5, math.nan, math.inf, -3.0, 7.0):
                stage.show(alpha)
    with pytest.raises(ArgumentError, match="pixel_size"):
        stage.scene.collect(stage.camera, 1.0, (0, 10))
