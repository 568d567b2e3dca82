"""Light and shadow: against exact geometry, the same on every machine, and nothing where nothing is lit."""

from __future__ import annotations

import math

import numpy as np
import pytest
from lighting import circle_corners, corners_of, light_of, lit_game, seen

import evilengine as evil
from evilengine import _core
from evilengine.game import Game, saving

PENUMBRA_ERROR = 0.02
"""Of full light: what 13 bits of the light map's factors and the rays of the exact answer differ by at most."""


def shadow_scene(**options):
    """A lamp over boxes and a ball, some of which hide the same part of it; and what hides it, as corners."""
    game = lit_game(**options)
    game.lights.quality = "medium"
    shapes = []
    for at, angle, sides in [((0, 0.4), 0.3, (0.8, 0.3)), ((0.7, 0.1), 1.1, (0.6, 0.2)), ((-1.4, 0.6), 0, (0.5, 0.5))]:
        body = game.add(evil.Rectangle(*sides), at=at, angle=angle, kind="static")
        shapes.append(corners_of(body, sides))
    ball = game.add(evil.Circle(0.3), at=(1.8, 0.7), kind="static")
    shapes.append(circle_corners(ball, 0.3))
    lamp = game.add_light(at=(0.2, 1.6), size=0.3, radius=100, falloff=0)
    return game, lamp, shapes


def test_shadows_are_where_exact_geometry_has_them():
    game, lamp, shapes = shadow_scene()
    light, places = light_of(game)
    compared = {"dark": 0, "half": 0, "full": 0}
    for row, column in np.random.default_rng(1).integers(0, light.shape[:2], (700, 2)):
        point = places[row, column]
        if any(_near(point, shape, 0.12) for shape in shapes):
            continue  # on a body, or within the six pixels in which a shadow's edge is kept from having steps
        expected = seen(point, np.array(lamp.at), lamp.size, shapes)
        kind = "dark" if expected == 0 else "full" if expected == 1 else "half"
        compared[kind] += 1
        assert light[row, column, 0] == pytest.approx(expected, abs=PENUMBRA_ERROR if kind == "half" else 0.004)
    assert min(compared.values()) > 30, compared


def _near(point, corners, distance):
    """Is the point inside a polygon, or that close to it?"""
    a, b = corners, np.roll(corners, -1, axis=0)
    edge = b - a
    if np.all(edge[:, 0] * (point - a)[:, 1] - edge[:, 1] * (point - a)[:, 0] > 0):
        return True
    part = np.clip(((point - a) * edge).sum(axis=1) / (edge**2).sum(axis=1), 0, 1)
    return np.hypot(*(a + part[:, None] * edge - point).T).min() < distance


def test_light_fades_as_its_falloff_says_and_ends_at_its_radius():
    game = lit_game()
    game.add_light(at=(0, 0), radius=2, falloff=1.5, intensity=0.8)
    light, places = light_of(game)
    away = np.hypot(*np.moveaxis(places, -1, 0))
    expected = 0.8 * np.clip(1 - away / 2, 0, None) ** 1.5
    assert np.abs(light[..., 1] - expected).max() < 0.004
    assert light[away > 2].max() == 0


def test_lights_add_up_in_linear_light():
    one = lit_game()
    one.add_light(at=(0, 0), colour=(0.5, 0.25, 1.0), radius=3)
    many = lit_game()
    for _ in range(3):
        many.add_light(at=(0, 0), colour=(0.5, 0.25, 1.0), radius=3, shadows=False)
    assert np.abs(light_of(many)[0] - 3 * light_of(one)[0]).max() < 0.01


@pytest.mark.parametrize("zoom", [1, 4])
def test_round_shapes_cast_round_shadows_however_large_they_are(zoom):
    """A pill and a disc of the same radius hide the same from where only the end of the pill is in the way."""
    found = []
    for shape in (evil.Capsule((-4, 0), (0, 0), 2.0), evil.Circle(2.0), evil.Rectangle(4, 4, rounding=2.0)):
        game = lit_game()
        game.lights.quality = "medium"
        game.camera.position, game.camera.zoom = (2.6, -0.5), zoom
        game.add(shape, at=(0, 0), kind="static")
        game.add_light(at=(2.4, 1.6), size=0.1, radius=100, falloff=0)
        light, places = light_of(game)
        at = (places - np.array(game.camera.position)) / zoom + np.array(game.camera.position)
        found.append(np.where(np.hypot(*np.moveaxis(at, -1, 0)) > 2.1, light[..., 0], 0))
    for other in found[1:]:
        assert np.abs(found[0] - other).max() < 0.1


