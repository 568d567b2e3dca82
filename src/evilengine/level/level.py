"""Levels: the commands of a level script, carried out on a game, or on a world alone.

>>> from evilengine import script
>>> world = evil.World()
>>> level = build(script.read("new circle ball 0.5 at 0 3 physicsOn;"), world)
>>> level["ball"].position
Vec2(0.0, 3.0)
"""

from __future__ import annotations

import logging
import random
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from evilengine import script
from evilengine.level import air, characters, fluids
from evilengine.level.looks import LOOKS, drawn, move_camera, written
from evilengine.level.making import Values
from evilengine.level.rules import Answers, Consequence, Made, Rounds, Scope
from evilengine.script.arithmetic import ArithmeticProblem
from evilengine.script.tags import Rule, Tags
from evilengine.script.word import MAX_BODIES, MAX_ROUNDS, OPPOSITES
from evilengine.values import level as commands
from evilengine.values.diagnostics import level_error
from evilengine.values.errors import ArgumentError, Error, LevelError
from evilengine.values.level import Block, Called, LevelScript, Number, Tagged
from evilengine.world.body import Body
from evilengine.world.liquid import Liquid
from evilengine.world.world import World

if TYPE_CHECKING:
    from evilengine.game import Game
    from evilengine.scene import Text
    from evilengine.timer import Event
    from evilengine.values.callbacks import Callbacks


def load(game: Game, path: str | Path) -> Level:
    """Build the level at `path` into `game`. Raises LevelError with all its errors, AssetError if it cannot be read."""
    return build(script.read_file(path), game)


def build(level: LevelScript, target: Game | World) -> Level:
    """Carry out the commands of `level` on a game; or on a world alone, which has no timer, keys, texts or looks.

    Raises LevelError if one of them cannot be carried out; what the ones before it made is gone then.
    """
    return Level(level, target)


_FOR_GOOD = commands.Rule | commands.AddLadder
_COUNTED = (
    _FOR_GOOD
    | commands.AddForce
    | commands.AddJoint
    | commands.AddDrawing
    | commands.AddText
    | commands.After
    | commands.Every
)


