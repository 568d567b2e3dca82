"""Media: drag, wind and buoyancy by the true share of a body that is inside, with numbers."""

from __future__ import annotations

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import evilengine as evil

G = 9.81


@pytest.fixture
def world():
    return evil.World(sleep=False)


def lake(world, **words):
    return world.add_force(evil.Medium((-50, -20, 50, 0), **{"density": 1.0, "linear": 3.0, **words}))


def run(world, seconds):
    for _ in range(round(seconds * 60)):
        world.step()


def lift(world, body, medium):
    """Newtons by which the medium lifts a body at rest, from what one step gives it."""
    body.velocity, body.angular_velocity = (0, 0), 0
    world.step(1e-3, substeps=1)
    return (body.acceleration.y + G) * body.mass


@pytest.mark.parametrize("density", [0.2, 0.5, 0.9])
@pytest.mark.parametrize("height", [0.5, 1.0])
def test_a_box_floats_at_its_draft(world, density, height):
    lake(world)
    box = world.add(evil.Rectangle(2, height), at=(0, 1), density=density)
    run(world, 30)
    assert 0.5 * height - box.position.y == pytest.approx(density * height, abs=2e-3)
    assert box.angle == pytest.approx(0, abs=1e-3)


def test_a_ball_floats_half_sunk_at_half_the_density(world):
    lake(world)
    ball = world.add(evil.Circle(0.7), at=(0, 1), density=0.5)
    run(world, 30)
    assert ball.position.y == pytest.approx(0, abs=2e-3)


def test_what_is_denser_sinks_and_what_is_as_dense_hovers(world):
    lake(world)
    stone = world.add(evil.Circle(0.3), at=(-3, -1), density=2.5)
    fish = world.add(evil.Circle(0.3), at=(3, -5), density=1.0)
    run(world, 2)
    assert stone.position.y < -3
    assert fish.position == pytest.approx((3, -5), abs=1e-3)


def test_a_box_that_stands_on_its_edge_rights_itself(world):
    lake(world)
    plank = world.add(evil.Rectangle(3, 0.6), at=(0, 0), angle=1.2, density=0.5)
    run(world, 40)
    assert math.remainder(plank.angle, math.pi) == pytest.approx(0, abs=0.02)
    assert plank.position.y == pytest.approx(0, abs=0.01)


def test_a_compound_floats_with_its_heavy_side_down(world):
    lake(world)
    buoy = world.add(evil.Circle(0.5), at=(0, 0), angle=2.0, density=0.3)
    buoy.add_shape(evil.Rectangle(0.2, 1), offset=(0, 0.8), density=2)
    run(world, 60)
    assert math.cos(buoy.angle) == pytest.approx(-1, abs=0.01)


def test_a_body_sinks_at_the_speed_at_which_drag_holds_its_weight(world):
    world.add_force(evil.Medium((-50, -2000, 50, 0), density=1.0, quadratic=2.0))
    stone = world.add(evil.Rectangle(1, 1), at=(0, -5), density=3.0)
    run(world, 20)
    assert stone.velocity.y == pytest.approx(-math.sqrt((3 - 1) * G / 2), rel=1e-3)
    slow = world.add(evil.Rectangle(1, 1), at=(9, -5), density=3.0, drag=4)
    run(world, 20)
    assert slow.velocity.y == pytest.approx(-math.sqrt((3 - 1) * G / 8), rel=1e-3)


def test_wind_carries_what_is_in_it_along_and_no_faster():
    world = evil.World(gravity=(0, 0))
    world.add_force(evil.Medium((-500, -5, 500, 5), linear=2.0, velocity=(6, 0)))
    leaf = world.add(evil.Circle(0.2), at=(0, 0), mass=1)
    outside = world.add(evil.Circle(0.2), at=(0, 9), mass=1)
    run(world, 0.5)
    assert leaf.velocity.x == pytest.approx(6 * (1 - math.exp(-2 * 0.5)), rel=0.02)
    run(world, 10)
    assert leaf.velocity.x == pytest.approx(6, rel=1e-3)
    assert outside.velocity == (0, 0)


def test_half_inside_is_half_the_drag():
    def slowed(area):
        world = evil.World(gravity=(0, 0))
        world.add_force(evil.Medium(area, linear=1.0))
        box = world.add(evil.Rectangle(2, 2), velocity=(1, 0), mass=1)
        world.step(1e-3, substeps=1)
        return 1 - box.velocity.x

    assert slowed((-9, -9, 9, 0)) == pytest.approx(0.5 * slowed((-9, -9, 9, 9)), rel=0.01)


def test_what_is_dragged_on_one_side_turns():
    world = evil.World(gravity=(0, 0))
    world.add_force(evil.Medium((-9, -9, 9, 0), linear=5.0))
    box = world.add(evil.Rectangle(2, 2), velocity=(3, 0))
    run(world, 0.2)
    assert box.angular_velocity < -0.1


def shoelace(corners):
    return 0.5 * sum(p[0] * q[1] - p[1] * q[0] for p, q in zip(corners, corners[1:] + corners[:1], strict=True))


