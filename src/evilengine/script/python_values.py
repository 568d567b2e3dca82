"""The values in commands as Python expressions."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod

from evilengine.values.level import (
    Area,
    Called,
    Colours,
    Corners,
    Formula,
    Holes,
    Make,
    Name,
    Number,
    Numbers,
    Option,
    Pair,
    PlayMusic,
    PlaySound,
    Value,
)
from evilengine.values.sheet import ALL_FRAMES

_OPERATORS = {
    "less": ("<", 1), "more": (">", 1), "at_most": ("<=", 1), "at_least": (">=", 1), "equal": ("==", 1),
    "unequal": ("!=", 1), "add": ("+", 2), "subtract": ("-", 2), "multiply": ("*", 3), "divide": ("/", 3),
    "remainder": ("%", 3),
}  # fmt: skip
_CALLS = {
    "abs": "abs", "min": "min", "max": "max", "sqrt": "math.sqrt", "floor": "math.floor", "radians": "math.radians",
    "sin": "sine", "cos": "cosine", "random": "game.random.uniform",
}  # fmt: skip


class PythonValues(ABC):
    """Writes values; whoever writes the commands knows what Python calls things."""

    @abstractmethod
    def called(self, name: str) -> str:
        """The Python name of what a level calls `name`."""

    def number(self, number: Number, tightness: int = 0) -> str:
        """A number; in parentheses if what is round it binds more tightly."""
        match number:
            case Name(name):
                return self.called(name)
            case Formula():
                return self.formula(number, tightness)
            case _:
                return literal(number)

    def formula(self, formula: Formula, tightness: int) -> str:
        function, arguments = formula.function, formula.arguments
        if function in _OPERATORS:
            sign, own = _OPERATORS[function]
            left = self.number(arguments[0], own + (own == 1))
            text = f"{left} {sign} {self.number(arguments[1], own + 1)}"
            return f"({text})" if own < tightness else text
        match function:
            case "and" | "or":
                return f"bool({self.condition(formula)})"
            case "not":
                return f"({self.condition(formula)})"
            case "negate":
                return f"(-{self.number(arguments[0], 4)})" if tightness else f"-{self.number(arguments[0], 4)}"
            case "round":
                return f"math.floor({self.number(arguments[0], 2)} + 0.5)"
            case _:
                return f"{_CALLS[function]}({', '.join(self.number(each) for each in arguments)})"

    def condition(self, number: Number) -> str:
        """A number of which only matters whether it is 0."""
        if isinstance(number, Formula):
            parts = [f"({self.condition(each)})" if _joins(each) else self.condition(each) for each in number.arguments]
            if number.function in ("and", "or"):
                return f"{parts[0]} {number.function} {parts[1]}"
            if number.function == "not":
                return f"not {parts[0]}"
        return self.number(number)

    def value(self, value: Value) -> str:
        match value:
            case Pair(x, y):
                return f"({self.number(x)}, {self.number(y)})"
            case Numbers(parts):
                return f"({', '.join(map(self.number, parts))})"
            case Corners(points):
                return f"[{', '.join(self.value(point) for point in points)}]"
            case Holes(rings):
                return f"[{', '.join(self.value(ring) for ring in rings)}]"
            case Colours(names):
                return f"[{', '.join(map(quoted, names))}]"
            case Area():
                edges = (value.left, value.bottom, value.right, value.top)
                return f"({', '.join(self.number(edge) for edge in edges)})"
            case Called(name):
                return self.called(name)
            case bool() | int():
                return repr(value)
            case str():
                return quoted(value)
            case _:
                return self.number(value)

    def options(self, options: tuple[Option, ...]) -> list[str]:
        """How a thing is made and looks, as keyword arguments; frames make a sheet of its texture."""
        said = {option.name: option.value for option in options}
        frames = said.get("frames")
        if not isinstance(frames, Pair):
            return [self.option(option) for option in options]
        assert isinstance(frames.x, float)
        assert isinstance(frames.y, float)
        columns, rows, name = int(frames.x), int(frames.y), quoted(ALL_FRAMES)
        fps = f"fps={self.value(said['fps'])}, " if "fps" in said else ""
        shown = f"[{self.index(said['frame'])}]" if "frame" in said else f"range({columns * rows})"
        if "course" in said:
            shown = f"evil.Animation({shown}, course={self.value(said['course'])})"
        animations = f"animations={{{name}: {shown}}}"
        sheet = f"evil.Sheet({self.value(said['texture'])}, {columns}, {rows}, {fps}{animations})"
        of_sheet = ("texture", "frames", "fps", "frame", "course")
        rest = [self.option(option) for option in options if option.name not in of_sheet]
        return [*rest, f"texture={sheet}", f"animation={name}"]

    def index(self, value: Value) -> str:
        """A whole number, which a fraction is cut off from."""
        text = self.value(value)
        return text if isinstance(value, float) else f"int({text})"

    def option(self, option: Option) -> str:
        if option.name == "hidden":
            return "visible=False"
        if option.name in ("angle", "angular_velocity", "max_slope"):
            return f"{option.name}={self.angle(option.value)}"
        return f"{option.name}={self.value(option.value)}"

    def sound(self, command: PlaySound | PlayMusic) -> str:
        what = "play" if isinstance(command, PlaySound) else "music"
        file = quoted(command.file) if command.file else "None"
        return f"game.audio.{what}({', '.join([file, *map(self.option, command.options)])})"

    def angle(self, value: Value) -> str:
        """Radians, as the degrees that were written if that is exact."""
        if isinstance(value, float) and value:
            degrees = round(math.degrees(value), 9)
            if math.radians(degrees) == value:
                return f"math.radians({literal(degrees)})"
        return self.value(value)

    def make(self, make: Make) -> str:
        arguments = [self.value(each) for each in make.arguments]
        return f"evil.{make.type}({', '.join([*arguments, *(self.option(each) for each in make.options)])})"


def imports(text: str) -> list[str]:
    """The import lines that a program with this text needs."""
    lines = ["import math", ""] if "math." in text else []
    lines.append("import evilengine as evil")
    angles = [name for name in ("cosine", "sine") if f"{name}(" in text]
    if angles:
        lines.append(f"from evilengine.script.arithmetic import {', '.join(angles)}")
    tags = [name for name, use in (("Tags", "Tags()"), ("when_met", "when_met(")) if use in text]
    if tags:
        lines.append(f"from evilengine.script.tags import {', '.join(tags)}")
    return lines


def literal(value: float) -> str:
    """A number as Python: without a point if it is whole."""
    negative_zero = value == 0.0 and math.copysign(1.0, value) < 0.0
    return repr(value) if negative_zero or value != int(value) or abs(value) >= 1e15 else str(int(value))


def quoted(text: str, quotes: int = 1) -> str:
    """A text as Python, in double quotes."""
    mark = '"' * quotes
    return mark + "".join(_escaped(letter) for letter in text) + mark


def _escaped(letter: str) -> str:
    if letter in '"\\':
        return "\\" + letter
    return letter if letter.isprintable() else letter.encode("unicode_escape").decode("ascii")


def _joins(number: Number) -> bool:
    return isinstance(number, Formula) and number.function in ("and", "or", "not")
