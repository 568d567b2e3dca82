"""Layers: what lies behind and before the world, and how far off it looks (SPEC G10)."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from evilengine.scene.camera import Matrix6
from evilengine.scene.drawing import to_layer
from evilengine.scene.shafts import Shafts
from evilengine.values.checks import number
from evilengine.values.colour import WHITE, Colour, ColourLike, to_colour
from evilengine.values.errors import ArgumentError
from evilengine.values.vec2 import Vec2

if TYPE_CHECKING:
    from evilengine import _core

Row = tuple[int, Matrix6, int, bool]
"""A layer as the core sees it: number, matrix, tint, visible."""

NEAREST, WIDEST = 100.0, 500.0  # parallax; logical points of blur
DISTANCE = 12.0  # metres from the eye to the world in perspective: some four times as far as things are high


class Layer:
    """How all that is on one layer is seen: `game.layers[-3]` gives it.

    `game.draw`, `game.add` and their kin put things on layers by number; higher ones lie over lower ones, and 0 is the
    world's own.

    >>> game = evil.Game(headless=True)
    >>> hills = game.layers[-2]
    >>> hills.parallax, hills.tint, hills.fog = 0.4, "black", "#8fa3b840"
    >>> game.draw(evil.Circle(3), at=(0, -4), layer=-2).layer
    -2
    >>> hills
    <Layer -2: parallax 0.4, tint #000000, fog #8fa3b840>
    """

    __slots__ = ("_blur", "_fog", "_number", "_parallax", "_tint", "fog_lit", "shafts", "visible")

    def __init__(self, number: int) -> None:
        self._number = number
        self._parallax = 1.0
        self._tint = WHITE
        self._fog: tuple[Colour, ...] = ()
        self._blur = 0.0
        self.shafts = Shafts()
        """Light that shines on through what is before it: `game.layers[-2].shafts.at = (5, 6)`; see Shafts."""
        self.fog_lit = False
        """Do lights fall on its fog? What stands in their way throws its shadow through it then."""
        self.visible = True
        """Is it seen at all?"""

    @property
    def parallax(self) -> float:
        """How much of the camera's motion it makes: 1 moves with the world, 0 stays on the screen, 2 is before it."""
        return self._parallax

    @parallax.setter
    def parallax(self, value: float) -> None:
        self._parallax = number(value, "Layer", "parallax", least=0.0, most=NEAREST)

    @property
    def tint(self) -> Colour:
        """What all its colours are multiplied with; black makes silhouettes of pictures too."""
        return self._tint

    @tint.setter
    def tint(self, value: ColourLike) -> None:
        self._tint = to_colour(value, "Layer", "tint")

    @property
    def fog(self) -> Colour | list[Colour] | None:
        """Fog between it and the next nearer layer: a colour whose alpha is how thick it is, two, of which the first is
        at the picture's bottom and the second at its top, or None."""
        return list(self._fog) if len(self._fog) > 1 else self._fog[0] if self._fog else None

    @fog.setter
    def fog(self, value: ColourLike | list[ColourLike] | None) -> None:
        colours: list[Any] = [] if value is None else value if isinstance(value, list) else [value]
        if len(colours) > 2:
            raise ArgumentError(f"Layer: fog={value!r} must be a colour, or two of them: at the bottom and at the top")
        self._fog = tuple(to_colour(each, "Layer", "fog") for each in colours)

    @property
    def blur(self) -> float:
        """How far it, and all behind it, is out of focus: logical points that a point is spread over; 0 is sharp."""
        return self._blur

    @blur.setter
    def blur(self, value: float) -> None:
        self._blur = number(value, "Layer", "blur", least=0.0, most=WIDEST)

    @property
    def number(self) -> int:
        """Which layer it is."""
        return self._number

    def __repr__(self) -> str:
        fog = ", ".join(each.hex for each in self._fog)
        parts = [
            f"parallax {self._parallax:g}" if self._parallax != 1.0 else "",
            f"tint {self._tint.hex}" if self._tint != WHITE else "",
            f"fog {fog}" if fog else "",
            f"blur {self._blur:g}" if self._blur else "",
            f"shafts from {tuple(self.shafts.at)}" if self.shafts.at is not None else "",
            "" if self.visible else "not visible",
        ]
        return f"<Layer {self._number}: {', '.join(part for part in parts if part) or 'as the world'}>"


