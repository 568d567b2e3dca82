"""What is done to a whole picture on a graphics device: depth blur, and the post pass. The same sums as in `soft`."""

from __future__ import annotations

from collections.abc import Sequence

from evilengine.renderer.gl.device import GraphicsDevice, Program, Target, Texture
from evilengine.renderer.gl.programs import Programs

BLOOM_LEVELS = 6
"""kBloomLevels of core/raster/pyramid.hpp."""

TONES = 1024
"""kTones of core/draw/post.hpp."""

GIVES_WAY, TAKES_LIGHT, PICTURE_GIVES_WAY, PICTURE_TAKES_LIGHT = range(4)
"""HOW in double.frag."""


class Filters:
    """The targets that a picture is halved into, and what is done with them."""

    def __init__(self, device: GraphicsDevice, programs: Programs) -> None:
        self._device = device
        self._programs = programs
        self._levels: list[Target] = []  # a half, a quarter, ... of the picture; and one that is being mixed, for each
        self._mixed: list[Target] = []
        self._quarter: Target | None = None  # one more of that size
        self._tones: Texture | None = None
        self._table = b""

    def blur(self, picture: Target, spare: Target, levels: int, share: float) -> Target:
        """The picture out of focus, on `spare`; one that is too small to be halved stays as it is."""
        steps = self._descend(picture, levels)
        if steps == 0:
            return picture
        return self._ascend(picture, spare, steps, [share if at == levels else 1.0 for at in range(1, steps + 1)])

    def shafts(
        self,
        picture: Target,
        spare: Target,
        origin: tuple[float, float],
        passes: Sequence[tuple[tuple[float, ...], tuple[float, ...]]],
        colour: tuple[float, float, float],
        threshold: float,
    ) -> Target:
        """The picture with shafts of light that go away from a point of it, on `spare`."""
        self._make_levels(picture, 2)
        (half, quarter), mixed = self._levels[:2], self._mixed[0]
        one, other = self._mixed[1], self._spare_quarter(quarter.size)
        self._halve(picture, half, first=True)
        self._halve(half, quarter)
        self._shaft(one, quarter, 0, threshold=(threshold,))
        for at, weight in passes:
            self._shaft(other, one, 1, origin=(0.25 * origin[0], 0.25 * origin[1]), at=at, weight=weight)
            one, other = other, one
        self._shaft(quarter, one, 2, colour=colour)
        self._double(half, quarter, mixed, GIVES_WAY)
        return self._double(picture, mixed, spare, PICTURE_TAKES_LIGHT)

    def _shaft(self, to: Target, picture: Target, stage: int, **uniforms: tuple[float, ...]) -> None:
        program = self._program("shaft.frag", STAGE=stage, TAPS=len(uniforms.get("at", ())))
        self._device.fill(to, program, textures=[("picture", picture.texture)], uniforms=uniforms)

    def finish(self, picture: Target, spare: Target, post: dict[str, float], tones: bytes) -> Target:
        """The picture after the post pass, on `spare`."""
        if self._tones is None:
            self._tones = self._device.texture("data", (TONES, 1))
        if tones != self._table:
            self._tones.write(tones, (0, 0, TONES, 1))
            self._table = tones
        glow = [("glow", self._glow(picture, post["threshold"]).texture)] if post["bloom"] > 0.0 else []
        self._device.fill(
            spare,
            self._program("post.frag", BLOOM=int(post["bloom"] > 0.0), GRAIN=int(post["grain"] > 0.0)),
            textures=[("picture", picture.texture), ("tones", self._tones), *glow],
            uniforms={
                "look": (post["bloom"], post["saturation"], post["vignette"], post["grain"]),
                "seed": (float(int(post["seed"]) >> 16), float(int(post["seed"]) & 0xFFFF)),
            },
        )
        return spare

    def release(self) -> None:
        """Give back everything that this made."""
        for thing in (*self._levels, *self._mixed, self._quarter, self._tones):
            if thing is not None:
                thing.release()
        self._levels, self._mixed, self._quarter, self._tones, self._table = [], [], None, None, b""

    # ---- down and up again ----------------------------------------------------------------------------------------

    def _glow(self, picture: Target, threshold: float) -> Target:
        self._make_levels(picture, BLOOM_LEVELS)
        first = self._levels[0]
        self._device.fill(
            first, self._program("halve.frag", FIRST=1, BRIGHT=1), textures=[("picture", picture.texture)],
            uniforms={"threshold": (threshold,)},
        )  # fmt: skip
        steps = 1
        while steps < BLOOM_LEVELS and max(self._levels[steps - 1].size) > 2:
            self._halve(self._levels[steps - 1], self._levels[steps])
            steps += 1
        below = self._levels[steps - 1]
        for at in range(steps - 2, -1, -1):
            below = self._double(self._levels[at], below, self._mixed[at], TAKES_LIGHT)
        return below

    def _descend(self, picture: Target, levels: int) -> int:
        self._make_levels(picture, levels)
        above, steps = picture, 0
        while steps < levels and max(above.size) > 2:
            self._halve(above, self._levels[steps], first=steps == 0)
            above = self._levels[steps]
            steps += 1
        return steps

    def _ascend(self, picture: Target, spare: Target, steps: int, shares: list[float]) -> Target:
        below = self._levels[steps - 1]
        for at in range(steps - 2, -1, -1):
            below = self._double(self._levels[at], below, self._mixed[at], GIVES_WAY, shares[at + 1])
        return self._double(picture, below, spare, PICTURE_GIVES_WAY, shares[0])

    def _halve(self, above: Target, to: Target, *, first: bool = False) -> None:
        program = self._program("halve.frag", FIRST=int(first), BRIGHT=0)
        self._device.fill(to, program, textures=[("picture", above.texture)], uniforms={})

    def _double(self, above: Target, below: Target, to: Target, how: int, share: float = 1.0) -> Target:
        """The smaller one takes the place of a share of the larger, or its light is added."""
        self._device.fill(
            to,
            self._program("double.frag", HOW=how),
            textures=[("above", above.texture), ("below", below.texture)],
            uniforms={"share": (share,)},
        )
        return to

    def _spare_quarter(self, size: tuple[int, int]) -> Target:
        if self._quarter is None or self._quarter.size != size:
            if self._quarter is not None:
                self._quarter.release()
            self._quarter = self._device.target(size, "deep")
        return self._quarter

    def _make_levels(self, picture: Target, count: int) -> None:
        width, height = picture.size
        if self._levels and self._levels[0].size != ((width + 1) // 2, (height + 1) // 2):
            for target in (*self._levels, *self._mixed):
                target.release()
            self._levels, self._mixed = [], []
        for _ in range(len(self._levels)):
            width, height = (width + 1) // 2, (height + 1) // 2
        while len(self._levels) < count:
            width, height = (width + 1) // 2, (height + 1) // 2
            self._levels.append(self._device.target((width, height), "deep"))
            self._mixed.append(self._device.target((width, height), "deep"))

    def _program(self, fragment: str, **defines: int) -> Program:
        return self._programs.get("screen.vert", fragment, **defines)
