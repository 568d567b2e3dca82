"""The debug view shows what the physics sees, and touches nothing of it."""

from __future__ import annotations

import math

import pytest
from stage import BLACK, BLUE, GREEN, RED, Stage

import evilengine as evil
from evilengine.scene.debug import WORLD_PARTS

WHITE, YELLOW, CYAN, MAGENTA = (255, 255, 255), (255, 255, 0), (0, 255, 255), (255, 0, 255)


@pytest.fixture
def stage() -> Stage:
    """With the debug view on, in plain colours, over black."""
    stage = Stage()
    stage.camera.zoom = 0.5  # 8 x 4 metres, 25 pixels a metre
    stage.scene.debug = True
    view = stage.scene.debug_view
    view.veil = "black"
    view.legend = False
    view.static, view.kinematic, view.awake, view.asleep = "blue", "magenta", "lime", "cyan"
    view.contact, view.centre, view.velocity, view.gravity = "red", "white", "yellow", "yellow"
    return stage


def sees(stage: Stage, point: tuple[float, float], colour: tuple[int, int, int], reach: int = 1) -> bool:
    """Is `colour`, or nearly, within `reach` pixels of a point of the world? A thin line seldom fills a pixel whole."""
    pixels = stage.show()
    column, row = (int(each) for each in stage.camera.to_pixel(point))
    near = [(row + y, column + x) for y in range(-reach, reach + 1) for x in range(-reach, reach + 1)]
    return any(all(abs(pixels[r, c, k] - colour[k]) <= 90 for k in range(3)) for r, c in near)


def pixels_of(stage: Stage, colour: tuple[int, int, int]) -> int:
    data = stage.show().tobytes()
    return sum(data[i : i + 3] == bytes(colour) for i in range(0, len(data), 4))


@pytest.mark.parametrize(("kind", "colour"), [("static", BLUE), ("kinematic", MAGENTA), ("dynamic", GREEN)])
@pytest.mark.parametrize("form", ["rectangle", "circle", "polygon"])
def test_outlines_tell_the_kind_of_body(stage: Stage, kind: str, colour: tuple[int, int, int], form: str) -> None:
    triangle = evil.Polygon([(1, -1), (1, 1), (-1, 0)])
    shape = {"rectangle": evil.Rectangle(2, 2), "circle": evil.Circle(1), "polygon": triangle}[form]
    stage.add(shape, kind=kind, at=(-1, 0))
    assert sees(stage, (0, 0), colour)
    assert not sees(stage, (-0.55, 0.25), colour)  # inside
    assert not sees(stage, (0.3, 0.8), colour)  # outside


def test_sensors_and_media_have_colours_of_their_own(stage: Stage) -> None:
    stage.scene.debug_view.sensor, stage.scene.debug_view.medium = "cyan", "magenta"
    body = stage.add(evil.Rectangle(1, 1), kind="static", at=(-1, 0))
    body.add_shape(evil.Rectangle(2, 2), sensor=True)
    stage.world.add_force(evil.Medium((1, -1, 3, 1), density=1))
    stage.world.add_force(evil.Medium(evil.Circle(0.3), at=(0.5, 0), body=body))
    assert sees(stage, (-0.5, 0.2), BLUE)
    assert sees(stage, (0, 0.6), CYAN)
    assert sees(stage, (1, 0.5), MAGENTA)
    assert sees(stage, (-0.5, 0.3), MAGENTA)


def test_bodies_that_fell_asleep_have_another_colour(stage: Stage) -> None:
    stage.world.gravity = (0, -10)  # type: ignore[assignment]
    stage.add(evil.Rectangle(6, 1), at=(0, -1.5), kind="static")
    box = stage.add(evil.Rectangle(1, 1), at=(0, -0.5))
    stage.world.step(1 / 60)
    assert sees(stage, (0.2, 0), GREEN)
    for _ in range(200):
        stage.world.step(1 / 60)
    assert not box.awake
    assert sees(stage, (0.2, 0), CYAN)


def test_every_shape_of_a_body_is_outlined_where_its_matrix_puts_it(stage: Stage) -> None:
    body = stage.add(evil.Rectangle(1, 1), kind="static")
    body.add_shape(evil.Circle(0.5), offset=(2, 0))
    body.apply_matrix(evil.Mat4.scale(0.5, 0.5))
    assert sees(stage, (0, 0.25), BLUE)
    assert sees(stage, (1, 0.25), BLUE)


def test_contacts_are_arrows_along_the_normal_from_the_first_body_to_the_second(stage: Stage) -> None:
    floor = stage.add(evil.Rectangle(6, 1), at=(0, -1), kind="static")
    ball = stage.add(evil.Circle(0.5), at=(0, -0.01))
    stage.world.step(1 / 60)
    (contact,) = stage.world.contacts.active
    assert (contact.a, contact.b) == (floor, ball)
    assert sees(stage, contact.point, RED)
    stage.scene.debug_view.awake = "black"
    assert sees(stage, (0, -0.5 + 0.4), RED)  # 10 points up: on the shaft
    assert not sees(stage, (0, -0.5 - 0.4), RED)
    assert not sees(stage, (0, 0.8), RED)


def test_the_centre_of_mass_is_marked_not_the_origin(stage: Stage) -> None:
    body = stage.add(evil.Polygon([(0, 0), (3, 0), (0, 3)]), at=(-1.5, -1.5))
    assert math.dist(body.centre, (-0.5, -0.5)) < 1e-5
    assert sees(stage, body.centre, WHITE, reach=0)
    assert not sees(stage, body.position, WHITE, reach=0)
    stage.add(evil.Circle(0.2), at=(2, 1), kind="static")
    assert not sees(stage, (2, 1), WHITE)


def test_velocities_are_shown_when_asked_for(stage: Stage) -> None:
    stage.add(evil.Circle(0.2), at=(-3, 1), velocity=(20, 0))
    assert not sees(stage, (-2, 1), YELLOW)
    stage.scene.debug_view.velocities = True
    assert sees(stage, (-2, 1), YELLOW)  # the arrow reaches as far as the body gets in a tenth of a second: 2 m
    assert not sees(stage, (-0.8, 1), YELLOW)


@pytest.mark.parametrize("angle", [0.0, math.pi / 2, 2.5])
def test_the_gravity_arrow_points_where_things_fall_on_the_screen(stage: Stage, angle: float) -> None:
    stage.camera.angle = angle
    stage.world.gravity = (0, -9.81)  # type: ignore[assignment]
    assert mean_of_head(stage) == pytest.approx((math.sin(-angle), math.cos(-angle)), abs=0.15)
    stage.world.gravity = (9.81, 0)  # type: ignore[assignment]
    assert mean_of_head(stage) == pytest.approx((math.cos(-angle), -math.sin(-angle)), abs=0.15)


def mean_of_head(stage: Stage) -> tuple[float, float]:
    """Direction, x right and y down, from the middle of the dial to the middle of the arrow, whose head is wide."""
    pixels = stage.show()
    height, width, _ = pixels.shape
    found = [(x + 0.5, y + 0.5) for y in range(height) for x in range(width) if pixels[y, x, 0] > 200]
    centre = (width - 42, 42)
    x, y = (sum(p[i] for p in found) / len(found) - centre[i] for i in range(2))
    return x / math.hypot(x, y), y / math.hypot(x, y)


def test_without_gravity_there_is_no_arrow(stage: Stage) -> None:
    assert pixels_of(stage, YELLOW) == 0


def test_lines_are_as_thick_in_points_on_a_finer_screen(stage: Stage) -> None:
    stage.add(evil.Rectangle(2, 2), at=(-1, 0), kind="static")
    widths = []
    for scale in (1, 3):
        pixels = stage.show(size=(200 * scale, 100 * scale))
        row = 50 * scale
        light = sum(pixels[row, column, 2] for column in range(90 * scale, 110 * scale))
        widths.append(light / 255)
    assert widths[0] == pytest.approx(1.5, abs=0.3)
    assert widths[1] == pytest.approx(4.5, abs=0.5)


def test_a_long_legend_goes_on_in_the_next_line(stage: Stage) -> None:
    stage.add(at=(0, 0))
    view = stage.scene.debug_view
    view.legend = view.velocities = view.impulses = view.bounds = True
    view.velocity = "#123456"
    assert pixels_of(stage, (0x12, 0x34, 0x56)) > 20, "its square is on the screen"


def test_the_legend_counts_and_needs_fonts(stage: Stage) -> None:
    before = stage.show().tobytes()
    stage.scene.debug_view.legend = True
    assert stage.show().tobytes() != before
    stage.scene._fonts = None
    assert stage.show().tobytes() == before


def test_when_it_is_off_nothing_of_it_is_left(stage: Stage) -> None:
    stage.scene.debug = False
    stage.add(evil.Rectangle(1, 1)).draw(colour="red")
    stage.add(evil.Circle(1), at=(1, 0), kind="static")
    stage.world.step()
    picture, checksum = stage.show().tobytes(), stage.world.checksum()
    content = stage.scene.collect(stage.camera).content
    counts = (content.vertex_count, content.mesh_count, content.instance_count)
    stage.scene.debug = stage.scene.debug_view.velocities = stage.scene.debug_view.legend = True
    assert stage.show().tobytes() != picture
    assert (len(stage.scene), stage.scene._core.mesh_count) == (1, 1)
    stage.scene.debug = False
    assert stage.show().tobytes() == picture
    assert (content.vertex_count, content.mesh_count, content.instance_count) == counts
    assert stage.world.checksum() == checksum


