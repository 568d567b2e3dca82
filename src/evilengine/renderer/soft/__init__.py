"""The software renderer: draws anywhere, without a GPU or a screen, and with the same bits on every machine."""

from __future__ import annotations

from evilengine import _core
from evilengine.values.drawlist import DrawList
from evilengine.values.errors import ArgumentError
from evilengine.values.image import Image
from evilengine.values.surface import Shows, Surface

MAX_SIDE = 16384
"""Pixels; the longest side of a target or a texture (kMaxSide in core/raster/target.hpp)."""

_NOTHING = _core.DrawList()


class SoftRenderer:
    """Draws with `core/raster`: exact area coverage, bilinear textures, sRGB blending. Behaves as `Renderer` says.

    `threads` (1 to 256) share in each picture, which comes out to the same bits however many they are; one that costs
    little is drawn by one.

    >>> shapes = _core.DrawList()
    >>> shapes.instance(shapes.circle(1.0), (8, 0, 0, 8, 16, 16), tint=0xFF0000FF)
    >>> renderer = SoftRenderer()
    >>> renderer.draw(DrawList((32, 32), 0xFF000000, shapes))
    >>> renderer.capture().pixels[16, 16, 0], renderer.capture().pixels[0, 0, 0]
    (255, 0)
    """

    name = "soft"
    draw_calls = 0

    def __init__(self, threads: int = 1) -> None:
        self._raster = _core.Raster(threads)
        self._size = (1, 1)
        self._pixels = bytearray(4)

    @property
    def threads(self) -> int:
        """How many may share in a picture."""
        return self._raster.threads

    def attach(self, surface: Surface | None) -> None:
        """Pictures are all that this renderer makes: a window's GL context is of no use to it."""
        if surface is not None:
            surface.close()

    def upload(self, image: Image) -> int:
        """Keep `image` for drawing and return its id, above 0."""
        return self._raster.upload(image.pixels, image.width, image.height)

    def update(self, texture: int, image: Image) -> None:
        """Show another image wherever `texture` is drawn."""
        self._raster.update(texture, image.pixels, image.width, image.height)

    def release(self, texture: int) -> None:
        """Forget a texture."""
        self._raster.release(texture)

    def reload_shaders(self) -> list[str]:
        """There are none."""
        return []

    def draw(self, frame: DrawList) -> None:
        """Draw a whole frame. A frame of another size gets new pixels; views of the old ones keep the last picture."""
        if frame.size != self._size:
            self._resize(*frame.size)
        whole = (self._pixels, *self._size)
        background: int | None = frame.background
        if frame.insets:
            self._raster.draw(_NOTHING, *whole, background)
            for inset in frame.insets:
                part = (inset.left, inset.top, *inset.frame.size)
                self._raster.draw(inset.frame.content, *whole, inset.frame.background, part=part)
            background = None
        self._raster.draw(frame.content, *whole, background)

    def _resize(self, width: int, height: int) -> None:
        if not (1 <= width <= MAX_SIDE and 1 <= height <= MAX_SIDE):
            raise ArgumentError(f"DrawList.size={(width, height)!r}: each side must be 1 to {MAX_SIDE} pixels")
        self._pixels = bytearray(width * height * 4)  # a new one: someone may still look at the old
        self._size = (width, height)

    @property
    def pixels(self) -> memoryview:
        """The last frame as (height, width, 4) bytes, colours multiplied with alpha; the next draw changes them."""
        width, height = self._size
        return memoryview(self._pixels).toreadonly().cast("B", (height, width, 4))

    def show(self, device: Shows) -> None:
        """Put the last frame on the screen."""
        device.show(self.pixels, self._size)

    def capture(self) -> Image:
        """A copy of the last frame, with straight alpha."""
        pixels = bytearray(self._pixels)
        _core.unpremultiply(pixels)
        return Image.of(*self._size, pixels)

    def close(self) -> None:
        """Let go of textures and target."""
        self._raster = _core.Raster(self._raster.threads)
        self._resize(1, 1)
