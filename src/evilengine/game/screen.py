"""The screen that a game is on: filling it, pictures of it, and what its frames cost."""

from __future__ import annotations

import contextlib
import re
import sys
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING, cast

from evilengine.game.timings import Timings
from evilengine.scene import Scene, Text, View
from evilengine.values.checks import known_keywords
from evilengine.values.errors import ArgumentTypeError, AssetError, Error
from evilengine.values.events import Event, KeyEvent, key_name
from evilengine.values.image import Image

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    from evilengine.game.game import Game
    from evilengine.platform import Device
    from evilengine.scene.camera_work import Followed
    from evilengine.values.vec2 import Point

NOTICE_SECONDS = 3.0
"""How long the screen says where a picture was saved."""

MOST_PICTURES = 100_000


class GameScreen:
    """The part of a game that knows its screen."""

    device: Device
    scene: Scene
    title: str

    def __init__(self) -> None:
        super().__init__()
        self.timings = Timings()
        """What the last frames cost, in milliseconds; `game.frame_graph = True` shows them."""
        self._keys_of_window = {"screenshot_key": "f12", "fullscreen_key": "f11"}
        self._notice: tuple[Text, float] | None = None  # and until when it is shown
        self._now = 0.0

    @property
    def screenshot_key(self) -> str | None:
        """The key that saves a picture: "f12"; None for none. It counts in `run`, also while the game is paused."""
        return self._keys_of_window["screenshot_key"] or None

    @screenshot_key.setter
    def screenshot_key(self, key: str | None) -> None:
        self._set_key("screenshot_key", key)

    @property
    def fullscreen_key(self) -> str | None:
        """The key that fills the screen with the game, and gives it back: "f11"; None for none."""
        return self._keys_of_window["fullscreen_key"] or None

    @fullscreen_key.setter
    def fullscreen_key(self, key: str | None) -> None:
        self._set_key("fullscreen_key", key)

    @property
    def fullscreen(self) -> bool:
        """Does the game fill the screen? The camera then shows more or less at the sides; nothing is stretched."""
        return self.device.fullscreen

    @fullscreen.setter
    def fullscreen(self, full: bool) -> None:
        if not isinstance(full, bool):
            raise ArgumentTypeError(f"Game: fullscreen={full!r} must be True or False")
        if full != self.device.fullscreen:
            self.device.fullscreen = full

    @property
    def frame_graph(self) -> bool:
        """Is what the last frames cost drawn as a graph? Steps, collecting, drawing and showing, in milliseconds."""
        return self.scene.graph is not None

    @frame_graph.setter
    def frame_graph(self, on: bool) -> None:
        self.scene.graph = self.timings.rows if on else None

    @known_keywords
    def screenshot(self, path: str | Path | None = None) -> Path:
        """Save the picture as it is now, in real pixels and without hints over it, and return its file.

        Without a `path` it is called after the game, "Tower-1.png", "Tower-2.png", ..., in the current folder (in that
        for temporary files if nothing may be written there). No file is ever written over. Inside a callback it is
        taken when that part of the frame is over. Raises AssetError if it cannot be written.
        """
        file = _free_name(self.title) if path is None else _claimed(path)
        cast("Game", self)._when_free(lambda: self._save_picture(file))
        return file

    def _save_picture(self, file: Path) -> None:
        try:
            self._plain_picture().save(file)
        except BaseException:
            with contextlib.suppress(OSError):
                file.unlink()
            raise

    def _plain_picture(self) -> Image:
        """The picture of the game alone; nobody's on_draw is called for it."""
        game = cast("Game", self)
        game.renderer.draw(game._collect(overlay=False))
        return game.renderer.capture()

    @known_keywords
    def add_view(
        self,
        area: str | Iterable[float],
        *,
        follow: Followed | None = None,
        position: Point | None = None,
        zoom: float | None = None,
        angle: float | None = None,
        view_height: float | None = None,
    ) -> View:
        """Show the world in one more part of the window, by a camera of its own, over the views that there are.

        `area` is left, bottom, right, top as shares of the window (0..1), or a word: "left", "top right", ... The
        camera keeps what it shall `follow` in sight; `position`, `zoom`, `angle` and `view_height` are as a Camera has
        them, and what is not said is as with the game's own. Lights, layers and what is done to the picture are seen
        in each view by itself; text and panels lie over all of them.

        >>> game = evil.Game(headless=True)
        >>> ball = game.add(evil.Circle(0.5), at=(0, 3))
        >>> view = game.add_view((0.7, 0.7, 1, 1), follow=ball, zoom=0.5)
        >>> len(game.views), view.camera.position
        (2, Vec2(0.0, 3.0))
        """
        look = {"position": position, "zoom": zoom, "angle": angle}
        told = {name: value for name, value in look.items() if value is not None}
        return cast("Game", self).views.add(area, follow, view_height, told)

    @known_keywords
    def split(self, *targets: Followed, stacked: bool = False) -> tuple[View, ...]:
        """Share the window out among one to four things, and follow each in a view of its own; they are returned.

        Two are side by side, or one over the other with `stacked`; three and four are in quarters, and of three the
        last has both lower ones. `game.split(hero)` gives all of it to one again. Sounds are heard from the nearest.

        >>> game = evil.Game(headless=True)
        >>> one, two = game.add_character(at=(0, 1)), game.add_character(at=(9, 1))
        >>> game.split(one, two)
        (<View left>, <View right>)
        """
        if not isinstance(stacked, bool):
            raise ArgumentTypeError(f"Game.split: stacked={stacked!r} must be True or False")
        return cast("Game", self).views.share(targets, stacked)

    def _set_key(self, which: str, key: str | None) -> None:
        self._keys_of_window[which] = "" if key is None else key_name(key, "Game", which)

    def _press_window_keys(self, events: Iterable[Event]) -> list[Callable[[], object]]:
        """What the keys of the window ask for, to be done when the frame is over."""
        asked: list[Callable[[], object]] = []
        for event in events:
            if isinstance(event, KeyEvent) and event.down:
                if event.key == self.fullscreen_key:
                    asked.append(self._turn_fullscreen)
                elif event.key == self.screenshot_key:
                    asked.append(self._take_screenshot)
        return asked

    def _turn_fullscreen(self) -> None:
        self.fullscreen = not self.fullscreen

    def _take_screenshot(self) -> None:
        """What the key does: a full disk is no reason to end the game."""
        try:
            words = f"saved {self.screenshot()}"
        except Error as problem:
            words = f"no picture: {problem}"
        print(f"{self.title}: {words}", file=sys.stderr)
        self._say(words)

    def _say(self, words: str) -> None:
        if self._notice is not None and self._notice[0].alive:
            self._notice[0].destroy()
        line = self.scene.overlay(words, at=(0, 26), anchor="bottom", size=15, colour="#ffffffd0")
        self._notice = line, self._now + NOTICE_SECONDS

    def _tidy_notice(self, now: float) -> None:
        self._now = now
        if self._notice is not None and now >= self._notice[1]:
            if self._notice[0].alive:
                self._notice[0].destroy()
            self._notice = None


