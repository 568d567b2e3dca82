"""What SDL finds on this machine, for people who ask why something is missing."""

from __future__ import annotations

import ctypes
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

from evilengine.platform import sdl as library


@dataclass(frozen=True, slots=True)
class DeviceReport:
    """Screens, sound outputs and what a player can hold, each by the name its driver gives it."""

    sdl: str
    """SDL's version."""
    video_driver: str
    """Empty where there is no screen."""
    no_screen: str
    """Why there is none; empty where there is one."""
    screens: tuple[str, ...]
    audio_driver: str
    """Empty where there is no sound card."""
    no_sound: str
    outputs: tuple[str, ...]
    touch_screens: tuple[str, ...]
    pads: tuple[str, ...]
    sensors: tuple[str, ...]


def report() -> DeviceReport:
    """Ask SDL, starting what it needs and stopping it again. Raises DeviceError where SDL itself cannot be loaded."""
    sdl = library.load()
    screen = library.screen_available()
    with library.quiet():
        video_driver, screens, touch_screens = _video(sdl) if screen else ("", (), ())
        audio_driver, outputs, no_sound = _audio(sdl)
        pads = _names(sdl, sdl.SDL_INIT_GAMECONTROLLER, sdl.SDL_NumJoysticks, sdl.SDL_JoystickNameForIndex)
        sensors = _names(sdl, sdl.SDL_INIT_SENSOR, sdl.SDL_NumSensors, sdl.SDL_SensorGetDeviceName)
    version = sdl.SDL_version()
    sdl.SDL_GetVersion(ctypes.byref(version))
    return DeviceReport(
        sdl=f"{version.major}.{version.minor}.{version.patch}",
        video_driver=video_driver,
        no_screen=screen.reason,
        screens=screens,
        audio_driver=audio_driver,
        no_sound=no_sound,
        outputs=outputs,
        touch_screens=touch_screens,
        pads=pads,
        sensors=sensors,
    )


def _video(sdl: Any) -> tuple[str, tuple[str, ...], tuple[str, ...]]:
    library.start_video(sdl)
    try:
        screens = tuple(_screen(sdl, index) for index in range(max(0, sdl.SDL_GetNumVideoDisplays())))
        touch = (sdl.SDL_GetTouchName(index) for index in range(max(0, sdl.SDL_GetNumTouchDevices())))
        return library.driver_of(sdl), screens, tuple(_text(name, "touch screen") for name in touch)
    finally:
        library.stop_video(sdl)


def _screen(sdl: Any, index: int) -> str:
    mode = sdl.SDL_DisplayMode()
    name = _text(sdl.SDL_GetDisplayName(index), f"screen {index}")
    if sdl.SDL_GetDesktopDisplayMode(index, ctypes.byref(mode)) != 0:
        return name
    return f"{name}, {mode.w} x {mode.h}" + (f" at {mode.refresh_rate} Hz" if mode.refresh_rate else "")


def _audio(sdl: Any) -> tuple[str, tuple[str, ...], str]:
    with _started(sdl, sdl.SDL_INIT_AUDIO) as works:
        if not works:
            return "", (), library.why(sdl)
        driver = _text(sdl.SDL_GetCurrentAudioDriver(), "")
        count = max(0, sdl.SDL_GetNumAudioDevices(0))
        outputs = tuple(_text(sdl.SDL_GetAudioDeviceName(index, 0), f"output {index}") for index in range(count))
        return driver, outputs, "" if outputs else "no sound output"


def _names(sdl: Any, subsystem: int, count: Any, name: Any) -> tuple[str, ...]:
    with _started(sdl, subsystem) as works:
        return tuple(_text(name(index), f"number {index}") for index in range(max(0, count()))) if works else ()


@contextmanager
def _started(sdl: Any, subsystem: int) -> Iterator[bool]:
    sdl.SDL_ClearError()
    works = sdl.SDL_InitSubSystem(subsystem) == 0
    try:
        yield works
    finally:
        if works:
            sdl.SDL_QuitSubSystem(subsystem)


def _text(name: bytes | None, otherwise: str) -> str:
    return " ".join((name or b"").decode("utf-8", "replace").split()) or otherwise
