"""Say everything that is wrong with a level, with the line, the word and what was probably meant.

evil check level.evil
evil check *.evil --json        for editors and programs
"""

from __future__ import annotations

import argparse
import json
import sys

from evilengine import script
from evilengine.values.diagnostics import Diagnostic
from evilengine.values.errors import AssetError


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("files", nargs="+", metavar="FILE", help="a level (.evil)")
    parser.add_argument("--json", action="store_true", help="print a list of objects instead of text")


def run(args: argparse.Namespace) -> int:
    """0 when no file has an error, else 1."""
    found = [(file, errors_of(file)) for file in args.files]
    errors = [error for _, each in found for error in each]
    if args.json:
        print(json.dumps([error.as_dict() for error in errors], indent=2))
        return 1 if errors else 0
    for file, each in found:
        for error in each:
            print(error, end="\n\n")
        if each:
            print(f"{file}: {len(each)} error{'s' if len(each) > 1 else ''}", file=sys.stderr)
        else:
            print(f"{file}: no errors")
    return 1 if errors else 0


def errors_of(file: str) -> tuple[Diagnostic, ...]:
    """What is wrong with a file; that it cannot be read, too."""
    try:
        return script.check_file(file)[1]
    except AssetError as error:
        message = str(error).removeprefix(f"{file}: ")
        return (Diagnostic("unreadable", message, file, 1, 1),)
