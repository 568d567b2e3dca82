"""Is there a screen? One line says why not; and what a window refuses. On SDL's dummy driver, which needs none."""

from __future__ import annotations

import os
import subprocess
import sys
import time

import numpy as np
import pytest

from evilengine.platform import DesktopDevice, HeadlessDevice, open_device, screen_available
from evilengine.platform import sdl as library
from evilengine.values.errors import ArgumentError, ArgumentTypeError, DeviceError


@pytest.fixture
def unseen(monkeypatch):
    """A window on SDL's dummy driver, with what opening it reports polled away."""
    monkeypatch.setenv("SDL_VIDEODRIVER", "dummy")
    device = DesktopDevice("Unseen", (320, 240))
    device.poll()
    yield device
    device.close()


@pytest.fixture
def no_display(monkeypatch):
    for name in ("DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER"):
        monkeypatch.delenv(name, raising=False)
    if sys.platform in ("win32", "darwin"):
        pytest.skip("this system has a screen without being told of it")
    return monkeypatch


def test_without_a_screen_the_reason_is_one_line(no_display):
    screen = screen_available()
    assert not screen
    assert screen.reason == "no screen: neither DISPLAY nor WAYLAND_DISPLAY is set"
    with pytest.raises(DeviceError, match="no screen: neither DISPLAY nor WAYLAND_DISPLAY is set"):
        open_device()


def test_a_display_that_is_not_there_is_named(no_display):
    no_display.setenv("DISPLAY", ":4711")
    assert screen_available().reason == "no screen: the display ':4711' cannot be opened"
    with pytest.raises(DeviceError, match="the display ':4711' cannot be opened"):
        DesktopDevice()


def test_a_display_on_a_host_that_does_not_answer_does_not_hold_us(no_display):
    no_display.setenv("DISPLAY", "localhost:4712")
    start = time.monotonic()
    assert not screen_available()
    assert time.monotonic() - start < 5


def test_a_driver_that_shows_nothing_is_no_screen_but_opens_when_asked_for(no_display):
    no_display.setenv("SDL_VIDEODRIVER", "dummy")
    assert screen_available().reason == "no screen: SDL's video driver 'dummy' shows nothing"
    DesktopDevice("opens", (64, 64)).close()


def test_a_driver_that_does_not_exist_is_named(no_display):
    no_display.setenv("SDL_VIDEODRIVER", "bogus")
    with pytest.raises(DeviceError, match="bogus"):
        DesktopDevice()


def test_looking_for_a_screen_prints_nothing_and_importing_loads_nothing(tmp_path):
    program = (
        "import sys, evilengine.platform as p, evilengine.interaction\n"
        "assert 'sdl2' not in sys.modules and 'sdl2dll' not in sys.modules\n"
        "assert not p.screen_available()\n"
    )
    clean = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER")}
    for extra in ({}, {"DISPLAY": ":4711"}, {"SDL_VIDEODRIVER": "dummy"}, {"PYSDL2_DLL_PATH": str(tmp_path)}):
        command = [sys.executable, "-W", "error", "-c", program]
        run = subprocess.run(command, env=clean | extra, capture_output=True, text=True, timeout=60)
        assert (run.returncode, run.stdout, run.stderr) == (0, "", "")


def test_a_closed_window_reports_nothing_and_shows_nothing(unseen):
    unseen.close()
    unseen.close()
    assert not unseen.is_open
    assert unseen.poll() == ()
    assert unseen.size == (320, 240)
    with pytest.raises(DeviceError, match=r"Device\.show\(\): this window was closed"):
        unseen.show(bytes(4), (1, 1))


def test_the_title_can_change(unseen):
    unseen.title = "Nivå två"
    assert library.load().SDL_GetWindowTitle(unseen._window).decode() == unseen.title == "Nivå två"
    with pytest.raises(ArgumentTypeError, match="title=7"):
        unseen.title = 7


@pytest.mark.parametrize(
    ("arguments", "error", "says"),
    [
        ({"size": (0, 10)}, ArgumentError, "at least 1"),
        ({"size": (10**6, 10)}, ArgumentError, "at most 16384"),
        ({"size": "big"}, ArgumentTypeError, "whole numbers"),
        ({"title": None}, ArgumentTypeError, "title=None"),
        ({"sice": (10, 10)}, ArgumentTypeError, "did you mean 'size'"),
    ],
)
def test_bad_arguments_are_refused_and_leave_no_window(monkeypatch, arguments, error, says):
    monkeypatch.setenv("SDL_VIDEODRIVER", "dummy")
    with pytest.raises(error, match=says):
        DesktopDevice(**arguments)
    DesktopDevice(size=(10, 10)).close()


@pytest.mark.parametrize("pixels", [b"", bytes(7), np.zeros((2, 4, 4), np.uint8)[:, ::2]])
def test_a_picture_that_does_not_fit_is_refused(unseen, pixels):
    with pytest.raises((ArgumentError, ArgumentTypeError), match=r"Device\.show\(\): pixels"):
        unseen.show(pixels, (2, 1))


def test_open_device_is_headless_when_asked():
    assert isinstance(open_device(headless=True), HeadlessDevice)
