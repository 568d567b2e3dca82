"""The frame's light on a graphics device."""

from __future__ import annotations

from evilengine import _core
from evilengine.renderer.gl.device import GraphicsDevice, Texture

PLANES = ("light", "light_across", "light_down")
"""What shaders call the light, and the ways that it comes from."""


class LightTextures:
    """The light map that the core worked out for a frame, as textures. Without light they hold nothing."""

    def __init__(self, device: GraphicsDevice) -> None:
        self._device = device
        self._textures: list[Texture] = []
        self.place = (0.0, 0.0, 1.0, 1.0)
        """Where in the picture the first texel's middle lies, in pixels; and how many texels a pixel is, both ways."""

    def of(self, content: _core.DrawList) -> list[tuple[str, Texture]]:
        """The light of a frame by its name in shaders, followed by its ways if something has normals; nothing where
        nothing is lit."""
        found = _core.light_map(content)
        if found is None:
            return []
        width, height, step, x, y, planes = found
        if self._textures and self._textures[0].size != (width, height):
            self.release()
        while len(self._textures) < len(planes):
            self._textures.append(self._device.texture("light", (width, height)))
        for texture, texels in zip(self._textures, planes, strict=False):
            texture.write(texels, (0, 0, width, height))
        self.place = (x, y, 1.0 / step, 1.0 / step)
        return list(zip(PLANES, self._textures[: len(planes)], strict=False))

    def release(self) -> None:
        """Give the memory back."""
        for texture in self._textures:
            texture.release()
        self._textures.clear()
