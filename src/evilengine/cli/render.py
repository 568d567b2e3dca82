"""Render a level, a game or an example to a film or a picture, without a window.

evil render level.evil -o film.webp                     ten seconds
evil render level.evil -o film.gif --seconds 4 --fps 25 --size 480x270
evil render level.evil -o picture.png --at 2.5          how it looks after 2.5 seconds

A .png is a picture unless --seconds asks for a film; .webp and .gif are films unless --at asks for a picture.
"""

from __future__ import annotations

import argparse
from pathlib import Path

from evilengine.cli import looks, options, sources
from evilengine.values.errors import ArgumentError

FILM_SECONDS = 10.0
PICTURE_SECONDS = 2.0
"""When a picture is taken unless --at says: things have fallen and some still move."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("what", metavar="LEVEL|GAME|EXAMPLE", help="what to render")
    parser.add_argument(
        "-o", "--output", required=True, metavar="FILE", help="what to write; its ending says what it is"
    )
    parser.add_argument("--seconds", type=options.seconds, metavar="S", help="a film of S seconds (default: 10)")
    parser.add_argument(
        "--at", type=options.moment, metavar="T", help="a picture, T seconds into the play (default: 2)"
    )
    parser.add_argument("--fps", type=options.fps, default=30.0, metavar="N", help="frames a second (default: 30)")
    parser.add_argument("--tilt", choices=("sway", "off"), default="sway", help="does a hand sway levels with tilt?")
    options.add_picture_arguments(parser)


def run(args: argparse.Namespace) -> int:
    from evilengine.cli import film

    if args.at is not None and args.seconds is not None:
        raise ArgumentError("--at makes a picture and --seconds a film; give one of them")
    path, target = sources.source(args.what), Path(args.output)
    shot = film.Shot(size=args.size, renderer=args.renderer, sway=args.tilt == "sway", looks=looks.of(args))
    if target.suffix.lower() not in film.FILMS + film.PICTURES:
        raise ArgumentError(f"{target} must end in {', '.join(film.FILMS)} for a film, .png or .jpg for a picture")
    if args.at is not None or (target.suffix.lower() not in (".webp", ".gif") and args.seconds is None):
        print(film.picture(path, target, shot, at=PICTURE_SECONDS if args.at is None else args.at))
    else:
        print(film.film(path, target, shot, seconds=args.seconds or FILM_SECONDS, fps=args.fps))
    return 0
