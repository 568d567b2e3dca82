"""Smoke, fire and water as Python."""

from __future__ import annotations

from evilengine.script.fluid_options import box_options, flow_options
from evilengine.script.python_pictures import Code, PythonPictures, shown
from evilengine.values import level as commands
from evilengine.values.level import Called


class PythonFluids(PythonPictures):
    """Writes commands about fluids."""

    def _fluid(self, command: commands.Fluid) -> None:
        said = {each.name: Code(self._written(each)) for each in command.options}
        match command:
            case commands.AddSmoke(area=area) | commands.AddWater(area=area):
                add = "game.add_smoke" if isinstance(command, commands.AddSmoke) else "game.add_water"
                self._call(self._naming(command.name), add, [self.value(area), *_keywords(box_options(said))])
            case commands.AddSource(smoke=smoke):
                shape = [f"evil.Rectangle({said['wide']}, {said['tall']})"] if "wide" in said else []
                self._begin(command, smoke, "add_source", shape, said, "source")
            case commands.AddLiquid(water=water):
                self._made_if_alive(command.name, self._needed(water, command), f"{self.called(water.name)}.add_liquid",
                                    _keywords(said))  # fmt: skip
            case commands.FillWater(water=water, shape=shape):
                with self._if_alive(*self._needed(water, command)):
                    self._call("", f"{self.called(water.name)}.fill", [self.make(shape), *_keywords(said)])
            case commands.AddStream(water=water, shape=None):
                self._begin(command, water, "pour", [], said, "stream")
            case commands.AddStream(water=water, shape=shape):
                self._begin(command, water, "drain", [self.make(shape)] if shape else [], said, "drain")

    def _begin(
        self, command: commands.AddSource | commands.AddStream, fluid: Called, call: str, shape: list[str],
        said: dict[str, Code], usual: str,
    ) -> None:  # fmt: skip
        """What flows from now on, or does not yet."""
        idle = [".running = False"] if "running" in said else []
        name = command.name or (usual if idle else "")
        arguments = [*shape, *_keywords(flow_options(said))]
        self._made_if_alive(name, self._needed(fluid, command), f"{self.called(fluid.name)}.{call}", arguments, idle)

    def _needed(self, fluid: Called, command: commands.Fluid) -> list[str]:
        """What must be there: the fluid, and what its options speak of."""
        others = [each.value for each in command.options if isinstance(each.value, Called)]
        return [self.called(each.name) for each in (fluid, *others)]

    def _made_if_alive(
        self, name: str, needed: list[str], function: str, arguments: list[str], after: list[str] | None = None
    ) -> None:
        """Something with a name, if what it needs is there; else its name is None."""
        made = self._make_name(name) if name else ""
        before = f"{made} = " if made else ""
        if made and not {*needed} <= self._sure[-1]:
            self._line(f"{before}None")
            self._maybe.add(made)
        elif made:
            self._sure[-1].add(made)
        with self._if_alive(*needed):
            self._call(before, function, arguments)
            for each in after or ():
                self._line(f"{made}{each}")


def _keywords(options: dict[str, Code]) -> list[str]:
    return [f"{name}={shown(value)}" for name, value in options.items()]
