"""Interaction: gathers a device's events between steps, and hands each step what the player does as frozen `Inputs`."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field, replace
from typing import Any, Protocol

from evilengine.interaction.axis import DEAD_ZONE, axis
from evilengine.interaction.tilt import StandIns, Tilting
from evilengine.values.checks import number, one_of
from evilengine.values.events import (
    POINTER_BUTTONS,
    STICK_KEYS,
    Event,
    Finger,
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
    key_name,
)
from evilengine.values.inputs import NOWHERE, Inputs, Keys, Pad, Pointer, Touch
from evilengine.values.vec2 import Vec2, to_vec2

MOUSE: Finger = "mouse"
KEYBOARD = -1  # a source of keys, beside pads 0, 1, ...
STICK_PRESSES, STICK_LETS_GO = 0.5, 0.35  # apart, so that a stick held near one of them does not flicker


class ToWorld(Protocol):
    """Where in the world a point of the screen is, and where it is for a finger that began at another point."""

    def __call__(self, pixel: Vec2, began: Vec2 | None = None) -> Vec2: ...


@dataclass(slots=True)
class _Finger:
    pixel: Vec2
    at: Vec2
    pixel_before: Vec2
    at_before: Vec2
    origin: Vec2
    """Where on the screen it came down."""
    began: bool = True
    ended: bool = False
    cancelled: bool = False


@dataclass(slots=True)
class _Pad:
    name: str
    axes: dict[str, float] = field(default_factory=dict)
    buttons: list[str] = field(default_factory=list)


@dataclass(slots=True)
class _Changes:
    """What happened since the last step, as it is sorted out of the events."""

    to_world: ToWorld
    pressed: list[str] = field(default_factory=list)
    released: list[str] = field(default_factory=list)
    text: str = ""
    buttons_pressed: list[str] = field(default_factory=list)
    buttons_released: list[str] = field(default_factory=list)
    wheel: Vec2 = NOWHERE
    touches: list[Touch] = field(default_factory=list)
    readings: list[Reading] = field(default_factory=list)


class Interaction:
    """What the player holds, and what changed since the last step.

    Call `collect` once a frame and `snapshot` once a step. Changes (a key pressed, a finger that began) go to the first
    step after them: a frame with several steps tells them once, a frame without a step keeps them for later.

    >>> interaction = Interaction()
    >>> interaction.collect([KeyEvent("space", True)])
    >>> [interaction.snapshot(lambda pixel, began=None: pixel).pressed for step in range(2)]
    [('space',), ()]
    """

    def __init__(self) -> None:
        self.tilt_keys = (("left", "a"), ("right", "d"))
        """Keys that turn the tilt left and right where there is no accelerometer."""
        self.stand_ins = True
        """Whether keys, wheel and stick turn the tilt; False for a game that uses them for something else."""
        self._waiting: list[Event] = []
        self._keys: dict[str, list[int]] = {}  # held keys with the sources that hold them
        self._pixel = NOWHERE
        self._pointer: Pointer | None = None  # as the last step saw it
        self._buttons: list[str] = []
        self._fingers: dict[Finger, _Finger] = {}
        self._pads: dict[int, _Pad] = {}
        self._sensors: dict[str, SensorEvent] = {}
        self._tilting = Tilting()

    def collect(self, events: Iterable[Event]) -> None:
        """Take in what a device reported."""
        for event in events:
            only_moves = isinstance(event, PointerEvent) and event.button is None
            if only_moves and self._waiting:
                last = self._waiting[-1]
                if isinstance(last, PointerEvent) and last.button is None:
                    self._waiting.pop()  # a mouse reports up to a thousand moves a second
            self._waiting.append(event)

    def snapshot(self, to_world: ToWorld, dt: float = 1 / 60) -> Inputs:
        """The inputs of a step of `dt` seconds. `to_world` turns points of the screen into points of the world.

        A game that stands still may take a snapshot with dt=0 and ignore it, so that what the player does meanwhile is
        not made up for later.
        """
        for finger in self._fingers.values():
            finger.began, finger.pixel_before, finger.at_before = False, finger.pixel, finger.at
        changes = _Changes(to_world)
        for event in self._waiting:
            self._take(event, changes)
        self._waiting.clear()
        self._pointer = pointer = self._pointer_now(changes)
        inputs = Inputs(
            keys=Keys(tuple(self._keys)),
            pressed=tuple(changes.pressed),
            released=tuple(changes.released),
            text=changes.text,
            pointer=pointer,
            wheel=changes.wheel,
            touches=self._touches_now(to_world),
            touch_events=tuple(changes.touches),
            pads=tuple(_pad_value(number, pad) for number, pad in sorted(self._pads.items())),
            sensors=tuple(self._sensors.values()),
        )
        return replace(inputs, tilt=self._tilting.step(dt, changes.readings, self._stand_ins(inputs)))

    # ---- saving ---------------------------------------------------------------------------------------------------

    def state(self) -> dict[str, Any]:
        """What a saved game keeps: what is held. What waits for the next step is lost, and pads are the device's."""
        fingers = [
            [
                name,
                *map(list, (finger.pixel, finger.at, finger.pixel_before, finger.at_before, finger.origin)),
                finger.began,
            ]
            for name, finger in self._fingers.items()
            if not finger.ended
        ]
        return {
            "keys": list(self._keys),
            "buttons": list(self._buttons),
            "pixel": list(self._pixel),
            "pointer": None if self._pointer is None else [list(self._pointer.at), list(self._pointer.pixel)],
            "fingers": fingers,
            "sensors": [[event.sensor, list(event.values)] for event in self._sensors.values()],
            "tilting": self._tilting.state(),
        }

    def read(self, state: dict[str, Any]) -> Callable[[], None]:
        """Read what `state` gave, and return what puts it in place; nothing changes before that is called.

        The next step lets go of all that was held then, as when the window loses its player: whoever goes on with the
        game holds other things. Pads stay as they are connected now.
        """
        me = "interaction"
        keys = [key_name(key, me, "key") for key in state["keys"]]
        buttons = [one_of(button, me, "button", POINTER_BUTTONS) for button in state["buttons"]]
        pixel = to_vec2(state["pixel"], me, "pixel")
        pointer = None
        if state["pointer"] is not None:
            at, pointer_pixel = (to_vec2(each, me, "pointer") for each in state["pointer"])
            pointer = Pointer(at=at, pixel=pointer_pixel)
        fingers: dict[Finger, _Finger] = {}
        for name, *places, began in state["fingers"]:
            if not isinstance(name, (int, str)):
                raise ValueError("no finger")
            now, at, before, at_before, origin = (to_vec2(each, me, "finger") for each in places)
            fingers[name] = _Finger(now, at, before, at_before, origin, bool(began))
        sensors = {}
        for name, (x, y, z) in state["sensors"]:
            reading = number(x, me, "sensor"), number(y, me, "sensor"), number(z, me, "sensor")
            sensors[str(name)] = SensorEvent(str(name), reading)
        tilting = Tilting.of(state["tilting"])

        def put() -> None:
            self._keys = {key: [KEYBOARD] for key in keys}
            self._buttons, self._pixel, self._pointer = buttons, pixel, pointer
            self._fingers, self._sensors, self._tilting = fingers, sensors, tilting
            self._waiting = [FocusEvent(False)]

        return put

    # ---- one event ------------------------------------------------------------------------------------------------

    def _take(self, event: Event, changes: _Changes) -> None:
        match event:
            case KeyEvent(key, down):
                self._hold(key, KEYBOARD, down, changes)
            case TextEvent(text):
                changes.text += text
            case PointerEvent():
                self._point(event, changes)
            case WheelEvent(turn):
                changes.wheel += turn
            case TouchEvent():
                self._touch(event, changes)
            case TiltEvent(reading):
                changes.readings.append(reading)
            case SensorEvent(sensor):
                self._sensors[sensor] = event
            case PadEvent(pad, connected, name):
                self._let_go_of_pad(pad, changes)
                self._pads.pop(pad, None)
                if connected:
                    self._pads[pad] = _Pad(name)
            case PadAxisEvent(pad, name, value) if pad in self._pads:
                self._pads[pad].axes[name] = value
                self._hold_stick(pad, changes)
            case PadButtonEvent(pad, button, down) if pad in self._pads:
                self._hold(f"pad_{button}", pad, down, changes)
                buttons = [held for held in self._pads[pad].buttons if held != button]
                self._pads[pad].buttons = [*buttons, button] if down else buttons
            case FocusEvent(False):
                self._let_go_of_everything(changes)

    def _hold(self, key: str, source: int, down: bool, changes: _Changes) -> None:
        sources = self._keys.get(key, [])
        if down and source not in sources:
            if not sources:
                changes.pressed.append(key)
            self._keys[key] = [*sources, source]
        elif not down and source in sources:
            sources.remove(source)
            if not sources:
                del self._keys[key]
                changes.released.append(key)

    def _hold_stick(self, number: int, changes: _Changes) -> None:
        x, y = _stick(self._pads[number], "left")
        for key, push in zip(STICK_KEYS, (-x, x, -y, y), strict=True):
            held = number in self._keys.get(key, [])
            self._hold(key, number, push > (STICK_LETS_GO if held else STICK_PRESSES), changes)

    def _point(self, event: PointerEvent, changes: _Changes) -> None:
        self._pixel = event.at
        if MOUSE in self._fingers:
            self._touch(TouchEvent(MOUSE, "moved", event.at), changes)
        if event.button is None or event.down == (event.button in self._buttons):
            return
        (self._buttons.append if event.down else self._buttons.remove)(event.button)
        (changes.buttons_pressed if event.down else changes.buttons_released).append(event.button)
        if event.button == "left":
            self._touch(TouchEvent(MOUSE, "began" if event.down else "ended", event.at), changes)

    def _touch(self, event: TouchEvent, changes: _Changes) -> None:
        finger = self._fingers.get(event.finger)
        down = finger is not None and not finger.ended
        origin = event.at if finger is None or event.phase == "began" else finger.origin
        at = changes.to_world(event.at, origin)
        if event.phase == "began":
            if down:
                self._touch(TouchEvent(event.finger, "ended", self._fingers[event.finger].pixel, True), changes)
            self._fingers.pop(event.finger, None)  # so that the order is that of coming down
            self._fingers[event.finger] = _Finger(event.at, at, event.at, at, event.at)
            changes.touches.append(Touch(event.finger, "began", at, at, event.at, event.at))
        elif finger is not None and down and (event.phase == "ended" or event.at != finger.pixel):
            touch = Touch(event.finger, event.phase, at, finger.at, event.at, finger.pixel, event.cancelled)
            _append_or_merge(changes.touches, touch)
            finger.pixel, finger.at = event.at, at
            finger.ended, finger.cancelled = event.phase == "ended", event.cancelled

    def _let_go_of_pad(self, number: int, changes: _Changes) -> None:
        for key in [key for key, sources in self._keys.items() if number in sources]:
            self._hold(key, number, False, changes)
        if number in self._pads:
            self._pads[number] = _Pad(self._pads[number].name)

    def _let_go_of_everything(self, changes: _Changes) -> None:
        for source in (KEYBOARD, *self._pads):
            self._let_go_of_pad(source, changes)
        for name, finger in list(self._fingers.items()):
            self._touch(TouchEvent(name, "ended", finger.pixel, cancelled=True), changes)
        changes.buttons_released.extend(self._buttons)
        self._buttons.clear()

    # ---- what a step sees -----------------------------------------------------------------------------------------

    def _pointer_now(self, changes: _Changes) -> Pointer:
        at, last = changes.to_world(self._pixel), self._pointer
        return Pointer(
            at=at,
            previous=last.at if last else at,
            pixel=self._pixel,
            previous_pixel=last.pixel if last else self._pixel,
            buttons=tuple(self._buttons),
            pressed=tuple(changes.buttons_pressed),
            released=tuple(changes.buttons_released),
        )

    def _touches_now(self, to_world: ToWorld) -> tuple[Touch, ...]:
        touches = []
        for name, finger in list(self._fingers.items()):
            finger.at = to_world(finger.pixel, finger.origin)  # the camera may have moved under a finger that rests
            phase: Phase = "ended" if finger.ended else "began" if finger.began else "moved"
            before, pixel_before = finger.at_before, finger.pixel_before
            touches.append(Touch(name, phase, finger.at, before, finger.pixel, pixel_before, finger.cancelled))
            if finger.ended:
                del self._fingers[name]
        return tuple(touches)

    def _stand_ins(self, inputs: Inputs) -> StandIns:
        if not self.stand_ins:
            return StandIns()
        pushed = (pad.left for pad in inputs.pads if max(abs(pad.left.x), abs(pad.left.y)) > DEAD_ZONE)
        return StandIns(axis(inputs, *self.tilt_keys), inputs.wheel.y, next(pushed, NOWHERE))


def _append_or_merge(touches: list[Touch], touch: Touch) -> None:
    """Add what a finger did; a move that follows a move of the same finger becomes one with it."""
    for index in range(len(touches) - 1, -1, -1):
        last = touches[index]
        if last.finger == touch.finger:
            if last.phase == touch.phase == "moved":
                touches[index] = replace(touch, previous=last.previous, previous_pixel=last.previous_pixel)
                return
            break
    touches.append(touch)


def _stick(pad: _Pad, side: str) -> Vec2:
    return Vec2(pad.axes.get(f"{side}_x", 0.0), pad.axes.get(f"{side}_y", 0.0))


def _pad_value(number: int, pad: _Pad) -> Pad:
    return Pad(
        number,
        pad.name,
        left=_stick(pad, "left"),
        right=_stick(pad, "right"),
        left_trigger=pad.axes.get("left_trigger", 0.0),
        right_trigger=pad.axes.get("right_trigger", 0.0),
        buttons=tuple(pad.buttons),
    )
