"""What SDL tells of the player, in our words; on SDL's dummy driver, which needs no screen."""

from __future__ import annotations

import ctypes

import pytest
from sdl_queue import push, push_finger, push_key, window_id

from evilengine.platform import DesktopDevice, sdl_events, sdl_keys
from evilengine.platform import sdl as library
from evilengine.values import events
from evilengine.values.events import (
    FocusEvent,
    KeyEvent,
    PadAxisEvent,
    PadButtonEvent,
    PadEvent,
    PointerEvent,
    SensorEvent,
    TextEvent,
    TiltEvent,
    TouchEvent,
    WheelEvent,
)
from evilengine.values.vec2 import Vec2


@pytest.fixture
def unseen(monkeypatch):
    """A window on SDL's dummy driver, with what opening it reports polled away."""
    monkeypatch.setenv("SDL_VIDEODRIVER", "dummy")
    device = DesktopDevice("Unseen", (320, 240))
    device.poll()
    yield device
    device.close()


def test_a_key_is_told_once_however_long_it_repeats(unseen):
    sdl = library.load()
    push_key(unseen, sdl.SDLK_a, 4, True)
    push_key(unseen, sdl.SDLK_a, 4, True, repeat=1)
    push_key(unseen, sdl.SDLK_a, 4, True)
    push_key(unseen, sdl.SDLK_a, 4, False)
    push_key(unseen, sdl.SDLK_a, 4, False)
    assert unseen.poll() == (KeyEvent("a", True), KeyEvent("a", False))


def test_a_key_is_called_what_is_printed_on_it(unseen):
    sdl = library.load()
    for code, place in (
        (sdl.SDLK_SPACE, 44),
        (sdl.SDLK_F1, 58),
        (sdl.SDLK_ESCAPE, 41),
        (sdl.SDLK_LSHIFT, 225),
        (sdl.SDLK_KP_4, 92),
        (ord("a"), 20),  # where an American keyboard has its q
        (0x444, 4),  # a Cyrillic letter: the place tells the name
        (sdl.SDLK_ESCAPE, 57),  # caps lock made into escape
        (0x40000FFF, 501),  # no key that we know
    ):
        push_key(unseen, code, place, True)
    names = [event.key for event in unseen.poll()]
    assert names == ["space", "f1", "escape", "left_shift", "keypad_4", "a", "a", "escape"]


def test_every_key_name_is_on_some_keyboard():
    assert set(sdl_keys.BY_PLACE.values()) == set(events.KEYBOARD_KEYS)
    assert set(sdl_keys.BY_CHARACTER.values()) <= set(events.KEYBOARD_KEYS)
    assert tuple(sdl_keys.MOUSE_BUTTONS.values()) == events.POINTER_BUTTONS


def test_sdl_calls_the_same_keys_the_same():
    sdl = library.load()
    for place, name in (
        (sdl.SDL_SCANCODE_A, "a"),
        (sdl.SDL_SCANCODE_0, "0"),
        (sdl.SDL_SCANCODE_SLASH, "slash"),
        (sdl.SDL_SCANCODE_F12, "f12"),
        (sdl.SDL_SCANCODE_UP, "up"),
        (sdl.SDL_SCANCODE_KP_0, "keypad_0"),
        (sdl.SDL_SCANCODE_APPLICATION, "menu"),
        (sdl.SDL_SCANCODE_F24, "f24"),
        (sdl.SDL_SCANCODE_RGUI, "right_meta"),
        (sdl.SDL_SCANCODE_AC_BACK, "back"),
    ):
        assert sdl_keys.BY_PLACE[place] == name
    assert sdl_keys.CONTROLLER_BUTTONS[sdl.SDL_CONTROLLER_BUTTON_DPAD_RIGHT] == "right"
    assert sdl_keys.CONTROLLER_BUTTONS[sdl.SDL_CONTROLLER_BUTTON_LEFTSHOULDER] == "left_shoulder"
    assert sdl_keys.CONTROLLER_AXES[sdl.SDL_CONTROLLER_AXIS_TRIGGERRIGHT] == "right_trigger"
    assert sdl_keys.MOUSE_BUTTONS[sdl.SDL_BUTTON_RIGHT] == "right"


