"""Which names a level knows where: blocks inside blocks, each with its own."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from evilengine.script.arithmetic import UNKNOWN, Bounds
from evilengine.script.syntax import Block, Choice, Event, Identifier, New, Order, Rounds, TextLine, Unknown
from evilengine.script.words import RESERVED, kind_called
from evilengine.values.level import Place

NUMBER = "number"
TEXT = "text"
DRAWING = "drawing"
SOMETHING = "something"  # its statement is broken, or nobody could guess its kind: it may be used for anything


@dataclass(frozen=True, slots=True)
class Made:
    """Something with a name: its family (body, walls, spring, ..., text, number), where it is made, what is known."""

    name: str
    family: str
    place: Place
    bounds: Bounds = UNKNOWN
    """For counters, the values they take."""
    fixed: bool = False
    """For numbers: a counter, which `set` cannot change."""
    still: bool = False
    """For bodies: it stands still for ever."""
    sees: bool = False
    """For bodies: it is a sensor."""


class Names:
    """The names known at one spot of a level, while it is read from top to bottom."""

    def __init__(self, statements: Block) -> None:
        self._scopes: list[dict[str, Made]] = [{}]
        self.everywhere: dict[str, Place] = {}
        """Where each name is made first, whether that is known here or not."""
        self._survey(statements)

    def open(self) -> None:
        self._scopes.append({})

    def close(self) -> None:
        self._scopes.pop()

    def find(self, name: str) -> Made | None:
        for scope in reversed(self._scopes):
            if name in scope:
                return scope[name]
        return None

    def make(self, made: Made) -> None:
        self._scopes[-1][made.name] = made

    def known(self, families: Iterable[str] | None = None) -> list[str]:
        """Names known here, of these families or of all."""
        wanted = None if families is None else set(families)
        found = [made for scope in reversed(self._scopes) for made in scope.values()]
        return [made.name for made in found if wanted is None or made.family in wanted or made.family == SOMETHING]

    @property
    def numbers(self) -> dict[str, Bounds]:
        """The numbers known here."""
        return {made.name: made.bounds for scope in self._scopes for made in scope.values() if made.family == NUMBER}

    def _survey(self, statements: Block) -> None:
        """Note every name that is made, so that an unknown one can be told from one that is known elsewhere."""
        stack = list(reversed(statements))
        while stack:
            statement = stack.pop()
            match statement:
                case New(name=Identifier() as name) | TextLine(name=Identifier() as name):
                    self._note(name)
                case Order(word="let", values=(Identifier() as name, *_)):
                    self._note(name)
                case Rounds(counter=counter, block=block):
                    if counter is not None:
                        self._note(counter)
                    stack.extend(reversed(block))
                case Event(block=block) | Unknown(block=block):
                    stack.extend(reversed(block))
                case Choice(then=then, otherwise=otherwise):
                    stack.extend(reversed(otherwise))
                    stack.extend(reversed(then))
                case _:
                    pass

    def _note(self, name: Identifier) -> None:
        self.everywhere.setdefault(name.name, name.place)


def family_made(statement: New) -> str:
    """The family of what a `new` statement makes, as far as anyone can tell."""
    if statement.kind is None or statement.broken:
        return SOMETHING
    if statement.drawn:
        return DRAWING
    return kind_called(statement.kind).family


def reserved(name: str) -> bool:
    """Whether a name was refused where it was made, so that nothing more need be said about it."""
    return name in RESERVED
