"""Checks at the public door: each returns the value given, in its proper type, or raises an error that names it."""

from __future__ import annotations

import difflib
import functools
import inspect
import math
from collections.abc import Callable, Iterable
from typing import ParamSpec, TypeVar

from evilengine.values.errors import ArgumentError, ArgumentTypeError

P = ParamSpec("P")
R = TypeVar("R")


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
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        try:
            value = float(value.__float__())  # type: ignore[attr-defined]
        except (AttributeError, TypeError, ValueError):
            raise ArgumentTypeError(f"{owner}: {argument}={value!r} must be a number") from None
    try:
        result = float(value)
    except OverflowError:
        result = math.inf
    inside = (
        math.isfinite(result)
        and (above is None or result > above)
        and (least is None or result >= least)
        and (most is None or result <= most)
    )
    if not inside:
        raise error(f"{owner}: {argument}={value!r} must be {_allowed(above, least, most)}")
    return result


def _allowed(above: float | None, least: float | None, most: float | None) -> str:
    parts = []
    if above is not None:
        parts.append(f"more than {above:g}")
    if least is not None:
        parts.append(f"at least {least:g}")
    if most is not None:
        parts.append(f"at most {most:g}")
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


def did_you_mean(word: object, words: Iterable[str]) -> str:
    """'; did you mean ...?' when one of `words` is near, else nothing."""
    near = difflib.get_close_matches(str(word), list(words), n=1, cutoff=0.6)
    return f"; did you mean {near[0]!r}?" if near else ""


def known_keywords(function: Callable[P, R]) -> Callable[P, R]:
    """Make an unknown keyword argument an error of ours, with the nearest known one."""
    parameters = inspect.signature(function).parameters.values()
    known = {p.name for p in parameters if p.kind in (p.KEYWORD_ONLY, p.POSITIONAL_OR_KEYWORD)}
    name = function.__qualname__.removesuffix(".__init__").removesuffix(".__new__")

    @functools.wraps(function)
    def checked(*args: P.args, **kwargs: P.kwargs) -> R:
        if not kwargs.keys() <= known:
            word = next(key for key in kwargs if key not in known)
            raise ArgumentTypeError(
                f"{name}() got an unknown argument {word}={kwargs[word]!r}{did_you_mean(word, known - {'self'})}"
                f"; it takes {', '.join(sorted(known - {'self'}))}"
            )
        return function(*args, **kwargs)

    return checked
