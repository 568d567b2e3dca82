"""Grabs: fingers hold bodies by a pull, each its own, and slide onto them (SPEC I1, I3)."""

from __future__ import annotations

import itertools

import pytest

import evilengine as evil
from evilengine.interaction import Grabs, Interaction
from evilengine.platform import HeadlessDevice
from evilengine.values.inputs import Inputs, Touch
from evilengine.values.vec2 import Vec2

DT = 1 / 60


class Table:
    """A world seen by a camera of 50 pixels a metre on a screen of 960x540, and a player's hands on it."""

    def __init__(self, gravity=(0.0, -9.81)):
        self.world = evil.World(gravity=gravity)
        self.device = HeadlessDevice((960, 540))
        self.interaction = Interaction()
        self.grabs = Grabs()

    def crate(self, x, y, **options):
        return self.world.add(evil.Rectangle(1, 1), at=(x, y), **{"touchable": True, **options})

    def finger(self, finger, phase, x, y):
        self.device.touch(finger, phase, at=(480 + 50 * x, 270 - 50 * y))

    def step(self, steps=1):
        """Play some steps; returns what bodies were told in them, as (body, phase)."""
        told = []
        for _ in range(steps):
            self.interaction.collect(self.device.poll())
            inputs = self.interaction.snapshot(
                lambda pixel, began=None: Vec2((pixel.x - 480) / 50, (270 - pixel.y) / 50), DT
            )
            told += [(body, touch.phase) for body, touch in self.grabs.update(inputs, self.world)]
            self.world.step(DT)
        return told


@pytest.fixture
def table() -> Table:
    return Table()


def test_a_held_body_is_pulled_to_the_finger_and_stays_there(table):
    crate = table.crate(0, 0)
    table.finger(1, "began", 0.3, 0.2)
    assert table.step() == [(crate, "began")]
    table.finger(1, "moved", 3, 2)
    assert table.step() == [(crate, "moved")]
    table.step(120)
    assert table.grabs.held(1) == crate
    assert (crate.position - (3, 2)).length < 0.02
    assert crate.velocity.length < 0.02


def test_a_pull_is_a_force_and_never_a_jump(table):
    crate = table.crate(0, 0)
    table.finger(1, "began", 0, 0)
    table.step()
    table.finger(1, "moved", 8, 0)
    places = [crate.position]
    for _ in range(30):
        table.step()
        places.append(crate.position)
    speeds = [(b - a).length / DT for a, b in itertools.pairwise(places)]
    gains = [abs(b - a) / DT for a, b in zip([0.0, *speeds], speeds, strict=False)]
    assert speeds[0] < 400 * DT * 1.01, "the first step moves it as far as the largest pull can"
    assert max(gains) < 401


@pytest.mark.parametrize("gravity", [(0, -9.81), (9.81, 0), (-6, 7), (0, -40)])
def test_a_held_body_is_not_pulled_by_gravity_and_falls_when_let_go(gravity):
    table = Table(gravity)
    crate = table.crate(0, 0)
    table.finger(1, "began", 0, 0)
    table.step(60)
    assert crate.position.length < 1e-3
    table.finger(1, "ended", 0, 0)
    assert table.step() == [(crate, "ended")]
    table.step(30)
    fallen = crate.position.direction
    assert fallen.dot(Vec2(*gravity).direction) > 0.999
    assert crate.position.length > 0.5


def test_turning_gravity_does_not_move_what_is_held(table):
    crate = table.crate(0, 0)
    table.finger(1, "began", 0, 0)
    table.step(10)
    for gravity in ((9.81, 0), (0, 9.81), (-9.81, 0)):
        table.world.gravity = gravity
        table.step(30)
        assert crate.position.length < 1e-3


def test_a_wall_holds_against_a_pull(table):
    table.world.add(evil.Rectangle(1, 10), at=(3, 0), kind="static")
    crate = table.crate(0, 0)
    table.finger(1, "began", 0, 0)
    table.step()
    table.finger(1, "moved", 8, 0)
    table.step(120)
    assert 1.8 < crate.position.x < 2.1


def test_a_held_body_that_has_come_to_rest_follows_when_the_finger_moves_again(table):
    crate = table.crate(0, 0)
    table.finger(1, "began", 0, 0)
    table.step(300)
    table.finger(1, "moved", 1, 0)
    table.step(120)
    assert crate.position.x == pytest.approx(1, abs=0.02)


