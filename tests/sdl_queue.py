"""For tests: events put into SDL's queue as a driver would put them there."""

from __future__ import annotations

import ctypes

from evilengine.platform import DesktopDevice
from evilengine.platform import sdl as library


def push(**fields: object) -> None:
    """Put one event into SDL's queue, as a driver would."""
    sdl = library.load()
    event = sdl.SDL_Event()
    part_name = str(fields.pop("part"))
    event.type = fields.pop("type")
    part = getattr(event, part_name)
    part.type = event.type
    for name, value in fields.items():
        target = part
        *path, last = name.split("__")
        for step in path:
            target = getattr(target, step)
        setattr(target, last, value)
    assert sdl.SDL_PushEvent(ctypes.byref(event)) == 1


def window_id(device: DesktopDevice) -> int:
    return library.load().SDL_GetWindowID(device._window)


def push_key(device: DesktopDevice, code: int, place: int, down: bool, repeat: int = 0) -> None:
    sdl = library.load()
    push(
        part="key",
        type=sdl.SDL_KEYDOWN if down else sdl.SDL_KEYUP,
        windowID=window_id(device),
        state=int(down),
        repeat=repeat,
        keysym__sym=code,
        keysym__scancode=place,
    )


def push_finger(device: DesktopDevice, kind: str, finger: int, x: float, y: float, touch: int = 5) -> None:
    sdl = library.load()
    push(
        part="tfinger",
        type=getattr(sdl, f"SDL_FINGER{kind}"),
        windowID=window_id(device),
        touchId=touch,
        fingerId=finger,
        x=x,
        y=y,
    )
