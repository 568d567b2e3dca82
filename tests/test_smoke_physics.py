"""The gas against physics: nothing gathers, nothing is lost, whirls last, walls hold."""

from __future__ import annotations

import math

import numpy as np
import pytest

import evilengine as evil

DT = 1 / 60


def whirl(smoke: evil.Smoke, speed: float = 1.0) -> None:
    """Taylor and Green's whirl in a box: sin(pi x) cos(pi y), -cos(pi x) sin(pi y)."""
    nx, ny = smoke.cells
    x, y = (np.arange(nx) + 0.5) / nx * math.pi, (np.arange(ny) + 0.5) / ny * math.pi
    velocity = np.asarray(smoke.velocity)
    velocity[..., 0] = speed * np.sin(x)[None, :] * np.cos(y)[:, None]
    velocity[..., 1] = -speed * np.cos(x)[None, :] * np.sin(y)[:, None]


def energy(smoke: evil.Smoke) -> float:
    return float((np.asarray(smoke.velocity, dtype=float) ** 2).sum())


@pytest.mark.parametrize("quality", ["fast", "high"])
@pytest.mark.parametrize(("cells", "steps"), [(128, 60), (256, 25), (512, 15)])
def test_hardly_anything_gathers_after_a_step_with_moving_bodies(quality: str, cells: int, steps: int) -> None:
    world = evil.World(gravity=(0, -10))
    smoke = world.add_smoke((0, 0, 1, 1), cells=cells, quality=quality)
    smoke.add_source(at=(0.5, 0.1), radius=0.06, rate=2, temperature=1)
    for k in range(8):
        world.add(evil.Circle(0.03), at=(0.15 + 0.1 * k, 0.55 + 0.05 * (k % 3)), kind="static")
    mover = world.add(evil.Rectangle(0.2, 0.08), at=(0.5, 0.4), kind="kinematic", angular_velocity=3)
    smoke._gathering()
    shares = []
    for k in range(steps):
        mover.velocity = (0.2 * math.cos(k / 30), 0)
        world.step(DT)
        before, after = smoke._gathering()
        shares.append(after / before)
    assert max(shares[5:]) < 0.02
    assert np.mean(shares[5:]) < 0.01


@pytest.mark.parametrize("cells", [(33, 65), (129, 129), (70, 35), (67, 5)], ids=str)
@pytest.mark.parametrize("sides", ["top", "right", "left top", "all"])
def test_grids_of_any_size_with_open_sides_are_solved_as_well(cells: tuple[int, int], sides: str) -> None:
    """An odd grid ends inside its last coarse cells: corrections that took no notice of that threw gas about."""
    world = evil.World(gravity=(0, 0))
    smoke = world.add_smoke((0, 0, 0.1 * cells[0], 0.1 * cells[1]), cells=cells, open_sides=sides)
    chance, velocity = np.random.default_rng(1), np.asarray(smoke.velocity)
    smoke._gathering()
    for _ in range(4):
        velocity[:] = chance.normal(size=velocity.shape)
        world.step(DT)
        before, after = smoke._gathering()
        assert after < 0.03 * before


def test_smoke_in_a_closed_box_keeps_its_mass_for_ten_seconds() -> None:
    world = evil.World(gravity=(0, -10))
    smoke = world.add_smoke((0, 0, 2, 2), cells=48, cooling=0)
    world.add(evil.Rectangle(0.5, 0.3), at=(1, 1), angle=0.4, kind="static")
    mixer = world.add(evil.Rectangle(0.6, 0.1), at=(0.6, 0.5), kind="kinematic", angular_velocity=2)
    np.asarray(smoke.density)[5:20, 10:30] = 1.0
    np.asarray(smoke.temperature)[5:20, 10:30] = 1.0
    world.step(DT)
    before = smoke.mass
    for _ in range(600):
        world.step(DT)
    assert mixer.angle > 19
    assert smoke.mass == pytest.approx(before, rel=1e-3)
    assert np.asarray(smoke.density).min() >= 0


