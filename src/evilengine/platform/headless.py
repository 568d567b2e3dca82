"""HeadlessDevice: a device without a screen, driven by calls. Tests, films and servers play on it."""

from __future__ import annotations

from evilengine.platform.device import to_picture, to_size
from evilengine.values.checks import known_keywords, number, one_of
from evilengine.values.errors import ArgumentError, ArgumentTypeError, DeviceError
from evilengine.values.events import (
    KEYBOARD_KEYS,
    PAD_AXES,
    PAD_BUTTONS,
    PHASES,
    POINTER_BUTTONS,
    SENSORS,
    CloseEvent,
    Event,
    Finger,
    FocusEvent,
    KeyEvent,
    PadAxisEvent,
    PadButtonEvent,
    PadEvent,
    Phase,
    PointerEvent,
    ResizeEvent,
    SensorEvent,
    TextEvent,
    TiltEvent,
    TouchEvent,
    WheelEvent,
    key_name,
)
from evilengine.values.image import Image
from evilengine.values.surface import Surface
from evilengine.values.vec2 import Point, Vec2, to_vec2

FURTHEST = 1.0e6
"""Points from the corner of the window that a position may be: more is a mistake, and far from overflowing anything."""

SCREEN = (1920, 1080)
"""Points of the screen that it pretends to have."""

MOST_G = 100.0
"""Largest acceleration that a reading may have, in g; the sensors of phones end at 16."""


