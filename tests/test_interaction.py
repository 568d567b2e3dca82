"""Interaction: what the device reported becomes what each step sees, once and in order."""

from __future__ import annotations

import pytest

from evilengine.interaction import Interaction, axis
from evilengine.platform import HeadlessDevice
from evilengine.values.errors import ArgumentError, ArgumentTypeError
from evilengine.values.events import PadAxisEvent, PadButtonEvent, TouchEvent
from evilengine.values.inputs import Inputs, Keys
from evilengine.values.vec2 import Vec2


class Player:
    """A headless device, what it reports gathered, and a camera of 50 pixels a metre on a screen of 960x540."""

    def __init__(self):
        self.device = HeadlessDevice((960, 540))
        self.interaction = Interaction()
        self.camera = Vec2(0, 0)

    def to_world(self, pixel: Vec2, began: Vec2 | None = None) -> Vec2:
        return self.camera + Vec2((pixel.x - 480) / 50, -(pixel.y - 270) / 50)

    def frame(self, steps: int = 1) -> list[Inputs]:
        self.interaction.collect(self.device.poll())
        return [self.interaction.snapshot(self.to_world) for _ in range(steps)]

    def step(self) -> Inputs:
        return self.frame()[0]


@pytest.fixture
def player() -> Player:
    return Player()


def phases(touches):
    return [(touch.finger, touch.phase) for touch in touches]


def test_a_press_is_told_once_and_the_key_stays_held(player):
    player.device.key("left")
    first, second = player.frame(steps=2)
    assert (first.pressed, first.keys["left"]) == (("left",), True)
    assert (second.pressed, second.keys["left"]) == ((), True)
    player.device.key("left", down=False)
    third = player.step()
    assert (third.released, third.keys["left"]) == (("left",), False)


def test_a_frame_without_a_step_keeps_what_changed_for_the_next_step(player):
    player.device.tap("space")
    player.device.wheel(1)
    player.device.text("é")
    player.device.pointer((500, 270), button="right", down=True)
    assert player.frame(steps=0) == []
    player.device.wheel(2)
    first, second = player.frame(steps=2)
    assert (first.pressed, first.released, first.wheel.y, first.text) == (("space",), ("space",), 3.0, "é")
    assert first.pointer.pressed == ("right",)
    assert (second.pressed, second.released, second.wheel.y, second.text) == ((), (), 0.0, "")
    assert (second.pointer.pressed, second.pointer.buttons) == ((), ("right",))


def test_held_keys_are_in_the_order_they_went_down(player):
    for key in ("z", "a", "m"):
        player.device.key(key)
    assert list(player.step().keys) == ["z", "a", "m"]


def test_a_misspelt_key_is_an_error_with_a_suggestion():
    keys = Keys(("left",))
    with pytest.raises(ArgumentError, match="did you mean 'right'"):
        keys["rihgt"]
    with pytest.raises(ArgumentError, match="did you mean 'right'"):
        "rihgt" in keys  # noqa: B015


def test_a_pixel_becomes_a_point_of_the_world(player):
    player.device.touch(1, "began", at=(480, 270))
    player.device.touch(2, "began", at=(530, 220))
    assert [touch.at for touch in player.step().touches] == [(0, 0), (1, 1)]


def test_a_finger_begins_moves_rests_and_ends(player):
    player.device.touch(7, "began", at=(480, 270))
    began = player.step()
    player.device.touch(7, "moved", at=(530, 270))
    moved, rests = player.frame(steps=2)
    player.device.touch(7, "ended", at=(580, 270))
    ended, gone = player.frame(steps=2)
    assert [phases(inputs.touches) for inputs in (began, moved, rests, ended, gone)] == [
        [(7, "began")],
        [(7, "moved")],
        [(7, "moved")],
        [(7, "ended")],
        [],
    ]
    assert [phases(inputs.touch_events) for inputs in (began, moved, rests, ended, gone)] == [
        [(7, "began")],
        [(7, "moved")],
        [],
        [(7, "ended")],
        [],
    ]
    assert [(inputs.touches[0].previous.x, inputs.touches[0].at.x) for inputs in (began, moved, rests, ended)] == [
        (0, 0),
        (0, 1),
        (1, 1),
        (1, 2),
    ]
    assert (moved.touches[0].previous_pixel, moved.touches[0].pixel) == ((480, 270), (530, 270))


