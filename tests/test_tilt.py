"""Tilt: a reading turns gravity and never its strength; keys, wheel and stick stand in for a sensor (SPEC I4)."""

from __future__ import annotations

import math

import pytest

from evilengine.interaction import Interaction
from evilengine.interaction.tilt import TURN_RATE, turned, turned_toward
from evilengine.platform import HeadlessDevice
from evilengine.values.inputs import Tilt
from evilengine.values.vec2 import Vec2


class Held:
    """A device held by a player, one step at a time."""

    def __init__(self):
        self.device = HeadlessDevice()
        self.interaction = Interaction()

    def step(self, steps: int = 1, dt: float = 1 / 60) -> Tilt:
        for _ in range(steps):
            self.interaction.collect(self.device.poll())
            tilt = self.interaction.snapshot(lambda pixel, began=None: pixel, dt).tilt
        return tilt

    def shakes(self, steps: int = 1) -> int:
        return sum(self.step().shaken for _ in range(steps))


@pytest.fixture
def held() -> Held:
    return Held()


def test_a_device_that_was_never_tilted_stands_upright(held):
    tilt = held.step()
    assert (tilt.direction, tilt.reading, tilt.changed, tilt.shaken) == ((0, -1), None, False, False)


@pytest.mark.parametrize("reading", [(0.5, -0.87, 0), (3, 4, 0), (-0.06, 0.02, -0.99), (0.7, 0, 0.7)])
def test_the_direction_has_length_one_however_hard_gravity_pulls(held, reading):
    held.device.tilt(*reading)
    tilt = held.step()
    along_screen = math.hypot(*reading[:2])
    assert tilt.direction.length == pytest.approx(1, abs=1e-12)
    assert tilt.direction == pytest.approx((reading[0] / along_screen, reading[1] / along_screen))
    assert tilt.reading == reading
    assert tilt.changed


def test_lying_flat_keeps_the_last_direction_and_the_reading_is_raw(held):
    held.device.tilt(1, 0)
    held.step()
    for x, y in ((0, 0), (0.01, -0.02), (-0.04, 0.01)):
        held.device.tilt(x, y, -1)
        tilt = held.step()
        assert tilt.direction == (1, 0)
        assert tilt.reading == (x, y, -1)


def test_a_change_is_told_once(held):
    held.device.tilt(1, 0)
    assert [held.step().changed, held.step().changed] == [True, False]
    held.device.tilt(1, 0)
    assert not held.step().changed


@pytest.mark.parametrize(("key", "sign"), [("right", 1), ("d", 1), ("left", -1), ("a", -1)])
def test_a_key_held_turns_gravity_smoothly_and_rests_where_it_was_let_go(held, key, sign):
    held.device.key(key)
    steps = [held.step().direction for _ in range(60)]
    angles = [previous.cross(direction) for previous, direction in zip([Vec2(0, -1), *steps], steps, strict=False)]
    assert 0 < sign * angles[0] < TURN_RATE / 60 / 2, "it starts gently"
    assert max(abs(angle) for angle in angles) <= TURN_RATE / 60 * 1.001
    assert sum(angles) == pytest.approx(sign * TURN_RATE, rel=0.1)
    held.device.key(key, down=False)
    rest = held.step(20)
    assert held.step(20).direction == rest.direction
    assert not held.step().changed


def test_both_keys_at_once_turn_nothing(held):
    held.device.key("left")
    held.device.key("right")
    assert held.step(30).direction == (0, -1)


def test_right_pulls_things_to_the_right(held):
    held.device.key("right")
    assert held.step(20).direction.x > 0.3


def test_a_notch_of_the_wheel_turns_a_twelfth_of_half_a_turn_smoothly(held):
    held.device.wheel(1)
    first = held.step().direction
    assert 0 < first.x < math.sin(math.pi / 12) / 2
    assert held.step(60).direction == pytest.approx((math.sin(math.pi / 12), -math.cos(math.pi / 12)), abs=1e-4)
    held.device.wheel(-1)
    assert held.step(60).direction == pytest.approx((0, -1), abs=1e-4)
    assert not held.step().changed