def test_typed_text_comes_as_the_layout_makes_it(unseen):
    push(part="text", type=library.load().SDL_TEXTINPUT, windowID=window_id(unseen), text="å€".encode())
    assert unseen.poll() == (TextEvent("å€"),)


def test_the_mouse_moves_clicks_and_turns_its_wheel(unseen):
    sdl = library.load()
    mine = window_id(unseen)
    push(part="motion", type=sdl.SDL_MOUSEMOTION, windowID=mine, x=10, y=20)
    push(part="button", type=sdl.SDL_MOUSEBUTTONDOWN, windowID=mine, x=10, y=20, button=3, state=1)
    push(part="button", type=sdl.SDL_MOUSEBUTTONUP, windowID=mine, x=11, y=20, button=3, state=0)
    push(part="wheel", type=sdl.SDL_MOUSEWHEEL, windowID=mine, x=0, y=1, preciseY=1.5)
    push(part="wheel", type=sdl.SDL_MOUSEWHEEL, windowID=mine, x=-1, y=0, direction=sdl.SDL_MOUSEWHEEL_FLIPPED)
    assert unseen.poll() == (
        PointerEvent(Vec2(10, 20)),
        PointerEvent(Vec2(10, 20), "right", True),
        PointerEvent(Vec2(11, 20), "right", False),
        WheelEvent(Vec2(0, 1.5)),
        WheelEvent(Vec2(1, 0)),
    )


def test_a_finger_is_not_also_a_mouse_nor_the_mouse_a_finger(unseen):
    sdl = library.load()
    mine = window_id(unseen)
    made_up = sdl_events.MADE_FROM_TOUCH
    push(part="motion", type=sdl.SDL_MOUSEMOTION, windowID=mine, which=made_up, x=10, y=20)
    push(part="button", type=sdl.SDL_MOUSEBUTTONDOWN, windowID=mine, which=made_up, x=1, y=2, button=1, state=1)
    push(part="wheel", type=sdl.SDL_MOUSEWHEEL, windowID=mine, which=made_up, y=1)
    push_finger(unseen, "DOWN", 1, 0.5, 0.5, touch=sdl_events.MADE_FROM_MOUSE)
    assert unseen.poll() == ()
    assert sdl.SDL_GetHint(b"SDL_TOUCH_MOUSE_EVENTS") == sdl.SDL_GetHint(b"SDL_MOUSE_TOUCH_EVENTS") == b"0"


def test_any_number_of_fingers_get_small_numbers_that_are_used_again(unseen):
    for finger in range(20):
        push_finger(unseen, "DOWN", 10**12 + finger, finger / 20, 0)
    assert [event.finger for event in unseen.poll()] == list(range(20))
    push_finger(unseen, "UP", 10**12 + 4, 0, 0)
    push_finger(unseen, "DOWN", 999, 0, 1)
    push_finger(unseen, "DOWN", 999, 0, 1, touch=6)
    assert unseen.poll() == (
        TouchEvent(4, "ended", Vec2(0, 0)),
        TouchEvent(4, "began", Vec2(0, 240)),
        TouchEvent(20, "began", Vec2(0, 240)),
    )


def test_a_finger_that_came_down_elsewhere_is_passed_over(unseen):
    push_finger(unseen, "MOTION", 3, 0.5, 0.5)
    push_finger(unseen, "UP", 3, 0.5, 0.5)
    assert unseen.poll() == ()


def test_a_place_that_is_no_number_does_no_harm(unseen):
    push_finger(unseen, "DOWN", 1, float("nan"), float("inf"))
    (touch,) = unseen.poll()
    assert 0 <= touch.at.x <= 320
    assert 0 <= touch.at.y <= 240