class Level(Values):
    """A level at play. `level["ball"]` is what it calls ball, and `in` asks whether that is there."""

    def __init__(self, level: LevelScript, target: Game | World, *, built: bool = False) -> None:
        self.script = level
        self.game: Game | None = None if isinstance(target, World) else target
        self.world: World = target if isinstance(target, World) else target.world
        self._random = self.game.random if self.game is not None else random.Random(0)
        self._tags = Tags()
        self._answers = Answers()
        self._texts: list[tuple[Text, commands.AddText, Scope]] = []
        self._top = Scope()
        self._undo: list[Callable[[], object]] | None = []
        """What takes back what was done so far; None once the level is built."""
        self._others: list[Any] = []
        """Forces, texts, drawings and events in waiting, for counting them."""
        self._rules = 0
        self._full = False
        if not built:  # else a saved game says what there is
            self._build()
        self._undo = None

    def _build(self) -> None:
        try:
            self.listen()
            self._block(self.script.commands, self._top)
        except BaseException:
            for each in reversed(self._undo or ()):
                each()
            raise

    def listen(self) -> None:
        """Be told what the player does and when a picture is drawn; once is enough."""
        if self.game is not None and self not in self.game.levels:
            self.game._note_settings()
            self.game.levels.append(self)
            self._on_failure(self.ignore)
            for callbacks, function in self._listeners(self.game):
                callbacks(function)

    def ignore(self) -> None:
        """Do nothing more of what the player asks for."""
        if self.game is not None and self in self.game.levels:
            self.game.levels.remove(self)
            for callbacks, function in self._listeners(self.game):
                callbacks.remove(function)

    @property
    def listening(self) -> tuple[Callable[..., object], ...]:
        """The functions of this level that its game calls."""
        return () if self.game is None else tuple(function for _, function in self._listeners(self.game))

    def _listeners(self, game: Game) -> tuple[tuple[Callbacks[...], Callable[..., object]], ...]:
        answers = self._answers
        return (
            (game.on_key_press, answers.pressed), (game.on_touch, answers.touched), (game.on_shake, answers.shaken),
            (game.on_draw, self._refresh),
        )  # fmt: skip

    def __getitem__(self, name: str) -> Any:
        """The body, force or text of that name. Raises KeyError if there is none, or if it is gone."""
        thing = self._top.things[name]
        if not thing.alive:
            raise KeyError(name)
        return thing

    def __contains__(self, name: object) -> bool:
        return name in self._top.things and self._top.things[str(name)].alive

    def _on_failure(self, undo: Callable[[], object]) -> None:
        if self._undo is not None:
            self._undo.append(undo)

    # Blocks

    def _block(self, block: Block, scope: Scope) -> None:
        for command in block:
            if isinstance(command, _COUNTED) and not self._has_room(command):
                continue
            try:
                self._carry_out(command, scope)
            except LevelError:
                raise
            except ArithmeticProblem as problem:
                raise self._refused("no-result", problem.message, problem.place) from None
            except Error as error:
                raise self._refused("refused", str(error), command.place) from error

    def _refused(self, code: str, message: str, place: commands.Place) -> LevelError:
        return level_error((self.script.diagnostic(code, message, place),))

    def _inside(self, block: Block, scope: Scope) -> None:
        """Carry out a block in a scope of its own."""
        self._block(block, Scope(scope))

    def _carry_out(self, command: commands.Command, scope: Scope) -> None:
        match command:
            case commands.AddBody():
                self._add_body(command, scope)
            case commands.AddForce():
                self._add_force(command, scope)
            case commands.AddJoint():
                self._add_joint(command, scope)
            case commands.SetGravity(gravity=gravity):
                before, self.world.gravity = self.world.gravity, self._pair(gravity, scope)
                self._on_failure(lambda: setattr(self.world, "gravity", before))
            case commands.Let(name=name, value=value):
                scope.numbers[name] = self._number(value, scope)
            case commands.SetNumber(name=name, value=value):
                scope.change(name, self._number(value, scope))
            case commands.SetProperty():
                self._set(command, scope)
            case commands.Destroy(target=target):
                thing = self._thing(target, scope)
                if thing is not None and not isinstance(thing, Liquid):
                    thing.destroy()
            case commands.Impulse(target=target, impulse=impulse):
                body = self._thing(target, scope)
                if isinstance(body, Body):
                    body.apply_impulse(self._pair(impulse, scope))
            case commands.Repeat():
                self._repeat(command, scope)
            case commands.If(condition=condition, then=then, otherwise=otherwise):
                self._inside(then if self._number(condition, scope) else otherwise, scope)
            case commands.OnMeeting():
                self._on_meeting(command, scope)
            case commands.OnCharacter(event=event, first=first):
                self._rule(event, first, None, Consequence(self, command, scope))
            case commands.OnTouch(first=first) if first is not None:
                self._rule("on_touch", first, None, Consequence(self, command, scope))
            case commands.AddCharacter() | commands.AddLadder() | commands.Tell() | commands.Drive():
                characters.carry_out(self, command, scope)
            case _ if isinstance(command, commands.Fluid):
                fluids.carry_out(self, command, scope)
            case _:
                if self.game is not None:
                    self._play(command, scope, self.game)

    def _play(self, command: commands.Command, scope: Scope, game: Game) -> None:
        """Commands that a world alone has no use for."""
        match command:
            case commands.SetView(width=width, height=height):
                game.camera.fit(width, height)
            case commands.SetTilt(on=on):
                game.tilt = on
            case _ if isinstance(command, commands.Picture):
                air.carry_out(self, command, scope, game)
            case commands.SetSeed(seed=seed):
                game.random.seed(seed)
            case commands.Go(file=file):
                self._go(file, game)
            case commands.SetPace(pace=pace):
                game.speed = self._number(pace, scope)
            case commands.Quake() | commands.Follow() | commands.Split():
                move_camera(self, command, scope, game)
            case commands.AddDrawing():
                self._add_drawing(command, scope, game)
            case commands.AddText():
                self._add_text(command, scope, game)
            case commands.PlaySound() | commands.PlayMusic():
                self._sound(command, scope, game)
            case commands.After(seconds=seconds):
                self._plan(game.timer.after(self._number(seconds, scope), Consequence(self, command, scope)))
            case commands.Every():
                self._every(command, scope, game)
            case commands.OnKey() | commands.OnShake() | commands.OnTouch():
                self._answers.add(Consequence(self, command, scope))

    # Making and changing

    def _add_body(self, command: commands.AddBody, scope: Scope) -> None:
        shapes = [self._made(each, scope) for each in command.shapes]
        options = self._looks(command.options, scope)
        if self._is_full():
            return
        shape = shapes[0] if len(shapes) == 1 else shapes
        add = self.world.add if self.game is None else self.game.add
        self._made_body(add(shape, **options), command.name, scope)

    def _made_body(self, body: Body, name: str, scope: Scope) -> None:
        self._made_thing(body, name, scope)
        self._tags.add(body)

    def _is_full(self) -> bool:
        if len(self.world.bodies) < MAX_BODIES:
            return False
        self._enough()
        return True

    def _enough(self) -> None:
        if not self._full:
            self._full = True
            logging.getLogger(__name__).warning(
                "%s: there are %d things; no more are made", self.script.file, MAX_BODIES
            )

    def _has_room(self, command: commands.Command) -> bool:
        """Whether one more of what is counted may be; a level that makes them for ever stays playable."""
        if isinstance(command, _FOR_GOOD):
            self._rules += 1
        if len(self._others) >= MAX_BODIES:
            self._others = [each for each in self._others if each.alive]
        if len(self._others) < MAX_BODIES and self._rules <= MAX_BODIES:
            return True
        self._enough()
        return False

    def _made_thing(self, thing: Made, name: str, scope: Scope) -> None:
        self._on_failure(lambda: thing.alive and thing.destroy())
        if not isinstance(thing, Body):
            self._others.append(thing)
        if name:
            scope.things[name] = thing

    def _add_force(self, command: commands.AddForce, scope: Scope) -> None:
        bodies = [body for body in (self._thing(each, scope) for each in command.bodies) if isinstance(body, Body)]
        other_ends = [each.value for each in command.force.options if isinstance(each.value, Called)]
        if (command.bodies and not bodies) or any(self._thing(each, scope) is None for each in other_ends):
            return  # what it would act on is gone
        force = self.world.add_force(self._made(command.force, scope), bodies or None)
        self._made_thing(force, command.name, scope)

    def _add_joint(self, command: commands.AddJoint, scope: Scope) -> None:
        ends = [self._thing(each, scope) for each in command.joint.arguments if isinstance(each, Called)]
        if all(isinstance(each, Body) for each in ends) and len(set(ends)) == 2:  # else one is gone
            self._made_thing(self.world.add_joint(self._made(command.joint, scope)), command.name, scope)

    def _add_drawing(self, command: commands.AddDrawing, scope: Scope, game: Game) -> None:
        shape = self._made(command.shape, scope)
        self._made_thing(game.draw(shape, **self._looks(command.options, scope)), command.name, scope)

    def _looks(self, options: tuple[commands.Option, ...], scope: Scope) -> dict[str, Any]:
        """Options for a game, which asks what is visible rather than what is hidden; a world alone has no looks."""
        values = {each.name: self._value(each.value, scope) for each in options}
        if self.game is None:
            return {name: value for name, value in values.items() if name not in LOOKS}
        return drawn(values, self._beside)

    def _beside(self, name: str) -> str:
        """A file that lies beside the level, by the name that the game finds it by in its own folder."""
        if self.game is None or not self.script.folder:
            return name
        beside, folder = Path(self.script.folder, name).resolve(), self.game.folder.resolve()
        return (beside.relative_to(folder) if beside.is_relative_to(folder) else beside).as_posix()

    def _sound(self, command: commands.PlaySound | commands.PlayMusic, scope: Scope, game: Game) -> None:
        options = {each.name: self._value(each.value, scope) for each in command.options}
        if options.get("at", True) is None:
            return  # what it would be heard from is gone
        if isinstance(command, commands.PlaySound):
            sound = game.audio.play(self._beside(command.file), **options)
            self._on_failure(lambda: sound.alive and sound.stop())
        else:
            game.audio.music(self._beside(command.file) if command.file else None, **options)
            self._on_failure(lambda: game.audio.music(None))

    def _go(self, file: str, game: Game) -> None:
        if file:
            game.go(self._beside(file))
        else:
            game.restart()

    def _add_text(self, command: commands.AddText, scope: Scope, game: Game) -> None:
        words = self._words(command.pieces, scope)
        options = {each.name: self._value(each.value, scope) for each in command.options}
        text = game.text(words, **written(options, self._beside))
        self._made_thing(text, command.name, scope)
        if any(not isinstance(piece, str) for piece in command.pieces):
            self._texts.append((text, command, scope))

    def _words(self, pieces: tuple[str | Number, ...], scope: Scope) -> str:
        shown = [each if isinstance(each, str) else f"{self._number(each, scope):.10g}" for each in pieces]
        return "".join(shown)

    def _refresh(self) -> None:
        """Show the present numbers in the texts that have some."""
        self._texts = [each for each in self._texts if each[0].alive]
        for text, command, scope in self._texts:
            text.text = self._words(command.pieces, scope)

    def _set(self, command: commands.SetProperty, scope: Scope) -> None:
        thing: Any = self._thing(command.target, scope)
        if thing is None:
            return
        value = self._value(command.value, scope)
        if command.property == "tag":
            self._tags.change(thing, value)
            return
        if command.property in ("texture", "font"):
            value = self._beside(value)
        if command.property in ("frame", "burst"):
            value = int(value)
        if command.property == "burst":
            thing.burst(value)
            return
        attribute = command.property
        if attribute in OPPOSITES:
            attribute, value = OPPOSITES[attribute], not value
        for each in self._parts(thing, command.part):
            setattr(each, attribute, value)

    def _parts(self, thing: Any, part: str) -> tuple[Any, ...]:
        """What of a thing a property is of; nothing, where there is none."""
        if part == "drawings":
            return tuple(getattr(thing, "drawings", ()))
        return characters.those(self.world, (thing,)) if part == "character" else (thing,)

    # Rounds and events

    def _repeat(self, command: commands.Repeat, scope: Scope) -> None:
        rounds = int(self._number(command.times, scope))
        if rounds > MAX_ROUNDS:
            raise ArgumentError(f"repeat {rounds}: at most {MAX_ROUNDS} rounds are allowed")
        for count in range(1, rounds + 1):
            inner = Scope(scope)
            if command.counter:
                inner.numbers[command.counter] = float(count)
            self._block(command.block, inner)

    def _every(self, command: commands.Every, scope: Scope, game: Game) -> None:
        seconds = self._number(command.seconds, scope)
        times = None if command.times is None else int(self._number(command.times, scope))
        rounds = Rounds(self, command, scope, times)
        rounds.event = self._plan(game.timer.every(seconds, rounds))

    def _plan(self, event: Event) -> Event:
        self._others.append(event)
        self._on_failure(event.cancel)
        return event

    def _on_meeting(self, command: commands.OnMeeting, scope: Scope) -> None:
        second: Body | str | None = None
        if isinstance(command.second, Tagged):
            second = command.second.tag
        elif command.second is not None:
            thing = self._thing(command.second, scope)
            if not isinstance(thing, Body):
                return  # nothing will ever meet what is gone
            second = thing
        self._rule(command.event, command.first, second, Consequence(self, command, scope))

    def _rule(self, event: str, first: commands.Target, second: Body | str | None, then: Consequence) -> None:
        if isinstance(first, Tagged):
            self._tags.on(Rule(event, first.tag, second, then))
            return
        body = self._thing(first, then.scope)
        if isinstance(body, Body):
            Rule(event, None, second, then).watch(body)
