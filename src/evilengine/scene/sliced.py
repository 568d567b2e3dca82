"""Pictures that fill more than their own size: with borders that keep their width, or laid like tiles."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from evilengine.scene.camera import POINTS_A_METRE, Matrix6
from evilengine.scene.drawing import to_mat4, to_matrix6
from evilengine.values.checks import number
from evilengine.values.errors import ArgumentError, ArgumentTypeError
from evilengine.values.vec2 import Point, to_vec2
from evilengine.world.body import Shape
from evilengine.world.shapes import Rectangle, ShapeDefinition

Four = tuple[float, float, float, float]
"""Left, low, right, high."""


class Sliced(Rectangle):
    """A rectangle in nine parts: `border` metres wide at its sides, which show `part` (0..1) of the picture each."""

    __slots__ = ("border", "part")
    border: Four
    part: Four

    def __init__(self, width: float, height: float, border: Four, part: Four) -> None:
        super().__init__(width, height)
        self._become(border=border, part=part)


def sliced(shape: ShapeDefinition | Shape, slices: Any, image: tuple[float, float], owner: str) -> Sliced:
    """A rectangle as `shape` is one, whose picture, `image` points large, keeps its borders.

    `slices` is one number of points, or left, top, right, bottom. Where they would not fit, they become as small as
    fits.
    """
    form = shape.definition if isinstance(shape, Shape) else shape
    if not isinstance(form, Rectangle):
        raise ArgumentError(f"{owner}: slice={slices!r} is for a Rectangle, not for {form!r}, which has no borders")
    width, height = form.width, form.height
    left, top, right, bottom = _borders(slices, owner)
    if left + right >= image[0] or top + bottom >= image[1]:
        raise ArgumentError(
            f"{owner}: slice={slices!r} must leave something in the middle of a picture of"
            f" {image[0]:g} x {image[1]:g} points"
        )
    scale = min(1.0 / POINTS_A_METRE, width / max(left + right, 1e-9), height / max(top + bottom, 1e-9))
    border = (left * scale, bottom * scale, right * scale, top * scale)
    part = (left / image[0], bottom / image[1], right / image[0], top / image[1])
    return Sliced(width, height, border, part)


def on_shape(shape: ShapeDefinition | Shape, place: Matrix6) -> Matrix6:
    """Where what lies so on a shape is on its body."""
    if not isinstance(shape, Shape):
        return place
    return to_matrix6(to_mat4(place) @ shape.matrix, "Scene.add", "matrix")


def _borders(slices: Any, owner: str) -> Four:
    """Left, top, right, bottom in points."""
    sides = tuple(slices) if isinstance(slices, Iterable) else (slices,) * 4
    if len(sides) != 4:
        raise ArgumentTypeError(f"{owner}: slice={slices!r} must be one number, or four: left, top, right, bottom")
    left, top, right, bottom = (number(side, owner, "slice", least=0.0, most=1e5) for side in sides)
    return left, top, right, bottom


def tile_size(tile: float | Point, owner: str) -> tuple[float, float]:
    """Width and height of one tile in metres."""
    if isinstance(tile, (int, float)) and not isinstance(tile, bool):
        width = height = float(tile)
    else:
        width, height = to_vec2(tile, owner, "tile")
    return (
        number(width, owner, "tile", above=0.0, most=1e6),
        number(height, owner, "tile", above=0.0, most=1e6),
    )
