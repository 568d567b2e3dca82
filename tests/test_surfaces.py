"""What surfaces do with light: bumps by pictures of normals, and what shines by itself."""

from __future__ import annotations

import math
import sys
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import PIL.Image
import pytest
from drawing_gl import any_driver
from golden_pictures import GOLDEN, assert_golden
from surfaces import FLAT, dome, hut, normal_colour, plain, surfaces, write

import evilengine as evil
from evilengine import _core
from evilengine.game import saving

Levels = npt.NDArray[np.int64]
SLANT = 1.5
"""kSlant in core/light/light_map.hpp."""


def game_in(folder: Path, renderer: str = "soft", size: tuple[int, int] = (160, 120)) -> evil.Game:
    return evil.Game("Surfaces", size=size, headless=True, renderer=renderer, gravity=(0, 0), folder=folder)


def levels(game: evil.Game) -> Levels:
    return np.asarray(game.capture().pixels).astype(np.int64)


def at(game: evil.Game, x: float, y: float) -> Levels:
    """Red, green and blue at a point of the world."""
    column, row = game.camera.to_pixel((x, y))
    return levels(game)[int(row), int(column), :3]


def sides(game: evil.Game) -> tuple[int, int, int, int]:
    """How bright a disc of radius 1 at the middle is: on its left, right, low and high side."""
    return tuple(int(at(game, *place).sum()) for place in ((-0.7, 0), (0.7, 0), (0, -0.7), (0, 0.7)))  # type: ignore[return-value]


# ---- normals ------------------------------------------------------------------------------------------------------


def test_flat_normals_change_no_pixel(tmp_path: Path) -> None:
    plain(tmp_path / "flat.png", FLAT)
    write(tmp_path / "gone.png", np.zeros((8, 8, 4)))  # nothing said: flat
    pictures = []
    for normals in (None, "flat.png", "gone.png"):
        game = game_in(tmp_path)
        game.draw(evil.Rectangle(4, 4), colour="#b0a090", angle=0.3, lit=True, normal_map=normals)
        game.add(evil.Circle(0.3), at=(0.4, 0.2), colour="white", lit=True)
        game.add_light(at=(-1, 0.5), colour="#ffc080", radius=3)
        game.add_light(direction=(1, 1), colour="#8090ff", intensity=0.3)
        pictures.append(bytes(game.capture().pixels))
    assert pictures[1] == pictures[0]
    assert pictures[2] == pictures[0]


@pytest.mark.parametrize("tilt", [(0.5, 0.0), (-0.5, 0.0), (0.3, 0.4), (-0.9, 0.3)])
def test_a_slope_gets_its_share_of_a_sun(tmp_path: Path, tilt: tuple[float, float]) -> None:
    plain(tmp_path / "slope.png", normal_colour(*tilt))
    game = game_in(tmp_path)
    game.draw(evil.Rectangle(4, 4), colour="white", lit=True, normal_map="slope.png")
    game.ambient = 0
    game.add_light(direction=(-1, 0), intensity=0.2)  # it comes from the right
    x, _, z = ((level - 128) / 127 for level in normal_colour(*tilt))
    share = max(z + SLANT * x, 0.0)
    assert at(game, 0, 0)[0] == pytest.approx(255 * 0.2 ** (29 / 64) * math.sqrt(share), abs=2)


def test_ambient_light_falls_from_where_one_looks(tmp_path: Path) -> None:
    plain(tmp_path / "slope.png", normal_colour(0.6, 0.0))
    game = game_in(tmp_path)
    game.draw(evil.Rectangle(4, 4), colour="white", lit=True, normal_map="slope.png")
    game.ambient = 0.5
    assert at(game, 0, 0)[0] == pytest.approx(255 * 0.5 ** (29 / 64) * math.sqrt(0.8), abs=1.5)


@pytest.mark.parametrize("turn", [0.0, 1.0, math.pi, -2.2])
@pytest.mark.parametrize("flip", [(False, False), (True, False), (False, True), (True, True)])
def test_bumps_face_the_light_however_they_are_turned_and_mirrored(
    tmp_path: Path, turn: float, flip: tuple[bool, bool]
) -> None:
    dome(tmp_path)
    game = game_in(tmp_path)
    ball = game.draw(evil.Circle(1), texture="dome.png", lit=True)
    ball.place((0, 0), turn)
    ball.flip_x, ball.flip_y = flip
    game.add_light(at=(-3, 0), radius=8)
    left, right, low, high = sides(game)
    assert left > 2 * right
    assert right < low < left
    assert right < high < left
    assert low == pytest.approx(high, abs=24)  # a pixel apart


