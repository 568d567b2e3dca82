"""Bodies without contacts, against the continuous solutions of (4.1) to (4.7): flights, spin, springs."""

from __future__ import annotations

import itertools
import math

import pytest

import evilengine as evil

G = 9.81


def flight(damping, velocity, substeps, seconds=2.0):
    """Where a projectile is and how fast, after so long, in steps of 1/60 s of so many parts."""
    world = evil.World(gravity=(0, -G))
    ball = world.add(evil.Circle(0.5), at=(1, 2), velocity=velocity, damping=damping)
    for _ in range(round(seconds * 60)):
        world.step(1 / 60, substeps)
    return ball.position, ball.velocity


def exact(damping, velocity, seconds=2.0):
    """The solution of x'' = ln(d) x' + g: what (4.1) to (4.3) become as their step goes to zero."""
    k = -math.log(damping)
    if k == 0:
        gone, fallen, faster = seconds, 0.5 * seconds**2, seconds
    else:
        gone = (1 - math.exp(-k * seconds)) / k
        fallen, faster = (seconds - gone) / k, gone
    kept = damping**seconds
    position = evil.Vec2(1 + velocity[0] * gone, 2 + velocity[1] * gone - G * fallen)
    return position, evil.Vec2(velocity[0] * kept, velocity[1] * kept - G * faster)


@pytest.mark.parametrize("velocity", [(0, 0), (5, 12)], ids=["free fall", "projectile"])
@pytest.mark.parametrize("damping", [1.0, 0.7, 0.05])
def test_the_error_of_a_flight_halves_with_the_step(damping, velocity):
    errors = []
    for substeps in (1, 2, 4, 8, 16):
        position, speed = flight(damping, velocity, substeps)
        there, fast = exact(damping, velocity)
        errors.append(((position - there).length, (speed - fast).length))
    for (coarse, _), (fine, _) in itertools.pairwise(errors):
        assert 1.9 < coarse / fine < 2.1
    assert errors[0][0] < 0.3, "a sixtieth of a second is a good step already"
    if damping == 1.0:
        assert max(error for _, error in errors) < 2e-4, "exact, but for single precision: a part in 100,000"
    else:
        assert errors[-1][1] < 0.6 * errors[-2][1]


@pytest.mark.parametrize("substeps", [1, 4, 9])
def test_free_fall_lags_by_half_a_substep_as_its_formula_says(substeps):
    position, _ = flight(1.0, (0, 0), substeps)
    h = 1 / 60 / substeps
    assert position.y == pytest.approx(2 - 0.5 * G * 2.0 * (2.0 + h), abs=1e-4)


@pytest.mark.parametrize("damping", [1.0, 0.9, 0.3, 1e-3])
@pytest.mark.parametrize("substeps", [1, 4])
def test_damping_of_velocity_and_spin_is_exact_at_any_step(damping, substeps):
    world = evil.World(gravity=(0, 0))
    ball = world.add(
        evil.Circle(0.5), velocity=(3, -4), angular_velocity=7, damping=damping, angular_damping=damping**0.5
    )
    for _ in range(90):
        world.step(1 / 60, substeps)
    assert ball.velocity.length == pytest.approx(5 * damping**1.5, rel=1e-4)
    assert ball.angular_velocity == pytest.approx(7 * damping**0.75, rel=1e-4)


def test_a_torque_turns_a_body_as_its_moment_of_inertia_says():
    world = evil.World(gravity=(0, 0))
    bar = world.add(evil.Rectangle(3, 0.5), mass=2.0)
    inertia = 2.0 * (3**2 + 0.5**2) / 12
    assert bar.inertia == pytest.approx(inertia, rel=1e-6)
    for _ in range(60):
        bar.apply_torque(1.5)
        world.step(1 / 60, 4)
    assert bar.angular_velocity == pytest.approx(1.5 / inertia, rel=1e-5)
    h = 1 / 240
    assert bar.angle == pytest.approx(0.5 * 1.5 / inertia * (1 + h), rel=1e-4)