def share_by_counting(contains, body, shape_contains, n=200):
    """The area of what two shapes share, by a fine grid over the unit of a body."""
    size = 2.0
    cell = 2 * size / n
    count = 0
    for i in range(n):
        for j in range(n):
            p = evil.Vec2(-size + (i + 0.5) * cell, -size + (j + 0.5) * cell)
            if shape_contains(p) and contains(body.to_world(p)):
                count += 1
    return count * cell * cell


SHAPES = {
    "circle": (evil.Circle(0.8), lambda p: p.length <= 0.8),
    "box": (evil.Rectangle(2, 1), lambda p: abs(p.x) <= 1 and abs(p.y) <= 0.5),
    "capsule": (evil.Capsule((-0.6, 0), (0.6, 0), 0.5), lambda p: math.hypot(max(abs(p.x) - 0.6, 0), p.y) <= 0.5),
    "ell": (
        evil.Polygon([(0, 0), (1.5, 0), (1.5, 0.5), (0.5, 0.5), (0.5, 1.5), (0, 1.5)]),
        lambda p: 0 <= p.x <= 1.5 and 0 <= p.y <= 1.5 and (p.x <= 0.5 or p.y <= 0.5),
    ),
}
AREAS = {
    "circle": (evil.Circle(1.5), lambda p: p.length <= 1.5),
    "box": ((-2, -1, 1, 0.7), lambda p: -2 <= p.x <= 1 and -1 <= p.y <= 0.7),
    "notch": (
        evil.Polygon([(-2, -2), (2, -2), (2, 2), (0, -1), (-2, 2)]),
        lambda p: -2 <= p.x <= 2 and -2 <= p.y <= 1.5 * abs(p.x) - 1,
    ),
}


@pytest.mark.parametrize("area", AREAS)
@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("place", [(0.3, 0.2, 0.4), (1.1, -0.6, 2.0), (-1.0, 0.9, -1.0)])
def test_the_lift_is_the_weight_of_the_water_that_is_displaced(world, area, shape, place):
    (definition, contains), (form, holds) = AREAS[area], SHAPES[shape]
    x, y, angle = place
    medium = world.add_force(evil.Medium(definition, density=2.0))
    body = world.add(form, at=(x, y), angle=angle, mass=100)
    wanted = share_by_counting(contains, body, holds)
    assert lift(world, body, medium) / (2.0 * G) == pytest.approx(wanted, abs=0.012)


@settings(max_examples=40, deadline=None)
@given(
    x=st.floats(-3, 3),
    y=st.floats(-3, 3),
    angle=st.floats(-7, 7),
    radius=st.floats(0.2, 2),
    around=st.floats(0.2, 2),
)
def test_a_circle_displaces_what_a_polygon_of_many_corners_does(x, y, angle, radius, around):
    many = [(radius * math.cos(i * math.pi / 100), radius * math.sin(i * math.pi / 100)) for i in range(200)]
    lifts = []
    for shape in (evil.Circle(radius), evil.Polygon(many)):
        for area in (
            evil.Circle(around),
            evil.Polygon([(around * p[0] / radius, around * p[1] / radius) for p in many]),
        ):
            world = evil.World()
            medium = world.add_force(evil.Medium(area, density=1))
            lifts.append(lift(world, world.add(shape, at=(x, y), angle=angle, mass=1000), medium))
    assert max(lifts) - min(lifts) <= 0.02 * G * min(radius, around) ** 2 + 0.01


def test_a_medium_that_a_body_carries_moves_with_it():
    world = evil.World(gravity=(0, -G))
    fan = world.add(evil.Rectangle(0.2, 0.2), at=(0, 5), angle=math.pi / 2, kind="kinematic", velocity=(1, 0))
    draught = world.add_force(evil.Medium((0, -1, 10, 1), linear=4, velocity=(8, 0), body=fan))  # blows upwards now
    ball = world.add(evil.Circle(0.3), at=(0, 8), mass=1, gravity_scale=0)
    run(world, 0.5)
    assert ball.velocity.y > 3
    assert 0 < ball.velocity.x <= 1.01  # taken along with the fan
    assert draught.body is fan
    fan.destroy()
    assert not draught.alive


def test_a_carried_medium_wakes_what_it_comes_to():
    world = evil.World()
    world.add(evil.Rectangle(40, 1), at=(0, -0.5), kind="static")
    box = world.add(evil.Rectangle(1, 1), at=(5, 0.5))
    fan = world.add(evil.Circle(0.2), at=(-5, 3), kind="kinematic")
    world.add_force(evil.Medium((-2, -3, 2, 0), density=3, body=fan))
    run(world, 2)
    assert not box.awake
    fan.velocity = (4, 0)
    run(world, 3)
    assert box.position.y > 0.6


