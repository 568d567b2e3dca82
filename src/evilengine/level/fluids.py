"""The commands of smoke, fire and water, which a world alone knows too, without their looks."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Any

from evilengine.level.rules import Scope
from evilengine.scene import gases, waters
from evilengine.script.fluid_options import box_options, flow_options
from evilengine.script.fluids import MAX_SMOKES
from evilengine.script.waters import MAX_WATERS
from evilengine.values import level as commands
from evilengine.world.liquid import MOST_LIQUIDS
from evilengine.world.shapes import Rectangle
from evilengine.world.smoke import Smoke
from evilengine.world.water import Water

if TYPE_CHECKING:
    from evilengine.level.level import Level


def carry_out(level: Level, command: commands.Fluid, scope: Scope) -> None:
    said: dict[str, Any] = {each.name: level._value(each.value, scope) for each in command.options}
    world, game = level.world, level.game
    match command:
        case commands.AddSmoke(area=area):
            if len(world.smokes) < MAX_SMOKES and level._has_room(command):
                add: Callable[..., Any] = (world if game is None else game).add_smoke
                made = _added(add, level._value(area, scope), said, () if game else gases.LOOKS)
                level._made_thing(made, command.name, scope)
        case commands.AddWater(area=area):
            if len(world.waters) < MAX_WATERS and level._has_room(command):
                add = (world if game is None else game).add_water
                made = _added(add, level._value(area, scope), said, () if game else waters.LOOKS)
                level._made_thing(made, command.name, scope)
        case commands.AddSource(smoke=called):
            smoke = level._thing(called, scope)
            if isinstance(smoke, Smoke) and _is_there(said) and level._has_room(command):
                shape = Rectangle(said["wide"], said["tall"]) if "wide" in said else None
                _start(level, command, scope, smoke.add_source(shape, **flow_options(said)), said)
        case _:
            water = level._thing(command.water, scope)
            if isinstance(water, Water) and _is_there(said):
                _flow(level, command, scope, water, said)


def _flow(
    level: Level,
    command: commands.AddLiquid | commands.FillWater | commands.AddStream,
    scope: Scope,
    water: Water,
    said: dict[str, Any],
) -> None:
    """What is about a water that is there."""
    match command:
        case commands.AddLiquid(name=name):
            if len(water.liquids) < MOST_LIQUIDS:
                liquid = water.add_liquid(**said)
                if name:
                    scope.things[name] = liquid
        case commands.FillWater(shape=shape):
            water.fill(level._made(shape, scope), **said)
        case commands.AddStream(shape=shape):
            if level._has_room(command):
                options = flow_options(said)
                stream = water.pour(**options) if shape is None else water.drain(level._made(shape, scope), **options)
                _start(level, command, scope, stream, said)


def _start(
    level: Level, command: commands.AddSource | commands.AddStream, scope: Scope, flow: Any, said: dict[str, Any]
) -> None:
    flow.running = "running" not in said
    level._made_thing(flow, command.name, scope)


def _is_there(said: dict[str, Any]) -> bool:
    """Whether what a flow goes along with, and the liquid that it brings, are."""
    return said.get("body", True) is not None and said.get("liquid", True) is not None


def _added(add: Callable[..., Any], area: Any, said: dict[str, Any], without: Iterable[str]) -> Any:
    return add(area, **{name: value for name, value in box_options(said).items() if name not in without})
