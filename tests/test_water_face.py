"""Water from Python: filling, pouring, draining, asking, writing; and what is refused."""

from __future__ import annotations

import math
import time
from typing import Any

import numpy as np
import pytest

import evilengine as evil
from evilengine.world.water import Water

DT = 1 / 60


def pool(**options: Any) -> tuple[evil.World, Water]:
    world = evil.World(gravity=(0, -10))
    return world, world.add_water((0, 0, 4, 3), **{"particle_size": 0.1} | options)


def run(world: evil.World, steps: int) -> None:
    for _ in range(steps):
        world.step(DT)


# ---- filling and taking out ----


def test_a_shape_is_filled_where_it_is_and_as_it_is_turned() -> None:
    _, water = pool()
    assert water.fill(evil.Rectangle(2, 0.44), at=(2, 1.5), angle=math.pi / 2) == 80
    at = np.asarray(water.positions)
    assert (abs(at - (2, 1.5)) <= (0.22, 1)).all()
    assert water.volume == pytest.approx(0.8)


def test_what_is_outside_the_box_is_not_filled() -> None:
    _, water = pool()
    assert water.fill((-1e6, -1e6, 1e6, 1)) == 400
    assert water.fill((9, 9, 10, 10)) == 0
    assert water.fill(evil.Circle(0.5), at=(9, 9)) == 0


def test_what_is_filled_moves_as_it_was_told() -> None:
    _, water = pool()
    water.fill((1, 1, 2, 2), velocity=(3, -1))
    assert (np.asarray(water.velocities) == (3, -1)).all()


def test_clear_takes_out_what_is_there_and_leaves_the_rest_in_order() -> None:
    _, water = pool()
    water.fill((0, 0, 4, 2))
    before = np.array(water.positions)
    middle = (np.linalg.norm(before - (2, 1), axis=1) <= 0.7).nonzero()[0]
    assert water.clear(evil.Circle(0.7), at=(2, 1)) == len(middle)
    assert (np.asarray(water.positions) == np.delete(before, middle, axis=0)).all()
    assert water.clear((-5, -5, -4, -4)) == 0
    assert water.clear() == 800 - len(middle)
    assert len(water) == 0
    assert bool(water)


# ---- streams ----


def test_a_stream_brings_what_it_says_and_flies_as_it_says() -> None:
    world, water = pool()
    world.gravity = (0, 0)
    tap = water.pour((0.5, 1.5), 0.8, (2, 0))
    run(world, 30)
    assert water.volume == pytest.approx(0.4, abs=0.03)
    assert np.asarray(water.velocities)[:, 0].mean() == pytest.approx(2, abs=0.1)
    assert (tap.rate, tap.velocity, tap.running, tap.drains) == (pytest.approx(0.8), (2, 0), True, False)
    assert tap.water == water
    assert tap.liquid == water.liquids[0]


def test_a_stream_is_stopped_changed_and_ended() -> None:
    world, water = pool()
    tap = water.pour((2, 2), 1)
    run(world, 10)
    tap.running = False
    some = water.count
    run(world, 10)
    assert water.count == some > 0
    tap.running, tap.rate, tap.velocity = True, 2, (0, -4)
    run(world, 10)
    assert water.count > some + 20
    assert water.streams == (tap,)
    tap.destroy()
    some = water.count
    run(world, 10)
    assert water.count == some
    assert (water.streams, tap.alive, repr(tap)) == ((), False, "<Stream, gone>")
    with pytest.raises(evil.StaleReferenceError, match="this Stream"):
        tap.rate = 3


def test_a_stream_on_a_body_goes_with_it_and_ends_with_it() -> None:
    world, water = pool()
    world.gravity = (0, 0)
    can = world.add(evil.Circle(0.1), at=(1, 2.5), kind="kinematic", velocity=(1, 0), angle=math.pi)
    stream = water.pour((0, 0.4), 0.5, (0, 1), body=can)
    assert stream.body == can
    run(world, 60)
    at, way = np.asarray(water.positions), np.asarray(water.velocities)
    assert at[:, 1].max() < 2.4, "the can is upside down"
    assert way.mean(axis=0) == pytest.approx((1, -1), abs=0.1)
    can.destroy()
    assert not stream.alive
    some = water.count
    run(world, 10)
    assert water.count == some


