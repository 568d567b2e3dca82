"""Force generators (SPEC P2): against formulas, shared, changed, written in Python, saved."""

import math
import sys

import pytest

import evilengine as evil


@pytest.fixture
def space():
    return evil.World(gravity=(0, 0))


class Swirl(evil.Force):
    """A force with state of its own: it turns a little each step."""

    def __init__(self, strength):
        self.strength = strength
        self.angle = 0.0

    def apply(self, bodies, dt):
        self.angle += dt
        for body in bodies:
            body.apply_force(evil.Vec2(self.strength, 0).turned(self.angle))


def test_gravity_force_accelerates_every_mass_alike(space):
    light, heavy = space.add(evil.Particle(0.1)), space.add(evil.Particle(50))
    space.add_force(evil.Gravity((0, -2)), [light, heavy])
    for _ in range(60):
        space.step()
    assert light.velocity == pytest.approx((0, -2), abs=1e-4)
    assert heavy.velocity == pytest.approx((0, -2), abs=1e-4)


def test_constant_force_off_centre_turns_the_body(space):
    bar = space.add(evil.Rectangle(2, 0.5), mass=2)
    bar.add_force(evil.ConstantForce((0, 1), at=(1, 0)))
    space.step(1 / 60)
    assert bar.velocity.y == pytest.approx(1 / 2 / 60, rel=1e-3)
    assert bar.angular_velocity == pytest.approx(1 / bar.inertia / 60, rel=1e-3)


@pytest.mark.parametrize(("mass", "stiffness"), [(1, 20), (2, 20), (0.5, 300)])
def test_a_spring_swings_with_its_period(space, mass, stiffness):
    bob = space.add(evil.Particle(mass), at=(1, 0))
    bob.add_force(evil.Spring(to=(0, 0), stiffness=stiffness))
    dt, crossings, before = 1 / 240, [], 1.0
    for step in range(4000):
        space.step(dt)
        x = bob.position.x
        if before < 0 <= x:
            crossings.append((step - x / (x - before)) * dt)
        before = x
    period = (crossings[-1] - crossings[0]) / (len(crossings) - 1)
    assert period == pytest.approx(2 * math.pi * math.sqrt(mass / stiffness), rel=1e-3)


def test_a_spring_without_damping_keeps_its_swing(space):
    bob = space.add(evil.Particle(1), at=(1, 0))
    bob.add_force(evil.Spring(to=(0, 0), stiffness=20))
    widest = 0.0
    for step in range(6000):
        space.step()
        if step > 5000:
            widest = max(widest, bob.position.x)
    assert widest == pytest.approx(1, abs=0.02)


def test_a_spring_hangs_a_weight_where_hooke_says(space):
    space.sleep = False  # it would fall asleep a few millimetres before the end of its slow approach
    weight = space.add(evil.Particle(2), at=(0, 5))
    space.gravity = (0, -10)
    weight.add_force(evil.Spring(to=(0, 8), stiffness=40, rest_length=1, damping=8))
    for _ in range(1200):
        space.step()
    assert weight.position == pytest.approx((0, 8 - 1 - 2 * 10 / 40), abs=2e-3)


def test_a_spring_between_bodies_pushes_both_and_keeps_momentum(space):
    a, b = space.add(evil.Particle(1), at=(-2, 0)), space.add(evil.Particle(3), at=(2, 0))
    a.add_force(evil.Spring(to=b, stiffness=10, rest_length=1))
    for _ in range(100):
        space.step()
        assert (a.velocity * 1 + b.velocity * 3).length < 1e-4
    assert abs(a.velocity.x) > 0.01


@pytest.mark.parametrize("stiffness", [1e6, 1e12])
def test_a_spring_too_stiff_for_the_step_does_not_explode(space, stiffness):
    bob = space.add(evil.Particle(1), at=(1, 0))
    bob.add_force(evil.Spring(to=(0, 0), stiffness=stiffness, damping=1))
    for _ in range(600):
        space.step()
        assert bob.position.length < 1.5


def test_linear_drag_decays_as_the_exponential(space):
    ball = space.add(evil.Particle(2), velocity=(8, 0))
    ball.add_force(evil.Drag(linear=3))
    for _ in range(60):
        space.step()
    assert ball.velocity.x == pytest.approx(8 * math.exp(-3 / 2), rel=0.01)


def test_drag_as_strong_as_it_may_be_stops_and_never_reverses(space):
    ball = space.add(evil.Circle(0.5), velocity=(8, 0), angular_velocity=9)
    ball.add_force(evil.Drag(linear=1e9, quadratic=1e9))
    space.step()
    assert 0 <= ball.velocity.x < 0.01
    assert 0 <= ball.angular_velocity < 0.01


