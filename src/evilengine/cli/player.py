"""The window of `evil play`: keys of its own, starting again, and files that are loaded again when they change."""

from __future__ import annotations

import contextlib
import signal
import sys
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING

from evilengine.assets.pictures import stamp_of
from evilengine.cli import autosave
from evilengine.cli.looks import NO_LOOKS, Looks
from evilengine.cli.stage import level_game, perform
from evilengine.values.errors import Error, LevelError
from evilengine.values.events import Event, KeyEvent

if TYPE_CHECKING:
    from evilengine.game import Game
    from evilengine.platform import Device
    from evilengine.scene import Text

KEYS = {"f1": "debug", "f2": "pause", "f3": "step", "f4": "graph", "f5": "again", "escape": "quit"}
LEVEL_KEYS = {"p": "pause", "period": "step", "r": "restart"}
"""Letters are free for games written in Python; in a level nobody else uses them."""

HINT = "F1 debug view     F2 pause     F3 one step     F5 start again     Esc quit"
LEVEL_HINT = "F1 debug view     P pause     F3 one step     R start again     Esc quit"
TILT_HINT = "Arrow keys tilt, the mouse drags     "
HINT_SECONDS = 8.0

WATCH_SECONDS = 0.25
"""Between two looks at the level and its images: soon enough to feel immediate, seldom enough to cost nothing."""

MOST_ERRORS = 8
"""Errors of a level that the window shows; the terminal has them all."""


class StartAgain(BaseException):
    """The player wants the game from its beginning: unwinds a script past its own `except Exception`."""


