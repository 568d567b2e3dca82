"""The device that tests drive: it reports what it is told, in order, and refuses what no real device could do."""

from __future__ import annotations

import math

import pytest

from evilengine.platform import HeadlessDevice
from evilengine.values.errors import ArgumentError, ArgumentTypeError, DeviceError
from evilengine.values.events import (
    CloseEvent,
    FocusEvent,
    KeyEvent,
    PadAxisEvent,
    PadButtonEvent,
    PadEvent,
    PointerEvent,
    ResizeEvent,
    SensorEvent,
    TextEvent,
    TiltEvent,
    TouchEvent,
    WheelEvent,
)
from evilengine.values.vec2 import Vec2


@pytest.fixture
def device() -> HeadlessDevice:
    return HeadlessDevice((960, 540))


def test_events_come_out_in_the_order_they_happened_and_once(device):
    device.key("left", down=True)
    device.touch(1, "began", at=(480, 270))
    device.touch(1, "moved", (500, 270))
    device.tilt(0.5, -0.87)
    device.wheel(2, x=-1)
    device.text("å")
    device.key("left", down=False)
    device.touch(1, "ended")
    assert device.poll() == (
        KeyEvent("left", True),
        TouchEvent(1, "began", Vec2(480, 270)),
        TouchEvent(1, "moved", Vec2(500, 270)),
        TiltEvent((0.5, -0.87, 0.0)),
        WheelEvent(Vec2(-1, 2)),
        TextEvent("å"),
        KeyEvent("left", False),
        TouchEvent(1, "ended", Vec2(500, 270)),
    )
    assert device.poll() == ()


def test_a_key_that_is_down_already_repeats_nothing(device):
    device.key("a")
    device.key("a")
    device.key("b", down=False)
    assert device.poll() == (KeyEvent("a", True),)


def test_a_tap_is_down_and_up(device):
    device.tap("space")
    assert device.poll() == (KeyEvent("space", True), KeyEvent("space", False))


def test_the_mouse_moves_before_its_button_goes_down(device):
    device.pointer((10, 20), button="left", down=True)
    device.pointer((30, 20))
    device.pointer(button="left", down=False)
    assert device.poll() == (
        PointerEvent(Vec2(10, 20)),
        PointerEvent(Vec2(10, 20), "left", True),
        PointerEvent(Vec2(30, 20)),
        PointerEvent(Vec2(30, 20), "left", False),
    )


def test_a_pad_connects_when_it_is_first_used(device):
    device.pad("left_x", -0.5)
    device.pad("a", down=True)
    device.pad("a", down=True)
    device.unplug()
    assert device.poll() == (
        PadEvent(0, True),
        PadAxisEvent(0, "left_x", -0.5),
        PadButtonEvent(0, "a", True),
        PadEvent(0, False),
    )


def test_resize_tells_points_and_pixels(device):
    device.resize((640, 360), scale=2)
    device.resize((640, 360))
    assert device.poll() == (ResizeEvent((640, 360), (1280, 720)),)
    assert (device.size, device.pixel_size, device.scale) == ((640, 360), (1280, 720), 2.0)


def test_losing_focus_lets_go_of_fingers_and_keys(device):
    device.touch(1, "began", at=(0, 0))
    device.key("a")
    device.poll()
    device.focus(False)
    device.key("a", down=False)
    assert device.poll() == (FocusEvent(False),)
    with pytest.raises(ArgumentError, match="finger 1 is not down"):
        device.touch(1, "moved", at=(1, 1))


def test_a_closed_device_says_so_and_takes_nothing_more(device):
    device.close()
    device.close()
    assert not device.is_open
    assert device.poll() == (CloseEvent(),)
    with pytest.raises(DeviceError, match=r"Device\.key\(\): this device was closed"):
        device.key("a")


def test_a_sensor_reads(device):
    device.sensor("gyroscope", 0, 0.5, 1)
    assert device.poll() == (SensorEvent("gyroscope", (0.0, 0.5, 1.0)),)


def test_the_last_picture_shown_is_kept(device):
    pixels = bytearray(range(16))
    device.show(memoryview(pixels).cast("B", (2, 2, 4)), (2, 2))
    pixels[0] = 99
    assert device.shown.size == (2, 2)
    assert device.shown.tobytes() == bytes(range(16))


