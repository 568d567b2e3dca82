"""How the picture looks, as Python: backgrounds, layers, the post pass, particles."""

from __future__ import annotations

from evilengine.script.air_options import emitter_options
from evilengine.script.python_meetings import PythonMeetings
from evilengine.script.python_values import quoted
from evilengine.values import level as commands

ANGLES = frozenset({"direction", "cone", "spin", "angle"})
"""What counts in radians."""


class Code(str):
    """Python as it is to be written."""


class PythonPictures(PythonMeetings):
    """Writes commands about how the picture looks."""

    def _picture(self, command: commands.Picture) -> None:
        if isinstance(command, commands.SetAmbient):
            self._line(f"game.ambient = {self.value(command.strength)}")
            return
        if isinstance(command, commands.SetShadows):
            self._line(f"game.lights.shadows = {command.on}")
            return
        said = {each.name: Code(self._written(each)) for each in command.options}
        match command:
            case commands.SetBackground(what=what):
                arguments = [quoted(what), *(f"{name}={value}" for name, value in said.items())]
                self._call("", "game.add_background", arguments)
            case commands.SetPlane(layer=layer):
                if "fog_above" in said:
                    above = said.pop("fog_above")
                    said["fog"] = Code(f"[{said.get('fog', above)}, {above}]")
                if "hidden" in said:
                    said["visible"] = Code(str(said.pop("hidden") == "False"))
                for name, value in said.items():
                    self._line(f"game.layers[{layer}].{name} = {value}")
            case commands.SetLens():
                if "filmic" in said:
                    said["tone_mapping"] = Code(quoted("filmic" if said.pop("filmic") == "True" else "plain"))
                for name in ("perspective", "distance"):
                    if name in said:
                        self._line(f"game.layers.{name} = {said.pop(name)}")
                for name, value in said.items():
                    self._line(f"game.post.{name} = {value}")
            case commands.SetCamera():
                self._camera(said)
            case commands.AddLight(name=name):
                if "direction" in said:
                    said["direction"] = Code(f"evil.Vec2(1, 0).turned({said['direction']})")
                said |= {name: Code("False") for name in ("shadows", "on") if name in said}
                if not said.keys() & {"at", "direction", "body"}:
                    said["at"] = Code("(0, 0)")
                with self._if_alive(*([said["body"]] if "body" in said else [])):
                    self._call(self._naming(name), "game.add_light", [f"{key}={value}" for key, value in said.items()])
            case commands.AddParticles(name=name):
                options = emitter_options(said)
                body = [str(options["body"])] if "body" in options else []
                with self._if_alive(*body):
                    arguments = [f"{key}={shown(value)}" for key, value in options.items()]
                    self._call(self._naming(name), "game.add_particles", arguments)

    def _camera(self, said: dict[str, Code]) -> None:
        following = [f"{name}={said.pop(name)}" for name in ("dead_zone", "smoothing", "offset") if name in said]
        if "target" in said:
            target = said.pop("target")
            with self._if_alive(target):
                self._call("", "game.camera.follow", [target, *following])
        if "low" in said:
            low, high = said.pop("low")[1:-1], said.pop("high")[1:-1]
            self._line(f"game.camera.bounds = ({low}, {high})")
        if "seconds" in said:
            self._call("", "game.camera.glide", [f"{name}={value}" for name, value in said.items()])
            return
        for name, value in said.items():
            self._line(f"game.camera.{name} = {value}")

    def _written(self, option: commands.Option) -> str:
        if option.name == "burst":
            return self.index(option.value)
        return self.angle(option.value) if option.name in ANGLES else self.value(option.value)


def shown(value: object) -> str:
    """A value as Python; code as it is."""
    match value:
        case Code():
            return str(value)
        case str():
            return quoted(value)
        case list():
            return f"[{', '.join(map(shown, value))}]"
        case tuple():
            return f"({', '.join(map(shown, value))})"
    return repr(value)