def test_a_full_box_takes_no_more() -> None:
    world, water = pool()
    water.fill((0, 0, 4, 3))
    water.pour((2, 1.5), 5, (0, -3))
    run(world, 60)
    assert water.count <= 1.05 * 1200
    assert np.isfinite(np.asarray(water.velocities)).all()
    assert abs(np.asarray(water.velocities)).max() < 10


def test_a_stream_inside_a_solid_brings_nothing_until_that_goes() -> None:
    world, water = pool()
    rock = world.add(evil.Rectangle(1.5, 1.5), at=(2, 1.5), kind="static")
    water.pour((2, 1.5), 1, radius=0.3)
    run(world, 30)
    assert water.count == 0
    rock.destroy()
    run(world, 30)
    assert 20 < water.count < 90, "what waited was at most what its square holds"


def test_a_torrent_as_wide_as_the_world_does_not_hold_up_a_step() -> None:
    world, water = pool()
    water.pour((2, 1), 1e5, radius=1e4)
    for _ in range(3):
        began = time.perf_counter()
        run(world, 1)
        assert time.perf_counter() - began < 2
    assert 400 < water.count < 1300


def test_a_stream_outside_the_box_brings_nothing() -> None:
    world, water = pool()
    water.pour((9, 9), 1)
    water.pour((-0.5, 1), 1, radius=0.2)
    run(world, 30)
    assert water.count == 0


def test_a_drain_takes_all_that_comes_or_so_much_a_second() -> None:
    world, water = pool()
    world.gravity = (0, 0)
    water.fill((0, 0, 4, 1))
    slow = water.drain((0, 0, 4, 1), rate=1)
    run(world, 60)
    assert water.volume == pytest.approx(3, abs=0.05)
    assert (slow.rate, slow.drains) == (1, True)
    slow.rate = math.inf
    assert slow.rate == math.inf
    run(world, 1)
    assert water.count < 10, "what has swum off at most"


def test_a_drain_takes_evenly_out_of_all() -> None:
    world, water = pool()
    world.gravity = (0, 0)
    water.fill((0, 0, 4, 1))
    water.drain((0, 0, 4, 1), rate=120)
    run(world, 1)
    assert water.count == pytest.approx(200, abs=1)
    assert np.asarray(water.positions).mean(axis=0) == pytest.approx((2, 0.5), abs=0.1)


def test_what_is_poured_and_drained_at_one_rate_keeps_its_level() -> None:
    world, water = pool()
    water.fill((0, 0, 4, 1))
    water.pour((0.5, 2.5), 1, (0, -2))
    water.drain((3, 0, 4, 0.3), rate=1)
    run(world, 240)
    assert water.volume == pytest.approx(4, abs=0.4)


# ---- several liquids ----


def test_liquids_are_added_changed_and_counted() -> None:
    _, water = pool(density=1.1, viscosity=0.2, surface_tension=0.3, colour="teal")
    plain, oil = water.liquids[0], water.add_liquid(density=0.8, viscosity=0.01, colour="gold")
    assert (plain.density, plain.viscosity, plain.surface_tension) == pytest.approx((1.1, 0.2, 0.3))
    assert (plain.colour.hex, oil.colour.hex) == ("#008080", "#ffd700")
    assert water.fill((0, 0, 4, 1)) == 400
    assert water.fill((0, 1, 4, 1.5), liquid=oil) == 200
    assert (plain.count, oil.count, oil.volume) == (400, 200, pytest.approx(2))
    assert np.bincount(np.asarray(water.kinds)).tolist() == [400, 200]
    assert water.density_at((2, 1.3)) == pytest.approx(0.8, abs=0.1)
    oil.density, oil.colour = 0.5, "red"
    assert (water.liquids[1].density, water.liquids[1].colour.hex) == (0.5, "#ff0000")
    assert water.pour((2, 2), 1, liquid=oil).liquid == oil
    assert {plain, oil} == set(water.liquids)