class HeadlessDevice:
    """A device that exists only in memory: calls stand for what a player would do.

    >>> device = HeadlessDevice((960, 540))
    >>> device.key("left", down=True)
    >>> device.touch(1, "began", at=(480, 270))
    >>> device.poll()[0]
    KeyEvent(key='left', down=True)
    >>> device.touch(2, "moved", at=(0, 0))
    Traceback (most recent call last):
        ...
    evilengine.values.errors.ArgumentError: Device.touch(2, 'moved'): finger 2 is not down; let it begin first

    What cannot happen on a real device is refused: a finger that moves without having come down, a key that does not
    exist, NaN. Pressing a key that is already down does nothing, as with a real key that repeats.
    """

    @known_keywords
    def __init__(self, size: tuple[int, int] = (960, 540), *, title: str = "", scale: float = 1.0) -> None:
        self.title = title
        self.vsync = False
        self.shown: Image | None = None
        """The picture shown last."""
        self._size = to_size(size, "HeadlessDevice")
        self._scale = number(scale, "HeadlessDevice", "scale", least=0.25, most=8)
        self._windowed: tuple[int, int] | None = None  # how large it is when it does not fill the screen
        self._open = True
        self._events: list[Event] = []
        self._fingers: dict[Finger, Vec2] = {}
        self._keys: list[str] = []
        self._buttons: list[str] = []
        self._pads: dict[int, list[str]] = {}
        self._pointer: Vec2 | None = None  # nobody has touched the mouse yet

    @property
    def size(self) -> tuple[int, int]:
        """Width and height in logical points."""
        return self._size

    @property
    def pixel_size(self) -> tuple[int, int]:
        """Width and height in real pixels: the size times the scale."""
        return max(1, round(self._size[0] * self._scale)), max(1, round(self._size[1] * self._scale))

    @property
    def scale(self) -> float:
        """Real pixels a logical point."""
        return self._scale

    @property
    def fullscreen(self) -> bool:
        """Whether it pretends to fill a screen, of 1920 x 1080 points; may be set."""
        return self._windowed is not None

    @fullscreen.setter
    def fullscreen(self, full: bool) -> None:
        self._require_open("Device.fullscreen")
        if full and self._windowed is None:
            self._windowed = self._size
            self.resize(SCREEN)
        elif not full and self._windowed is not None:
            size, self._windowed = self._windowed, None
            self.resize(size)

    @property
    def is_open(self) -> bool:
        """False once `close` was called."""
        return self._open

    @property
    def surface(self) -> Surface | None:
        """None: there is no window."""
        return None

    def poll(self) -> tuple[Event, ...]:
        """What happened since the last call, in order."""
        events = tuple(self._events)
        self._events.clear()
        return events

    def show(self, pixels: object, size: tuple[int, int]) -> None:
        """Keep a copy of the picture in `shown`."""
        flat, (width, height) = to_picture(pixels, size, "Device.show()")
        self.shown = Image.of(width, height, bytes(flat))

    def close(self) -> None:
        """The player closes the window; what happens after this is refused. Closing twice does nothing."""
        if self._open:
            self._open = False
            self._events.append(CloseEvent())

    @known_keywords
    def touch(self, finger: Finger, phase: Phase, at: Point | None = None, *, cancelled: bool = False) -> None:
        """A finger "began", "moved" or "ended" at a point in pixels from the top left corner.

        `finger` is any whole number or name that tells fingers apart. One that ended may leave out `at`: it left where
        it was. `cancelled=True` ends it as a phone does when a call comes in.
        """
        if isinstance(finger, bool) or not isinstance(finger, (int, str)):
            raise ArgumentTypeError(f"Device.touch(): finger={finger!r} must be a whole number or a name")
        if finger == "mouse":
            raise ArgumentError(
                "Device.touch(): finger='mouse' is the mouse; press it with pointer(button='left', ...)"
            )
        one_of(phase, "Device.touch()", "phase", PHASES)
        owner = f"Device.touch({finger!r}, {phase!r})"
        down = finger in self._fingers
        if phase == "began" and down:
            raise ArgumentError(f"{owner}: finger {finger!r} is down already; end it first, or use another number")
        if phase != "began" and not down:
            raise ArgumentError(f"{owner}: finger {finger!r} is not down; let it begin first")
        if cancelled and phase != "ended":
            raise ArgumentError(f"{owner}: only a finger that ended can be cancelled")
        if at is None and phase != "ended":
            raise ArgumentTypeError(f"{owner}: needs at=(x, y), pixels from the top left corner")
        place = self._fingers[finger] if at is None else self._place(at, owner)
        self._report(TouchEvent(finger, phase, place, bool(cancelled)), owner)
        if phase == "ended":
            del self._fingers[finger]
        else:
            self._fingers[finger] = place

    @known_keywords
    def tilt(self, x: float, y: float, z: float = 0.0) -> None:
        """The accelerometer reads (x, y, z) in g: where gravity pulls, x to the right, y up, z out of the screen.

        Upright is (0, -1), flat on a table (0, 0, -1), right edge down (1, 0).
        """
        owner = "Device.tilt()"
        reading = (self._g(x, "x"), self._g(y, "y"), self._g(z, "z"))
        self._report(TiltEvent(reading), owner)

    @known_keywords
    def key(self, key: str, *, down: bool = True) -> None:
        """A key goes down or up; names are those of `game.keys`: "left", "a", "space", ..."""
        owner = "Device.key()"
        key_name(key, owner, "key")
        if key not in KEYBOARD_KEYS:
            raise ArgumentError(f"{owner}: key={key!r} is on a pad; use device.pad(...)")
        if down == (key in self._keys):
            return
        self._report(KeyEvent(key, bool(down)), owner)
        (self._keys.append if down else self._keys.remove)(key)

    @known_keywords
    def tap(self, key: str) -> None:
        """A key goes down and up at once."""
        self.key(key, down=True)
        self.key(key, down=False)

    @known_keywords
    def text(self, text: str) -> None:
        """The player types `text`."""
        if not isinstance(text, str) or not text:
            raise ArgumentTypeError(f"Device.text(): text={text!r} must be a str with at least one character")
        self._report(TextEvent(text), "Device.text()")

    @known_keywords
    def pointer(self, at: Point | None = None, *, button: str | None = None, down: bool | None = None) -> None:
        """The mouse moves to `at`, or presses (down=True) or lets go (down=False) a button where it is or at `at`."""
        owner = "Device.pointer()"
        if at is None and button is None:
            raise ArgumentTypeError(f"{owner}: needs at=(x, y), or button= with down=, or all three")
        if (button is None) != (down is None):
            raise ArgumentTypeError(f"{owner}: button= and down= go together: pointer(button='left', down=True)")
        middle = Vec2(self._size[0] / 2, self._size[1] / 2)
        place = self._place(at, owner) if at is not None else self._pointer or middle
        if button is not None:
            one_of(button, owner, "button", POINTER_BUTTONS)
        if place != self._pointer:
            self._report(PointerEvent(place), owner)
            self._pointer = place
        if button is not None and bool(down) != (button in self._buttons):
            self._report(PointerEvent(place, button, bool(down)), owner)
            (self._buttons.append if down else self._buttons.remove)(button)

    @known_keywords
    def wheel(self, y: float, x: float = 0.0) -> None:
        """The mouse wheel turns by `y` notches, positive away from the player; `x` is for wheels that tilt sideways."""
        owner = "Device.wheel()"
        turn = Vec2(number(x, owner, "x", least=-1000, most=1000), number(y, owner, "y", least=-1000, most=1000))
        self._report(WheelEvent(turn), owner)

    @known_keywords
    def pad(self, control: str, value: float | None = None, *, down: bool | None = None, pad: int = 0) -> None:
        """A game controller's stick or trigger takes a value, or a button goes down or up. It is connected if need be.

        `pad("left_x", 0.5)`, `pad("right_trigger", 1)`, `pad("a", down=True)`; y is up.
        """
        owner = "Device.pad()"
        one_of(control, owner, "control", PAD_AXES + PAD_BUTTONS)
        if control in PAD_AXES:
            if value is None or down is not None:
                raise ArgumentTypeError(f"{owner}: {control!r} moves; give its value: pad({control!r}, 0.5)")
            least = 0.0 if control.endswith("trigger") else -1.0
            amount = number(value, owner, "value", least=least, most=1.0)
            self.plug(pad=pad)
            self._report(PadAxisEvent(pad, control, amount), owner)
            return
        if down is None or value is not None:
            raise ArgumentTypeError(f"{owner}: {control!r} is a button; say pad({control!r}, down=True) or down=False")
        self.plug(pad=pad)
        buttons = self._pads[pad]
        if bool(down) != (control in buttons):
            self._report(PadButtonEvent(pad, control, bool(down)), owner)
            (buttons.append if down else buttons.remove)(control)

    @known_keywords
    def plug(self, *, pad: int = 0, name: str = "pad") -> None:
        """A game controller is connected. One that is there already stays as it is."""
        if isinstance(pad, bool) or not isinstance(pad, int) or not 0 <= pad < 16:
            raise ArgumentError(f"Device.plug(): pad={pad!r} must be a whole number, at least 0 and at most 15")
        if pad not in self._pads:
            self._report(PadEvent(pad, True, str(name)), "Device.plug()")
            self._pads[pad] = []

    @known_keywords
    def unplug(self, *, pad: int = 0) -> None:
        """A game controller is taken away."""
        if pad not in self._pads:
            raise ArgumentError(f"Device.unplug(): pad={pad!r} is not connected; connected are {sorted(self._pads)}")
        self._report(PadEvent(pad, False), "Device.unplug()")
        del self._pads[pad]

    @known_keywords
    def sensor(self, sensor: str, x: float, y: float, z: float) -> None:
        """Another sensor reads (x, y, z): the "gyroscope" in radians a second."""
        owner = "Device.sensor()"
        one_of(sensor, owner, "sensor", SENSORS)
        values = (number(x, owner, "x"), number(y, owner, "y"), number(z, owner, "z"))
        self._report(SensorEvent(sensor, values), owner)

    @known_keywords
    def resize(self, size: tuple[int, int], *, scale: float | None = None) -> None:
        """The window gets another size in points, or moves to a screen with another scale."""
        new = to_size(size, "Device.resize()")
        new_scale = self._scale if scale is None else number(scale, "Device.resize()", "scale", least=0.25, most=8)
        if (new, new_scale) != (self._size, self._scale):
            self._require_open("Device.resize()")
            self._size, self._scale = new, new_scale
            self._events.append(ResizeEvent(new, self.pixel_size))

    @known_keywords
    def focus(self, focused: bool) -> None:
        """The window gets or loses the player's attention; losing it lets go of keys, buttons and fingers."""
        self._report(FocusEvent(bool(focused)), "Device.focus()")
        if not focused:
            self._fingers.clear()
            self._keys.clear()
            self._buttons.clear()
            for buttons in self._pads.values():
                buttons.clear()

    def _report(self, event: Event, owner: str) -> None:
        self._require_open(owner)
        self._events.append(event)

    def _require_open(self, owner: str) -> None:
        if not self._open:
            raise DeviceError(f"{owner}: this device was closed")

    @staticmethod
    def _place(at: Point, owner: str) -> Vec2:
        place = to_vec2(at, owner, "at")
        if max(abs(place.x), abs(place.y)) > FURTHEST:
            raise ArgumentError(f"{owner}: at={at!r} must be within {FURTHEST:g} points of the top left corner")
        return place

    @staticmethod
    def _g(value: float, argument: str) -> float:
        return number(value, "Device.tilt()", argument, least=-MOST_G, most=MOST_G)