@pytest.mark.parametrize(
    ("call", "error", "says"),
    [
        (lambda d: d.key("lefft"), ArgumentError, "did you mean 'left'"),
        (lambda d: d.key("pad_a"), ArgumentError, "on a pad"),
        (lambda d: d.key(7), ArgumentError, "key=7 is no key's name"),
        (lambda d: d.key("a", dwon=True), ArgumentTypeError, "did you mean 'down'"),
        (lambda d: d.touch(1, "moved", at=(0, 0)), ArgumentError, "finger 1 is not down; let it begin first"),
        (lambda d: d.touch(1, "ended"), ArgumentError, "finger 1 is not down"),
        (lambda d: d.touch(1, "begin", at=(0, 0)), ArgumentError, "did you mean 'began'"),
        (lambda d: d.touch(1, "began"), ArgumentTypeError, r"needs at=\(x, y\)"),
        (lambda d: d.touch(1, "began", at=(math.nan, 0)), ArgumentError, "must be finite"),
        (lambda d: d.touch(1, "began", at=(0, 1e30)), ArgumentError, "within"),
        (lambda d: d.touch(1, "began", at=5), ArgumentTypeError, "must be a point"),
        (lambda d: d.touch(1, "began", at=(0, 0), cancelled=True), ArgumentError, "only a finger that ended"),
        (lambda d: d.touch("mouse", "began", at=(0, 0)), ArgumentError, "pointer"),
        (lambda d: d.touch(True, "began", at=(0, 0)), ArgumentTypeError, "whole number or a name"),
        (lambda d: d.touch(1.5, "began", at=(0, 0)), ArgumentTypeError, "whole number or a name"),
        (lambda d: d.tilt(math.nan, 0), ArgumentError, r"Device\.tilt\(\): x=nan must be a finite number"),
        (lambda d: d.tilt(0, math.inf), ArgumentError, "y=inf"),
        (lambda d: d.tilt("1", 0), ArgumentTypeError, "x='1' must be a number"),
        (lambda d: d.pointer(), ArgumentTypeError, r"needs at=\(x, y\)"),
        (lambda d: d.pointer(button="left"), ArgumentTypeError, "go together"),
        (lambda d: d.pointer(button="lft", down=True), ArgumentError, "did you mean 'left'"),
        (lambda d: d.wheel(math.nan), ArgumentError, "y=nan"),
        (lambda d: d.pad("left_x", 1.5), ArgumentError, "at most 1"),
        (lambda d: d.pad("left_trigger", -0.1), ArgumentError, "at least 0"),
        (lambda d: d.pad("left_x", down=True), ArgumentTypeError, "give its value"),
        (lambda d: d.pad("a", 1), ArgumentTypeError, "is a button"),
        (lambda d: d.pad("aa", 1), ArgumentError, "did you mean 'a'"),
        (lambda d: d.pad("a", down=True, pad=99), ArgumentError, "at most 15"),
        (lambda d: d.unplug(), ArgumentError, "not connected"),
        (lambda d: d.text(""), ArgumentTypeError, "at least one character"),
        (lambda d: d.resize((0, 10)), ArgumentError, "at least 1"),
        (lambda d: d.resize((10.5, 10)), ArgumentTypeError, "whole numbers"),
        (lambda d: d.sensor("gyro", 0, 0, 0), ArgumentError, "did you mean 'gyroscope'"),
        (lambda d: d.show(b"123", (1, 1)), ArgumentError, "has 3 bytes; .* needs 4"),
        (lambda d: d.show("text", (1, 1)), ArgumentTypeError, "contiguous buffer"),
    ],
)
def test_bad_input_is_refused_and_reports_nothing(device, call, error, says):
    with pytest.raises(error, match=says):
        call(device)
    assert device.poll() == ()


def test_a_second_beginning_of_a_finger_is_refused(device):
    device.touch(1, "began", at=(0, 0))
    with pytest.raises(ArgumentError, match="finger 1 is down already"):
        device.touch(1, "began", at=(5, 5))
    device.touch(1, "ended", at=(2, 2))
    device.touch(1, "began", at=(5, 5))
    assert [event.phase for event in device.poll()] == ["began", "ended", "began"]


@pytest.mark.parametrize("size", [(0, 0), (-1, 5), (99999, 10)])
def test_a_size_out_of_range_is_refused(size):
    with pytest.raises(ArgumentError, match="at least 1 and at most 16384"):
        HeadlessDevice(size)