def test_text_lies_over_what_is_lit():
    game = lit_game()
    game.add_light(at=(0, 0))
    before = bytes(game.capture().pixels)
    game.text("Dusk", at=(8, 8), size=20, colour="red")
    assert bytes(game.capture().pixels) != before


def test_a_light_without_shadows_shines_through():
    game, lamp, _ = shadow_scene()
    lamp.shadows = False
    assert light_of(game)[0].min() == pytest.approx(1.0, abs=0.002)


def test_a_row_of_boxes_side_by_side_is_a_wall_without_a_gap():
    game = lit_game()
    for x in range(-8, 9):
        game.add(evil.Rectangle(0.4, 0.4), at=(0.4 * x, 0), kind="static")
    game.add_light(at=(0.13, 1.2), size=0.1, radius=20, falloff=0)
    light, places = light_of(game)
    assert light[places[..., 1] < -0.25].max() == 0


def test_a_lamp_shines_out_of_the_body_that_it_is_in_or_on():
    game = lit_game()
    lantern = game.add(evil.Circle(0.4), at=(0, 0), kind="static")
    game.add_light(at=(0, 0), radius=5)
    assert light_of(game)[0].max() > 0.5
    other = lit_game()
    carrier = other.add(evil.Rectangle(2, 0.2), at=(0, 0), kind="static")
    light = other.add_light(body=carrier, at=(0, 0.3), radius=5)
    assert light_of(other)[0][-1].max() > 0.1, "its own body casts no shadow in it"
    assert lantern.alive
    assert light.position == (0.0, pytest.approx(0.3))


def test_sensors_and_other_categories_cast_no_shadow():
    game = lit_game()
    game.add(evil.Rectangle(2, 0.2), at=(0, 0), kind="static", sensor=True)
    game.add(evil.Rectangle(2, 0.2), at=(0, -0.5), kind="static", category=2)
    lamp = game.add_light(at=(0, 1), radius=50, falloff=0, mask=1)
    assert light_of(game)[0][-1].min() > 0.99
    lamp.mask = 2
    assert light_of(game)[0][-1].min() == 0


def test_a_sun_casts_the_same_shadow_everywhere():
    game = lit_game()
    for x in (-2, 1.5):
        game.add(evil.Rectangle(0.5, 0.5), at=(x, 0.5), kind="static")
    game.add_light(direction=(0, -1), size=0.001)
    light, places = light_of(game)
    row = np.argmin(np.abs(places[:, 0, 1] + 1))
    x, bright = places[row, :, 0], light[row, :, 0]
    under = (np.abs(x + 2) < 0.2) | (np.abs(x - 1.5) < 0.2)
    beside = (np.abs(x + 2) > 0.3) & (np.abs(x - 1.5) > 0.3)
    assert bright[under].max() == 0
    assert bright[beside].min() == pytest.approx(1.0, abs=0.002)


def test_a_spot_shines_only_within_its_cone():
    game = lit_game()
    spot = game.add_light(at=(0, 0), direction=(1, 0), cone=math.radians(60), radius=50, falloff=0)
    light, places = light_of(game)
    angle = np.abs(np.arctan2(places[..., 1], places[..., 0]))
    assert light[angle > math.radians(30.5)].max() == 0
    assert light[(angle < math.radians(20)) & (np.hypot(*np.moveaxis(places, -1, 0)) > 0.1)].min() > 0.99
    spot.point_to((0, 5))
    assert spot.angle == pytest.approx(math.pi / 2)


def test_light_soaks_into_bodies_and_fades_there():
    game = lit_game()
    game.lights.depth = 0.5
    game.add(evil.Rectangle(20, 4), at=(0, -2), kind="static")
    game.add_light(at=(0, 1.5), radius=100, falloff=0)
    light, places = light_of(game)
    middle = light.shape[1] // 2
    depth, bright = -places[:, middle, 1], light[:, middle, 0]
    inside = depth > 0.05
    assert bright[(depth > 0.05) & (depth < 0.1)].min() > 0.5
    assert np.all(np.diff(bright[inside]) <= 1e-3)
    assert bright[depth > 0.6].max() < 0.001


