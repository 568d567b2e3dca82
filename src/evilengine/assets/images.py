"""Images: pictures by name, found and decoded once."""

from __future__ import annotations

import os
import warnings
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from evilengine.values import picture_files
from evilengine.values.checks import did_you_mean
from evilengine.values.errors import ArgumentTypeError, AssetError
from evilengine.values.image import Image

if TYPE_CHECKING:
    from PIL.Image import Image as Picture

MAX_SIDE = 16384
"""Pixels; the longest side that a renderer takes."""

MAX_PIXELS = 2**26
"""8192 x 8192, a quarter of a gigabyte once decoded: beyond, a small file could fill the memory."""

DENSE = 1.5
"""Real pixels a logical point from which on a screen gets the pictures drawn for dense ones."""

TWICE = "@2x"
"""At the end of a file's name: drawn with two pixels for each point."""

FORMATS = ("PNG", "JPEG", "WEBP", "GIF", "BMP", "TIFF", "TGA", "PPM", "ICO", "AVIF")
"""What is tried on a file, whatever its ending. Formats that start other programs (EPS) are not among them."""


@dataclass(frozen=True, slots=True)
class Found:
    """The file that shows a picture on a screen."""

    path: Path
    density: int
    """Pixels a logical point that it was drawn with: 1, or 2 with TWICE in its name."""

    @property
    def plain(self) -> Path:
        """One path for all densities of the same picture."""
        return Path(os.path.abspath(self.path.with_stem(_plain(self.path.stem))))


class Images:
    """Finds pictures in folders and decodes each once.

    Names are relative to the folders, which are searched in order; a full path works too. Any size up to MAX_SIDE and
    MAX_PIXELS will do, in any colour mode; pictures that a camera laid on their side are set upright, and of animated
    ones the first frame counts.

    >>> images = Images("levels/art")
    >>> images.load("crate.png")
    Traceback (most recent call last):
    evilengine.values.errors.AssetError: image 'crate.png': there is no such file in levels/art
    """

    def __init__(self, *folders: str | Path) -> None:
        self.folders = tuple(Path(folder) for folder in folders) or (Path(),)
        self._loaded: dict[Path, Image] = {}

    def load(self, name: str | Path) -> Image:
        """The picture called `name`.

        Raises AssetError that says why if it is missing, damaged, no picture or too large.
        """
        path = self.find(name)
        key = Path(os.path.abspath(path))
        if key not in self._loaded:
            self._loaded[key] = _decode(path, str(name))
        return self._loaded[key]

    def find(self, name: str | Path) -> Path:
        """The file of the picture called `name`. Raises AssetError, with the nearest name, if there is none."""
        if not isinstance(name, (str, Path)):
            raise ArgumentTypeError(f"Images.load: name={name!r} must be a file name")
        if not str(name) or "\0" in str(name):
            raise AssetError(f"image {str(name)!r}: this is no file name")
        for folder in self.folders:
            if _is(Path.is_file, folder / name):
                return folder / name
        raise self._missing(name)

    def find_for(self, name: str | Path, scale: float) -> Found:
        """The file of the picture called `name` for a screen with `scale` real pixels a logical point.

        Beside `crate.png` there may be `crate@2x.png` for dense screens; either serves where the other is missing, and
        both are found by either name. Raises AssetError if there is neither.
        """
        if isinstance(name, (str, Path)) and Path(name).name:
            plain = Path(name).with_stem(_plain(Path(name).stem))
            pair = Found(plain, 1), Found(plain.with_stem(plain.stem + TWICE), 2)
            for folder in self.folders:
                for one in reversed(pair) if scale >= DENSE else pair:
                    if _is(Path.is_file, folder / one.path):
                        return Found(folder / one.path, one.density)
        return Found(self.find(name), 1)

    def beside(self, name: str, ending: str) -> str | None:
        """The name of the picture beside `name` whose stem ends so, as `rock.normal.png`; None if there is none."""
        if not Path(name).name:
            return None
        plain = Path(name).with_stem(_plain(Path(name).stem) + ending)
        both = plain, plain.with_stem(plain.stem + TWICE)
        there = any(_is(Path.is_file, folder / one) for folder in self.folders for one in both)
        return str(plain) if there else None

    def _missing(self, name: str | Path) -> AssetError:
        searched = " or ".join(str(folder) for folder in self.folders)
        if any(_is(Path.is_dir, folder / name) for folder in self.folders):
            return AssetError(f"image {str(name)!r}: this is a folder, not a picture")
        return AssetError(
            f"image {str(name)!r}: there is no such file in {searched}{did_you_mean(name, self._names(name))}"
        )

    def forget(self, name: str | Path) -> None:
        """Decode `name` anew the next time it is loaded: the file has changed."""
        for folder in self.folders:
            self._loaded.pop(Path(os.path.abspath(folder / name)), None)

    def _names(self, near: str | Path) -> list[str]:
        """What could have been meant: the files beside where `near` would be."""
        names = []
        for folder in self.folders:
            beside = (folder / near).parent
            if _is(Path.is_dir, beside):
                names += [str(Path(near).parent / path.name) for path in sorted(beside.iterdir())]
        return names