def test_it_lies_over_the_drawings_and_under_the_text(stage: Stage) -> None:
    stage.add(evil.Rectangle(8, 4), kind="static").draw(colour="red", layer=9)
    stage.scene.text("a", at=(0, 0), size=20)
    assert stage.at(1, 0) == BLACK  # the veil
    assert stage.show()[10, 5, 1] == 255


def test_a_misspelt_colour_is_named_when_it_is_drawn(stage: Stage) -> None:
    stage.scene.debug_view.awake = "gren"
    with pytest.raises(evil.ArgumentError, match="did you mean 'green'"):
        stage.show()


def test_bodies_at_the_edge_of_the_world_do_no_harm(stage: Stage) -> None:
    stage.scene.debug_view.velocities = True
    stage.add(evil.Circle(1e5), at=(1e7, 0), velocity=(1e5, 1e5))
    stage.add(evil.Rectangle(1e5, 1e-4), at=(0, -9e6))
    stage.add(evil.Particle(), at=(0, 0))
    for zoom in (1e-6, 1.0, 1e6):
        stage.camera.zoom = zoom
        stage.world.step()
        stage.show()


# -- each part by itself --


@pytest.fixture
def lone(stage: Stage) -> Stage:
    """Nothing is shown yet, in plain colours over black."""
    view = stage.scene.debug_view
    view.show([])
    view.dial = False
    view.impulse, view.bound, view.joint = "red", "red", "red"
    return stage


def test_nothing_is_drawn_of_what_is_off_and_each_part_shows_something(lone: Stage) -> None:
    lone.add(evil.Rectangle(6, 1), at=(0, -1.5), kind="static")
    a, b = lone.add(evil.Circle(0.5), at=(0, -0.51), velocity=(3, -3)), lone.add(evil.Circle(0.3), at=(2, 0.5))
    lone.world.add_joint(evil.joints.Distance(a, b))
    lone.scene.lights.add(at=(1, 1.5))
    lone.world.step()
    dark = lone.show().tobytes()
    assert {dark[i] for i in range(len(dark)) if i % 4 != 3} == {0}
    pictures = set()
    parts = (*WORLD_PARTS, "lights")  # fluids have tests of their own
    for part in parts:
        lone.scene.debug_view.show([part])
        assert lone.scene.debug_view.shown == (part,)
        pictures.add(lone.show().tobytes())
    assert len(pictures | {dark}) == len(parts) + 1


def test_lights_and_the_edges_of_shadows_are_where_tangents_have_them(lone: Stage) -> None:
    lone.scene.debug_view.show(["lights"])
    lone.scene.debug_view.light, lone.scene.debug_view.umbra = "lime", "red"
    lone.scene.debug_view.penumbra = "blue"
    lone.add(evil.Rectangle(0.5, 2), at=(0, 0), kind="static")
    lamp = lone.scene.lights.add(at=(-2.25, 0), size=0.5, radius=4)
    assert sees(lone, (1.75, 0), GREEN), "where its light ends"
    assert sees(lone, (-1.75, 0), GREEN), "its rim"
    assert sees(lone, (0.75, 1.25), RED), (
        "from the lamp's upper rim past the nearer corner, 1 up: half as much as far again"
    )
    assert sees(lone, (0.75, 1.75), BLUE), "and from its lower rim"
    assert not sees(lone, (0.75, 0.75), RED)
    lamp.shadows = False
    assert not sees(lone, (0.75, 1.25), RED)


def test_parts_that_there_are_not_are_named(lone: Stage) -> None:
    with pytest.raises(evil.ArgumentError, match=r"part='island' must be one of .*did you mean 'islands'"):
        lone.scene.debug_view.show(["joints", "island"])
    assert lone.scene.debug_view.shown == ()


