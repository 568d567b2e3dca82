"""Joints (SPEC P8): each kind against the mechanics that it stands for."""

import itertools
import math

import pytest

import evilengine as evil


def pendulum(length=1.0, angle=0.1, substeps=4, **keywords):
    """A point mass on a rod, let go at `angle` from straight down: the world, the ball, the joint."""
    world = evil.World(gravity=(0, -10), sleep=False)
    hook = world.add(evil.Circle(0.05), kind="static")
    at = (length * math.sin(angle), -length * math.cos(angle))
    ball = world.add(evil.Particle(mass=1), at=at)
    rod = world.add_joint(evil.joints.Distance(hook, ball, **keywords))
    return world, ball, rod


def zero_crossings(read, step, seconds, dt=1 / 60):
    """Times at which `read()` rises through 0, by linear interpolation."""
    times, before = [], read()
    for i in range(int(seconds / dt)):
        step()
        now = read()
        if before < 0 <= now:
            times.append((i + before / (before - now)) * dt)
        before = now
    return times


def mean_period(times):
    return (times[-1] - times[0]) / (len(times) - 1)


@pytest.mark.parametrize("length", [0.3, 1.0, 4.0])
def test_a_small_pendulum_swings_in_two_pi_root_l_over_g(length):
    world, ball, _ = pendulum(length)
    period = mean_period(zero_crossings(lambda: ball.position.x, world.step, 20))
    exact = 2 * math.pi * math.sqrt(length / 10) * (1 + 0.1**2 / 16)  # the first term of the series in the amplitude
    assert period == pytest.approx(exact, rel=0.003)


def test_a_rod_on_a_hinge_swings_as_a_physical_pendulum():
    world = evil.World(gravity=(0, -10), sleep=False)
    wall = world.add(evil.Circle(0.05), kind="static")
    rod = world.add(evil.Rectangle(0.1, 2), at=(0, -1))
    hinge = world.add_joint(evil.joints.Hinge(wall, rod, at=(0, 0)))
    rod.angular_velocity = 0.1
    times = zero_crossings(lambda: hinge.angle, world.step, 20)
    inertia = rod.inertia + rod.mass * 1**2
    assert mean_period(times) == pytest.approx(2 * math.pi * math.sqrt(inertia / (rod.mass * 10 * 1)), rel=0.005)


@pytest.mark.parametrize("given", [{"frequency": 2.0}, {"stiffness": 1.0 * (2 * math.pi * 2) ** 2}])
def test_a_spring_swings_at_its_frequency_and_keeps_its_swing(given):
    world = evil.World(gravity=(0, 0), sleep=False)
    wall = world.add(evil.Circle(0.1), kind="static")
    ball = world.add(evil.Particle(mass=1), at=(2.5, 0))
    spring = world.add_joint(evil.joints.Distance(wall, ball, length=2.0, **given))
    furthest = 0.0
    times = zero_crossings(lambda: spring.length - 2, world.step, 10)
    for _ in range(60):
        world.step()
        furthest = max(furthest, spring.length - 2)
    assert mean_period(times) == pytest.approx(0.5, rel=0.01)
    assert furthest == pytest.approx(0.5, rel=0.05)


def test_a_critically_damped_spring_comes_to_rest_without_overshoot():
    world = evil.World(gravity=(0, 0), sleep=False)
    wall = world.add(evil.Circle(0.1), kind="static")
    ball = world.add(evil.Particle(mass=3), at=(3, 0))
    spring = world.add_joint(evil.joints.Distance(wall, ball, length=2.0, frequency=1, damping_ratio=1))
    omega = 2 * math.pi
    for i in range(1, 121):
        world.step()
        t = i / 60
        assert spring.length - 2 == pytest.approx((1 + omega * t) * math.exp(-omega * t), abs=0.02)
    assert spring.length == pytest.approx(2.0, abs=0.001)


def test_a_hinge_carries_the_weight_and_says_so():
    world = evil.World(gravity=(0, -10))
    wall = world.add(evil.Circle(0.1), kind="static")
    sign = world.add(evil.Rectangle(1, 1), at=(0, -1), mass=3)
    hinge = world.add_joint(evil.joints.Hinge(wall, sign, at=(0, 0)))
    for _ in range(60):
        world.step()
    assert hinge.force.y == pytest.approx(30, rel=0.001)
    assert hinge.force.x == pytest.approx(0, abs=0.01)


def test_a_weld_carries_weight_and_torque():
    world = evil.World(gravity=(0, -10))
    wall = world.add(evil.Circle(0.1), kind="static")
    shelf = world.add(evil.Rectangle(2, 0.2), at=(1, 0), mass=3)
    weld = world.add_joint(evil.joints.Weld(wall, shelf, at=(0, 0)))
    for _ in range(120):
        world.step()
    assert weld.force.y == pytest.approx(30, rel=0.01)
    assert weld.torque == pytest.approx(30 * 1, rel=0.01)
    assert abs(weld.angle) < 0.005


