"""Filming a game that nobody plays: a headless device, a hand that sways it, and a file of pictures."""

from __future__ import annotations

import math
import sys
from abc import ABC, abstractmethod
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, TextIO, cast

from evilengine.assets.film import save_film
from evilengine.cli import autosave
from evilengine.cli.looks import NO_LOOKS, Looks
from evilengine.cli.stage import perform
from evilengine.platform import HeadlessDevice
from evilengine.platform.device import MOST_POINTS
from evilengine.values.errors import ArgumentError, Error
from evilengine.values.tick import STEP

if TYPE_CHECKING:
    from evilengine.game import Game
    from evilengine.game.replaying import Playback
    from evilengine.values.image import Image

SWAY_SECONDS = 5.0
"""From upright to one side, over to the other and back; things need about a second to cross Prototype 1."""

SWAY_ANGLE = math.radians(65.0)
"""How far: enough for boxes to slide and stacks to fall, not so far that all lies against one wall."""

FILMS = (".webp", ".gif", ".png")
PICTURES = (".png", ".webp", ".jpg", ".jpeg")
MOST_FRAMES = 20_000
"""Frames in a film: what a viewer still opens."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Shot:
    """How to look at a game that nobody plays."""

    size: tuple[int, int] | None = None
    """Of the picture, in pixels, whatever it shows; None: as large as the game wants to be."""
    renderer: str = "auto"
    sway: bool = True
    """Does a hand sway the device, for games with tilt?"""
    looks: Looks = NO_LOOKS
    resume: bool = False
    """Does it begin where the game's window was closed?"""
    record: Path | None = None
    """Where what is filmed is recorded, for `evil replay`."""


def film(path: Path, target: Path, shot: Shot, *, seconds: float = 10.0, fps: float = 30.0) -> Path:
    """Write `seconds` of the level or game at `path` to `target`, with a bar on a terminal, and return `target`."""
    check_ending(target, FILMS, "a film")
    if seconds * fps > MOST_FRAMES:
        raise ArgumentError(
            f"{seconds:g} s at {fps:g} frames a second are more than {MOST_FRAMES} frames; make it shorter"
        )
    return _perform(path, target, _Film(path, target, shot, max(1, round(seconds * fps)), fps), shot)


def picture(path: Path, target: Path, shot: Shot, *, at: float) -> Path:
    """Write how the level or game at `path` looks after `at` seconds to `target`, and return `target`."""
    check_ending(target, PICTURES, "a picture")
    return _perform(path, target, _Picture(path, target, shot, at), shot)


def sway(seconds: float) -> tuple[float, float]:
    """The accelerometer's x and y, in g, of a hand that sways the device in an upright plane.

    >>> sway(0.0)
    (0.0, -1.0)
    """
    angle = SWAY_ANGLE * math.sin(2.0 * math.pi * seconds / SWAY_SECONDS)
    return math.sin(angle), -math.cos(angle)


class Screen(HeadlessDevice):
    """A device for a game of `size` points on a picture of so many pixels; where their shapes differ, it shows more.

    A strip so long and thin that more would be beyond what a device may show, shows less.
    """

    def __init__(self, title: str, size: tuple[int, int], picture: tuple[int, int]) -> None:
        self._pixels_a_point = max(min(picture[0] / size[0], picture[1] / size[1]), max(picture) / MOST_POINTS)
        self._picture = picture
        self._full = False
        width, height = (round(side / self._pixels_a_point) for side in picture)
        super().__init__((width, height), title=title)

    @property
    def pixel_size(self) -> tuple[int, int]:
        return self._picture

    @property
    def scale(self) -> float:
        return self._pixels_a_point

    @property
    def fullscreen(self) -> bool:
        """A film is as large as was asked for, whatever the game wants."""
        return self._full

    @fullscreen.setter
    def fullscreen(self, full: bool) -> None:
        self._full = bool(full)