def test_moves_within_a_step_are_one_move_and_edges_are_all_told(player):
    player.device.touch(1, "began", at=(0, 0))
    player.device.touch(2, "began", at=(0, 0))
    for x in (10, 20, 30):
        player.device.touch(1, "moved", at=(x, 0))
        player.device.touch(2, "moved", at=(0, x))
    player.device.touch(1, "ended")
    inputs = player.step()
    assert phases(inputs.touch_events) == [(1, "began"), (2, "began"), (1, "moved"), (2, "moved"), (1, "ended")]
    move = inputs.touch_events[2]
    assert (move.previous_pixel, move.pixel) == ((0, 0), (30, 0))
    assert phases(inputs.touches) == [(1, "ended"), (2, "began")]


def test_a_finger_that_ends_and_begins_again_in_one_step_is_told_in_full_and_polled_once(player):
    player.device.touch(1, "began", at=(0, 0))
    player.step()
    player.device.touch(1, "ended")
    player.device.touch(1, "began", at=(50, 0))
    inputs = player.step()
    assert phases(inputs.touch_events) == [(1, "ended"), (1, "began")]
    assert phases(inputs.touches) == [(1, "began")]
    assert inputs.touches[0].previous == inputs.touches[0].at


def test_any_number_of_fingers_keep_the_order_in_which_they_came_down(player):
    for finger in (9, 3, 5, 1, 12, 0, 77, 8, 2, 4, 6):
        player.device.touch(finger, "began", at=(finger, 0))
    assert [touch.finger for touch in player.step().touches] == [9, 3, 5, 1, 12, 0, 77, 8, 2, 4, 6]


def test_a_resting_finger_stays_at_its_pixel_when_the_camera_moves(player):
    player.device.touch(1, "began", at=(480, 270))
    player.step()
    player.camera = Vec2(3, 0)
    inputs = player.step()
    assert (inputs.touches[0].previous, inputs.touches[0].at) == ((0, 0), (3, 0))
    assert inputs.touch_events == ()


def test_the_mouse_with_its_left_button_down_is_a_finger(player):
    player.device.pointer((480, 270))
    assert player.step().touches == ()
    player.device.pointer(button="left", down=True)
    player.device.pointer((530, 270))
    inputs = player.step()
    assert phases(inputs.touch_events) == [("mouse", "began"), ("mouse", "moved")]
    player.device.pointer(button="left", down=False)
    assert phases(player.step().touches) == [("mouse", "ended")]


def test_the_pointer_knows_where_it_was(player):
    player.device.pointer((480, 270))
    first = player.step().pointer
    assert (first.previous, first.at) == ((0, 0), (0, 0))
    player.device.pointer((500, 270))
    player.device.pointer((530, 270))
    second, third = (inputs.pointer for inputs in player.frame(steps=2))
    assert (second.previous, second.at, second.previous_pixel) == ((0, 0), (1, 0), (480, 270))
    assert (third.previous, third.at) == ((1, 0), (1, 0))


def test_losing_focus_lets_go_of_everything(player):
    player.device.key("a")
    player.device.touch(1, "began", at=(0, 0))
    player.device.pointer((5, 5), button="left", down=True)
    player.device.pad("b", down=True)
    player.device.pad("left_x", 1)
    assert list(player.step().keys) == ["a", "pad_b", "stick_right"]
    player.device.focus(False)
    inputs = player.step()
    assert inputs.released == ("a", "pad_b", "stick_right")
    assert phases(inputs.touch_events) == [(1, "ended"), ("mouse", "ended")]
    assert all(touch.cancelled for touch in inputs.touch_events + inputs.touches)
    assert (inputs.pointer.released, inputs.pointer.buttons) == (("left",), ())
    assert (list(inputs.keys), inputs.pads[0].left, inputs.pads[0].buttons) == ([], (0, 0), ())
    assert player.step().touches == ()