def test_a_motor_turns_its_hinge_at_its_speed_and_no_stronger_than_its_torque():
    world = evil.World(gravity=(0, 0))
    wall = world.add(evil.Circle(0.1), kind="static")
    wheel = world.add(evil.Circle(1), mass=2)
    hinge = world.add_joint(evil.joints.Hinge(wall, wheel, at=(0, 0), motor_speed=6, max_torque=3))
    world.step(0.1)
    assert hinge.speed == pytest.approx(0.1 * 3 / wheel.inertia, rel=0.001)
    assert hinge.torque == pytest.approx(3, rel=0.001)
    for _ in range(240):
        world.step()
    assert hinge.speed == pytest.approx(6, rel=0.001)
    hinge.motor_speed = -2
    for _ in range(240):
        world.step()
    assert hinge.speed == pytest.approx(-2, rel=0.001)
    hinge.motor_speed = None
    wheel.angular_velocity = 5
    world.step()
    assert hinge.speed == pytest.approx(5, rel=0.001)


def test_limits_hold_and_may_change():
    world = evil.World(gravity=(0, -10))
    wall = world.add(evil.Circle(0.1), kind="static")
    arm = world.add(evil.Rectangle(2, 0.1), at=(1, 0))
    hinge = world.add_joint(evil.joints.Hinge(wall, arm, at=(0, 0), limits=(-0.5, 0.25)))
    lowest = 0.0
    for _ in range(180):
        world.step()
        lowest = min(lowest, hinge.angle)
    assert hinge.angle == pytest.approx(-0.5, abs=0.005)
    assert lowest > -0.51
    hinge.limits = (-1.0, 0.25)
    for _ in range(180):
        world.step()
    assert hinge.angle == pytest.approx(-1.0, abs=0.005)
    hinge.limits = None
    lowest = 0.0
    for _ in range(180):
        world.step()
        lowest = min(lowest, hinge.angle)
    assert lowest < -1.5


@pytest.mark.parametrize("most", [None, 100.0])
def test_a_strong_motor_stops_at_a_limit_and_does_not_push_through_it(most: float | None) -> None:
    world = evil.World()
    frame = world.add(evil.Rectangle(1, 1), kind="static")
    lift, door = world.add(evil.Rectangle(2, 0.2), at=(2, 0)), world.add(evil.Rectangle(2, 0.2), at=(-2, 0))
    rail = evil.joints.Slider(frame, lift, axis=(0, 1), limits=(-1, 3), motor_speed=2, max_force=most)
    pin = evil.joints.Hinge(frame, door, at=(-1, 0), limits=(-1, 1), motor_speed=2, max_torque=most)
    world.add_joint(rail), world.add_joint(pin)
    for way, ends in ((1, (3, 1)), (-1, (-1, -1))):
        rail.motor_speed, pin.motor_speed = 2 * way, 2 * way
        for _ in range(240):
            world.step()
        assert (rail.translation, pin.angle) == pytest.approx(ends, abs=0.003)
        assert (rail.speed, pin.speed) == pytest.approx((0, 0), abs=1e-3)


def test_joined_bodies_do_not_touch_unless_told_to():
    for collide, touching in ((False, 0), (True, 1)):
        world = evil.World(gravity=(0, 0))
        a, b = world.add(evil.Circle(1)), world.add(evil.Circle(1), at=(1.5, 0))
        world.step()
        assert len(world.contacts.active) == 1
        joint = world.add_joint(evil.joints.Hinge(a, b, at=(0.7, 0), collide=collide))
        world.step()
        assert len(world.contacts.active) == touching
        joint.destroy()
        world.step()
        assert len(world.contacts.active) == 1


def test_only_the_directly_joined_pass_through_each_other():
    world = evil.World(gravity=(0, 0))
    links = [world.add(evil.Circle(0.6), at=(i * 0.5, 0)) for i in range(4)]
    for a, b in itertools.pairwise(links):
        world.add_joint(evil.joints.Distance(a, b))
    world.step()
    pairs = {tuple(sorted((c.a.slot, c.b.slot))) for c in world.contacts.active}
    assert pairs == {(0, 2), (1, 3)}


def test_a_joint_breaks_at_its_force_and_tells():
    world = evil.World(gravity=(0, -10))
    hook = world.add(evil.Circle(0.1), kind="static")
    ball = world.add(evil.Circle(0.2), at=(0, -1), mass=1)
    rod = world.add_joint(evil.joints.Distance(hook, ball, breaking_force=25))
    heard = []
    rod.on_break(heard.append)
    for _ in range(60):
        world.step()
    assert rod.alive
    assert world.joints.broken == ()
    ball.mass = 3
    while rod.alive:
        assert world.steps < 70
        world.step()
    (broken,) = world.joints.broken
    assert heard == [broken]
    assert (broken.joint, broken.a, broken.b) == (rod, hook, ball)
    assert 25 < broken.force.y < 35
    assert len(world.joints) == 0
    world.step()
    assert world.joints.broken == ()
    with pytest.raises(evil.StaleReferenceError, match="destroyed at step"):
        rod.force  # noqa: B018


