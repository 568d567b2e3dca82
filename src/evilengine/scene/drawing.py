"""Drawing: the handle of one thing that is drawn (SPEC A5, A6, G13)."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from evilengine.scene.animated import Animated
from evilengine.scene.camera import Matrix6
from evilengine.scene.surface import Surfaced
from evilengine.values.checks import known_keywords, make_up, number, switch
from evilengine.values.colour import BACKGROUND, Colour, ColourLike, to_colour
from evilengine.values.errors import ArgumentError, ArgumentTypeError, StaleReferenceError
from evilengine.values.sheet import Sheet
from evilengine.values.vec2 import Point, to_vec2
from evilengine.world.body import Shape

if TYPE_CHECKING:
    from evilengine.math import Mat4
    from evilengine.scene.scene import Scene
    from evilengine.world.body import Body
    from evilengine.world.shapes import ShapeDefinition

DEEPEST_LAYER = 1_000_000
FARTHEST_BEHIND = 10_000.0  # metres (kDeepest in core/draw/depth.hpp)
OUTLINE = 1.5  # logical points
OUTLINE_SHADE = 0.4  # how much of the night is in an outline's colour


class Drawing(Animated, Surfaced):
    """One thing that is drawn: a shape with a colour, perhaps a texture, on a body or standing by itself.

    `scene.add`, `game.draw` and `body.draw` make them. Once it is destroyed, or the body it is on, every use raises
    StaleReferenceError; `alive` asks first.
    """

    __slots__ = ("__weakref__", "_body", "_generation", "_scene", "_shape", "_slot", "_what")

    def __init__(
        self, scene: Scene, handle: tuple[int, int], body: Body | None, shape: ShapeDefinition | Shape | None
    ) -> None:
        self._scene = scene
        self._slot, self._generation = handle
        self._body = body
        self._shape = shape if isinstance(shape, Shape) else None
        form = shape.definition if isinstance(shape, Shape) else shape
        on = "" if body is None else f" on body {body.tag!r}" if body.tag else f" on body {body.slot}"
        self._what = f"{type(form).__name__ if form is not None else 'Shape'}{on}"

    @property
    def alive(self) -> bool:
        """False once it was destroyed, or the body or shape that it is on."""
        followed = self._body is None or (self._body.alive and (self._shape is None or self._shape.alive))
        return followed and self._scene._core.alive(self._slot, self._generation)

    @property
    def body(self) -> Body | None:
        """The body it is on, or None."""
        self._at()
        return self._body

    @property
    def colour(self) -> Colour:
        """What its corners and texture are multiplied with; set it to any colour. Kept with 8 bits a part."""
        return Colour.of_rgba8(self._scene._core.tint(*self._at()))

    @colour.setter
    def colour(self, value: ColourLike) -> None:
        core, (slot, generation) = self._scene._core, self._at()
        colour = to_colour(value, "Drawing", "colour")
        core.set_tint(slot, generation, colour.rgba8)
        core.set_edge(slot, generation, edge_of(colour).rgba8)

    @property
    def outline(self) -> bool:
        """Whether a thin line, darker than its colour, runs round it."""
        return self._scene._core.edge_width(*self._at()) > 0.0

    @outline.setter
    def outline(self, value: bool) -> None:
        core, (slot, generation) = self._scene._core, self._at()
        core.set_edge(slot, generation, edge_of(self.colour).rgba8)
        core.set_edge_width(slot, generation, OUTLINE if switch(value, "Drawing", "outline") else 0.0)

    @property
    def behind(self) -> float:
        """Metres that it is behind the plane of its layer, or before it (less than 0), where that is in perspective."""
        return self._scene._core.behind(*self._at())

    @behind.setter
    def behind(self, value: float) -> None:
        self._scene._core.set_behind(*self._at(), to_depth(value, 0.0, "Drawing")[0])

    @property
    def depth(self) -> float:
        """Metres that it reaches back in perspective: its sides are seen. 0 is flat, as a picture."""
        return self._scene._core.depth(*self._at())

    @depth.setter
    def depth(self, value: float) -> None:
        self._scene._core.set_depth(*self._at(), to_depth(0.0, value, "Drawing")[1])

    @property
    def texture(self) -> str | Sheet | None:
        """The name of its image, the Sheet that it shows frames of, or None."""
        slot, generation = self._at()
        clip = self._scene._clip_shown(slot, generation)
        if clip is not None:
            return clip.sheet
        return self._scene._name_of(self._scene._core.texture(slot, generation))

    @texture.setter
    def texture(self, value: str | Sheet | None) -> None:
        self._scene._show(self._at(), *self._scene._to_look(value, None, "Drawing"))

    @property
    def texture_matrix(self) -> Mat4:
        """The 4x4 matrix that texture coordinates go through, columns first."""
        return to_mat4(self._scene._core.texture_matrix(*self._at()))

    @texture_matrix.setter
    def texture_matrix(self, value: Iterable[float]) -> None:
        slot, generation = self._at()
        matrix = to_matrix6(value, "Drawing", "texture_matrix")
        self._scene._core.set_texture_matrix(slot, generation, matrix)

    @property
    def matrix(self) -> Mat4:
        """The 4x4 matrix from the drawing to its shape, its body or the world, columns first."""
        return to_mat4(self._scene._core.matrix(*self._at()))

    @matrix.setter
    def matrix(self, value: Iterable[float]) -> None:
        slot, generation = self._at()
        self._scene._core.set_matrix(slot, generation, to_matrix6(value, "Drawing", "matrix"))

    @known_keywords
    def place(self, at: Point, angle: float = 0.0, *, scale: float = 1.0) -> None:
        """Set the matrix from a position, an angle in radians and a scale."""
        slot, generation = self._at()
        self._scene._core.set_matrix(slot, generation, placement(at, angle, "Drawing.place", scale))

    @property
    def layer(self) -> int:
        """Higher layers are drawn over lower ones; within a layer, what was made later is on top."""
        return self._scene._core.layer(*self._at())

    @layer.setter
    def layer(self, value: int) -> None:
        slot, generation = self._at()
        self._scene._core.set_layer(slot, generation, to_layer(value, "Drawing"))

    @property
    def visible(self) -> bool:
        """Whether it is drawn at all."""
        return self._scene._core.visible(*self._at())

    @visible.setter
    def visible(self, value: bool) -> None:
        slot, generation = self._at()
        self._scene._core.set_visible(slot, generation, switch(value, "Drawing", "visible"))

    @property
    def lit(self) -> bool:
        """Whether lights fall on it; without lights it is shown as it is."""
        return self._scene._core.lit(*self._at())

    @lit.setter
    def lit(self, value: bool) -> None:
        slot, generation = self._at()
        self._scene._core.set_lit(slot, generation, switch(value, "Drawing", "lit"))

    def destroy(self) -> None:
        """Draw it no longer; what it was on stays."""
        self._scene._core.remove(*self._at())

    def _at(self) -> tuple[int, int]:
        if not self.alive:
            with_body = self._body is not None and not self._body.alive
            gone = "went with its body" if with_body else "was destroyed"
            raise StaleReferenceError(
                f"this Drawing ({self._what}) {gone}; keep no reference past destroy(), or ask drawing.alive first"
            )
        return self._slot, self._generation

    def _key(self) -> tuple[int, int, int]:
        return id(self._scene), self._slot, self._generation

    def __eq__(self, other: object) -> bool:
        return self._key() == other._key() if isinstance(other, Drawing) else NotImplemented

    def __hash__(self) -> int:
        return hash(self._key())

    def __repr__(self) -> str:
        return f"<Drawing {self._what}{'' if self.alive else ', destroyed'}>"


make_up(Drawing, Animated, Surfaced)


def edge_of(colour: Colour) -> Colour:
    """The colour of the line round a shape."""
    return colour.mixed(BACKGROUND.with_alpha(colour.a), OUTLINE_SHADE)


def placement(at: Point, angle: float, owner: str, scale: float = 1.0) -> Matrix6:
    """The matrix that scales, turns and then moves."""
    x, y = to_vec2(at, owner, "at")
    turn = number(angle, owner, "angle", least=-1e6, most=1e6)
    size = number(scale, owner, "scale", above=0.0, most=1e6)
    c, s = math.cos(turn) * size, math.sin(turn) * size
    return (c, s, -s, c, x, y)


def to_matrix6(value: Any, owner: str, argument: str) -> Matrix6:
    """The plane's share of a 4x4 matrix, which must leave z alone; six numbers a b c d tx ty are taken too."""
    try:
        numbers = [float(each) for each in value]
    except (TypeError, ValueError, OverflowError):
        numbers = []
    if len(numbers) not in (6, 16):
        raise ArgumentTypeError(f"{owner}: {argument}={value!r} must be a 4x4 matrix: 16 numbers, column after column")
    if not all(abs(each) <= 1e30 for each in numbers):
        raise ArgumentError(f"{owner}: {argument}={value!r} must hold finite numbers, at most 1e30")
    if len(numbers) == 16:
        if numbers[3] or numbers[7] or numbers[15] != 1.0:
            raise ArgumentError(f"{owner}: {argument}={value!r} must not bend the plane: its last row is 0 0 0 1")
        numbers = [numbers[i] for i in (0, 1, 4, 5, 12, 13)]
    a, b, c, d, x, y = numbers
    return (a, b, c, d, x, y)


def to_mat4(m: Matrix6) -> Mat4:
    """Six numbers as a 4x4 matrix that leaves z alone."""
    from evilengine.math import Mat4

    a, b, c, d, x, y = m
    return Mat4((a, b, 0.0, 0.0, c, d, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, x, y, 0.0, 1.0))


def to_depth(behind: object, depth: object, owner: str) -> tuple[float, float]:
    """How far behind its layer's plane a thing is, and how far it reaches back; metres."""
    return (
        number(behind, owner, "behind", least=-FARTHEST_BEHIND, most=FARTHEST_BEHIND),
        number(depth, owner, "depth", least=0.0, most=FARTHEST_BEHIND),
    )


def to_layer(value: object, owner: str) -> int:
    """`value` as a layer, a whole number."""
    if isinstance(value, bool) or not isinstance(value, int):
        raise ArgumentTypeError(f"{owner}: layer={value!r} must be a whole number")
    return int(number(value, owner, "layer", least=-DEEPEST_LAYER, most=DEEPEST_LAYER))