def test_a_body_carries_its_bumps(tmp_path: Path) -> None:
    dome(tmp_path)
    game = game_in(tmp_path)
    ball = game.add(evil.Circle(1), texture="dome.png", lit=True, angular_velocity=math.pi)
    game.lights.depth = 3
    game.add_light(at=(0, 3), radius=8)
    game.step(30)
    assert ball.angle == pytest.approx(math.pi / 2, abs=0.01)
    left, right, low, high = sides(game)
    assert high > 2 * low
    assert left == pytest.approx(right, abs=24)


def test_each_lamp_colours_its_own_side(tmp_path: Path) -> None:
    dome(tmp_path)
    game = game_in(tmp_path)
    game.draw(evil.Circle(1), texture="dome.png", lit=True)
    game.ambient = 0
    game.add_light(at=(-3, 0), colour="red", radius=6)
    game.add_light(at=(3, 0), colour="blue", radius=6)
    left, right = at(game, -0.8, 0), at(game, 0.8, 0)
    assert left[0] > 1.5 * left[2]
    assert right[2] > 1.5 * right[0]


def test_normals_beside_a_picture_are_found_and_others_may_be_named(tmp_path: Path) -> None:
    dome(tmp_path)
    plain(tmp_path / "plain.png", (210, 210, 210))
    pictures = []
    for words in ({"texture": "dome.png"}, {"texture": "plain.png", "normal_map": "dome.normal.png"}):
        game = game_in(tmp_path)
        drawing = game.draw(evil.Rectangle(1.2, 1.2), lit=True, **words)  # type: ignore[arg-type]
        game.add_light(at=(-3, 1), radius=8)
        assert drawing.normal_map == words.get("normal_map")
        pictures.append(levels(game)[40:80, 60:100])
    assert (pictures[0] == pictures[1]).all()


def test_frames_of_a_sheet_have_their_own_normals(tmp_path: Path) -> None:
    plain(tmp_path / "walk.png", (200, 200, 200), 32)
    slopes = np.full((32, 32, 3), normal_colour(-0.6, 0.0))
    slopes[:, 16:] = normal_colour(0.6, 0.0)
    write(tmp_path / "walk.normal.png", slopes)
    game = game_in(tmp_path)
    walker = game.draw(evil.Rectangle(2, 2), texture=evil.Sheet("walk.png", 2, 1), lit=True)
    game.add_light(direction=(-1, 0), intensity=0.3)
    away = at(game, 0, 0)[0]
    walker.frame = 1
    assert at(game, 0, 0)[0] > 2 * away


def test_a_map_is_changed_and_taken_away(tmp_path: Path) -> None:
    plain(tmp_path / "slope.png", normal_colour(-0.6, 0.0))
    game = game_in(tmp_path)
    wall = game.draw(evil.Rectangle(2, 2), colour="white", lit=True)
    game.add_light(direction=(-1, 0), intensity=0.3)
    flat = at(game, 0, 0)[0]
    wall.normal_map = "slope.png"
    assert (wall.normal_map, at(game, 0, 0)[0] < flat) == ("slope.png", True)
    wall.normal_map = None
    assert (wall.normal_map, at(game, 0, 0)[0]) == (None, flat)


def test_what_is_not_lit_has_no_bumps(tmp_path: Path) -> None:
    dome(tmp_path)
    game = game_in(tmp_path)
    game.draw(evil.Circle(1), texture="dome.png")
    game.add_light(at=(-3, 0), radius=8)
    assert len(set(sides(game))) == 1


def test_a_file_of_normals_that_changes_is_seen(tmp_path: Path) -> None:
    plain(tmp_path / "slope.png", normal_colour(-0.6, 0.0))
    game = game_in(tmp_path)
    game.draw(evil.Rectangle(2, 2), colour="white", lit=True, normal_map="slope.png")
    game.add_light(direction=(-1, 0), intensity=0.3)
    before = at(game, 0, 0)[0]
    plain(tmp_path / "slope.png", normal_colour(0.6, 0.0), 24)
    assert game.reload_images() == []
    assert at(game, 0, 0)[0] > before


