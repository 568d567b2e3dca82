"""Two opposite keys, or the two halves of a stick, as one number."""

from __future__ import annotations

from collections.abc import Iterable

from evilengine.values.errors import ArgumentTypeError
from evilengine.values.events import STICK_KEYS, key_name
from evilengine.values.inputs import Inputs, Pad

DEAD_ZONE = 0.2
"""A stick nearer to its middle than this counts as let go; worn sticks rest that far off."""


def axis(inputs: Inputs, negative: str | Iterable[str], positive: str | Iterable[str]) -> float:
    """-1 while `negative` is held, 1 while `positive` is, 0 for none or both; between for a stick pushed partly.

    Each side is a key's name or several. The directions of pads' left sticks are names too: "stick_left",
    "stick_right", "stick_down", "stick_up".

    >>> from evilengine.values.inputs import Keys
    >>> axis(Inputs(keys=Keys(("right",))), ("left", "a", "stick_left"), ("right", "d", "stick_right"))
    1.0
    """
    return _strength(inputs, positive, "positive") - _strength(inputs, negative, "negative")


def _strength(inputs: Inputs, names: str | Iterable[str], argument: str) -> float:
    try:
        each = (names,) if isinstance(names, str) else tuple(names)
    except TypeError:
        raise ArgumentTypeError(f"axis(): {argument}={names!r} must be a key's name, or several in a tuple") from None
    return max((_one(inputs, key_name(name, "axis()", argument)) for name in each), default=0.0)


def _one(inputs: Inputs, name: str) -> float:
    if name in STICK_KEYS:
        return max((stick_strength(pad, name) for pad in inputs.pads), default=0.0)
    return 1.0 if inputs.keys[name] else 0.0


def stick_strength(pad: Pad, name: str) -> float:
    """How far the left stick is pushed the way that `name` says: 0 within the dead zone, 1 at its end."""
    push = {"stick_left": -pad.left.x, "stick_right": pad.left.x, "stick_down": -pad.left.y, "stick_up": pad.left.y}
    return min(1.0, max(0.0, (push[name] - DEAD_ZONE) / (1.0 - DEAD_ZONE)))
