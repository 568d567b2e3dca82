"""What the arithmetic of a level means: its value while the level plays, and the range it can take beforehand.

Everything here gives the same bits on every machine; sine and cosine come from the core for that reason.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass

from evilengine import _core
from evilengine.values.level import Formula, Name, Number, Place

Random = Callable[[float, float], float]


class ArithmeticProblem(Exception):  # noqa: N818 - becomes a diagnostic before anybody sees it
    """Arithmetic that has no result: a division by zero, a root of a negative number."""

    def __init__(self, message: str, place: Place) -> None:
        super().__init__(message)
        self.message = message
        self.place = place


def sine(degrees: float) -> float:
    """Sine of an angle in degrees.

    >>> sine(30)
    0.5
    """
    return float(_core.sincos(math.radians(math.fmod(degrees, 360.0)))[0])


def cosine(degrees: float) -> float:
    """Cosine of an angle in degrees.

    >>> cosine(180)
    -1.0
    """
    return float(_core.sincos(math.radians(math.fmod(degrees, 360.0)))[1])


def _divide(a: float, b: float) -> float:
    if b == 0.0:
        raise ValueError("this divides by 0")
    return a / b


def _remainder(a: float, b: float) -> float:
    if b == 0.0:
        raise ValueError("this divides by 0")
    return a % b


def _root(a: float) -> float:
    if a < 0.0:
        raise ValueError(f"there is no square root of {a:g}")
    return math.sqrt(a)


_FUNCTIONS: Mapping[str, Callable[..., float]] = {
    "add": lambda a, b: a + b,
    "subtract": lambda a, b: a - b,
    "multiply": lambda a, b: a * b,
    "divide": _divide,
    "remainder": _remainder,
    "negate": lambda a: -a,
    "less": lambda a, b: float(a < b),
    "more": lambda a, b: float(a > b),
    "at_most": lambda a, b: float(a <= b),
    "at_least": lambda a, b: float(a >= b),
    "equal": lambda a, b: float(a == b),
    "unequal": lambda a, b: float(a != b),
    "and": lambda a, b: float(a != 0.0 and b != 0.0),
    "or": lambda a, b: float(a != 0.0 or b != 0.0),
    "not": lambda a: float(a == 0.0),
    "sin": sine,
    "cos": cosine,
    "sqrt": _root,
    "abs": abs,
    "min": min,
    "max": max,
    "floor": lambda a: float(math.floor(a)),
    "round": lambda a: float(math.floor(a + 0.5)),
    "radians": math.radians,
}


def evaluate(number: Number, names: Mapping[str, float], random: Random) -> float:
    """The value of `number` now. Raises ArithmeticProblem where there is none."""
    if isinstance(number, Name):
        return names[number.name]
    if not isinstance(number, Formula):
        return number
    if number.function in ("and", "or"):  # the second is looked at only if it matters, as in Python
        first = evaluate(number.arguments[0], names, random)
        if (first != 0.0) == (number.function == "or"):
            return float(first != 0.0)
        return float(evaluate(number.arguments[1], names, random) != 0.0)
    values = [evaluate(each, names, random) for each in number.arguments]
    if number.function == "random":
        return random(*values)
    return _apply(number.function, values, number.place)


def _apply(function: str, values: list[float], place: Place) -> float:
    try:
        result = _FUNCTIONS[function](*values)
    except (ValueError, OverflowError) as error:
        raise ArithmeticProblem(str(error) if isinstance(error, ValueError) else "this is too large", place) from None
    if not math.isfinite(result):
        raise ArithmeticProblem("this number is too large", place)
    return result


def formula(function: str, arguments: tuple[Number, ...], place: Place) -> Number:
    """A formula, or its value when that is known already. Raises ArithmeticProblem where there is none."""
    if function != "random" and all(isinstance(each, float) for each in arguments):
        return _apply(function, [each for each in arguments if isinstance(each, float)], place)
    return Formula(function, arguments, place)


# Ranges --------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Bounds:
    """The values that a number can take, from `low` to `high`; both are really taken when it is `exact`."""

    low: float
    high: float
    exact: bool = True


UNKNOWN = Bounds(-math.inf, math.inf, exact=False)


def bounds(number: Number, names: Mapping[str, Bounds], seen: set[str]) -> Bounds:
    """The bounds of `number`, given those of its names; `seen` collects the names it uses.

    They are exact only if each name is used once and every step is monotone, so that no false alarm is raised.
    """
    if isinstance(number, Name):
        once = number.name not in seen
        seen.add(number.name)
        known = names.get(number.name, UNKNOWN)
        return Bounds(known.low, known.high, known.exact and once)
    if not isinstance(number, Formula):
        return Bounds(number, number)
    parts = [bounds(each, names, seen) for each in number.arguments]
    if not all(part.exact for part in parts):
        return UNKNOWN
    corners = [(part.low, part.high) for part in parts]
    match number.function:
        case "random":
            return Bounds(min(corners[0][0], corners[1][0]), max(corners[0][1], corners[1][1]))
        case "add" | "subtract" | "multiply" | "min" | "max":
            results = [_FUNCTIONS[number.function](a, b) for a in corners[0] for b in corners[1]]
            return Bounds(min(results), max(results))
        case "divide" if corners[1][0] > 0.0 or corners[1][1] < 0.0:
            results = [a / b for a in corners[0] for b in corners[1]]
            return Bounds(min(results), max(results))
        case "negate":
            return Bounds(-corners[0][1], -corners[0][0])
        case "radians" | "floor" | "round":
            one = _FUNCTIONS[number.function]
            return Bounds(one(corners[0][0]), one(corners[0][1]))
        case _:
            return UNKNOWN
