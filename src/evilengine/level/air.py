"""The commands of backgrounds, planes, particles, the lens and the camera."""

from __future__ import annotations

from functools import reduce
from pathlib import PurePath
from typing import TYPE_CHECKING, Any

from evilengine.level import lights, looks
from evilengine.level.rules import Scope
from evilengine.script.air_options import emitter_options
from evilengine.values import level as commands

if TYPE_CHECKING:
    from evilengine.game import Game
    from evilengine.level.level import Level


def carry_out(level: Level, command: commands.Picture, scope: Scope, game: Game) -> None:
    if isinstance(command, commands.AddLight | commands.SetAmbient | commands.SetShadows):
        lights.carry_out(level, command, scope, game)
        return
    options: dict[str, Any] = {each.name: level._value(each.value, scope) for each in command.options}
    match command:
        case commands.SetBackground(what=what):
            game.add_background(level._beside(what) if PurePath(what).suffix else what, **options)
        case commands.SetPlane(layer=number):
            layer = game.layers[int(level._number(number, scope))]
            if "fog_above" in options:
                options["fog"] = [options.get("fog", options["fog_above"]), options.pop("fog_above")]
            if "hidden" in options:
                options["visible"] = not options.pop("hidden")
            for name, value in options.items():
                *way, last = name.split(".")
                setattr(reduce(getattr, way, layer), last, value)
        case commands.SetLens():
            if "filmic" in options:
                options["tone_mapping"] = "filmic" if options.pop("filmic") else "plain"
            for name in ("perspective", "distance"):
                if name in options:
                    setattr(game.layers, name, options.pop(name))
            for name, value in options.items():
                setattr(game.post, name, value)
        case commands.SetCamera():
            looks.set_camera(game.camera, options)
        case commands.AddParticles(name=name):
            if level._has_room(command) and options.get("body", True) is not None:
                if "texture" in options:
                    options["texture"] = level._beside(options["texture"])
                if "burst" in options:
                    options["burst"] = int(options["burst"])
                level._made_thing(game.add_particles(**emitter_options(options)), name, scope)