def test_a_whirl_without_viscosity_keeps_its_energy_in_high_quality() -> None:
    world = evil.World(gravity=(0, 0))
    smoke = world.add_smoke((0, 0, 1, 1), cells=64, quality="high")
    whirl(smoke)
    world.step(DT)
    before = energy(smoke)
    for _ in range(599):
        world.step(DT)
    assert 0.98 < energy(smoke) / before < 1.001


def test_a_plume_is_as_its_mirror_image() -> None:
    world = evil.World(gravity=(0, -10))
    smoke = world.add_smoke((-1, 0, 1, 2), cells=64)
    smoke.add_source(at=(0, 0.3), radius=0.15, rate=2, temperature=1)
    world.add(evil.Circle(0.15), at=(0, 1), kind="static")
    for _ in range(120):
        world.step(DT)
    density = np.asarray(smoke.density)
    assert density[40:].max() > 0.2
    assert np.abs(density - density[:, ::-1]).max() < 2e-3


def test_hardly_anything_gathers_round_a_ball_that_falls_freely() -> None:
    world = evil.World(gravity=(0, -10))
    smoke = world.add_smoke((0, 0, 1, 1), cells=128, weight=1)
    world.add(evil.Circle(0.1), at=(0.5, 0.7), density=0.3)
    for _ in range(3):
        world.step(DT)
    smoke._gathering()
    shares = []
    for _ in range(27):
        world.step(DT)
        before, after = smoke._gathering()
        shares.append(after / before)
    assert np.mean(shares[2:]) < 0.01


@pytest.mark.parametrize(("origin", "size"), [((1e5, 1e5), 2.0), ((-1e5, 3e4), 2.0), ((0.0, 0.0), 1e-3), ((0, 0), 1e4)])
def test_areas_far_from_the_origin_tiny_and_huge_ones_work(origin: tuple[float, float], size: float) -> None:
    world = evil.World(gravity=(0, -10))
    left, bottom = origin
    smoke = world.add_smoke((left, bottom, left + size, bottom + size), cells=32, cooling=0)
    world.add(evil.Circle(size / 8), at=(left + size / 2, bottom + 0.7 * size), kind="static")
    smoke.add_source(at=(left + size / 2, bottom + size / 4), radius=size / 8, rate=2, temperature=1)
    for _ in range(60):
        world.step(DT)
    velocity = np.asarray(smoke.velocity)
    assert np.isfinite(velocity).all()
    assert velocity[..., 1].max() > 0.02
    assert smoke.mass / size**2 == pytest.approx(0.0977, rel=0.08)


def test_nothing_passes_a_wall_and_nothing_passes_a_body_that_moves() -> None:
    world = evil.World(gravity=(0, -10))
    smoke = world.add_smoke((0, 0, 2, 2), cells=64, cooling=0)
    world.add(evil.Rectangle(2.2, 0.02), at=(1, 1.2), angle=0.2, kind="static")
    door = world.add(evil.Rectangle(0.05, 3), at=(0.5, 1), kind="kinematic", velocity=(0.3, 0))
    np.asarray(smoke.density)[2:10, 40:60] = 1.0
    np.asarray(smoke.temperature)[2:10, 40:60] = 3.0
    for _ in range(120):
        world.step(DT)
    density = np.asarray(smoke.density)
    assert density[30:38, 50:].sum() > 1, "it rose to the wall"
    assert density[52:].max() < 1e-6, "nothing above the wall"
    assert door.position.x > 1.0
    assert density[:, : int(0.9 / 2 * 64)].max() < 1e-6, "nothing behind the door"


def test_gas_goes_round_a_body_and_not_through_it() -> None:
    world = evil.World(gravity=(0, 0))
    smoke = world.add_smoke((0, 0, 2, 1), cells=64, open_sides="left right", wind=(1, 0), wind_pull=5)
    world.add(evil.Circle(0.2), at=(1, 0.5), kind="static")
    for _ in range(120):
        world.step(DT)
    velocity = np.asarray(smoke.velocity)
    assert abs(velocity[16, 32]).max() < 0.05, "still within"
    assert velocity[27, 32, 0] > 1.2, "faster beside it"


