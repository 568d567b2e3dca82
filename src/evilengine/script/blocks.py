"""Questions about blocks of commands."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import fields, is_dataclass

from evilengine.values import level as commands
from evilengine.values.level import Block, Called, Command, Tagged


def inline(block: Block) -> Iterator[Command]:
    """The commands that a block carries out at once: its own and those of what it repeats or chooses."""
    for command in block:
        yield command
        match command:
            case commands.Repeat(block=inner):
                yield from inline(inner)
            case commands.If(then=then, otherwise=otherwise):
                yield from inline(then)
                yield from inline(otherwise)


def changed(block: Block) -> set[str]:
    """Numbers made outside a block that it changes."""
    made = {each.name for each in inline(block) if isinstance(each, commands.Let)}
    return {each.name for each in inline(block) if isinstance(each, commands.SetNumber)} - made


def destroyed(block: Block) -> set[str]:
    """What a block destroys at once."""
    return {each.target.name for each in inline(block) if isinstance(each, commands.Destroy)}


def used(block: Block) -> set[Called]:
    """What a block speaks of, in the blocks inside it too."""
    found: set[Called] = set()
    pending: list[object] = [block]
    while pending:
        each = pending.pop()
        if isinstance(each, Called):
            found.add(each)
        elif isinstance(each, tuple):
            pending.extend(each)
        elif is_dataclass(each):
            pending.extend(getattr(each, field.name) for field in fields(each))
    return found


def is_deferred(block: Block) -> bool:
    """Whether a block makes functions that are called later, and so must keep the values of its round."""
    later = any(isinstance(each, commands.Waiting) for each in inline(block))
    return later or any(isinstance(each, commands.AddText) and len(each.pieces) > 1 for each in inline(block))


def has_tags(block: Block) -> bool:
    """Whether some event is about everything with a tag."""
    for command in inline(block):
        if isinstance(getattr(command, "first", None), Tagged):
            return True
        if not isinstance(command, commands.Repeat | commands.If) and has_tags(getattr(command, "block", ())):
            return True
    return False
