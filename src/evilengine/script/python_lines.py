"""Lines of a Python program, with the names that are known where each stands."""

from __future__ import annotations

import keyword
from abc import abstractmethod
from collections.abc import Iterator
from contextlib import contextmanager

from evilengine.script.blocks import changed, has_tags
from evilengine.script.python_values import PythonValues
from evilengine.values.level import Block, LevelScript

WIDTH = 120  # characters; a longer call is spread over several lines

_TAKEN = {
    "abs", "bool", "build", "character", "contact", "cosine", "drawing", "evil", "game", "int", "key", "map", "max",
    "math", "min", "other", "range", "sine", "speed", "tags", "this", "touch", "visit", "when_met"}  # fmt: skip


class PythonLines(PythonValues):
    """Writes lines, calls and functions; whoever knows the commands says what is in them."""

    def __init__(self, level: LevelScript) -> None:
        self._level = level
        self._lines: list[str] = []
        self._indent = 0
        self._used = set(_TAKEN)
        self._names: list[dict[str, str]] = [{}]
        """What the level calls things -> what Python does, a dictionary for each block."""
        self._sure: list[set[str]] = [set()]
        """Python names of what cannot be gone: made in this function and not destroyed in it."""
        self._maybe: set[str] = set()
        """Python names that are None if what they need was gone."""
        self._cast: set[str] = set()
        """Python names of characters' bodies."""
        self._tags = has_tags(level.commands)
        self._gap = False
        """Whether a blank line belongs here: before and after a function."""

    def _line(self, text: str) -> None:
        if self._gap and self._lines and not self._lines[-1].endswith(":"):
            self._lines.append("")
        self._gap = False
        self._lines.append("    " * self._indent + text)

    @contextmanager
    def _deeper(self) -> Iterator[None]:
        self._indent += 1
        yield
        self._indent -= 1

    @contextmanager
    def _scope(self, **known: str) -> Iterator[None]:
        self._names.append(dict(known))
        yield
        self._names.pop()

    def _fresh(self, wanted: str) -> str:
        """A Python name of its own for everything, so that no closure sees another's value."""
        wanted = wanted.replace(" ", "_")
        name = wanted if wanted.isidentifier() and not keyword.iskeyword(wanted) else f"{wanted}_"
        number = 2
        while name in self._used:
            name = f"{wanted}_{number}"
            number += 1
        self._used.add(name)
        return name

    def _make_name(self, name: str) -> str:
        self._names[-1][name] = self._fresh(name)
        return self._names[-1][name]

    def called(self, name: str) -> str:
        """The Python name of what a level calls `name`."""
        for names in reversed(self._names):
            if name in names:
                return names[name]
        return name

    def _call(self, before: str, function: str, arguments: list[str], after: str = "") -> None:
        """A call on one line, or with a line for each argument; several shapes are a list."""
        line = f"{before}{function}({', '.join(arguments)}){after}"
        if 4 * self._indent + len(line) <= WIDTH:
            self._line(line)
            return
        self._line(f"{before}{function}(")
        with self._deeper():
            for argument in arguments:
                self._line(f"{argument.replace('), evil.', '),' + chr(10) + '    ' * self._indent + ' evil.')},")
        self._line(f"){after}")

    @contextmanager
    def _if_alive(self, *names: str) -> Iterator[None]:
        """What follows happens only if all of these are there; nobody asks where that is sure."""
        unsure = [name for name in names if name not in self._sure[-1]]
        if not unsure:
            yield
            return
        asked = [f"{name} is not None and {name}.alive" if name in self._maybe else f"{name}.alive" for name in unsure]
        self._line(f"if {' and '.join(asked)}:")
        with self._deeper():
            yield

    @contextmanager
    def _as_character(self, name: str) -> Iterator[str]:
        """What follows happens to the character of this body, if it is one; gives how that is written."""
        with self._if_alive(name):
            if name in self._cast:
                yield f"game.world.character_of({name})"
                return
            self._line(f"if character := game.world.character_of({name}):")
            with self._deeper():
                yield "character"

    def _function(self, name: str, arguments: str, block: Block, *, by: str = "", first: str = "") -> None:
        """A function that does what a block says; `by` decorates it, `first` is its first line, or a condition."""
        self._gap = True
        if by:
            self._line(f"@{by}")
        self._line(f"def {name}({arguments}):")
        self._sure.append(set())
        with self._deeper():
            outer = sorted({self.called(each) for each in changed(block)})
            if outer:
                self._line(f"nonlocal {', '.join(outer)}")
            if first.endswith(":"):
                self._line(first)
                with self._deeper():
                    self._inner(block)
            else:
                if first:
                    self._line(first)
                self._inner(block)
        self._sure.pop()
        self._gap = True

    def _inner(self, block: Block) -> None:
        with self._scope():
            self._block(block)
        if not block:
            self._line("pass")

    def _naming(self, name: str) -> str:
        """`name = ` for something that is made here and has a name."""
        if not name:
            return ""
        made = self._make_name(name)
        self._sure[-1].add(made)
        return f"{made} = "

    @abstractmethod
    def _block(self, block: Block) -> None:
        """Write the commands of a block."""
