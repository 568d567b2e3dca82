"""A level as Python (SPEC L3): a program that builds the same world through the engine's public face."""

from __future__ import annotations

from pathlib import PurePath

from evilengine.script.blocks import destroyed, is_deferred, used
from evilengine.script.python_fluids import PythonFluids
from evilengine.script.python_pictures import ANGLES
from evilengine.script.python_values import imports, literal, quoted
from evilengine.script.word import OPPOSITES
from evilengine.values import level as commands
from evilengine.values.level import Block, Called, Command, LevelScript, Number


def translate(level: LevelScript) -> str:
    """The text of a Python program that builds `level`; its `build(game)` fills a Game.

    >>> from evilengine import script
    >>> print(translate(script.read("new circle ball 0.5 at 0 3 physicsOn;", "ball.evil")))
    \"\"\"ball.evil as Python, made by `evil translate`.\"\"\"
    <BLANKLINE>
    import evilengine as evil
    <BLANKLINE>
    <BLANKLINE>
    def build(game):
        ball = game.add(evil.Circle(0.5), kind="dynamic", at=(0, 3))
    <BLANKLINE>
    <BLANKLINE>
    if __name__ == "__main__":
        game = evil.Game("ball")
        build(game)
        game.run()
    <BLANKLINE>
    """
    return Translator(level).program()


