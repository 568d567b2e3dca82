"""Particles: born at the rate asked for, moved by the laws they name, stopped by bodies, saved, and drawn alike."""

from __future__ import annotations

import math
import struct
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from golden_pictures import GOLDEN, assert_golden

import evilengine as evil
from evilengine import _core
from evilengine.game import Game, saving
from evilengine.scene import Emitter
from evilengine.values.image import Image


def quiet(**options: Any) -> Game:
    return Game("Particles", size=(240, 160), headless=True, **{"renderer": "soft", **options})


def state_of(emitter: Emitter) -> bytes:
    return emitter._core.snapshot()


# ---- birth, life, death ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("rate", [0, 0.5, 7, 59, 61, 10_000])
def test_as_many_are_born_as_the_rate_says(rate: float) -> None:
    game = quiet()
    emitter = game.add_particles(rate=rate, life=100, most=100_000)
    game.step(240)
    assert abs(emitter.count - 4 * rate) <= 1  # a birth may be due by a rounding more or less


def test_no_more_are_alive_than_allowed() -> None:
    game = quiet()
    emitter = game.add_particles(rate=6000, life=10, most=500)
    game.step(60)
    assert emitter.count == 500
    emitter.burst(10)
    assert emitter.count == 500


def test_each_lives_as_long_as_its_life() -> None:
    game = quiet()
    emitter = game.add_particles(life=(0.5, 1.0))
    emitter.burst(200)
    game.step(29)
    assert emitter.count == 200
    game.step(16)
    assert 60 < emitter.count < 140
    game.step(16)
    assert emitter.count == 0


def test_a_body_carries_its_emitter_which_outlives_it_until_the_last_spark() -> None:
    game = quiet(gravity=(0, 0))
    cart = game.add(evil.Rectangle(1, 1), at=(3, 0), angle=math.pi / 2, velocity=(6, 0))
    emitter = game.add_particles(body=cart, at=(1, 0), speed=0, rate=60, life=0.5)
    game.step(30)
    (oldest, *_, youngest) = emitter.positions
    assert youngest == pytest.approx((6, 1), abs=0.11)
    assert oldest.x < youngest.x - 2
    cart.destroy()
    game.step(20)
    assert emitter.alive
    assert 0 < emitter.count < 30
    game.step(20)
    assert not emitter.alive
    with pytest.raises(evil.StaleReferenceError, match="this Emitter was destroyed"):
        emitter.burst(1)


# ---- motion ---------------------------------------------------------------------------------------------------


def test_what_falls_falls_as_bodies_do() -> None:
    game = quiet()
    emitter = game.add_particles(at=(0, 10), speed=0, life=10)
    ball = game.world.add(evil.Circle(0.1), at=(0, 10))
    emitter.burst(1)
    game.step(60)
    (place,), (velocity,) = emitter.positions, emitter.velocities
    assert velocity == pytest.approx(ball.velocity, rel=1e-4)
    assert place.y == pytest.approx(ball.position.y, abs=0.1)


def test_drag_brings_them_to_the_wind() -> None:
    game = quiet(gravity=(0, 0))
    emitter = game.add_particles(speed=0, drag=2.0, wind=(3, -1), life=10)
    emitter.burst(1)
    game.step(60)
    share = 1 - math.exp(-2)
    assert emitter.velocities[0] == pytest.approx((3 * share, -share), rel=1e-4)


def test_a_pace_of_nothing_stops_them() -> None:
    game = quiet(gravity=(0, 0))
    emitter = game.add_particles(speed=10, cone=0, direction=0, life=1, pace=[1, 0])
    emitter.burst(1)
    game.step(59)
    assert emitter.positions[0] == pytest.approx((5, 0), abs=0.2)  # the mean pace of a life is a half


def test_they_fly_within_their_cone_and_start_within_their_area() -> None:
    game = quiet(gravity=(0, 0))
    emitter = game.add_particles(at=(2, 1), area=(4, 2), direction=1.0, cone=0.6, speed=(2, 3), most=1000)
    emitter.burst(1000)
    places, velocities = np.array(emitter.positions), np.array(emitter.velocities)
    assert (abs(places - (2, 1)) <= (2, 1)).all()
    assert places.std(axis=0) == pytest.approx((4 / 12**0.5, 2 / 12**0.5), rel=0.1)
    angles, speeds = np.arctan2(velocities[:, 1], velocities[:, 0]), np.hypot(*velocities.T)
    assert angles.min() > 0.7 - 1e-4
    assert angles.max() < 1.3 + 1e-4
    assert np.ptp(angles) > 0.55
    assert speeds.min() >= 2 - 1e-4
    assert speeds.max() <= 3 + 1e-4


