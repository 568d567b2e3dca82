"""The commands of smoke and fire, which a world alone knows too, without their looks."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from evilengine.level.rules import Scope
from evilengine.scene.gases import LOOKS
from evilengine.script.fluid_options import smoke_options, source_options
from evilengine.script.fluids import MAX_SMOKES
from evilengine.values import level as commands
from evilengine.world.shapes import Rectangle
from evilengine.world.smoke import Smoke

if TYPE_CHECKING:
    from evilengine.level.level import Level


def carry_out(level: Level, command: commands.Fluid, scope: Scope) -> None:
    said: dict[str, Any] = {each.name: level._value(each.value, scope) for each in command.options}
    match command:
        case commands.AddSmoke(area=area):
            if len(level.world.smokes) < MAX_SMOKES and level._has_room(command):
                options = smoke_options(said)
                edges = level._value(area, scope)
                level._made_thing(_add_smoke(level, edges, options), command.name, scope)
        case commands.AddSource(smoke=called):
            smoke = level._thing(called, scope)
            if isinstance(smoke, Smoke) and said.get("body", True) is not None and level._has_room(command):
                shape = Rectangle(said["wide"], said["tall"]) if "wide" in said else None
                source = smoke.add_source(shape, **source_options(said))
                source.running = "running" not in said
                level._made_thing(source, command.name, scope)


def _add_smoke(level: Level, area: Any, options: dict[str, Any]) -> Smoke:
    if level.game is not None:
        return level.game.add_smoke(area, **options)
    return level.world.add_smoke(area, **{name: value for name, value in options.items() if name not in LOOKS})
