"""The syntax tree: what the parser found, before anyone asked whether it makes sense.

`broken` marks a statement in which an error was already reported: its names still count as made, and nothing more is
said about it, so that one mistake gives one message.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeAlias

from evilengine.values.level import Place


@dataclass(frozen=True, slots=True)
class Literal:
    """A number as written, with its unit ("" for none)."""

    value: float
    unit: str
    place: Place


@dataclass(frozen=True, slots=True)
class Reference:
    """The name of a number inside arithmetic."""

    name: str
    place: Place


@dataclass(frozen=True, slots=True)
class Operation:
    """An operator or function: add, subtract, multiply, divide, remainder, negate, less, ..., random, sin, ..."""

    function: str
    arguments: tuple[Expression, ...]
    place: Place


Expression: TypeAlias = Literal | Reference | Operation


@dataclass(frozen=True, slots=True)
class Text:
    """Something in quotes."""

    value: str
    place: Place


@dataclass(frozen=True, slots=True)
class Identifier:
    """A name outside arithmetic."""

    name: str
    place: Place


@dataclass(frozen=True, slots=True)
class Spot:
    """Two numbers that belong together."""

    x: Expression
    y: Expression
    place: Place


Item: TypeAlias = Expression | Text | Identifier | Spot


@dataclass(frozen=True, slots=True)
class Setting:
    """A property word with its values; `word` is the table's spelling."""

    word: str
    values: tuple[Item, ...]
    place: Place


@dataclass(frozen=True, slots=True)
class New:
    """`kind` is None when nobody could guess what it was meant to be; `drawn` is a picture of it that nothing meets."""

    kind: str | None
    name: Identifier | None
    sizes: tuple[Expression, ...]
    corners: tuple[Spot, ...]
    settings: tuple[Setting, ...]
    place: Place
    broken: bool
    drawn: bool = False


@dataclass(frozen=True, slots=True)
class Picturing:
    """`background` with a colour or a picture, `plane` with a layer, or `lens`."""

    word: str
    what: Item | None
    settings: tuple[Setting, ...]
    place: Place
    broken: bool


@dataclass(frozen=True, slots=True)
class Steering:
    """`drive` with its keys, or `tell` with what it says; `target` is None for `drive off`."""

    word: str
    target: Identifier | None
    keys: tuple[tuple[str, tuple[Text, ...]], ...]
    telling: str
    value: Expression | None
    place: Place
    broken: bool


@dataclass(frozen=True, slots=True)
class Order:
    """A statement that is a word and its values: gravity, view, tilt, background, seed, evil, let, destroy, impulse."""

    word: str
    values: tuple[Item, ...]
    place: Place
    broken: bool


@dataclass(frozen=True, slots=True)
class TextLine:
    name: Identifier | None
    words: Text
    settings: tuple[Setting, ...]
    place: Place
    broken: bool


@dataclass(frozen=True, slots=True)
class Sounding:
    """`play` or `music` with a file; `music off` has none."""

    word: str
    file: Text | None
    settings: tuple[Setting, ...]
    place: Place
    broken: bool


@dataclass(frozen=True, slots=True)
class Change:
    """`set NAME PROPERTY VALUE` or, with the setting None, `set NAME NUMBER`."""

    target: Identifier
    setting: Setting | None
    value: Expression | None
    place: Place
    broken: bool


@dataclass(frozen=True, slots=True)
class Event:
    event: str
    targets: tuple[Identifier | Text, ...]
    block: Block
    place: Place
    broken: bool


@dataclass(frozen=True, slots=True)
class Rounds:
    """after, every and repeat. `amount` is seconds for the first two, rounds for the last."""

    word: str
    amount: Expression | None
    times: Expression | None
    counter: Identifier | None
    block: Block
    place: Place
    broken: bool


@dataclass(frozen=True, slots=True)
class Choice:
    condition: Expression | None
    then: Block
    otherwise: Block
    place: Place
    broken: bool


@dataclass(frozen=True, slots=True)
class Unknown:
    """A statement that starts with no known word; its block, if it has one, is still read."""

    block: Block
    place: Place


StatementNode: TypeAlias = (
    New | Order | Picturing | Steering | TextLine | Sounding | Change | Event | Rounds | Choice | Unknown
)
Block: TypeAlias = tuple[StatementNode, ...]


@dataclass(frozen=True, slots=True)
class Level:
    statements: Block
