"""Which pictures a scene shows: images by name, frames of sheets, and what lies beside them."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeAlias

from evilengine import _core
from evilengine.scene.animated import Clip, clip_of, still
from evilengine.values.errors import ArgumentError, ArgumentTypeError, AssetError
from evilengine.values.sheet import COURSES, Cell, Grid, Normals, Sheet
from evilengine.values.tick import STEP
from evilengine.world.world import World

Textures: TypeAlias = Callable[[str | Cell | Normals], int]
"""Gives the texture id for an image's name or a frame of a sheet, or raises AssetError; it keeps what it loaded."""

Surfaces: TypeAlias = Callable[[str | Cell], tuple[int, int]]
"""Gives the texture ids of the normals and of what glows that lie beside an image or a frame, 0 for none."""


Sizes: TypeAlias = Callable[[str | Grid], tuple[float, float]]
"""Gives width and height of an image, or of each frame of a sheet, in logical points, or raises AssetError."""


class Shown:
    """The part of a scene that knows pictures."""

    def __init__(self, world: World, textures: Textures | None, surfaces: Surfaces | None, sizes: Sizes | None) -> None:
        self.world = world
        self._core = _core.Scene()
        self._textures = textures
        self._surfaces = surfaces
        self._sizes = sizes
        self._texture_names: dict[int, str | Normals] = {}
        self._dressed: dict[int, tuple[str | Cell, tuple[int, int]]] = {}  # textures, and what the core knows of them
        self._failed: dict[int, str] = {}  # textures of which something cannot be read, and why
        self._clips: list[Clip] = []  # as the core counts them

    def texture_id(self, name: object, owner: str, argument: str = "texture") -> int:
        """The texture id of the image called `name`; 0 for None. Raises AssetError for an image that cannot be had."""
        if name is None:
            return 0
        if not isinstance(name, str):
            raise ArgumentTypeError(f"{owner}: {argument}={name!r} must be the name of an image, such as 'crate.png'")
        if self._textures is None:
            raise ArgumentError(
                f"{owner}: {argument}={name!r}: this scene was given no images; Scene(textures=...) takes them"
            )
        what = Normals(name) if argument == "normal_map" else name
        texture = self._textures(what)
        self._texture_names[texture] = what
        if isinstance(what, str):
            self._dress(texture, what)
        return texture

    def _size_of(self, texture: str | Sheet, owner: str) -> tuple[float, float]:
        """Width and height of a picture, or of each frame of a sheet, in logical points."""
        if self._sizes is None:
            raise ArgumentError(f"{owner}: texture={texture!r}: this scene knows no sizes; Scene(sizes=...) takes them")
        return self._sizes(texture.grid if isinstance(texture, Sheet) else texture)

    def _name_of(self, texture: int) -> str | None:
        """The name that a texture was asked for by."""
        what = self._texture_names.get(texture)
        return what if what is None or isinstance(what, str) else str(what.of)

    def _dress(self, texture: int, what: str | Cell) -> None:
        """Tell the core what goes with a picture wherever it is shown."""
        if self._surfaces is not None and texture not in self._dressed:
            surface = self._surfaces(what)
            self._core.set_surface_of(texture, *surface)
            self._dressed[texture] = what, surface

    def dress_anew(self) -> list[str]:
        """See normals and what glows that have come to lie beside pictures since; lines that say why one cannot be
        read, once for each reason."""
        lines: list[str] = []
        failed: dict[int, str] = {}
        for texture, (what, known) in self._dressed.items():
            assert self._surfaces is not None
            try:
                normals, glows = self._surfaces(what)
            except AssetError as error:
                failed[texture] = str(error)
                if self._failed.get(texture) != failed[texture]:
                    lines.append(f"{error}; it is left out")
                continue
            surface = normals or known[0], glows or known[1]  # one that is gone for a moment stays
            if surface != known:
                self._core.set_surface_of(texture, *surface)
                self._dressed[texture] = what, surface
        self._failed = failed
        return lines

    def _clip_number(self, clip: Clip) -> int:
        """The number by which the core knows a clip, which is handed to it when it is new."""
        if clip not in self._clips:
            if self._textures is None:
                raise ArgumentError(f"{clip.sheet!r}: this scene was given no images; Scene(textures=...) takes them")
            frames = {frame: self._textures(Cell(clip.sheet.grid, frame)) for frame in sorted(set(clip.frames))}
            for frame, texture in frames.items():
                self._dress(texture, Cell(clip.sheet.grid, frame))
            textures = [frames[frame] for frame in clip.frames]
            self._core.add_clip(textures, 1.0 / (clip.fps * STEP), COURSES.index(clip.course))
            self._clips.append(clip)
        return self._clips.index(clip)

    def _clip_shown(self, slot: int, generation: int) -> Clip | None:
        """The clip that a drawing shows, None for one without a sheet."""
        now = self._core.playing(self.world._core, slot, generation)
        return None if now is None else self._clips[now[0]]

    def _to_look(self, texture: object, animation: str | None, owner: str) -> tuple[int, int | None]:
        """What a drawing shows, checked: the texture id, or the number of a clip."""
        if isinstance(texture, Sheet):
            clip = still(texture, 0) if animation is None else clip_of(texture, animation, owner)
            return 0, self._clip_number(clip)
        if animation is not None:
            raise ArgumentError(f"{owner}: animation={animation!r} needs texture=evil.Sheet(...), not {texture!r}")
        return self.texture_id(texture, owner), None

    def _show(self, handle: tuple[int, int], texture: int, clip: int | None) -> None:
        self._core.set_texture(*handle, texture)
        self._core.play(*handle, clip, self.world.steps)
