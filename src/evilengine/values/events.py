"""Events: what a device reports, one frozen value each, in the order it happened.

Positions are in logical points from the top left corner of the window, y downwards; on an ordinary screen a point is a
pixel, on a high-resolution one it is several. A device hands events out by `poll()`; `interaction` gathers them into
`Inputs`.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, TypeAlias

from evilengine.values.checks import did_you_mean
from evilengine.values.errors import ArgumentError
from evilengine.values.vec2 import Vec2

Finger: TypeAlias = int | str
"""Which finger: a small number for one on a touch screen, "mouse" for the mouse with its left button down."""

Phase: TypeAlias = Literal["began", "moved", "ended"]
PHASES: tuple[Phase, ...] = ("began", "moved", "ended")

Reading: TypeAlias = tuple[float, float, float]
"""What an accelerometer reads, in g, seen from the player: x to the right, y up along the screen, z out of the screen.
It points where gravity pulls: upright (0, -1, 0), flat on a table (0, 0, -1), right edge down (1, 0, 0)."""

POINTER_BUTTONS = ("left", "middle", "right", "back", "forward")
PAD_AXES = ("left_x", "left_y", "right_x", "right_y", "left_trigger", "right_trigger")
PAD_BUTTONS = (
    *("a", "b", "x", "y", "back", "guide", "start", "left_stick", "right_stick"),
    *("left_shoulder", "right_shoulder", "up", "down", "left", "right"),
)
SENSORS = ("gyroscope",)

KEYBOARD_KEYS = (
    *"abcdefghijklmnopqrstuvwxyz0123456789",
    *(f"f{number}" for number in range(1, 25)),
    *("left", "right", "up", "down", "space", "enter", "escape", "tab", "backspace"),
    *("insert", "delete", "home", "end", "page_up", "page_down"),
    *("left_shift", "right_shift", "left_ctrl", "right_ctrl", "left_alt", "right_alt", "left_meta", "right_meta"),
    *("caps_lock", "num_lock", "scroll_lock", "print_screen", "pause", "menu"),
    *("minus", "equals", "left_bracket", "right_bracket", "backslash", "semicolon", "quote", "backquote"),
    *("comma", "period", "slash", "less"),
    *(f"keypad_{number}" for number in range(10)),
    *("keypad_enter", "keypad_plus", "keypad_minus", "keypad_times", "keypad_divide", "keypad_period", "back"),
)
PAD_KEYS = tuple(f"pad_{button}" for button in PAD_BUTTONS)
STICK_KEYS = ("stick_left", "stick_right", "stick_down", "stick_up")
KEY_NAMES = KEYBOARD_KEYS + PAD_KEYS + STICK_KEYS
"""Every name that `game.keys`, `game.axis` and key callbacks know. A key is called what is printed on it. A pad's
buttons and the directions of its left stick are keys too ("pad_a", "stick_left"), whichever pad they are on."""

_KEYS = frozenset(KEY_NAMES)


def key_name(value: object, owner: str, argument: str) -> str:
    """`value` if it is the name of a key, else an error with the nearest name.

    >>> key_name("space", "Device.key()", "key")
    'space'
    """
    if isinstance(value, str) and value in _KEYS:
        return value
    raise ArgumentError(
        f"{owner}: {argument}={value!r} is no key's name{did_you_mean(value, KEY_NAMES)}"
        "; names are lower case: 'a', '1', 'left', 'space', 'enter', 'escape', 'f1', 'left_shift', 'pad_a', ..."
    )


@dataclass(frozen=True, slots=True)
class KeyEvent:
    """A key of the keyboard went down or up. Repeats of a held key are not reported."""

    key: str
    """One of KEYBOARD_KEYS."""
    down: bool


@dataclass(frozen=True, slots=True)
class TextEvent:
    """The player typed some characters, as the keyboard's layout makes them."""

    text: str


@dataclass(frozen=True, slots=True)
class PointerEvent:
    """The mouse moved, or one of its buttons went down or up."""

    at: Vec2
    button: str | None = None
    """One of POINTER_BUTTONS; None when it only moved."""
    down: bool = False


@dataclass(frozen=True, slots=True)
class WheelEvent:
    """The mouse wheel turned by notches: y positive away from the player, x positive to the right."""

    turn: Vec2


@dataclass(frozen=True, slots=True)
class TouchEvent:
    """A finger came down, moved or left the screen."""

    finger: Finger
    phase: Phase
    at: Vec2
    cancelled: bool = False
    """True when the device took an "ended" finger away (a call came in), so what it did should not count."""


@dataclass(frozen=True, slots=True)
class TiltEvent:
    """The accelerometer's reading in g; see Reading for its axes."""

    reading: Reading


@dataclass(frozen=True, slots=True)
class SensorEvent:
    """Another sensor's reading, in its own unit: a gyroscope's radians a second round x, y, z."""

    sensor: str
    """One of SENSORS."""
    values: Reading


@dataclass(frozen=True, slots=True)
class PadEvent:
    """A game controller was connected or taken away. Pads are numbered from 0; a free number is used again."""

    pad: int
    connected: bool
    name: str = "pad"


@dataclass(frozen=True, slots=True)
class PadAxisEvent:
    """A stick or trigger moved: sticks -1..1 (x to the right, y up), triggers 0..1."""

    pad: int
    axis: str
    """One of PAD_AXES."""
    value: float


@dataclass(frozen=True, slots=True)
class PadButtonEvent:
    """A button of a game controller went down or up."""

    pad: int
    button: str
    """One of PAD_BUTTONS."""
    down: bool


@dataclass(frozen=True, slots=True)
class ResizeEvent:
    """The window has a new size, or moved to a screen of another resolution."""

    size: tuple[int, int]
    """In logical points."""
    pixel_size: tuple[int, int]
    """In real pixels."""


@dataclass(frozen=True, slots=True)
class FocusEvent:
    """The window got or lost the player's attention. Losing it lets go of every key, button, stick and finger."""

    focused: bool


@dataclass(frozen=True, slots=True)
class CloseEvent:
    """The player wants the window closed."""


Event: TypeAlias = (
    KeyEvent
    | TextEvent
    | PointerEvent
    | WheelEvent
    | TouchEvent
    | TiltEvent
    | SensorEvent
    | PadEvent
    | PadAxisEvent
    | PadButtonEvent
    | ResizeEvent
    | FocusEvent
    | CloseEvent
)
