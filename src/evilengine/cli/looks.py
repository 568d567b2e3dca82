"""How a game is looked at that somebody else made: what the debug view shows over it, and the quality of its light."""

from __future__ import annotations

import argparse
from dataclasses import dataclass
from typing import TYPE_CHECKING

from evilengine.scene.debug import PARTS
from evilengine.values.checks import did_you_mean
from evilengine.values.governor import QUALITIES

if TYPE_CHECKING:
    from evilengine.game import Game


@dataclass(frozen=True, slots=True, kw_only=True)
class Looks:
    """What is asked of every game that is shown."""

    debug_view: bool = False
    parts: tuple[str, ...] = ()
    """Of the debug view; none: as the game has them."""
    quality: str | None = None
    """Of light; None: as the game has it."""

    def put_on(self, game: Game) -> None:
        """Let `game` be seen like this."""
        game.debug = game.debug or self.debug_view or bool(self.parts)
        if self.parts:
            game.debug_view.show(self.parts)
        if self.quality is not None:
            game.lights.quality = self.quality


NO_LOOKS = Looks()
"""Games as they are."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """--debug-view, --debug-parts and --quality."""
    parser.add_argument("--debug-view", action="store_true", help="show outlines, contact normals and gravity")
    parser.add_argument(
        "--debug-parts", type=parts, metavar="P,P,...", default=(), help=f"of it, only these: {', '.join(PARTS)}"
    )
    parser.add_argument("--quality", choices=("auto", *QUALITIES), help="of light (default: what the game says)")


def of(args: argparse.Namespace) -> Looks:
    """What the command line asks for."""
    return Looks(debug_view=args.debug_view, parts=args.debug_parts, quality=args.quality)


def parts(text: str) -> tuple[str, ...]:
    """`shapes,contacts` as names of parts.

    >>> parts("shapes, joints")
    ('shapes', 'joints')
    """
    names = tuple(each.strip() for each in text.split(","))
    for name in names:
        if name not in PARTS:
            raise argparse.ArgumentTypeError(f"{name!r} is no part of the debug view{did_you_mean(name, PARTS)}")
    return names