@pytest.mark.parametrize("asleep", [False, True])
def test_a_joint_that_is_told_to_hold_less_than_it_bears_breaks_in_the_next_step(asleep):
    world = evil.World(gravity=(0, -10), sleep=asleep)
    hook = world.add(evil.Circle(0.1), kind="static")
    ball = world.add(evil.Circle(0.2), at=(0, -1), mass=1)
    rods = [
        world.add_joint(evil.joints.Distance(hook, ball)),
        world.add_joint(evil.joints.Hinge(hook, ball, at=hook.position)),
    ]
    for _ in range(120):
        world.step()
    assert ball.awake is not asleep
    pull = max(rods, key=lambda rod: rod.force.length)
    pull.breaking_force = 0.5 * pull.force.length
    world.step()
    assert [broken.joint for broken in world.joints.broken] == [pull]


def test_joints_go_with_their_bodies_and_sleep_and_wake_with_them():
    world = evil.World()
    ground = world.add(evil.Rectangle(40, 1), at=(0, -0.5), kind="static")
    boxes = [world.add(evil.Rectangle(0.8, 0.8), at=(i, 0.4)) for i in range(5)]
    joints = [
        world.add_joint(evil.joints.Weld(a, b, at=(i + 0.5, 0.4))) for i, (a, b) in enumerate(itertools.pairwise(boxes))
    ]
    for _ in range(120):
        world.step()
    assert not any(box.awake for box in boxes)
    boxes[4].apply_impulse((0, 0.1))
    world.step()
    assert all(box.awake for box in boxes)
    boxes[1].destroy()
    assert [joint.alive for joint in joints] == [False, False, True, True]
    assert list(world.joints) == joints[2:]
    assert boxes[2].joints == (joints[2],)
    assert ground.joints == ()


def test_what_makes_no_sense_is_refused_and_changes_nothing():
    world, other = evil.World(), evil.World()
    a, b = world.add(evil.Circle(1)), world.add(evil.Circle(1), at=(3, 0))
    far = other.add(evil.Circle(1))
    before = world.snapshot()
    for make, words in (
        (lambda: evil.joints.Hinge(a, a, at=(0, 0)), "two different bodies"),
        (lambda: evil.joints.Hinge(a, far, at=(0, 0)), "two worlds"),
        (lambda: evil.joints.Hinge(a, None, at=(0, 0)), "must be a Body"),
        (lambda: evil.joints.Hinge(a, b, at=(0, math.nan)), "at"),
        (lambda: evil.joints.Hinge(a, b, at=(0, 0), limits=(1, -1)), "smaller number first"),
        (lambda: evil.joints.Hinge(a, b, at=(0, 0), limits=3), "limits=3"),
        (lambda: evil.joints.Hinge(a, b, at=(0, 0), frequency=-1), "frequency=-1"),
        (lambda: evil.joints.Hinge(a, b, at=(0, 0), frequency=1, stiffness=3), "frequency and damping_ratio, or"),
        (lambda: evil.joints.Hinge(a, b, at=(0, 0), motor_speed=math.inf), "motor_speed=inf"),
        (lambda: evil.joints.Hinge(a, b, at=(0, 0), max_torqe=1), "did you mean 'max_torque'"),
        (lambda: evil.joints.Distance(a, b, length=-1), "length=-1"),
        (lambda: evil.joints.Distance(a, b, breaking_force=0), "breaking_force=0"),
        (lambda: evil.joints.Slider(a, b, axis=(0, 0)), "must have a direction"),
        (lambda: evil.joints.Gear(a, b, ratio=0), "ratio=0"),
        (lambda: evil.joints.Pulley(a, b, (0, 1), (1, 1), ratio=-1), "more than 0"),
        (lambda: world.add_joint("hinge"), "must be one of evil.joints"),
        (lambda: evil.joints.Hinge(a, b, at=(0, 0)).force, "not in a world yet"),
        (lambda: other.add_joint(evil.joints.Hinge(a, b, at=(0, 0))), "another world"),
    ):
        with pytest.raises(evil.Error, match=words.replace("(", r"\(")):
            make()
    assert world.snapshot() == before
    hinge = world.add_joint(evil.joints.Hinge(a, b, at=(0, 0)))
    with pytest.raises(evil.ArgumentError, match="added before"):
        world.add_joint(hinge)
    held = world.snapshot()
    with pytest.raises(evil.ArgumentError):
        hinge.limits = (2, 1)
    with pytest.raises(evil.ArgumentError):
        hinge.max_torque = -1
    assert world.snapshot() == held