class Player:
    """A stage with a window, which stays open while games come and go on it."""

    def __init__(
        self,
        path: Path,
        *,
        size: tuple[int, int] | None = None,
        renderer: str = "auto",
        looks: Looks = NO_LOOKS,
        seconds: float | None = None,
        resume: bool = False,
        record: Path | None = None,
        device: Device | None = None,
        clock: Callable[[], float] = time.perf_counter,
    ) -> None:
        self.path = path
        self.size = size
        self.renderer = renderer
        self.looks = looks
        self.debug_view: bool | None = None  # once the player has switched it on or off
        self.frame_graph = False
        self.seconds = seconds
        self.resume = resume
        self.record = record
        self._recordings = 0
        self.device = device
        self.is_level = path.suffix != ".py"
        self.game: Game | None = None
        self._hint: Text | None = None
        self._hint_until = 0.0  # of the game's seconds
        self._failure: Text | None = None  # why the level on disk is not the one that plays
        self._wants_again = self._wants_step = False
        self._told_to_end = 0  # by which signal
        self._stamp = stamp_of(path)
        self._clock = clock
        self._looked = self._began = clock()

    def play(self) -> int:
        """Play until the player has enough, or the process is told to end; returns the exit code."""
        try:
            again = True
            while again:
                try:
                    perform(self.path, self, renderer=self.renderer)
                    again = False
                except StartAgain:
                    pass
        finally:
            if self.game is not None:
                self.game.audio.close()
            if self.device is not None:
                self.device.close()
        return 128 + self._told_to_end if self._told_to_end else 0

    # The stage

    def open(self, title: str, size: tuple[int, int]) -> Device:
        """The window, opened for the first game."""
        from evilengine.platform import open_device

        if self.device is None:
            self.device = open_device(title, self.size or size, gl=self.renderer != "soft")
        self.device.title = title
        return self.device

    def run(self, game: Game) -> None:
        """Play `game`, or the one that takes its place, until it ends."""
        if self.resume:
            self.resume = False
            autosave.resume(game, self.path)
        self._take(game)
        try:
            with self._ending_when_told():
                over = self._play()
        finally:
            self._stop_recording()
        if over and self.game is not None:
            autosave.write(self.game, self.path)

    def _play(self) -> bool:
        """True once somebody ended the game, False when its seconds are over."""
        from evilengine.game import keep_pace

        while self.game is not None and self.game.running:
            now = self._clock()
            if self.seconds is not None and now - self._began > self.seconds:
                return False
            if now - self._looked > WATCH_SECONDS:
                self._looked = now
                self._look_at_the_files()
            if self._wants_again:
                self._again()
            if self._wants_step:
                self._wants_step = False
                self.game.step()
            if self._hint is not None and self.game.world.time >= self._hint_until:
                self._hint.destroy()
                self._hint = None
            self.game.frame(now)
            keep_pace(self.game.device, now)
        return True

    @contextlib.contextmanager
    def _ending_when_told(self) -> Iterator[None]:
        """Ctrl-C and the system's request to end finish the frame first, so that the game can be saved whole.

        A second one does not wait.
        """

        def told(number: int, frame: object) -> None:
            if self._told_to_end or self.game is None:
                raise KeyboardInterrupt
            self._told_to_end = number
            self.game.quit()

        if threading.current_thread() is not threading.main_thread():
            yield
            return
        before = {number: signal.signal(number, told) for number in (signal.SIGINT, signal.SIGTERM)}
        try:
            yield
        finally:
            for number, handler in before.items():
                signal.signal(number, handler)

    def _take(self, game: Game) -> None:
        """Put `game` into the window, with the keys of this player; the one before it is heard no more."""
        if self.game is not None:
            self.game.audio.close()
        self._stop_recording()
        self.game = game
        if self.record is not None:
            from evilengine.game import replaying

            game._recorder = replaying.record(game, self._next_recording(self.record), level=self.is_level)
        self.looks.put_on(game)
        if self.debug_view is not None:
            game.debug = self.debug_view
        game.frame_graph = game.frame_graph or self.frame_graph
        game._watchers.append(self._key)
        words = (TILT_HINT if game.tilt else "") + (LEVEL_HINT if self.is_level else HINT)
        self._hint = game.scene.overlay(words, at=(0, 26), anchor="top", size=15, colour="#ffffffc0")
        self._hint_until = game.world.time + HINT_SECONDS

    def _next_recording(self, first: Path) -> Path:
        """r.evr, and each time that the player starts again r-2.evr, r-3.evr, ..."""
        self._recordings += 1
        return first if self._recordings == 1 else first.with_stem(f"{first.stem}-{self._recordings}")

    def _stop_recording(self) -> None:
        if self.game is not None and self.record is not None:
            self.game._stop_recording()

    def _key(self, event: Event) -> None:
        if not isinstance(event, KeyEvent) or not event.down or self.game is None:
            return
        match KEYS.get(event.key) or (LEVEL_KEYS.get(event.key) if self.is_level else None):
            case "quit":
                self.game.quit()
            case "debug":
                self.debug_view = self.game.debug = not self.game.debug
            case "pause":
                self.game.paused = not self.game.paused
            case "step":
                self._wants_step = self.game.paused
            case "graph":
                self.frame_graph = self.game.frame_graph = not self.game.frame_graph
            case "restart" if self.game.scenes.present not in (None, self.path.name):
                self.game.restart()  # a level that the first one went to
            case "again" | "restart":
                self._wants_again = True

    # Starting again

    def _look_at_the_files(self) -> None:
        assert self.game is not None
        for line in (*self.game.reload_images(), *self.game.renderer.reload_shaders()):
            print(line, file=sys.stderr)
        stamp = stamp_of(self.path)
        if self.is_level and stamp is not None and stamp != self._stamp:  # an editor may take it away for a moment
            self._stamp = stamp
            self._wants_again = True

    def _again(self) -> None:
        """From the beginning, as it is on disk now; if that has errors, show them over the one that plays."""
        self._wants_again = False
        if not self.is_level:
            raise StartAgain
        try:
            game = level_game(self.path, renderer=self.renderer)
        except Error as error:
            self._show_failure(error)
        else:
            self._failure = None  # it goes with the game that it was written on
            self._take(game)

    def _show_failure(self, error: Error) -> None:
        print(error, file=sys.stderr)
        assert self.game is not None
        if self._failure is None:
            self._failure = self.game.scene.overlay("", at=(16, 16), size=15, colour="#ff9d8a")
        lines = [f"{self.path.name} has errors, so the level as it was plays on:", *_headlines(error)]
        self._failure.text = "\n".join(lines)


def _headlines(error: Error) -> list[str]:
    """What the window shows of an error: a line for each of a level's errors, the first few of them."""
    found = [each.headline for each in error.errors] if isinstance(error, LevelError) else [str(error)]
    more = [f"and {len(found) - MOST_ERRORS} more"] if len(found) > MOST_ERRORS else []
    return [*found[:MOST_ERRORS], *more]
