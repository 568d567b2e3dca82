"""Image: pixels that modules hand to each other, and that people save."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from evilengine.values.checks import known_keywords
from evilengine.values.errors import ArgumentError


@dataclass(frozen=True, slots=True)
class Image:
    """Pixels of a picture: rows from the top, each pixel red, green, blue, alpha (straight, sRGB), one byte each.

    >>> Image.of(2, 1, bytes([255, 0, 0, 255] * 2)).pixels[0, 1, 0]
    255
    """

    width: int
    height: int
    pixels: memoryview
    """A (height, width, 4) view of unsigned bytes; `numpy.asarray(image.pixels)` needs no copy."""

    @staticmethod
    @known_keywords
    def of(width: int, height: int, data: bytes | bytearray | memoryview) -> Image:
        """An image over `data`, width * height * 4 bytes, which it keeps alive and does not copy."""
        flat = memoryview(data).cast("B")
        if width < 1 or height < 1 or len(flat) != width * height * 4:
            raise ArgumentError(f"Image.of({width}, {height}): needs {width} * {height} * 4 bytes, got {len(flat)}")
        return Image(width, height, flat.cast("B", (height, width, 4)))

    @property
    def size(self) -> tuple[int, int]:
        """(width, height) in pixels."""
        return self.width, self.height

    def tobytes(self) -> bytes:
        """The pixels as bytes, row by row from the top."""
        return self.pixels.tobytes()

    @known_keywords
    def save(self, path: str | Path) -> Path:
        """Write the image to `path`; the ending chooses the format (.png, .webp, .jpg, ...)."""
        from evilengine.values import picture_files  # Pillow is slow to import, so only when it is needed

        return picture_files.save(self, Path(path))
