"""Checks at the public door: each returns the value given, in its proper type, or raises an error that names it."""

from __future__ import annotations

import difflib
import functools
import inspect
import math
from collections.abc import Callable, Iterable, Mapping
from typing import NoReturn, ParamSpec, TypeVar

from evilengine.values.errors import ArgumentError, ArgumentTypeError

P = ParamSpec("P")
R = TypeVar("R")


def parts(value: object, owner: str, argument: str = "substeps") -> int:
    """`value` as a number of substeps or threads; raises ArgumentError unless it is a whole number from 1 to 256."""
    if isinstance(value, bool) or not isinstance(value, int) or not 1 <= value <= 256:
        raise ArgumentError(f"{owner}: {argument}={value!r} must be a whole number from 1 to 256")
    return value


def number(
    value: object,
    owner: str,
    argument: str,
    *,
    above: float | None = None,
    least: float | None = None,
    most: float | None = None,
    error: type[ArgumentError] = ArgumentError,
) -> float:
    """`value` as a finite float within the given bounds.

    >>> number(2, "Circle", "radius", above=0)
    2.0
    """
    try:
        result = to_float(value)
    except TypeError:
        raise ArgumentTypeError(f"{owner}: {argument}={value!r} must be a number") from None
    inside = (
        math.isfinite(result)
        and (above is None or result > above)
        and (least is None or result >= least)
        and (most is None or result <= most)
    )
    if not inside:
        raise error(f"{owner}: {argument}={value!r} must be {_allowed(above, least, most)}")
    return result


def to_float(value: object) -> float:
    """`value` as a float, infinite where it is too large for one, or TypeError: True, "1" and None are no numbers.

    >>> to_float(2), to_float(10**400)
    (2.0, inf)
    """
    if isinstance(value, float):
        return float(value)
    if isinstance(value, bool) or not hasattr(value, "__float__"):
        raise TypeError(f"{value!r} is no number")
    try:
        return float(value.__float__())
    except OverflowError:
        return math.inf
    except ValueError as problem:  # an array of several
        raise TypeError(str(problem)) from None


def _allowed(above: float | None, least: float | None, most: float | None) -> str:
    parts = []
    if above is not None:
        parts.append(f"more than {above:.10g}")
    if least is not None:
        parts.append(f"at least {least:.10g}")
    if most is not None:
        parts.append(f"at most {most:.10g}")
    return "a finite number" + (", " + " and ".join(parts) if parts else "")


def one_of(value: object, owner: str, argument: str, allowed: Iterable[str]) -> str:
    """`value` if it is one of the words `allowed`, else an error with the nearest of them.

    >>> one_of("static", "Body", "kind", ("dynamic", "static"))
    'static'
    """
    words = list(allowed)
    if isinstance(value, str) and value in words:
        return value
    raise ArgumentError(
        f"{owner}: {argument}={value!r} must be one of {', '.join(map(repr, words))}{did_you_mean(value, words)}"
    )


def switch(value: object, owner: str, argument: str) -> bool:
    """`value` as True or False; words such as "no" are neither.

    >>> switch(1, "Drawing", "lit")
    True
    """
    if value is None or isinstance(value, str):
        raise ArgumentTypeError(f"{owner}: {argument}={value!r} must be True or False")
    return bool(value)


def did_you_mean(word: object, words: Iterable[str]) -> str:
    """'; did you mean ...?' when one of `words` is near, else nothing."""
    near = difflib.get_close_matches(str(word), list(words), n=1, cutoff=0.6)
    return f"; did you mean {near[0]!r}?" if near else ""


def known_keywords(function: Callable[P, R]) -> Callable[P, R]:
    """Make an unknown keyword argument an error of ours, with the nearest known one."""
    parameters = inspect.signature(function).parameters.values()
    known = [
        p.name
        for p in parameters
        if p.kind in (p.KEYWORD_ONLY, p.POSITIONAL_OR_KEYWORD) and p.name not in ("self", "cls")
    ]
    words = frozenset(known)

    @functools.wraps(function)
    def checked(*args: P.args, **kwargs: P.kwargs) -> R:
        try:
            return function(*args, **kwargs)
        except TypeError:  # by an unknown word, before the function began; or one of its own, which goes on
            if kwargs.keys() <= words:
                raise
        name = checked.__qualname__.removesuffix(".__init__").removesuffix(".__new__")
        refuse_unknown(name, known, kwargs)
        raise AssertionError("one of the words was unknown")

    return checked


def make_up(whole: type, *parts: type) -> None:
    """Call the methods of `parts`, of which `whole` is made up, by the name that its users know it by."""
    for part in parts:
        for method in vars(part).values():
            if inspect.isfunction(method):
                for each in (method, inspect.unwrap(method)):
                    each.__qualname__ = f"{whole.__qualname__}.{method.__name__}"


def refuse_unknown(name: str, known: Iterable[str], given: Mapping[str, object]) -> None:
    """Raise the error that names the first word in `given` that `name` does not take; without one, do nothing."""
    words = list(known)
    word = next((word for word in given if word not in words), None)
    if word is not None:
        raise ArgumentTypeError(
            f"{name}() got an unknown argument {word}={given[word]!r}{did_you_mean(word, words)}"
            f"; it takes {', '.join(words)}"
        )


def refuse_call(name: str, known: Iterable[str], args: tuple[object, ...], given: Mapping[str, object]) -> NoReturn:
    """The error for a call of the core that fits none of its forms."""
    words = list(known)
    refuse_unknown(name, words, given)
    count = len(args) + len(given)
    raise ArgumentTypeError(f"{name}() takes {', '.join(words)}; it was called with {count} argument(s)")
