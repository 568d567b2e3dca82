"""Shafts of light, fog in the light, and particles in the light, in both renderers."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
from golden_pictures import assert_golden

import evilengine as evil
from evilengine import level, script
from evilengine.script.translate import translate

RENDERERS = ("soft", "gl")


def quiet(renderer: str = "soft", **options: Any) -> evil.Game:
    game = evil.Game("Air", size=(240, 160), headless=True, renderer=renderer, gravity=(0, 0), **options)
    game.add_background("black")
    return game


def picture(game: evil.Game) -> npt.NDArray[np.int64]:
    return np.array(game.capture().pixels).astype(np.int64)


def moon(renderer: str = "soft") -> evil.Game:
    """A white moon in the middle of the picture, and a black pole before the right side of it."""
    game = quiet(renderer)
    game.draw(evil.Circle(0.5), layer=-3, colour="white")
    game.draw(evil.Rectangle(0.4, 3), at=(0.4, 0), layer=-2, colour="black")
    game.layers[-2].shafts.at = (0, 0)
    return game


def scenery(renderer: str) -> evil.Game:
    game = quiet(renderer)
    game.draw(evil.Rectangle(6, 4), colours=["#203050", "#203050", "#0a1020", "#0a1020"], layer=-4)
    game.draw(evil.Circle(0.4), at=(0.6, 0.5), layer=-3, colour="#fff0d0")
    for x in (-1.8, -0.9, 0.2, 0.8, 1.7):
        game.draw(evil.Rectangle(0.14, 4), at=(x, 0), layer=-2, colour="#04060a")
    rays = game.layers[-2].shafts
    rays.at, rays.colour, rays.strength, rays.threshold = (0.6, 0.5), "#c8dcff", 1.5, 0.1
    game.layers[-2].fog, game.layers[-2].fog_lit = "#90a0b040", True
    game.add(evil.Rectangle(0.5, 0.5), at=(-0.6, -0.9), kind="static", colour="#302820", lit=True)
    game.add_light(at=(-1.4, -0.4), radius=3, colour="#ffb060")
    game.add_particles(area=(4, 3), size=0.12, speed=0.2, colour="white", lit=True, life=9).burst(60)
    game.step(10)
    return game


@pytest.mark.parametrize("renderer", RENDERERS)
def test_what_is_bright_shines_on_and_what_is_dark_throws_a_shadow(renderer: str) -> None:
    game = moon(renderer)
    lit = picture(game)[..., 0]
    assert lit[80, 60] > 15  # to the left of the moon, where there was nothing
    assert lit[80, 60] > lit[80, 20]  # and less farther off
    assert lit[80, 180] < lit[80, 60] - 4  # behind the pole
    assert lit[20, 110] == pytest.approx(lit[140, 110], abs=3)


def test_they_go_away_from_the_point_wherever_the_camera_looks() -> None:
    game = moon()
    game.layers[-2].parallax = game.layers[-3].parallax = 0.5
    game.camera.position = (1.2, 0)
    light = picture(game)[..., 0]
    assert light[80, 60:100].mean() > light[10, 60:100].mean()
    rows = light[:, 120 - 30 - 50]  # left of the moon, which is 30 pixels left of the middle
    assert abs(int(rows.argmax()) - 80) <= 6


@pytest.mark.parametrize(("name", "value"), [("strength", 0.0), ("at", None)])
def test_without_strength_or_a_point_there_are_none(name: str, value: Any) -> None:
    game = moon()
    setattr(game.layers[-2].shafts, name, value)
    off = picture(game)
    assert np.isin(off[80, :60, :3], 0).all()


def test_nearer_layers_stand_before_them() -> None:
    game = moon()
    game.draw(evil.Rectangle(1, 1), at=(-1.2, 0), layer=-1, colour="black")
    assert (picture(game)[70:90, 50:70, :3] == 0).all()


@pytest.mark.parametrize("reach", [0.1, 1.0])
def test_a_short_reach_makes_short_shafts(reach: float) -> None:
    game = moon()
    game.layers[-2].shafts.reach = reach
    assert (picture(game)[80, 30, 0] > 3) == (reach == 1.0)


@pytest.mark.parametrize("renderer", RENDERERS)
def test_fog_in_the_light_is_bright_where_light_is_and_dark_in_shadows(renderer: str) -> None:
    game = quiet(renderer)
    game.layers[-1].fog = "#ffffff80"
    game.add_light(at=(-1, 0), radius=4)
    game.add(evil.Rectangle(0.3, 0.8), kind="static", colour="black")
    game.ambient = 0.0
    plain = picture(game)
    game.layers[-1].fog_lit = True
    lit = picture(game)
    assert plain[80, 40, 0] == plain[80, 150, 0]
    assert lit[80, 70, 0] > 100
    assert lit[80, 150, 0] < 12


@pytest.mark.parametrize("renderer", RENDERERS)
@pytest.mark.parametrize("texture", [False, True])
def test_particles_take_the_light_of_where_they_are(renderer: str, texture: bool, tmp_path: Path) -> None:
    evil.Image.of(2, 2, bytearray(b"\xff" * 16)).save(tmp_path / "dot.png")
    game = quiet(renderer, folder=tmp_path)
    game.add_light(at=(-1.5, 0), radius=2.5)
    game.ambient = 0.0
    look: dict[str, Any] = {"texture": "dot.png"} if texture else {"soft": False}
    effects = [game.add_particles(at=(x, 0), size=0.4, speed=0, life=9, **look) for x in (-1.5, 1.5)]
    for each in effects:
        each.burst(1)
    assert picture(game)[80, [45, 195], 0].min() > 250
    for each in effects:
        each.lit = True
    bright, dark = picture(game)[80, [45, 195], 0]
    assert bright > 200
    assert dark < 5


def test_particles_have_the_tint_of_their_layer() -> None:
    game = quiet()
    game.add_particles(size=0.5, speed=0, life=9, soft=False).burst(1)
    game.layers[0].tint = "red"
    assert tuple(picture(game)[80, 120, :3]) == (255, 0, 0)


def test_the_air_looks_as_it_always_did() -> None:
    assert_golden("shafts", scenery("soft").capture().pixels)


def test_both_renderers_draw_the_same_air() -> None:
    soft, gl = (picture(scenery(renderer)) for renderer in RENDERERS)
    assert np.abs(soft - gl).max() <= 4


def test_it_is_saved(tmp_path: Path) -> None:
    game = scenery("soft")
    before = game.capture().tobytes()
    game.save("s", folder=tmp_path)
    other = quiet()
    other.resume("s", folder=tmp_path)
    assert other.capture().tobytes() == before
    assert other.layers[-2].fog_lit
    assert repr(other.layers[-2].shafts) == repr(game.layers[-2].shafts)


@pytest.mark.parametrize(
    ("name", "value"),
    [("at", (1e9, 0)), ("at", 3), ("strength", -1), ("reach", 0), ("threshold", 1), ("colour", "reddish")],
)
def test_bad_shafts_are_refused(name: str, value: Any) -> None:
    shafts = quiet().layers[-1].shafts
    before = shafts.state()
    with pytest.raises((evil.ArgumentError, evil.ArgumentTypeError), match=f"Shafts: {name}="):
        setattr(shafts, name, value)
    assert shafts.state() == before


LEVEL = """
draw circle moon 1 at 0 2 layer -3 colour "white";
plane -2 shafts 0 2 shaftColour "gold" shaftStrength 2 shaftReach 0.8 shaftThreshold 0.3 fog "#ffffff20" fogLit;
new particles dust rate 30 lit;
lens perspective;
new rectangle crate 1 1 at 0 0 depth 0.5 behind 2;
set crate depth 1;
"""


def test_levels_say_it() -> None:
    game = quiet()
    made = level.build(script.read(LEVEL), game)
    shafts = game.layers[-2].shafts
    assert (shafts.at, shafts.strength, shafts.reach, shafts.threshold) == ((0, 2), 2.0, 0.8, 0.3)
    assert game.layers[-2].fog_lit
    assert game.scene.emitters[0].lit
    assert game.layers.perspective
    crate: Any = made["crate"]
    assert (crate.drawings[0].behind, crate.drawings[0].depth) == (2.0, 1.0)
    program = translate(script.read(LEVEL))
    for line in ("game.layers[-2].shafts.at = (0, 2)", "game.layers.perspective = True", "lit=True", "depth=0.5"):
        assert line in program


def test_a_background_of_a_level_is_in_the_light(tmp_path: Path) -> None:
    evil.Image.of(2, 2, bytearray(b"\xff" * 16)).save(tmp_path / "wall.png")
    game = quiet(folder=tmp_path)
    level.build(script.read('background "wall.png" lit; new light at -1 0 radius 1.5; ambient 0;'), game)
    bright, dark = picture(game)[80, [70, 200], 0]
    assert bright > 200
    assert dark == 0
    assert "lit=True" in translate(script.read('background "wall.png" lit;'))
