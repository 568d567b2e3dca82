"""Lights that shine through a picture: windows, stained glass, leaves."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from drawing_gl import any_driver
from golden_pictures import assert_golden
from lighting import light_of, lit_game
from surfaces import plain, write

import evilengine as evil
from evilengine import _core
from evilengine.game import saving
from evilengine.platform import HeadlessDevice


def panes(folder: Path) -> None:
    """`panes.png`: red, green, blue and yellow, with a black cross between, 32 x 32."""
    picture = np.zeros((32, 32, 3))
    picture[:15, :15], picture[:15, 17:] = (255, 0, 0), (0, 255, 0)
    picture[17:, :15], picture[17:, 17:] = (0, 0, 255), (255, 255, 0)
    write(folder / "panes.png", picture)


def light_at(game: evil.Game, *places: tuple[float, float]) -> list[tuple[float, ...]]:
    """Linear light at points of the world, rounded."""
    light, where = light_of(game)
    found = []
    for place in places:
        row, column = np.unravel_index(
            np.hypot(*(where - np.array(place)).transpose(2, 0, 1)).argmin(), where.shape[:2]
        )
        found.append(tuple(round(float(level), 2) + 0.0 for level in light[row, column]))
    return found


CORNERS = ((-0.7, 0.7), (0.7, 0.7), (-0.7, -0.7), (0.7, -0.7))
RED, GREEN, BLUE, YELLOW = (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 0)


def window(folder: Path, **options: Any) -> evil.Game:
    panes(folder)
    game = lit_game(folder=folder)
    game.add_light(at=(0, 0), radius=2, texture="panes.png", **options)
    return game


def test_a_lamp_shines_through_its_picture(tmp_path: Path) -> None:
    game = window(tmp_path)
    assert light_at(game, *CORNERS) == [RED, GREEN, BLUE, YELLOW]
    assert light_at(game, (0, 0), (0, 0.7), (1.6, 0), (0, -1.6)) == [(0, 0, 0)] * 4


def test_it_turns_and_grows_with_the_lamp(tmp_path: Path) -> None:
    game = window(tmp_path, angle=math.pi / 2)
    assert light_at(game, *CORNERS) == [GREEN, YELLOW, RED, BLUE]
    (lamp,) = game.lights
    lamp.angle, lamp.radius = 0, 4
    assert light_at(game, (-2, 2), (2, -2)) == [RED, YELLOW]


def test_it_turns_with_the_body_that_it_is_on(tmp_path: Path) -> None:
    panes(tmp_path)
    game = lit_game(folder=tmp_path)
    holder = game.add(evil.Circle(0.2), at=(0, 0), angle=math.pi, sensor=True, colour="white")
    game.add_light(body=holder, radius=2, texture="panes.png", shadows=False)
    assert light_at(game, *CORNERS) == [YELLOW, BLUE, GREEN, RED]


def test_colour_and_falloff_go_with_it(tmp_path: Path) -> None:
    game = window(tmp_path, colour="red", intensity=0.5)
    assert light_at(game, *CORNERS[:2]) == [(0.5, 0, 0), (0, 0, 0)]
    (lamp,) = game.lights
    assert lamp.falloff == 0
    lamp.falloff = 1
    assert light_at(game, CORNERS[0])[0][0] == pytest.approx(0.5 * (1 - math.hypot(0.7, 0.7) / 2), abs=0.03)


def test_bodies_cast_shadows_in_it(tmp_path: Path) -> None:
    game = window(tmp_path)
    game.add(evil.Circle(0.1), at=(-0.4, 0.4), kind="static")
    assert light_at(game, *CORNERS) == [(0, 0, 0), GREEN, BLUE, YELLOW]


def test_a_suns_picture_is_laid_again_and_again(tmp_path: Path) -> None:
    panes(tmp_path)
    game = lit_game(folder=tmp_path)
    game.add_light(direction=(1, 0), radius=math.sqrt(0.5), texture="panes.png")  # a metre wide and high
    for across in (-1, 0, 1):
        x = across + 0.25
        assert light_at(game, (x, 0.25), (x, -0.25)) == [GREEN, YELLOW]
        assert light_at(game, (x - 0.5, 0.25), (x - 0.5, -0.25)) == [RED, BLUE]


def test_a_light_that_does_not_fade_ends_at_its_radius(tmp_path: Path) -> None:
    game = lit_game()
    game.add_light(at=(0, 0), radius=1, falloff=0)
    assert light_at(game, (0.8, 0), (1.15, 0), (0.9, 0.9)) == [(1, 1, 1), (0, 0, 0), (0, 0, 0)]


def test_what_is_transparent_lets_no_light_through(tmp_path: Path) -> None:
    plain(tmp_path / "half.png", (255, 255, 255, 128))
    game = lit_game(folder=tmp_path)
    game.add_light(at=(0, 0), radius=2, texture="half.png")
    assert light_at(game, (0, 0))[0][0] == pytest.approx((128 / 255) ** (64 / 29), abs=0.01)


def test_a_picture_much_finer_than_the_light_map_is_seen_as_its_mean(tmp_path: Path) -> None:
    write(tmp_path / "fine.png", np.indices((512, 512)).sum(axis=0)[..., None] % 2 * np.full(3, 255))
    game = lit_game(folder=tmp_path)
    game.add_light(at=(0, 0), radius=0.5, texture="fine.png")
    light, where = light_of(game)
    inside = np.abs(where).max(axis=2) < 0.3
    assert light[inside].std() < 0.02
    assert light[inside].mean() == pytest.approx((128 / 255) ** (64 / 29), abs=0.02)


def test_a_picture_is_named_changed_and_taken_away(tmp_path: Path) -> None:
    game = window(tmp_path)
    plain(tmp_path / "clear.png", (255, 255, 255))
    (lamp,) = game.lights
    assert lamp.texture == "panes.png"
    lamp.texture = "clear.png"
    assert light_at(game, *CORNERS) == [(1, 1, 1)] * 4
    lamp.texture = None
    assert lamp.texture is None
    assert light_at(game, (1.6, 0)) == [(1, 1, 1)]


def test_saved_lights_shine_through_their_pictures(tmp_path: Path) -> None:
    game = window(tmp_path, angle=0.3, static=True)
    data = saving.to_bytes(game)
    other = lit_game(folder=tmp_path)
    other.add_light(at=(0, 0), texture="panes.png")
    saving.from_bytes(other, data, "saved")
    (lamp,) = other.lights
    assert (lamp.texture, lamp.static, lamp.falloff) == ("panes.png", True, 0)
    assert saving.to_bytes(other) == data
    assert bytes(other.capture().pixels) == bytes(game.capture().pixels)
    (tmp_path / "panes.png").unlink()
    third = lit_game(folder=tmp_path)
    with pytest.raises(evil.Error, match=r"panes\.png"):
        saving.from_bytes(third, data, "saved")
    assert len(third.lights) == 0


def test_a_changed_picture_is_shone_through_and_a_broken_one_is_not(tmp_path: Path) -> None:
    game = window(tmp_path, static=True)
    assert light_at(game, *CORNERS)[0] == RED
    plain(tmp_path / "panes.png", (255, 255, 255), size=3)
    assert game.reload_images() == []
    assert light_at(game, *CORNERS) == [(1, 1, 1)] * 4
    (tmp_path / "panes.png").write_bytes(b"no picture")
    (line,) = game.reload_images()
    assert "panes.png" in line
    (tmp_path / "panes.png").unlink()
    assert game.reload_images() == []
    assert light_at(game, *CORNERS) == [(1, 1, 1)] * 4
    assert [light.texture for light in game.lights] == ["panes.png"]


def test_dense_screens_shine_through_the_finer_picture(tmp_path: Path) -> None:
    panes(tmp_path)
    plain(tmp_path / "panes@2x.png", (255, 255, 0), size=64)
    found = []
    for scale in (1.0, 2.0):
        game = evil.Game(device=HeadlessDevice((320, 180), scale=scale), renderer="soft", folder=tmp_path)
        game.draw(evil.Rectangle(200, 200), colour="white", lit=True, outline=False)
        game.ambient = 0
        game.add_light(at=(0, 0), radius=2, texture="panes.png")
        pixels = np.asarray(game.capture().pixels)
        found.append([tuple(pixels[int(scale * (90 - 50 * y)), int(scale * (160 + 50 * x)), :3]) for x, y in CORNERS])
    assert found[0] == [(255, 0, 0), (0, 255, 0), (0, 0, 255), (255, 255, 0)]
    assert found[1] == [(255, 255, 0)] * 4


def slides(folder: Path, renderer: str = "soft") -> evil.Game:
    """Two windows and leaves, on a wall with a ledge."""
    panes(folder)
    spots = np.indices((32, 32)).astype(float) - 15.5
    write(folder / "leaves.png", np.clip(16 - np.hypot(*spots), 0, 8)[..., None] * np.full(3, 31))
    game = evil.Game("Slides", size=(320, 180), headless=True, renderer=renderer, folder=folder)
    game.camera.view_height = 9
    game.draw(evil.Rectangle(20, 12), colour="#b0a898", lit=True, layer=-1, outline=False)
    game.add(evil.Rectangle(3, 0.3), at=(-3, -1), kind="static", colour="#806040", lit=True)
    game.ambient = 0.05
    game.add_light(at=(-3, 0.5), radius=3, intensity=2, texture="panes.png")
    game.add_light(at=(3, 0), radius=2.5, angle=0.5, texture="panes.png", size=0.4)
    game.add_light(direction=(1, -2), radius=0.8, texture="leaves.png", colour="#bcd8ff", intensity=0.3)
    return game


def test_the_golden_picture_of_slides_comes_out_to_the_bit(tmp_path: Path) -> None:
    assert_golden("light_slides", slides(tmp_path).capture().pixels)


def test_every_instruction_set_gives_the_same_light(tmp_path: Path) -> None:
    found = set()
    for instructions in _core.instruction_sets():
        game = slides(tmp_path)
        game.world._core.instruction_set = instructions
        found.add(bytes(game.capture().pixels))
    assert len(found) == 1


def test_the_graphics_card_draws_the_same(tmp_path: Path) -> None:
    any_driver()
    soft, gl = (np.asarray(slides(tmp_path, name).capture().pixels).astype(int) for name in ("soft", "gl"))
    assert np.abs(soft - gl).max() <= 3


@pytest.mark.parametrize(
    ("words", "kind", "said"),
    [
        ({"texture": 3}, evil.ArgumentTypeError, "texture=3"),
        ({"texture": "pains.png"}, evil.AssetError, "pains.png"),
        ({"angle": math.nan}, evil.ArgumentError, "angle=nan"),
        ({"angle": 1.0, "direction": (1, 0)}, evil.ArgumentError, "leave angle=1.0 out"),
    ],
)
def test_what_cannot_be_is_refused(tmp_path: Path, words: dict[str, Any], kind: type[Exception], said: str) -> None:
    game = lit_game(folder=tmp_path)
    with pytest.raises(kind, match=said):
        game.add_light(at=(0, 0), **words)
    assert len(game.lights) == 0


if __name__ == "__main__":
    import sys
    import tempfile

    from golden_pictures import GOLDEN

    with tempfile.TemporaryDirectory() as made:
        slides(Path(made)).capture().save(GOLDEN / "light_slides.png")
    print(GOLDEN / "light_slides.png", file=sys.stderr)
