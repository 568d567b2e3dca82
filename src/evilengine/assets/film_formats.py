"""Animated WebP, GIF and PNG: Pillow encodes each change as a picture of its own, and these wrap them up one by one.

Pillow's own writers of animations keep every frame in memory, or need to know how many come.
"""

from __future__ import annotations

import io
import struct
import zlib
from abc import ABC, abstractmethod
from collections.abc import Iterator
from typing import IO, TYPE_CHECKING

if TYPE_CHECKING:
    from PIL.Image import Image as Picture

Box = tuple[int, int, int, int]
"""Left, top, right, bottom in pixels."""


class Writer(ABC):
    """One format. `begin` once, then `add` for each change of the picture, then `end`."""

    clock = 1000
    """Ticks a second of the format's clock."""
    most_fps = 1000.0

    def begin(self, file: IO[bytes], size: tuple[int, int], loop: bool) -> None:
        """Write what stands before the first frame."""
        self._file = file
        self._size = size
        self._loop = loop
        self._count = 0
        self._begin()

    @abstractmethod
    def _begin(self) -> None: ...

    def widen(self, box: Box | None) -> Box | None:
        """`box`, or the next larger one that the format can place."""
        return box

    def prepare(self, after: Picture, before: Picture | None, box: Box) -> tuple[Picture, Box]:
        """What `add` will want of the frame `after`, which differs from `before` inside `box`."""
        return after.crop(box), box

    @abstractmethod
    def add(self, part: Picture, box: Box, ticks: int) -> None:
        """Show `part` at `box`, over what was there, for `ticks`."""

    @abstractmethod
    def end(self) -> None:
        """Write what stands after the last frame."""