def test_a_stick_points_gravity_where_it_is_pushed_and_leaves_it_there(held):
    held.device.pad("left_x", -0.6)
    held.device.pad("left_y", 0.6)
    first = held.step().direction
    assert first != pytest.approx((-math.sqrt(0.5), math.sqrt(0.5)), abs=0.1), "it swings, it does not jump"
    assert held.step(60).direction == pytest.approx((-math.sqrt(0.5), math.sqrt(0.5)))
    held.device.pad("left_x", 0)
    held.device.pad("left_y", 0.1)
    assert held.step(60).direction == pytest.approx((-math.sqrt(0.5), math.sqrt(0.5)))


def test_a_stick_pushed_straight_against_gravity_turns_it_over(held):
    held.device.pad("left_y", 1)
    assert held.step(60).direction == pytest.approx((0, 1))


def test_the_sensor_takes_over_from_the_keys(held):
    held.device.key("right")
    held.step(10)
    held.device.key("right", down=False)
    held.device.tilt(-1, 0)
    assert held.step().direction == (-1, 0)
    assert held.step(30).direction == (-1, 0)


def test_a_game_that_needs_the_keys_itself_turns_the_stand_ins_off(held):
    held.interaction.stand_ins = False
    held.device.key("right")
    held.device.wheel(5)
    held.device.pad("left_y", 1)
    assert held.step(30).direction == (0, -1)
    held.device.tilt(1, 0)
    assert held.step().direction == (1, 0)


def test_a_step_of_no_length_turns_nothing(held):
    held.device.key("right")
    assert held.step(30, dt=0.0).direction == (0, -1)


def test_shaking_there_and_back_is_one_event(held):
    shakes = 0
    for swing in range(5):
        held.device.tilt(2.5 if swing % 2 else -2.5, -1, 0)
        shakes += held.shakes(3)
    assert shakes == 1


def test_a_fast_shake_within_a_frame_is_noticed(held):
    for swing in range(4):
        held.device.tilt(0, 3 if swing % 2 else -3)
    assert held.shakes() == 1


def test_a_shake_along_gravity_is_noticed_by_the_calm_between_its_jolts(held):
    shakes = 0
    for _ in range(3):
        held.device.tilt(0, -3)
        shakes += held.shakes(4)
        held.device.tilt(0, 0.5)
        shakes += held.shakes(4)
    assert shakes == 1


def test_turning_the_device_over_and_over_is_no_shake(held):
    for turn in range(40):
        held.device.tilt(0, 1 if turn % 2 else -1)
        assert held.shakes() == 0


def test_a_knock_on_the_table_is_no_shake(held):
    for reading in ((0, 0, -3), (0, 0, 2.5), (0, 0, -1)):
        held.device.tilt(*reading)
        assert held.shakes() == 0


def test_slow_jolts_are_no_shake(held):
    for swing in range(6):
        held.device.tilt(2.5 if swing % 2 else -2.5, 0)
        assert held.shakes(30) == 0


def test_a_second_shake_is_a_second_event(held):
    def shake() -> int:
        count = 0
        for swing in range(4):
            held.device.tilt(3 if swing % 2 else -3, 0)
            count += held.shakes()
        held.device.tilt(0, -1)
        return count

    assert shake() == 1
    held.step(60)
    assert shake() == 1


@pytest.mark.parametrize("angle", [0.001, 0.04, -0.15, 0.5])
def test_turning_without_trigonometry_is_a_turn(angle):
    direction = turned(Vec2(0.6, -0.8), angle)
    assert direction.length == pytest.approx(1, abs=1e-15)
    assert direction == pytest.approx(Vec2(0.6, -0.8).turned(angle), abs=1e-3)


def test_turning_toward_goes_the_short_way_and_stops_there():
    assert turned_toward(Vec2(1, 0), Vec2(0, -5), 0.1).y < 0
    assert turned_toward(Vec2(1, 0), Vec2(5, 0.1), 0.1) == pytest.approx(Vec2(5, 0.1).direction)


def test_the_same_play_gives_the_same_bits_whatever_frames_it_came_in():
    def play(frames: list[int]) -> list[Vec2]:
        device, interaction, seen = HeadlessDevice(), Interaction(), []
        device.key("right")
        device.wheel(3)
        for steps in frames:
            interaction.collect(device.poll())
            seen += [interaction.snapshot(lambda pixel, began=None: pixel).tilt.direction for _ in range(steps)]
        return seen

    assert play([1] * 12) == play([0, 3, 0, 5, 4])
