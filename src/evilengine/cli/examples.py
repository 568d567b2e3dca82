"""List the levels and games that ship with the engine, or copy one to change.

evil examples                     lists them
evil play NAME                    plays one
evil examples --copy NAME         copies one into this folder, with the files it needs
"""

from __future__ import annotations

import argparse
import shutil
from pathlib import Path

from evilengine.cli import sources
from evilengine.values.errors import SaveError


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--copy", metavar="NAME", help="copy the example NAME, instead of listing")
    parser.add_argument("--to", metavar="FOLDER", default=".", help="where to copy it (default: this folder)")


def run(args: argparse.Namespace) -> int:
    if args.copy is not None:
        print(copy(args.copy, Path(args.to)))
        return 0
    shipped = sources.examples()
    width = max(len(example.name) for example in shipped)
    for example in shipped:
        print(f"{example.name:<{width}}  {example.summary}")
    return 0


def copy(name: str, folder: Path) -> Path:
    """Copy an example into `folder`, with the folder of its pictures and sounds, and return its new path.

    Raises SaveError rather than write over a file.
    """
    origin = sources.example(name).path
    pairs = [(each, folder / each.name) for each in (origin, sources.things_of(origin)) if each.exists()]
    for _, target in pairs:
        if target.exists():
            raise SaveError(f"{target} exists already; copy to another folder with --to, or move it away")
    try:
        folder.mkdir(parents=True, exist_ok=True)
        for source, target in pairs:
            (shutil.copytree if source.is_dir() else shutil.copyfile)(source, target)
    except OSError as error:
        raise SaveError(f"{folder} cannot be written: {error.strerror or error}") from None
    return folder / origin.name
