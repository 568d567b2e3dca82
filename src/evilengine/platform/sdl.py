"""SDL 2: found, loaded and kept quiet. Nothing outside `platform/` knows it; nothing imports it before it is used."""

from __future__ import annotations

import contextlib
import functools
import os
import socket
import sys
import time
import warnings
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from evilengine.values.errors import DeviceError

SEEN_BY_NOBODY = ("dummy", "offscreen", "evdev")
"""Video drivers of SDL that have no screen."""

HINTS = {
    b"SDL_NO_SIGNAL_HANDLERS": b"1",  # Ctrl-C stays Python's KeyboardInterrupt
    b"SDL_TOUCH_MOUSE_EVENTS": b"0",  # a finger is not also the mouse
    b"SDL_MOUSE_TOUCH_EVENTS": b"0",  # nor the mouse a finger
    b"SDL_ACCELEROMETER_AS_JOYSTICK": b"0",  # it is a sensor
    b"SDL_WINDOWS_DPI_SCALING": b"1",  # window sizes in points on Windows too
    b"SDL_VIDEO_X11_NET_WM_BYPASS_COMPOSITOR": b"0",  # leave the desktop's effects alone
    b"SDL_APP_NAME": b"EvilEngine",
}
PATIENCE = (0.0, 0.05, 0.2)
"""Seconds to wait before each try at a display: an X server that its last window has just left starts anew, and turns
callers away meanwhile."""

SILENCE = 7  # one above SDL_LOG_PRIORITY_CRITICAL: SDL logs nothing


@dataclass(frozen=True, slots=True)
class Screen:
    """Whether a window can be shown here; true when it can, else `reason` says in one line why not."""

    available: bool
    reason: str = ""

    def __bool__(self) -> bool:
        return self.available


@functools.cache
def load() -> Any:
    """The sdl2 module with its library loaded and silent. Raises DeviceError where it cannot be had."""
    chosen = os.environ.get("PYSDL2_DLL_PATH", "")
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # it warns of the very library that we ask for
            _prefer_our_library()
            import sdl2
    except (ImportError, RuntimeError, OSError, ValueError) as error:
        reason = " ".join(str(error).split())
        fix = f"PYSDL2_DLL_PATH={chosen!r} may be wrong" if chosen else "try pip install pysdl2-dll"
        raise DeviceError(f"SDL 2, which opens windows, cannot be loaded: {reason}; {fix}") from None
    sdl2.SDL_LogSetAllPriority(SILENCE)
    for name, value in HINTS.items():
        sdl2.SDL_SetHint(name, value)
    return sdl2


def _prefer_our_library() -> None:
    """Point PySDL2 to the library in pysdl2-dll, unless the player chose another by PYSDL2_DLL_PATH."""
    if os.environ.get("PYSDL2_DLL_PATH") == "":
        del os.environ["PYSDL2_DLL_PATH"]  # set but empty, it would be taken for the folder we stand in
    with contextlib.suppress(ImportError):
        import sdl2dll  # noqa: F401  (sets the variable when it is imported)


def why(sdl: Any) -> str:
    """SDL's last error, in one line."""
    text = (sdl.SDL_GetError() or b"").decode("utf-8", "replace")
    return " ".join(text.split()) or "SDL gives no reason"


@contextlib.contextmanager
def quiet() -> Iterator[None]:
    """What drivers and libraries under SDL would print on the terminal meanwhile goes nowhere."""
    kept: list[tuple[int, int]] = []
    try:
        with contextlib.suppress(OSError, ValueError, AttributeError):
            sys.stdout.flush()
            sys.stderr.flush()
        with contextlib.suppress(OSError):
            nowhere = os.open(os.devnull, os.O_WRONLY)
            for stream in (1, 2):
                kept.append((stream, os.dup(stream)))
                os.dup2(nowhere, stream)
            os.close(nowhere)
        yield
    finally:
        for stream, copy in kept:
            os.dup2(copy, stream)
            os.close(copy)


def screen_available() -> Screen:
    """Whether a window can be shown on this machine; never raises, never hangs, prints nothing.

    >>> screen = screen_available()
    >>> bool(screen) == (screen.reason == "")
    True
    """
    try:
        sdl = load()
        start_video(sdl)
    except DeviceError as error:
        return Screen(False, str(error))
    try:
        driver = driver_of(sdl)
        if driver in SEEN_BY_NOBODY:
            return Screen(False, f"no screen: SDL's video driver {driver!r} shows nothing")
        if sdl.SDL_GetNumVideoDisplays() < 1:
            return Screen(False, f"no screen: the video driver {driver!r} knows no display")
        return Screen(True)
    finally:
        stop_video(sdl)


def start_video(sdl: Any) -> None:
    """Start SDL's video, which counts its users, or raise a DeviceError that says in one line why not."""
    reason = "" if sdl.SDL_WasInit(sdl.SDL_INIT_VIDEO) else _no_display()
    if reason:
        raise DeviceError(f"no screen: {reason}")
    for pause in PATIENCE:
        time.sleep(pause)
        sdl.SDL_ClearError()
        with quiet():
            failed = sdl.SDL_InitSubSystem(sdl.SDL_INIT_VIDEO) != 0
        if failed:
            raise DeviceError(f"no screen: {why(sdl)}")
        if driver_of(sdl) not in SEEN_BY_NOBODY or os.environ.get("SDL_VIDEODRIVER"):
            return
        stop_video(sdl)  # what SDL falls back to when no display opens
    display = os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY", "")
    raise DeviceError(f"no screen: the display {display!r} cannot be opened")


def driver_of(sdl: Any) -> str:
    """The name of the video driver in use: "x11", "windows", "dummy", ..."""
    return (sdl.SDL_GetCurrentVideoDriver() or b"").decode()


def stop_video(sdl: Any) -> None:
    """Give up one use of SDL's video."""
    with quiet():
        sdl.SDL_QuitSubSystem(sdl.SDL_INIT_VIDEO)


def _no_display() -> str:
    """Why the environment rules a screen out before SDL is asked; empty when it does not."""
    if sys.platform in ("win32", "darwin") or os.environ.get("SDL_VIDEODRIVER", "") not in ("", "x11", "wayland"):
        return ""
    display = os.environ.get("DISPLAY", "")
    if not display:
        return "" if os.environ.get("WAYLAND_DISPLAY") else "neither DISPLAY nor WAYLAND_DISPLAY is set"
    return _dead_host(display)


def _dead_host(display: str) -> str:
    """An X server on a host that does not answer would hold us for minutes; ask it for at most two seconds first."""
    host, colon, number = display.rpartition(":")
    number = number.partition(".")[0]
    if not colon or not number.isdigit() or host in ("", "unix") or "/" in host or int(number) > 59535:
        return ""
    try:
        socket.create_connection((host.strip("[]"), 6000 + int(number)), timeout=2.0).close()
    except (OSError, UnicodeError):
        return f"the display {display!r} does not answer"
    return ""