def test_normals_and_glow_that_come_later_are_seen(tmp_path: Path) -> None:
    plain(tmp_path / "rock.png", (255, 255, 255))
    game = game_in(tmp_path)
    rock = game.draw(evil.Rectangle(2, 2), texture="rock.png", lit=True)
    game.add_light(direction=(-1, 0), intensity=0.3)
    flat = at(game, 0, 0)
    plain(tmp_path / "rock.normal.png", normal_colour(0.9, 0.0))
    assert game.reload_images() == []
    assert tuple(at(game, 0, 0)) != tuple(flat)
    (tmp_path / "rock.glow.png").write_bytes(b"half saved")
    (line,) = game.reload_images()
    assert "rock.glow.png" in line
    assert game.reload_images() == []
    plain(tmp_path / "rock.glow.png", (0, 255, 0))
    assert game.reload_images() == []
    assert at(game, 0, 0)[1] == 255
    (tmp_path / "rock.normal.png").unlink()
    shown = at(game, 0, 0)
    assert game.reload_images() == []
    assert tuple(at(game, 0, 0)) == tuple(shown)
    assert rock.normal_map is None


# ---- what shines by itself ----------------------------------------------------------------------------------------


def test_what_glows_is_seen_in_the_dark(tmp_path: Path) -> None:
    hut(tmp_path)
    game = game_in(tmp_path)
    game.draw(evil.Rectangle(2, 2), texture="hut.png", lit=True)
    game.draw(evil.Circle(0.2), at=(-1.4, 0), colour="#ff8040", lit=True, glow=1)
    game.draw(evil.Circle(0.2), at=(1.4, 0), colour="#ff8040", lit=True)
    game.ambient = 0
    assert tuple(at(game, -0.4, 0)) == (255, 200, 90)
    assert tuple(at(game, 0, 0)) == (0, 0, 0)
    assert tuple(at(game, -1.4, 0)) == (255, 128, 64)
    assert tuple(at(game, 1.4, 0)) == (0, 0, 0)


def test_glow_adds_to_light_as_light_adds_up(tmp_path: Path) -> None:
    game = game_in(tmp_path)
    game.draw(evil.Rectangle(2, 2), colour="#808080", lit=True, glow=0.5)
    game.ambient = 0.25
    lit = 128 * 0.25 ** (29 / 64)
    assert at(game, 0, 0)[0] == pytest.approx(math.hypot(lit, 64), abs=1.5)


def test_glow_ends_at_white_and_fades_with_what_is_transparent(tmp_path: Path) -> None:
    game = game_in(tmp_path)
    game.scene.background = "black"
    game.draw(evil.Rectangle(2, 2), colour=(0.5, 0.25, 0.0, 0.5), lit=True, glow=64)
    assert tuple(at(game, 0, 0)) == (128, 128, 0)


def test_how_strongly_it_glows_is_its_own_or_the_pictures(tmp_path: Path) -> None:
    hut(tmp_path)
    game = game_in(tmp_path)
    house = game.draw(evil.Rectangle(2, 2), texture="hut.png", lit=True)
    game.ambient = 0
    assert house.glow is None
    house.glow = 0
    assert tuple(at(game, -0.4, 0)) == (0, 0, 0)
    house.glow = 0.5
    assert tuple(at(game, -0.4, 0)) == (128, 100, 45)
    house.glow, house.texture = None, None
    assert tuple(at(game, -0.4, 0)) == (0, 0, 0)
    house.glow_map = "hut.glow.png"
    assert house.glow_map == "hut.glow.png"
    assert tuple(at(game, -0.4, 0)) == (255, 200, 90)
    house.glow_map = None
    assert tuple(at(game, -0.4, 0)) == (0, 0, 0)


def test_bloom_takes_up_what_glows(tmp_path: Path) -> None:
    game = game_in(tmp_path)
    game.scene.background = "black"
    game.draw(evil.Circle(0.4), colour="white", lit=True, glow=1)
    game.ambient = 0
    dark = at(game, 0.6, 0).sum()
    game.post.bloom = 1
    assert at(game, 0.6, 0).sum() > dark + 20


# ---- all of it ----------------------------------------------------------------------------------------------------


def test_the_golden_picture_of_surfaces_comes_out_to_the_bit(tmp_path: Path) -> None:
    assert_golden("surfaces", surfaces(tmp_path).capture().pixels)