def test_quadratic_drag_gives_terminal_velocity(space):
    space.gravity = (0, -10)
    ball = space.add(evil.Particle(2), at=(0, 0))
    ball.add_force(evil.Drag(quadratic=0.05))
    for _ in range(1800):
        space.step()
    assert ball.velocity.y == pytest.approx(-math.sqrt(2 * 10 / 0.05), rel=2e-3)  # implicit: h c v / m = 0.2% too fast


def test_a_medium_slows_only_what_is_inside_it(space):
    space.add_force(evil.Medium((0, -1, 10, 1), linear=5))
    inside = space.add(evil.Particle(1), at=(1, 0), velocity=(1, 0))
    outside = space.add(evil.Particle(1), at=(1, 3), velocity=(1, 0))
    thin = space.add(evil.Particle(1), at=(1, 0.5), velocity=(1, 0), drag=0)
    for _ in range(30):
        space.step()
    assert inside.velocity.x < 0.2
    assert outside.velocity.x == pytest.approx(1)
    assert thin.velocity.x == pytest.approx(1)


@pytest.mark.parametrize("shape", [evil.Circle(2), evil.Polygon([(-2, -2), (2, -2), (2, 2), (0, -1), (-2, 2)])])
def test_a_medium_takes_any_shape_as_its_area(space, shape):
    space.add_force(evil.Medium(shape, at=(10, 0), linear=50))
    inside = space.add(evil.Particle(1), at=(10, -1.5), velocity=(1, 0))
    outside = space.add(evil.Particle(1), at=(10, 3), velocity=(1, 0))
    space.step()
    assert inside.velocity.x < 0.6
    assert outside.velocity.x == 1


def test_a_pull_brings_a_body_to_the_finger_and_carries_its_weight():
    world = evil.World()
    box = world.add(evil.Rectangle(1, 1), at=(0, 0))
    pull = box.add_force(evil.Pull((2, 1)))
    for _ in range(120):
        world.step()
    assert box.position == pytest.approx((2, 1), abs=0.01)
    pull.to = (0, 3)
    for _ in range(120):
        world.step()
    assert box.position == pytest.approx((0, 3), abs=0.01)
    pull.destroy()
    world.step()
    assert box.velocity.y < 0


def test_walls_hold_against_a_pull():
    world = evil.World()
    world.add(evil.Rectangle(1, 10), at=(3, 0), kind="static")
    box = world.add(evil.Rectangle(1, 1))
    box.add_force(evil.Pull((100, 0)))
    for _ in range(300):
        world.step()
        assert box.position.x < 2.1


def test_one_force_is_shared_by_many_bodies_and_changed_for_all(space):
    bodies = [space.add(evil.Particle(1), at=(i, 0)) for i in range(3)]
    wind = evil.ConstantForce((1, 0))
    assert bodies[0].add_force(wind) is wind
    bodies[1].add_force(wind)
    assert wind.bodies == tuple(bodies[:2])
    wind.force = (2, 0)
    wind.attach(bodies[2])
    wind.detach(bodies[0])
    space.step(0.5)
    assert [body.velocity.x for body in bodies] == pytest.approx([0, 1, 1])
    assert bodies[1].forces == (wind,)


def test_a_force_without_bodies_acts_on_all_also_on_later_ones(space):
    space.add_force(evil.Gravity((1, 0)))
    late = space.add(evil.Circle(1))
    space.step(0.5)
    assert late.velocity.x == pytest.approx(0.5)


def test_a_force_in_python_acts_each_step(space):
    ball = space.add(evil.Particle(1))
    swirl = ball.add_force(Swirl(3))
    space.step(0.5)
    assert ball.velocity == pytest.approx(evil.Vec2(1.5, 0).turned(0.5), abs=1e-5)
    swirl.destroy()
    velocity = ball.velocity
    space.step(0.5)
    assert ball.velocity == velocity


def test_a_force_in_python_is_saved_with_its_state_and_goes_on_exactly(space):
    ball = space.add(evil.Particle(1))
    ball.add_force(Swirl(3))
    for _ in range(10):
        space.step()
    data = space.snapshot()
    twin = evil.World.of(data)
    for _ in range(10):
        space.step()
        twin.step()
    assert space.snapshot() == twin.snapshot()
    space.restore(data)
    for _ in range(10):
        space.step()
    assert space.snapshot() == twin.snapshot()


