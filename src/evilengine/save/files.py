"""Files that are written whole or not at all, and the folder of slots that they are."""

from __future__ import annotations

import contextlib
import logging
import os
import re
import shutil
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import TypeVar

from evilengine.save.container import LARGEST
from evilengine.values.errors import ArgumentError, ArgumentTypeError, DamagedSaveError, SaveError

T = TypeVar("T")

FOLDER = "EVILENGINE_SAVES"
"""The environment variable that says where saved games lie, instead of the user's data folder."""

ENDING = ".evs"
BACKUP = ".evs.before"
"""Ending of the save before the newest, kept in case that one is damaged."""

LEFT_OVER = 3600.0
"""Seconds after which a temporary file is nobody's any more: its process was killed while it wrote."""

_SLOT = re.compile(r"[A-Za-z0-9_-]{1,64}", re.ASCII)
_NOT_IN_A_NAME = re.compile(r"[^A-Za-z0-9_-]+", re.ASCII)


def write_whole(path: Path, data: bytes, *, backup: Path | None = None) -> None:
    """Put `data` into the file `path`: all of it, or the file stays as it was. Raises SaveError.

    The bytes go to a temporary file in the same folder and are on the disk before that takes the place of `path`,
    which is one step for the file system. What was there before becomes `backup`.
    """
    temporary = path.with_name(f".{path.name}.{os.getpid()}.new")
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        try:
            with temporary.open("wb") as stream:
                stream.write(data)
                stream.flush()
                os.fsync(stream.fileno())
            if backup is not None:
                _keep(path, backup)
            os.replace(temporary, path)
        except BaseException:
            with contextlib.suppress(OSError):
                temporary.unlink()
            raise
    except OSError as problem:
        raise SaveError(
            f"{path} cannot be written: {problem.strerror or problem}; what was there before stays"
        ) from problem
    _sync_folder(path.parent)
    _sweep(path)


def _keep(path: Path, backup: Path) -> None:
    """Make what is at `path` now the backup; it stays where it is, too, so that it is never missing."""
    if not path.exists():
        return
    spare = backup.with_name(f".{backup.name}.{os.getpid()}.new")
    with contextlib.suppress(FileNotFoundError):
        spare.unlink()
    try:
        os.link(path, spare)
        os.replace(spare, backup)
    except OSError:  # a file system without links: two names of one file
        shutil.copyfile(path, spare)
        os.replace(spare, backup)
    finally:
        with contextlib.suppress(FileNotFoundError):
            spare.unlink()


def read_whole(path: Path, largest: int) -> bytes:
    """The bytes of the file `path`. Raises SaveError when there is none, or when it is too large to be one of ours."""
    try:
        with path.open("rb") as stream:
            size = os.fstat(stream.fileno()).st_size  # read(n) takes n bytes of memory first, however small the file
            data = stream.read(min(size, largest) + 1)
    except FileNotFoundError:
        raise SaveError(f"there is no file {path}") from None
    except OSError as problem:
        raise SaveError(f"{path} cannot be read: {problem.strerror or problem}") from problem
    if len(data) > largest:
        raise DamagedSaveError(f"{path} is larger than {largest} bytes, so it is none of ours")
    return data


class Slots:
    """The saved games of one game: a file for each slot, and one backup of it.

    They lie in `folder`; without one, in a folder with the title of the game, where the environment variable
    EVILENGINE_SAVES says, or in the user's data folder.
    """

    def __init__(self, title: str, folder: str | Path | None = None) -> None:
        if folder is not None:
            self.folder = Path(folder)
        else:
            self.folder = saves_folder() / (_NOT_IN_A_NAME.sub("-", title).strip("-")[:64] or "game")

    def path(self, slot: str, owner: str) -> Path:
        """The file of a slot. Raises ArgumentError for what is no slot's name."""
        if not isinstance(slot, str):
            raise ArgumentTypeError(f"{owner}: slot={slot!r} must be a name, such as 'first'")
        if not _SLOT.fullmatch(slot):
            raise ArgumentError(
                f"{owner}: slot={slot!r} must be 1 to 64 letters (a to z), digits, dashes and underscores: 'level-2'"
            )
        return self.folder / (slot + ENDING)

    def write(self, path: Path, data: bytes, is_sound: Callable[[bytes], object]) -> None:
        """Write a slot's file. What was in it becomes the backup, unless it is damaged: a sound backup stays then."""
        backup: Path | None = path.with_name(path.stem + BACKUP)
        try:
            if path.exists():
                is_sound(read_whole(path, LARGEST))
        except DamagedSaveError:
            backup = None
        except SaveError:
            pass  # whole, but of a newer version: keep it
        write_whole(path, data, backup=backup)

    def read(self, path: Path, read: Callable[[bytes, str], T]) -> T:
        """What `read(bytes, name)` makes of a slot's file; of its backup, with a line of notice, where that fails."""
        backup = path.with_name(path.stem + BACKUP)
        try:
            if not path.exists():
                raise DamagedSaveError(
                    f"nothing is saved in slot {path.stem!r}: there is no file {path}{self._others()}"
                )
            return read(read_whole(path, LARGEST), path.name)
        except DamagedSaveError as problem:
            if not backup.exists():
                raise
            before = read(read_whole(backup, LARGEST), backup.name)
            logging.getLogger("evilengine").warning("%s; the save before it is used instead", problem)
            return before

    def names(self) -> tuple[str, ...]:
        """The slots that hold something, in the order of their names."""
        found = {path.name.removesuffix(BACKUP).removesuffix(ENDING) for path in self._files()}
        return tuple(sorted(name for name in found if _SLOT.fullmatch(name)))

    def _files(self) -> list[Path]:
        try:
            return [path for path in self.folder.iterdir() if path.name.endswith((ENDING, BACKUP))]
        except OSError:
            return []

    def _others(self) -> str:
        names = self.names()
        return f"; there are {', '.join(map(repr, names[:8]))}" if names else ""


def saves_folder() -> Path:
    """Where the saved games of all games lie."""
    named = os.environ.get(FOLDER)
    if named:
        return Path(named)
    from platformdirs import user_data_path

    return user_data_path("evilengine", appauthor=False) / "saves"


def _sync_folder(folder: Path) -> None:
    """Let the new name be on the disk too. Systems that cannot open a folder do so by themselves."""
    if sys.platform == "win32":
        return
    with contextlib.suppress(OSError):
        handle = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(handle)
        finally:
            os.close(handle)


def _sweep(path: Path) -> None:
    """Remove what processes that were killed while they wrote have left behind."""
    with contextlib.suppress(OSError):
        for each in path.parent.glob(f".{path.name}.*.new"):
            with contextlib.suppress(OSError):
                if time.time() - each.stat().st_mtime > LEFT_OVER:
                    each.unlink()
