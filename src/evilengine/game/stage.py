"""Where a game is shown: in a window of its own, or on the stage of a command that plays or films it."""

from __future__ import annotations

import sys
import time
from contextvars import ContextVar
from pathlib import Path
from typing import TYPE_CHECKING, Protocol

from evilengine import platform
from evilengine.platform import Device
from evilengine.values.errors import ArgumentTypeError, DeviceError
from evilengine.values.tick import STEP

if TYPE_CHECKING:
    from evilengine.game.game import Game

SHORTEST_FRAME = 1.0 / 500.0
"""Seconds. Screens that set the pace are slower; but a window that is hidden may not wait for its screen at all."""


class Stage(Protocol):
    """Who shows the games that are made while it is `STAGE`: `evil play` and `evil render` put scripts on one."""

    def open(self, title: str, size: tuple[int, int]) -> Device:
        """The device that a new game gets instead of opening its own."""

    def run(self, game: Game) -> None:
        """What `game.run()` does instead of its own loop."""


def keep_pace(device: Device, began: float) -> None:
    """Wait until the frame that began then (by time.perf_counter) has lasted as long as one should."""
    shortest = SHORTEST_FRAME if device.vsync else STEP
    time.sleep(max(0.0, began + shortest - time.perf_counter()))


STAGE: ContextVar[Stage | None] = ContextVar("evilengine_stage", default=None)


def open_device(title: str, size: tuple[int, int], headless: bool, *, gl: bool) -> Device:
    """What the stage gives, else a window, with GL if wanted, else a device without a screen."""
    stage = STAGE.get()
    if stage is not None:
        return stage.open(title, size)
    if not headless:
        try:
            return platform.open_device(title, size, gl=gl)
        except DeviceError:
            screen = platform.screen_available()
            if screen:
                raise
            print(f"{title}: {screen.reason}; it plays without one", file=sys.stderr)
    return platform.HeadlessDevice(size, title=title)


def script_folder() -> Path:
    """The folder of the script that runs, else the current one."""
    file = getattr(sys.modules.get("__main__"), "__file__", None)
    return Path(file).resolve().parent if file else Path.cwd()


def to_path(value: object, owner: str) -> Path:
    """`value` as a path, or an error that names `owner`."""
    if not isinstance(value, (str, Path)) or not str(value):
        raise ArgumentTypeError(f"{owner}: path={value!r} must be the name of a file")
    return Path(value)