def test_a_force_off_the_centre_turns_by_its_arm():
    world = evil.World(gravity=(0, 0))
    bar = world.add(evil.Rectangle(3, 0.5), mass=2.0)
    bar.apply_force((0, 4), at=(1.25, 0.25))
    world.step(1 / 60)
    assert bar.velocity.y == pytest.approx(4 / 2.0 / 60, rel=1e-5)
    assert bar.angular_velocity == pytest.approx(1.25 * 4 / bar.inertia / 60, rel=1e-4)  # (4.7), (4.6)


@pytest.mark.parametrize(("mass", "stiffness"), [(1, 40), (0.25, 90), (12, 30)])
def test_a_spring_swings_with_the_period_of_its_mass_and_stiffness(mass, stiffness):
    world = evil.World(gravity=(0, 0))
    bob = world.add(evil.Circle(0.1), at=(3, 0), mass=mass)
    bob.add_force(evil.Spring(to=(0, 0), stiffness=stiffness, rest_length=2))
    period = 2 * math.pi * math.sqrt(mass / stiffness)
    crossings, before, furthest = [], bob.position.x - 2, 0.0
    while len(crossings) < 21:
        world.step(1 / 60, 4)
        now = bob.position.x - 2
        if before * now < 0:
            crossings.append(world.time - 1 / 60 * now / (now - before))
        furthest = max(furthest, abs(now))
        before = now
    measured = (crossings[-1] - crossings[0]) / 10
    assert measured == pytest.approx(period, rel=2e-3)
    assert furthest == pytest.approx(1.0, rel=0.02), "and neither gains nor loses"


def test_a_damped_spring_dies_away_as_fast_as_its_damping_says():
    mass, stiffness, damping = 2.0, 50.0, 1.2
    world = evil.World(gravity=(0, 0))
    bob = world.add(evil.Circle(0.1), at=(3, 0), mass=mass)
    bob.add_force(evil.Spring(to=(0, 0), stiffness=stiffness, rest_length=2, damping=damping))
    tops, last, before = [], 0.0, 1.0
    for _ in range(600):
        world.step(1 / 60, 16)
        now = bob.position.x - 2
        if last > before and last > now and last > 0.01:
            tops.append(last)
        before, last = last, now
    ratios = [b / a for a, b in itertools.pairwise(tops)]
    decay, turning = damping / (2 * mass), math.sqrt(stiffness / mass - (damping / (2 * mass)) ** 2)
    assert len(ratios) >= 5
    assert ratios[0] == pytest.approx(math.exp(-decay * 2 * math.pi / turning), rel=0.02)


def test_a_spinning_dumbbell_keeps_its_centre_spin_and_length():
    world = evil.World(gravity=(0, 0))
    bar = world.add(evil.Rectangle(4, 0.1), at=(10, -3), angular_velocity=6, velocity=(0.5, 0.25), density=0.01)
    for side in (-2, 2):
        bar.add_shape(evil.Circle(0.5), offset=(side, 0), density=3)
    start, inertia = bar.centre, bar.inertia
    momentum = bar.inertia * bar.angular_velocity
    for _ in range(1200):
        world.step(1 / 60, 4)
    assert (bar.centre - start - evil.Vec2(10, 5)).length < 2e-3
    assert bar.inertia == inertia
    assert bar.inertia * bar.angular_velocity == pytest.approx(momentum, rel=1e-6)
    assert bar.angle == pytest.approx(6 * 20, rel=1e-5)


def test_two_masses_on_a_spring_turn_about_their_centre_and_keep_angular_momentum():
    world = evil.World(gravity=(0, 0))
    light = world.add(evil.Circle(0.2), at=(-2, 0), mass=1, velocity=(0, -4))
    heavy = world.add(evil.Circle(0.2), at=(1, 0), mass=2, velocity=(0, 2))
    light.add_force(evil.Spring(to=heavy, stiffness=400, rest_length=2.7))

    def angular_momentum():
        return sum(body.mass * body.centre.cross(body.velocity) for body in (light, heavy))

    before, furthest = angular_momentum(), 0.0
    for _ in range(1200):
        world.step(1 / 60, 8)
        centre = (light.centre + 2 * heavy.centre) / 3
        furthest = max(furthest, centre.length)
        assert 2.4 < (light.centre - heavy.centre).length < 3.001, "the spring breathes about its length under the pull"
    assert furthest < 1e-3
    assert angular_momentum() == pytest.approx(before, rel=1e-4)
