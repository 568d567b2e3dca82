"""Sheet: many pictures in one file, side by side in a grid, and the animations made of them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from types import MappingProxyType
from typing import Any, NamedTuple, cast

from evilengine.values.checks import did_you_mean, known_keywords, number, one_of
from evilengine.values.errors import ArgumentError, ArgumentTypeError

COURSES = ("loop", "once", "back")
"""What an animation does at its last frame: begins again, stays there, goes back the way it came."""

MOST_CELLS = 4096
"""Frames of a sheet: each becomes a picture of its own."""

ALL_FRAMES = "all"
"""The animation of a level's picture that has frames."""

MOST_FRAMES = 10_000
SLOWEST, FASTEST = 0.001, 1000.0  # frames a second


class Grid(NamedTuple):
    """How a picture is divided: cells from its top left corner, row by row."""

    image: str
    columns: int
    rows: int
    margin: float
    """Logical points of the picture round all cells, which no cell has."""
    spacing: float
    """Logical points between one cell and the next."""

    @property
    def cells(self) -> int:
        """How many cells there are."""
        return self.columns * self.rows


class Cell(NamedTuple):
    """One frame of a grid, by its number from 0 at the top left."""

    grid: Grid
    number: int


class Normals(NamedTuple):
    """A picture that says which way a surface faces: r, g, b for x, y, z, 128 for 0, y up."""

    of: str | Cell


class Animation:
    """Frames of a sheet in the order in which they are shown.

    `fps` frames a second, as many as the sheet has without it; `course` says what comes after the last: "loop" begins
    again, "once" stays there, "back" goes there and back again.

    >>> Animation([4, 5, 6], fps=8, course="once")
    Animation([4, 5, 6], fps=8, course='once')
    """

    __slots__ = ("course", "fps", "frames")

    @known_keywords
    def __init__(self, frames: Iterable[int], *, fps: float | None = None, course: str = "loop") -> None:
        self.frames = _frames(frames, "Animation")
        self.fps = None if fps is None else rate(fps, "Animation")
        self.course = one_of(course, "Animation", "course", COURSES)

    def _key(self) -> tuple[Any, ...]:
        return self.frames, self.fps, self.course

    def __eq__(self, other: object) -> bool:
        return self._key() == other._key() if isinstance(other, Animation) else NotImplemented

    def __hash__(self) -> int:
        return hash(self._key())

    def __repr__(self) -> str:
        fps = "" if self.fps is None else f", fps={self.fps:g}"
        return f"Animation({list(self.frames)}{fps}, course={self.course!r})"


