"""Scene: everything that is drawn, and the list of it that a renderer gets each frame."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Sequence
from typing import Any, TypeAlias

from evilengine import _core
from evilengine.scene import graph
from evilengine.scene.animated import BLENDS
from evilengine.scene.camera import Camera, Matrix6
from evilengine.scene.debug import DebugView
from evilengine.scene.drawing import Drawing, placement, to_depth, to_layer, to_matrix6
from evilengine.scene.drawn_body import DrawnBody, show
from evilengine.scene.gases import Gases
from evilengine.scene.gases import Textures as PictureKeeper
from evilengine.scene.layers import Layer, Layers, seen_middle
from evilengine.scene.lights import Lights, Loads
from evilengine.scene.particles import Emitter
from evilengine.scene.post import Post
from evilengine.scene.shown import Shown, Sizes, Surfaces, Textures
from evilengine.scene.sliced import Sliced, on_shape, sliced, tile_size
from evilengine.scene.surface import to_glow
from evilengine.scene.text import Fonts, Text
from evilengine.scene.waters import WaterLook, WaterLooks
from evilengine.values.checks import known_keywords, number, one_of, switch
from evilengine.values.colour import BACKGROUND, PALETTE, STONE, WHITE, Colour, ColourLike, to_colour
from evilengine.values.drawlist import DrawList
from evilengine.values.errors import ArgumentError, ArgumentTypeError
from evilengine.values.frame import FrameTimes
from evilengine.values.sheet import Sheet
from evilengine.values.vec2 import Point, Vec2
from evilengine.world.body import Body, Shape
from evilengine.world.shapes import PolygonLike, ShapeDefinition, to_shape
from evilengine.world.world import World

Panel: TypeAlias = Callable[[_core.Scene, Fonts | None, tuple[int, int], float], object]
"""Draws on the screen: given the core's scene, the fonts, the picture's size in pixels, and how many make a point."""

SPECK = 0.05  # metres: how large a particle is drawn, which has no size of its own


class Scene(Shown):
    """What of `world` is drawn, and what is drawn beside it: layers, a background colour, text, the debug view.

    `textures` turns an image's name into a texture id, and `fonts` a height in pixels into a font; a game gives both.

    >>> world = evil.World(); scene = Scene(world)
    >>> crate = world.add(evil.Rectangle(1, 1), at=(0, 4))
    >>> drawing = scene.add(crate.shapes[0], colour="orange")
    >>> drawing.layer = 3
    >>> frame = scene.collect(Camera((960, 540)))
    >>> frame.size, len(scene)
    ((960, 540), 1)
    """

    @known_keywords
    def __init__(
        self,
        world: World,
        *,
        textures: Textures | None = None,
        surfaces: Surfaces | None = None,
        sizes: Sizes | None = None,
        images: Loads | None = None,
        fonts: Fonts | None = None,
        background: ColourLike = BACKGROUND,
        renderer: PictureKeeper | None = None,
        threads: int = 1,
    ) -> None:
        if not isinstance(world, World):
            raise ArgumentTypeError(f"Scene: world={world!r} must be a World")
        self.debug = False
        """Is the debug view drawn over the world?"""
        self.debug_view = DebugView()
        self.graph: Collection[FrameTimes] | None = None
        """What frames cost, to be drawn over everything; None for no graph."""
        self.panels: list[Panel] = []
        """Who draws over everything, on the screen: menus and readings that are no part of the game."""
        self.backgrounds = 0
        """How many images have been put behind everything."""
        self.layers = Layers()
        """How layers are seen that are not seen as the world is: farther off, in fog, out of focus."""
        self.post = Post()
        """What is done to the whole picture before text goes over it."""
        super().__init__(world, textures, surfaces, sizes)
        self._fonts = fonts
        self._emitters: list[Emitter] = []
        self._emitters_made = 0
        self._texts: list[Text] = []
        self._texts_made = 0
        self._overlay: list[Text] = []
        self._restores = 0
        self._restored: dict[
            tuple[int, int], list[tuple[int, int, int]]
        ] = {}  # by body, which takes its own when asked
        self._from_palette = 0  # how many drawings took a colour of the palette
        self.gases = Gases(self, renderer)
        """How the world's smokes are seen."""
        self.waters = WaterLooks(self)
        """How the world's waters are seen."""
        self.lights = Lights(world, images, threads)
        """What shines on drawings that are lit: lamps, spots, suns, and the ambient light."""
        self.background = background
        show(world, self)

    def __len__(self) -> int:
        """How many drawings there are. Those of a body that was destroyed count until the next frame."""
        return len(self._core)

    @property
    def background(self) -> Colour:
        """The colour behind everything."""
        return self._background

    @background.setter
    def background(self, value: ColourLike) -> None:
        self._background = to_colour(value, "Scene", "background").with_alpha(1.0)

    @known_keywords
    def add(
        self,
        shape: ShapeDefinition | Shape,
        *,
        body: Body | None = None,
        at: Point = (0.0, 0.0),
        angle: float = 0.0,
        matrix: Iterable[float] | None = None,
        colour: ColourLike | None = None,
        colours: Sequence[ColourLike] | None = None,
        texture: str | Sheet | None = None,
        animation: str | None = None,
        texture_points: Sequence[Point] | None = None,
        texture_matrix: Iterable[float] | None = None,
        tile: float | Point | None = None,
        slice: float | tuple[float, float, float, float] | None = None,
        flip_x: bool = False,
        flip_y: bool = False,
        blend: str = "normal",
        outline: bool | None = None,
        layer: int = 0,
        visible: bool = True,
        lit: bool = False,
        normal_map: str | None = None,
        glow_map: str | None = None,
        glow: float | None = None,
        behind: float = 0.0,
        depth: float = 0.0,
    ) -> Drawing:
        """Draw `shape` from now on: on `body`, or on a body's Shape itself, or by itself in the world.

        `at` and `angle`, or a 4x4 `matrix`, place it there. `colour` tints all of it, and `colours` each of
        `shape.corners`. The image `texture` spreads over the shape's bounding box unless `texture_points` says which
        point of it (0..1 from its top left) lies on each corner; `texture_matrix` moves those points, and `tile` lays
        it again and again, each so many metres wide and high. On a rectangle `slice` keeps the borders of the picture
        as wide as they are: so many points of it, or left, top, right, bottom. Of a Sheet, `animation` is shown, else
        its first frame; `flip_x` and `flip_y` mirror it. `blend` is "normal", "add" (shines), "multiply" (shades) or
        "screen". `outline` is a thin darker line round it. What is given neither colour nor texture takes a colour of
        the palette and, if it can move, an outline. On what is `lit`, `normal_map` shows bumps; `glow_map` and `glow`
        say what shines by itself (see Drawing). Higher layers lie over lower ones; within one, what was made later is
        on top. In perspective it is `behind` the plane of its layer, in metres, and reaches so many back (`depth`).

        Raises ArgumentError, ArgumentTypeError or AssetError, and draws nothing then.
        """
        owner = "Scene.add"
        shape, body = self._what(shape, body)
        place = placement(at, angle, owner) if matrix is None else to_matrix6(matrix, owner, "matrix")
        plain = colour is None and colours is None and texture is None
        tint = self._palette_colour(body) if plain else WHITE if colour is None else to_colour(colour, owner, "colour")
        corner_colours = None if colours is None else [to_colour(one, owner, "colours").rgba8 for one in colours]
        look = self._to_look(texture, animation, owner)
        surface = self.texture_id(normal_map, owner, "normal_map"), self.texture_id(glow_map, owner, "glow_map")
        shine = to_glow(glow, owner)
        image_place = None if texture_matrix is None else to_matrix6(texture_matrix, owner, "texture_matrix")
        tiles = None if tile is None else tile_size(tile, owner)
        if tiles is not None and (texture is None or texture_points is not None or texture_matrix is not None):
            raise ArgumentError(
                f"{owner}: tile={tile!r} needs a texture, and neither texture_points nor texture_matrix"
            )
        mixed = BLENDS.index(one_of(blend, owner, "blend", BLENDS))
        mirrored = switch(flip_x, owner, "flip_x"), switch(flip_y, owner, "flip_y")
        seen, in_light = switch(visible, owner, "visible"), switch(lit, owner, "lit")
        form = shape
        if slice is not None:
            others = (tile, texture_points, texture_matrix, colours)
            if texture is None or any(each is not None for each in others):
                raise ArgumentError(
                    f"{owner}: slice={slice!r} needs a texture, and no tile, texture_points, texture_matrix or colours"
                )
            form = sliced(shape, slice, self._size_of(texture, owner), owner)
            place = on_shape(shape, place)
        layer = to_layer(layer, owner)
        behind, depth = to_depth(behind, depth, owner)

        core = self._core
        handle = self._add_mesh(form, body, texture_points, corner_colours, shape)
        core.set_matrix(*handle, place)
        core.set_tint(*handle, tint.rgba8)
        self._show(handle, *look)
        core.set_flip_x(*handle, mirrored[0])
        core.set_flip_y(*handle, mirrored[1])
        core.set_blend(*handle, mixed)
        core.set_layer(*handle, layer)
        core.set_visible(*handle, seen)
        core.set_lit(*handle, in_light)
        core.set_surface(*handle, *surface)
        core.set_glow(*handle, shine)
        core.set_behind(*handle, behind)
        core.set_depth(*handle, depth)
        if tiles is not None:
            width, height = core.extent(*handle)
            image_place = (width / tiles[0], 0.0, 0.0, height / tiles[1], 0.0, 0.0)
        if image_place is not None:
            core.set_texture_matrix(*handle, image_place)
        drawing = Drawing(self, handle, body, shape)
        moves = body is None or body.kind != "static"
        drawing.outline = plain and moves if outline is None else outline
        self._from_palette += plain and moves
        if isinstance(body, DrawnBody):
            body._all_drawings().append(drawing)
        return drawing

    @known_keywords
    def text(
        self,
        text: object,
        *,
        at: Point = (16.0, 12.0),
        size: float = 18.0,
        colour: ColourLike = "white",
        anchor: str = "top left",
        visible: bool = True,
        font: str | None = None,
        width: float | None = None,
        align: str | None = None,
    ) -> Text:
        """Put text on the screen; see Text. `at`, `size` and `width` are logical points, `font` is a file (.ttf, .otf).

        Raises AssetError for a font that cannot be had.
        """
        fonts = self._require_fonts("Scene.text")
        line = Text(
            text, at, size, colour, anchor, visible, serial=self._texts_made, font=font, width=width, align=align
        )
        if font is not None:
            fonts(round(line.size), font, line.text)  # an error now is better than one in every frame
        self._texts_made += 1
        self._texts.append(line)
        return line

    @known_keywords
    def overlay(
        self,
        text: object,
        *,
        at: Point = (16.0, 12.0),
        size: float = 18.0,
        colour: ColourLike = "white",
        anchor: str = "top left",
    ) -> Text:
        """Put a line of text over everything that is no part of the game: it is not saved with it."""
        self._require_fonts("Scene.overlay")
        line = Text(text, at, size, colour, anchor, True)
        self._overlay.append(line)
        return line

    @property
    def emitters(self) -> tuple[Emitter, ...]:
        """The particle effects, in the order in which they were made."""
        return tuple(self._emitters)

    def step(self) -> None:
        """What moves by itself moves on by one step of the world, after that: particles, foam, the lamps of fires."""
        self.waters.step()
        self.gases.step()
        for emitter in tuple(self._emitters):
            emitter._step()

    def clear(self) -> None:
        """Take away all that is drawn, and what was said of the background, of layers and of the picture.

        What `overlay` put on the screen stays.
        """
        nothing = _core.SavedScene(_core.Scene().snapshot(self.world._core)[0])
        self._core.restore(nothing, self.world._core, [], [])
        self._core.clear_clips()
        self._clips.clear()
        for text in self._texts:
            if text.alive:
                text.destroy()
        for emitter in tuple(self._emitters):
            emitter.destroy()
        self.waters.clear()
        self.backgrounds = 0
        self.layers.clear()
        self.post.clear()
        self.lights.clear()
        self._texts, self._restored, self._from_palette, self.background = [], {}, 0, BACKGROUND
        self._restores += 1

    def _require_fonts(self, owner: str) -> Fonts:
        if self._fonts is None:
            raise ArgumentError(f"{owner}: this scene was given no fonts; Scene(fonts=...) takes them")
        return self._fonts

    def collect(
        self,
        camera: Camera,
        alpha: float = 1.0,
        pixel_size: tuple[int, int] | None = None,
        scale: float | None = None,
        *,
        overlay: bool = True,
    ) -> DrawList:
        """The frame at `alpha` (0..1) between the last two steps, for a picture of `pixel_size` real pixels.

        `scale` is how many of them a logical point is long; without it, what the screen shows fits the picture. Without
        `overlay` only what belongs to the game is on it. The list is good until the next `collect`.
        """
        width, height = (round(each) for each in (camera.size if pixel_size is None else pixel_size))
        number(width, "Scene.collect", "pixel_size", least=1)
        number(height, "Scene.collect", "pixel_size", least=1)
        screen = (width, height)
        if scale is None:
            scale = min(width / camera.size[0], height / camera.size[1])
        self.lights._begin_frame()
        frame = self.collect_world(camera, alpha, screen, scale)
        self._collect_over(screen, scale, overlay)
        return frame

    def collect_world(
        self, camera: Camera, alpha: float, screen: tuple[int, int], scale: float, *, into: int = 0
    ) -> DrawList:
        """What a camera sees, without what lies over all. Good until the next frame `into` the list of that number."""
        self._core.aim(into)
        self.gases.refresh()
        view = camera.matrix(screen, scale, alpha)
        eye = seen_middle(view, screen)
        self._core.set_layers(self.layers.rows(eye, camera.zoom), self.layers.depth(screen, camera.zoom))
        content = self._core.collect(self.world._core, view, alpha, scale)
        self._collect_layers(view, eye, camera.zoom, alpha, screen, scale)
        self.lights._smokes = self.gases.shadows()
        self.lights._collect(self._core, into, view, alpha, screen, scale)
        if self.post.on:
            self.post.put(self._core, self.world.steps)
        if self.debug:
            self.debug_view.draw(self._core, self.world, self.lights, self._fonts, view, alpha, screen, scale)
        return DrawList(screen, self._background.rgba8, content)

    def collect_screen(self, screen: tuple[int, int], scale: float, *, overlay: bool = True) -> _core.DrawList:
        """What lies over all, and nothing else."""
        self._core.aim(0)
        content = self._core.empty()
        self._collect_over(screen, scale, overlay)
        return content

    def _collect_over(self, screen: tuple[int, int], scale: float, overlay: bool) -> None:
        """What lies over the world, on the screen: text, panels, the graph."""
        if self.graph is not None and overlay:
            graph.draw(self._core, self.graph, self._fonts, screen, scale)
        for panel in self.panels if overlay else ():
            panel(self._core, self._fonts, screen, scale)
        self._texts = [text for text in self._texts if text.alive]
        self._overlay = [text for text in self._overlay if text.alive]
        for text in (*self._texts, *(self._overlay if overlay else ())):
            if text.visible and self._fonts is not None:
                text.draw(self._core, self._fonts, screen, scale)

    def _collect_layers(
        self, view: Matrix6, eye: Vec2, zoom: float, alpha: float, screen: tuple[int, int], scale: float
    ) -> None:
        """Particles and fog, layer after layer: what lies over a layer's drawings, and what lies over that."""
        over: list[tuple[int, bool, WaterLook | Emitter | Layer]] = [
            (water.layer, False, water) for water in self.waters.alive()
        ]
        over += [(each.layer, False, each) for each in self._emitters]
        over += [(each.number, True, each) for each in self.layers]
        for which, _, each in sorted(over, key=lambda row: row[:2]):
            seen = self.layers.view(which, view, eye, zoom)
            if isinstance(each, Layer):
                self.layers.cover(self._core, each, seen, screen, scale)
            elif isinstance(each, WaterLook) and seen is not None:
                each._collect(self, seen, alpha, screen, scale)
            elif isinstance(each, Emitter) and seen is not None:
                each._collect(seen, alpha, screen)

    def _take_restored(self, body: DrawnBody) -> list[Drawing]:
        """The drawings that the last restore put on `body`."""
        return [self._drawing(*row) for row in self._restored.pop((body.slot, body.generation), ())]

    def _drawing(self, slot: int, body: int, shape: int) -> Drawing:
        """The handle of the drawing in a slot, on these slots of the world."""
        on = None if body == _core.NO_SLOT else self.world._body(body)
        what = None if shape == _core.NO_SLOT else self.world._shape(shape)
        return Drawing(self, (slot, self._core.generation(slot)), on, what)

    def _what(self, shape: Any, body: Any) -> tuple[ShapeDefinition | Shape, Body | None]:
        """What `add` shall show, and the body that it is on."""
        if body is not None and not isinstance(body, Body):
            raise ArgumentTypeError(f"Scene.add: body={body!r} must be a Body, or None to stand by itself")
        if not isinstance(shape, Shape):
            shape = to_shape(shape, "Scene.add")
        elif body is not None and shape.body != body:
            raise ArgumentError(f"Scene.add: shape={shape!r} is on another body than body={body!r}; leave body out")
        else:
            body = shape.body
        if body is not None:
            body._require()
            if body.world is not self.world:
                raise ArgumentError(f"Scene.add: {body!r} lives in another world than the one that this scene shows")
        return shape, body

    def _add_mesh(
        self,
        shape: ShapeDefinition | Shape,
        body: Body | None,
        texture_points: Sequence[Point] | None,
        colours: Sequence[int] | None,
        on: ShapeDefinition | Shape,
    ) -> tuple[int, int]:
        if isinstance(shape, Shape):
            cornered = shape.outline[0] == "polygon"
        else:
            cornered = isinstance(shape, PolygonLike) and not shape.rounding
        if not cornered and (colours is not None or texture_points is not None):
            word = "colours" if colours is not None else "texture_points"
            raise ArgumentError(f"Scene.add: {word} are one for each corner, and {shape!r} has none")
        if isinstance(shape, Shape):
            return self._core.add_shape(self.world._core, shape.slot, SPECK, texture_points, colours)
        follows = None if body is None else (body.slot, body.generation)
        if isinstance(shape, Sliced):
            part = (on.slot, on.generation) if isinstance(on, Shape) else None
            return self._core.add_sliced(shape.width, shape.height, shape.border, shape.part, follows, part)
        return self._core.add_definition(shape._spec, SPECK, follows, texture_points, colours)

    def _palette_colour(self, body: Body | None) -> Colour:
        """The next colour; a body with several shapes has one, and what stands still is of stone."""
        if body is not None and body.kind == "static":
            return STONE
        if isinstance(body, DrawnBody) and body.drawings:
            return body.drawings[0].colour
        return PALETTE[self._from_palette % len(PALETTE)]
