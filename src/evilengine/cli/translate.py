"""Print a level as the Python that builds the same world.

evil translate level.evil
evil translate level.evil -o level.py
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from evilengine import script
from evilengine.cli.sources import source
from evilengine.script.translate import translate
from evilengine.values.errors import AssetError, LevelError


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("level", metavar="LEVEL", help="a level (.evil), or the name of one that ships with the engine")
    parser.add_argument("-o", "--output", type=Path, metavar="FILE", help="write it to a file instead of the terminal")


def run(args: argparse.Namespace) -> int:
    """0 when it is printed; 1 when the level has errors, which are printed instead."""
    try:
        program = translate(script.read_file(level_file(args.level)))
    except LevelError as error:
        print(error, file=sys.stderr)
        return 1
    if args.output is None:
        print(program, end="")
        return 0
    try:
        args.output.write_text(program, encoding="utf-8")
    except OSError as error:
        raise AssetError(f"{args.output}: cannot be written: {error.strerror or error}") from None
    return 0


def level_file(name: str) -> Path:
    """The level that `name` means: a file, else an example. Raises AssetError if it is neither, or a Python game."""
    path = source(name)
    if path.suffix == ".py":
        raise AssetError(f"{name}: is Python already")
    return path