def test_the_impulse_of_a_block_at_rest_on_a_slope_points_straight_up(lone: Stage) -> None:
    lone.world.gravity = (0, -10)  # type: ignore[assignment]
    tilt = 0.4
    out = evil.Vec2(-math.sin(tilt), math.cos(tilt))
    lone.add(evil.Rectangle(8, 1), at=out * -0.5, angle=tilt, kind="static", friction=1)
    block = lone.add(evil.Rectangle(0.5, 0.5), at=out * 0.25, angle=tilt, friction=1)
    for _ in range(60):
        lone.world.step()
    assert block.velocity.length < 1e-3
    assert abs(lone.world.contacts.active[0].normal.x) > 0.3

    def upright_shafts() -> int:
        pixels = lone.show()
        return sum(sum(pixels[y, x, 0] > 150 for y in range(100)) > 12 for x in range(200))

    lone.scene.debug_view.show(["impulses"])
    assert upright_shafts() >= 2
    lone.scene.debug_view.impulse = "black"
    lone.scene.debug_view.show(["contacts", "impulses"])
    assert upright_shafts() == 0, "normals stand across the slope"


def test_bounds_are_boxes_round_every_convex_piece(lone: Stage) -> None:
    lone.add(evil.Polygon([(-2, -1), (2, -1), (2, 1), (1, 1), (1, 0), (-2, 0)]), at=(0.02, 0.02), kind="static")
    lone.add(evil.Circle(0.3), at=(-3, 0))
    lone.scene.debug_view.show(["bounds"])
    assert sees(lone, (-3.3, 0.3), RED)  # the corner of a circle's box
    assert sees(lone, (-2, -0.5), RED)
    assert sees(lone, (2, 0.5), RED)
    assert not sees(lone, (-1, 0.5), RED), "no box round both pieces"


def test_islands_have_one_colour_and_a_box_and_are_dark_in_sleep(lone: Stage) -> None:
    heap = [lone.add(evil.Rectangle(1, 1), at=(x, 0)) for x in (-3, -2)]
    lone.add(evil.Rectangle(1, 1), at=(2, 0))
    lone.world.step()
    lone.scene.debug_view.show(["shapes", "islands"])

    def colour(x: float, y: float) -> list[int]:
        column, row = (int(each) for each in lone.camera.to_pixel((x, y)))
        pixels = lone.show()
        return [max(pixels[row + side, column, part] for side in (-1, 0)) for part in range(3)]

    a, b, c = (colour(x, 0.5) for x in (-3, -2, 2))
    assert a == b != c
    lone.scene.debug_view.shapes = False
    assert sum(colour(-2.8, 0.5)) > 100, "the box round the two"
    assert sum(colour(2, 0.5)) == 0, "one alone needs none"
    lone.scene.debug_view.shapes = True
    lone.world.gravity = (0, 0)  # type: ignore[assignment]
    for _ in range(120):
        lone.world.step()
    assert not any(body.awake for body in heap)
    assert sum(colour(-3, 0.5)) < 0.7 * sum(a)


# -- joints --


@pytest.fixture
def joined(stage: Stage) -> Stage:
    """Only joints are shown, red, over black."""
    stage.scene.debug_view.show(["joints"])
    stage.scene.debug_view.dial = False
    stage.scene.debug_view.joint = "red"
    stage.scene.debug_view.contact = "lime"
    return stage


def pair(stage: Stage, a: tuple[float, float], b: tuple[float, float]) -> tuple[evil.Body, evil.Body]:
    return stage.add(evil.Circle(0.1), at=a, kind="static"), stage.add(evil.Circle(0.1), at=b)


def test_a_rod_is_a_line_and_a_spring_a_coil(joined: Stage) -> None:
    rod = joined.world.add_joint(evil.joints.Distance(*pair(joined, (-3, 0), (3, 0))))
    assert all(sees(joined, (x, 0), RED, reach=0) for x in (-2, -1, 0.5, 2))
    assert not sees(joined, (0, 0.2), RED)
    rod.destroy()
    assert not sees(joined, (-2, 0), RED)
    joined.world.add_joint(evil.joints.Distance(*pair(joined, (-3, 0), (3, 0)), frequency=2))
    bends = [x * 0.04 for x in range(-60, 60) if sees(joined, (x * 0.04, 0.18), RED)]
    assert bends
    assert min(bends) < -1.5 < 1.5 < max(bends), "it goes to and fro all the way"


def test_a_rope_hangs_when_it_is_slack_and_is_straight_when_it_is_tight(joined: Stage) -> None:
    joined.world.gravity = (0, -9.81)  # type: ignore[assignment]
    slack = joined.world.add_joint(evil.joints.Rope(*pair(joined, (-1, 0.5), (1, 0.5)), length=3))
    assert not sees(joined, (0, 0.5), RED)
    sag = math.sqrt(3 / 16 * (9 - 4))
    assert sees(joined, (0, 0.5 - sag), RED)
    joined.world.gravity = (0, 9.81)  # type: ignore[assignment]
    assert sees(joined, (0, 0.5 + sag), RED), "down is where things fall"
    slack.destroy()
    joined.world.add_joint(evil.joints.Rope(*pair(joined, (-1, 0.5), (1, 0.5))))
    assert sees(joined, (0, 0.5), RED)


