"""DesktopDevice: a window of the desktop, by SDL 2."""

from __future__ import annotations

import contextlib
import ctypes
import weakref
from functools import partial
from typing import Any

from evilengine.platform import sdl as library
from evilengine.platform.device import to_picture, to_size
from evilengine.platform.sdl_events import Translator
from evilengine.platform.sdl_gl import GlSurface, open_window
from evilengine.values.checks import known_keywords
from evilengine.values.errors import ArgumentTypeError, DeviceError
from evilengine.values.events import Event, ResizeEvent

SMALLEST = (64, 64)
"""Points that a player cannot make a window smaller than."""

_open_window: weakref.ref[DesktopDevice] | None = None  # SDL has one queue of events for the whole process


class DesktopDevice:
    """A resizable window that shows pictures and reports what the player does.

    Raises DeviceError, which says why in one line, where no window can be opened. There is one window at a time. It
    must be used by the thread that made it, on some systems the main one.

    With `gl=True` it has a `surface` to draw on, where the driver grants one. The first picture that is shown instead
    closes it.
    """

    @known_keywords
    def __init__(
        self, title: str = "EvilEngine", size: tuple[int, int] = (960, 540), *, vsync: bool = True, gl: bool = False
    ) -> None:
        wanted, self._title = to_size(size, "DesktopDevice"), _to_title(title)
        self._sdl = sdl = library.load()
        _claim(self)
        self._window = self._renderer = self._texture = self._translator = None
        self._surface: GlSurface | None = None
        self.vsync = False
        self._driver = ""
        self._texture_size = (0, 0)
        self._wants_vsync = bool(vsync)
        self._resources = contextlib.ExitStack()
        self._finalizer = weakref.finalize(self, self._resources.close)
        try:
            library.start_video(sdl)
            self._resources.callback(library.stop_video, sdl)
            with library.quiet():
                self._open_inputs()
                self._open_window(wanted, gl)
                if self._surface is None:
                    self._open_renderer()
            # What closes the window must not hold this device, or nothing would ever let go of it.
            self._translator = Translator(sdl, self._window, partial(_ask, sdl.SDL_GetWindowSize, self._window))
            self._resources.callback(self._translator.close)
        except BaseException:
            self._finalizer()
            raise
        self._known_size = self.size, self.pixel_size

    @property
    def title(self) -> str:
        """What stands above the window."""
        return self._title

    @title.setter
    def title(self, title: str) -> None:
        self._title = _to_title(title)
        if self.is_open:
            self._sdl.SDL_SetWindowTitle(self._window, self._title.encode())

    @property
    def size(self) -> tuple[int, int]:
        """Width and height in logical points."""
        return _ask(self._sdl.SDL_GetWindowSize, self._window) if self.is_open else self._known_size[0]

    @property
    def pixel_size(self) -> tuple[int, int]:
        """Width and height in real pixels; more than `size` on a high-resolution screen."""
        if self.surface is not None:
            return self.surface.pixel_size
        if self.is_open and self._renderer:
            return _ask(self._sdl.SDL_GetRendererOutputSize, self._renderer)
        return _ask(self._sdl.SDL_GL_GetDrawableSize, self._window) if self.is_open else self._known_size[1]

    @property
    def scale(self) -> float:
        """Real pixels a logical point."""
        return self.pixel_size[0] / self.size[0]

    @property
    def is_open(self) -> bool:
        """False once `close` was called."""
        return self._finalizer.alive

    @property
    def surface(self) -> GlSurface | None:
        """The GL context to draw with, None where there is none or it was closed."""
        return self._surface if self._surface is not None and self._surface.is_open else None

    @property
    def driver(self) -> str:
        """What puts pictures on the screen: "software", "opengl", "metal", "direct3d11", ..."""
        return self._driver

    @property
    def fullscreen(self) -> bool:
        """Whether the window fills the screen; may be set."""
        return self.is_open and bool(self._sdl.SDL_GetWindowFlags(self._window) & self._sdl.SDL_WINDOW_FULLSCREEN)

    @fullscreen.setter
    def fullscreen(self, full: bool) -> None:
        self._require_open("Device.fullscreen")
        self._sdl.SDL_SetWindowFullscreen(self._window, self._sdl.SDL_WINDOW_FULLSCREEN_DESKTOP if full else 0)

    def poll(self) -> tuple[Event, ...]:
        """What happened since the last call, in order."""
        if not self.is_open or self._translator is None:
            return ()
        events = list(self._translator.poll())
        now = self.size, self.pixel_size
        if now != self._known_size:  # asked, as a move to another screen changes pixels without a resize
            self._known_size = now
            events.insert(0, ResizeEvent(*now))
        return tuple(events)

    def show(self, pixels: object, size: tuple[int, int]) -> None:
        """Put a picture on the screen, stretched over the whole window; waits for the screen when `vsync` is true."""
        flat, picture_size = to_picture(pixels, size, "Device.show()")
        self._require_open("Device.show()")
        sdl = self._sdl
        if not self._renderer:
            self._leave_gl()
        if picture_size != self._texture_size:
            self._make_texture(picture_size)
        address, keeper = _address(flat)
        failed = sdl.SDL_UpdateTexture(self._texture, None, address, picture_size[0] * 4) != 0
        del keeper
        sdl.SDL_RenderClear(self._renderer)
        if failed or sdl.SDL_RenderCopy(self._renderer, self._texture, None, None) != 0:
            self._texture_size = (0, 0)  # a graphics card that was reset lost it; the next picture makes a new one
        sdl.SDL_RenderPresent(self._renderer)

    def close(self) -> None:
        """Close the window and give everything back. Closing twice does nothing."""
        if self.is_open:
            self._known_size = self.size, self.pixel_size
            with library.quiet():
                self._finalizer()

    # ---- opening --------------------------------------------------------------------------------------------------

    def _open_inputs(self) -> None:
        """Game controllers and sensors; a machine that has none, or no access to them, does without."""
        for kind in (self._sdl.SDL_INIT_GAMECONTROLLER, self._sdl.SDL_INIT_SENSOR):
            if self._sdl.SDL_InitSubSystem(kind) == 0:
                self._resources.callback(self._sdl.SDL_QuitSubSystem, kind)

    def _open_window(self, size: tuple[int, int], gl: bool) -> None:
        sdl = self._sdl
        flags = sdl.SDL_WINDOW_RESIZABLE | sdl.SDL_WINDOW_ALLOW_HIGHDPI | sdl.SDL_WINDOW_SHOWN
        anywhere = sdl.SDL_WINDOWPOS_UNDEFINED
        context = None
        if gl:
            self._window, context = open_window(sdl, self._title.encode(), size, flags)
        if not self._window:
            self._window = sdl.SDL_CreateWindow(self._title.encode(), anywhere, anywhere, *size, flags)
        if not self._window:
            raise DeviceError(f"no window: {library.why(sdl)}")
        self._resources.callback(sdl.SDL_DestroyWindow, self._window)
        if context:
            self._surface = GlSurface(sdl, self._window, context, vsync=self._wants_vsync)
            self._resources.callback(self._surface.close)
            self.vsync, self._driver = self._surface.vsync, "opengl"
        sdl.SDL_SetWindowMinimumSize(self._window, *(min(pair) for pair in zip(SMALLEST, size, strict=True)))

    def _leave_gl(self) -> None:
        """From drawing on the window to showing pictures in it."""
        if self._surface is not None:
            self._surface.close()
        with library.quiet():
            self._open_renderer()

    def _open_renderer(self) -> None:
        """The graphics card where there is one; the processor where there is none, or where it plays the card."""
        sdl = self._sdl
        wait = sdl.SDL_RENDERER_PRESENTVSYNC if self._wants_vsync else 0
        for flags in (sdl.SDL_RENDERER_ACCELERATED | wait, sdl.SDL_RENDERER_SOFTWARE | wait, sdl.SDL_RENDERER_SOFTWARE):
            renderer = sdl.SDL_CreateRenderer(self._window, -1, flags)
            if renderer and flags & sdl.SDL_RENDERER_ACCELERATED and _is_slow(sdl):
                sdl.SDL_DestroyRenderer(renderer)
                continue
            if renderer:
                break
        else:
            raise DeviceError(f"no window: {library.why(sdl)}")
        self._renderer = renderer
        self._resources.callback(sdl.SDL_DestroyRenderer, renderer)
        info = sdl.SDL_RendererInfo()
        sdl.SDL_GetRendererInfo(renderer, ctypes.byref(info))
        self._driver = (info.name or b"").decode()
        self.vsync = bool(flags & info.flags & sdl.SDL_RENDERER_PRESENTVSYNC)

    def _make_texture(self, size: tuple[int, int]) -> None:
        sdl = self._sdl
        if self._texture:
            sdl.SDL_DestroyTexture(self._texture)
        kind, access = sdl.SDL_PIXELFORMAT_RGBA32, sdl.SDL_TEXTUREACCESS_STREAMING
        self._texture = sdl.SDL_CreateTexture(self._renderer, kind, access, *size)
        if not self._texture:
            self._texture_size = (0, 0)
            raise DeviceError(f"Device.show(): no picture of {size[0]} x {size[1]} pixels: {library.why(sdl)}")
        sdl.SDL_SetTextureBlendMode(self._texture, sdl.SDL_BLENDMODE_NONE)
        sdl.SDL_SetTextureScaleMode(self._texture, sdl.SDL_ScaleModeLinear)
        self._texture_size = size

    def _require_open(self, owner: str) -> None:
        if not self.is_open:
            raise DeviceError(f"{owner}: this window was closed")