def test_liquids_of_another_water_and_too_many_are_refused() -> None:
    world, water = pool()
    other = world.add_water((5, 0, 6, 1))
    with pytest.raises(evil.ArgumentError, match=r"Water\.fill: liquid=<Liquid 0 of .*another water"):
        water.fill((0, 0, 1, 1), liquid=other.liquids[0])
    for _ in range(15):
        water.add_liquid()
    with pytest.raises(evil.ArgumentError, match="at most 16 liquids"):
        water.add_liquid()
    assert len(water.liquids) == 16


# ---- asking and writing ----


def test_points_are_asked_one_by_one_and_in_batches() -> None:
    _, water = pool()
    water.fill((0, 0, 4, 1), velocity=(1, 2))
    points = np.array([(2, 0.5), (2, 2.5), (-1, 0.5), (2, math.nan)], dtype=np.float32)
    assert water.is_in(points) == [True, False, False, False]
    assert water.velocity_at(points) == [(1, 2), (0, 0), (0, 0), (0, 0)]
    assert water.density_at([(2, 0.5), (2, 2.5)]) == pytest.approx([1, 0], abs=0.05)
    assert water.depth_at([(2, 0.25), (2, 2)]) == pytest.approx([0.8, 0], abs=0.1)
    assert water.is_in([]) == []
    with pytest.raises(evil.ArgumentTypeError, match=r"Water\.is_in"):
        water.is_in("here")


def test_depth_is_against_gravity() -> None:
    world, water = pool()
    water.fill((0, 0, 1, 3))
    world.gravity = (-10, 0)
    assert water.depth_at((0.25, 1.5)) == pytest.approx(0.8, abs=0.1)


def test_particles_are_seen_and_written_without_a_copy() -> None:
    world, water = pool()
    world.gravity = (0, 0)
    water.fill((1, 1, 2, 2))
    assert water.positions.shape == water.velocities.shape == (100, 2)
    assert water.kinds.shape == (100,)
    np.asarray(water.velocities)[:] = (0, 1)
    water.velocities[0] = (3, 4)
    assert (water.velocities[0], water.velocities[-1], water.kinds[0]) == ((3, 4), (0, 1), 0)
    run(world, 6)
    assert np.asarray(water.positions).mean(axis=0)[1] > 1.55
    with pytest.raises(IndexError):
        water.positions[100]
    assert memoryview(water.kinds).readonly
    with pytest.raises(evil.ArgumentError, match="cannot be written"):
        water.kinds[0] = 1


def test_the_views_of_an_empty_water_are_empty_rows_of_two() -> None:
    world, water = pool()
    for _ in range(2):
        for view in (water.positions, water.velocities):
            assert (np.asarray(view).shape, np.asarray(view).dtype, view.shape) == ((0, 2), np.float32, (0, 2))
        assert (np.asarray(water.kinds).shape, np.asarray(water.kinds).dtype) == ((0,), np.uint8)
        np.asarray(water.velocities)[:] = math.nan
        run(world, 1)
        water.fill((0, 0, 1, 1))
        water.clear()


def test_views_from_before_a_step_do_no_harm() -> None:
    world, water = pool()
    water.fill((0, 0, 1, 1))
    old = [np.asarray(water.positions), np.asarray(water.velocities), np.asarray(water.kinds)]
    water.fill((0, 1, 4, 3))
    water.pour((2, 2), 3)
    run(world, 5)
    for view in old[:2]:
        view[:] = 7.0
    run(world, 5)
    water.destroy()
    assert all(len(view) == 100 and np.isfinite(view).all() for view in old)


@pytest.mark.parametrize("nonsense", [math.nan, math.inf, -math.inf, 1e30])
def test_nonsense_that_is_written_is_gone_after_a_step(nonsense: float) -> None:
    world, water = pool()
    water.fill((0, 0, 4, 1))
    np.asarray(water.positions)[::3] = nonsense
    np.asarray(water.velocities)[::2] = nonsense
    run(world, 3)
    at, way = np.asarray(water.positions), np.asarray(water.velocities)
    assert np.isfinite(way).all()
    assert (at >= 0).all()
    assert (at <= (4, 3)).all()
    np.asarray(water.positions)[::3] = nonsense
    twin = evil.World.of(world.snapshot())
    assert np.isfinite(np.asarray(twin.waters[0].positions)).all()


