"""Layers: parallax, perspective, fog, silhouettes and depth blur, in both renderers."""

from __future__ import annotations

import itertools
import random
import sys
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
from golden_pictures import GOLDEN, assert_golden

import evilengine as evil
from evilengine import _core
from evilengine.game import Game, saving
from evilengine.values.image import Image


def quiet(**options: Any) -> Game:
    game = Game("Layers", size=(240, 160), headless=True, **{"renderer": "soft", **options})
    game.add_background("black")
    return game


def picture(game: Game) -> npt.NDArray[np.int64]:
    return np.array(game.capture().pixels).astype(np.int64)


def middle_of(game: Game) -> tuple[float, float]:
    """Where the light of a picture is, in pixels from its middle, x right and y up."""
    light = picture(game)[..., 0]
    y, x = np.indices(light.shape)
    return (x * light).sum() / light.sum() - 119.5, 79.5 - (y * light).sum() / light.sum()


def width_of(game: Game) -> float:
    return float(picture(game)[80, :, 0].sum()) / 255


@pytest.mark.parametrize("parallax", [0.0, 0.3, 1.0, 1.5])
def test_a_layer_makes_its_share_of_the_cameras_motion(parallax: float) -> None:
    game = quiet()
    game.draw(evil.Circle(0.3), layer=3, colour="white")
    game.layers[3].parallax = parallax
    assert middle_of(game) == pytest.approx((0, 0), abs=0.1)
    game.camera.position = (1.0, -0.5)
    assert middle_of(game) == pytest.approx((-50 * parallax, 25 * parallax), abs=0.1)


def test_parallax_goes_along_with_zoom_and_a_turned_camera() -> None:
    game = quiet()
    game.draw(evil.Circle(0.2), layer=-1, colour="white")
    game.layers[-1].parallax = 0.5
    game.camera.zoom, game.camera.angle, game.camera.position = 1.5, 0.3, (0.8, 0.2)
    there = game.camera.to_pixel((0.4, 0.1))
    assert middle_of(game) == pytest.approx((there.x - 120, 80 - there.y), abs=0.1)


def test_in_perspective_what_is_far_is_small_and_comes_near_slowly() -> None:
    game = quiet()
    game.draw(evil.Rectangle(2, 1), layer=-1, colour="white")
    game.layers[-1].parallax = 0.5
    assert width_of(game) == pytest.approx(100)
    game.layers.perspective = True
    assert width_of(game) == pytest.approx(50, abs=0.5)  # twice as far as the world is half as large
    game.camera.zoom = 2.0  # the world's distance 1/2, the layer's 1/2 + 1
    assert width_of(game) == pytest.approx(100 / 1.5, abs=0.5)
    game.camera.position = (1.0, 0.0)
    assert middle_of(game)[0] == pytest.approx(-50 / 1.5, abs=0.5)


def test_particles_are_seen_as_their_layer_is() -> None:
    game = quiet(gravity=(0, 0))
    game.add_particles(layer=2, size=0.4, speed=0, life=9).burst(1)
    game.layers[2].parallax = 0.5
    game.camera.position = (1.0, 0.0)
    assert middle_of(game) == pytest.approx((-25, 0), abs=0.2)
    game.layers[2].visible = False
    assert picture(game)[..., :3].max() == 0


def test_bodies_do_not_notice_how_their_layer_is_seen() -> None:
    sums = []
    for parallax in (1.0, 0.2):
        game = quiet()
        game.add(evil.Rectangle(8, 1), at=(0, -1), kind="static", layer=1)
        game.add(evil.Circle(0.4), at=(0, 2), layer=1)
        game.layers[1].parallax = parallax
        game.step(60)
        game.capture()
        sums.append(game.world.checksum())
    assert sums[0] == sums[1]