def test_a_hinge_shows_the_arc_that_it_may_turn_through_and_turns_with_its_first_body(joined: Stage) -> None:
    frame = joined.add(evil.Circle(0.1), at=(0, 0), kind="kinematic")
    door = joined.add(evil.Rectangle(2, 0.2), at=(1, 0))
    joined.world.add_joint(evil.joints.Hinge(frame, door, at=(0, 0), limits=(-0.5, 1.5)))
    radius = 20 / 25  # 20 points, at 25 pixels a metre

    def arc(angle: float) -> bool:
        return sees(joined, (radius * math.cos(angle), radius * math.sin(angle)), RED)

    assert [arc(angle) for angle in (-0.8, -0.4, 0.7, 1.4, 1.8, 3.0)] == [False, True, True, True, False, False]
    frame.angle = door.angle = 1.0
    door.position = (math.cos(1), math.sin(1))  # type: ignore[assignment]
    assert [arc(angle) for angle in (0.2, 0.7, 2.4, 2.9)] == [False, True, True, False]


def test_a_rail_ends_at_its_limits(joined: Stage) -> None:
    frame, lift = pair(joined, (-3, 0), (0, 0))
    joined.world.add_joint(evil.joints.Slider(frame, lift, axis=(1, 0), limits=(-1, 2)))
    stops = [x for x in (-2, -1, 1, 2, 3) if sees(joined, (x, 0.16), RED)]
    assert stops == [-1, 2]


def test_a_pulley_runs_over_its_points(joined: Stage) -> None:
    left, right = joined.add(evil.Circle(0.1), at=(-2, -1)), joined.add(evil.Circle(0.1), at=(2, -1))
    joined.world.add_joint(evil.joints.Pulley(left, right, over_a=(-2, 1), over_b=(2, 1)))
    assert sees(joined, (-2, 0), RED)
    assert sees(joined, (2, 0), RED)
    assert sees(joined, (-2.2, 1), RED), "the ring it runs over"
    assert not sees(joined, (0, 0), RED)


def test_a_joint_takes_the_colour_of_contacts_as_it_comes_near_breaking(joined: Stage) -> None:
    joined.world.gravity = (0, -10)  # type: ignore[assignment]
    wall, lamp = pair(joined, (0, 1), (0, -1))
    weight = lamp.mass * 10
    rope = joined.world.add_joint(evil.joints.Rope(wall, lamp, breaking_force=1.25 * weight))
    for _ in range(120):
        joined.world.step()
    column, row = (int(each) for each in joined.camera.to_pixel((0, 0)))
    pixels = joined.show()
    red, green = (sum(pixels[row, column + side, part] for side in (-1, 0)) for part in (0, 1))
    assert green / (red + green) == pytest.approx(0.8, abs=0.05)
    rope.breaking_force = None
    assert not sees(joined, (0, 0), GREEN)


def test_where_bodies_are_crowded_joints_are_lines_alone(joined: Stage) -> None:
    joined.world.add_joint(evil.joints.Weld(*pair(joined, (0, 0), (0.5, 0))))
    assert sees(joined, (0.25, 0), RED)
    assert not sees(joined, (0.25, 0.18), RED)
    joined.camera.zoom *= 4
    assert sees(joined, (0.25, 0.04), RED), "the sign of a weld"


def test_every_kind_of_joint_is_drawn_at_any_zoom_and_at_the_edge_of_the_world(joined: Stage) -> None:
    def rows(x: float) -> list[evil.Body]:
        return [joined.add(evil.Circle(0.2), at=(x + i, 0)) for i in range(2)]

    for x in (0.0, 9e6):
        joints = evil.joints
        for kind in (joints.Distance, joints.Slider, joints.Weld, joints.Wheel, joints.Motor, joints.Rope, joints.Gear):
            joined.world.add_joint(kind(*rows(x)))  # type: ignore[abstract]
        joined.world.add_joint(joints.Hinge(*rows(x), at=(x, 0), limits=(-1e6, 1e6), motor_speed=-3))
        joined.world.add_joint(joints.Pulley(*rows(x), over_a=(x, 2), over_b=(x + 1, 2)))
    for zoom in (1e-6, 0.5, 1e6):
        joined.camera.zoom = zoom
        pixels = joined.show()
        if zoom == 0.5:
            assert sum(pixels[50, x, 0] > 100 for x in range(200)) > 20
    assert len(joined.world.joints) == 18
