"""The names by which a game's functions come back after a resume."""

from __future__ import annotations

import functools
import sys
from collections.abc import Callable
from types import FunctionType
from typing import Any

from evilengine.values.errors import ArgumentError, ArgumentTypeError, SaveError

MOST_LETTERS = 200


class Functions:
    """Functions by name: those that were registered under one, and those that can be imported by theirs.

    >>> functions = Functions()
    >>> functions.register("ring", print)
    >>> functions.name_of(print, "game.timer"), functions.find("ring") is print
    ('ring', True)

    A name with a colon is that of a module and of a function at its top level. A saved game is a file that anybody may
    have written, so such a name is looked up only in modules that the game itself has imported, and never in Python's
    own: a file cannot make the engine import or call what the game does not know.
    """

    def __init__(self) -> None:
        self._by_name: dict[str, Callable[..., Any]] = {}

    def register(self, name: str, function: Callable[..., Any]) -> None:
        """From now on `function` is saved as `name`, and `name` means `function`."""
        owner = "game.register"
        if not isinstance(name, str):
            raise ArgumentTypeError(f"{owner}: name={name!r} must be a string")
        if not 0 < len(name) <= MOST_LETTERS or ":" in name:
            raise ArgumentError(f"{owner}: name={name!r} must have 1 to {MOST_LETTERS} letters and no colon")
        if not callable(function):
            raise ArgumentTypeError(f"{owner}: {function!r} must be a function")
        self._by_name[name] = function

    def name_of(self, function: Callable[..., Any], where: str) -> str:
        """The name that finds `function` again. Raises SaveError, which says `where` it is used, if none does."""
        for name, known in self._by_name.items():
            if known is function or (hasattr(known, "__self__") and known == function):
                return name
        name = f"{getattr(function, '__module__', None)}:{getattr(function, '__qualname__', None)}"
        if isinstance(function, FunctionType) and _imported(name) is function:
            return name
        raise SaveError(
            f"{where}: {_described(function)} cannot be saved, as no name leads back to it; use a function at the top"
            ' of a module, or give it a name with game.register("name", function)'
        )

    def find(self, name: str) -> Callable[..., Any]:
        """The function of that name. Raises SaveError if there is none."""
        if ":" not in name and name in self._by_name:
            return self._by_name[name]
        found = _imported(name)
        if found is not None:
            return found
        module, _, function = name.partition(":")
        if ":" not in name:
            raise SaveError(
                f"this save needs the function {name!r}; call game.register({name!r}, ...) before game.resume"
            )
        raise SaveError(
            f"this save needs the function {function!r} of the module {module!r}, which is not there; define or import"
            " it before game.resume"
        )


def _imported(name: str) -> FunctionType | None:
    """The function at the top of a module that the game has imported, by "module:function"."""
    module, _, path = name.partition(":")
    if module.partition(".")[0] in sys.stdlib_module_names - {"__main__"} or "<" in path:
        return None
    try:
        found = functools.reduce(getattr, path.split("."), sys.modules[module])
    except (KeyError, AttributeError):
        return None
    return found if isinstance(found, FunctionType) else None


def _described(function: Callable[..., Any]) -> str:
    name = getattr(function, "__qualname__", None)
    module = getattr(function, "__module__", None)
    return f"the function {name} of {module}" if name and module else repr(function)