def test_fog_lies_over_its_layer_and_under_the_next() -> None:
    game = quiet()
    for layer, x in ((-2, -2), (-1, 0), (0, 2)):
        game.draw(evil.Rectangle(1, 1), at=(x, 0), colour="black", layer=layer)
    game.layers[-1].fog = "#ffffff80"
    light = picture(game)[80, [20, 120, 220], 0]
    assert list(light) == [128, 128, 0]
    game.layers[-2].fog = "#ffffff80"
    assert list(picture(game)[80, [20, 120, 220], 0]) == pytest.approx([192, 128, 0], abs=1)


def test_fog_of_two_colours_goes_from_the_bottom_to_the_top() -> None:
    game = quiet()
    game.layers[0].fog = ["white", "#000000"]
    column = picture(game)[:, 120, 0]
    assert column[-1] >= 253
    assert column[0] <= 2
    assert (np.diff(column) >= 0).all()
    assert game.layers[0].fog == [(1, 1, 1, 1), (0, 0, 0, 1)]


def test_fog_lies_over_the_particles_of_its_layer() -> None:
    game = quiet(gravity=(0, 0))
    for layer in (-1, 0):
        game.add_particles(at=(2 * layer, 0), layer=layer, size=1, speed=0, life=9, soft=False).burst(1)
    game.layers[-1].fog = "black"
    assert picture(game)[80, 20, 0] == 0
    assert picture(game)[80, 120, 0] == 255


def test_a_black_tint_makes_silhouettes(tmp_path: Path) -> None:
    Image.of(2, 2, b"\x20\xf0\x40\xff" * 4).save(tmp_path / "leaf.png")
    game = quiet(folder=tmp_path)
    game.add_background("white")
    game.draw(evil.Rectangle(1, 1), texture="leaf.png", layer=-1)
    game.draw(evil.Rectangle(0.5, 0.5), at=(1, 0), colour="#ff0000", outline=True, layer=-1)
    game.layers[-1].tint = "black"
    shown = picture(game)
    assert shown[80, 120, :3].max() == 0
    assert (shown[..., 0] == shown[..., 1]).all()


@pytest.mark.parametrize("radius", [0.5, 1, 3, 8, 40])
def test_blur_keeps_the_light_and_spreads_it(radius: float) -> None:
    game = quiet()
    game.draw(evil.Rectangle(0.4, 0.4), colour="white", layer=-1)
    sharp = picture(game)[..., 0]
    game.layers[-1].blur = radius
    soft = picture(game)[..., 0]
    if radius < 20:  # farther out, eight bits have no room for what is left
        assert soft.sum() == pytest.approx(sharp.sum(), rel=0.05)
    assert middle_of(game) == pytest.approx((0, 0), abs=max(0.5, radius / 4))  # coarse pictures lie on coarse grids
    assert soft.max() < 255 if radius > 8 else soft.max() <= 255
    x = np.arange(240) - 119.5
    spread = (soft.sum(axis=0) * x * x).sum() / soft.sum() - (sharp.sum(axis=0) * x * x).sum() / sharp.sum()
    assert 0.3 * radius < max(spread, 0) ** 0.5 < 1.6 * radius + 1


def test_more_blur_is_never_less() -> None:
    game = quiet()
    game.draw(evil.Rectangle(0.6, 0.6), colour="white", layer=-1)
    peaks = []
    for radius in np.arange(0, 30, 0.5):
        game.layers[-1].blur = float(radius)
        peaks.append(int(picture(game)[80, 120, 0]))
    assert all(a >= b - 2 for a, b in itertools.pairwise(peaks))
    assert peaks[-1] < 120


def test_what_is_nearer_stays_sharp() -> None:
    game = quiet()
    game.draw(evil.Rectangle(2, 2), at=(1, 0), colour="white", layer=0)
    game.draw(evil.Rectangle(2, 2), at=(-1, 0), colour="white", layer=-1)
    game.layers[-1].blur = 6
    edge_far, edge_near = picture(game)[40, :40, 0], picture(game)[40, 200:, 0]
    assert len(set(edge_far)) > 8
    assert set(edge_near) <= {0, 255}


