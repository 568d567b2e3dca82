"""The frame's light on a graphics device."""

from __future__ import annotations

from evilengine import _core
from evilengine.renderer.gl.device import GraphicsDevice, Texture


class LightTexture:
    """The light map that the core worked out for a frame, as a texture. Without light it holds nothing."""

    def __init__(self, device: GraphicsDevice) -> None:
        self._device = device
        self._texture: Texture | None = None
        self.place = (0.0, 0.0, 1.0, 1.0)
        """Where in the picture the first texel's middle lies, in pixels; and how many texels a pixel is, both ways."""

    def of(self, content: _core.DrawList) -> Texture | None:
        """The light of a frame; None where nothing is lit."""
        found = _core.light_map(content)
        if found is None:
            return None
        width, height, step, x, y, texels = found
        if self._texture is None or self._texture.size != (width, height):
            self.release()
            self._texture = self._device.texture("light", (width, height))
        self._texture.write(texels, (0, 0, width, height))
        self.place = (x, y, 1.0 / step, 1.0 / step)
        return self._texture

    def release(self) -> None:
        """Give the memory back."""
        if self._texture is not None:
            self._texture.release()
        self._texture = None
