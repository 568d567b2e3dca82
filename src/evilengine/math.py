"""4x4 matrices, one at a time and in batches (SPEC M2, M3).

A matrix is 16 floats of 32 bits, column after column, as the graphics card keeps them. Vectors are columns, so
`a @ b` applies b first. A point (x, y) of the plane stands for the column (x, y, 0, 1).

>>> to_world = Mat4.translation(10, 0) @ Mat4.rotation(0.0) @ Mat4.scale(2)
>>> to_world @ (1, 1)
Vec2(12.0, 2.0)
>>> transform(to_world, [(0, 0), (1, 1)]).tolist()
[[10.0, 0.0], [12.0, 2.0]]
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import NoReturn, TypeAlias, overload

from evilengine import _core
from evilengine.values.checks import known_keywords, number
from evilengine.values.errors import ArgumentError, ArgumentTypeError
from evilengine.values.vec2 import Point, Vec2

Vec4: TypeAlias = tuple[float, float, float, float]
"""A vector (x, y, z, w)."""

__all__ = ["Mat4", "Matrix", "multiply", "transform"]


class Mat4(tuple[float, ...]):
    """A 4x4 matrix: a tuple of 16 numbers, column after column, each rounded to 32 bits.

    `Mat4(values)` takes 16 numbers or the 64 bytes of `tobytes()`; element (row, column) is `m[4 * column + row]`.
    A wrong count, NaN or infinity raises ArgumentError, anything but numbers ArgumentTypeError.

    >>> Mat4.translation(3, 4)[12:14]
    (3.0, 4.0)
    >>> Mat4.identity() == (1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1)
    True
    """

    __slots__ = ()

    @known_keywords
    def __new__(cls, values: Iterable[float] | bytes) -> Mat4:
        return tuple.__new__(cls, _core.mat4(values))

    @classmethod
    def identity(cls) -> Mat4:
        """The matrix that changes nothing.

        >>> Mat4.identity() @ (1, 2)
        Vec2(1.0, 2.0)
        """
        return IDENTITY

    @classmethod
    @known_keywords
    def rotation(cls, angle: float) -> Mat4:
        """A turn round the origin by `angle` radians, counter-clockwise.

        >>> Mat4.rotation(0.5) @ (2, 0) == Vec2(2 * Mat4.rotation(0.5)[0], 2 * Mat4.rotation(0.5)[1])
        True
        """
        return _wrap(_core.mat4_rotation(number(angle, "Mat4.rotation", "angle")))

    @classmethod
    @known_keywords
    def scale(cls, x: float, y: float | None = None) -> Mat4:
        """Stretching by the factors `x` and `y` along the axes; one factor stretches both alike.

        >>> Mat4.scale(2, 3) @ (1, 1)
        Vec2(2.0, 3.0)
        """
        factor = number(x, "Mat4.scale", "x")
        other = factor if y is None else number(y, "Mat4.scale", "y")
        return cls((factor, 0, 0, 0, 0, other, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1))

    @classmethod
    @known_keywords
    def translation(cls, x: float, y: float) -> Mat4:
        """A shift by (x, y) metres.

        >>> Mat4.translation(5, 0) @ (1, 2)
        Vec2(6.0, 2.0)
        """
        x, y = number(x, "Mat4.translation", "x"), number(y, "Mat4.translation", "y")
        return cls((1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, 0, 1))

    @property
    def transposed(self) -> Mat4:
        """Rows as columns.

        >>> Mat4(range(16)).transposed[:4]
        (0.0, 4.0, 8.0, 12.0)
        """
        return _wrap(_core.mat4_transposed(self))

    @property
    def inverse(self) -> Mat4:
        """The matrix that undoes this one. Raises ArgumentError when there is none: nothing undoes a flattening.

        >>> Mat4.scale(2, 4).inverse @ (1, 1)
        Vec2(0.5, 0.25)
        """
        found = _core.mat4_inverse(self)
        if found is None:
            raise ArgumentError(f"{self!r}.inverse: this matrix has none, as its determinant is 0 or nearly")
        return _wrap(found)

    def tobytes(self) -> bytes:
        """The 16 floats as 64 bytes, as a graphics card takes them.

        >>> Mat4(Mat4.scale(3).tobytes()) == Mat4.scale(3)
        True
        """
        return memoryview(_core.multiply(self, IDENTITY)).tobytes()

    @overload
    def __matmul__(self, other: Mat4) -> Mat4: ...  # type: ignore[overload-overlap]
    @overload
    def __matmul__(self, other: Vec4) -> Vec4: ...  # type: ignore[overload-overlap]
    @overload
    def __matmul__(self, other: Point) -> Vec2: ...
    def __matmul__(self, other: object) -> object:
        """Matrix times matrix, point (x, y) or vector (x, y, z, w); of a point's result x and y are given back."""
        if isinstance(other, Mat4):
            return _wrap(_core.mat4_product(self, other))
        return _core.mat4_times(self, other)

    def _no_operator(self, other: object) -> NoReturn:
        """A tuple would join or repeat its numbers."""
        raise ArgumentTypeError("matrices are multiplied with @: a @ b applies b first, m @ point moves a point")

    __add__ = __radd__ = __mul__ = __rmul__ = _no_operator

    def __repr__(self) -> str:
        return f"Mat4({tuple(self)!r})"

    def __reduce__(self) -> tuple[type[Mat4], tuple[tuple[float, ...]]]:
        return Mat4, (tuple(self),)


def _wrap(values: tuple[float, ...]) -> Mat4:
    return tuple.__new__(Mat4, values)


IDENTITY = Mat4((1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1))

Matrix: TypeAlias = Mat4 | Iterable[float]
"""Whatever a function takes for a matrix: a Mat4, or 16 numbers column after column."""


@known_keywords
def transform(matrix: object, points: object) -> memoryview:
    """Many points at once: `matrix @ point` for each, as a new buffer of 32-bit floats with the shape of `points`.

    `points` is any C-contiguous float32 buffer of shape (n, 2), such as `world.bodies.positions` or a NumPy array, or
    of shape (n, 4) for vectors (x, y, z, w); or a list of points. `matrix` is a Mat4, or a float32 buffer of shape
    (n, 16) with a matrix for each point, such as `world.bodies.matrices`. `numpy.asarray(result)` needs no copy.
    Wrong shapes, NaN and infinity raise ArgumentError, wrong types ArgumentTypeError.

    >>> moved = transform(Mat4.translation(1, 0), [(0, 0), (0, 5)])
    >>> moved.shape, moved[1, 0], moved.tolist()
    ((2, 2), 1.0, [[1.0, 0.0], [1.0, 5.0]])
    """
    return _core.transform(matrix, points)


@known_keywords
def multiply(a: object, b: object) -> memoryview:
    """Many products at once: `a @ b` for each pair, as a new float32 buffer of shape (n, 16).

    `a` and `b` are float32 buffers of shape (n, 16), or one Mat4 that goes with all of the other.

    >>> both = multiply(Mat4.translation(1, 0), Mat4.scale(2))
    >>> Mat4(both.tobytes()) == Mat4.translation(1, 0) @ Mat4.scale(2)
    True
    """
    return _core.multiply(a, b)
