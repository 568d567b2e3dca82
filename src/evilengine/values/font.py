"""Font: one size of a typeface as a picture of all its glyphs, what assets hand to the scene."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from evilengine.values.image import Image

Box = tuple[float, float, float, float]
"""Left, top, right, bottom."""


@dataclass(frozen=True, slots=True)
class Glyph:
    """One character of a Font."""

    advance: float
    """Pixels from this character's pen position to the next one's."""
    box: Box
    """Where its picture goes, in pixels from the pen: x to the right, y down, 0 on the baseline."""
    texture: Box
    """Where its picture is in the font's image, 0..1 from the top left corner."""


def no_kerning(before: str, letter: str) -> float:
    """Every letter as far from the one before it as from any other."""
    return 0.0


@dataclass(frozen=True, slots=True)
class Font:
    """Glyphs of one pixel size, in one image: white, with the shape in alpha, so that any colour can tint it."""

    size: int
    """Nominal height in pixels."""
    ascent: float
    """Pixels from the top of a line to its baseline."""
    line_height: float
    """Pixels from one baseline to the next."""
    image: Image
    glyphs: Mapping[str, Glyph]
    """By character; one that is missing is drawn as U+FFFD, or else as '?'."""
    kerning: Callable[[str, str], float] = no_kerning
    """How many pixels a letter is moved to the right when it comes after another: mostly less than 0."""
