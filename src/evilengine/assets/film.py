"""Films: frames of a game as one animated picture file."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from itertools import chain, islice
from pathlib import Path
from typing import IO, TYPE_CHECKING

from evilengine.assets.film_formats import WRITERS, Box, Writer
from evilengine.values import picture_files
from evilengine.values.checks import did_you_mean, known_keywords, number
from evilengine.values.errors import ArgumentError
from evilengine.values.image import Image

if TYPE_CHECKING:
    from PIL.Image import Image as Picture


@known_keywords
def save_film(
    frames: Iterable[Image],
    path: str | Path,
    *,
    fps: float = 30.0,
    loop: bool = True,
    progress: Callable[[int], None] | None = None,
) -> Path:
    """Write `frames` to `path` as an animated .webp, .gif or .png, and return the path.

    Each frame is encoded as it comes, so `frames` may be a generator and the film as long as the disk is large. A
    single frame makes a still picture. `fps` is frames a second, at most 50 for .gif, whose clock is coarse;
    `progress` is called with the number of frames done. The file appears once it is whole; if anything raises, none
    appears. Frames are opaque: what is not stands on black.

    Raises ArgumentError for an unknown ending, no frames, or frames of different sizes; AssetError if `path` cannot be
    written.
    """
    path = Path(path)
    ending = path.suffix.lower()
    if ending not in WRITERS:
        raise ArgumentError(
            f"save_film({str(path)!r}): the ending {ending!r} must be one of {', '.join(WRITERS)}"
            f"{did_you_mean(ending, WRITERS)}"
        )
    writer = WRITERS[ending]()
    fps = number(fps, "save_film", "fps", above=0.0, most=writer.most_fps)
    with picture_files.replacing(path) as file:
        coming = iter(frames)
        opening = list(islice(coming, 2))
        if not opening:
            raise ArgumentError(f"save_film({str(path)!r}): there are no frames")
        if len(opening) == 2:
            _encode(chain(opening, coming), file, writer, fps, loop, progress)
            return path
    picture_files.save(opening[0], path)
    if progress is not None:
        progress(1)
    return path


def _encode(
    frames: Iterator[Image],
    file: IO[bytes],
    writer: Writer,
    fps: float,
    loop: bool,
    progress: Callable[[int], None] | None,
) -> None:
    """Hand the writer each change between frames, once it is known how long it stays."""
    shown: Picture | None = None
    waiting: tuple[Picture, Box, int] | None = None  # the last change: picture, where it changed, frame number
    count = 0
    for count, frame in enumerate(frames, 1):
        picture = picture_files.on_black(frame)
        if shown is None:
            writer.begin(file, picture.size, loop)
            box: Box | None = (0, 0, *picture.size)
        elif picture.size != shown.size:
            raise ArgumentError(f"save_film: frame {count} is {picture.size}, those before were {shown.size}")
        else:
            box = writer.widen(_changed(shown, picture))
        if box is not None:
            if waiting is not None:
                before = waiting[2]
                writer.add(waiting[0], waiting[1], _ticks(writer, fps, before, count - 1))
            waiting = (*writer.prepare(picture, shown, box), count - 1)
        shown = picture
        if progress is not None:
            progress(count)
    if waiting is not None:
        writer.add(waiting[0], waiting[1], _ticks(writer, fps, waiting[2], count))
    writer.end()


def _ticks(writer: Writer, fps: float, start: int, end: int) -> int:
    """How long the frames start..end last on the writer's clock, rounded so that the whole film keeps time."""
    return round(end * writer.clock / fps) - round(start * writer.clock / fps)


def _changed(before: Picture, after: Picture) -> Box | None:
    from PIL import ImageChops

    return ImageChops.difference(before, after).getbbox()
