"""The commands of lights."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from evilengine.level.rules import Scope
from evilengine.values import level as commands
from evilengine.values.vec2 import Vec2

if TYPE_CHECKING:
    from evilengine.game import Game
    from evilengine.level.level import Level


def carry_out(level: Level, command: commands.AddLight | commands.SetAmbient, scope: Scope, game: Game) -> None:
    if isinstance(command, commands.SetAmbient):
        game.ambient = level._number(command.strength, scope)
        return
    options: dict[str, Any] = {each.name: level._value(each.value, scope) for each in command.options}
    if not level._has_room(command) or options.get("body", True) is None:
        return
    if "direction" in options:
        options["direction"] = Vec2(1.0, 0.0).turned(options["direction"])
    if "shadows" in options:
        options["shadows"] = False
    if not options.keys() & {"at", "direction", "body"}:
        options["at"] = (0.0, 0.0)
    level._made_thing(game.add_light(**options), command.name, scope)
