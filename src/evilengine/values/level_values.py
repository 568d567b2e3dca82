"""What the commands of a level speak of: numbers known while it plays, points, names, and values to make."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeAlias


@dataclass(frozen=True, slots=True)
class Place:
    """Where in a level file something is written. Line and column count from 1."""

    line: int
    column: int
    length: int = 1


# Numbers that are known while the level plays ------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Name:
    """The present value of a counter or of a number made by `let`."""

    name: str


@dataclass(frozen=True, slots=True)
class Formula:
    """A function of other numbers: `add`, `random`, `radians`, ... (script/arithmetic.py has them all)."""

    function: str
    arguments: tuple[Number, ...]
    place: Place


Number: TypeAlias = float | Name | Formula


@dataclass(frozen=True, slots=True)
class Pair:
    """A point or a direction."""

    x: Number
    y: Number


@dataclass(frozen=True, slots=True)
class Numbers:
    """Several numbers that belong together."""

    parts: tuple[Number, ...]


@dataclass(frozen=True, slots=True)
class Called:
    """The body, force or text that a level calls by this name; `this` and `other` inside an event."""

    name: str


@dataclass(frozen=True, slots=True)
class Corners:
    """The corners of a polygon or triangle, in the body's own coordinates."""

    points: tuple[Pair, ...]


@dataclass(frozen=True, slots=True)
class Holes:
    """The corners of each hole of a polygon."""

    rings: tuple[Corners, ...]


@dataclass(frozen=True, slots=True)
class Colours:
    """Colours in a row."""

    names: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Area:
    """The edges of an upright rectangle."""

    left: Number
    bottom: Number
    right: Number
    top: Number


Value: TypeAlias = Number | Pair | Numbers | Corners | Holes | Colours | Area | Called | str | bool | int


@dataclass(frozen=True, slots=True)
class Option:
    """`name=value` of a call."""

    name: str
    value: Value


@dataclass(frozen=True, slots=True)
class Make:
    """A value of the engine: `evil.<type>(*arguments, **options)`."""

    type: str
    arguments: tuple[Value, ...] = ()
    options: tuple[Option, ...] = ()


FARTHEST_LIMIT = 100_000.0
"""Radians or metres: the end of a joint's range that a level leaves open."""


@dataclass(frozen=True, slots=True)
class Tagged:
    """Every body that carries this tag, also those made later."""

    tag: str


Target: TypeAlias = Called | Tagged