def test_a_snapshot_does_not_make_the_program_import_what_it_has_not_imported(space):
    ball = space.add(evil.Particle(1))
    swirl = ball.add_force(Swirl(3))
    data = space.snapshot()
    swirl.destroy()
    module = sys.modules.pop(__name__)
    try:
        with pytest.raises(evil.SnapshotError, match="import that module first"):
            evil.World.of(data)
        assert __name__ not in sys.modules
    finally:
        sys.modules[__name__] = module


def test_a_force_with_what_cannot_be_saved_says_so(space):
    ball = space.add(evil.Particle(1))
    swirl = ball.add_force(Swirl(3))
    swirl.friend = ball
    with pytest.raises(evil.SnapshotError, match="Swirl"):
        space.snapshot()


def test_a_destroyed_force_is_stale(space):
    ball = space.add(evil.Particle(1))
    spring = ball.add_force(evil.Spring(to=(0, 3)))
    spring.destroy()
    assert not spring.alive
    with pytest.raises(evil.StaleReferenceError, match="this Force"):
        spring.stiffness = 3
    assert ball.forces == ()


def test_a_spring_dies_with_the_body_it_leads_to(space):
    ball, anchor = space.add(evil.Particle(1)), space.add(evil.Particle(1), at=(1, 0))
    spring = ball.add_force(evil.Spring(to=anchor))
    anchor.destroy()
    assert not spring.alive
    space.step()
    with pytest.raises(evil.StaleReferenceError, match="destroyed at step 0"):
        spring.stiffness  # noqa: B018


def test_a_force_outlives_a_body_that_it_acted_on(space):
    a, b = space.add(evil.Particle(1)), space.add(evil.Particle(1))
    wind = space.add_force(evil.ConstantForce((1, 0)), [a, b])
    a.destroy()
    assert wind.bodies == (b,)


@pytest.mark.parametrize(
    ("wrong", "words"),
    [
        (lambda w, b: b.add_force(evil.Circle(1)), "must be a Force"),
        (lambda w, b: b.add_force(evil.Spring(to=evil.World().add(evil.Circle(1)))), "another world"),
        (lambda w, b: evil.Gravity((math.nan, 0)), "acceleration"),
        (lambda w, b: evil.Drag(linear=-1), "linear=-1"),
        (lambda w, b: evil.Spring(to=(0, 0), stifness=1), "did you mean 'stiffness'"),
        (lambda w, b: evil.Medium("mud"), "area='mud'"),
        (lambda w, b: setattr(b.add_force(evil.Pull((0, 0))), "to", (math.inf, 0)), "to="),
        (lambda w, b: evil.Gravity((0, 1)).destroy(), "not in a world yet"),
    ],
)
def test_bad_forces_are_refused_clearly(space, wrong, words):
    body = space.add(evil.Circle(1))
    with pytest.raises(evil.Error, match=words):
        wrong(space, body)


def resting_box():
    """A world whose box has fallen asleep on the ground."""
    world = evil.World()
    world.add(evil.Rectangle(40, 1), at=(0, -0.5), kind="static", tag="ground")
    box = world.add(evil.Rectangle(1, 1), at=(0, 0.5))
    for _ in range(200):
        world.step()
    assert not box.awake
    return world, box


def test_a_force_on_everything_wakes_what_sleeps():
    world, box = resting_box()
    wind = world.add_force(evil.ConstantForce((50, 0)))
    for _ in range(30):
        world.step()
    assert box.position.x > 1
    wind.destroy()


def test_a_world_that_may_not_sleep_wakes_up():
    world, box = resting_box()
    world.sleep = False
    world.step()
    assert box.awake


@pytest.mark.parametrize("grow", [False, True])
def test_a_disc_that_turns_slowly_falls_asleep_unless_it_has_grown_a_long_arm(grow):
    world = evil.World(gravity=(0, 0))
    disc = world.add(evil.Circle(1), angular_velocity=0.03)
    for _ in range(20):
        world.step()
    assert disc.awake
    if grow:
        disc.add_shape(evil.Circle(0.1), offset=(9, 0))
    for _ in range(60):
        world.step()
    assert disc.awake is grow


def test_a_push_on_what_cannot_move_is_not_kept_for_later():
    world, _ = resting_box()
    ground = world.find("ground")
    ground.apply_force((0, 1e6))
    ground.apply_torque(1e6)
    world.step()
    assert ground.force == (0, 0)
    assert ground.torque == 0
    ground.gravity_scale, ground.kind = 0, "dynamic"
    world.step()
    assert abs(ground.velocity.y) < 1
