"""Arguments that several commands share."""

from __future__ import annotations

import argparse
import math
import re

from evilengine.cli import looks


def add_picture_arguments(parser: argparse.ArgumentParser) -> None:
    """--size and --renderer, and how the game is looked at."""
    parser.add_argument("--size", type=size, metavar="WxH", help="size of the picture, such as 960x540")
    parser.add_argument("--renderer", choices=("auto", "gl", "soft"), default="auto", help="who draws (default: auto)")
    looks.add_arguments(parser)


def size(text: str) -> tuple[int, int]:
    """`960x540` as numbers.

    >>> size("960x540")
    (960, 540)
    """
    match = re.fullmatch(r"(\d{1,5})[x*](\d{1,5})", text.strip().lower())
    width, height = (int(part) for part in match.groups()) if match else (0, 0)
    if not (1 <= width <= 8192 and 1 <= height <= 8192):
        raise argparse.ArgumentTypeError(f"{text!r} must be WIDTHxHEIGHT, each 1 to 8192, such as 960x540")
    return width, height


def seconds(text: str) -> float:
    """A time of play: more than 0, at most an hour."""
    return _number(text, 1e-3, 3600.0, "a number of seconds, at most 3600")


def moment(text: str) -> float:
    """A moment of play: 0 or more, at most an hour."""
    return _number(text, 0.0, 3600.0, "a number of seconds, 0 to 3600")


def count(text: str) -> int:
    """A whole number, 1 to a million."""
    return _whole(text, 1_000_000)


def threads(text: str) -> int:
    """How many threads: 1 to 256."""
    return _whole(text, 256)


def substeps(text: str) -> int:
    """How many parts of a step: 1 to 256."""
    return _whole(text, 256)


def _whole(text: str, most: int) -> int:
    if not (text.isdecimal() and len(text) < 8 and 1 <= int(text) <= most):
        raise argparse.ArgumentTypeError(f"{text!r} must be a whole number, 1 to {most}")
    return int(text)


def fps(text: str) -> float:
    """Frames a second: 1 to 120."""
    return _number(text, 1.0, 120.0, "a number of frames a second, 1 to 120")


def _number(text: str, least: float, most: float, meaning: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not least <= value <= most:
        raise argparse.ArgumentTypeError(f"{text!r} must be {meaning}")
    return value