class Layers:
    """The layers of a game that are seen in a way of their own, by number. Any number may be asked for."""

    __slots__ = ("_by_number", "_distance", "perspective")

    def __init__(self) -> None:
        self._by_number: dict[int, Layer] = {}
        self._distance = DISTANCE
        self.perspective = False
        """Are layers smaller the farther off they are, as `parallax` says, and zooming in a walk towards them?"""

    def __getitem__(self, which: int) -> Layer:
        which = to_layer(which, "layers[]")
        if which not in self._by_number:
            self._by_number[which] = Layer(which)
            self._by_number = dict(sorted(self._by_number.items()))
        return self._by_number[which]

    def __iter__(self) -> Iterator[Layer]:
        """Those that were asked for, from the deepest on."""
        return iter(tuple(self._by_number.values()))

    def __len__(self) -> int:
        return len(self._by_number)

    @property
    def distance(self) -> float:
        """Metres from the eye to the world in perspective, at zoom 1: what is so far behind it is half as large."""
        return self._distance

    @distance.setter
    def distance(self, value: float) -> None:
        self._distance = number(value, "Layers", "distance", least=0.1, most=1e6)

    def clear(self) -> None:
        """Let every layer be seen as the world is."""
        self._by_number, self.perspective, self._distance = {}, False, DISTANCE

    # What the scene does with them -------------------------------------------------------------------------------

    def rows(self, eye: Vec2, zoom: float) -> list[Row]:
        """What the core is told."""
        return [(layer.number, self.matrix(layer.number, eye, zoom), layer.tint.rgba8, layer.visible) for layer in self]

    def matrix(self, which: int, eye: Vec2, zoom: float) -> Matrix6:
        """Where in the world the things of a layer are seen, from where they are, by a camera that looks at `eye`.

        Parallax p: a step s of the camera moves them by p s on the screen, so they are moved by (1 - p) s in the world.
        In perspective, with the world at a distance of 1 / zoom from the eye, they are 1 / p - 1 behind it, and so much
        smaller, round that point.
        """
        layer = self._by_number.get(which)
        if layer is None or layer.parallax == 1.0:
            return (1.0, 0.0, 0.0, 1.0, 0.0, 0.0)
        part, (x, y) = layer.parallax, eye
        if not self.perspective or not part:
            return (1.0, 0.0, 0.0, 1.0, (1.0 - part) * x, (1.0 - part) * y)
        distance = part + zoom * (1.0 - part)  # times zoom and part
        size = min(part / distance, NEAREST) if distance > 0.0 else NEAREST
        return (size, 0.0, 0.0, size, (1.0 - size) * x, (1.0 - size) * y)

    def view(self, which: int, view: Matrix6, eye: Vec2, zoom: float) -> Matrix6 | None:
        """What `view` is for the things of a layer; None if it is not seen."""
        layer = self._by_number.get(which)
        if layer is None:
            return view
        size, _, _, _, x, y = self.matrix(which, eye, zoom)
        a, b, c, d, tx, ty = view
        place = (a * x + c * y + tx, b * x + d * y + ty)
        return (a * size, b * size, c * size, d * size, *place) if layer.visible else None

    def depth(self, screen: tuple[int, int], zoom: float) -> tuple[float, float, float] | None:
        """Where in the picture all goes that is far off, and one over how far the eye is from the world; None: flat."""
        return (screen[0] / 2, screen[1] / 2, zoom / self._distance) if self.perspective else None

    def cover(
        self, core: _core.Scene, layer: Layer, seen: Matrix6 | None, screen: tuple[int, int], scale: float
    ) -> None:
        """Put its fog over what the frame has of it, and take it out of focus; `seen`: how its things are seen."""
        if layer._blur:
            core.blur(layer.number, layer._blur * scale)
        if seen is not None:
            layer.shafts._put(core, layer.number, seen)
        if layer._fog:
            core.fog(layer.number, layer._fog[-1].rgba8, layer._fog[0].rgba8, *screen, layer.fog_lit)

    # Saving ------------------------------------------------------------------------------------------------------

    def state(self) -> dict[str, Any]:
        """What a saved game keeps of them."""
        rows = [
            [
                each.number, each.parallax, list(each.tint), [list(fog) for fog in each._fog], each.blur, each.visible,
                each.fog_lit, each.shafts.state(),
            ]
            for each in self
        ]  # fmt: skip
        return {"rows": rows, "perspective": self.perspective, "distance": self._distance}

    def read(self, state: dict[str, Any]) -> Layers:
        """Layers as `state` gave them. Raises what is wrong."""
        read = Layers()
        read.perspective, read.distance = bool(state["perspective"]), state["distance"]
        for which, parallax, tint, fog, blur, visible, fog_lit, shafts in state["rows"]:
            layer = read[which]
            layer.parallax, layer.tint, layer.blur = parallax, Colour(*tint), blur
            layer.fog = [Colour(*each) for each in fog]
            layer.visible, layer.fog_lit, layer.shafts = bool(visible), bool(fog_lit), Shafts.read(shafts)
        return read

    def become(self, read: Layers) -> None:
        """Take over what was read; layers that are known stay themselves."""
        self.perspective, self._distance = read.perspective, read._distance
        for layer in self:
            if layer.number not in read._by_number:
                read[layer.number]
        for layer in read:
            mine = self[layer.number]
            for name in Layer.__slots__:
                if name != "_number":
                    setattr(mine, name, getattr(layer, name))


def seen_middle(view: Matrix6, screen: tuple[int, int]) -> Vec2:
    """The point of the world in the middle of a picture that `view` shows."""
    a, b, c, d, tx, ty = view
    turn, x, y = a * d - b * c, screen[0] / 2 - tx, screen[1] / 2 - ty
    return Vec2((d * x - c * y) / turn, (a * y - b * x) / turn)
