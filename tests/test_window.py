"""The real window: opened on a screen in memory (Xvfb), drawn on, resized, touched, typed at and closed."""

from __future__ import annotations

import ctypes
import gc
import os
import shutil
import subprocess
import time
from pathlib import Path

import numpy as np
import pytest
from sdl_queue import push, push_finger, push_key

from evilengine.platform import DesktopDevice, open_device, screen_available
from evilengine.platform import sdl as library
from evilengine.values.errors import DeviceError
from evilengine.values.events import (
    CloseEvent,
    KeyEvent,
    ResizeEvent,
    TouchEvent,
)
from evilengine.values.vec2 import Vec2


class MemoryScreen:
    """An X server of our own whose screen is a file."""

    def __init__(self, folder: Path) -> None:
        read, write = os.pipe()
        self.server = subprocess.Popen(
            [
                "Xvfb",
                "-displayfd",
                str(write),
                "-screen",
                "0",
                "1280x1024x24",
                "-fbdir",
                str(folder),
                "-noreset",  # else it restarts when its last window closes, and refuses the next one meanwhile
                "-nolisten",
                "tcp",
                "-noreset",  # or it starts over when a window closes, and may turn away the next one meanwhile
            ],
            pass_fds=[write],
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        os.close(write)
        with os.fdopen(read) as answer:
            number = answer.readline().strip()  # comes when it is ready; is empty when it died
        if not number:
            pytest.fail(f"Xvfb did not start; it ended with {self.server.wait(10)}")
        self.display = f":{number}"
        self.file = folder / "Xvfb_screen0"

    def pixels(self) -> np.ndarray:
        """What the screen shows: rows from the top, red, green, blue."""
        data = self.file.read_bytes()  # the X window dump format: a header of big-endian words, colours, then pixels
        header = np.frombuffer(data, ">u4", 25)
        size, width, height, line, colours = (int(header[i]) for i in (0, 4, 5, 12, 19))
        start = size + 12 * colours
        rows = np.frombuffer(data, np.uint8, line * height, start).reshape(height, line)
        return rows[:, : width * 4].reshape(height, width, 4)[:, :, 2::-1]

    def close(self) -> None:
        self.server.terminate()
        self.server.wait(10)


@pytest.fixture(scope="module")
def screen(tmp_path_factory):
    if shutil.which("Xvfb") is None:
        pytest.skip("the window is tested on an X server in memory: apt-get install xvfb")
    screen = MemoryScreen(tmp_path_factory.mktemp("screen"))
    yield screen
    screen.close()


@pytest.fixture
def window(screen, monkeypatch):
    monkeypatch.setenv("DISPLAY", screen.display)
    for name in ("SDL_VIDEODRIVER", "WAYLAND_DISPLAY"):
        monkeypatch.delenv(name, raising=False)
    device = DesktopDevice("A test", (320, 240))
    yield device
    device.close()


def chessboard(width: int, height: int) -> np.ndarray:
    """A picture in which every pixel differs from that below it and to the right, so that a shift cannot hide."""
    y, x = np.mgrid[0:height, 0:width]
    picture = np.zeros((height, width, 4), np.uint8)
    picture[..., 0], picture[..., 1], picture[..., 2] = x * 7, y * 5, (x + y) * 11
    picture[..., 3] = x * 3  # alpha says nothing to a window
    return picture


def wait_for(condition, seconds: float = 10.0) -> bool:
    """Whether `condition` comes true in time: an X server answers when it likes."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        if condition():
            return True
        time.sleep(0.01)
    return False


def on_screen(screen: MemoryScreen, device: DesktopDevice) -> np.ndarray:
    """The part of the screen that the window covers."""
    x, y = ctypes.c_int(), ctypes.c_int()
    sdl = library.load()
    sdl.SDL_GetWindowPosition(device._window, ctypes.byref(x), ctypes.byref(y))
    width, height = device.size
    return screen.pixels()[y.value : y.value + height, x.value : x.value + width]


def shows(screen: MemoryScreen, device: DesktopDevice, picture: np.ndarray) -> bool:
    def same() -> bool:
        device.poll()
        device.show(picture, (picture.shape[1], picture.shape[0]))
        return np.array_equal(on_screen(screen, device), picture[..., :3])

    return wait_for(same)


def test_the_screen_shows_every_pixel_that_was_drawn(screen, window):
    assert window.size == window.pixel_size == (320, 240)
    assert window.scale == 1.0
    assert shows(screen, window, chessboard(320, 240))
    assert shows(screen, window, 255 - chessboard(320, 240))


def test_a_picture_of_read_only_bytes_is_shown_too(screen, window):
    picture = chessboard(320, 240)
    window.show(picture.tobytes(), (320, 240))
    assert wait_for(lambda: np.array_equal(on_screen(screen, window), picture[..., :3]))


def test_a_resized_window_says_so_and_shows_pictures_of_its_new_size(screen, window):
    assert shows(screen, window, chessboard(320, 240))
    window.poll()
    sdl = library.load()
    sdl.SDL_SetWindowSize(window._window, 400, 180)
    seen = []
    assert wait_for(lambda: seen.extend(window.poll()) or ResizeEvent((400, 180), (400, 180)) in seen)
    assert (window.size, window.pixel_size) == ((400, 180), (400, 180))
    assert shows(screen, window, chessboard(400, 180))
    assert sum(isinstance(event, ResizeEvent) for event in [*seen, *window.poll()]) == 1


def test_a_picture_of_another_size_is_stretched_over_the_window(screen, window):
    picture = np.zeros((2, 2, 4), np.uint8)
    picture[0, :, 0] = picture[:, 0, 1] = 255
    window.show(picture, (2, 2))
    corners = [(2, 2), (2, -3), (-3, 2), (-3, -3)]
    expected = [(255, 255, 0), (255, 0, 0), (0, 255, 0), (0, 0, 0)]
    assert wait_for(lambda: [tuple(on_screen(screen, window)[corner]) for corner in corners] == expected)


def test_synthetic_keys_and_fingers_reach_the_real_window_and_closing_it_is_told(screen, window):
    window.poll()
    sdl = library.load()
    push_key(window, sdl.SDLK_LEFT, 80, True)
    push_finger(window, "DOWN", 77, 0.25, 0.5)
    push_finger(window, "DOWN", 78, 0.5, 0.75)
    push_finger(window, "MOTION", 77, 0.5, 0.5)
    push(part="quit", type=sdl.SDL_QUIT)
    told = [e for e in window.poll() if isinstance(e, KeyEvent | TouchEvent | CloseEvent)]
    assert told == [
        KeyEvent("left", True),
        TouchEvent(0, "began", Vec2(80, 120)),
        TouchEvent(1, "began", Vec2(160, 180)),
        TouchEvent(0, "moved", Vec2(160, 120)),
        CloseEvent(),
    ]
    window.close()
    assert wait_for(lambda: not screen.pixels().any()), "a closed window leaves the screen"


def test_frames_keep_the_pace_of_the_screen(screen, window):
    if not window.vsync:
        pytest.fail("the window does not wait for the screen")
    picture = chessboard(320, 240)
    window.show(picture, (320, 240))
    start = time.monotonic()
    for _ in range(30):
        window.show(picture, (320, 240))
    assert 0.3 < time.monotonic() - start < 3.0  # 0.5 s at 60 frames a second, on a busy machine perhaps more


def test_the_screen_is_available_where_a_window_opens(screen, window):
    found = screen_available()
    assert (bool(found), found.reason) == (True, "")
    assert shows(screen, window, chessboard(320, 240)), "asking does not disturb a window that is open"


def test_there_is_one_window_at_a_time(screen, window):
    with pytest.raises(DeviceError, match=r"a window is open already \('A test'\); close it first"):
        DesktopDevice("Another")
    window.close()
    DesktopDevice("Another").close()


def test_a_device_that_nobody_keeps_closes_its_window(screen, monkeypatch):
    monkeypatch.setenv("DISPLAY", screen.display)
    monkeypatch.delenv("SDL_VIDEODRIVER", raising=False)
    for _ in range(3):
        device = open_device("Forgotten", (100, 100))
        device.poll()
        del device
        gc.collect()
    open_device("Last", (100, 100)).close()


def test_the_window_fills_the_screen_and_comes_back(screen, window):
    window.fullscreen = True
    assert wait_for(lambda: window.poll() is not None and window.size == (1280, 1024))
    assert window.fullscreen
    window.fullscreen = False
    assert wait_for(lambda: window.poll() is not None and window.size == (320, 240))
