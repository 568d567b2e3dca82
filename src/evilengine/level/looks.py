"""How the things of a level look, in the words of a game."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from evilengine.values import level as commands
from evilengine.values.sheet import ALL_FRAMES, Animation, Sheet
from evilengine.world.body import Body

if TYPE_CHECKING:
    from evilengine.game import Game
    from evilengine.level.level import Level
    from evilengine.level.rules import Scope
    from evilengine.scene import Camera

MAPS = frozenset({"normal_map", "glow_map"})
"""Pictures of a surface, beside that of its colours."""

LOOKS = (
    frozenset({"colour", "colours", "texture", "frames", "fps", "frame", "course", "tile", "slice", "flip_x", "flip_y"})
    | {"blend", "outline", "layer", "lit", "behind", "depth", "hidden", "glow"}
    | MAPS
)
"""What a world alone has no use for."""


def drawn(values: dict[str, Any], beside: Callable[[str], str]) -> dict[str, Any]:
    """Options as a game takes them: what is visible rather than hidden, a sheet where a picture has frames, and files
    by the names that `beside` gives them."""
    frames, frame = values.pop("frames", None), values.pop("frame", None)
    speed, course = ({name: values.pop(name)} if name in values else {} for name in ("fps", "course"))
    if values.pop("hidden", False):
        values["visible"] = False
    for name in ("texture", *sorted(MAPS)):
        if name in values:
            values[name] = beside(values[name])
    if frames is not None:
        columns, rows = (int(each) for each in frames)
        shown = range(columns * rows) if frame is None else [int(frame)]
        every = {ALL_FRAMES: Animation(shown, **course)}
        sheet = Sheet(values["texture"], columns, rows, animations=every, **speed)
        values |= {"texture": sheet, "animation": ALL_FRAMES}
    return values


def written(values: dict[str, Any], beside: Callable[[str], str]) -> dict[str, Any]:
    """Options of a text as a game takes them."""
    if values.pop("hidden", False):
        values["visible"] = False
    if "font" in values:
        values["font"] = beside(values["font"])
    return values


def move_camera(
    level: Level, command: commands.Quake | commands.Follow | commands.Split, scope: Scope, game: Game
) -> None:
    """What the camera is told, or the cameras."""
    if isinstance(command, commands.Quake):
        game.camera.shake(level._number(command.strength, scope))
        return
    if isinstance(command, commands.Split):
        there = [body for each in command.targets if isinstance(body := level._thing(each, scope), Body)]
        if len(there) == len(command.targets):  # else one is gone
            game.split(*there)
        return
    body = level._thing(command.target, scope)
    if isinstance(body, Body):  # else it is gone
        game.camera.follow(body)


def set_camera(camera: Camera, told: dict[str, Any]) -> None:
    """What `camera` says, by the names of its properties' options."""
    following = {name: told.pop(name) for name in ("dead_zone", "smoothing", "offset") if name in told}
    target = told.pop("target", None)
    if isinstance(target, Body):  # else it is gone, or nobody was named
        camera.follow(target, **following)
    if "low" in told:
        camera.bounds = (*told.pop("low"), *told.pop("high"))
    seconds = told.pop("seconds", None)
    if seconds is not None:
        camera.glide(**told, seconds=seconds)
        return
    for name, value in told.items():
        setattr(camera, name, value)
