"""Pictures: images, frames and fonts, each given to the renderer once, and again when its file changes."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Protocol

from evilengine.assets.fonts import Fonts
from evilengine.assets.images import Found, Images
from evilengine.values import picture_files
from evilengine.values.errors import AssetError
from evilengine.values.font import Font
from evilengine.values.image import Image
from evilengine.values.sheet import Cell, Grid, Normals

NORMAL, GLOW = ".normal", ".glow"
"""At the end of the stems of files that lie beside a picture: `rock.normal.png`, `rock.glow.png` beside `rock.png`."""

FLAT = (128, 128, 255, 255)
"""The colour of a normal that points straight out."""


class Textures(Protocol):
    """Who keeps images for drawing: every renderer does."""

    def upload(self, image: Image) -> int:
        """Keep `image` and return its id."""

    def update(self, texture: int, image: Image) -> None:
        """Show another image, of any size, wherever `texture` is drawn."""


@dataclass(slots=True)
class _Shown:
    """An image that the renderer has, whole or as the frames of a sheet."""

    what: str | Grid
    normals: bool
    keeper: Textures
    found: Found
    stamp: tuple[int, int] | None
    textures: tuple[int, ...]
    points: tuple[float, float]
    """The size of the image, or of one frame."""

    @property
    def name(self) -> str:
        return self.what if isinstance(self.what, str) else self.what.image


class Pictures:
    """What a scene asks for: texture ids of images by name, fonts by height in pixels.

    `scale` is how many real pixels a logical point has. On dense screens (1.5 and more) `crate@2x.png` is shown, where
    there is one, instead of `crate.png`; it counts as half as large, so nothing changes its size on the screen.
    """

    def __init__(self, textures: Textures, images: Images, *, scale: float = 1.0) -> None:
        self.images = images
        self._textures = textures
        self._scale = scale
        self._all_fonts = Fonts(*images.folders)
        self._shown: dict[tuple[Path, Grid | None, bool, Textures], _Shown] = {}
        self._by_name: dict[tuple[str | Grid, bool, Textures], _Shown] = {}
        self._fonts: dict[tuple[str | None, int], tuple[int, Font]] = {}
        self._unsaid: list[str] = []  # what another screen's pictures brought up, for the next reload to say

    @property
    def scale(self) -> float:
        """Real pixels a logical point; set it when the window moves to another screen."""
        return self._scale

    @scale.setter
    def scale(self, value: float) -> None:
        if value != self._scale:
            self._scale = value
            self._unsaid = self.reload()

    def texture(self, what: str | Cell | Normals) -> int:
        """The texture id of an image or a frame, uploaded once. Raises AssetError if it cannot be had."""
        image, normals = (what.of, True) if isinstance(what, Normals) else (what, False)
        if isinstance(image, Cell):
            return self._show(image.grid, normals).textures[image.number]
        return self._show(image, normals).textures[0]

    def slide(self, name: str, lights: Textures) -> int:
        """The number by which `lights` know an image that they shine through, given to them once, and again when its
        file changes. Raises AssetError if it cannot be had."""
        return self._show(name, False, lights).textures[0]

    def surface(self, what: str | Cell) -> tuple[int, int]:
        """The texture ids of the normals and of what glows that lie beside an image, 0 where there are none.

        Raises AssetError for a file that is there and cannot be read.
        """
        normals, glows = self._beside(what, NORMAL), self._beside(what, GLOW)
        return self.texture(Normals(normals)) if normals else 0, self.texture(glows) if glows else 0

    def _beside(self, what: str | Cell, ending: str) -> str | Cell | None:
        """The image or frame with that ending in its name, if there is one."""
        name = self.images.beside(what if isinstance(what, str) else what.grid.image, ending)
        if name is None or isinstance(what, str):
            return name
        return what._replace(grid=what.grid._replace(image=name))

    def size(self, what: str | Grid) -> tuple[float, float]:
        """Width and height of an image, or of each frame of a sheet, in logical points. Raises AssetError likewise."""
        return self._show(what, False).points

    def font(self, pixels: int, name: str | None = None, characters: str = "") -> tuple[int, Font]:
        """The texture id and the font of a height in pixels: the engine's own, or that of a file, which has
        `characters`. Raises AssetError if it cannot be had."""
        font = self._all_fonts.load(pixels, name, characters)
        texture, shown = self._fonts.get((name, pixels), (0, None))
        if shown is None:
            texture = self._textures.upload(font.image)
        elif shown is not font:
            self._textures.update(texture, font.image)
        self._fonts[name, pixels] = texture, font
        return texture, font

    def reload(self) -> list[str]:
        """Show the images whose files have changed as they are now.

        One that cannot be read any more stays as it was; the lines returned say why, once for each change. A file
        that is gone is no change: editors take theirs away for a moment.
        """
        lines, self._unsaid = self._unsaid, []
        return lines + [line for shown in self._shown.values() if (line := self._reload(shown))]

    def _show(self, what: str | Grid, normals: bool, keeper: Textures | None = None) -> _Shown:
        keeper = keeper or self._textures
        if (what, normals, keeper) not in self._by_name:
            grid = what if isinstance(what, Grid) else None
            found = self.images.find_for(what if isinstance(what, str) else what.image, self._scale)
            key = found.plain, grid and grid._replace(image=""), normals, keeper
            if key not in self._shown:
                stamp = stamp_of(found.path)
                pictures = self._pictures_in(found, what, normals)
                textures = tuple(keeper.upload(picture) for picture in pictures)
                self._shown[key] = _Shown(what, normals, keeper, found, stamp, textures, _points(pictures[0], found))
            self._by_name[what, normals, keeper] = self._shown[key]
        return self._by_name[what, normals, keeper]

    def _reload(self, shown: _Shown) -> str:
        try:
            found = self.images.find_for(shown.name, self._scale)
        except AssetError:
            return ""
        stamp = stamp_of(found.path)
        if stamp is None or (found, stamp) == (shown.found, shown.stamp):
            return ""
        shown.found, shown.stamp = found, stamp
        try:
            pictures = self._pictures_in(found, shown.what, shown.normals)
        except AssetError as error:
            return f"{error}; it is shown as it was"
        for texture, picture in zip(shown.textures, pictures, strict=True):
            shown.keeper.update(texture, picture)
        shown.points = _points(pictures[0], found)
        return ""

    def _pictures_in(self, found: Found, what: str | Grid, normals: bool) -> list[Image]:
        image = self._decode(found.path)
        if normals:
            image = picture_files.over(image, FLAT)  # where it is transparent, nothing was said of the surface
        return [image] if isinstance(what, str) else cut(image, what, found.density)

    def _decode(self, path: Path) -> Image:
        """The picture at `path`; only the renderer keeps it."""
        self.images.forget(path)
        image = self.images.load(path)
        self.images.forget(path)
        return image


def stamp_of(path: Path) -> tuple[int, int] | None:
    """What changes when the file at `path` does; None while there is none."""
    try:
        status = path.stat()
    except OSError:
        return None
    return status.st_mtime_ns, status.st_size


def cut(image: Image, grid: Grid, density: int = 1) -> list[Image]:
    """The cells of a picture that has `density` pixels a logical point. Raises AssetError if the grid does not fit it.

    >>> picture = Image.of(4, 1, bytes(range(16)))
    >>> [cell.tobytes()[0] for cell in cut(picture, Grid("", 2, 1, 0, 0))]
    [0, 8]
    """
    margin, spacing = round(grid.margin * density), round(grid.spacing * density)
    width = image.width - 2 * margin - (grid.columns - 1) * spacing
    height = image.height - 2 * margin - (grid.rows - 1) * spacing
    if width < grid.columns or height < grid.rows or width % grid.columns or height % grid.rows:
        raise AssetError(
            f"image {grid.image!r}: {image.width} x {image.height} pixels do not divide into"
            f" {grid.columns} x {grid.rows} frames of one size, margin={grid.margin:g}, spacing={grid.spacing:g}"
        )
    width, height = width // grid.columns, height // grid.rows
    flat, row = image.tobytes(), image.width * 4
    cells = []
    for down in range(grid.rows):
        for across in range(grid.columns):
            first = (margin + down * (height + spacing)) * row + (margin + across * (width + spacing)) * 4
            lines = [flat[start : start + 4 * width] for start in range(first, first + height * row, row)]
            cells.append(Image.of(width, height, b"".join(lines)))
    return cells


def _points(image: Image, found: Found) -> tuple[float, float]:
    return image.width / found.density, image.height / found.density
