"""Letters in lines: where each glyph of a text goes, with kerning, wrapping and alignment."""

from __future__ import annotations

from array import array
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from evilengine.values.font import Font, Glyph

Piece = tuple[str, int]
"""Letters, and the number of their colour."""

Line = list[tuple[str, int]]
"""Single letters, each with the number of its colour."""


class Block(NamedTuple):
    """A text that was set: boxes of glyphs for `_core.Scene.glyphs`, by the numbers of their colours, and its size."""

    boxes: dict[int, bytes]
    width: float
    height: float


def typeset(font: Font, pieces: Sequence[Piece], across: float, *, align: float, width: float | None = None) -> Block:
    """Set pieces of text; all lengths are pixels.

    The block lies with its part `across` (0..1) left of x = 0, and y = 0 is the top of its first line. Lines are no
    wider than `width`, if that is given; `align` is 0 for lines that begin together, 1 for lines that end together.
    """
    lines = [line for paragraph in _paragraphs(pieces) for line in _wrapped(font, paragraph, width)]
    widths = [_width(font, line) for line in lines]
    block = max(widths, default=0.0) if width is None else width
    boxes: dict[int, array[float]] = {}
    for row, (line, wide) in enumerate(zip(lines, widths, strict=True)):
        start, baseline = (align - across) * block - align * wide, round(row * font.line_height + font.ascent)
        for (_, colour), glyph, pen in _places(font, line, start):
            left, top, right, bottom = glyph.box
            if right > left and bottom > top:
                x = round(pen)
                of_colour = boxes.setdefault(colour, array("f"))
                of_colour.extend((x + left, baseline + top, x + right, baseline + bottom, *glyph.texture))
    return Block({colour: each.tobytes() for colour, each in boxes.items()}, block, len(lines) * font.line_height)


def layout(font: Font, text: str, across: float = 0.0) -> tuple[bytes, tuple[float, float]]:
    """Text of one colour, each line with its part `across` left of x = 0: boxes of glyphs, width and height."""
    block = typeset(font, [(text, 0)], across, align=across)
    return block.boxes.get(0, b""), (block.width, block.height)


def _paragraphs(pieces: Sequence[Piece]) -> Iterator[Line]:
    line: Line = []
    for text, colour in pieces:
        for letter in text:
            if letter == "\n":
                yield line
                line = []
            else:
                line.append((letter, colour))
    yield line


def _wrapped(font: Font, paragraph: Line, width: float | None) -> Iterator[Line]:
    """Lines of at most that width, broken at spaces, and inside a word only where it alone is too wide."""
    if width is None or _width(font, paragraph) <= width:
        yield paragraph
        return
    start, space = 0, -1  # of the line, and the last space in it
    at, pen, before = 0, 0.0, ""
    while at < len(paragraph):
        letter = paragraph[at][0]
        pen += _step(font, before, letter)
        if pen > width and at > start and letter != " ":
            end, following = (space, space + 1) if space >= start else (at, at)
            yield paragraph[start:end]
            start = at = following
            space, pen, before = -1, 0.0, ""
            continue
        if letter == " ":
            space = at
        before, at = letter, at + 1
    yield paragraph[start:]


def _glyph(font: Font, letter: str) -> Glyph | None:
    return font.glyphs.get(letter) or font.glyphs.get("\ufffd") or font.glyphs.get("?")


def _step(font: Font, before: str, letter: str) -> float:
    """From one letter's pen to the next one's, closer to the letter before it where the font says so."""
    glyph = _glyph(font, letter)
    return 0.0 if glyph is None else glyph.advance + (font.kerning(before, letter) if before else 0.0)


def _width(font: Font, line: Line) -> float:
    width, before = 0.0, ""
    for letter, _ in line:
        width += _step(font, before, letter)
        before = letter
    return width


def _places(font: Font, line: Line, pen: float) -> Iterator[tuple[tuple[str, int], Glyph, float]]:
    before = ""
    for entry in line:
        glyph = _glyph(font, entry[0])
        if glyph is None:
            continue
        pen += font.kerning(before, entry[0]) if before else 0.0
        yield entry, glyph, pen
        pen += glyph.advance
        before = entry[0]
