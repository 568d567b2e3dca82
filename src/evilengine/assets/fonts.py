"""Fonts: the built-in typeface or a file's, at any size, as one picture of its characters.

Pillow's typeface is Latin without accents, so letters such as a-ring are put together here from what it has.
"""

from __future__ import annotations

import unicodedata
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from evilengine.assets.kerning import kerning_of
from evilengine.values import picture_files
from evilengine.values.checks import did_you_mean, number
from evilengine.values.errors import AssetError
from evilengine.values.font import Font, Glyph

if TYPE_CHECKING:
    from PIL.Image import Image as Picture
    from PIL.ImageFont import FreeTypeFont

UNKNOWN = "\ufffd"
"""The glyph for characters that a font does not have: an empty box."""

CHARACTERS = "".join(map(chr, (*range(0x20, 0x7F), *range(0xA0, 0x100)))) + "\u2018\u2019\u201c\u201d\u2026\u2122"
"""ASCII, Latin-1, and a few more that the typeface has. Those that cannot be drawn get the box."""

MARKS = {"\u0300": "`", "\u0301": "\xb4", "\u0302": "^", "\u0303": "~", "\u0308": "..", "\u030a": "\xb0"}
"""What stands for each combining accent: above a letter, centred."""

BESIDE = {"\xe6": "ae", "\xc6": "AE", "\xa0": " ", "\xd7": "x"}
"""Characters as others in a row, close together."""

OVER = {"\xf8": "o/", "\xd8": "O/", "\xe7": "c,", "\xc7": "C,"}
"""Characters as two on the same spot."""

TURNED = {"\xa1": "!", "\xbf": "?"}
"""Characters as others upside down."""

MARGIN = 1
"""Empty pixels round each glyph, so that smooth edges are whole and neighbours in the picture do not shine through."""

SMALLEST, LARGEST = 4, 512


FILES = (".ttf", ".otf", ".ttc")
"""How files of typefaces end."""

MOST_CHARACTERS = 5000
"""Of one font: beyond, its picture would grow past what a graphics card holds. Others are shown as the box."""


class Fonts:
    """Makes each size of each typeface once, and again when it is asked for characters that it does not have yet.

    >>> font = Fonts().load(16)
    >>> font.glyphs["i"].advance < font.glyphs["m"].advance
    True
    """

    def __init__(self, *folders: Path) -> None:
        self.folders = folders
        self._made: dict[tuple[str | None, int], Font] = {}

    def load(self, size: float = 16, name: str | None = None, characters: str = "") -> Font:
        """A typeface at `size` pixels, rounded to a whole number from 4 to 512: the built-in one, or that of a file.

        That of a file has `characters` beside those of European languages. Raises AssetError if it cannot be had.
        """
        pixels = round(number(size, "Fonts.load", "size", least=SMALLEST, most=LARGEST))
        made = self._made.get((name, pixels))
        if made is None or (name is not None and not made.glyphs.keys() >= set(characters) - {"\n"}):
            known = CHARACTERS if made is None else "".join(made.glyphs)
            wanted = dict.fromkeys(known + characters.replace("\n", "") if name else known)
            face = _face(pixels) if name is None else _face_of(self.find(name), pixels)
            made = self._made[name, pixels] = _make(face, pixels, list(wanted)[:MOST_CHARACTERS])
        return made

    def find(self, name: str) -> Path:
        """The file of the typeface called `name`. Raises AssetError, with the nearest name, if there is none."""
        for folder in self.folders:
            if (folder / name).is_file():
                return folder / name
        near = [file.name for folder in self.folders if folder.is_dir() for file in sorted(folder.iterdir())]
        searched = " or ".join(map(str, self.folders))
        fonts = [each for each in near if each.lower().endswith(FILES)]
        raise AssetError(f"font {name!r}: there is no such file in {searched}{did_you_mean(name, fonts)}")


@dataclass(slots=True)
class _Cell:
    """A drawn character: coverage, where its top left corner lies from the pen, and where it goes in the atlas."""

    shape: Picture
    left: int
    top: int
    advance: int
    at: tuple[int, int] = (0, 0)

    @property
    def right(self) -> int:
        return self.left + self.shape.width

    @property
    def bottom(self) -> int:
        return self.top + self.shape.height


def _make(face: FreeTypeFont, size: int, characters: list[str]) -> Font:
    from PIL import Image

    pen = _Pen(face, size)
    cells = {character: pen.draw(character) for character in characters}
    cells[UNKNOWN] = pen.box()
    width, height = _pack(cells)
    shapes = Image.new("L", (width, height))
    glyphs = {}
    for character, cell in cells.items():
        x, y = cell.at
        shapes.paste(cell.shape, cell.at)
        place = (float(cell.left), float(cell.top), float(cell.right), float(cell.bottom))
        texture = (x / width, y / height, (x + cell.shape.width) / width, (y + cell.shape.height) / height)
        glyphs[character] = Glyph(float(cell.advance), place, texture)
    atlas = Image.new("RGBA", (width, height), (255, 255, 255, 0))
    atlas.putalpha(shapes)
    ascent, descent = pen.face.getmetrics()
    picture = picture_files.from_pillow(atlas)
    return Font(size, float(ascent), float(ascent + descent), picture, glyphs, kerning_of(face))