class _Camera(ABC):
    """A stage without a window; what is filmed is up to `shoot`, once."""

    def __init__(self, path: Path, target: Path, shot: Shot) -> None:
        self.path = path
        self.target = target
        self.shot = shot
        self.done = False

    def open(self, title: str, size: tuple[int, int]) -> HeadlessDevice:
        self.device = Screen(title, size, self.shot.size or size)
        return self.device

    def run(self, game: Game) -> None:
        if not self.done:
            self.shot.looks.put_on(game)
            if self.shot.resume:
                autosave.resume(game, self.path)
            if self.shot.record is not None:
                from evilengine.game import replaying

                game._recorder = replaying.record(game, self.shot.record, level=self.path.suffix != ".py")
            self.done = True
            self.shoot(game)
        game.close()

    @abstractmethod
    def shoot(self, game: Game) -> None:
        """Film it."""

    def frame(self, game: Game, now: float) -> Image:
        """The picture at `now`, seconds from the start."""
        if game.tilt and self.shot.sway:
            self.device.tilt(*sway(now))
        game.frame(now)
        assert self.device.shown is not None
        return self.device.shown


class _Film(_Camera):
    def __init__(self, path: Path, target: Path, shot: Shot, frames: int, fps: float) -> None:
        super().__init__(path, target, shot)
        self.frames = frames
        self.fps = fps

    def shoot(self, game: Game) -> None:
        bar = Bar(self.target.name)
        pictures = (self.frame(game, count / self.fps) for count in range(self.frames))
        save_film(pictures, self.target, fps=self.fps, progress=lambda count: bar(count / self.frames))


class Reel:
    """A film of a recording, from its first step to its last."""

    def __init__(self, target: Path, shot: Shot, fps: float) -> None:
        self.target = target
        self.shot = shot
        self.fps = fps

    def __call__(self, game: Game, playback: Playback) -> None:
        frames = max(1, round(len(playback.replay.steps) * STEP * self.fps))
        if frames > MOST_FRAMES:
            raise ArgumentError(f"{self.target}: {frames} frames are more than {MOST_FRAMES}; ask for fewer with --fps")
        bar = Bar(self.target.name)
        save_film(self._frames(game, playback), self.target, fps=self.fps, progress=lambda count: bar(count / frames))

    def _frames(self, game: Game, playback: Playback) -> Iterator[Image]:
        count = 0
        while game.running and not playback.over and count < MOST_FRAMES:
            game.frame(count / self.fps)
            yield cast(HeadlessDevice, game.device).shown or game.capture()
            count += 1


class _Picture(_Camera):
    def __init__(self, path: Path, target: Path, shot: Shot, at: float) -> None:
        super().__init__(path, target, shot)
        self.at = at

    def shoot(self, game: Game) -> None:
        for count in range(round(self.at / STEP) + 1):
            image = self.frame(game, count * STEP)
        image.save(self.target)


def _perform(path: Path, target: Path, stage: _Camera, shot: Shot) -> Path:
    perform(path, stage, renderer=shot.renderer)
    if not stage.done:
        raise Error(f"{path} ended without game.run(), so there is nothing to show")
    return target


def check_ending(target: Path, endings: tuple[str, ...], what: str) -> None:
    if target.suffix.lower() not in endings:
        raise ArgumentError(f"{target} must end in {', '.join(endings[:-1])} or {endings[-1]} to be {what}")


class Bar:
    """A line that fills while something long goes on; nothing at all when the stream is not a terminal.

    >>> import io
    >>> out = io.StringIO(); Bar("film", out)(0.5); out.getvalue()
    ''
    """

    WIDTH = 40

    def __init__(self, what: str, stream: TextIO | None = None) -> None:
        self._what = what
        self._stream = sys.stderr if stream is None else stream
        self._quiet = not self._stream.isatty()
        self._shown = -1

    def __call__(self, part: float) -> None:
        """`part` of it, 0..1, is done."""
        part = min(part, 1.0)  # in slow motion there are more pictures than anybody counted
        percent = int(100 * part)
        if self._quiet or percent == self._shown:
            return
        self._shown = percent
        filled = int(self.WIDTH * part)
        self._stream.write(f"\r{self._what} [{'#' * filled}{'.' * (self.WIDTH - filled)}] {percent:3d}%")
        if part >= 1.0:
            self._stream.write("\n")
        self._stream.flush()