@pytest.mark.parametrize("size", [(1, 1), (2, 3), (17, 5), (33, 64)])
@pytest.mark.parametrize("renderer", ["soft", "gl"])  # gl where there is a driver, else soft once more
def test_pictures_of_any_size_are_blurred(size: tuple[int, int], renderer: str) -> None:
    game = Game("Small", size=size, headless=True, renderer=renderer)
    game.add_background("#808080")
    game.layers[0].blur = 20
    shown = np.array(game.capture().pixels)
    assert shown.shape == (size[1], size[0], 4)
    assert (shown[..., :3] == 128).all()


# ---- backgrounds --------------------------------------------------------------------------------------------------


@pytest.fixture
def stripes(tmp_path: Path) -> Path:
    """A picture of 8 x 4 points: a white column on blue."""
    rows = np.zeros((4, 8, 4), np.uint8)
    rows[:] = (0, 0, 255, 255)
    rows[:, 0] = 255
    Image.of(8, 4, rows.tobytes()).save(tmp_path / "stripes.png")
    return tmp_path


def test_a_background_covers_the_screen_and_moves_by_its_parallax(stripes: Path) -> None:
    game = quiet(folder=stripes)
    drawing = game.add_background("stripes.png", parallax=0.25)
    assert drawing is not None
    for x in (0.0, 3.0, 40.0, -70.0):
        game.camera.position = (x, 0)
        assert picture(game)[..., 2].min() == 255, "blue or white everywhere"
    game.camera.position = (0, 0)
    before = picture(game)[80, :, 0]
    game.camera.position = (4.0, 0)
    assert (picture(game)[80, :150, 0] == before[50:200]).mean() > 0.97


def test_a_very_wide_background_is_repeated_as_often_as_there_is_room(tmp_path: Path) -> None:
    Image.of(4000, 3, b"\xff\0\0\xff" * 12000).save(tmp_path / "wide.png")
    game = quiet(folder=tmp_path)
    assert game.add_background("wide.png", parallax=0.4) is not None
    game.camera.position = (300, 0)
    assert picture(game)[0, 0].tolist() == [255, 0, 0, 255]


def test_backgrounds_lie_in_the_order_in_which_they_were_added(stripes: Path) -> None:
    game = quiet(folder=stripes)
    layers = [game.add_background("stripes.png", parallax=p, height=1).layer for p in (0.1, 0.2, 0.5)]  # type: ignore[union-attr]
    assert layers == sorted(layers)
    assert [game.layers[layer].parallax for layer in layers] == [0.1, 0.2, 0.5]
    game.scene.clear()
    assert len(game.layers) == 0


def test_a_background_that_is_refused_leaves_nothing(stripes: Path) -> None:
    game = quiet(folder=stripes)
    for options in ({"parallax": -1}, {"height": 0}, {"parallax": "far"}, {"layer": 1.5}, {"colour": "bluue"}):
        with pytest.raises(evil.Error):
            game.add_background("stripes.png", **options)  # type: ignore[arg-type]
    with pytest.raises(evil.AssetError):
        game.add_background("none.png", parallax=0.5)
    assert (len(game.scene), len(game.layers), game.scene.backgrounds) == (0, 0, 0)


# ---- the door, saving ---------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("parallax", -0.1),
        ("parallax", None),
        ("blur", -1),
        ("blur", 1e9),
        ("fog", "smoke"),
        ("fog", ["red"] * 3),
        ("tint", 7),
    ],
)
def test_a_layer_refuses_what_it_cannot_be(name: str, value: Any) -> None:
    layer = quiet().layers[1]
    before = repr(layer)
    with pytest.raises(evil.Error, match="Layer"):
        setattr(layer, name, value)
    assert repr(layer) == before


@pytest.mark.parametrize("number", [1.5, "1", True, 10**7])
def test_layers_are_asked_for_by_whole_numbers(number: Any) -> None:
    game = quiet()
    with pytest.raises(evil.Error):
        game.layers[number]
    assert len(game.layers) == 0


