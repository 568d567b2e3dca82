"""Files that games call by name: looked for in folders, in order."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

from evilengine.values.checks import did_you_mean
from evilengine.values.errors import ArgumentTypeError, AssetError


def find_file(name: str | Path, folders: Sequence[Path], what: str) -> Path:
    """The file called `name` in the first of `folders` that has it; a full path works too.

    `what` it should be ("sound", "image") is for the AssetError, which tells the nearest name where there is none.

    >>> find_file("thud.ogg", [Path("levels")], "sound")
    Traceback (most recent call last):
    evilengine.values.errors.AssetError: sound 'thud.ogg': there is no such file in levels
    """
    if not isinstance(name, (str, Path)):
        raise ArgumentTypeError(f"{what} name={name!r} must be a file name")
    if not str(name) or "\0" in str(name):
        raise AssetError(f"{what} {str(name)!r}: this is no file name")
    for folder in folders:
        if _is(Path.is_file, folder / name):
            return folder / name
    searched = " or ".join(str(folder) for folder in folders)
    if any(_is(Path.is_dir, folder / name) for folder in folders):
        raise AssetError(f"{what} {str(name)!r}: this is a folder")
    near = did_you_mean(name, _names_beside(name, folders))
    raise AssetError(f"{what} {str(name)!r}: there is no such file in {searched}{near}")


def _names_beside(name: str | Path, folders: Sequence[Path]) -> list[str]:
    """What could have been meant: the files beside where `name` would be."""
    names = []
    for folder in folders:
        beside = (folder / name).parent
        if _is(Path.is_dir, beside):
            names += [str(Path(name).parent / path.name) for path in sorted(beside.iterdir())]
    return names


def _is(kind: Callable[[Path], bool], path: Path) -> bool:
    try:
        return kind(path)
    except OSError:  # such as a name that is too long
        return False