def _claimed(path: object) -> Path:
    """An empty file of that name, made now so that nobody else takes it; an error if there is one."""
    if not isinstance(path, (str, Path)) or not str(path):
        raise ArgumentTypeError(f"Game.screenshot: path={path!r} must be the name of a file")
    file = Path(path)
    try:
        file.open("xb").close()
    except FileExistsError:
        raise AssetError(f"Game.screenshot: {file} is there already; no picture is written over another") from None
    except (OSError, ValueError) as problem:
        raise AssetError(f"Game.screenshot: {file} cannot be written: {problem}") from problem
    return file


def _free_name(title: str) -> Path:
    """The first of TITLE-1.png, TITLE-2.png, ... that is free where files may be written, and is taken now."""
    stem = re.sub(r"[^A-Za-z0-9_-]+", "-", title).strip("-")[:60] or "game"
    problem: OSError | None = None
    for folder in (Path(), Path(tempfile.gettempdir())):
        taken = {path.name for path in folder.glob(f"{stem}-*.png")}
        for number in range(1, MOST_PICTURES):
            file = folder / f"{stem}-{number}.png"
            if file.name in taken:
                continue
            try:
                file.open("xb").close()
            except FileExistsError:
                continue
            except OSError as failure:
                problem = failure
                break
            return file
    raise AssetError(f"Game.screenshot: no picture can be written here: {problem or 'there are too many'}")