# ---- the same every time ----------------------------------------------------------------------------------------


def storm(instructions: str = "", seed: int = 5) -> bytes:
    game = quiet(seed=seed)
    if instructions:
        game.world._core.instruction_set = instructions
    game.add(evil.Rectangle(8, 1), at=(0, -3), kind="static")
    crate = game.add(evil.Rectangle(1, 1), at=(0, 1))
    emitter = game.add_particles(
        body=crate, rate=500, life=(0.3, 1.1), speed=(1, 6), cone=6, drag=0.3, wind=(1, 0), spin=(-3, 3),
        pace=[1, 0.4], size_varies=0.5, collide=True,
    )  # fmt: skip
    game.step(60)
    return state_of(emitter)


@pytest.mark.parametrize("instructions", _core.instruction_sets())
def test_every_instruction_set_gives_the_same_bits(instructions: str) -> None:
    assert storm(instructions) == storm()


def test_chances_come_from_the_game() -> None:
    assert storm(seed=5) == storm(seed=5) != storm(seed=6)


# ---- bodies ---------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "floor",
    [
        evil.Rectangle(20, 1),
        evil.Capsule((-10, 0), (10, 0), 0.5),
        evil.Polygon([(-10, -1), (10, -1), (10, 0.5), (-10, 0.5)]),
    ],
)
def test_nothing_gets_through_a_floor(floor: Any) -> None:
    game = quiet()
    game.add(floor, kind="static")
    emitter = game.add_particles(at=(0, 3), speed=(0, 40), cone=6.28, rate=600, life=5, collide=True, bounce=0.6)
    game.step(200)
    ends = [place for place in emitter.positions if abs(place.x) < 9.5]
    assert len(ends) > 200
    assert min(place.y for place in ends) > 0.5


def test_rain_ends_where_it_falls() -> None:
    game = quiet()
    game.add(evil.Rectangle(20, 1), kind="static")
    emitter = game.add_particles(at=(0, 3), speed=1, rate=120, life=50, collide=True, dies=True)
    game.step(300)
    assert emitter.count < 180
    assert min(place.y for place in emitter.positions) > 0.5


def test_a_wall_that_moves_takes_them_along() -> None:
    game = quiet(gravity=(0, 0))
    game.world.add(evil.Rectangle(0.2, 4), at=(-2, 0), kind="kinematic", velocity=(6, 0))
    emitter = game.add_particles(area=(1, 1), speed=0, life=60, collide=True)
    emitter.burst(100)
    game.step(60)
    assert min(place.x for place in emitter.positions) > 4.0


def test_a_spark_keeps_its_bounce() -> None:
    game = quiet()
    game.add(evil.Rectangle(20, 1), at=(0, -0.5), kind="static")
    emitter = game.add_particles(at=(0, 2), speed=0, life=20, collide=True, bounce=0.5, friction=0)
    emitter.burst(1)
    heights = []
    for _ in range(90):
        game.step()
        heights.append(emitter.positions[0].y)
    landed = heights.index(min(heights[:60]))
    assert max(heights[landed:]) == pytest.approx(2 * 0.25, rel=0.15)
    game.step(300)
    assert emitter.positions[0].y == pytest.approx(0, abs=0.01)


def test_masks_and_sensors_let_through() -> None:
    game = quiet()
    game.world.add(evil.Rectangle(20, 1), category=2, kind="static")
    game.world.add(evil.Rectangle(20, 1), at=(0, -2), sensor=True, kind="static")
    emitter = game.add_particles(at=(0, 3), speed=0, life=20, collide=True, mask=1)
    emitter.burst(1)
    game.step(120)
    assert emitter.positions[0].y < -3


def test_bodies_feel_nothing_of_them() -> None:
    def play(particles: bool) -> str:
        game = quiet()
        game.add(evil.Rectangle(20, 1), at=(0, -2), kind="static")
        for n in range(5):
            game.add(evil.Circle(0.4), at=(0.1 * n, n))
        if particles:
            game.add_particles(rate=500, speed=10, cone=6, collide=True)
        game.step(120)
        return game.world.checksum()

    assert play(True) == play(False)


# ---- saving ---------------------------------------------------------------------------------------------------


def fountain() -> Game:
    game = quiet(seed=9)
    cart = game.add(evil.Rectangle(1, 0.5), at=(-2, 0), velocity=(1, 0), tag="cart")
    game.add_particles(body=cart, rate=90, life=(0.5, 2), colour=["gold", "#f000"], size=[0.1, 0.3], blend="add")
    game.add_particles(at=(1, 1), area=(2, 1), rate=30, life=1, layer=3, collide=True).running = False
    return game