@pytest.mark.parametrize("change", ["density", "velocity", "linear", "area"])
def test_a_change_of_the_medium_wakes_who_sleeps_in_it(change):
    world = evil.World()
    world.add(evil.Rectangle(40, 1), at=(0, -5), kind="static")
    medium = world.add_force(evil.Medium((-9, -9, 9, 0), linear=1, density=0.5))
    box = world.add(evil.Rectangle(1, 1), at=(0, -4))
    run(world, 2)
    assert not box.awake
    setattr(medium, change, {"density": 2, "velocity": (5, 0), "linear": 2, "area": (-9, -9, 9, 1)}[change])
    assert box.awake


def test_a_rising_tide_lifts_the_boat(world):
    sea = lake(world, linear=8.0)
    boat = world.add(evil.Rectangle(2, 1), at=(0, 0), density=0.5)
    run(world, 10)
    sea.area = (-50, -20, 50, 3)
    run(world, 20)
    assert boat.position.y == pytest.approx(3, abs=0.01)
    assert sea.area == evil.Rectangle(100, 23)


def test_a_particle_is_inside_or_not(world):
    world.add_force(evil.Medium(evil.Circle(2), linear=1, velocity=(3, 0)))
    inside, outside = (world.add(evil.Particle(mass=1), at=(x, 0), gravity_scale=0) for x in (1, 5))
    run(world, 0.2)
    assert inside.velocity.x > 0.4
    assert outside.velocity.x == 0


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: evil.Medium((0, 0, 1, 1), density=-1), "density=-1"),
        (lambda: evil.Medium((0, 0, 1, 1), velocity=3), "velocity"),
        (lambda: evil.Medium((0, 0, 1, 1), body="boat"), "body='boat' must be a Body"),
        (lambda: evil.World().add_force(evil.Medium(evil.Segment((0, 0), (1, 1)))), "shape with an inside"),
        (lambda: evil.World().add_force(evil.Medium(evil.Particle())), "shape with an inside"),
    ],
)
def test_what_is_no_medium_is_refused(make, message):
    with pytest.raises(evil.Error, match=message):
        make()


def test_media_are_in_a_snapshot_and_the_lists_of_another_process_know_them(world):
    ship = world.add(evil.Rectangle(3, 1), kind="kinematic", velocity=(1, 0))
    lake(world, velocity=(0.5, 0), quadratic=0.2)
    world.add_force(evil.Medium(evil.Circle(2), linear=3, body=ship, at=(0, 1)))
    for x in range(4):
        world.add(evil.Rectangle(1, 0.5 + 0.2 * x), at=(2 * x, 0), density=0.4)
    twin = evil.World.of(world.snapshot())
    for _ in range(60):
        world.step()
        twin.step()
    assert twin.snapshot() == world.snapshot()
    water, bubble = twin.forces
    assert (water.density, water.velocity, water.area.area) == (1, (0.5, 0), pytest.approx(2000))
    assert (bubble.area, bubble.at, bubble.body.slot) == (evil.Circle(2), (0, 1), ship.slot)


def test_a_medium_knows_the_area_that_a_restore_gave_back(world):
    water = lake(world)
    puddle = world.add_force(evil.Medium(evil.Circle(1), at=(3, 0)))
    saved, area = world.snapshot(), water.area
    water.area = (0, 0, 1, 1)
    world.restore(saved)
    left, bottom = min(water.area.corners)
    assert (water.at.x + left, water.at.y + bottom, water.area.area) == (-50, -20, pytest.approx(area.area))
    assert (puddle.area, puddle.at) == (evil.Circle(1), (3, 0))


@settings(max_examples=25, deadline=None)
@given(
    density=st.floats(1e-3, 1e3),
    linear=st.floats(0, 1e9),
    quadratic=st.floats(0, 1e9),
    water=st.floats(0, 50),
    speed=st.floats(-1e4, 1e4),
    wind=st.floats(-1e3, 1e3),
)
def test_whatever_its_numbers_nothing_explodes(density, linear, quadratic, water, speed, wind):
    world = evil.World()
    world.add_force(evil.Medium((-5, -5, 5, 5), linear=linear, quadratic=quadratic, density=water, velocity=(wind, 0)))
    box = world.add(evil.Rectangle(1, 0.4), density=density, velocity=(speed, -speed), angular_velocity=speed / 100)
    for _ in range(30):
        world.step()
        assert all(math.isfinite(value) for value in (*box.position, *box.velocity, box.angle))
        if linear == quadratic == 0:
            continue
        fastest = abs(speed) * 2 + abs(wind) + 30 * G * (1 + water / density) / 60 + abs(speed)
        assert box.velocity.length <= fastest + 1


def test_a_carrier_beside_any_force_keeps_the_speed_that_it_was_given():
    world = evil.World(gravity=(0, -G))
    fan = world.add(evil.Rectangle(1, 1), kind="kinematic", velocity=(1, 0), angular_velocity=2)
    world.add_force(evil.Medium((5, 5, 6, 6), linear=1))
    run(world, 1)
    assert fan.velocity == (1, 0)
    assert fan.angular_velocity == 2
    assert abs(fan.position.x - 1) < 1e-4
