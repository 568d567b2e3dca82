"""One frame on a graphics device: meshes stay on the card, a buffer of quads goes there, and few draw calls show them.

`core/gpu` turns a draw list into quads, edges and facets; the shaders say what becomes of them. Here is only what is
kept where, and in which order things go to the card.
"""

from __future__ import annotations

from typing import Any

from evilengine import _core
from evilengine.renderer.gl.atlas import Atlas, Copy
from evilengine.renderer.gl.device import Attribute, Blend, Buffer, GraphicsDevice, Layout, Program, Target, Texture
from evilengine.renderer.gl.filters import Filters
from evilengine.renderer.gl.light import LightTextures
from evilengine.renderer.gl.liquid import Liquids
from evilengine.renderer.gl.programs import Programs
from evilengine.values.drawlist import DrawList, Inset
from evilengine.values.image import Image

Named = list[tuple[str, Texture]]
"""Textures by their names in a shader."""

ROW = 1024
"""Texels in a row of a data texture (kRow in core/gpu/quads.hpp)."""

MIXES = (0, 1, 2, 4, 8)
"""How many pictures a draw call may mix, at most kUnits in core/gpu/quads.hpp; a program for each, as some drivers look
each picture up for each pixel."""

COVERS = (0, 1, 2)
"""What a sprite's pixels are covered by in part (Fringe in core/gpu/quads.hpp); each makes the shader slower."""

BLENDS: tuple[Blend, ...] = ("over", "over", "multiply", "screen")
"""By the numbers of draw::Blend; what adds is drawn over, with no alpha."""

ADD = 1

INSTANCE = Layout(
    104,
    (
        *(Attribute("float", 4, 16 * place) for place in range(5)),  # matrix, offsets, box, inner, coordinates
        Attribute("uint", 4, 80),  # first edge, edges, first facet, how
        Attribute("uint", 2, 96),  # tint, surface
    ),
)
"""A Quad of core/gpu/quads.hpp, field by field."""

SPRITE = Layout(
    72,
    (
        *(Attribute("float", 4, 16 * place) for place in range(4)),  # place, axes, texels, what to draw
        Attribute("uint", 2, 64),  # flags, tint
    ),
)
"""A Sprite of core/gpu/quads.hpp, field by field."""

SPECK = Layout(
    24,
    (
        Attribute("float", 4, 0),  # middle, half axis
        Attribute("float", 1, 16),  # the other half axis
        Attribute("uint", 1, 20),  # colour
    ),
)
"""A Speck of core/draw/specks.hpp, field by field."""


class _Shapes:
    """The data texture: the meshes' rows, then those that are made for a frame. It grows by doubling."""

    def __init__(self, device: GraphicsDevice) -> None:
        self._device = device
        self._revision = 0
        self.texture: Texture = device.texture("data", (ROW, 1))

    def write(self, batcher: _core.Batcher) -> None:
        meshes, edges = batcher.shapes, batcher.edges
        mesh_rows, edge_rows = len(meshes) // (ROW * 16), len(edges) // (ROW * 16)
        if mesh_rows + edge_rows > self.texture.size[1]:
            self.texture.release()
            self.texture = self._device.texture("data", (ROW, 1 << (mesh_rows + edge_rows - 1).bit_length()))
            self._revision = 0
        if batcher.revision != self._revision:
            self.texture.write(meshes, (0, 0, ROW, mesh_rows))
            self._revision = batcher.revision
        if edge_rows:
            self.texture.write(edges, (0, mesh_rows, ROW, edge_rows))


