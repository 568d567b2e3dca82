"""SDL's events turned into ours: keys, mouse, fingers, game controllers, sensors."""

from __future__ import annotations

import ctypes
import math
from collections.abc import Callable, Iterator
from typing import Any

from evilengine.platform.sdl_keys import CONTROLLER_AXES, CONTROLLER_BUTTONS, MOUSE_BUTTONS, key_of
from evilengine.values.events import (
    CloseEvent,
    Event,
    FocusEvent,
    KeyEvent,
    PadAxisEvent,
    PadButtonEvent,
    PadEvent,
    Phase,
    PointerEvent,
    Reading,
    SensorEvent,
    TextEvent,
    TiltEvent,
    TouchEvent,
    WheelEvent,
)
from evilengine.values.vec2 import Vec2

# PySDL2 gives these as other numbers than SDL does, so they are here.
MADE_FROM_TOUCH = 0xFFFFFFFF  # the mouse that SDL makes up from a finger
MADE_FROM_MOUSE = -1  # the touch screen that SDL makes up from the mouse
TRACK_PADS = (1, 2)  # touch devices that do not lie on the screen; their fingers are not where a picture is

STILL = 0.02
"""g that a reading must change by to be told. A laptop on a table trembles less; told, it would overrule the keys."""


def _names(sdl: Any, prefix: str, *names: str) -> list[int]:
    return [getattr(sdl, prefix + name) for name in names]


