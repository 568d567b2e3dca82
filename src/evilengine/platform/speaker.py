"""The sound card, through SDL. Its thread calls a C function of the core by address: Python is never asked."""

from __future__ import annotations

import ctypes
import weakref
from typing import Any

from evilengine.platform import sdl as library
from evilengine.values.errors import DeviceError

BLOCK = 512
"""Frames that the card asks for at once, 10.7 ms at 48 kHz: fewer crackle on busy machines, more are heard late."""


class Speaker:
    """An open sound output that plays two channels of 32-bit floats at `rate` until it is closed.

    The function at the address `callback` is called, as `void callback(argument, bytes, count)`, in the card's own
    thread; `keep` is kept alive as long as that can happen. Raises DeviceError where there is no sound card.
    """

    def __init__(self, callback: int, argument: int, keep: object, rate: int) -> None:
        sdl = library.load()
        sdl.SDL_ClearError()
        with library.quiet():
            failed = sdl.SDL_InitSubSystem(sdl.SDL_INIT_AUDIO) != 0
        if failed:
            raise DeviceError(f"no sound card: {library.why(sdl)}")
        wanted, got = _spec(sdl, callback, argument, rate), sdl.SDL_AudioSpec(0, 0, 0, 0)
        with library.quiet():
            number = sdl.SDL_OpenAudioDevice(None, 0, ctypes.byref(wanted), ctypes.byref(got), 0)  # 0: SDL converts
        if number == 0:
            reason = library.why(sdl)
            with library.quiet():
                sdl.SDL_QuitSubSystem(sdl.SDL_INIT_AUDIO)
            raise DeviceError(f"no sound card: {reason}")
        self.driver = (sdl.SDL_GetCurrentAudioDriver() or b"").decode()
        self.block = int(got.samples)
        self._shut = weakref.finalize(self, _close, sdl, number, (wanted, keep))
        sdl.SDL_PauseAudioDevice(number, 0)

    def close(self) -> None:
        """Fall silent. When this returns the callback is not called any more."""
        self._shut()


def clock_address() -> tuple[int, float]:
    """The address of a C function that gives ticks as uint64_t, and how many of them are a second."""
    sdl = library.load()
    function = ctypes.cast(sdl.SDL_GetPerformanceCounter, ctypes.c_void_p).value
    assert function
    return function, float(sdl.SDL_GetPerformanceFrequency())


def _spec(sdl: Any, callback: int, argument: int, rate: int) -> Any:
    spec = sdl.SDL_AudioSpec(rate, sdl.AUDIO_F32SYS, 2, BLOCK)
    spec.callback = ctypes.cast(callback, sdl.SDL_AudioCallback)
    spec.userdata = argument
    return spec


def _close(sdl: Any, number: int, keep: object) -> None:
    """Runs once: at close(), when the Speaker is forgotten, or when Python ends."""
    with library.quiet():
        sdl.SDL_CloseAudioDevice(number)  # waits for a callback that is running
        sdl.SDL_QuitSubSystem(sdl.SDL_INIT_AUDIO)
