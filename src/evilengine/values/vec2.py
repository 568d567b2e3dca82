"""Vec2: a point or direction in the plane (SPEC M1)."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TypeAlias, cast

from evilengine.values.checks import to_float
from evilengine.values.errors import ArgumentError, ArgumentTypeError


class Vec2(tuple[float, float]):
    """A point or direction `(x, y)`: a tuple with vector arithmetic.

    It compares and unpacks like any tuple, so every function that takes a point takes a plain pair as well.
    Adding is vector addition, not joining; multiplying scales.

    >>> Vec2(3, 4) + (1, 0)
    Vec2(4.0, 4.0)
    >>> Vec2(3, 4).length
    5.0
    >>> Vec2(1, 2) == (1, 2)
    True
    """

    __slots__ = ()

    def __new__(cls, x: float = 0.0, y: float = 0.0) -> Vec2:
        try:
            return tuple.__new__(cls, (float(x * 1.0), float(y * 1.0)))  # a string times 1.0 is an error, not a number
        except OverflowError:
            raise ArgumentError(f"Vec2({x!r}, {y!r}): x and y are too large") from None
        except (TypeError, ValueError):
            raise ArgumentTypeError(
                f"Vec2({x!r}, {y!r}): x and y must be numbers; Vec2(*pair) unpacks a pair"
            ) from None

    @property
    def x(self) -> float:
        """The first coordinate; to the right."""
        return self[0]

    @property
    def y(self) -> float:
        """The second coordinate; upwards."""
        return self[1]

    @property
    def length(self) -> float:
        """Distance from the origin."""
        return math.hypot(self[0], self[1])

    @property
    def angle(self) -> float:
        """Direction in radians, counter-clockwise from the x axis, in -pi..pi; 0 for a vector without length.

        >>> Vec2(0, 2).angle == math.pi / 2
        True
        """
        return math.atan2(self[1], self[0])

    @property
    def direction(self) -> Vec2:
        """The vector of length 1 that points the same way; (0, 0) for a vector without length.

        >>> Vec2(0, -3).direction
        Vec2(0.0, -1.0)
        """
        length = self.length
        return Vec2(self[0] / length, self[1] / length) if length > 0.0 else Vec2(0.0, 0.0)

    @property
    def left(self) -> Vec2:
        """This vector turned by +90 degrees.

        >>> Vec2(1, 0).left
        Vec2(0.0, 1.0)
        """
        return Vec2(0.0 - self[1], self[0])

    def dot(self, other: Point) -> float:
        """Scalar product.

        >>> Vec2(1, 2).dot((3, 4))
        11.0
        """
        return self[0] * other[0] + self[1] * other[1]

    def cross(self, other: Point) -> float:
        """Determinant (perpendicular dot): positive when `other` lies to the left.

        >>> Vec2(1, 0).cross((0, 1))
        1.0
        """
        return self[0] * other[1] - self[1] * other[0]

    def turned(self, angle: float) -> Vec2:
        """This vector turned counter-clockwise by `angle` radians.

        >>> Vec2(1, 0).turned(0)
        Vec2(1.0, 0.0)
        """
        c, s = math.cos(angle), math.sin(angle)
        return Vec2(c * self[0] - s * self[1], s * self[0] + c * self[1])

    def __add__(self, other: Point) -> Vec2:  # type: ignore[override]
        return Vec2(self[0] + other[0], self[1] + other[1])

    __radd__ = __add__

    def __sub__(self, other: Point) -> Vec2:
        return Vec2(self[0] - other[0], self[1] - other[1])

    def __rsub__(self, other: Point) -> Vec2:
        return Vec2(other[0] - self[0], other[1] - self[1])

    def __mul__(self, scale: float) -> Vec2:  # type: ignore[override]
        if not isinstance(scale, (int, float)):
            return NotImplemented
        return Vec2(self[0] * scale, self[1] * scale)

    __rmul__ = __mul__  # type: ignore[assignment]

    def __truediv__(self, scale: float) -> Vec2:
        return Vec2(self[0] / scale, self[1] / scale)

    def __neg__(self) -> Vec2:
        return Vec2(-self[0], -self[1])

    def __pos__(self) -> Vec2:
        return self

    def __abs__(self) -> float:
        return self.length

    def __repr__(self) -> str:
        return f"Vec2({self[0]!r}, {self[1]!r})"

    def __reduce__(self) -> tuple[type[Vec2], tuple[float, float]]:
        return Vec2, (self[0], self[1])


Point: TypeAlias = Vec2 | tuple[float, float] | Sequence[float]
"""Whatever a function takes for a point: a Vec2 or any pair of numbers."""


NO_PAIRS = (str, bytes, bytearray, dict, set, frozenset)
"""What can be taken apart into two and is no point all the same."""


def to_vec2(value: object, owner: str, argument: str) -> Vec2:
    """`value` as a finite Vec2, or an error that names `owner` and `argument`.

    >>> to_vec2([1, 2], "Body", "position")
    Vec2(1.0, 2.0)
    """
    if type(value) is Vec2 and math.isfinite(value[0]) and math.isfinite(value[1]):
        return value
    try:
        if isinstance(value, NO_PAIRS):
            raise TypeError
        x, y = cast("tuple[float, float]", value)
        point = Vec2(to_float(x), to_float(y))
    except (TypeError, ValueError):
        raise ArgumentTypeError(
            f"{owner}: {argument}={value!r} must be a point, a pair of numbers such as (0, 1)"
        ) from None
    if not (math.isfinite(point[0]) and math.isfinite(point[1])):
        raise ArgumentError(f"{owner}: {argument}={value!r} must be finite; NaN or infinity came in")
    return point
