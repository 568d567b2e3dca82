"""Images to and from Pillow, which is slow to import: nothing outside functions may need it."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import IO, TYPE_CHECKING, Any

from evilengine.values.checks import did_you_mean
from evilengine.values.errors import ArgumentError, AssetError, Error
from evilengine.values.image import Image

if TYPE_CHECKING:
    from PIL.Image import Image as Picture

FORMATS: dict[str, tuple[str, dict[str, Any]]] = {
    ".png": ("PNG", {}),
    ".webp": ("WEBP", {"lossless": True}),  # a single picture stays exact; films are lossy (assets/film.py)
    ".jpg": ("JPEG", {"quality": 92}),
    ".jpeg": ("JPEG", {"quality": 92}),
    ".bmp": ("BMP", {}),
    ".gif": ("GIF", {}),
    ".tga": ("TGA", {}),
    ".tif": ("TIFF", {}),
    ".tiff": ("TIFF", {}),
}
WITHOUT_ALPHA = {"JPEG", "BMP", "GIF"}


def save(image: Image, path: Path) -> Path:
    """Write `image` to `path`, in the format of its ending, and return the path.

    The file appears whole or not at all. Formats without transparency show the image on black. Raises ArgumentError
    for an unknown ending and AssetError for a path that cannot be written.
    """
    ending = path.suffix.lower()
    if ending not in FORMATS:
        raise ArgumentError(
            f"Image.save({str(path)!r}): the ending {ending!r} must be one of {', '.join(FORMATS)}"
            f"{did_you_mean(ending, FORMATS)}"
        )
    kind, options = FORMATS[ending]
    with replacing(path) as file:
        picture = on_black(image) if kind in WITHOUT_ALPHA else to_pillow(image)
        picture.save(file, kind, **options)
    return path


def to_pillow(image: Image) -> Picture:
    """The same pixels as a Pillow image."""
    import PIL.Image

    return PIL.Image.frombytes("RGBA", image.size, image.tobytes())


def on_black(image: Image) -> Picture:
    """The image without alpha, as a Pillow image: what is not opaque stands on black."""
    import PIL.Image

    picture = to_pillow(image)
    opaque = picture.convert("RGB")
    alpha = picture.getchannel("A")
    if alpha.getextrema() == (255, 255):
        return opaque
    return PIL.Image.composite(opaque, PIL.Image.new("RGB", image.size), alpha)


def over(image: Image, colour: tuple[int, int, int, int]) -> Image:
    """The image laid over one colour."""
    import PIL.Image

    return from_pillow(PIL.Image.alpha_composite(PIL.Image.new("RGBA", image.size, colour), to_pillow(image)))


def from_pillow(picture: Picture) -> Image:
    """A Pillow image, of any mode that `convert` knows, as an Image."""
    rgba = picture if picture.mode == "RGBA" else picture.convert("RGBA")
    return Image.of(rgba.width, rgba.height, rgba.tobytes())


@contextmanager
def replacing(path: Path) -> Iterator[IO[bytes]]:
    """A file to write, which takes the place of `path` once all went well and leaves no trace otherwise."""
    written: str | None = None
    try:
        if path.is_dir():
            raise AssetError(f"cannot write {str(path)!r}: it is a folder")
        handle, written = tempfile.mkstemp(prefix=f".{path.stem[:40]}-", suffix=path.suffix, dir=path.parent)
        with os.fdopen(handle, "w+b") as file:
            yield file
        os.chmod(written, 0o666 & ~_umask())  # a temporary file is its owner's alone
        os.replace(written, path)
        written = None
    except Error:
        raise
    except (OSError, ValueError) as problem:  # ValueError: a path with a null byte, a picture its format refuses
        reason = problem.strerror if isinstance(problem, OSError) and problem.strerror else str(problem)
        raise AssetError(f"cannot write {str(path)!r}: {reason}") from problem
    finally:
        if written is not None:
            Path(written).unlink(missing_ok=True)


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask
