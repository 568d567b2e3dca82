"""Surface: where a renderer draws without making a picture first, because the platform has a GL context for it."""

from __future__ import annotations

from typing import Protocol


class Surface(Protocol):
    """A window's GL context. Only the thread that made it may use it."""

    @property
    def pixel_size(self) -> tuple[int, int]:
        """Width and height in real pixels."""

    def make_current(self) -> None:
        """Let this context be the one that draws. Raises DeviceError if it is gone."""

    def address(self, name: str) -> int:
        """Where a function of GL is; 0 if there is none of that name."""

    def swap(self) -> None:
        """Put what was drawn on the screen; waits for it when the window's vsync is on."""

    def close(self) -> None:
        """Give the context back; the window shows pictures from here on. Closing twice does nothing."""


class Shows(Protocol):
    """What a renderer asks of a device to be seen."""

    def show(self, pixels: object, size: tuple[int, int]) -> None:
        """Put a picture on the screen."""