class Pipeline:
    """Everything that is held on one device, and how a frame is drawn with it.

    One that is `of` another draws a part of its frames, and has pictures and programs in common with it.
    """

    def __init__(self, device: GraphicsDevice, of: Pipeline | None = None) -> None:
        self.device = device
        self.draw_calls = 0
        """Of the last frame."""
        self.target: Target | None = None
        self._batcher: _core.Batcher = _core.Batcher() if of is None else of._batcher.another()
        self._pictures: dict[int, Texture] = {} if of is None else of._pictures
        self.programs: Programs = Programs(device) if of is None else of.programs
        self._atlas: Atlas = Atlas(device, self._batcher) if of is None else of._atlas
        self._is_part = of is not None
        self._insets: list[Pipeline] = []
        self._quads = device.buffer()
        self._sprites = device.buffer()
        self._specks = device.buffer()
        self._spare: Target | None = None  # of the same size, for what is done to a whole picture
        self._filters = Filters(device, self.programs)
        self._shapes = _Shapes(device)
        self._light = LightTextures(device)
        self._liquids = Liquids(device, self.programs)
        for pictures in MIXES[:2]:  # compiled now, so that no frame waits for it, and errors come at the start
            self._program(pictures, 0, 0)
        for cover in COVERS:
            self.programs.get("sprite.vert", "sprite.frag", COVER=cover, LIGHT=0)

    # ---- pictures -------------------------------------------------------------------------------------------------

    def upload(self, image: Image) -> int:
        picture, copies = self._picture(image)
        texture = self._batcher.hold()
        self._pictures[texture] = picture
        self._atlas.put(texture, copies)
        return texture

    def update(self, texture: int, image: Image) -> None:
        picture, copies = self._picture(image)
        self._pictures[texture].release()
        self._pictures[texture] = picture
        self._atlas.put(texture, copies)

    def drop(self, texture: int) -> None:
        self._batcher.drop(texture)
        self._atlas.drop(texture)
        self._pictures.pop(texture).release()

    def _picture(self, image: Image) -> tuple[Texture, list[Copy]]:
        """On the card, with the smaller copies that `soft` uses too. What the card cannot hold is held smaller."""
        levels = _core.mipmaps(image.pixels, image.width, image.height)
        while max(levels[0][:2]) > self.device.most_pixels:
            levels.pop(0)
        picture = self.device.texture("picture", levels[0][:2], levels=len(levels))
        for level, (width, height, texels, _) in enumerate(levels):
            picture.write(texels, (0, 0, width, height), level=level)
        return picture, levels

    # ---- a frame --------------------------------------------------------------------------------------------------

    def draw(self, frame: DrawList) -> None:
        insets = self._draw_insets(frame)
        batches = self._batcher.collect(frame.content, *frame.size)
        target = self._target(frame.size)
        target.clear(_to_colour(frame.background))
        for inset, pipeline in zip(frame.insets, insets, strict=True):
            self._place(target, inset, pipeline)
        self._write(self._batcher.quads, self._quads)
        self._write(self._batcher.sprites, self._sprites)
        self._write(self._batcher.specks, self._specks)
        if batches:
            self._shapes.write(self._batcher)
        light = self._light.of(frame.content)
        for batch in batches:
            if batch[0] == "sprites":
                self._draw_sprites(target, light, *batch[1:])
            elif isinstance(batch[0], str):
                target = self._interlude(target, light, *batch)
            else:
                self._draw_quads(target, light, *batch)
        self.draw_calls = len(batches) + sum(pipeline.draw_calls + 1 for pipeline in insets)
        self.device.check()

    def _draw_insets(self, frame: DrawList) -> list[Pipeline]:
        """What fills parts of the frame, each drawn by a pipeline of its own."""
        while len(self._insets) < len(frame.insets):
            self._insets.append(Pipeline(self.device, self))
        while len(self._insets) > len(frame.insets):
            self._insets.pop().release()
        for inset, pipeline in zip(frame.insets, self._insets, strict=True):
            pipeline.draw(inset.frame)
        return self._insets

    def _place(self, target: Target, inset: Inset, pipeline: Pipeline) -> None:
        assert pipeline.target is not None
        self.device.fill(
            target,
            self.programs.get("screen.vert", "place.frag"),
            textures=[("picture", pipeline.target.texture)],
            uniforms={"corner": (float(inset.left), float(inset.top))},
            part=(inset.left, inset.top, *inset.frame.size),
        )

    def _write(self, data: _core.Memory, buffer: Buffer) -> None:
        if len(data):
            buffer.write(data, len(data))

    def _draw_quads(
        self, target: Target, light: Named, first: int, count: int, pictures: tuple[int, ...], look: int
    ) -> None:
        self._draw(
            target,
            self._program(next(mix for mix in MIXES if mix >= len(pictures)), look & 9, len(light)),
            (self._quads, INSTANCE, first, count),
            [
                ("shapes", self._shapes.texture),
                *((f"picture{unit}", self._pictures[texture]) for unit, texture in enumerate(pictures)),
                *light,
            ],
            BLENDS[look >> 1 & 3],
        )

    def _draw_sprites(
        self, target: Target, light: Named, first: int, count: int, page: int, cover: int, lit: bool, blend: int
    ) -> None:
        self._draw(
            target,
            self.programs.get("sprite.vert", "sprite.frag", COVER=cover, LIGHT=int(lit)),
            (self._sprites, SPRITE, first, count),
            [("page", self._atlas.page(page)), *(light[:1] if lit else ())],
            BLENDS[blend],
        )

    def _draw(
        self,
        target: Target,
        program: Program,
        instances: tuple[Buffer, Layout, int, int],
        textures: Named,
        blend: Blend,
    ) -> None:
        size = float(target.size[0]), float(target.size[1])
        uniforms = {"target_size": size, "light_place": self._light.place}
        self.device.draw(target, program, instances=instances, textures=textures, uniforms=uniforms, blend=blend)

    def _interlude(self, target: Target, light: Named, kind: str, *what: Any) -> Target:
        """What comes between the quads of a frame; on which target it goes on."""
        if kind == "specks":
            self._draw_specks(target, *what)
            return target
        if self._spare is None or self._spare.size != target.size:
            if self._spare is not None:
                self._spare.release()
            self._spare = None
            self._spare = self.device.target(target.size)
        if kind == "blur":
            done = self._filters.blur(target, self._spare, *what)
        elif kind == "shafts":
            done = self._filters.shafts(target, self._spare, *what)
        elif kind == "liquid":
            done = self._liquids.draw(target, self._spare, light[:1], self._light.place, *what)
        else:
            done = self._filters.finish(target, self._spare, self._batcher.post, self._batcher.tones)
        if done is not target:
            self.target, self._spare = done, target
        return done

    def _draw_specks(self, target: Target, first: int, count: int, disc: bool, blend: int) -> None:
        self.device.draw(
            target,
            self.programs.get("speck.vert", "speck.frag", DISC=int(disc), ADDS=int(blend == ADD)),
            instances=(self._specks, SPECK, first, count),
            textures=[],
            uniforms={"target_size": (float(target.size[0]), float(target.size[1]))},
            blend=BLENDS[blend],
        )

    def show(self, size: tuple[int, int]) -> None:
        """Put the last frame on the window, `size` pixels large."""
        if self.target is None:
            return
        program = self.programs.get("screen.vert", "screen.frag")
        self.device.show(program, [("picture", self.target.texture)], size)
        self.device.check()

    def _program(self, pictures: int, look: int, light: int) -> Program:
        return self.programs.get(
            "shape.vert", "shape.frag", PICTURES=pictures, FACETS=look & 1, SURFACES=look >> 3, LIGHT=light
        )

    def _target(self, size: tuple[int, int]) -> Target:
        if self.target is None or self.target.size != size:
            if self.target is not None:
                self.target.release()
            self.target = None
            self.target = self.device.target(size)
        return self.target

    def release(self) -> None:
        """Give back everything that this made."""
        for pipeline in self._insets:
            pipeline.release()
        pictures = () if self._is_part else tuple(self._pictures.values())
        for thing in (
            *pictures,
            self._shapes.texture,
            self._quads,
            self._sprites,
            self._specks,
            self._spare,
            self.target,
        ):
            if thing is not None:
                thing.release()
        self._filters.release()
        self._liquids.release()
        self._light.release()
        if not self._is_part:
            self._atlas.release()
            self._pictures.clear()
        self._insets.clear()
        self.target = self._spare = None


def _to_colour(background: int) -> tuple[float, float, float, float]:
    """0xAABBGGRR as 0..1, multiplied with alpha."""
    alpha = (background >> 24) / 255
    red, green, blue = ((background >> shift & 255) / 255 * alpha for shift in (0, 8, 16))
    return red, green, blue, alpha
