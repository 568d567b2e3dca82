"""What the engine asks of a device, whichever it is: a window, a browser's canvas, or nothing at all."""

from __future__ import annotations

import operator
from typing import Protocol

from evilengine.values.errors import ArgumentError, ArgumentTypeError
from evilengine.values.events import Event
from evilengine.values.surface import Surface

MOST_POINTS = 16384
"""Widest and highest window, in points: what graphics drivers take as a texture's side."""


class Device(Protocol):
    """A screen and what the player holds. Only the thread that made a device may use it."""

    title: str
    vsync: bool
    """True when `show` waits for the screen, so that a loop needs no clock of its own to keep its pace."""
    fullscreen: bool
    """Does it fill the screen? May be set; a ResizeEvent tells the size that comes of it."""

    @property
    def size(self) -> tuple[int, int]:
        """Width and height in logical points, the unit of event positions."""

    @property
    def pixel_size(self) -> tuple[int, int]:
        """Width and height in real pixels: what to draw."""

    @property
    def scale(self) -> float:
        """Real pixels a logical point."""

    @property
    def is_open(self) -> bool:
        """False once `close` was called."""

    @property
    def surface(self) -> Surface | None:
        """The GL context of the window, to draw on instead of showing pictures; None where there is none."""

    def poll(self) -> tuple[Event, ...]:
        """What happened since the last call, in order."""

    def show(self, pixels: object, size: tuple[int, int]) -> None:
        """Put a picture on the screen, stretched over all of it.

        `pixels` is any buffer of size[0] * size[1] * 4 bytes: rows from the top, each pixel red, green, blue and an
        alpha that is ignored.
        """

    def close(self) -> None:
        """Give everything back. Closing twice does nothing."""


def to_size(value: object, owner: str) -> tuple[int, int]:
    """`value` as (width, height) in whole points, or an error that names `owner`."""
    try:
        width, height = map(operator.index, value)  # type: ignore[call-overload]
    except (TypeError, ValueError):
        raise ArgumentTypeError(f"{owner}: size={value!r} must be a pair of whole numbers such as (960, 540)") from None
    if not (1 <= width <= MOST_POINTS and 1 <= height <= MOST_POINTS):
        raise ArgumentError(f"{owner}: size={value!r} must be at least 1 and at most {MOST_POINTS} points each way")
    return int(width), int(height)


def to_picture(pixels: object, size: object, owner: str) -> tuple[memoryview, tuple[int, int]]:
    """`pixels` as flat bytes that fit `size`, or an error that names `owner`."""
    width, height = to_size(size, owner)
    try:
        view = memoryview(pixels)  # type: ignore[arg-type]
        flat = view if view.ndim == 1 and view.format == "B" else view.cast("B")
    except TypeError:
        raise ArgumentTypeError(
            f"{owner}: pixels must be a contiguous buffer of bytes, got {type(pixels).__name__}"
        ) from None
    needed = width * height * 4
    if flat.nbytes != needed:
        raise ArgumentError(f"{owner}: pixels has {flat.nbytes} bytes; size={size!r} needs {needed}, four a pixel")
    return flat, (width, height)
