"""Play a recording (.evr) again, and say whether everything comes out as it did.

evil replay r.evr                      in a window, at the speed at which it was played
evil replay r.evr --headless           as fast as it goes, without a picture
evil replay r.evr -o film.webp         as a film (.webp, .gif, .png)
evil replay r.evr game.py              a recording of a game in Python, which is somewhere else now

Exit code 1 where the game parts from the recording; the step and the part of the engine are said.
`evil play --record r.evr` makes recordings.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from evilengine.cli import film, looks, options
from evilengine.cli.stage import perform
from evilengine.platform import open_device, screen_available
from evilengine.save import Replay
from evilengine.values.errors import ArgumentError, Error, SaveError
from evilengine.values.events import CloseEvent, KeyEvent
from evilengine.values.tick import STEP

if TYPE_CHECKING:
    from evilengine.game import Game
    from evilengine.game.replaying import Playback
    from evilengine.platform import Device

QUIT_KEYS = ("escape",)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("recording", metavar="RECORDING", help="what to play again (.evr)")
    parser.add_argument("game", nargs="?", metavar="GAME", help="the game in Python that it is of, if it was moved")
    parser.add_argument("--headless", action="store_true", help="only check: no window, as fast as it goes")
    parser.add_argument("-o", "--output", metavar="FILE", help="write a film instead")
    parser.add_argument("--fps", type=options.fps, default=30.0, metavar="N", help="frames a second of the film (30)")
    options.add_picture_arguments(parser)


def run(args: argparse.Namespace) -> int:
    replay = Replay.read(Path(args.recording))
    shot = film.Shot(size=args.size, renderer=args.renderer, sway=False, looks=looks.of(args))
    if args.output:
        film.check_ending(Path(args.output), film.FILMS, "a film")
        show: Callable[[Game, Playback], None] = film.Reel(Path(args.output), shot, args.fps)
    elif args.headless or not screen_available():
        show = _check
    else:
        show = _watch
    stage = _Stage(replay, show, shot)
    _perform(replay, stage, args)
    return _report(replay, stage.playback)


class _Stage:
    """Plays a recording on the first game that runs."""

    replays = True

    def __init__(self, replay: Replay, show: Callable[[Game, Playback], None], shot: film.Shot) -> None:
        self.replay, self.show, self.shot = replay, show, shot
        self.playback: Playback | None = None

    def open(self, title: str, size: tuple[int, int]) -> Device:
        if self.show is _watch:
            return open_device(title, self.shot.size or size)
        return film.Screen(title, size, self.shot.size or size)

    def run(self, game: Game) -> None:
        try:
            if self.playback is None:
                from evilengine.game import replaying

                self.shot.looks.put_on(game)
                game._playback = self.playback = replaying.play(game, self.replay)
                self.show(game, self.playback)
        finally:
            game.close()


def _perform(replay: Replay, stage: _Stage, args: argparse.Namespace) -> None:
    from evilengine.game import STAGE
    from evilengine.game.replaying import LEVEL, game_of

    if replay.header.get("of") == LEVEL:
        if args.game:
            raise ArgumentError(f"{replay.name} is of a level and holds it; leave out {args.game}")
        token = STAGE.set(stage)
        try:
            game_of(replay, renderer=args.renderer).run()
        finally:
            STAGE.reset(token)
        return
    path = _program(replay, args.game)
    perform(path, stage, renderer=args.renderer)
    if stage.playback is None:
        raise Error(f"{path} ended without game.run(), so nothing was played")


def _program(replay: Replay, given: str | None) -> Path:
    """The game in Python that a recording is of: the one given, or the recorded one if it is as it was."""
    from evilengine.game.replaying import hash_of

    path = Path(given if given is not None else str(replay.header.get("file") or ""))
    if path.suffix != ".py" or not path.is_file():
        raise SaveError(
            f"{replay.name} is of a game in Python, {path}, which is not there; name it: evil replay {replay.name} GAME"
        )
    if hash_of(path.read_bytes()) != replay.header.get("hash"):
        if given is None:  # a recording may come from anybody: it does not choose what runs here
            raise SaveError(
                f"{replay.name} was recorded with another {path.name} than the one that is there now;"
                f" to play it with that: evil replay {replay.name} {path}"
            )
        print(f"{path.name} has changed since {replay.name} was recorded", file=sys.stderr)
    return path


# Ways to play it ------------------------------------------------------------------------------------------------------


def _check(game: Game, playback: Playback) -> None:
    while game.running and not playback.over:
        game.step()


def _watch(game: Game, playback: Playback) -> None:
    from evilengine.game import keep_pace

    def quit_on_request(event: object) -> None:
        if isinstance(event, CloseEvent) or (isinstance(event, KeyEvent) and event.down and event.key in QUIT_KEYS):
            game.quit()

    game._watchers.append(quit_on_request)
    line = game.scene.overlay("", at=(0, 26), anchor="top", size=15, colour="#ffffffc0")
    while game.running and not playback.over:
        now = time.perf_counter()
        apart = f"     parts from the recording at {playback.difference}" if playback.difference else ""
        line.text = f"replay {playback.made * STEP:.1f} of {len(playback.replay.steps) * STEP:.1f} s{apart}"
        game.frame(now)
        keep_pace(game.device, now)


def _report(replay: Replay, playback: Playback | None) -> int:
    assert playback is not None
    name, steps = replay.name, len(replay.steps)
    if not replay.complete:
        print(f"{name} breaks off after step {steps}: what was recorded there ended without a word")
    if playback.difference is not None:
        print(f"{name}: the game first differs from the recording at {playback.difference}")
        return 1
    if not playback.over:
        print(f"{name}: as recorded up to step {playback.made} of {steps}, where it was ended")
        return 0
    print(f"{name}: {steps} steps ({steps * STEP:.1f} s), all as recorded")
    return 0