def test_every_instruction_set_draws_the_same(tmp_path: Path) -> None:
    content = surfaces(tmp_path)._collect().content
    raster = _core.Raster()
    for name in ("bricks", "bricks.normal", "dome", "dome.normal", "hut", "hut.glow"):
        with PIL.Image.open(tmp_path / f"{name}.png") as picture:
            raster.upload(picture.convert("RGBA").tobytes(), *picture.size)
    pictures = set()
    for instructions in _core.instruction_sets():
        pixels = bytearray(320 * 180 * 4)
        raster.draw(content, pixels, 320, 180, instructions=instructions)
        pictures.add(bytes(pixels))
    assert len(pictures) == 1


def test_the_graphics_card_draws_the_same(tmp_path: Path) -> None:
    any_driver()
    soft, gl = levels(surfaces(tmp_path)), levels(surfaces(tmp_path, "gl"))
    apart = np.abs(soft - gl).max(axis=2)
    assert (apart > 3).mean() < 0.001, "but where a slope is all but turned away, and the root of its share is steep"
    assert apart.max() <= 16


def test_more_pictures_than_a_draw_call_mixes_are_drawn_all_the_same(tmp_path: Path) -> None:
    any_driver()
    pictures = []
    for number in range(6):
        plain(tmp_path / f"{number}.png", (40 * number, 255 - 40 * number, 90))
        plain(tmp_path / f"{number}.normal.png", normal_colour(0.1 * number, 0.0))
        plain(tmp_path / f"{number}.glow.png", (0, 0, 30 * number))
    for renderer in ("soft", "gl"):
        game = game_in(tmp_path, renderer)
        for number in range(6):
            game.draw(evil.Rectangle(0.5, 2), at=(-1.25 + 0.5 * number, 0), texture=f"{number}.png", lit=True)
        game.add_light(at=(3, 0), radius=9)
        pictures.append(levels(game))
    assert np.abs(pictures[0] - pictures[1]).max() <= 3
    assert pictures[0][60, :, 2].max() > 120


def test_surfaces_are_saved(tmp_path: Path) -> None:
    game = surfaces(tmp_path)
    coal = game.draw(evil.Circle(1), at=(2, 3), normal_map="dome.normal.png", glow_map="hut.glow.png", glow=2, lit=True)
    data = saving.to_bytes(game)
    coal.glow, coal.normal_map = 0, None
    other = game_in(tmp_path, size=(320, 180))
    saving.from_bytes(other, data, "saved")
    assert saving.to_bytes(other) == data
    saving.from_bytes(game, data, "saved")
    assert (coal.glow, coal.normal_map, coal.glow_map) == (2, "dome.normal.png", "hut.glow.png")
    assert bytes(other.capture().pixels) == bytes(game.capture().pixels)


@pytest.mark.parametrize(
    ("words", "kind", "said"),
    [
        ({"glow": -1}, evil.ArgumentError, "glow=-1"),
        ({"glow": math.nan}, evil.ArgumentError, "glow=nan"),
        ({"glow": 65}, evil.ArgumentError, "64"),
        ({"glow": "bright"}, evil.ArgumentTypeError, "glow='bright'"),
        ({"normal_map": 3}, evil.ArgumentTypeError, "normal_map=3"),
        ({"normal_map": "rok.png"}, evil.AssetError, "rok.png"),
        ({"glow_map": "rok.png"}, evil.AssetError, "rok.png"),
        ({"texture": "torn.png"}, evil.AssetError, "torn.normal.png"),
    ],
)
def test_what_cannot_be_is_refused_and_nothing_is_drawn(
    tmp_path: Path, words: dict[str, Any], kind: type[Exception], said: str
) -> None:
    plain(tmp_path / "torn.png", (1, 2, 3))
    (tmp_path / "torn.normal.png").write_bytes(b"no picture")
    game = game_in(tmp_path)
    with pytest.raises(kind, match=said):
        game.draw(evil.Circle(1), **words)
    assert len(game.scene) == 0


if __name__ == "__main__":
    import tempfile

    with tempfile.TemporaryDirectory() as folder:
        surfaces(Path(folder)).capture().save(GOLDEN / "surfaces.png")
    print(GOLDEN / "surfaces.png", file=sys.stderr)
