"""What an entry of the word tables is: a word, its values and ranges, its meaning and an example."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

LANGUAGE_VERSION = 1

MAX_ROUNDS = 1000  # rounds of one repeat; beyond, a level takes seconds to load
MAX_WORK = 20_000  # statements carried out by nested repeats at once; ten thousand bodies fill a screen many times over
MAX_NESTING = 16  # blocks inside blocks
MOST_COLUMNS = 64  # frames side by side, or one below another, of a sheet: 64 by 64 is as many as a Sheet takes
MOST_BITS = 4_294_967_295.0  # all 32 categories
MAX_CORNERS = 256  # corners of one polygon
MAX_BODIES = 10_000  # bodies that a level keeps alive; `new` does nothing beyond, so a forgotten `every` stays playable
OPPOSITES = {"hidden": "visible", "idle": "running", "out": "on", "noShadows": "shadows"}
"""What a level says of a thing -> the attribute that is the opposite."""
FARTHEST = 100_000.0  # metres from the origin; float32 positions are a centimetre apart there


@dataclass(frozen=True, slots=True)
class Unit:
    """A unit that may follow a number: `value * times / over` of what its dimension is counted in."""

    dimension: str
    times: float = 1.0
    over: float = 1.0


UNITS: Mapping[str, Unit] = {
    "m": Unit("length"),
    "cm": Unit("length", over=100.0),
    "mm": Unit("length", over=1000.0),
    "km": Unit("length", times=1000.0),
    "s": Unit("time"),
    "ms": Unit("time", over=1000.0),
    "min": Unit("time", times=60.0),
    "deg": Unit("angle"),
    "°": Unit("angle"),
    "rad": Unit("angle", times=180.0, over=math.pi),
    "kg": Unit("mass"),
    "g": Unit("mass", over=1000.0),
    "m/s": Unit("speed"),
    "km/h": Unit("speed", over=3.6),
    "deg/s": Unit("spin"),
    "°/s": Unit("spin"),
    "rad/s": Unit("spin", times=180.0, over=math.pi),
}
MEASURES = {
    "length": "metres",
    "time": "seconds",
    "angle": "degrees",
    "mass": "kilograms",
    "speed": "metres a second",
    "spin": "degrees a second",
}


@dataclass(frozen=True, slots=True)
class Range:
    """The numbers that are allowed."""

    least: float | None = None
    most: float | None = None
    above: float | None = None

    def holds(self, value: float) -> bool:
        return (
            math.isfinite(value)
            and (self.least is None or value >= self.least)
            and (self.most is None or value <= self.most)
            and (self.above is None or value > self.above)
        )

    def __str__(self) -> str:
        if self.least is not None and self.most is not None:
            return f"from {plain(self.least)} to {plain(self.most)}"
        if self.above is not None:
            most = f" and at most {plain(self.most)}" if self.most is not None else ""
            return f"more than {plain(self.above)}{most}"
        if self.least is not None:
            return f"{plain(self.least)} or more"
        return f"at most {plain(self.most)}" if self.most is not None else "any number"


def same(*words: str) -> Mapping[str, str]:
    """Choices that the engine calls what a level calls them."""
    return dict(zip(words, words, strict=True))


BLENDS = same("normal", "add", "multiply", "screen")


def plain(value: float) -> str:
    """A number as people write it.

    >>> plain(1e6), plain(0.25)
    ('1000000', '0.25')
    """
    return str(int(value)) if value == int(value) and abs(value) < 1e15 else f"{value:.6g}"


ANY = Range()
PLACE = Range(least=-FARTHEST, most=FARTHEST)
SIZE = Range(least=0.001, most=10_000.0)
FRACTION = Range(least=0.0, most=1.0)
NOT_NEGATIVE = Range(least=0.0, most=1e6)


@dataclass(frozen=True, slots=True, kw_only=True)
class Word:
    """A word with its meaning, an example that is a whole level, and what people write when they mean it."""

    word: str
    doc: str
    example: str
    meant: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class Statement(Word):
    """A word that starts a statement."""

    form: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Size:
    """One number of a kind's fixed size."""

    name: str
    range: Range = SIZE
    measure: str = "length"


@dataclass(frozen=True, slots=True, kw_only=True)
class Kind(Word):
    """Something that `new` makes: numbers or corners, then properties."""

    family: str
    """body, spring, force, drag, medium: which properties it takes."""
    type: str
    """The engine's class."""
    sizes: tuple[Size, ...] = ()
    corners: tuple[int, int] | None = None
    """(fewest, most) corners, for kinds that are a list of points."""
    open: bool = False
    """Its points are a path rather than corners round a shape."""
    shaped: tuple[str, ...] = ()
    """Which properties of shapes it takes."""
    needs: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class Property(Word):
    """A word that follows what is made, with its value."""

    takes: str
    """flag, switch, choice, whole, index, number, angle, length, time, mass, spin, span, sides, point, direction, spot,
    colour, colours, picture, font, tag, name, names, place, corners: what the parser reads and the checker asks of
    it."""
    families: tuple[str, ...]
    option: str = ""
    """The engine's keyword argument."""
    range: Range = ANY
    settable: str = ""
    """The attribute that `set` changes while the level plays; empty when it cannot be changed."""
    part: str = ""
    """Whose it is, if not the thing's as a whole: "drawings" for looks, "shape" for what only some kinds have."""
    measure: str = ""
    """What a span is counted in."""
    choices: Mapping[str, str] | None = None
    """Of a choice: the words that there are, and what the engine calls them."""
    of: tuple[str, ...] = ()
    """Families of what its name may stand for; things, where it says nothing."""
    spellings: tuple[str, ...] = ()
    """Other spellings that mean the same and are no error."""


@dataclass(frozen=True, slots=True)
class Of:
    """Makes the properties of some families.

    >>> Of(("sound",), 'play "thud.ogg" ')("pitch", "number", "How high.", "pitch 0.8").example
    'play "thud.ogg" pitch 0.8;'
    """

    families: tuple[str, ...]
    before: str = ""
    """How their examples begin."""

    def __call__(
        self, word: str, takes: str, doc: str, shown: str = "", *, example: str = "", option: str = "",
        settable: bool | str = False, **more: Any,
    ) -> Property:  # fmt: skip
        """`shown` goes on where their examples begin; `example` is one of its own. The engine's keyword argument is
        `option`, or else the word, and `set` changes the attribute of that name, or the one that `settable` names."""
        keyword = option or word
        attribute = settable if isinstance(settable, str) else keyword if settable else ""
        written = f"{self.before}{shown};" if shown else example
        return Property(
            word=word, takes=takes, doc=doc, families=self.families, example=written, option=keyword,
            settable=attribute, **more,
        )  # fmt: skip