def test_what_is_not_lit_looks_the_same_with_lights_and_without():
    def picture(lights):
        game = evil.Game("Plain", size=(200, 120), headless=True, renderer="soft", gravity=(0, 0))
        game.add(evil.Rectangle(1, 1), at=(0.3, 0.2), angle=0.4)
        game.add(evil.Circle(0.5), at=(-1, 0))
        for _ in range(lights):
            game.add_light(at=(0, 1))
        assert _core.light_map(game._collect().content) is None
        return bytes(game.capture().pixels)

    assert picture(0) == picture(2)


def test_what_is_lit_looks_as_it_does_until_there_is_a_light_or_ambient_light():
    def picture(**looks):
        game = evil.Game("Plain", size=(200, 120), headless=True, renderer="soft", gravity=(0, 0))
        game.add(evil.Rectangle(1, 1), at=(0.3, 0.2), angle=0.4, **looks)
        plain = bytes(game.capture().pixels)
        game.ambient = 1.0
        return plain, bytes(game.capture().pixels), game

    plain, _, _ = picture()
    lit, at_one, game = picture(lit=True)
    assert lit == plain == at_one
    game.ambient = 0.2
    assert bytes(game.capture().pixels) != plain


@pytest.mark.parametrize("instructions", _core.instruction_sets())
@pytest.mark.parametrize("threads", [1, 3])
def test_light_has_the_same_bits_on_every_instruction_set_and_for_any_number_of_threads(instructions, threads):
    game, _, _ = shadow_scene(threads=threads)
    expected = _core.light_map(game._collect().content)
    game.world._core.instruction_set = instructions
    assert _core.light_map(game._collect().content) == expected
    one, _, _ = shadow_scene()
    assert _core.light_map(one._collect().content) == expected


def test_shadows_do_not_crawl_when_the_camera_moves():
    game, lamp, _ = shadow_scene()
    game.lights.quality = "medium"
    lamp.falloff = 0
    before, places = light_of(game)
    game.camera.position = (0.3, 0.1)  # 15 and 5 pixels: no whole number of texels
    after, moved = light_of(game)
    column = np.argmin(np.abs(places[0, :, 0] - moved[0, 20, 0]))
    row = np.argmin(np.abs(places[:, 0, 1] - moved[20, 0, 1]))
    assert places[row, column] == pytest.approx(moved[20, 20], abs=1e-4)
    air = np.s_[row : row + 40, column : column + 80], np.s_[20:60, 20:100]
    assert np.abs(before[air[0]] - after[air[1]]).max() < 0.01


def test_a_light_goes_with_its_body():
    game = lit_game()
    body = game.add(evil.Circle(0.2), at=(1, 0))
    lamp = game.add_light(body=body, at=(0.5, 0))
    assert lamp.body is body
    assert lamp.position == (1.5, 0)
    body.destroy()
    assert not lamp.alive
    with pytest.raises(evil.StaleReferenceError, match=r"Light.*went with its body"):
        lamp.radius = 3
    game.capture()
    assert len(game.lights) == 0


@pytest.mark.parametrize(
    ("words", "error", "match"),
    [
        ({}, evil.ArgumentError, r"at=\(x, y\)"),
        ({"at": (0, 0), "radius": 0}, evil.ArgumentError, "radius=0 must be"),
        ({"at": (0, math.nan)}, evil.ArgumentError, "at="),
        ({"at": (0, 0), "size": math.nan}, evil.ArgumentError, "size=nan"),
        ({"at": (0, 0), "temperature": 12}, evil.ArgumentError, "temperature=12"),
        ({"at": (0, 0), "colour": "lamp"}, evil.ArgumentError, "colour='lamp'"),
        ({"at": (0, 0), "mask": 1.5}, evil.ArgumentTypeError, r"mask=1\.5"),
        ({"direction": (0, 0)}, evil.ArgumentError, "direction"),
        ({"direction": (0, -1), "cone": 1}, evil.ArgumentError, "far away"),
        ({"at": (0, 0), "body": 3}, evil.ArgumentTypeError, "body=3"),
        ({"at": (0, 0), "brightness": 3}, evil.ArgumentTypeError, "brightness"),
    ],
)
def test_a_light_that_cannot_be_is_refused_and_none_is_added(words, error, match):
    game = lit_game()
    with pytest.raises(error, match=match):
        game.add_light(**words)
    assert len(game.lights) == 0


