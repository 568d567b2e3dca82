"""Shafts: light that shines on from what is bright, and the shadows that silhouettes throw through the haze."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from evilengine.scene.camera import FARTHEST, Matrix6
from evilengine.values.checks import number
from evilengine.values.colour import WHITE, Colour, ColourLike, to_colour
from evilengine.values.vec2 import Point, Vec2, to_vec2

if TYPE_CHECKING:
    from evilengine import _core


class Shafts:
    """Shafts of light over a layer: what is bright there, or behind, shines on, away from a point; what is dark does
    not. They are drawn between the layer and the next nearer one, which is dark before them.

    >>> game = evil.Game(headless=True)
    >>> moon = game.draw(evil.Circle(1), at=(5, 6), layer=-3, colour="#fff4d8")
    >>> game.layers[-2].shafts.at = (5, 6)
    >>> game.layers[-2].shafts.strength, game.layers[-2].shafts.colour = 0.8, "#ffe8b0"
    """

    __slots__ = ("_at", "_colour", "_reach", "_strength", "_threshold")

    def __init__(self) -> None:
        self._at: Vec2 | None = None
        self._colour = WHITE
        self._strength, self._reach, self._threshold = 1.0, 0.9, 0.5

    @property
    def at(self) -> Vec2 | None:
        """Where they come from, in metres, as a thing of the layer; it may be out of sight. None: there are none."""
        return self._at

    @at.setter
    def at(self, value: Point | None) -> None:
        point = None if value is None else to_vec2(value, "Shafts", "at")
        if point is not None:
            number(max(abs(point.x), abs(point.y)), "Shafts", "at", most=FARTHEST)
        self._at = point

    @property
    def colour(self) -> Colour:
        """Their colour."""
        return self._colour

    @colour.setter
    def colour(self, value: ColourLike) -> None:
        self._colour = to_colour(value, "Shafts", "colour")

    @property
    def strength(self) -> float:
        """How bright they are: 0 to 8, where 1 is as bright as what they come from, were all of it so."""
        return self._strength

    @strength.setter
    def strength(self, value: float) -> None:
        self._strength = number(value, "Shafts", "strength", least=0.0, most=8.0)

    @property
    def reach(self) -> float:
        """How far light comes: the share of its way to the point that a place of the picture sees; 0.05 to 1."""
        return self._reach

    @reach.setter
    def reach(self, value: float) -> None:
        self._reach = number(value, "Shafts", "reach", least=0.05, most=1.0)

    @property
    def threshold(self) -> float:
        """How bright a thing must be to shine: 0 to 0.99, where 1 is white."""
        return self._threshold

    @threshold.setter
    def threshold(self, value: float) -> None:
        self._threshold = number(value, "Shafts", "threshold", least=0.0, most=0.99)

    def __repr__(self) -> str:
        return "<Shafts off>" if self._at is None else f"<Shafts from {tuple(self._at)}, strength {self._strength:g}>"

    def _put(self, core: _core.Scene, layer: int, seen: Matrix6) -> None:
        """Over what the frame has of the layer, whose things are seen through `seen`."""
        if self._at is None or not self._strength:
            return
        a, b, c, d, tx, ty = seen
        x, y = self._at
        place = (a * x + c * y + tx, b * x + d * y + ty)
        core.shafts(layer, *place, self._colour.rgba8, self._strength, self._reach, self._threshold)

    def state(self) -> list[Any]:
        """What a saved game keeps of them."""
        at = None if self._at is None else list(self._at)
        return [at, list(self._colour), self._strength, self._reach, self._threshold]

    @staticmethod
    def read(state: list[Any]) -> Shafts:
        """What `state` gave, checked."""
        read = Shafts()
        read.at, colour, read.strength, read.reach, read.threshold = state
        read.colour = Colour(*colour)
        return read