class Translator:
    """Remembers what SDL's events leave out: which fingers, pads and sensors there are."""

    def __init__(self, sdl: Any, window: Any, size: Callable[[], tuple[int, int]]) -> None:
        self._sdl = sdl
        self._window = window
        self._window_id = sdl.SDL_GetWindowID(window)
        self._size = size
        self._keys: dict[int, str] = {}  # by scancode: a layout may change while a key is down
        self._fingers: dict[tuple[int, int], int] = {}  # (touch screen, SDL's finger) -> ours
        self._pads: dict[int, tuple[int, Any]] = {}  # SDL's instance -> (our number, controller)
        self._sensors: dict[int, tuple[str, Any]] = {}  # SDL's instance -> (our name, sensor)
        self._reading: Reading | None = None
        self._translate: dict[int, Callable[[Any], Iterator[Event]]] = {}
        self._register()
        self._open_sensors()

    def _register(self) -> None:
        sdl, table = self._sdl, self._translate
        table[sdl.SDL_QUIT] = lambda _: iter([CloseEvent()])
        table[sdl.SDL_WINDOWEVENT] = lambda event: self._window_changed(event.window)
        table[sdl.SDL_TEXTINPUT] = lambda event: self._text(event.text)
        table[sdl.SDL_MOUSEMOTION] = lambda event: self._mouse_moved(event.motion)
        table[sdl.SDL_MOUSEWHEEL] = lambda event: self._wheel(event.wheel)
        for kind in _names(sdl, "SDL_KEY", "DOWN", "UP"):
            table[kind] = lambda event: self._key(event.key)
        for kind in _names(sdl, "SDL_MOUSEBUTTON", "DOWN", "UP"):
            table[kind] = lambda event: self._mouse_button(event.button)
        for kind in _names(sdl, "SDL_FINGER", "DOWN", "MOTION", "UP"):
            table[kind] = lambda event: self._finger(event.tfinger)
        for kind in _names(sdl, "SDL_CONTROLLERBUTTON", "DOWN", "UP"):
            table[kind] = lambda event: self._pad_button(event.cbutton)
        table[sdl.SDL_CONTROLLERAXISMOTION] = lambda event: self._pad_axis(event.caxis)
        table[sdl.SDL_CONTROLLERDEVICEADDED] = lambda event: self._pad_added(event.cdevice.which)
        table[sdl.SDL_CONTROLLERDEVICEREMOVED] = lambda event: self._pad_removed(event.cdevice.which)
        table[sdl.SDL_SENSORUPDATE] = lambda event: self._sensor(event.sensor)

    def poll(self) -> Iterator[Event]:
        """Everything that SDL has for us, as our events."""
        event = self._sdl.SDL_Event()
        while self._sdl.SDL_PollEvent(ctypes.byref(event)):
            translate = self._translate.get(event.type)
            if translate is not None:
                yield from translate(event)

    def close(self) -> None:
        """Give back the game controllers and sensors."""
        for _, controller in self._pads.values():
            self._sdl.SDL_GameControllerClose(controller)
        for _, sensor in self._sensors.values():
            self._sdl.SDL_SensorClose(sensor)
        self._pads.clear()
        self._sensors.clear()

    def _ours(self, window_id: int) -> bool:
        return window_id in (self._window_id, 0)  # 0: what is sent while no window has the focus

    # ---- window, keyboard, mouse ----------------------------------------------------------------------------------

    def _window_changed(self, event: Any) -> Iterator[Event]:
        if not self._ours(event.windowID):
            return
        if event.event == self._sdl.SDL_WINDOWEVENT_FOCUS_GAINED:
            yield FocusEvent(True)
        elif event.event == self._sdl.SDL_WINDOWEVENT_FOCUS_LOST:
            self._keys.clear()
            self._fingers.clear()
            yield FocusEvent(False)

    def _key(self, event: Any) -> Iterator[Event]:
        place = event.keysym.scancode
        if event.state and self._ours(event.windowID):
            name = key_of(event.keysym.sym, place)
            if name and not event.repeat and place not in self._keys:
                self._keys[place] = name
                yield KeyEvent(name, True)
        elif not event.state and place in self._keys:
            yield KeyEvent(self._keys.pop(place), False)

    def _text(self, event: Any) -> Iterator[Event]:
        text = event.text.decode("utf-8", "replace")
        if text and self._ours(event.windowID):
            yield TextEvent(text)

    def _mouse_moved(self, event: Any) -> Iterator[Event]:
        if event.which != MADE_FROM_TOUCH and self._ours(event.windowID):
            yield PointerEvent(Vec2(event.x, event.y))

    def _mouse_button(self, event: Any) -> Iterator[Event]:
        name = MOUSE_BUTTONS.get(event.button)
        if name and event.which != MADE_FROM_TOUCH and self._ours(event.windowID):
            yield PointerEvent(Vec2(event.x, event.y), name, bool(event.state))

    def _wheel(self, event: Any) -> Iterator[Event]:
        if event.which == MADE_FROM_TOUCH or not self._ours(event.windowID):
            return
        turn = Vec2(_finite(event.preciseX) or event.x, _finite(event.preciseY) or event.y)
        if turn != (0.0, 0.0):
            yield WheelEvent(-turn if event.direction == self._sdl.SDL_MOUSEWHEEL_FLIPPED else turn)

    # ---- fingers --------------------------------------------------------------------------------------------------

    def _finger(self, event: Any) -> Iterator[Event]:
        screen, key = event.touchId, (event.touchId, event.fingerId)
        if screen == MADE_FROM_MOUSE or not self._ours(event.windowID):
            return
        if self._sdl.SDL_GetTouchDeviceType(screen) in TRACK_PADS:
            return
        phase = self._phase(event.type)
        if (phase == "began") == (key in self._fingers):
            return  # came down before the window had the focus, or left with it
        width, height = self._size()
        at = Vec2(_finite(event.x) * width, _finite(event.y) * height)
        if phase == "began":
            self._fingers[key] = _least_free(self._fingers.values())
        finger = self._fingers[key]
        if phase == "ended":
            del self._fingers[key]
        yield TouchEvent(finger, phase, at)

    def _phase(self, kind: int) -> Phase:
        if kind == self._sdl.SDL_FINGERDOWN:
            return "began"
        return "moved" if kind == self._sdl.SDL_FINGERMOTION else "ended"

    # ---- game controllers -----------------------------------------------------------------------------------------

    def _pad_added(self, index: int) -> Iterator[Event]:
        sdl = self._sdl
        controller = sdl.SDL_GameControllerOpen(index)
        if not controller:
            return
        instance = sdl.SDL_JoystickInstanceID(sdl.SDL_GameControllerGetJoystick(controller))
        if instance in self._pads:
            sdl.SDL_GameControllerClose(controller)  # one open too many is counted, and would keep it
            return
        number = _least_free(pad for pad, _ in self._pads.values())
        self._pads[instance] = number, controller
        name = (sdl.SDL_GameControllerName(controller) or b"pad").decode("utf-8", "replace")
        yield PadEvent(number, True, name)

    def _pad_removed(self, instance: int) -> Iterator[Event]:
        if instance in self._pads:
            number, controller = self._pads.pop(instance)
            self._sdl.SDL_GameControllerClose(controller)
            yield PadEvent(number, False)

    def _pad_button(self, event: Any) -> Iterator[Event]:
        name = CONTROLLER_BUTTONS.get(event.button)
        if name and event.which in self._pads:
            yield PadButtonEvent(self._pads[event.which][0], name, bool(event.state))

    def _pad_axis(self, event: Any) -> Iterator[Event]:
        name = CONTROLLER_AXES.get(event.axis)
        if name and event.which in self._pads:
            value = max(-1.0, event.value / 32767.0)
            upward = name.endswith("_y")
            yield PadAxisEvent(self._pads[event.which][0], name, 0.0 - value if upward else value)

    # ---- sensors --------------------------------------------------------------------------------------------------

    def _open_sensors(self) -> None:
        sdl = self._sdl
        kinds = {sdl.SDL_SENSOR_ACCEL: "accelerometer", sdl.SDL_SENSOR_GYRO: "gyroscope"}
        for index in range(sdl.SDL_NumSensors()):
            name = kinds.get(sdl.SDL_SensorGetDeviceType(index))
            known = [sensor for sensor, _ in self._sensors.values()]
            sensor = sdl.SDL_SensorOpen(index) if name and name not in known else None
            if name and sensor:
                self._sensors[sdl.SDL_SensorGetInstanceID(sensor)] = name, sensor

    def _sensor(self, event: Any) -> Iterator[Event]:
        if event.which not in self._sensors:
            return
        name, _ = self._sensors[event.which]
        x, y, z = (_finite(value) for value in event.data[:3])
        x, y = self._turned_with_the_screen(x, y)
        if name != "accelerometer":
            yield SensorEvent(name, (x, y, z))
            return
        g = -self._sdl.SDL_STANDARD_GRAVITY  # SDL tells the push that holds the device up; we tell gravity's pull
        reading = (x / g, y / g, z / g)
        if self._reading is None or max(abs(a - b) for a, b in zip(reading, self._reading, strict=True)) > STILL:
            self._reading = reading
            yield TiltEvent(reading)

    def _turned_with_the_screen(self, x: float, y: float) -> tuple[float, float]:
        """A reading along the axes of a panel built to lie wide, as it is along those of the picture on it."""
        sdl = self._sdl
        display = max(0, sdl.SDL_GetWindowDisplayIndex(self._window))
        orientation = sdl.SDL_GetDisplayOrientation(display)
        if orientation == sdl.SDL_ORIENTATION_LANDSCAPE_FLIPPED:
            return -x, -y
        if orientation == sdl.SDL_ORIENTATION_PORTRAIT:
            return y, -x
        if orientation == sdl.SDL_ORIENTATION_PORTRAIT_FLIPPED:
            return -y, x
        return x, y


def _finite(value: float) -> float:
    return float(value) if math.isfinite(value) else 0.0


def _least_free(used: Any) -> int:
    taken = set(used)
    return next(number for number in range(len(taken) + 1) if number not in taken)
