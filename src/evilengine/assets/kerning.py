"""Kerning: how much closer some pairs of letters stand, as the typeface's GPOS table says, or its older kern table.

HarfBuzz reads both, with pairs of single letters and of classes. Pillow could do it too, but only where it was built
with Raqm and finds FriBiDi, and then texts would be as wide as the machine has it.
"""

from __future__ import annotations

import functools
import io
import unicodedata
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from evilengine.values.font import no_kerning

if TYPE_CHECKING:
    from PIL.ImageFont import FreeTypeFont

ALONE = {"liga": False, "clig": False, "calt": False, "ccmp": False}
"""What a typeface does to letters beside each other, other than to move them: each has a picture of its own here."""

MOST_PAIRS = 20_000
"""That are remembered of each size of a typeface."""


def kerning_of(face: FreeTypeFont) -> Callable[[str, str], float]:
    """How many whole pixels a letter is moved to the right after another one: whole ones keep letters sharp.

    Pairs are worked out when they are first asked for. Letters that the typeface lacks, and are put together from
    others, stand as their first part does. Where there is no HarfBuzz, all pairs are alike.
    """
    try:
        import uharfbuzz
    except ImportError:
        return no_kerning
    shaper: Any = uharfbuzz
    font = shaper.Font(shaper.Face(_bytes_of(face)))
    pixels = face.size / font.face.upem

    def width(text: str, kerned: bool) -> int:
        buffer = shaper.Buffer()
        buffer.add_str(text)
        buffer.guess_segment_properties()
        shaper.shape(font, buffer, {**ALONE, "kern": kerned})
        return sum(position.x_advance for position in buffer.glyph_positions)

    @functools.lru_cache(maxsize=MOST_PAIRS)
    def known(letter: str) -> str:
        return letter if font.get_nominal_glyph(ord(letter)) else unicodedata.normalize("NFD", letter)[0]

    @functools.lru_cache(maxsize=MOST_PAIRS)
    def kerning(before: str, letter: str) -> float:
        if before.isspace() or letter.isspace():
            return 0.0
        pair = known(before) + known(letter)
        return float(round((width(pair, True) - width(pair, False)) * pixels))

    return kerning


def _bytes_of(face: FreeTypeFont) -> bytes:
    """The typeface's file."""
    path: Any = face.path
    return path.getvalue() if isinstance(path, io.BytesIO) else Path(path).read_bytes()
