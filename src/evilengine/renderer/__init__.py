"""Renderers: one protocol, with a backend in each folder beside it."""

from __future__ import annotations

from typing import Protocol

from evilengine.values.checks import one_of
from evilengine.values.drawlist import DrawList
from evilengine.values.errors import DeviceError
from evilengine.values.image import Image


class Renderer(Protocol):
    """Turns draw lists into pictures. Textures are known by whole numbers, so that the core can name them."""

    def upload(self, image: Image) -> int:
        """Keep `image` for drawing and return its id, a number above 0 that is never given out again."""

    def update(self, texture: int, image: Image) -> None:
        """Show another image, of any size, wherever `texture` is drawn. Raises ArgumentError for an unknown id."""

    def release(self, texture: int) -> None:
        """Forget a texture; what still names it is drawn without one. Raises ArgumentError for an unknown id."""

    def draw(self, frame: DrawList) -> None:
        """Draw a whole frame; the target takes the frame's size."""

    @property
    def pixels(self) -> memoryview:
        """The last frame as (height, width, 4) bytes r, g, b, a, colours multiplied with alpha; without a copy."""

    def capture(self) -> Image:
        """A copy of the last frame, with straight alpha."""

    def close(self) -> None:
        """Let go of textures and target. Nothing may be drawn after."""


def open_renderer(name: str = "auto") -> Renderer:
    """The renderer called `name`: "soft" or "auto", the best that this machine has.

    Raises ArgumentError for an unknown name, and DeviceError for "gl", which this version does not have.

    >>> type(open_renderer("soft")).__name__
    'SoftRenderer'
    """
    if one_of(name, "open_renderer", "name", ("auto", "soft", "gl")) == "gl":
        raise DeviceError('renderer="gl": this version draws in software only; take "soft" or "auto"')
    from evilengine.renderer.soft import SoftRenderer

    return SoftRenderer()