def test_each_finger_holds_its_own_body(table):
    left, right, other = table.crate(-2, 0), table.crate(2, 0), table.crate(0, 4)
    table.finger(1, "began", -2, 0)
    table.finger(2, "began", 2, 0)
    table.finger("thumb", "began", 0, 4)
    assert table.step() == [(left, "began"), (right, "began"), (other, "began")]
    table.finger(1, "moved", -5, 1)
    table.finger(2, "moved", 5, -1)
    table.step(120)
    assert (left.position - (-5, 1)).length < 0.02
    assert (right.position - (5, -1)).length < 0.02
    assert (other.position - (0, 4)).length < 0.02


def test_a_second_finger_on_a_held_body_takes_nothing_from_the_first(table):
    crate = table.crate(0, 0)
    table.finger(1, "began", 0, 0)
    table.finger(2, "began", 0.2, 0)
    assert table.step() == [(crate, "began")]
    assert (table.grabs.held(1), table.grabs.held(2)) == (crate, None)
    table.finger(2, "ended", 0.2, 0)
    table.step()
    assert len(crate.forces) == 1


def test_of_bodies_that_lie_over_each_other_the_one_added_last_is_taken(table):
    table.crate(0, 0)
    top = table.crate(0, 0)
    table.world.add(evil.Circle(2), kind="static")
    table.finger(1, "began", 0, 0)
    assert table.step() == [(top, "began")]


def test_a_body_that_is_not_touchable_is_not_held(table):
    crate = table.crate(0, 0, touchable=False)
    table.finger(1, "began", 0, 0)
    assert table.step() == []
    assert crate.forces == ()


def test_a_finger_slides_onto_a_body_and_grabs_it(table):
    crate = table.crate(0, 0, gravity_scale=0)
    table.finger(1, "began", -3, 0)
    assert table.step(3) == []
    table.finger(1, "moved", -2, 0)
    assert table.step() == []
    table.finger(1, "moved", 0, 0)
    assert table.step() == [(crate, "began")]
    table.finger(1, "moved", 1, 0)
    assert table.step() == [(crate, "moved")]


def test_a_finger_that_swipes_across_a_body_between_two_steps_grabs_it(table):
    speck = table.world.add(evil.Circle(0.02), at=(0.5, 0), touchable=True, gravity_scale=0)
    table.finger(1, "began", -9, 0)
    table.step()
    table.finger(1, "moved", 9, 0)
    assert table.step() == [(speck, "began")]


def test_a_finger_slides_over_what_it_cannot_hold(table):
    table.world.add(evil.Rectangle(1, 5), at=(-1, 0), kind="static")
    table.world.add(evil.Rectangle(8, 8), at=(0, 0), kind="static")
    crate = table.crate(0, 0)  # its edge lies where that of the first wall ends
    table.crate(2, 0)
    table.finger(1, "began", -6, 0)
    table.step()
    table.finger(1, "moved", 6, 0)
    assert table.step() == [(crate, "began")]


def test_a_finger_slides_past_a_body_that_another_holds_to_the_next(table):
    near, far = table.crate(0, 0), table.crate(2, 0)
    table.finger(1, "began", 0, 0)
    table.finger(2, "began", -3, 0)
    table.step()
    table.finger(2, "moved", 3, 0)
    assert table.step() == [(far, "began")]
    assert table.grabs.held(1) == near


def test_a_resting_finger_grabs_nothing_that_comes_by_until_it_moves(table):
    table.finger(1, "began", 0, 0)
    table.step()
    crate = table.crate(0, 0, gravity_scale=0)
    assert table.step(5) == []
    table.finger(1, "moved", 0.02, 0)
    assert table.step() == [(crate, "began")]


def test_the_mouse_drags_as_a_finger_does(table):
    crate = table.crate(0, 0)
    table.device.pointer((480, 270))
    assert table.step() == []
    table.device.pointer(button="left", down=True)
    assert table.step() == [(crate, "began")]
    table.device.pointer((530, 270))
    table.step(120)
    assert table.grabs.held("mouse") == crate
    assert crate.position.x == pytest.approx(1, abs=0.02)
    table.device.pointer(button="left", down=False)
    assert table.step() == [(crate, "ended")]
    assert crate.forces == ()