def test_stirring_pushes_what_is_near() -> None:
    _, water = pool()
    water.fill((0, 0, 4, 2))
    water.stir((2, 1), radius=0.5, velocity=(4, 0))
    assert water.velocity_at((2, 1)).x > 3
    assert water.velocity_at((3, 1)) == (0, 0)


def test_tilting_gravity_moves_it() -> None:
    world, water = pool()
    water.fill((0, 0, 4, 1))
    run(world, 30)
    world.gravity = (8, -6)
    run(world, 90)
    assert np.asarray(water.positions)[:, 0].mean() > 2.3
    assert water.volume == pytest.approx(4)


def test_tilting_the_device_moves_the_water_of_a_game() -> None:
    game = evil.Game(headless=True, size=(160, 120))
    water = game.add_water((-2, -2, 2, 2), particle_size=0.1)
    water.fill((-2, -2, 2, -1))
    game.tilt = True
    game.step(30)
    game.device.tilt(1, -1)
    game.step(90)
    assert np.asarray(water.positions)[:, 0].mean() > 0.3


# ---- what is refused ----


@pytest.mark.parametrize("bad", [0, -1, math.nan, math.inf, "big", None, True, 1e9])
def test_sizes_that_make_no_sense_are_refused_by_name(bad: Any) -> None:
    with pytest.raises(evil.Error, match=r"World\.add_water: particle_size="):
        evil.World().add_water((0, 0, 4, 3), particle_size=bad)


@pytest.mark.parametrize(
    "area", [(0, 3, 4, 0), (4, 0, 0, 3), (0, 0, 0, 3), (0, 0, math.nan, 3), (0, 0, math.inf, 3), (1, 2, 3), "area", 7]
)
def test_areas_that_make_no_sense_are_refused_by_name(area: Any) -> None:
    world, water = pool()
    for ask, me in ((world.add_water, "World.add_water"), (water.fill, "Water.fill"), (water.clear, "Water.clear"),
                    (water.drain, "Water.drain")):  # fmt: skip
        with pytest.raises(evil.Error, match=f"{me}: area="):
            ask(area)
    assert (len(world.waters), water.streams, water.count) == (1, (), 0)


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda water: water.pour((2, 2), -1), "Water.pour: rate=-1"),
        (lambda water: water.pour((2, 2), math.nan), "Water.pour: rate=nan"),
        (lambda water: water.pour((2, 2), math.inf), "Water.pour: rate=inf"),
        (lambda water: water.pour((math.nan, 2), 1), "Water.pour: at="),
        (lambda water: water.pour((2, 2), 1, (math.inf, 0)), "Water.pour: velocity="),
        (lambda water: water.pour((2, 2), 1, (1e5, 0)), "Water.pour: velocity="),
        (lambda water: water.pour((2, 2), 1, radius=0), "Water.pour: radius=0"),
        (lambda water: water.pour((2, 2), 1, radius=1, shape=evil.Circle(1)), "either a shape or radius="),
        (lambda water: water.pour((2, 2), 1, shape=evil.Segment((0, 0), (1, 0))), "shape with an inside"),
        (lambda water: water.pour((2, 2), 1, body="crate"), "Water.pour: body must be a Body"),
        (lambda water: water.pour((2, 2), 1, liquid="oil"), "Water.pour: liquid='oil'"),
        (lambda water: water.pour((2, 2), 1, speed=3), "speed"),
        (lambda water: water.drain((0, 0, 1, 1), rate=0), "Water.drain: rate=0"),
        (lambda water: water.drain((0, 0, 1, 1), rate=-math.inf), "Water.drain: rate=-inf"),
        (lambda water: water.drain((0, 0, 1, 1), at=(1, 1)), "Water.drain: at= and angle= are for shapes"),
        (lambda water: water.fill((0, 0, 1, 1), velocity=(math.nan, 0)), "Water.fill: velocity="),
        (lambda water: water.stir((2, 2), radius=-1, velocity=(1, 0)), "Water.stir: radius=-1"),
        (lambda water: water.add_liquid(density=0), "Water.add_liquid: density=0"),
        (lambda water: water.add_liquid(viscosity=-1), "Water.add_liquid: viscosity=-1"),
        (lambda water: water.add_liquid(surface_tension=math.nan), "Water.add_liquid: surface_tension=nan"),
        (lambda water: water.add_liquid(colour="sort of blue"), "Water.add_liquid: colour="),
        (lambda water: setattr(water.liquids[0], "density", -1), "Liquid: density=-1"),
        (lambda water: setattr(water.pour((2, 2), 1), "rate", math.inf), "Stream: rate=inf"),
        (lambda water: setattr(water.pour((2, 2), 1), "velocity", (1e5, 0)), "Stream: velocity"),
    ],
)
def test_what_makes_no_sense_is_refused_by_name(call: Any, words: str) -> None:
    _, water = pool()
    with pytest.raises(evil.Error) as caught:
        call(water)
    assert words in str(caught.value)


