"""Stages: a level or a game is set up on one, which shows it its own way (a window, a film, a single picture)."""

from __future__ import annotations

import runpy
import sys
import traceback
from pathlib import Path
from typing import TYPE_CHECKING

from evilengine.values.errors import Error

if TYPE_CHECKING:
    from evilengine.game import Game, Stage


def perform(path: Path, stage: Stage, *, renderer: str = "auto") -> None:
    """Run the level or the script at `path` with `stage` in place of the window and the loop of its game."""
    from evilengine.game import STAGE

    token = STAGE.set(stage)
    try:
        if path.suffix == ".py":
            _run_script(path)
        else:
            level_game(path, renderer=renderer).run()
    finally:
        STAGE.reset(token)


def level_game(path: Path, *, renderer: str = "auto") -> Game:
    """A game with nothing but the level at `path`."""
    from evilengine.game import Game

    game = Game(path.stem, renderer=renderer, folder=path.parent)
    game.go(path.name)
    return game


def _run_script(path: Path) -> None:
    folder = str(path.resolve().parent)
    arguments, sys.argv = sys.argv, [str(path)]
    sys.path.insert(0, folder)
    try:
        runpy.run_path(str(path), run_name="__main__")
    except Error as error:
        place = next((f for f in reversed(traceback.extract_tb(error.__traceback__)) if f.filename == str(path)), None)
        if place is not None:
            error.add_note(f"{path}:{place.lineno}: in {place.name}: {place.line}")
        raise
    finally:
        sys.argv = arguments
        sys.path.remove(folder)