def test_a_touch_callback_takes_the_place_of_the_pull(table):
    crate = table.crate(0, 0, touchable=False, gravity_scale=0)
    crate.on_touch(lambda touch: None)
    table.finger(1, "began", 0, 0)
    assert table.step() == [(crate, "began")]
    table.finger(1, "moved", 3, 0)
    assert table.step() == [(crate, "moved")]
    table.finger(1, "ended", 4, 0)
    assert table.step() == [(crate, "ended")]
    assert crate.position == (0, 0)


def test_any_number_of_fingers_may_be_on_a_body_that_answers_them_itself(table):
    crate = table.crate(0, 0)
    crate.on_touch(lambda touch: None)
    table.finger(1, "began", -0.2, 0)
    table.finger(2, "began", 0.2, 0)
    assert table.step() == [(crate, "began"), (crate, "began")]


def test_a_body_that_nothing_moves_is_told_and_not_pulled(table):
    button = table.crate(0, 0, kind="static")
    table.finger(1, "began", 0, 0)
    assert table.step() == [(button, "began")]
    assert button.forces == ()


def test_a_destroyed_body_lets_go_and_its_finger_can_hold_another(table):
    first, second = table.crate(0, 0), table.crate(2, 0, gravity_scale=0)
    table.finger(1, "began", 0, 0)
    table.step()
    first.destroy()
    assert table.grabs.held(1) is None
    assert table.step(3) == []
    table.finger(1, "moved", 2, 0)
    assert table.step() == [(second, "began")]
    second.destroy()
    table.finger(1, "ended", 2, 0)
    assert table.step() == []


def test_a_pull_that_somebody_destroyed_is_let_go(table):
    crate = table.crate(0, 0, gravity_scale=0)
    table.finger(1, "began", 0, 0)
    table.step()
    crate.forces[0].destroy()
    assert table.step() == []
    assert table.grabs.held(1) is None


def test_a_finger_that_vanishes_lets_go(table):
    crate = table.crate(0, 0)
    table.finger(1, "began", 0, 0)
    table.step()
    told = table.grabs.update(Inputs(), table.world)
    assert [(body, touch.phase, touch.cancelled) for body, touch in told] == [(crate, "ended", True)]
    assert crate.forces == ()
    assert table.grabs.update(Inputs(), table.world) == ()


def test_losing_the_focus_lets_go_of_everything(table):
    crate, other = table.crate(0, 0), table.crate(2, 0)
    table.finger(1, "began", 0, 0)
    table.finger(2, "began", 2, 0)
    table.step()
    table.device.focus(False)
    assert table.step() == [(crate, "ended"), (other, "ended")]
    assert crate.forces == other.forces == ()


def test_a_tap_within_one_step_is_told_in_full_and_leaves_no_pull(table):
    crate = table.crate(0, 0)
    table.finger(1, "began", 0, 0)
    table.finger(1, "ended", 0, 0)
    assert table.step() == [(crate, "began"), (crate, "ended")]
    assert crate.forces == ()


def test_another_world_has_nothing_held(table):
    crate = table.crate(0, 0)
    table.finger(1, "began", 0, 0)
    table.step()
    old, table.world = table.world, evil.World()
    assert table.step(2) == []
    assert crate.forces == old.forces == ()


def test_a_restored_world_goes_on_with_the_fingers_as_they_are(table):
    crate = table.crate(0, 0)
    before = table.world.snapshot()
    table.finger(1, "began", 0, 0)
    table.step()
    during = table.world.snapshot()
    table.finger(1, "moved", 2, 0)
    table.step(60)
    table.world.restore(during)
    table.step(120)
    assert crate.position.x == pytest.approx(2, abs=0.02), "the finger is at 2 still"
    table.world.restore(before)
    assert table.step(30) == []
    assert crate.position.y < -0.5, "in the world of before, nobody held it"


def test_letting_go_before_a_save_leaves_no_pull_in_it(table):
    crate = table.crate(0, 0)
    table.finger(1, "began", 0, 0)
    table.step()
    table.grabs.let_go()
    assert crate.forces == table.world.forces == ()
    assert table.grabs.held(1) is None


def test_a_touch_without_a_world_point_in_it_finds_nothing(table):
    far = Vec2(1e6, -1e6)
    touch = Touch(1, "moved", far, Vec2(0, 0), pixel=far, previous_pixel=far)
    assert table.grabs.update(Inputs(touches=(touch,), touch_events=(touch,)), table.world) == ()