class WebP(Writer):
    """Lossy frames that stand alone: libwebp's own deltas leave ghosts of what moved on, and are no smaller."""

    QUALITY = 80  # 75 shows blocks in gradients; 90 adds 40% to the file
    BLOCK = 16  # pixels that VP8 codes together; its errors stay within
    METHOD = 2  # of 0 (fast) to 6; 4 takes twice the time for 5% of the file

    def _begin(self) -> None:
        width, height = self._size
        self._file.write(b"RIFF\0\0\0\0WEBP")
        self._chunk(b"VP8X", struct.pack("<I", 0x02) + _three(width - 1) + _three(height - 1))  # 2: animated
        self._chunk(b"ANIM", struct.pack("<IH", 0xFF000000, 0 if self._loop else 1))

    def widen(self, box: Box | None) -> Box | None:
        """Whole blocks, and one more around: what moved on is drawn again until none of its block is near."""
        if box is None:
            return None
        (left, top, right, bottom), (width, height) = box, self._size
        block = self.BLOCK
        left, top = max(left // block - 1, 0) * block, max(top // block - 1, 0) * block
        return left, top, min((right // block + 2) * block, width), min((bottom // block + 2) * block, height)

    def add(self, part: Picture, box: Box, ticks: int) -> None:
        encoded = io.BytesIO()
        part.save(encoded, "WEBP", quality=self.QUALITY, method=self.METHOD)
        data = encoded.getvalue()
        frame = b"".join(data[at : at + size] for name, at, size in _riff_chunks(data) if name in (b"VP8 ", b"VP8L"))
        place = _three(box[0] // 2) + _three(box[1] // 2) + _three(part.width - 1) + _three(part.height - 1)
        self._chunk(b"ANMF", place + _three(min(ticks, 0xFFFFFF)) + b"\x02" + frame)  # 2: replace, do not blend

    def end(self) -> None:
        length = self._file.tell()
        self._file.seek(4)
        self._file.write(struct.pack("<I", length - 8))
        self._file.seek(length)

    def _chunk(self, name: bytes, data: bytes) -> None:
        self._file.write(name + struct.pack("<I", len(data)) + data + b"\0" * (len(data) % 2))


class Gif(Writer):
    """One palette as long as it will do, so that what moves leaves no rings of other shades behind; then a whole frame
    with the next. What did not change is transparent, which packs to nothing."""

    clock = 100
    most_fps = 50.0  # viewers slow down frames of less than two hundredths of a second
    KEEP = 255  # palette place of "as before"
    SAMPLES = 60_000  # pixels that a palette is made from: all of them take seven times as long and look no better
    FAR = 32  # levels of a channel; a pixel shown this far off needs a better palette
    MANY_FAR = 2 / 1000  # of the picture, more than when the palette was new: edges are always a little off

    def _begin(self) -> None:
        self._palette: Picture | None = None
        self._allowed = 0.0
        self._file.write(b"GIF89a" + struct.pack("<HHBBB", *self._size, 0x70, 0, 0))
        if self._loop:
            self._file.write(b"\x21\xff\x0bNETSCAPE2.0\x03\x01\0\0\0")

    def prepare(self, after: Picture, before: Picture | None, box: Box) -> tuple[Picture, Box]:
        from PIL import ImageChops

        part = after.crop(box)
        if before is None or self._palette is None or self._far_off(part, self._indexed(part)) > self._allowed:
            self._palette = self._palette_of(after)
            indexed = self._indexed(after)
            self._allowed = self._far_off(after, indexed) + self.MANY_FAR * after.width * after.height
            return indexed, (0, 0, *after.size)
        indexed = self._indexed(part)
        difference = _largest_channel(ImageChops.difference(part, before.crop(box)))
        indexed.paste(self.KEEP, mask=difference.point([255] + [0] * 255, "1"))
        return indexed, box

    def _indexed(self, picture: Picture) -> Picture:
        from PIL.Image import Dither

        return picture.quantize(palette=self._palette, dither=Dither.NONE)

    def _palette_of(self, picture: Picture) -> Picture:
        from PIL.Image import Dither, Quantize, Resampling

        every = max(1, int((picture.width * picture.height / self.SAMPLES) ** 0.5))
        small = (max(1, picture.width // every), max(1, picture.height // every))
        few = picture.resize(small, Resampling.NEAREST)
        return few.quantize(self.KEEP, method=Quantize.MEDIANCUT, dither=Dither.NONE)

    def _far_off(self, picture: Picture, indexed: Picture) -> int:
        """Pixels that the palette shows badly."""
        from PIL import ImageChops

        return sum(_largest_channel(ImageChops.difference(picture, indexed.convert("RGB"))).histogram()[self.FAR :])

    def add(self, part: Picture, box: Box, ticks: int) -> None:
        colours = bytes(part.getpalette() or ())[: 3 * self.KEEP].ljust(3 * 256, b"\0")
        encoded = io.BytesIO()
        part.save(encoded, "GIF", optimize=False, interlace=0)
        place = struct.pack("<HHHHB", box[0], box[1], part.width, part.height, 0x87)  # with 256 colours of its own
        self._file.write(b"\x21\xf9\x04" + struct.pack("<BHBB", 0x05, min(ticks, 0xFFFF), self.KEEP, 0))
        self._file.write(b"\x2c" + place + colours + _gif_data(encoded.getvalue()))

    def end(self) -> None:
        self._file.write(b"\x3b")


class Png(Writer):
    """Lossless: every pixel as it was drawn."""

    LEVEL = 4  # of zlib, 0..9; 6 takes a fifth longer for 2% of the file

    def _begin(self) -> None:
        self._file.write(b"\x89PNG\r\n\x1a\n")
        self._chunk(b"IHDR", struct.pack(">IIBBBBB", *self._size, 8, 2, 0, 0, 0))  # 8 bits, RGB
        self._actl = self._file.tell()
        self._write_actl()
        self._sequence = 0

    def _write_actl(self) -> None:
        self._chunk(b"acTL", struct.pack(">II", self._count, 0 if self._loop else 1))

    def add(self, part: Picture, box: Box, ticks: int) -> None:
        encoded = io.BytesIO()
        part.save(encoded, "PNG", compress_level=self.LEVEL)
        control = struct.pack(">IIIIIHHBB", self._next(), *part.size, *box[:2], min(ticks, 0xFFFF), self.clock, 0, 0)
        self._chunk(b"fcTL", control)
        for name, data in _png_chunks(encoded.getvalue()):
            if name == b"IDAT" and self._count == 0:
                self._chunk(b"IDAT", data)
            elif name == b"IDAT":
                self._chunk(b"fdAT", struct.pack(">I", self._next()) + data)
        self._count += 1

    def end(self) -> None:
        self._chunk(b"IEND", b"")
        self._file.seek(self._actl)
        self._write_actl()
        self._file.seek(0, io.SEEK_END)

    def _next(self) -> int:
        self._sequence += 1
        return self._sequence - 1

    def _chunk(self, name: bytes, data: bytes) -> None:
        self._file.write(struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data)))


WRITERS: dict[str, type[Writer]] = {".webp": WebP, ".gif": Gif, ".png": Png}


def _largest_channel(picture: Picture) -> Picture:
    from PIL import ImageChops

    red, green, blue = picture.split()
    return ImageChops.lighter(ImageChops.lighter(red, green), blue)


def _three(value: int) -> bytes:
    return value.to_bytes(3, "little")


def _riff_chunks(data: bytes) -> Iterator[tuple[bytes, int, int]]:
    """Name, start and length (header, data and padding together) of each chunk of a WebP file."""
    at = 12
    while at + 8 <= len(data):
        size = int.from_bytes(data[at + 4 : at + 8], "little")
        whole = 8 + size + size % 2
        yield data[at : at + 4], at, whole
        at += whole


def _png_chunks(data: bytes) -> Iterator[tuple[bytes, bytes]]:
    at = 8
    while at + 12 <= len(data):
        size = int.from_bytes(data[at : at + 4], "big")
        yield data[at + 4 : at + 8], data[at + 8 : at + 8 + size]
        at += 12 + size


def _gif_data(data: bytes) -> bytes:
    """The compressed pixels of a GIF with one picture."""
    flags = data[10]
    at = 13 + (3 << ((flags & 7) + 1) if flags & 0x80 else 0)
    while data[at] == 0x21:  # extensions: a label, then blocks up to an empty one
        at += 2
        while data[at]:
            at += 1 + data[at]
        at += 1
    flags = data[at + 9]
    at += 10 + (3 << ((flags & 7) + 1) if flags & 0x80 else 0)
    start = at
    at += 1  # bits of a code
    while data[at]:
        at += 1 + data[at]
    return data[start : at + 1]
