"""Liquids on a graphics device: the core's map of one, put over the picture. The same sums as in `soft`."""

from __future__ import annotations

from collections.abc import Sequence

from evilengine import _core
from evilengine.renderer.gl.device import GraphicsDevice, Target, Texture
from evilengine.renderer.gl.programs import Programs

PLANES = ("surface", "through", "own")
"""What shaders call the map's textures: depth, displacement and rim; what comes through; what the liquid adds."""


class Liquids:
    """The textures of the frame's liquids, one after the other."""

    def __init__(self, device: GraphicsDevice, programs: Programs) -> None:
        self._device = device
        self._programs = programs
        self._textures: list[Texture] = []

    def draw(
        self,
        picture: Target,
        spare: Target,
        light: Sequence[tuple[str, Texture]],
        light_place: tuple[float, float, float, float],
        size: tuple[int, int],
        planes: Sequence[_core.Memory],
        place: tuple[float, float, float],
        used: tuple[int, int],
        rim: float,
        lit: bool,
    ) -> Target:
        """The picture with the liquid over it, on `spare`."""
        width, height = size
        if self._textures and not _fits(self._textures[0], width, height):
            self.release()
        if not self._textures:
            room = width + width // 4, height + height // 4
            self._textures = [self._device.texture("light", room) for _ in PLANES]
        for texture, texels in zip(self._textures, planes, strict=True):
            texture.write(texels, (0, 0, width, height))
        lit = lit and bool(light)
        self._device.fill(
            spare,
            self._programs.get("screen.vert", "liquid.frag", LIGHT=int(lit)),
            textures=[
                ("picture", picture.texture),
                *zip(PLANES, self._textures, strict=True),
                *(light if lit else ()),
            ],
            uniforms={
                "place": place,
                "used": (float(used[0]), float(used[1])),
                "rim_slope": (rim,),
                **({"light_place": light_place} if lit else {}),
            },
        )
        return spare

    def release(self) -> None:
        """Give the memory back."""
        for texture in self._textures:
            texture.release()
        self._textures.clear()


def _fits(texture: Texture, width: int, height: int) -> bool:
    """Whether so many texels have room, in no more than four times as many."""
    across, down = texture.size
    return width <= across and height <= down and across * down <= 4 * width * height
