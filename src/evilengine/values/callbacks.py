"""Callbacks: the functions to call when something happens."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterable, Iterator
from typing import Any, Generic, ParamSpec, TypeVar

from evilengine.values.errors import ArgumentTypeError

P = ParamSpec("P")
F = TypeVar("F", bound=Callable[..., Any])


class Callbacks(Generic[P]):
    """Functions to call when something happens, in the order they were added. Calling it with a function adds that one.

    >>> on_score = Callbacks[[int]]("on_score", "points")
    >>> @on_score
    ... def cheer(points):
    ...     print("points:", points)
    >>> on_score.run(3)
    points: 3
    """

    __slots__ = ("_arguments", "_functions", "_owner")

    def __init__(self, owner: str, *arguments: str) -> None:
        self._owner = owner
        self._arguments = arguments
        self._functions: list[Callable[..., Any]] = []

    def __call__(self, function: F) -> F:
        """Add `function`, which must take the arguments that will come, and return it: this works as a decorator."""
        taken = f"must be a function that takes ({', '.join(self._arguments)})"
        if not callable(function):
            raise ArgumentTypeError(f"{self._owner}: {function!r} {taken}")
        try:
            signature = inspect.signature(function)
        except ValueError:  # some built-in functions do not tell
            pass
        else:
            try:
                signature.bind(*self._arguments)
            except TypeError:
                name = getattr(function, "__qualname__", repr(function))
                raise ArgumentTypeError(f"{self._owner}: {name}{signature} {taken}") from None
        self._functions.append(function)
        return function

    def remove(self, function: Callable[..., Any]) -> None:
        """Do not call `function` any more. Removing what was not added does nothing."""
        if function in self._functions:
            self._functions.remove(function)

    def become(self, functions: Iterable[Callable[..., Any]]) -> None:
        """Call these from now on, which were among them before, and no others."""
        self._functions = list(functions)

    def __len__(self) -> int:
        """How many functions will be called."""
        return len(self._functions)

    def __iter__(self) -> Iterator[Callable[..., Any]]:
        """The functions that will be called, in their order."""
        return iter(tuple(self._functions))

    def run(self, *args: P.args, **kwargs: P.kwargs) -> None:
        """Call them. One that is removed meanwhile is not called, one that is added meanwhile is called from next time.

        An exception goes through, and the functions after it are not called this time.
        """
        for function in tuple(self._functions):
            if function in self._functions:
                function(*args, **kwargs)