class Sheet:
    """A picture of `columns` x `rows` frames of one size; give it wherever a texture is asked for.

    Frames count from 0, row by row from the top left. `margin` logical points round all of them and `spacing` between
    them belong to none. `animations` gives names to rows of frames, as numbers or an Animation; they are shown at `fps`
    frames a second. Each frame becomes a picture of its own, so its neighbours never shine through.

    >>> jump = Animation([6, 7, 8], course="once")
    >>> hero = Sheet("hero.png", 6, 2, fps=10, animations={"walk": range(6), "jump": jump})
    >>> hero.animations["walk"].frames
    (0, 1, 2, 3, 4, 5)
    """

    __slots__ = ("animations", "fps", "grid")

    @known_keywords
    def __init__(
        self,
        image: str,
        columns: int,
        rows: int = 1,
        *,
        margin: float = 0.0,
        spacing: float = 0.0,
        fps: float = 12.0,
        animations: Mapping[str, Iterable[int] | Animation] | None = None,
    ) -> None:
        if not isinstance(image, str) or not image:
            raise ArgumentTypeError(f"Sheet: image={image!r} must be the name of an image, such as 'hero.png'")
        self.grid = Grid(
            image,
            _whole(columns, "columns"),
            _whole(rows, "rows"),
            number(margin, "Sheet", "margin", least=0.0, most=1e4),
            number(spacing, "Sheet", "spacing", least=0.0, most=1e4),
        )
        if self.grid.cells > MOST_CELLS:
            raise ArgumentError(f"Sheet: {columns} x {rows} frames are more than {MOST_CELLS}")
        self.fps = rate(fps, "Sheet")
        if not isinstance(animations, Mapping | None):
            raise ArgumentTypeError(f"Sheet: animations={animations!r} must be a dict of names and frames")
        self.animations: Mapping[str, Animation] = MappingProxyType(
            {name: self._animation(name, each) for name, each in (animations or {}).items()}
        )

    @property
    def image(self) -> str:
        """The name of the picture."""
        return self.grid.image

    def __len__(self) -> int:
        """How many frames there are."""
        return self.grid.cells

    def animation(self, name: str | None, owner: str) -> Animation:
        """The animation called `name`; None: all frames in a row. Raises ArgumentError for a name it does not have."""
        if name is None:
            return Animation(range(len(self)))
        if name not in self.animations:
            known = list(self.animations)
            there_are = f"; there are {', '.join(known)}" if known else "; Sheet(..., animations={...}) names some"
            raise ArgumentError(
                f"{owner}: {self.image!r} has no animation {name!r}{did_you_mean(name, known)}{there_are}"
            )
        return self.animations[name]

    def _animation(self, name: object, given: object) -> Animation:
        if not isinstance(name, str) or not name:
            raise ArgumentTypeError(f"Sheet: animations: {name!r} must be a name")
        animation = given if isinstance(given, Animation) else Animation(cast(Iterable[int], given))
        beyond = next((frame for frame in animation.frames if frame >= len(self)), None)
        if beyond is not None:
            raise ArgumentError(f"Sheet: animation {name!r}: there is no frame {beyond}, only 0 to {len(self) - 1}")
        return animation

    def plain(self) -> list[Any]:
        """As lists and numbers, to be saved."""
        animations = {name: [list(each.frames), each.fps, each.course] for name, each in self.animations.items()}
        return [list(self.grid), self.fps, animations]

    @staticmethod
    def of_plain(plain: Any) -> Sheet:
        """What `plain` gave. Raises ValueError, TypeError or an Error of ours for what is no sheet."""
        (image, columns, rows, margin, spacing), fps, animations = plain
        rows_of = {
            name: Animation(frames, fps=each, course=course) for name, (frames, each, course) in animations.items()
        }
        return Sheet(image, columns, rows, margin=margin, spacing=spacing, fps=fps, animations=rows_of)

    def _key(self) -> tuple[Any, ...]:
        return self.grid, self.fps, tuple(self.animations.items())

    def __eq__(self, other: object) -> bool:
        return self._key() == other._key() if isinstance(other, Sheet) else NotImplemented

    def __hash__(self) -> int:
        return hash(self._key())

    def __repr__(self) -> str:
        names = f", animations: {', '.join(self.animations)}" if self.animations else ""
        return f"<Sheet {self.image!r}, {self.grid.columns} x {self.grid.rows} frames{names}>"


def rate(value: object, owner: str) -> float:
    """Frames a second, checked."""
    return number(value, owner, "fps", least=SLOWEST, most=FASTEST)


def _whole(value: object, argument: str) -> int:
    if isinstance(value, bool) or not isinstance(value, int):
        raise ArgumentTypeError(f"Sheet: {argument}={value!r} must be a whole number")
    return int(number(value, "Sheet", argument, least=1, most=MOST_CELLS))


def _frames(frames: object, owner: str) -> tuple[int, ...]:
    try:
        found = tuple(cast(Iterable[int], frames))
    except TypeError:
        found = ()
    if not found or any(isinstance(each, bool) or not isinstance(each, int) or each < 0 for each in found):
        raise ArgumentTypeError(f"{owner}: frames={frames!r} must be numbers of frames, from 0, such as range(6)")
    if len(found) > MOST_FRAMES:
        raise ArgumentError(f"{owner}: {len(found)} frames are more than {MOST_FRAMES}")
    return found