@pytest.mark.parametrize("stop", [0, 1, 50])
def test_what_was_saved_goes_on_as_if_it_had_never_stopped(stop: int) -> None:
    game = fountain()
    game.step(stop)
    data = saving.to_bytes(game)
    other = quiet()
    saving.from_bytes(other, data, "saved")
    assert saving.to_bytes(other) == data
    for each in (game, other):
        each.step(70)
        each.scene.emitters[1].running = True
        each.step(30)
    assert [state_of(each) for each in game.scene.emitters] == [state_of(each) for each in other.scene.emitters]
    assert bytes(game.capture().pixels) == bytes(other.capture().pixels)


def test_handles_stay_good_when_their_game_goes_back() -> None:
    game = fountain()
    emitter = game.scene.emitters[0]
    game.step(30)
    data, before = saving.to_bytes(game), state_of(emitter)
    later = game.add_particles(rate=5)
    emitter.rate = 3
    game.step(30)
    saving.from_bytes(game, data, "saved")
    assert (emitter.rate, state_of(emitter), later.alive) == (90, before, False)


def test_a_save_with_particles_that_are_none_changes_nothing() -> None:
    game = fountain()
    game.step(30)
    sections = saving.SAVED_GAME.read(saving.to_bytes(game), "saved")
    for damaged in (sections["particles"][:-4], sections["particles"][4:] + bytes(4), b""):
        other = quiet()
        keep = other.add_particles(rate=1)
        with pytest.raises(evil.SaveError):
            saving.from_bytes(other, saving.SAVED_GAME.write({**sections, "particles": damaged}), "saved")
        assert other.scene.emitters == (keep,)


@pytest.mark.parametrize("number", [3e38, -1e20, math.inf, math.nan])
@pytest.mark.parametrize("column", range(9))
def test_no_number_of_a_save_gets_a_particle_out_of_hand(number: float, column: int) -> None:
    game = fountain()
    game.step(30)
    data = bytearray(saving.SAVED_GAME.read(saving.to_bytes(game), "saved")["particles"])
    struct.pack_into("<f", data, 20 + 4 * column * game.scene.emitters[0].count, number)
    sections = saving.SAVED_GAME.read(saving.to_bytes(game), "saved")
    with pytest.raises(evil.SaveError):
        saving.from_bytes(quiet(), saving.SAVED_GAME.write({**sections, "particles": bytes(data)}), "saved")


def test_a_save_from_before_there_were_particles_is_read() -> None:
    game = quiet()
    sections = saving.SAVED_GAME.read(saving.to_bytes(game), "saved")
    del sections["particles"]
    other = fountain()
    saving.from_bytes(other, saving.SAVED_GAME.write(sections), "saved")
    assert saving.to_bytes(other) == saving.to_bytes(game)


# ---- the door -------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"rate": -1}, "rate=-1 must be"),
        ({"life": 0}, "life=0 must be"),
        ({"life": (2, 1)}, "the least and then the most"),
        ({"speed": (1, 2, 3)}, "must be a number, or two"),
        ({"size": []}, "1 to 64 values over a life"),
        ({"size": [0.1, math.nan]}, "size=nan must be"),
        ({"colour": []}, "1 to 64 values over a life"),
        ({"colour": ["red", "bluue"]}, "did you mean 'blue'"),
        ({"area": (1, -1)}, "area=-1"),
        ({"at": (1e30, 0)}, "at=1e+30"),
        ({"blend": "sub"}, "must be one of 'normal', 'add', 'multiply', 'screen'"),
        ({"blend": "over"}, "must be one of 'normal', 'add', 'multiply', 'screen'"),
        ({"burst": -1}, "burst=-1 must be"),
        ({"running": 1}, "running=1 must be True or False"),
        ({"collide": 1}, "collide=1 must be True or False"),
        ({"most": 2.5}, "most=2.5 must be a whole number"),
        ({"body": 3}, "must be a Body"),
        ({"rat": 3}, "did you mean 'rate'"),
        ({"texture": "no.png"}, "no.png"),
    ],
)
def test_what_makes_no_sense_is_refused_and_makes_nothing(options: dict[str, Any], words: str) -> None:
    game = quiet()
    with pytest.raises(evil.Error) as problem:
        game.add_particles(**options)
    assert words in str(problem.value)
    assert game.scene.emitters == ()
    emitter = game.add_particles()
    name, value = next(iter(options.items()))
    if name not in ("body", "rat", "burst"):
        before = getattr(emitter, name)
        with pytest.raises(evil.Error):
            setattr(emitter, name, value)
        assert getattr(emitter, name) == before


