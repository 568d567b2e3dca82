"""The commands of characters. A level knows a character by its body, as all that meets it does."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from evilengine.level.rules import Scope
from evilengine.values import level as commands
from evilengine.world.body import Body
from evilengine.world.character import Character
from evilengine.world.world import World

if TYPE_CHECKING:
    from evilengine.level.level import Level


def carry_out(
    level: Level,
    command: commands.AddCharacter | commands.AddLadder | commands.Tell | commands.Drive,
    scope: Scope,
) -> None:
    match command:
        case commands.AddCharacter():
            _add(level, command, scope)
        case commands.AddLadder(area=area, bodies=bodies):
            edges = level._value(area, scope)
            named = [level._thing(each, scope) for each in bodies]
            for character in those(level.world, named) if bodies else level.world.characters:
                character.add_ladder(edges)
        case commands.Tell(target=target, what=what, value=value):
            axis = () if value is None else (level._number(value, scope),)
            for character in those(level.world, (level._thing(target, scope),)):
                getattr(character, what)(*axis)
        case commands.Drive():
            _drive(level, command, scope)


def those(world: World, things: Iterable[object]) -> tuple[Character, ...]:
    """The characters whose bodies are among `things`."""
    found = (world.character_of(each) for each in things if isinstance(each, Body))
    return tuple(each for each in found if each is not None)


def _add(level: Level, command: commands.AddCharacter, scope: Scope) -> None:
    shape, options = level._made(command.shape, scope), level._looks(command.options, scope)
    if not level._is_full():
        add = level.world.add_character if level.game is None else level.game.add_character
        level._made_body(add(shape, **options).body, command.name, scope)


def _drive(level: Level, command: commands.Drive, scope: Scope) -> None:
    """A world alone has no keys; and nobody is steered in place of one who is gone."""
    if level.game is None:
        return
    if command.target is None:
        level.game.drive(None)
    for character in those(level.world, () if command.target is None else (level._thing(command.target, scope),)):
        level.game.drive(character, **dict(command.keys))