def test_a_finger_that_the_phone_takes_away_is_marked(player):
    player.device.touch(1, "began", at=(0, 0))
    player.step()
    player.device.touch(1, "ended", cancelled=True)
    inputs = player.step()
    assert (inputs.touches[0].phase, inputs.touches[0].cancelled) == ("ended", True)


def test_events_of_fingers_and_pads_that_are_not_there_are_passed_over(player):
    player.interaction.collect(
        [
            TouchEvent(4, "moved", Vec2(1, 1)),
            TouchEvent(4, "ended", Vec2(1, 1)),
            PadAxisEvent(3, "left_x", 1.0),
            PadButtonEvent(3, "a", True),
        ]
    )
    inputs = player.step()
    assert (inputs.touches, inputs.touch_events, inputs.pads, len(inputs.keys)) == ((), (), (), 0)


def test_a_pad_has_sticks_triggers_and_buttons_and_its_buttons_are_keys(player):
    player.device.plug(pad=1, name="Second")
    player.device.pad("a", down=True, pad=0)
    player.device.pad("a", down=True, pad=1)
    player.device.pad("right_y", -0.25, pad=1)
    player.device.pad("left_trigger", 0.75, pad=1)
    inputs = player.step()
    assert inputs.pressed == ("pad_a",)
    assert [(pad.number, pad.name, pad.buttons) for pad in inputs.pads] == [(0, "pad", ("a",)), (1, "Second", ("a",))]
    assert (inputs.pads[1].right, inputs.pads[1].left_trigger) == ((0, -0.25), 0.75)
    player.device.pad("a", down=False, pad=0)
    assert player.step().keys["pad_a"]
    player.device.unplug(pad=1)
    inputs = player.step()
    assert (inputs.released, [pad.number for pad in inputs.pads]) == (("pad_a",), [0])


def test_a_stick_is_a_key_that_does_not_flicker(player):
    pressed, released = 0, 0
    for push in (0.4, 0.55, 0.45, 0.52, 0.44, 0.2):
        player.device.pad("left_y", push)
        inputs = player.step()
        pressed += inputs.pressed.count("stick_up")
        released += inputs.released.count("stick_up")
    assert (pressed, released) == (1, 1)


def test_axis_is_minus_one_to_one(player):
    left_right = ("left", "a", "stick_left"), ("right", "d", "stick_right")
    assert axis(player.step(), *left_right) == 0
    player.device.key("d")
    assert axis(player.step(), *left_right) == 1
    player.device.key("left")
    assert axis(player.step(), *left_right) == 0
    player.device.key("d", down=False)
    assert axis(player.step(), "left", "right") == -1


def test_axis_follows_a_stick_partly_and_rests_in_its_dead_zone(player):
    player.device.pad("left_x", 0.15)
    assert axis(player.step(), "stick_left", "stick_right") == 0
    player.device.pad("left_x", 0.6)
    assert axis(player.step(), "stick_left", "stick_right") == pytest.approx(0.5)
    player.device.pad("left_x", -1)
    assert axis(player.step(), "stick_left", "stick_right") == -1


def test_axis_names_a_key_that_does_not_exist():
    with pytest.raises(ArgumentError, match=r"axis\(\): negative='lefft' is no key's name; did you mean 'left'"):
        axis(Inputs(), "lefft", "right")
    with pytest.raises(ArgumentTypeError, match="positive=5"):
        axis(Inputs(), "left", 5)


def test_the_gyroscope_is_there_for_who_wants_it(player):
    player.device.sensor("gyroscope", 0, 0, 1)
    player.device.sensor("gyroscope", 0, 0, 2)
    first, second = player.frame(steps=2)
    assert [reading.values for reading in first.sensors] == [(0, 0, 2)]
    assert second.sensors == first.sensors


def test_inputs_are_frozen_and_equal_by_value(player):
    player.device.key("left")
    player.device.touch(1, "began", at=(480, 270))
    inputs = player.step()
    other = Player()
    other.device.key("left")
    other.device.touch(1, "began", at=(480, 270))
    assert other.step() == inputs
    with pytest.raises(AttributeError):
        inputs.pressed = ()
