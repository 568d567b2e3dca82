"""Play a level or a game: Prototype 1, an example, a level of yours (.evil) or a game (.py).

While it plays:
  F1                 debug view: outlines, contact normals, gravity
  F2, P              pause, and go on
  F3, .              one step, while paused
  F4                 what each frame costs, as a graph
  F5                 start again; R begins the level that plays anew
  F11                fill the screen, and back
  F12                save a picture; the terminal says where
  Escape             quit
P, . and R are for levels; a game in Python may use letters itself.
A level that changes on disk is loaded again; one with errors is shown with them, and the old one plays on.
Images that change on disk are shown as they are now, in levels and in games.
In levels with tilt, the arrow keys, the mouse wheel or a pad's stick turn gravity. Drag things by mouse or finger.

When the window closes (or Ctrl-C or the system ends it), the game is saved; `evil play --resume` goes on with it.

Without a screen it films ten seconds instead and prints where the film is.
"""

from __future__ import annotations

import argparse
import tempfile
from pathlib import Path

from evilengine.cli import looks, options, sources
from evilengine.values.errors import ArgumentError

FILM_SECONDS = 10.0


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("what", nargs="?", metavar="LEVEL|GAME|EXAMPLE", help="what to play (default: prototype1)")
    parser.add_argument(
        "--resume",
        action="store_true",
        help="go on where the window was closed; without a name, with what was played last",
    )
    parser.add_argument(
        "--record", metavar="FILE", help="record what the player does to FILE (.evr), for `evil replay`"
    )
    parser.add_argument("--headless", action="store_true", help="open no window: film it")
    parser.add_argument("--film", metavar="FILE", help="film it to FILE (.webp, .gif, .png) instead of playing")
    parser.add_argument("--seconds", type=options.seconds, metavar="S", help="stop after S seconds")
    options.add_picture_arguments(parser)


def run(args: argparse.Namespace) -> int:
    path, recording = _what(args), None
    if args.record:
        recording = Path(args.record)
        if recording.suffix != ".evr":
            raise ArgumentError(f"--record {recording} must end in .evr")
    if args.headless or args.film or not _screen():
        from evilengine.cli import film

        target = Path(args.film) if args.film else _writable_folder() / f"{path.stem}.webp"
        shot = film.Shot(
            size=args.size, renderer=args.renderer, looks=looks.of(args), resume=args.resume, record=recording
        )
        print(film.film(path, target, shot, seconds=args.seconds or FILM_SECONDS))
        return 0
    from evilengine.cli.player import Player

    picture = {"size": args.size, "renderer": args.renderer, "looks": looks.of(args)}
    return Player(path, **picture, seconds=args.seconds, resume=args.resume, record=recording).play()


def _what(args: argparse.Namespace) -> Path:
    if args.what is None and args.resume:
        from evilengine.cli import autosave

        return autosave.newest()
    return sources.source(args.what or "prototype1")


def _screen() -> bool:
    from evilengine.platform import screen_available

    screen = screen_available()
    if not screen:
        print(f"{screen.reason}; this is a film instead of a window")
    return bool(screen)


def _writable_folder() -> Path:
    """The current folder, or the one for temporary files where nothing may be written here."""
    try:
        with tempfile.TemporaryFile(dir="."):
            return Path()
    except OSError:
        return Path(tempfile.gettempdir())