def test_losing_the_focus_is_told_and_forgets_what_was_held(unseen):
    sdl = library.load()
    push_key(unseen, sdl.SDLK_a, 4, True)
    push_finger(unseen, "DOWN", 1, 0, 0)
    push(part="window", type=sdl.SDL_WINDOWEVENT, windowID=window_id(unseen), event=sdl.SDL_WINDOWEVENT_FOCUS_LOST)
    push_key(unseen, sdl.SDLK_a, 4, False)
    push_finger(unseen, "UP", 1, 0, 0)
    push(part="window", type=sdl.SDL_WINDOWEVENT, windowID=window_id(unseen), event=sdl.SDL_WINDOWEVENT_FOCUS_GAINED)
    assert unseen.poll()[2:] == (FocusEvent(False), FocusEvent(True))


def test_events_of_another_window_are_passed_over(unseen):
    sdl = library.load()
    other = window_id(unseen) + 7
    push(part="motion", type=sdl.SDL_MOUSEMOTION, windowID=other, x=10, y=20)
    push(part="tfinger", type=sdl.SDL_FINGERDOWN, windowID=other, touchId=5, fingerId=1)
    push(part="window", type=sdl.SDL_WINDOWEVENT, windowID=other, event=sdl.SDL_WINDOWEVENT_FOCUS_LOST)
    assert unseen.poll() == ()


def test_a_game_controller_is_plugged_in_used_and_taken_away(unseen):
    sdl = library.load()
    sdl.SDL_SetHint(b"SDL_JOYSTICK_ALLOW_BACKGROUND_EVENTS", b"1")
    index = sdl.SDL_JoystickAttachVirtual(sdl.SDL_JOYSTICK_TYPE_GAMECONTROLLER, 6, 15, 0)
    assert index >= 0
    try:
        (added,) = unseen.poll()
        assert (added.pad, added.connected, type(added)) == (0, True, PadEvent)
        joystick = sdl.SDL_GameControllerGetJoystick(next(iter(unseen._translator._pads.values()))[1])
        sdl.SDL_JoystickSetVirtualAxis(joystick, 0, 32767)
        sdl.SDL_JoystickSetVirtualAxis(joystick, 1, -32768)
        sdl.SDL_JoystickSetVirtualButton(joystick, 0, 1)
        moved = unseen.poll()
        assert PadAxisEvent(0, "left_x", 1.0) in moved
        assert PadAxisEvent(0, "left_y", 1.0) in moved, "pushed away from the player is up"
        assert PadButtonEvent(0, "a", True) in moved
    finally:
        sdl.SDL_JoystickDetachVirtual(index)
    assert PadEvent(0, False) in unseen.poll()


class FakeSensor:
    """Puts a sensor where SDL would have opened one; this machine has none."""

    def __init__(self, device: DesktopDevice, name: str) -> None:
        self.device = device
        device._translator._sensors[7] = name, None

    def read(self, x: float, y: float, z: float) -> tuple:
        push(part="sensor", type=library.load().SDL_SENSORUPDATE, which=7, data=(ctypes.c_float * 6)(x, y, z))
        return self.device.poll()


@pytest.fixture
def no_sensor_to_close(unseen):
    yield
    unseen._translator._sensors.clear()


@pytest.mark.usefixtures("no_sensor_to_close")
def test_the_accelerometer_tells_where_gravity_pulls_in_g(unseen):
    sensor = FakeSensor(unseen, "accelerometer")
    (upright,) = sensor.read(0.0, 9.80665, 0.0)  # at rest, SDL tells the push upwards
    assert isinstance(upright, TiltEvent)
    assert upright.reading == pytest.approx((0, -1, 0))
    (right_edge_down,) = sensor.read(-9.80665, 0.0, 0.0)
    assert right_edge_down.reading == pytest.approx((1, 0, 0))


@pytest.mark.usefixtures("no_sensor_to_close")
def test_a_device_that_stands_still_tells_nothing_new(unseen):
    sensor = FakeSensor(unseen, "accelerometer")
    assert len(sensor.read(0.0, 9.8, 0.0)) == 1
    assert sensor.read(0.05, 9.75, 0.1) == ()
    assert len(sensor.read(0.5, 9.7, 0.0)) == 1


@pytest.mark.usefixtures("no_sensor_to_close")
def test_the_gyroscope_reads_radians_a_second(unseen):
    assert FakeSensor(unseen, "gyroscope").read(0.0, 0.0, 0.5) == (SensorEvent("gyroscope", (0.0, 0.0, 0.5)),)
