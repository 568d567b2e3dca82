"""What a level says shall happen later: blocks of its commands that wait for an event, each with the names it knows."""

from __future__ import annotations

from collections import ChainMap
from typing import TYPE_CHECKING, Any, TypeAlias

from evilengine.values import level as commands
from evilengine.world.body import Body
from evilengine.world.forces import Force
from evilengine.world.joints import Joint

if TYPE_CHECKING:
    from evilengine.level.level import Level
    from evilengine.scene import Drawing, Emitter, Light, Text
    from evilengine.timer import Event
    from evilengine.world.liquid import Liquid
    from evilengine.world.smoke import Smoke, Source
    from evilengine.world.water import Stream, Water

Made: TypeAlias = "Body | Drawing | Emitter | Force | Joint | Light | Smoke | Source | Stream | Text | Water"
Thing: TypeAlias = "Made | Liquid"


class Gone:
    """Stands for a thing that a name meant and that was destroyed, after a resume: the name still hides others."""

    alive = False


class Scope:
    """The names known in a block: its own, then those of the blocks round it."""

    __slots__ = ("numbers", "outer", "things")

    def __init__(self, outer: Scope | None = None) -> None:
        self.outer = outer
        self.things: ChainMap[str, Thing | Gone] = outer.things.new_child() if outer else ChainMap()
        self.numbers: ChainMap[str, float] = outer.numbers.new_child() if outer else ChainMap()

    def change(self, name: str, value: float) -> None:
        """Set a number where it was made."""
        for each in self.numbers.maps:
            if name in each:
                each[name] = value
                return


class Consequence:
    """What follows an event: the block of a command, in the scope in which the command was met."""

    __slots__ = ("command", "level", "scope")

    def __init__(self, level: Level, command: commands.Waiting, scope: Scope) -> None:
        self.level = level
        self.command = command
        self.scope = scope

    def __call__(self, this: Body | None = None, other: Body | None = None) -> None:
        inner = Scope(self.scope)
        if this is not None:
            inner.things["this"] = this
        if other is not None:
            inner.things["other"] = other
        self.level._block(self.command.block, inner)


class Rounds(Consequence):
    """The block of an `every`, time and again."""

    __slots__ = ("count", "event", "times")

    def __init__(self, level: Level, command: commands.Every, scope: Scope, times: int | None, count: int = 0) -> None:
        super().__init__(level, command, scope)
        self.times = times
        self.count = count
        self.event: Event | None = None

    def __call__(self, this: Body | None = None, other: Body | None = None) -> None:
        self.count += 1
        if self.count == self.times and self.event is not None:
            self.event.cancel()
        inner = Scope(self.scope)
        if isinstance(self.command, commands.Every) and self.command.counter:
            inner.numbers[self.command.counter] = float(self.count)
        self.level._block(self.command.block, inner)


class Answers:
    """What a level does when the player does something, in the order in which it said so."""

    def __init__(self) -> None:
        self.keys: list[Consequence] = []
        self.touches: list[Consequence] = []
        self.shakes: list[Consequence] = []

    def add(self, answer: Consequence) -> None:
        """Let `answer` be what follows its event, from the next time on."""
        match answer.command:
            case commands.OnKey():
                self.keys.append(answer)
            case commands.OnTouch():
                self.touches.append(answer)
            case _:
                self.shakes.append(answer)

    def all(self) -> tuple[Consequence, ...]:
        """Every answer; those of a kind in their order."""
        return (*self.keys, *self.touches, *self.shakes)

    def pressed(self, key: str) -> None:
        for answer in tuple(self.keys):
            if isinstance(answer.command, commands.OnKey) and answer.command.key == key:
                answer()

    def touched(self, touch: Any) -> None:
        if touch.phase == "began":
            for answer in tuple(self.touches):
                answer()

    def shaken(self) -> None:
        for answer in tuple(self.shakes):
            answer()
