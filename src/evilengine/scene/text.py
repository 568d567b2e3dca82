"""Text: lines of text on the screen, in logical points: a score, a debug value."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Protocol, TypeAlias

from evilengine.scene.typeset import Block, Piece, typeset
from evilengine.values.checks import number, one_of
from evilengine.values.colour import BLACK, Colour, ColourLike, to_colour
from evilengine.values.errors import ArgumentError, ArgumentTypeError, StaleReferenceError
from evilengine.values.font import Font
from evilengine.values.vec2 import Point, Vec2, to_vec2

if TYPE_CHECKING:
    from evilengine._core import Scene as CoreScene


class Fonts(Protocol):
    """Who makes fonts for a scene, and keeps what was made."""

    def __call__(self, pixels: int, name: str | None = None, characters: str = "") -> tuple[int, Font]:
        """The texture id and the glyphs of a font, for a height in real pixels: the engine's own, or a file's.

        A font of a file has `characters` and all that it was ever asked for. Raises AssetError if it cannot be had.
        """


Pieces: TypeAlias = "Sequence[str | tuple[str, ColourLike]]"
"""Text in several colours: letters, or letters with a colour."""

SMALLEST, LARGEST = 4, 400  # real pixels: below, nothing can be read; above, the picture of the glyphs grows past 4096
SHADOW = BLACK.with_alpha(0.45)  # under each glyph, so that text can be read on anything
MOST_CHARACTERS = 10_000
FARTHEST = 1e6  # logical points

# For each anchor: which part of the text's width and height lies left of and above the point that it hangs on.
ANCHORS: dict[str, tuple[float, float]] = {
    "top left": (0.0, 0.0),
    "top": (0.5, 0.0),
    "top right": (1.0, 0.0),
    "left": (0.0, 0.5),
    "centre": (0.5, 0.5),
    "right": (1.0, 0.5),
    "bottom left": (0.0, 1.0),
    "bottom": (0.5, 1.0),
    "bottom right": (1.0, 1.0),
}


ALIGNMENTS = {"left": 0.0, "centre": 0.5, "right": 1.0}
"""For each alignment: which part of the room left in a line lies before it."""


class Text:
    """Text on the screen, made by `scene.text` or `game.text`: a line, or several.

    `at` counts in logical points from the `anchor` of the screen inwards: `anchor="top right", at=(16, 16)` keeps the
    text's own top right corner 16 points from that corner of the screen, whatever the size of either. Lines break
    where it says so, and where they would be wider than `width` points; `align` says where they begin.
    """

    __slots__ = (
        *("_align", "_alive", "_anchor", "_at", "_block", "_colour", "_drawn", "_font", "_pieces", "_serial", "_size"),
        *("_width", "visible"),
    )

    def __init__(
        self,
        text: object,
        at: Point,
        size: float,
        colour: ColourLike,
        anchor: str,
        visible: bool,
        serial: int = -1,
        *,
        font: str | None = None,
        width: float | None = None,
        align: str | None = None,
    ) -> None:
        self._alive = True
        self._serial = serial  # order of creation in its scene, never used again
        self._drawn: tuple[Any, ...] | None = None  # what _block was made for
        self._block = Block({}, 0.0, 0.0)
        self.text = text
        self.at = at
        self.size = size
        self.colour = colour
        self.anchor = anchor
        self.font = font
        self.width = width
        self.align = align
        self.visible = visible

    @property
    def text(self) -> str:
        """What is shown; set it to anything, numbers too. A list of pieces has several colours:
        `["You have ", ("10", "gold"), " coins"]`."""
        return "".join(letters for letters, _ in self._pieces)

    @text.setter
    def text(self, value: object) -> None:
        self._require_alive()
        self._pieces = _pieces(value)

    @property
    def at(self) -> Vec2:
        """Logical points from the screen's anchor inwards; from the middle: to the right and down."""
        return self._at

    @at.setter
    def at(self, value: Point) -> None:
        self._require_alive()
        at = to_vec2(value, "Text", "at")
        if max(abs(at.x), abs(at.y)) > FARTHEST:
            raise ArgumentError(f"Text: at={value!r} must be at most {FARTHEST:g} points either way")
        self._at = at

    @property
    def size(self) -> float:
        """Height of the letters in logical points."""
        return self._size

    @size.setter
    def size(self, value: float) -> None:
        self._require_alive()
        self._size = number(value, "Text", "size", least=SMALLEST, most=LARGEST)

    @property
    def colour(self) -> Colour:
        """Colour of the letters."""
        return self._colour

    @colour.setter
    def colour(self, value: ColourLike) -> None:
        self._require_alive()
        self._colour = to_colour(value, "Text", "colour")

    @property
    def anchor(self) -> str:
        """Where on the screen, and which point of the text: "top left", "top", ..., "centre", ..., "bottom right"."""
        return self._anchor

    @anchor.setter
    def anchor(self, value: str) -> None:
        self._require_alive()
        self._anchor = one_of(value, "Text", "anchor", ANCHORS)

    @property
    def font(self) -> str | None:
        """The file of its typeface (.ttf or .otf), found beside the script or level; None: the engine's own."""
        return self._font

    @font.setter
    def font(self, value: str | None) -> None:
        self._require_alive()
        if not (value is None or (isinstance(value, str) and value)):
            raise ArgumentTypeError(f"Text: font={value!r} must be the name of a font file, such as 'title.ttf'")
        self._font = value

    @property
    def width(self) -> float | None:
        """Logical points that a line may be wide; a longer one breaks, at a space if it can. None: no limit."""
        return self._width

    @width.setter
    def width(self, value: float | None) -> None:
        self._require_alive()
        self._width = None if value is None else number(value, "Text", "width", above=0.0, most=FARTHEST)

    @property
    def align(self) -> str | None:
        """Where each line lies: "left", "centre" or "right"; None: as the anchor does."""
        return self._align

    @align.setter
    def align(self, value: str | None) -> None:
        self._require_alive()
        self._align = None if value is None else one_of(value, "Text", "align", ALIGNMENTS)

    @property
    def alive(self) -> bool:
        """False once it was destroyed."""
        return self._alive

    def destroy(self) -> None:
        """Show it no longer."""
        self._require_alive()
        self._alive = False

    def _require_alive(self) -> None:
        if not self._alive:
            raise StaleReferenceError(
                f"this Text ({self.text[:40]!r}) was destroyed; "
                "keep no reference past destroy(), or ask text.alive first"
            )

    def draw(self, core: CoreScene, fonts: Fonts, screen: tuple[int, int], scale: float) -> None:
        """Put it on top of the collected frame; `screen` in real pixels, `scale` of them a logical point."""
        pixels = min(max(round(self._size * scale), SMALLEST), LARGEST)
        texture, font = fonts(pixels) if self._font is None else fonts(pixels, self._font, self.text)
        across, down = ANCHORS[self._anchor]
        drawn = (id(font), self._pieces, pixels, across, self._width, self._align, scale)
        if self._drawn != drawn:
            width = None if self._width is None else self._width * scale
            pieces: list[Piece] = [(letters, place) for place, (letters, _) in enumerate(self._pieces)]
            align = across if self._align is None else ALIGNMENTS[self._align]
            self._block, self._drawn = typeset(font, pieces, across, align=align, width=width), drawn
        x = across * screen[0] + (-1 if across == 1.0 else 1) * self._at.x * scale
        y = down * screen[1] + (-1 if down == 1.0 else 1) * self._at.y * scale - down * self._block.height
        place = (float(round(x)), float(round(y)))  # whole pixels: the glyphs are as sharp as they were made
        drop = max(1.0, float(round(pixels / 16)))
        shadow = SHADOW.with_alpha(SHADOW.a * self._colour.a)
        for boxes in self._block.boxes.values():
            core.glyphs(boxes, place[0] + drop, place[1] + drop, texture, shadow.rgba8)
        for piece, boxes in self._block.boxes.items():
            colour = self._pieces[piece][1] or self._colour
            core.glyphs(boxes, *place, texture, colour.rgba8)

    def __repr__(self) -> str:
        return f"<Text {self.text[:40]!r}{'' if self._alive else ', destroyed'}>"


def _pieces(value: object) -> tuple[tuple[str, Colour | None], ...]:
    """What is shown, and in which colours; None for that of the text."""
    if not isinstance(value, (list, tuple)):
        return ((str(value)[:MOST_CHARACTERS], None),)
    pieces: list[tuple[str, Colour | None]] = []
    for piece in value:
        if isinstance(piece, tuple) and len(piece) == 2:
            letters, colour = piece
            pieces.append((str(letters), None if colour is None else to_colour(colour, "Text", "text")))
        else:
            pieces.append((str(piece), None))
    if sum(len(letters) for letters, _ in pieces) > MOST_CHARACTERS:
        raise ArgumentError(f"Text: text: the pieces have more than {MOST_CHARACTERS} characters")
    return tuple(pieces)
