"""What a saved game keeps of a level at play: its source, the names it knows, and what waits to happen.

A block that waits is saved as the number of its command in the source and the number of its scope, so it comes back as
exactly that block, with the same names.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

from evilengine import script
from evilengine.level.level import Level
from evilengine.level.rules import Consequence, Gone, Rounds, Scope
from evilengine.scene import Drawing, Emitter, Light, Text
from evilengine.script.tags import EVENTS, Rule, Tags, Told
from evilengine.timer import Event
from evilengine.values import level as commands
from evilengine.values.errors import SaveError
from evilengine.world.body import Body
from evilengine.world.forces import Force
from evilengine.world.joints import Joint
from evilengine.world.liquid import Liquid
from evilengine.world.smoke import Smoke, Source
from evilengine.world.water import Stream, Water

if TYPE_CHECKING:
    from evilengine.game import Game

Reference = list[Any] | None
"""["body", slot], and so with force, joint and drawing; ["text", number], ["event", number]; None: it is gone."""

C = TypeVar("C", bound=commands.Command)

Things = Mapping[str, Callable[[int], Any]]
"""For each kind of reference, what gives the thing of that number."""

Known = Mapping[str, set[int]]
"""For each kind of reference, the numbers that lead somewhere."""


def reference(thing: object) -> Reference:
    """What a saved game calls a thing."""
    match thing:
        case Body(alive=True):
            return ["body", thing.slot]
        case Force(alive=True):
            return ["force", thing._handle().slot]
        case Joint(alive=True):
            return ["joint", thing._handle().slot]
        case Drawing(alive=True):
            return ["drawing", thing._slot]
        case Light(alive=True):
            return ["light", thing._slot]
        case Emitter(alive=True):
            return ["emitter", thing._serial]
        case Smoke(alive=True):
            return ["smoke", thing.slot]
        case Source(alive=True):
            return ["source", thing.slot]
        case Water(alive=True):
            return ["water", thing.slot]
        case Liquid(alive=True):
            return ["liquid", thing.number]
        case Stream(alive=True):
            return ["stream", thing.slot]
        case Text(alive=True):
            return ["text", thing._serial]
        case Event(alive=True):
            return ["event", thing._order]
        case _:
            return None


class LevelWriter:
    """Names what refers to a level, and then writes the level with all that was named."""

    def __init__(self, level: Level) -> None:
        if level.script.commands and not level.script.lines:
            raise SaveError(f"the level {level.script.file} cannot be saved: it was not read from a text")
        self._level = level
        self._numbers = {id(command): number for number, command in enumerate(level.script.numbered)}
        self._scopes: dict[int, int] = {}
        self._rows: list[Scope] = []
        self._scope(level._top)

    def name_of(self, function: Any) -> Any:
        """What a saved game calls a function of this level; None if it is none."""
        if isinstance(function, Rounds) and function.level is self._level:
            return {"rounds": [*self._consequence(function), function.times, function.count]}
        if isinstance(function, Consequence) and function.level is self._level:
            return {"then": self._consequence(function)}
        if isinstance(function, Told) and getattr(function.rule.call, "level", None) is self._level:
            rules = self._level._tags.rules
            number = next((n for n, rule in enumerate(rules) if rule is function.rule), None)
            return {"rule": self._rule(function.rule)} if number is None else {"tagged": number}
        return None

    def state(self) -> dict[str, Any]:
        """The level, once everything that refers to it has its name."""
        level, source = self._level, self._level.script
        tags = {
            "bodies": [body.slot for body in level._tags.bodies if body.alive],
            "rules": [self._rule(rule) for rule in level._tags.rules],
        }
        answers = [self._consequence(each) for each in level._answers.all()]
        texts = [
            [text._serial, self._numbers[id(command)], self._scope(scope)]
            for text, command, scope in level._texts
            if text.alive
        ]
        return {
            "file": source.file,
            "folder": str(Path(source.folder).resolve()) if source.folder else "",
            "text": source.text,
            "tags": tags,
            "answers": answers,
            "texts": texts,
            "others": [found for each in level._others if (found := reference(each))],
            "rules": level._rules,
            "full": level._full,
            "scopes": [self._row(scope) for scope in self._rows],
        }

    def _scope(self, scope: Scope) -> int:
        if id(scope) not in self._scopes:
            if scope.outer is not None:
                self._scope(scope.outer)
            self._scopes[id(scope)] = len(self._rows)
            self._rows.append(scope)
        return self._scopes[id(scope)]

    def _row(self, scope: Scope) -> list[Any]:
        outer = None if scope.outer is None else self._scopes[id(scope.outer)]
        things = {name: reference(thing) for name, thing in scope.things.maps[0].items()}
        return [outer, things, dict(scope.numbers.maps[0])]

    def _consequence(self, each: Consequence) -> list[Any]:
        return [self._numbers[id(each.command)], self._scope(each.scope)]

    def _rule(self, rule: Rule) -> list[Any]:
        assert isinstance(rule.call, Consequence)
        second = ["tag", rule.second] if isinstance(rule.second, str) else None
        if isinstance(rule.second, Body):
            second = reference(rule.second) or ["nobody"]
        return [rule.event, rule.tag, second, *self._consequence(rule.call)]


class LevelState:
    """A level that was read, and what it would become; nothing has changed before `put`.

    Raises SaveError for a source that has errors now, and ValueError, TypeError, KeyError or IndexError for what no
    level has written. `known` has the numbers of bodies, forces, drawings, texts and events that there will be.
    """

    def __init__(self, game: Game, state: dict[str, Any], known: Known, present: Level | None) -> None:
        self._known = known
        source = str(state["text"])
        if present is not None and present.script.text == source:
            self.level = present
            self._script = present.script
        else:
            self._script = _read(source, str(state["file"]), str(state["folder"]))
            self.level = Level(self._script, game, built=True)
        self._commands = self._script.numbered
        self._scopes: list[Scope] = []
        for outer, _, _ in state["scopes"]:
            self._scopes.append(Scope(None if outer is None else self._earlier(outer)))
        self._things = [self._checked(things) for _, things, _ in state["scopes"]]
        self._numbers = [{str(name): float(value) for name, value in row.items()} for _, _, row in state["scopes"]]
        self._bodies = [self._check(["body", slot]) for slot in state["tags"]["bodies"]]
        self._told: list[tuple[Told, int]] = []
        self._seconds: list[tuple[Rule, Reference]] = []
        self._tags = Tags()
        self._tags.rules = [self._rule(row) for row in state["tags"]["rules"]]
        self._answers = [self._consequence(*row) for row in state["answers"]]
        self._texts = [
            (self._check(["text", serial]), self._command(number, commands.AddText), self._scopes[_index(scope)])
            for serial, number, scope in state["texts"]
        ]
        self._others = [self._check(each) for each in state["others"]]
        self._rules, self._full = int(state["rules"]), bool(state["full"])

    def find(self, name: dict[str, Any], body: int | None = None) -> Callable[..., Any]:
        """The function that `LevelWriter.name_of` called so; of a rule, that which the body in a slot calls."""
        ((kind, row),) = name.items()
        if (body is None) != (kind in ("then", "rounds")):
            raise ValueError(f"{kind!r} in the wrong place")
        if kind == "then":
            return self._consequence(*row)
        if kind == "rounds":
            number, scope, times, count = row
            command = self._command(number, commands.Every)
            return Rounds(
                self.level, command, self._scopes[_index(scope)], None if times is None else int(times), int(count)
            )
        rule = self._tags.rules[_index(row)] if kind == "tagged" else self._rule(row)
        assert body is not None
        told = Told(rule, None)  # type: ignore[arg-type]  # whose it is, is known once there are bodies
        self._told.append((told, body))
        return told

    def put(self, things: Things) -> None:
        """Become what was saved. Everything that `things` gives must be there."""

        def thing(found: Reference) -> Any:
            return Gone() if found is None else things[found[0]](found[1])

        for scope, named, numbers in zip(self._scopes, self._things, self._numbers, strict=True):
            scope.things.maps[0].update({name: thing(found) for name, found in named.items()})
            scope.numbers.maps[0].update(numbers)
        for rule, second in self._seconds:
            rule.second = thing(second)
        for told, body in self._told:
            told.this = things["body"](body)
        level = self.level
        level._top = self._scopes[0]
        level._tags = self._tags
        self._tags.bodies = [thing(body) for body in self._bodies]
        level._answers.keys, level._answers.touches, level._answers.shakes = [], [], []
        for answer in self._answers:
            level._answers.add(answer)
        level._texts = [(thing(text), command, scope) for text, command, scope in self._texts]
        level._others = [thing(each) for each in self._others]
        level._rules, level._full = self._rules, self._full
        level.listen()

    def _earlier(self, number: int) -> Scope:
        """A scope that comes before the one that is being read: no scope is inside itself."""
        return self._scopes[_index(number)]

    def _check(self, found: Any) -> Reference:
        if found is None:
            return None
        kind, number = found
        if number not in self._known[kind]:
            raise ValueError(f"there is no {kind} {number!r}")
        return [kind, number]

    def _checked(self, things: dict[str, Any]) -> dict[str, Reference]:
        return {str(name): self._check(found) for name, found in things.items()}

    def _command(self, number: int, kind: type[C]) -> C:
        command = self._commands[_index(number)]
        if not isinstance(command, kind):
            raise ValueError(f"command {number} is no {kind.__name__}")
        return command

    def _consequence(self, number: int, scope: int) -> Consequence:
        command = self._commands[_index(number)]
        if not isinstance(command, commands.Waiting):
            raise ValueError(f"command {number} waits for nothing")
        return Consequence(self.level, command, self._scopes[_index(scope)])

    def _rule(self, row: list[Any]) -> Rule:
        event, tag, second, number, scope = row
        if event not in EVENTS or not (tag is None or isinstance(tag, str)):
            raise ValueError(f"no rule waits for {event!r}")
        rule = Rule(event, tag, None, self._consequence(number, scope))
        match second:
            case ["tag", str(word)]:
                rule.second = word
            case ["body", _]:
                self._seconds.append((rule, self._check(second)))
            case ["nobody"]:
                self._seconds.append((rule, None))
            case None:
                pass
            case _:
                raise ValueError("no second")
        return rule


def _index(number: Any) -> int:
    """A place in a list, never from its end."""
    if isinstance(number, bool) or not isinstance(number, int) or number < 0:
        raise ValueError(f"{number!r} is no number of anything")
    return number


def _read(source: str, file: str, folder: str) -> commands.LevelScript:
    found, errors = script.check(source, file)
    if errors:
        raise SaveError(f"this save is of a level that this version of the engine cannot read: {errors[0].headline}")
    return replace(found, folder=folder)
