"""The `evil` command: one module a command, each with `add_arguments(parser)` and `run(args) -> exit code`.

The first line of a command's docstring is its line in `evil help`; the rest is the text of its own help.
"""

from __future__ import annotations

import argparse
import importlib
import os
import sys
import textwrap
import traceback
from collections.abc import Sequence
from typing import Protocol, cast

from evilengine.values.checks import did_you_mean
from evilengine.values.errors import Error
from evilengine.values.version import VERSION

COMMANDS = ("play", "replay", "new", "examples", "check", "render", "translate", "doctor", "bench", "testbed")
"""In the order in which one meets them."""

USAGE_ERROR = 2
INTERRUPTED = 130


class Command(Protocol):
    """What a module of this package offers."""

    __doc__: str | None

    def add_arguments(self, parser: argparse.ArgumentParser) -> None: ...

    def run(self, args: argparse.Namespace) -> int: ...


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command line `argv` (without the program's name) and return its exit code.

    An error of ours is one line on stderr and 1; wrong usage is 2; Ctrl-C is 130.
    `evil --debug ...` shows the traceback.
    """
    words = list(sys.argv[1:] if argv is None else argv)
    debug = words[:1] == ["--debug"]
    try:
        return _dispatch(words[debug:])
    except Error as error:
        if debug:
            traceback.print_exc()
        print("\n".join([f"evil: {error}", *getattr(error, "__notes__", ())]), file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        return INTERRUPTED
    except BrokenPipeError:  # `evil examples | head`: nobody reads on
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 1


def _dispatch(words: list[str]) -> int:
    if not words or words[0] in ("-h", "--help"):
        return _help()
    if words[0] in ("-V", "--version"):
        print(f"evil {VERSION}")
        return 0
    if words[0] == "help":
        return _dispatch([words[1], "--help"]) if len(words) > 1 else _help()
    if words[0] not in COMMANDS:
        print(
            f"evil: there is no command {words[0]!r}{did_you_mean(words[0], COMMANDS)}; `evil help` lists them",
            file=sys.stderr,
        )
        return USAGE_ERROR
    return _run(words[0], words[1:])


def _run(name: str, words: list[str]) -> int:
    command = _command(name)
    parser = argparse.ArgumentParser(
        prog=f"evil {name}",
        description=textwrap.dedent(command.__doc__ or "").strip(),
        formatter_class=argparse.RawDescriptionHelpFormatter,
        allow_abbrev=False,
    )
    command.add_arguments(parser)
    try:
        args = parser.parse_args(words)
    except SystemExit as done:  # argparse has printed the help or what was wrong
        return int(done.code or 0)
    return command.run(args)


def _help() -> int:
    lines = [f"  {name:<10} {_summary(_command(name))}" for name in COMMANDS]
    print(
        "usage: evil [--debug] COMMAND ...\n\nEvilEngine: make 2D games with physics.\n\ncommands:\n"
        + "\n".join(lines)
        + "\n\n  evil help COMMAND    what it does and takes\n  evil --version       the version"
        + "\n  evil --debug ...     show the traceback of an error\n\nStart with `evil play`."
    )
    return 0


def _command(name: str) -> Command:
    return cast(Command, importlib.import_module(f"evilengine.cli.{name}"))


def _summary(command: Command) -> str:
    return (command.__doc__ or "").strip().splitlines()[0].rstrip(".")