def test_layers_are_saved(stripes: Path) -> None:
    game = quiet(folder=stripes)
    game.add_background("stripes.png", parallax=0.3)
    near = game.layers[2]
    near.parallax, near.fog, near.blur, near.tint, near.visible = 1.4, ["#fff4", "#fff0"], 2.0, "#333", False
    game.layers.perspective = True
    data = saving.to_bytes(game)
    other = quiet(folder=stripes)
    saving.from_bytes(other, data, "saved")
    assert saving.to_bytes(other) == data
    assert bytes(other.capture().pixels) == bytes(game.capture().pixels)
    near.fog = None
    game.layers[5].parallax = 0.1
    saving.from_bytes(game, data, "saved")
    assert game.layers[2] is near
    assert (near.fog, game.layers[5].parallax) == ([(1, 1, 1, 4 / 15), (1, 1, 1, 0)], 1.0)


def test_a_scene_begins_as_the_game_was_told() -> None:
    game = quiet()
    game.layers[-1].parallax, game.post.vignette = 0.5, 0.4

    @game.scenes
    def cave() -> None:
        game.layers[-1].parallax, game.post.bloom = 0.1, 1.0

    @game.scenes
    def field() -> None: ...

    game.go("cave")
    assert (game.layers[-1].parallax, game.post.bloom, game.post.vignette) == (0.1, 1.0, 0.4)
    game.go("field")
    assert (game.layers[-1].parallax, game.post.bloom, game.post.vignette) == (0.5, 0.0, 0.4)


# ---- pictures -----------------------------------------------------------------------------------------------------


def wood(renderer: str) -> Game:
    """Trees at four depths in fog, as in Limbo."""
    game = Game("Wood", size=(240, 160), headless=True, renderer=renderer, view_height=12)
    game.add_background("#9fb4c2")
    chance = random.Random(4)
    for layer, parallax, count, width in ((-4, 0.15, 14, 0.25), (-3, 0.3, 9, 0.4), (-2, 0.5, 6, 0.6), (2, 1.6, 1, 1.2)):
        for tree in range(count):
            x = -11 + 22 * (tree + 0.7 * chance.random()) / count + (15 if layer == 2 else 0)
            trunk = [(x - width, -7), (x + width, -7), (x + 0.4 * width, 7), (x - 0.3 * width, 7)]
            game.draw(evil.Polygon(trunk), layer=layer, colour="white")
            for branch in range(6):
                y, long = -3 + 1.7 * branch, chance.choice((-1, 1)) * chance.uniform(1, 2.5)
                tip = (x + long, y + 0.6 * abs(long))
                game.draw(evil.Polygon([(x, y), tip, (x, y + 0.8 * width)]), layer=layer, colour="white")
        game.layers[layer].parallax, game.layers[layer].tint = parallax, "#10161c"
    for layer, blur in ((-4, 2.0), (-3, 1.2), (-2, 0.6)):
        game.layers[layer].fog, game.layers[layer].blur = ["#c4d4dcb0", "#9fb4c270"], blur
    game.add(evil.Rectangle(40, 2), at=(0, -6), kind="static", colour="#05070a")
    game.camera.position = (1.5, 0.0)
    return game


def test_the_golden_picture_comes_out_to_the_bit() -> None:
    assert_golden("layers", wood("soft").capture().pixels)


def test_the_graphics_card_draws_it_as_the_processor_does() -> None:
    pytest.importorskip("moderngl")
    from drawing_gl import any_driver

    any_driver()
    game = wood("gl")
    assert game.renderer.name == "gl"
    difference = abs(picture(game) - picture(wood("soft")))
    assert difference.max() <= 5
    assert difference.mean() < 0.6


def test_every_instruction_set_blurs_to_the_same_bits() -> None:
    game = wood("soft")
    frame = game._collect()
    raster, shown = _core.Raster(), []
    for instructions in _core.instruction_sets():
        pixels = bytearray(240 * 160 * 4)
        raster.draw(frame.content, pixels, 240, 160, frame.background, instructions)
        shown.append(bytes(pixels))
    assert len(set(shown)) == 1


if __name__ == "__main__":
    wood("soft").capture().save(GOLDEN / "layers.png")
    print(GOLDEN / "layers.png", file=sys.stderr)
