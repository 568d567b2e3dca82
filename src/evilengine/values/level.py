"""What a level script turns into: commands for a game to carry out.

Commands speak the engine's own units and words (metres, radians, `restitution=`), so that carrying one out is a call.
A number in them is a float, or a name or formula whose value is known only while the level plays.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TypeAlias

from evilengine.values.diagnostics import Diagnostic


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
class Called:
    """The body, force or text that a level calls by this name; `this` and `other` inside an event."""

    name: str


@dataclass(frozen=True, slots=True)
class Corners:
    """The corners of a polygon or triangle, in the body's own coordinates."""

    points: tuple[Pair, ...]


@dataclass(frozen=True, slots=True)
class Area:
    """The edges of an upright rectangle."""

    left: Number
    bottom: Number
    right: Number
    top: Number


Value: TypeAlias = Number | Pair | Corners | Area | Called | str | bool | int


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


# Commands ------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class SetGravity:
    place: Place
    gravity: Pair


@dataclass(frozen=True, slots=True)
class SetView:
    """The camera shows an area of this size round the origin, in metres."""

    place: Place
    width: float
    height: float


@dataclass(frozen=True, slots=True)
class SetTilt:
    place: Place
    on: bool


@dataclass(frozen=True, slots=True)
class SetBackground:
    """A colour, or a picture's file name."""

    place: Place
    what: str


@dataclass(frozen=True, slots=True)
class SetSeed:
    place: Place
    seed: int


@dataclass(frozen=True, slots=True)
class AddBody:
    """A body made of `shapes`; `options` go to `game.add`."""

    place: Place
    name: str
    shapes: tuple[Make, ...]
    options: tuple[Option, ...]


@dataclass(frozen=True, slots=True)
class AddDrawing:
    """A shape that is seen and nothing else; `options` go to `game.draw`."""

    place: Place
    name: str
    shape: Make
    options: tuple[Option, ...]


@dataclass(frozen=True, slots=True)
class AddForce:
    """A force on `bodies`; on none of them, on the whole world."""

    place: Place
    name: str
    force: Make
    bodies: tuple[Called, ...] = ()


@dataclass(frozen=True, slots=True)
class AddJoint:
    """A joint between the two bodies that its first arguments call."""

    place: Place
    name: str
    joint: Make


@dataclass(frozen=True, slots=True)
class AddText:
    """A line of text at a point of the screen; `pieces` alternate between fixed text and numbers."""

    place: Place
    name: str
    pieces: tuple[str | Number, ...]
    options: tuple[Option, ...]


@dataclass(frozen=True, slots=True)
class PlaySound:
    """Plays a sound file; nothing, when what it is heard from is gone."""

    place: Place
    file: str
    options: tuple[Option, ...]


@dataclass(frozen=True, slots=True)
class PlayMusic:
    """Plays music, or none ("")."""

    place: Place
    file: str
    options: tuple[Option, ...]


@dataclass(frozen=True, slots=True)
class Go:
    """Begins another level; this one again (""), when the step is over."""

    place: Place
    file: str


@dataclass(frozen=True, slots=True)
class SetPace:
    """How fast time goes: below 1 is slow motion."""

    place: Place
    pace: Number


@dataclass(frozen=True, slots=True)
class Let:
    """Makes a number that the level can change."""

    place: Place
    name: str
    value: Number


@dataclass(frozen=True, slots=True)
class SetNumber:
    place: Place
    name: str
    value: Number


@dataclass(frozen=True, slots=True)
class SetProperty:
    """Changes `property` of what is called `target`, or of its drawings; nothing, when that is gone."""

    place: Place
    target: Called
    property: str
    value: Value
    of_drawings: bool = False


@dataclass(frozen=True, slots=True)
class Destroy:
    """Destroys what is called `target`; nothing, when that is gone."""

    place: Place
    target: Called


@dataclass(frozen=True, slots=True)
class Impulse:
    place: Place
    target: Called
    impulse: Pair


@dataclass(frozen=True, slots=True)
class OnContact:
    """When contact of `first` with `second` (None: with anything) begins, or ends."""

    place: Place
    begins: bool
    first: Target
    second: Target | None
    block: Block


@dataclass(frozen=True, slots=True)
class OnTouch:
    """When a finger presses `first` (None: anything, or nothing)."""

    place: Place
    first: Target | None
    block: Block


@dataclass(frozen=True, slots=True)
class OnKey:
    place: Place
    key: str
    block: Block


@dataclass(frozen=True, slots=True)
class OnShake:
    place: Place
    block: Block


@dataclass(frozen=True, slots=True)
class After:
    place: Place
    seconds: Number
    block: Block


@dataclass(frozen=True, slots=True)
class Every:
    """A round each `seconds`, `times` rounds (None: without end); `counter` is 1 in the first."""

    place: Place
    seconds: Number
    times: Number | None
    counter: str
    block: Block


@dataclass(frozen=True, slots=True)
class Repeat:
    place: Place
    times: Number
    counter: str
    block: Block


@dataclass(frozen=True, slots=True)
class If:
    place: Place
    condition: Number
    then: Block
    otherwise: Block


Command: TypeAlias = (
    SetGravity
    | SetView
    | SetTilt
    | SetBackground
    | SetSeed
    | AddBody
    | AddDrawing
    | AddForce
    | AddJoint
    | AddText
    | PlaySound
    | PlayMusic
    | Go
    | SetPace
    | Let
    | SetNumber
    | SetProperty
    | Destroy
    | Impulse
    | OnContact
    | OnTouch
    | OnKey
    | OnShake
    | After
    | Every
    | Repeat
    | If
)
Block: TypeAlias = tuple[Command, ...]


@dataclass(frozen=True, slots=True)
class LevelScript:
    """A level without errors, ready to be carried out. `folder` is where its pictures are found ("" for none)."""

    file: str
    folder: str
    commands: Block
    version: int = 1
    lines: tuple[str, ...] = ()
    """The source, for showing where something went wrong while the level plays."""

    @property
    def text(self) -> str:
        """The source, from which the same commands are read again."""
        return "\n".join(self.lines)

    @property
    def numbered(self) -> tuple[Command, ...]:
        """Every command, those in blocks too, in the order in which they are written."""
        return tuple(_walk(self.commands))

    def diagnostic(self, code: str, message: str, place: Place, suggestion: str = "") -> Diagnostic:
        """A diagnostic at `place` of this level."""
        source = self.lines[place.line - 1] if 0 < place.line <= len(self.lines) else ""
        return Diagnostic(code, message, self.file, place.line, place.column, place.length, suggestion, source)


def _walk(block: Block) -> Iterator[Command]:
    for command in block:
        yield command
        for inner in ("block", "then", "otherwise"):
            yield from _walk(getattr(command, inner, ()))