def _ask(question: Any, subject: Any) -> tuple[int, int]:
    """A width and a height, by one of SDL's functions that fill in two numbers."""
    width, height = ctypes.c_int(), ctypes.c_int()
    question(subject, ctypes.byref(width), ctypes.byref(height))
    return max(1, width.value), max(1, height.value)


def _claim(device: DesktopDevice) -> None:
    global _open_window
    other = _open_window() if _open_window is not None else None
    if other is not None and other is not device and other.is_open:
        raise DeviceError(f"a window is open already ({other.title!r}); close it first")
    _open_window = weakref.ref(device)


def _to_title(title: object) -> str:
    if not isinstance(title, str):
        raise ArgumentTypeError(f"Device: title={title!r} must be a str")
    return title.replace("\0", " ").encode("utf-8", "replace").decode()


def _address(flat: memoryview) -> tuple[Any, Any]:
    """Where the bytes of a buffer are, and what keeps them there."""
    if flat.readonly:
        whole = flat.obj if type(flat.obj) is bytes and len(flat.obj) == len(flat) else bytes(flat)
        return ctypes.cast(ctypes.c_char_p(whole), ctypes.c_void_p), whole
    array = (ctypes.c_ubyte * len(flat)).from_buffer(flat)
    return ctypes.cast(array, ctypes.c_void_p), array


def _is_slow(sdl: Any) -> bool:
    """Whether the OpenGL in use is itself a program on the processor: a detour that SDL's own software path avoids."""
    address = sdl.SDL_GL_GetProcAddress(b"glGetString") if sdl.SDL_GL_GetCurrentContext() else None
    if not address:
        return False
    get_string = ctypes.CFUNCTYPE(ctypes.c_char_p, ctypes.c_uint)(address)
    name = (get_string(0x1F01) or b"").decode("ascii", "replace").lower()  # GL_RENDERER
    return any(word in name for word in ("llvmpipe", "softpipe", "swrast", "swiftshader", "software"))