def _plain(stem: str) -> str:
    return stem.removesuffix(TWICE) or stem


def _is(kind: Callable[[Path], bool], path: Path) -> bool:
    try:
        return kind(path)
    except OSError:  # such as a name that is too long
        return False


def _decode(path: Path, name: str) -> Image:
    import PIL.Image

    try:
        with warnings.catch_warnings(), path.open("rb") as file:
            warnings.simplefilter("ignore")  # of odd but readable files
            PIL.Image.init()
            known = [name for name in FORMATS if name in PIL.Image.OPEN]  # older Pillows lack AVIF
            with PIL.Image.open(file, formats=known) as picture:
                _check_size(picture, name)
                return picture_files.from_pillow(_straightened(picture))
    except AssetError:
        raise
    except PIL.Image.DecompressionBombError:
        raise AssetError(f"image {name!r} ({path}): it is larger than {MAX_PIXELS} pixels") from None
    except PIL.UnidentifiedImageError:
        raise AssetError(
            f"image {name!r} ({path}): this is no picture that can be read ({_first_bytes(path)}); "
            f"known are {', '.join(FORMATS)}"
        ) from None
    except PermissionError as problem:
        raise AssetError(f"image {name!r} ({path}): {problem.strerror}") from problem
    except MemoryError:
        raise AssetError(f"image {name!r} ({path}): there is not enough memory for it") from None
    except Exception as problem:  # what decoders raise for damaged files has no common root
        raise AssetError(f"image {name!r} ({path}): the file is damaged or cut short: {problem}") from problem


def _check_size(picture: Picture, name: str) -> None:
    width, height = picture.size
    if width > MAX_SIDE or height > MAX_SIDE or width * height > MAX_PIXELS or width * height == 0:
        raise AssetError(
            f"image {name!r}: {width} x {height} pixels; a side may have at most {MAX_SIDE} and the whole {MAX_PIXELS}"
        )


def _straightened(picture: Picture) -> Picture:
    """The picture upright and in eight bits a channel."""
    import PIL.ImageOps

    upright = PIL.ImageOps.exif_transpose(picture) or picture
    if upright.mode.startswith("I;16"):
        return _in_eight_bits(upright.convert("I"), 1 / 256)
    if upright.mode == "I":  # 32 bits, but files of 16 bits come so as well
        return _in_eight_bits(upright, 1 / 256 if _largest(upright) > 255 else 1.0)
    if upright.mode == "F":  # 0..1 by custom
        return _in_eight_bits(upright, 255.0 if _largest(upright) <= 1.0 else 1.0)
    if upright.mode in ("LAB", "HSV", "YCbCr", "CMYK"):
        return upright.convert("RGB")
    return upright


def _in_eight_bits(picture: Picture, factor: float) -> Picture:
    return picture.point(lambda value: value * factor + 0).convert("L")


def _largest(picture: Picture) -> float:
    """The largest value in a picture with one channel."""
    high = picture.getextrema()[1]
    assert isinstance(high, (int, float))
    return high


def _first_bytes(path: Path) -> str:
    with path.open("rb") as file:
        start = file.read(12)
    return f"it starts with {start!r}" if start else "it is empty"
