"""Smoke and fire as Python."""

from __future__ import annotations

from evilengine.script.fluid_options import smoke_options, source_options
from evilengine.script.python_pictures import Code, PythonPictures, shown
from evilengine.values import level as commands


class PythonFluids(PythonPictures):
    """Writes commands about fluids."""

    def _fluid(self, command: commands.Fluid) -> None:
        said = {each.name: Code(self._written(each)) for each in command.options}
        match command:
            case commands.AddSmoke(area=area):
                options = [f"{name}={shown(value)}" for name, value in smoke_options(said).items()]
                self._call(self._naming(command.name), "game.add_smoke", [self.value(area), *options])
            case commands.AddSource():
                self._add_source(command, said)

    def _add_source(self, command: commands.AddSource, said: dict[str, Code]) -> None:
        options = [f"{name}={shown(value)}" for name, value in source_options(said).items()]
        shape = [f"evil.Rectangle({said['wide']}, {said['tall']})"] if "wide" in said else []
        idle = "running" in said
        name = self._make_name(command.name or "source") if command.name or idle else ""
        before = f"{name} = " if name else ""
        needed = [self.called(command.smoke.name), *([str(said["body"])] if "body" in said else [])]
        if command.name and not {*needed} <= self._sure[-1]:
            self._line(f"{before}None")
            self._maybe.add(name)
        elif name:
            self._sure[-1].add(name)
        with self._if_alive(*needed):
            self._call(before, f"{needed[0]}.add_source", [*shape, *options])
            if idle:
                self._line(f"{name}.running = False")