def test_a_saved_game_keeps_its_lights():
    game, lamp, _ = shadow_scene()
    body = game.add(evil.Circle(0.2), at=(2, -1))
    on_body = game.add_light(body=body, at=(0.1, 0.2), direction=(1, 1), cone=0.7, temperature=2700, size=0.05)
    sun = game.add_light(direction=(1, -1), intensity=0.2, on=False, colour="#8090a0")
    game.ambient = "#102030"
    data, picture = saving.to_bytes(game), bytes(game.capture().pixels)

    other = Game("Light", size=(320, 180), headless=True, renderer="soft")
    other.lights.quality = "medium"
    saving.from_bytes(other, data, "other")
    assert bytes(other.capture().pixels) == picture
    assert saving.to_bytes(other) == data

    lamp.destroy()
    sun.on = True
    late = game.add_light(at=(0, 0))
    saving.from_bytes(game, data, "same")
    assert bytes(game.capture().pixels) == picture
    assert on_body.alive
    assert sun.alive
    assert not sun.on
    assert not late.alive
    assert sorted(light.kind for light in game.lights) == ["lamp", "spot", "sun"]


def test_a_new_scene_begins_without_lights():
    game = lit_game()
    game.add_light(at=(0, 0))

    @game.scenes
    def bare():
        pass

    game.go("bare")
    assert len(game.lights) == 0
    assert game.ambient == 1.0


def test_warm_light_is_warm_and_a_clear_sky_is_blue():
    from evilengine.values.temperature import linear_of

    for kelvin in (1000, 1900, 2700, 4000):
        red, green, blue = linear_of(kelvin)
        assert red == 1.0
        assert red > green > blue >= 0
    assert linear_of(6500) == pytest.approx((1, 1, 1), abs=0.07)
    red, green, blue = linear_of(15000)
    assert blue == 1.0
    assert blue > green > red


def test_shadows_of_a_crowd_are_where_exact_geometry_has_them():
    game = lit_game()
    dice, shapes = np.random.default_rng(3), []
    for at in dice.uniform((-3, -1.7), (3, 1.7), (140, 2)):
        if np.hypot(*(at - (0.1, 0.2))) > 0.5:
            body = game.add(evil.Rectangle(0.16, 0.16), at=at, angle=dice.uniform(0, 3), kind="static")
            shapes.append(corners_of(body, (0.16, 0.16)))
    lamp = game.add_light(at=(0.1, 0.2), size=0.12, radius=100, falloff=0)
    light, places = light_of(game)
    compared = {"dark": 0, "half": 0, "full": 0}
    for row, column in dice.integers(0, light.shape[:2], (150, 2)):
        point = places[row, column]
        if any(_near(point, shape, 0.12) for shape in shapes):
            continue
        expected = seen(point, np.array(lamp.at), lamp.size, shapes, rays=150)
        kind = "dark" if expected == 0 else "full" if expected == 1 else "half"
        compared[kind] += 1
        assert light[row, column, 0] == pytest.approx(expected, abs=0.03), point
    assert compared["dark"] > 10, compared
    assert compared["half"] > 5, compared


def test_low_quality_has_hard_shadows_where_medium_has_soft_ones():
    def half_shadow(quality):
        game = lit_game()
        game.lights.quality = quality
        game.add(evil.Rectangle(3, 0.1), at=(-1.5, 0.5), kind="static")
        game.add_light(at=(0.1, 1.5), size=0.4, radius=50, falloff=0)
        light, places = light_of(game)
        row = light[np.argmin(np.abs(places[:, 0, 1] + 1.3)), :, 0]
        return np.sum((row > 0.01) & (row < 0.99)) * (places[0, 1, 0] - places[0, 0, 0])

    assert half_shadow("low") < 0.25
    assert half_shadow("medium") > 1.0
