"""Look at the scenes of the benchmarks, drag their bodies about, and see what they cost.

A menu at the left has all scenes; click on one, or go by the arrow keys. Drag bodies with the mouse.
  evil testbed                     the pyramid, and a menu of the others
  evil testbed tumbler             one of them
  evil testbed --list              what there is
  evil testbed --film rain.webp    a film instead of a window

D or F1 is the debug view, 1 to 9 turn parts of it on and off, P pauses, a full stop makes one step, R starts again,
- and + make the scene smaller and larger, G or F4 shows and hides the graph of timings, the wheel zooms.
"""

from __future__ import annotations

import argparse
import time
from pathlib import Path
from typing import TYPE_CHECKING

from evilengine.cli import looks, options
from evilengine.values.errors import ArgumentError

if TYPE_CHECKING:
    from evilengine.bench.testbed import Testbed

FILM_SECONDS, FILM_FPS = 6.0, 30.0


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "scene", nargs="?", default="pyramid", metavar="SCENE", help="where to begin (default: pyramid)"
    )
    parser.add_argument("--list", action="store_true", help="name the scenes and end")
    parser.add_argument(
        "--threads", type=options.threads, metavar="N", default=1, help="threads of a step (default: 1)"
    )
    parser.add_argument(
        "--film", metavar="FILE", help="film it to FILE (.webp, .gif, .png) instead of opening a window"
    )
    parser.add_argument("--seconds", type=options.seconds, metavar="S", help="stop after S seconds (a film: 6)")
    options.add_picture_arguments(parser)


def run(args: argparse.Namespace) -> int:
    from evilengine.bench.scene import find

    if args.list:
        from evilengine.bench.testbed import names

        print("\n".join(names()))
        return 0
    find(args.scene)
    if args.film:
        return _film(args, Path(args.film))
    from evilengine.platform import screen_available

    screen = screen_available()
    if not screen:
        raise ArgumentError(f"{screen.reason}; --film FILE films the testbed instead")
    return _play(_open(args), args.seconds)


def _open(args: argparse.Namespace, headless: bool = False) -> Testbed:
    from evilengine.bench.testbed import SIZE, Testbed
    from evilengine.platform import HeadlessDevice

    size = args.size or SIZE
    device = HeadlessDevice(size, title="EvilEngine testbed") if headless else None
    bed = Testbed(args.scene, size=size, renderer=args.renderer, threads=args.threads, device=device)
    looks.of(args).put_on(bed.game)
    return bed


def _play(bed: Testbed, seconds: float | None) -> int:
    from evilengine.game import keep_pace

    start = now = time.perf_counter()
    try:
        while bed.game.running and (seconds is None or now - start < seconds):
            bed.frame(now)
            keep_pace(bed.game.device, now)
            now = time.perf_counter()
    finally:
        bed.game.close()
    return 0


def _film(args: argparse.Namespace, target: Path) -> int:
    from evilengine.assets.film import save_film
    from evilengine.cli.film import FILMS, Bar, check_ending

    check_ending(target, FILMS, "a film")
    frames = max(1, round((args.seconds or FILM_SECONDS) * FILM_FPS))
    bed, bar = _open(args, headless=True), Bar(target.name)
    try:
        save_film(bed.frames(frames, FILM_FPS), target, fps=FILM_FPS, progress=lambda count: bar(count / frames))
    finally:
        bed.game.close()
    print(target)
    return 0