def test_a_scene_ends_with_its_emitters() -> None:
    game = fountain()
    emitters = game.scene.emitters
    game.scene.clear()
    assert not any(each.alive for each in emitters)
    assert game.scene.emitters == ()


# ---- pictures -------------------------------------------------------------------------------------------------


def fire_and_rain(renderer: str) -> Game:
    game = quiet(renderer=renderer, seed=2, view_height=8)
    game.add_background("#141824")
    game.draw(evil.Rectangle(3, 6), at=(-3, 0), colour="#2c3550", layer=2)
    game.add(evil.Rectangle(14, 1), at=(0, -3.5), kind="static", colour="#3d4660")
    game.add_particles(
        at=(-3, -2.8), area=0.3, rate=120, life=(0.6, 1.4), speed=(1, 3), size=[1.0, 0.7, 0.1], size_varies=0.5,
        colour=["#ff9a30", "#ff4d10c0", "#40100000"], gravity_scale=-0.15, blend="add", layer=3,
    )  # fmt: skip
    game.add_particles(
        at=(-3, -1), area=0.4, rate=20, life=3, speed=1, size=[0.6, 2.5], colour=["#8880", "#8886", "#8880"],
        gravity_scale=0, wind=(0.8, 0.6), drag=0.5, layer=1,
    )  # fmt: skip
    game.add_particles(
        at=(3, 4), area=(6, 0), rate=60, life=3, speed=9, direction=-1.7, cone=0, size=0.08, colour="#9db8e0c0",
        stretch=0.06, collide=True, dies=True,
    )  # fmt: skip
    game.add_particles(
        at=(2, -1), rate=80, life=1, speed=(2, 5), cone=6.28, size=[0.25, 0.1], colour=["white", "gold", "#f400"],
        collide=True, soft=False,
    )  # fmt: skip
    game.step(90)
    return game


def picture(game: Game) -> np.ndarray[Any, np.dtype[np.uint8]]:
    return np.array(game.capture().pixels)


def test_the_golden_picture_comes_out_to_the_bit() -> None:
    assert_golden("particles", picture(fire_and_rain("soft")))


def test_the_graphics_card_draws_them_as_the_processor_does() -> None:
    pytest.importorskip("moderngl")
    from drawing_gl import any_driver

    any_driver()
    game = fire_and_rain("gl")
    assert game.renderer.name == "gl"
    difference = abs(picture(game).astype(int) - picture(fire_and_rain("soft")))
    assert difference.max() <= 6
    assert difference.mean() < 0.1


def test_they_lie_over_their_layer_and_under_the_next(tmp_path: Path) -> None:
    Image.of(2, 2, b"\xff\x00\x00\xff" * 4).save(tmp_path / "red.png")
    for looks in ({"soft": False, "colour": "red"}, {"texture": "red.png"}):
        game = quiet(folder=tmp_path, gravity=(0, 0))
        for layer, x in ((0, -1), (1, 0), (2, 1)):
            game.draw(evil.Rectangle(1, 3), at=(x, 0), colour="blue", layer=layer)
        emitter = game.add_particles(layer=1, size=6, speed=0, **looks)
        emitter.burst(1)
        colours = [tuple(picture(game)[80, 120 + 50 * x, :3]) for x in (-1, 0, 1)]
        assert colours == [(255, 0, 0), (255, 0, 0), (0, 0, 255)]


def test_what_adds_light_never_darkens_and_stops_at_white() -> None:
    game = quiet(gravity=(0, 0))
    game.add_background("#406080")
    emitter = game.add_particles(size=2, speed=0, colour="#804020", blend="add", soft=False, life=9)
    for bursts, colour in ((1, (192, 160, 160)), (1, (255, 224, 192)), (20, (255, 255, 255))):
        emitter.burst(bursts)
        assert tuple(picture(game)[80, 120, :3]) == colour


def test_what_is_smaller_than_a_pixel_is_fainter_and_not_gone() -> None:
    def light(size: float) -> int:
        game = quiet(gravity=(0, 0))
        game.add_background("black")
        game.add_particles(size=size, speed=0, area=2.0, soft=False).burst(400)
        return int(picture(game)[..., 0].sum())

    assert light(0.01) == pytest.approx(light(0.02) / 4, rel=0.2)
    assert light(0.01) > 1000


SCENES: dict[str, Callable[[], Game]] = {"particles": lambda: fire_and_rain("soft")}

if __name__ == "__main__":
    for name, scene in SCENES.items():
        scene().capture().save(GOLDEN / f"{name}.png")
        print(GOLDEN / f"{name}.png", file=sys.stderr)