def test_more_than_a_water_holds_is_refused_before_anything_comes() -> None:
    world = evil.World()
    water = world.add_water((0, 0, 4000, 4000), particle_size=1)
    with pytest.raises(evil.ArgumentError, match=r"16,000,000 particles, and a water holds 4,194,304.*particle_size"):
        water.fill((0, 0, 4000, 4000))
    assert water.count == 0


def test_a_particle_size_that_asks_for_too_many_cells_is_refused_with_one_that_fits() -> None:
    with pytest.raises(evil.ArgumentError, match=r"too small for this area; at least 0\.24 fits"):
        evil.World().add_water((0, 0, 1000, 10), particle_size=0.01)


def test_a_water_that_is_gone_says_so_and_takes_all_with_it() -> None:
    world, water = pool()
    tap, oil = water.pour((2, 2), 1), water.add_liquid()
    water.destroy()
    assert (world.waters, water.alive, tap.alive, oil.alive) == ((), False, False, False)
    assert (repr(water), repr(oil)) == ("<Water, gone>", "<Liquid, gone>")
    for ask in (lambda: water.count, lambda: water.fill((0, 0, 1, 1)), lambda: oil.density, lambda: tap.rate,
                water.destroy, lambda: water.is_in((0, 0)), lambda: water.positions):  # fmt: skip
        with pytest.raises(evil.StaleReferenceError, match=r"gone|destroyed"):
            ask()
    again = world.add_water((0, 0, 1, 1))
    assert again != water
    assert not water.alive


@pytest.mark.parametrize("options", [{}, {"velocity": (0, -3)}, {"velocity": (0.5, -2.4)}])
def test_what_is_poured_falls_as_one_jet_at_its_rate(options: dict[str, Any]) -> None:
    world = evil.World()
    water = world.add_water((-2, -8, 2, 2), particle_size=0.08, open_sides="bottom")
    stream = water.pour((0, 1), rate=0.7, **options)
    for _ in range(45):
        world.step()
    assert water.volume == pytest.approx(0.7 * 0.75, abs=0.02)
    for _ in range(75):
        world.step()
        heights = np.sort(np.asarray(water.positions)[:, 1])
        assert np.diff(heights[heights > -0.5]).max() < 1.8 * water.particle_size
    if not options:
        assert stream.velocity == evil.Vec2(0, -2.5)


def test_a_stream_without_gravity_and_one_on_a_body_are_given_no_speed() -> None:
    world = evil.World(gravity=(0, 0))
    water = world.add_water((0, 0, 4, 4))
    assert water.pour((2, 2), 0.5).velocity == evil.Vec2(0, 0)
    world.gravity = (3, 0)
    assert water.pour((2, 2), 0.5).velocity == evil.Vec2(2.5, 0)
    can = world.add(evil.Circle(0.1), at=(1, 1))
    assert water.pour((0, 0), 0.5, body=can).velocity == evil.Vec2(0, 0)