class _Pen:
    """Draws characters at one size."""

    def __init__(self, face: FreeTypeFont, size: int) -> None:
        self.size = size
        self.face = face
        self._missing = bytes(self.face.getmask("\uffff"))
        self._stroke = max(1, size // 16)

    def draw(self, character: str) -> _Cell:
        """The character, put together from others if the typeface lacks it, or the box."""
        parts = unicodedata.normalize("NFD", character)
        if character in BESIDE:
            return self._text(BESIDE[character], closer=self.size // 8)
        if character in OVER:
            under, over = (self._text(part) for part in OVER[character])
            return _stacked(under, over, (under.left + under.right - over.left - over.right) // 2, 0)
        if character in TURNED:
            return self._turned(TURNED[character])
        if bytes(self.face.getmask(character)) != self._missing:
            return self._text(character)
        if len(parts) == 2 and parts[1] in MARKS:
            return self._accented(parts[0], MARKS[parts[1]])
        return self.box()

    def box(self) -> _Cell:
        from PIL import Image, ImageDraw

        width, height = self.size // 2, (3 * self.size) // 4
        shape = Image.new("L", (width + 2 * MARGIN, height + 2 * MARGIN))
        corners = (MARGIN, MARGIN, width - 1 + MARGIN, height - 1 + MARGIN)
        ImageDraw.Draw(shape).rectangle(corners, outline=255, width=self._stroke)
        return _Cell(shape, 0, -height - MARGIN, width + 2 * MARGIN + self._stroke)

    def _text(self, text: str, closer: int = 0) -> _Cell:
        """Characters in a row, `closer` pixels to each other than they would be."""
        from PIL import Image, ImageDraw

        left, top, right, bottom = (round(edge) for edge in self.face.getbbox(text, anchor="ls"))
        size = (max(right - left, 0) + 2 * MARGIN, max(bottom - top, 0) + 2 * MARGIN)
        shape = Image.new("L", size)
        draw, x = ImageDraw.Draw(shape), 0
        for character in text:
            draw.text((x + MARGIN - left, MARGIN - top), character, fill=255, font=self.face, anchor="ls")
            # Whole advances: text that starts on a whole pixel is sharp all along.
            x += round(self.face.getlength(character)) - closer
        return _trimmed(_Cell(shape, left - MARGIN, top - MARGIN, x + closer))

    def _accented(self, letter: str, mark: str) -> _Cell:
        under, over = self._text(letter), self._text(mark)
        if letter == "i":  # its dot makes room
            height = self._text("x").top
            under.shape.paste(0, (0, 0, under.shape.width, height - under.top))
            under = _Cell(
                under.shape.crop((0, height - under.top, *under.shape.size)), under.left, height, under.advance
            )
        rise = under.top + MARGIN - self._stroke - (over.bottom - MARGIN)
        return _stacked(under, over, (under.left + under.right - over.left - over.right) // 2, rise)

    def _turned(self, character: str) -> _Cell:
        """Upside down, reaching as far below the middle of small letters as it did above."""
        from PIL.Image import Transpose

        upright, x_height = self._text(character), -self._text("x").top - MARGIN
        top = -x_height - upright.bottom
        return _Cell(upright.shape.transpose(Transpose.ROTATE_180), upright.left, top, upright.advance)


def _trimmed(cell: _Cell) -> _Cell:
    """The cell without its empty sides, but for the margin. Pillow's boxes reach down to the baseline."""
    left, top, right, bottom = cell.shape.getbbox() or (MARGIN, MARGIN, MARGIN, MARGIN)
    around = (left - MARGIN, top - MARGIN, right + MARGIN, bottom + MARGIN)
    return _Cell(cell.shape.crop(around), cell.left + around[0], cell.top + around[1], cell.advance)


def _stacked(under: _Cell, over: _Cell, right: int, down: int) -> _Cell:
    """Two cells as one, `over` moved by (right, down)."""
    from PIL import Image, ImageChops

    left, top = min(under.left, over.left + right), min(under.top, over.top + down)
    size = (max(under.right, over.right + right) - left, max(under.bottom, over.bottom + down) - top)
    shape, other = Image.new("L", size), Image.new("L", size)
    shape.paste(under.shape, (under.left - left, under.top - top))
    other.paste(over.shape, (over.left + right - left, over.top + down - top))
    return _Cell(ImageChops.lighter(shape, other), left, top, under.advance)


def _face(size: int) -> FreeTypeFont:
    from PIL import ImageFont

    face = ImageFont.load_default(size)
    if not isinstance(face, ImageFont.FreeTypeFont):
        raise AssetError("built-in font: this Pillow lacks FreeType; install Pillow from PyPI, whose wheels have it")
    return face


def _face_of(file: Path, size: int) -> FreeTypeFont:
    from PIL import ImageFont

    try:
        return ImageFont.truetype(str(file), size, layout_engine=ImageFont.Layout.BASIC)
    except (OSError, ValueError) as problem:
        raise AssetError(f"font {file.name!r} ({file}): this is no typeface that can be read: {problem}") from problem


def _pack(cells: dict[str, _Cell]) -> tuple[int, int]:
    """Lay the cells in rows, about as wide as high, and return the atlas's size."""
    width = max(cell.shape.width for cell in cells.values())
    width = max(width, round((1.1 * sum(cell.shape.width * cell.shape.height for cell in cells.values())) ** 0.5))
    x = y = row = 0
    for cell in sorted(cells.values(), key=lambda cell: -cell.shape.height):  # tall ones first
        if x + cell.shape.width > width:
            x, y, row = 0, y + row, 0
        cell.at = (x, y)
        x, row = x + cell.shape.width, max(row, cell.shape.height)
    return width, y + row