def test_what_blows_out_of_an_open_side_is_gone() -> None:
    world = evil.World(gravity=(0, 0))
    smoke = world.add_smoke((0, 0, 2, 1), cells=32, open_sides=("left", "right"), wind=(2, 0), wind_pull=10)
    np.asarray(smoke.density)[:, :16] = 1.0
    for _ in range(180):
        world.step(DT)
    assert smoke.mass < 0.01


def test_a_whirl_decays_as_fast_as_its_viscosity_says() -> None:
    world = evil.World(gravity=(0, 0))
    nu, seconds = 1e-3, 10
    smoke = world.add_smoke((0, 0, 1, 1), cells=64, quality="high", viscosity=nu, stick=False)
    whirl(smoke)
    world.step(DT)
    before = energy(smoke)
    for _ in range(60 * seconds - 1):
        world.step(DT)
    exact = math.exp(-4 * nu * math.pi**2 * (seconds - DT))
    assert energy(smoke) / before == pytest.approx(exact, rel=0.02)


# Ghia, Ghia and Shin 1982, "High-Re solutions for incompressible flow using the Navier-Stokes equations and a multigrid
# method", table I: u along the vertical line through the middle of the cavity, at these heights.
HEIGHTS = (
    0.0547,
    0.0625,
    0.0703,
    0.1016,
    0.1719,
    0.2813,
    0.4531,
    0.5,
    0.6172,
    0.7344,
    0.8516,
    0.9531,
    0.9609,
    0.9688,
    0.9766,
)
GHIA = {
    100: (-0.03717, -0.04192, -0.04775, -0.06434, -0.10150, -0.15662, -0.21090, -0.20581, -0.13641, 0.00332, 0.23151,
          0.68717, 0.73722, 0.78871, 0.84123),
    400: (-0.08186, -0.09266, -0.10338, -0.14612, -0.24299, -0.32726, -0.17119, -0.11477, 0.02135, 0.16256, 0.29093,
          0.55892, 0.61756, 0.68439, 0.75837),
    1000: (-0.18109, -0.20196, -0.22220, -0.29730, -0.38289, -0.27805, -0.10648, -0.06080, 0.05702, 0.18719, 0.33304,
           0.46604, 0.51117, 0.57492, 0.65928),
}  # fmt: skip


@pytest.mark.parametrize(
    ("reynolds", "cells", "seconds", "off"), [(100, 32, 12, 0.02), (400, 48, 25, 0.03), (1000, 64, 40, 0.05)]
)
def test_a_lid_drives_a_cavity_as_ghia_found(reynolds: int, cells: int, seconds: int, off: float) -> None:
    world = evil.World(gravity=(0, 0))
    smoke = world.add_smoke((0, 0, 1, 1), cells=cells, viscosity=1 / reynolds, side_speeds=(0, 0, 0, 1), quality="high")
    for _ in range(30 * seconds):
        world.step(1 / 30)
    found = [velocity.x for velocity in smoke.velocity_at([(0.5, height) for height in HEIGHTS])]
    assert max(abs(a - b) for a, b in zip(found, GHIA[reynolds], strict=True)) < off


@pytest.mark.parametrize("open_sides", ["top", "top left right", "all"])
def test_a_fire_in_the_open_draws_air_in_and_makes_no_storm(open_sides: str) -> None:
    """Air that comes in by an open side brings no speed of its own, or it would come ever faster."""
    world = evil.World()
    smoke = world.add_smoke((-4, 0, 4, 4), cells=48, open_sides=open_sides, vorticity=4)
    smoke.add_source(at=(1, 0.5), radius=0.3, fuel=5, temperature=1)
    fastest = 0.0
    for _ in range(45):
        for _ in range(20):
            world.step()
        fastest = max(fastest, float(np.hypot(*np.moveaxis(np.asarray(smoke.velocity), -1, 0)).max()))
    assert 4.0 < fastest < 20.0


def test_what_an_open_side_lets_in_moves_as_the_wind_does() -> None:
    world = evil.World(gravity=(0, 0))
    smoke = world.add_smoke((0, 0, 4, 2), cells=32, open_sides="left right", wind=(2, 0), wind_pull=5)
    for _ in range(240):
        world.step()
    assert np.asarray(smoke.velocity)[..., 0] == pytest.approx(2.0, rel=0.02)