class Translator(PythonFluids):
    """One method for each command."""

    def program(self) -> str:
        with self._deeper():
            if self._tags:
                self._line("tags = Tags()")
            self._block(self._level.commands)
            body = self._lines or ["    pass"]
        title = PurePath(self._level.file).name
        stem = PurePath(self._level.file).stem
        text = "\n".join(body)
        lines = [f"{quoted(f'{title} as Python, made by `evil translate`.', 3)}", "", *imports(text), "", ""]
        lines += ["def build(game):", text, "", "", 'if __name__ == "__main__":']
        begin = ["    build(game)"]
        if any(isinstance(each, commands.Go) and not each.file for each in self._level.numbered):
            begin = [f"    game.scenes({quoted(stem)})(lambda: build(game))", f"    game.go({quoted(stem)})"]
        lines += [f"    game = evil.Game({quoted(stem)})", *begin, "    game.run()", ""]
        return "\n".join(lines)

    # Commands

    def _block(self, block: Block) -> None:
        for command in block:
            self._command(command)

    def _command(self, command: Command) -> None:
        match command:
            case commands.SetView(width=width, height=height):
                self._line(f"game.camera.fit({literal(width)}, {literal(height)})")
            case commands.SetGravity(gravity=gravity):
                self._line(f"game.world.gravity = {self.value(gravity)}")
            case commands.SetTilt(on=on):
                self._line(f"game.tilt = {on}")
            case _ if isinstance(command, commands.Picture):
                self._picture(command)
            case _ if isinstance(command, commands.Fluid):
                self._fluid(command)
            case commands.Go(file=file):
                self._line(f"game.go({quoted(file)})" if file else "game.restart()")
            case commands.SetPace(pace=pace):
                self._line(f"game.speed = {self.number(pace)}")
            case commands.Quake(strength=strength):
                self._line(f"game.camera.shake({self.number(strength)})")
            case commands.Follow(target=target):
                name = self.called(target.name)
                with self._if_alive(name):
                    self._line(f"game.camera.follow({name})")
            case commands.Split(targets=targets):
                names = [self.called(target.name) for target in targets]
                with self._if_alive(*names):
                    self._line(f"game.split({', '.join(names)})")
            case commands.SetSeed(seed=seed):
                self._line(f"game.random.seed({seed})")
            case commands.AddBody():
                self._add_body(command)
            case commands.AddCharacter() | commands.AddLadder() | commands.Drive() | commands.Tell():
                self._character(command)
            case commands.AddDrawing():
                arguments = [self.make(command.shape), *self.options(command.options)]
                self._call(self._naming(command.name), "game.draw", arguments)
            case commands.AddForce():
                self._add_force(command)
            case commands.AddJoint():
                self._add_joint(command)
            case commands.AddText():
                self._add_text(command)
            case commands.Let(name=name, value=value):
                number = self.number(value)
                self._line(f"{self._make_name(name)} = {number}")
            case commands.SetNumber(name=name, value=value):
                self._line(f"{self.called(name)} = {self.number(value)}")
            case commands.SetProperty():
                self._set(command)
            case commands.Destroy(target=target):
                name = self.called(target.name)
                with self._if_alive(name):
                    self._line(f"{name}.destroy()")
                self._sure[-1].discard(name)
            case commands.Impulse(target=target, impulse=impulse):
                name = self.called(target.name)
                with self._if_alive(name):
                    self._line(f"{name}.apply_impulse({self.value(impulse)})")
            case commands.PlaySound() | commands.PlayMusic():
                with self._if_alive(*(self.called(each.name) for each in used((command,)))):
                    self._line(self.sound(command))
            case _:
                self._structure(command)

    def _structure(self, command: Command) -> None:
        """Commands with blocks."""
        match command:
            case commands.OnMeeting():
                self._on_meeting(command)
            case commands.OnCharacter():
                self._on_character(command)
            case commands.OnTouch():
                self._on_touch(command)
            case commands.OnKey(key=key, block=block):
                first = f"if key == {quoted(key)}:"
                self._function(self._fresh(f"when_{key}"), "key", block, by="game.on_key_press", first=first)
            case commands.OnShake(block=block):
                self._function(self._fresh("when_shaken"), "", block, by="game.on_shake")
            case commands.After(seconds=seconds, block=block):
                name = self._fresh("later")
                self._function(name, "", block)
                self._line(f"game.timer.after({self.number(seconds)}, {name})")
            case commands.Every():
                self._every(command)
            case commands.Repeat():
                self._repeat(command)
            case commands.If(condition=condition, then=then, otherwise=otherwise):
                self._line(f"if {self.condition(condition)}:")
                sure = set(self._sure[-1])
                with self._deeper():
                    self._inner(then)
                if otherwise:
                    self._line("else:")
                    with self._deeper():
                        self._inner(otherwise)
                self._sure[-1] &= sure

    def _add_body(self, command: commands.AddBody) -> None:
        shapes = [self.make(each) for each in command.shapes]
        shape = shapes[0] if len(shapes) == 1 else f"[{', '.join(shapes)}]"
        arguments = [shape, *self.options(command.options)]
        self._add_tagged(command.name, "game.add", arguments, command.options)

    def _add_force(self, command: commands.AddForce) -> None:
        bodies = [self.called(each.name) for each in command.bodies]
        others = [self.called(each.value.name) for each in command.force.options if isinstance(each.value, Called)]
        force = self.make(command.force)
        name = self._make_name(command.name) if command.name else ""
        before = f"{name} = " if name else ""
        if not bodies:
            self._call(before, "game.world.add_force", [force])
            self._sure[-1].add(name)
            return
        if name and not {*bodies, *others} <= self._sure[-1]:
            self._line(f"{name} = None")
            self._maybe.add(name)
        if len(bodies) == 1:
            with self._if_alive(bodies[0], *others):
                self._call(before, f"{bodies[0]}.add_force", [force])
            return
        alive = self._fresh("alive")
        self._line(f"{alive} = [body for body in ({', '.join(bodies)}) if body.alive]")
        self._line(f"if {alive}:")
        with self._deeper():
            self._call(before, "game.world.add_force", [force, alive])

    def _add_joint(self, command: commands.AddJoint) -> None:
        ends = [self.called(each.name) for each in command.joint.arguments if isinstance(each, Called)]
        before = f"{self._make_name(command.name)} = " if command.name else ""
        if before and not {*ends} <= self._sure[-1]:
            self._line(f"{before}None")
            self._maybe.add(self.called(command.name))
        with self._if_alive(*ends):
            self._call(before, "game.world.add_joint", [self.make(command.joint)])

    def _add_text(self, command: commands.AddText) -> None:
        options = [self.option(each) for each in command.options]
        numbers = any(not isinstance(piece, str) for piece in command.pieces)
        words = self._words(command.pieces) if numbers else quoted("".join(map(str, command.pieces)))
        name = self._make_name(command.name) if command.name else self._fresh("text") if numbers else ""
        self._call(f"{name} = " if name else "", "game.text", [words, *options])
        if numbers:
            self._gap = True
            self._line("@game.on_draw")
            self._line(f"def {self._fresh(f'show_{name}')}():")
            with self._deeper():
                self._line(f"if {name}.alive:")
                with self._deeper():
                    self._line(f"{name}.text = {words}")
            self._gap = True
        if name:
            self._sure[-1].add(name)

    def _words(self, pieces: tuple[str | Number, ...]) -> str:
        shown = [
            quoted(each)[1:-1].replace("{", "{{").replace("}", "}}")
            if isinstance(each, str)
            else f"{{{self.number(each)}:.10g}}"
            for each in pieces
        ]
        return f'f"{"".join(shown)}"'

    def _set(self, command: commands.SetProperty) -> None:
        name, attribute = self.called(command.target.name), command.property
        in_radians = "ang" in attribute or attribute in ANGLES
        value = self.angle(command.value) if in_radians else self.value(command.value)
        if attribute in ("frame", "burst"):
            value = self.index(command.value)
        if command.part == "character":
            with self._as_character(name) as character:
                self._line(f"{character}.{attribute} = {value}")
            return
        with self._if_alive(name):
            if attribute == "tag" and self._tags:
                self._line(f"tags.change({name}, {value})")
                return
            if attribute in OPPOSITES:
                attribute, value = OPPOSITES[attribute], repr(not command.value)
            if command.part == "drawings":
                self._line(f"for drawing in {name}.drawings:")
                with self._deeper():
                    self._line(f"drawing.{attribute} = {value}")
            elif attribute == "burst":
                self._line(f"{name}.burst({value})")
            else:
                self._line(f"{name}.{attribute} = {value}")

    def _every(self, command: commands.Every) -> None:
        seconds, name = self.number(command.seconds), self._fresh("again")
        if command.times is None and not command.counter:
            self._function(name, "", command.block)
            self._line(f"game.timer.every({seconds}, {name})")
            return
        counter, event, times = self._fresh(command.counter or "count"), self._fresh("event"), ""
        if isinstance(command.times, float):
            times = literal(float(int(command.times)))
        elif command.times is not None:
            every, times = self._fresh("seconds"), self._fresh("times")
            self._line(f"{every}, {times} = {seconds}, int({self.number(command.times)})")
            seconds = every
        self._line(f"{counter} = 0")
        with self._scope(**{command.counter: counter} if command.counter else {}):
            self._counted_function(name, command.block, counter, f"if {counter} == {times}:" if times else "", event)
        self._line(f"{event} = game.timer.every({seconds}, {name})")

    def _counted_function(self, name: str, block: Block, counter: str, last: str, event: str) -> None:
        """The function of an `every` that counts its rounds; closures made in one keep the number of that round."""
        inner = self._fresh(f"{name}_round")
        with self._scope():
            self._function(inner, counter, block)
        self._gap = True
        self._line(f"def {name}():")
        with self._deeper():
            self._line(f"nonlocal {counter}")
            self._line(f"{counter} += 1")
            if last:
                self._line(last)
                with self._deeper():
                    self._line(f"{event}.cancel()")
            self._line(f"{inner}({counter})")
        self._gap = True

    def _repeat(self, command: commands.Repeat) -> None:
        counter = self._fresh(command.counter or "_")
        times = command.times
        last = f"{int(times) + 1}" if isinstance(times, float) else f"int({self.number(times)}) + 1"
        rounds = f"range(1, {last})"
        with self._scope(**{command.counter: counter} if command.counter else {}):
            if is_deferred(command.block):
                name = self._fresh("one_round")
                self._function(name, counter, command.block)
                self._line(f"for {counter} in {rounds}:")
                with self._deeper():
                    self._line(f"{name}({counter})")
            else:
                self._line(f"for {counter} in {rounds}:")
                self._sure.append(set())
                with self._deeper():
                    self._inner(command.block)
                self._sure.pop()
        self._sure[-1] -= {self.called(each) for each in destroyed(command.block)}
