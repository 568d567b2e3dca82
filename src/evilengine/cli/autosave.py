"""The saves that `evil play` makes by itself when its window closes, one for each level or game."""

from __future__ import annotations

import hashlib
import json
import re
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from evilengine.save import Slots
from evilengine.values.errors import SaveError

if TYPE_CHECKING:
    from evilengine.game import Game

FOLDER = "autosave"
"""Beside the folders of games, which are named by their titles."""


def slot_of(path: Path) -> tuple[Slots, Path]:
    """The slot of the level or game at `path`: its name, and what tells it from others of the same name elsewhere."""
    slots = Slots(FOLDER)
    place = hashlib.blake2b(str(path.resolve()).encode("utf-8", "surrogatepass"), digest_size=4).hexdigest()
    name = re.sub(r"[^A-Za-z0-9_-]+", "-", path.stem, flags=re.ASCII)[:48] or "game"
    return slots, slots.path(f"{name}-{place}", "evil play")


def write(game: Game, path: Path) -> None:
    """Save the game that was played from `path`. One that cannot be saved is said to be so, in one line."""
    from evilengine.game import saving

    try:
        saving.save(game, *slot_of(path), origin=str(path.resolve()))
    except SaveError as problem:
        print(f"evil: {path.name} cannot be resumed later: {problem}", file=sys.stderr)


def resume(game: Game, path: Path) -> None:
    """Let `game`, which was started from `path`, go on where it was when its window closed. Raises SaveError."""
    from evilengine.game import saving

    before = [level.script.text for level in game.levels]
    saving.resume(game, *slot_of(path))
    if before != [level.script.text for level in game.levels]:
        print(
            f"{path.name} has changed since; this is the game as it was saved (F5 starts the new one)", file=sys.stderr
        )


def newest() -> Path:
    """What was played last: the level or game whose save is the newest. Raises SaveError if there is none."""
    from evilengine.game import saving

    slots = Slots(FOLDER)
    found = [path for path in (slots.path(name, "evil play") for name in slots.names()) if path.exists()]
    if not found:
        raise SaveError("nothing was played yet that could be resumed; `evil play LEVEL` starts something")
    path = max(found, key=lambda each: (each.stat().st_mtime_ns, each.name))
    try:
        origin = Path(saving.origin_of(slots, path))
    except (KeyError, TypeError, json.JSONDecodeError):
        raise SaveError(f"{path} does not say what was played") from None
    if not origin.is_file():
        raise SaveError(f"{origin}, which was played last, is not there any more")
    return origin
