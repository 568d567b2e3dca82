"""Inputs: everything the player did, as one frozen value a step. A recording of a game is a list of these."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

from evilengine.values.events import Finger, Phase, Reading, SensorEvent, key_name
from evilengine.values.vec2 import Vec2

DOWN = Vec2(0.0, -1.0)
NOWHERE = Vec2(0.0, 0.0)


@dataclass(frozen=True, slots=True)
class Keys:
    """The keys held now, in the order they went down.

    Ask by name; a name that no key has is an error, so a misspelt one is found at once.

    >>> keys = Keys(("left", "space"))
    >>> keys["left"], keys["right"], list(keys)
    (True, False, ['left', 'space'])
    >>> keys["rihgt"]  # doctest: +ELLIPSIS
    Traceback (most recent call last):
        ...
    evilengine.values.errors.ArgumentError: game.keys: key='rihgt' is no key's name; did you mean 'right'?; ...
    """

    held: tuple[str, ...] = ()

    def __getitem__(self, key: str) -> bool:
        return key_name(key, "game.keys", "key") in self.held

    def __contains__(self, key: object) -> bool:
        return key_name(key, "game.keys", "key") in self.held

    def __iter__(self) -> Iterator[str]:
        return iter(self.held)

    def __len__(self) -> int:
        return len(self.held)


@dataclass(frozen=True, slots=True)
class Touch:
    """A finger on the screen, where it is and where it was.

    In `game.touches` every finger that is down appears once, and one that left during this step once more. Its phase is
    "began" in the step in which it came down, "ended" in the step in which it left, and "moved" in those between, also
    where it rests; then `previous` is where it was a step earlier. A callback gets each event: "began", "moved" when it
    really moved, "ended". The mouse with its left button down is the finger "mouse".

    >>> touch = Touch(1, "moved", Vec2(2, 0), Vec2(1, 0), pixel=Vec2(580, 270), previous_pixel=Vec2(530, 270))
    >>> touch.delta
    Vec2(1.0, 0.0)
    """

    finger: Finger
    phase: Phase
    at: Vec2
    """In the world, metres."""
    previous: Vec2
    """Where it was before, in the world; the same as `at` when it has just come down."""
    pixel: Vec2
    """On the screen: logical points from the top left corner, y downwards."""
    previous_pixel: Vec2
    cancelled: bool = False
    """True on an "ended" touch that the device took away, as when a call comes in: what it did should not count."""

    @property
    def delta(self) -> Vec2:
        """How far it moved in the world since `previous`, metres."""
        return self.at - self.previous


@dataclass(frozen=True, slots=True)
class Pointer:
    """The mouse: where it is, where it was, and its buttons: "left", "middle", "right", "back", "forward"."""

    at: Vec2 = NOWHERE
    """In the world, metres."""
    previous: Vec2 = NOWHERE
    pixel: Vec2 = NOWHERE
    """On the screen: logical points from the top left corner, y downwards."""
    previous_pixel: Vec2 = NOWHERE
    buttons: tuple[str, ...] = ()
    """Buttons held now, in the order they went down."""
    pressed: tuple[str, ...] = ()
    """Buttons that went down in this step."""
    released: tuple[str, ...] = ()
    """Buttons that went up in this step."""


@dataclass(frozen=True, slots=True)
class Pad:
    """A game controller: sticks -1..1 (x to the right, y up), triggers 0..1, and the names of buttons held."""

    number: int
    name: str = "pad"
    left: Vec2 = NOWHERE
    right: Vec2 = NOWHERE
    left_trigger: float = 0.0
    right_trigger: float = 0.0
    buttons: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Tilt:
    """How the device is held, or what stands in for it on a machine without an accelerometer."""

    direction: Vec2 = DOWN
    """Where gravity pulls on the screen: length 1, x to the right, y up. Lying flat keeps the last direction."""
    reading: Reading | None = None
    """The accelerometer's last reading in g, not normalised (see `events.Reading`); None where there is none."""
    changed: bool = False
    """True in a step in which `direction` or `reading` became another."""
    shaken: bool = False
    """True in the step in which a shake of the device was noticed."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Inputs:
    """What the player does during one step: what is held, and what changed since the step before.

    >>> Inputs(keys=Keys(("left",)), pressed=("left",)).keys["left"]
    True
    """

    keys: Keys = field(default_factory=Keys)
    pressed: tuple[str, ...] = ()
    """Keys that went down in this step, in order."""
    released: tuple[str, ...] = ()
    """Keys that went up in this step, in order; one that was only tapped is in both."""
    text: str = ""
    """Characters typed in this step."""
    pointer: Pointer = field(default_factory=Pointer)
    wheel: Vec2 = NOWHERE
    """Notches of the mouse wheel in this step: y positive away from the player, x positive to the right."""
    touches: tuple[Touch, ...] = ()
    """Every finger once, in the order they came down; see Touch."""
    touch_events: tuple[Touch, ...] = ()
    """What the fingers did in this step, in order; callbacks are called with these."""
    tilt: Tilt = field(default_factory=Tilt)
    pads: tuple[Pad, ...] = ()
    """The game controllers connected, by number."""
    sensors: tuple[SensorEvent, ...] = ()
    """The last reading of each further sensor."""
