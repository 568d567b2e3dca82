"""How water is seen: a smooth surface, clear at its edge and deep below; the same on both renderers, and saved."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from drawing_gl import any_driver
from golden_pictures import assert_golden
from sea import AREA, SIZE, game_of, jet, pixels, pool, pour, scenery, wave

import evilengine as evil

PLAIN = {"ramp": ["#ffff", "#ffff"], "rim": 0.0, "refraction": 0.0}
"""White all through."""

SCENES = ("pool", "wave", "jet", "lit", "turned", "liquids")


def share_of_white(game: evil.Game) -> Any:
    """How much of each pixel is water that is white, over black."""
    return pixels(game)[..., 0] / 255


def black(renderer: str = "soft", size: tuple[int, int] = (320, 200)) -> evil.Game:
    game = game_of(renderer, size)
    game.scene.background = "black"
    return game


def scene_of(name: str, renderer: str) -> evil.Game:
    game = game_of(renderer)
    lit = name == "lit"
    scenery(game, lit=lit)
    if lit:
        game.ambient = 0.3
        game.add_light(at=(-2.5, 1.5), colour="#ffd9a0", radius=6)
        game.add_light(at=(2, 0.5), colour="#80b0ff", radius=4)
    water = pour(game, {"pool": pool, "jet": jet}.get(name, wave), noise=0.0 if name == "liquids" else 0.2)
    if name == "liquids":
        kinds = [water.add_liquid(colour="#e0a020"), water.add_liquid(colour="#c03050")]
        for kind, left in zip(kinds, (-1.5, 1.0), strict=True):
            water.fill((left, -0.8, left + 1.5, 0.9), liquid=kind)
    if name == "turned":
        game.camera.angle = 0.4
        game.camera.zoom *= 2
    return game


@pytest.mark.parametrize("name", SCENES)
def test_water_looks_as_it_did(name: str) -> None:
    assert_golden(f"water_{name}", scene_of(name, "soft").capture().pixels)


@pytest.mark.parametrize("name", SCENES)
def test_both_renderers_show_the_same_water(name: str) -> None:
    any_driver()
    game = scene_of(name, "gl")
    assert_golden(f"water_{name}", game.capture().pixels, 3)


def test_a_calm_pool_has_a_straight_line_at_its_own_height() -> None:
    game = black()
    pour(game, pool, noise=0.2, **PLAIN)
    level = share_of_white(game).sum(axis=0)[10:-10]
    assert abs(level.mean() - 80) < 1.0  # 2 metres
    assert level.max() - level.min() < 1.2
    assert abs(np.diff(level)).max() < 0.1


def test_water_meets_walls_and_floor_without_a_gap() -> None:
    game = black()
    game.add(evil.Rectangle(1, 5), at=(1, 0), angle=0.2, kind="static", colour="white", layer=-1)
    pour(game, pool, **PLAIN)
    below = share_of_white(game)[130:175]
    assert below.min() > 0.9


def test_a_single_drop_is_round_and_as_large_as_it_is() -> None:
    game = black(size=(1280, 800))
    water = pour(game, lambda x, y: (abs(x - 0.05) < 0.01) & (abs(y - 0.05) < 0.01), **PLAIN)
    assert water.count == 1
    white = share_of_white(game)
    y, x = np.mgrid[0.5:800, 0.5:1280]
    middle = (white * x).sum() / white.sum(), (white * y).sum() / white.sum()
    assert middle == pytest.approx((648, 392), abs=0.5)
    assert white.sum() == pytest.approx((SIZE * 160) ** 2, rel=0.3)
    spread = [(white * (axis - mean) ** 2).sum() for axis, mean in zip((x, y), middle, strict=True)]
    assert spread[0] == pytest.approx(spread[1], rel=0.03)


def test_a_jet_of_single_particles_stays_whole() -> None:
    game = black()
    pour(game, lambda x, y: (abs(y - 0.05) < 0.01) & (abs(x) < 3), noise=0.25, **PLAIN)
    thick = share_of_white(game)[:, 50:270].sum(axis=0)
    assert thick.min() > 1.5


def test_clumps_of_particles_are_no_combs() -> None:
    """Liquid that flowed apart lies in columns: as many particles in each cell as ever, with gaps between."""
    game = black()
    water = pour(game, pool, **PLAIN)
    positions = np.asarray(water.positions)
    positions[:, 0] = -4 + 0.3 * np.floor((positions[:, 0] + 4) / 0.3) + 0.15
    white = share_of_white(game)
    assert white[126:190].min() > 0.9
    assert white[:116].max() == 0.0


def test_the_border_of_two_liquids_is_sharp() -> None:
    game = black()
    water = game.add_water(AREA, particle_size=SIZE, ramp=["#00f", "#00f"], rim=0, refraction=0)
    oil = water.add_liquid(colour="#f00")
    water.fill((-4, -2.5, 4, -0.5))
    water.fill((-4, -0.5, 4, 1.0), liquid=oil)
    column = pixels(game)[70:170, 100]
    mixed = (column[:, 0] > 0.1 * column[:, 0].max()) & (column[:, 2] > 0.1 * column[:, 2].max())
    assert 0 < mixed.sum() <= 0.1 * 40 * 1.5, "as wide as one particle and a half"


def test_behind_what_swims_there_is_the_liquid_that_is_round_it() -> None:
    game = black()
    water = game.add_water((-5, -3, 5, 3), particle_size=SIZE, ramp=["#0000ff", "#0000ff"], rim=0, refraction=0)
    oil = water.add_liquid(density=0.8, colour="#ff0000")
    game.add(evil.Rectangle(2, 1), at=(0, -1), layer=-1, colour="#808080", density=0.5)
    water.fill((-5, -3, 5, 1), liquid=oil)
    seen = pixels(game).astype(int)
    inside, beside = seen[132, 130:190], seen[132, 60]
    assert beside[0] > beside[2] + 50
    assert (inside[:, 0] > inside[:, 2] + 20).all()


def test_two_drops_apart_stay_two() -> None:
    game = black()
    pour(game, lambda x, y: (abs(y - 0.05) < 0.01) & ((abs(x - 0.05) < 0.01) | (abs(x - 0.45) < 0.01)), **PLAIN)
    row = share_of_white(game)[98]
    assert row[162] > 0.7
    assert row[178] > 0.7
    assert row[170] < 0.05


def test_the_deep_is_darker_than_the_surface_and_clear_water_is_clearer() -> None:
    def shown(clarity: float) -> Any:
        game = game_of()
        game.scene.background = "white"
        pour(game, pool, clarity=clarity, rim=0, refraction=0)
        return pixels(game)[:, 160].sum(axis=1)

    clear, murky = shown(4.0), shown(0.5)
    assert (np.diff(murky[125:190]) <= 3).all()
    assert murky[190] < murky[125] - 100
    assert clear[190] > murky[190] + 60


def test_what_lies_behind_is_displaced_at_the_surface_and_wavers_inside() -> None:
    def edges(**looks: Any) -> Any:
        game = game_of()
        game.draw(evil.Rectangle(1, 5), colour="white", layer=-1)
        pour(game, pool, ramp=["#0001", "#0001"], rim=0, waves=2, **looks)
        return pixels(game)[..., 0]

    still, bent = edges(refraction=0), edges()
    assert (still[140:190] == still[150]).all()
    assert (bent != still).any()
    assert (bent[:100] == still[:100]).all()
    lit = bent[130:190] > bent[150:155, 20:60].max() + 20  # the stripe
    assert len(set(lit.argmax(axis=1).tolist())) > 2  # its edge is no straight line any more


def test_lamps_shine_on_water_and_shadows_fall_on_it() -> None:
    game = game_of()
    game.ambient = 0.1
    game.add_light(at=(-2, 2), colour="white", radius=8)
    game.add(evil.Rectangle(1.2, 0.3), at=(-0.5, 0.8), kind="static")
    pour(game, pool, ramp=["#48c", "#48c"])
    row = pixels(game)[130].sum(axis=1)
    assert row[70] > 1.6 * row[300]
    assert row[70] > 1.3 * row[195:215].min()  # behind the board
    game.scene.waters.alive()[0]._core.lit = False
    assert pixels(game)[130].sum(axis=1)[300] > 1.6 * row[300]


def test_a_body_that_swims_is_seen_through_the_water_and_a_wall_is_not() -> None:
    game = game_of()
    game.add(evil.Rectangle(1, 1), at=(0, -0.5), colour="white", outline=False)
    game.add(evil.Rectangle(1, 1), at=(2, -0.5), kind="static", colour="white", outline=False)
    pour(game, pool, ramp=["#00f8", "#00f8"], rim=0, refraction=0)
    picture = pixels(game)
    assert picture[110, 160].tolist() == [255, 255, 255]
    assert picture[132, 160, 0] < 160
    assert picture[110, 240].tolist() == picture[132, 240].tolist() == [255, 255, 255]


def test_liquids_have_their_own_colours_and_mix_at_their_border() -> None:
    game = game_of()
    water = pour(game, lambda x, y: (y < 0) & (x < 0), colour="blue", rim=0)
    water.fill((0, -2.5, 4, 0), liquid=water.add_liquid(colour="red"))
    row = pixels(game)[180]
    left, right = row[80], row[240]
    assert left[2] > 2 * left[0]
    assert right[0] > 2 * right[2]
    reds = row[140:180, 0]
    assert (np.diff(reds) >= -2).all()
    assert ((reds > left[0] + 10) & (reds < right[0] - 10)).sum() >= 4


def test_it_is_drawn_over_its_layer_and_under_the_next() -> None:
    game = game_of()
    game.draw(evil.Rectangle(8, 5), colour="red", layer=2)
    game.draw(evil.Rectangle(2, 5), colour="lime", layer=4)
    pour(game, pool, layer=3, ramp=["#00f", "#00f"], rim=0)
    picture = pixels(game)
    assert picture[50, 60].tolist() == [255, 0, 0]
    assert picture[180, 60].tolist() == [0, 0, 255]
    assert picture[180, 160].tolist() == [0, 255, 0]


def test_every_view_shows_it() -> None:
    game = game_of()
    pour(game, pool, **PLAIN)
    game.add_view((0.6, 0.6, 1, 1), view_height=5)
    picture = pixels(game)
    assert picture[180, 100].tolist() == [255, 255, 255]
    assert picture[70, 300].tolist() == [255, 255, 255]
    assert picture[20, 300].tolist() != [255, 255, 255]


def test_it_has_the_same_bits_whatever_it_showed_before() -> None:
    game = scene_of("wave", "soft")
    first = pixels(game)
    game.camera.zoom *= 3
    pixels(game)
    game.camera.zoom /= 3
    assert np.array_equal(pixels(game), first)


def test_fast_water_throws_up_foam_that_fades_again() -> None:
    calm = game_of()
    pour(calm, pool, foam=2)
    calm.step(60)
    assert calm.scene.waters.alive()[0]._foam.count == 0

    game = game_of()
    water = pour(game, lambda x, y: (x < -2) & (y < 2), foam=2)
    foam = game.scene.waters.alive()[0]._foam
    game.step(90)
    assert foam.count > 20
    np.asarray(water.velocities)[:] = 0
    game.scene.waters.alive()[0].foam = 0.0
    game.step(1000)
    assert foam.count == 0


def test_bodies_stop_foam() -> None:
    game = game_of()
    game.add(evil.Rectangle(0.5, 1.6), at=(0.5, -1.7), kind="static")
    game.add(evil.Rectangle(8, 0.6), at=(0, -2.4), kind="static")
    game.add(evil.Circle(0.4), at=(2, -1.5), density=0.5)
    pour(game, lambda x, y: (x < -2) & (y < 2), foam=3)
    foam, seen, inside = game.scene.waters.alive()[0]._foam, 0, 0
    for _ in range(30):
        game.step(5)
        if foam.count == 0:
            continue
        flecks = np.frombuffer(foam.snapshot()[-32 * foam.count :], np.float32).reshape(-1, 8)
        seen += foam.count
        inside += sum(bool(found) for found in game.world.bodies_at_each(flecks[:, :2]))
    assert seen > 2000
    assert inside < 0.005 * seen  # a body may be pushed over some


def test_without_foam_there_is_none() -> None:
    game = game_of()
    pour(game, lambda x, y: (x < -2) & (y < 2), foam=0)
    game.step(90)
    assert game.scene.waters.alive()[0]._foam.count == 0


def test_looks_go_with_their_water() -> None:
    game = game_of()
    before = pixels(game)
    water = pour(game, pool)
    assert (pixels(game) != before).any()
    water.destroy()
    assert (pixels(game) == before).all()


def test_saved_looks_show_the_same_water() -> None:
    game = game_of()
    scenery(game)
    looks: dict[str, Any] = {"ramp": ["#8f84", "#fffa", "#000"], "clarity": 0.7, "rim": 0.3, "waves": 2, "foam": 3}
    pour(game, lambda x, y: (x < -2) & (y < 2), **looks)
    game.step(60)
    waters = game.scene.waters
    before, saved = pixels(game), waters.state()
    assert waters.alive()[0]._foam.count > 0
    waters.clear()
    assert (pixels(game) != before).any()
    waters.put(waters.read(json.loads(json.dumps(saved))))
    assert np.array_equal(pixels(game), before)


def test_a_saved_game_goes_on_with_the_same_water(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path))
    game = game_of()
    scenery(game)
    pour(game, lambda x, y: (x < -2) & (y < 2), ramp=["#8f84", "#fffa", "#000"], foam=3)
    game.step(60)
    game.save("sea")
    other = game_of()
    other.resume("sea")
    assert np.array_equal(pixels(other), pixels(game))
    for each in (game, other):
        each.step(10)
    assert np.array_equal(pixels(other), pixels(game))


@pytest.mark.parametrize("damage", [{"flecks": "AAAA"}, {"flecks": "?"}, {"clarity": -1.0}, {"ramp": [[0, 0, 0, 1]]}])
def test_damaged_looks_are_refused(damage: dict[str, Any]) -> None:
    game = game_of()
    pour(game, pool)
    row = game.scene.waters.state()[0]
    with pytest.raises((ValueError, TypeError)):
        game.scene.waters.read([row | damage])


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"clarity": 0}, "clarity=0"),
        ({"clarity": float("nan")}, "clarity=nan"),
        ({"refraction": -1}, "refraction=-1"),
        ({"rim": 2}, "rim=2"),
        ({"waves": -1}, "waves=-1"),
        ({"foam": 11}, "foam=11"),
        ({"lit": 1}, "lit=1 must be True or False"),
        ({"ramp": ["red"]}, "two or more colours"),
        ({"ramp": "red"}, "two or more colours"),
        ({"refracton": 1}, "did you mean 'refraction'"),
        ({"layer": 0.5}, "layer"),
        ({"colour": "watery"}, "colour"),
    ],
)
def test_looks_that_make_no_sense_leave_nothing_behind(given: dict[str, Any], message: str) -> None:
    game = evil.Game(headless=True)
    with pytest.raises((evil.ArgumentError, evil.ArgumentTypeError), match=message):
        game.add_water(AREA, particle_size=SIZE, **given)
    assert game.world.waters == ()
    assert game.scene.waters.alive() == []


if __name__ == "__main__":
    import PIL.Image

    for each in SCENES:
        shown = scene_of(each, "soft").capture()
        PIL.Image.fromarray(np.asarray(shown.pixels), "RGBA").save(Path(__file__).parent / f"golden/water_{each}.png")
