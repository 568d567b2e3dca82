"""Text: lines of text on the screen, in logical points: a score, a debug value."""

from __future__ import annotations

from array import array
from collections.abc import Callable
from typing import TYPE_CHECKING, TypeAlias

from evilengine.values.checks import number, one_of
from evilengine.values.colour import BLACK, Colour, ColourLike, to_colour
from evilengine.values.errors import ArgumentError, StaleReferenceError
from evilengine.values.font import Font
from evilengine.values.vec2 import Point, Vec2, to_vec2

if TYPE_CHECKING:
    from evilengine._core import Scene as CoreScene

Fonts: TypeAlias = Callable[[int], tuple[int, Font]]
"""Gives the texture id and the glyphs of a font for a height in real pixels; it keeps what it made."""

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


class Text:
    """A line of text on the screen (or several, with newlines), made by `scene.text` or `game.text`.

    `at` counts in logical points from the `anchor` of the screen inwards: `anchor="top right", at=(16, 16)` keeps the
    text's own top right corner 16 points from that corner of the screen, whatever the size of either.
    """

    __slots__ = (
        "_alive", "_anchor", "_at", "_boxes", "_colour", "_drawn", "_extent", "_serial", "_size", "_text", "visible",
    )  # fmt: skip

    def __init__(
        self, text: object, at: Point, size: float, colour: ColourLike, anchor: str, visible: bool, serial: int = -1
    ) -> None:
        self._alive = True
        self._serial = serial  # order of creation in its scene, never used again
        self._drawn: tuple[str, int, float] | None = None  # text, font size and alignment that _boxes were made for
        self._boxes = b""
        self._extent = (0.0, 0.0)
        self.text = text
        self.at = at
        self.size = size
        self.colour = colour
        self.anchor = anchor
        self.visible = visible

    @property
    def text(self) -> str:
        """What is shown; set it to anything, numbers too."""
        return self._text

    @text.setter
    def text(self, value: object) -> None:
        self._require_alive()
        self._text = str(value)[:MOST_CHARACTERS]

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
                f"this Text ({self._text[:40]!r}) was destroyed; "
                "keep no reference past destroy(), or ask text.alive first"
            )

    def draw(self, core: CoreScene, fonts: Fonts, screen: tuple[int, int], scale: float) -> None:
        """Put it on top of the collected frame; `screen` in real pixels, `scale` of them a logical point."""
        pixels = min(max(round(self._size * scale), SMALLEST), LARGEST)
        texture, font = fonts(pixels)
        across, down = ANCHORS[self._anchor]
        if self._drawn != (self._text, pixels, across):
            self._boxes, self._extent = layout(font, self._text, across)
            self._drawn = (self._text, pixels, across)
        x = across * screen[0] + (-1 if across == 1.0 else 1) * self._at.x * scale
        y = down * screen[1] + (-1 if down == 1.0 else 1) * self._at.y * scale - down * self._extent[1]
        place = (float(round(x)), float(round(y)))  # whole pixels: the glyphs are as sharp as they were made
        drop = max(1.0, float(round(pixels / 16)))
        shadow = SHADOW.with_alpha(SHADOW.a * self._colour.a)
        core.glyphs(self._boxes, place[0] + drop, place[1] + drop, texture, shadow.rgba8)
        core.glyphs(self._boxes, *place, texture, self._colour.rgba8)

    def __repr__(self) -> str:
        return f"<Text {self._text[:40]!r}{'' if self._alive else ', destroyed'}>"


def layout(font: Font, text: str, across: float) -> tuple[bytes, tuple[float, float]]:
    """Boxes of the glyphs for `_core.Scene.glyphs`, and the text's width and height; all in pixels.

    Each line lies with its part `across` (0..1) left of x = 0; y = 0 is the top of the first line.
    """
    boxes = array("f")
    widest = 0.0
    lines = text.split("\n")
    missing = font.glyphs.get("\ufffd", font.glyphs.get("?"))
    for row, line in enumerate(lines):
        glyphs = [glyph for glyph in (font.glyphs.get(character, missing) for character in line) if glyph is not None]
        width = sum(glyph.advance for glyph in glyphs)
        widest = max(widest, width)
        pen, baseline = -across * width, row * font.line_height + font.ascent
        for glyph in glyphs:
            x, y = round(pen), round(baseline)
            left, top, right, bottom = glyph.box
            if right > left and bottom > top:
                boxes.extend((x + left, y + top, x + right, y + bottom, *glyph.texture))
            pen += glyph.advance
    return boxes.tobytes(), (widest, len(lines) * font.line_height)
