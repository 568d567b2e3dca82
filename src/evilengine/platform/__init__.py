"""Devices: where a game is seen and what its player holds."""

from __future__ import annotations

from evilengine.platform.desktop import DesktopDevice
from evilengine.platform.device import Device
from evilengine.platform.headless import HeadlessDevice
from evilengine.platform.sdl import Screen, screen_available
from evilengine.platform.speaker import Speaker
from evilengine.values.checks import known_keywords

__all__ = ["DesktopDevice", "Device", "HeadlessDevice", "Screen", "Speaker", "open_device", "screen_available"]


@known_keywords
def open_device(
    title: str = "EvilEngine",
    size: tuple[int, int] = (960, 540),
    *,
    headless: bool = False,
    vsync: bool = True,
    gl: bool = False,
) -> DesktopDevice | HeadlessDevice:
    """A window, or with `headless=True` a device without a screen. Raises DeviceError where no window can be opened.

    With `gl=True` the window has a `surface` for a renderer to draw on, where there is a driver for it.

    >>> open_device("Tilt", (640, 360), headless=True).size
    (640, 360)
    """
    if headless:
        return HeadlessDevice(size, title=title)
    return DesktopDevice(title, size, vsync=vsync, gl=gl)
