"""A window's GL context, by SDL: on X11, Wayland, Windows and macOS alike."""

from __future__ import annotations

import ctypes
import weakref
from typing import Any

from evilengine.platform import sdl as library
from evilengine.values.errors import DeviceError

VERSIONS = ((3, 3, "SDL_GL_CONTEXT_PROFILE_CORE"), (3, 0, "SDL_GL_CONTEXT_PROFILE_ES"))
"""Versions and profiles to ask for, the first that the driver grants."""


def open_window(sdl: Any, title: bytes, size: tuple[int, int], flags: int) -> tuple[Any, Any]:
    """A window and the GL context in it, or (None, None) where that cannot be had; `flags` are of SDL_CreateWindow."""
    anywhere = sdl.SDL_WINDOWPOS_UNDEFINED
    try:
        for major, minor, profile in VERSIONS:
            sdl.SDL_GL_SetAttribute(sdl.SDL_GL_CONTEXT_MAJOR_VERSION, major)
            sdl.SDL_GL_SetAttribute(sdl.SDL_GL_CONTEXT_MINOR_VERSION, minor)
            sdl.SDL_GL_SetAttribute(sdl.SDL_GL_CONTEXT_PROFILE_MASK, getattr(sdl, profile))
            sdl.SDL_GL_SetAttribute(sdl.SDL_GL_CONTEXT_FLAGS, sdl.SDL_GL_CONTEXT_FORWARD_COMPATIBLE_FLAG)  # macOS
            sdl.SDL_GL_SetAttribute(sdl.SDL_GL_DEPTH_SIZE, 0)
            window = sdl.SDL_CreateWindow(title, anywhere, anywhere, *size, flags | sdl.SDL_WINDOW_OPENGL)
            context = sdl.SDL_GL_CreateContext(window) if window else None
            if context:
                return window, context
            if window:
                sdl.SDL_DestroyWindow(window)
        return None, None
    finally:
        sdl.SDL_GL_ResetAttributes()  # SDL's own renderers would take them for theirs


class GlSurface:
    """Behaves as `Surface` in evilengine.values.surface says."""

    def __init__(self, sdl: Any, window: Any, context: Any, *, vsync: bool) -> None:
        self._sdl, self._window, self._context = sdl, window, context
        self._finalizer = weakref.finalize(self, sdl.SDL_GL_DeleteContext, context)
        self.make_current()
        # Adaptive where there is such a thing: a frame that comes late is shown at once.
        wanted = (-1, 1) if vsync else (0,)
        self.vsync = any(sdl.SDL_GL_SetSwapInterval(each) == 0 for each in wanted) and vsync

    @property
    def is_open(self) -> bool:
        """False once `close` was called."""
        return self._finalizer.alive

    @property
    def pixel_size(self) -> tuple[int, int]:
        """Width and height in real pixels."""
        width, height = ctypes.c_int(), ctypes.c_int()
        self._sdl.SDL_GL_GetDrawableSize(self._window, ctypes.byref(width), ctypes.byref(height))
        return max(1, width.value), max(1, height.value)

    def make_current(self) -> None:
        """Let this context be the one that draws."""
        if not self.is_open:
            raise DeviceError("the window's GL context was closed")
        if self._sdl.SDL_GL_MakeCurrent(self._window, self._context) != 0:
            raise DeviceError(f"the window's GL context cannot be used: {library.why(self._sdl)}")

    def address(self, name: str) -> int:
        """Where a function of GL is; 0 if there is none of that name."""
        return int(self._sdl.SDL_GL_GetProcAddress(name.encode()) or 0)

    def swap(self) -> None:
        """Put what was drawn on the screen."""
        self.make_current()
        self._sdl.SDL_GL_SwapWindow(self._window)

    def close(self) -> None:
        """Give the context back."""
        self._finalizer()
