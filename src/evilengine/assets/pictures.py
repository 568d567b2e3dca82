"""Pictures: images and fonts by name or size, each given to the renderer once, and again when its file changes."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Protocol

from evilengine.assets.fonts import Fonts
from evilengine.assets.images import Found, Images
from evilengine.values.errors import AssetError
from evilengine.values.font import Font
from evilengine.values.image import Image


class Textures(Protocol):
    """Who keeps images for drawing: every renderer does."""

    def upload(self, image: Image) -> int:
        """Keep `image` and return its id."""

    def update(self, texture: int, image: Image) -> None:
        """Show another image, of any size, wherever `texture` is drawn."""


@dataclass(slots=True)
class _Shown:
    """An image that the renderer has."""

    name: str
    found: Found
    stamp: tuple[int, int] | None
    texture: int
    points: tuple[float, float]


class Pictures:
    """What a scene asks for: texture ids of images by name, fonts by height in pixels.

    `scale` is how many real pixels a logical point has. On dense screens (1.5 and more) `crate@2x.png` is shown, where
    there is one, instead of `crate.png`; it counts as half as large, so nothing changes its size on the screen.
    """

    def __init__(self, textures: Textures, images: Images, *, scale: float = 1.0) -> None:
        self.images = images
        self._textures = textures
        self._scale = scale
        self._all_fonts = Fonts()
        self._shown: dict[Path, _Shown] = {}
        self._by_name: dict[str, _Shown] = {}
        self._fonts: dict[int, tuple[int, Font]] = {}
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

    def texture(self, name: str) -> int:
        """The texture id of the image called `name`, uploaded once. Raises AssetError if it cannot be had."""
        return self._show(name).texture

    def size(self, name: str) -> tuple[float, float]:
        """Width and height of the image called `name`, in logical points. Raises AssetError if it cannot be had."""
        return self._show(name).points

    def font(self, pixels: int) -> tuple[int, Font]:
        """The texture id and the font of a height in pixels."""
        if pixels not in self._fonts:
            font = self._all_fonts.load(pixels)
            self._fonts[pixels] = self._textures.upload(font.image), font
        return self._fonts[pixels]

    def reload(self) -> list[str]:
        """Show the images whose files have changed as they are now.

        One that cannot be read any more stays as it was; the lines returned say why, once for each change. A file
        that is gone is no change: editors take theirs away for a moment.
        """
        lines, self._unsaid = self._unsaid, []
        return lines + [line for shown in self._shown.values() if (line := self._reload(shown))]

    def _show(self, name: str) -> _Shown:
        if name not in self._by_name:
            found = self.images.find_for(name, self._scale)
            if found.plain not in self._shown:
                stamp = stamp_of(found.path)
                image = self._decode(found.path)
                texture = self._textures.upload(image)
                self._shown[found.plain] = _Shown(name, found, stamp, texture, _points(image, found))
            self._by_name[name] = self._shown[found.plain]
        return self._by_name[name]

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
            image = self._decode(found.path)
        except AssetError as error:
            return f"{error}; it is shown as it was"
        self._textures.update(shown.texture, image)
        shown.points = _points(image, found)
        return ""

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


def _points(image: Image, found: Found) -> tuple[float, float]:
    return image.width / found.density, image.height / found.density
