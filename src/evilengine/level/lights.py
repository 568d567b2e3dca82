"""The commands of lights."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, TypeAlias

from evilengine.level.rules import Scope
from evilengine.values import level as commands
from evilengine.values.vec2 import Vec2

if TYPE_CHECKING:
    from evilengine.game import Game
    from evilengine.level.level import Level


Command: TypeAlias = commands.AddLight | commands.SetAmbient | commands.SetShadows


def carry_out(level: Level, command: Command, scope: Scope, game: Game) -> None:
    if isinstance(command, commands.SetShadows):
        game.lights.shadows = command.on
        return
    if isinstance(command, commands.SetAmbient):
        strength = command.strength
        game.ambient = strength if isinstance(strength, str) else level._number(strength, scope)
        return
    options: dict[str, Any] = {each.name: level._value(each.value, scope) for each in command.options}
    if not level._has_room(command) or options.get("body", True) is None:
        return
    if "direction" in options:
        options["direction"] = Vec2(1.0, 0.0).turned(options["direction"])
    for name in ("shadows", "on"):
        if name in options:
            options[name] = False
    if "texture" in options:
        options["texture"] = level._beside(options["texture"])
    if not options.keys() & {"at", "direction", "body"}:
        options["at"] = (0.0, 0.0)
    level._made_thing(game.add_light(**options), command.name, scope)
