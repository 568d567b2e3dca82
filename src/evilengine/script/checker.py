"""What a level's parts must be: numbers within their ranges, names that are known, colours, files, corners.

Each check notes an error at the place of what is wrong and gives back something usable, so that checking goes on.
"""

from __future__ import annotations

import math
import os
import re
from collections.abc import Mapping
from itertools import pairwise
from pathlib import Path, PurePosixPath

from evilengine import _core
from evilengine.script.arithmetic import ArithmeticProblem, bounds, formula
from evilengine.script.expressions import cut
from evilengine.script.lexer import Source
from evilengine.script.names import NUMBER, SOMETHING, Made, Names, reserved
from evilengine.script.settings import one_of
from evilengine.script.syntax import Expression, Identifier, Level, Literal, Operation, Reference, Spot, Text
from evilengine.script.word import ANY, MEASURES, UNITS, Kind, Range, plain
from evilengine.script.words import EVENT_NAMES, near, some
from evilengine.values.colour import NAMES as COLOURS
from evilengine.values.colour import to_colour
from evilengine.values.errors import ArgumentError
from evilengine.values.events import KEY_NAMES
from evilengine.values.level import Name, Number, Pair, Place
from evilengine.world.shapes import MIN_SIZE

LARGEST = 1e9  # of any number in a level, so that no arithmetic on it overflows
_PLAIN = ""
_KEY_MEANT = {
    "spacebar": "space", "return": "enter", "esc": "escape", "arrowup": "up", "arrowdown": "down", "arrowleft": "left",
    "arrowright": "right", "shift": "left_shift", "ctrl": "left_ctrl", "control": "left_ctrl", "alt": "left_alt",
    " ": "space", "pageup": "page_up", "pagedown": "page_down",
}  # fmt: skip
_PIECE = re.compile(r"\{\{|\}\}|\{([^{}]*)\}|[{}]")


class Checker:
    """The checks, with the names that are known so far."""

    def __init__(self, source: Source, level: Level, folder: str, lost: frozenset[str]) -> None:
        self.source = source
        self.folder = folder
        self.names = Names(level.statements)
        self.first = level.statements[0] if level.statements else None
        self._lost = set(lost)
        self._unbalanced = any(error.code in ("missing-brace", "odd-brace") for error in source.diagnostics)
        """Whether nobody can tell where blocks end, and so which names are known where."""
        self.uncertain = 0
        """More than 0 inside an `if`, whose condition may rule out what its bounds allow."""

    def error(self, code: str, message: str, place: Place, suggestion: str = "") -> None:
        self.source.error(code, message, place, suggestion)

    # Numbers

    def number(self, expression: Expression, what: str, allowed: Range = ANY, measure: str = _PLAIN) -> Number:
        """`expression` as a number that is `what`, within `allowed`, counted in the measure's unit."""
        place = place_of(expression)
        value, found = self._arithmetic(expression)
        if found not in (_PLAIN, measure):
            wanted = f"is in {MEASURES[measure]}" if measure else "has no unit"
            self.error("wrong-unit", f"{what} {wanted}, but this is in {MEASURES[found]}", place, self._units(measure))
            return value
        self._within(value, what, allowed, place)
        return value

    def _units(self, measure: str) -> str:
        units = [name for name, unit in UNITS.items() if unit.dimension == measure]
        return (
            f"its units are {', '.join(units)}; without one it is in {MEASURES[measure]}"
            if units
            else "leave the unit out"
        )

    def _within(self, value: Number, what: str, allowed: Range, place: Place) -> None:
        limits = Range(
            least=-LARGEST if allowed.least is None and allowed.above is None else allowed.least,
            most=LARGEST if allowed.most is None else allowed.most,
            above=allowed.above,
        )
        if isinstance(value, float):
            if not limits.holds(value):
                hint = f"{what} is {allowed}" if allowed != ANY else "numbers stay between -1000000000 and 1000000000"
                self.error("out-of-range", f"{what} cannot be {plain(value)}", place, hint)
            return
        if self.uncertain:
            return
        known = bounds(value, self.names.numbers, set())
        if not known.exact:
            return
        for reached in (known.low, known.high):
            if not limits.holds(reached):
                self.error("out-of-range", f"{what} can become {plain(reached)} here", place, f"{what} is {allowed}")
                return

    def whole(self, expression: Expression, what: str, allowed: Range) -> int:
        """A whole number that is known beforehand."""
        value = self.number(expression, what, allowed)
        if not isinstance(value, float):
            self.error(
                "not-fixed", f"{what} cannot change while the level plays", place_of(expression), "write one number"
            )
            return 0
        if value != int(value):
            self.error("not-whole", f"{what} is a whole number", place_of(expression), f"write {round(value)}")
        return int(value)

    def fixed(self, expression: Expression, what: str, allowed: Range, measure: str = _PLAIN) -> float:
        """A number that is known beforehand."""
        value = self.number(expression, what, allowed, measure)
        if isinstance(value, float):
            return value
        self.error("not-fixed", f"{what} cannot change while the level plays", place_of(expression), "write one number")
        return 1.0

    def pair(self, spot: Spot, what: str, allowed: Range = ANY, measure: str = _PLAIN) -> Pair:
        return Pair(
            self.number(spot.x, f"the x of {what}", allowed, measure),
            self.number(spot.y, f"the y of {what}", allowed, measure),
        )

    def _arithmetic(self, expression: Expression) -> tuple[Number, str]:
        """The number and what it measures ("" for nothing in particular), in the measure's base unit."""
        if isinstance(expression, Literal):
            unit = UNITS.get(expression.unit)
            if unit is None:
                return expression.value, _PLAIN
            return expression.value * unit.times / unit.over, unit.dimension
        if isinstance(expression, Reference):
            return self._number_called(expression)
        parts = [self._arithmetic(each) for each in expression.arguments]
        measure = self._measure(expression, [part[1] for part in parts])
        try:
            return formula(expression.function, tuple(part[0] for part in parts), expression.place), measure
        except ArithmeticProblem as problem:
            self.error("no-result", problem.message, problem.place, "check the numbers in these parentheses")
            return 1.0, measure

    def _measure(self, operation: Operation, measures: list[str]) -> str:
        """What the result measures, when metres are multiplied by 2, or seconds added to seconds."""
        different = sorted({each for each in measures if each})
        match operation.function:
            case "multiply" if len([each for each in measures if each]) < 2:
                return different[0] if different else _PLAIN
            case "divide" if measures[1] in (_PLAIN, measures[0]):
                return _PLAIN if measures[1] else measures[0]
            case "sin" | "cos" if measures[0] in (_PLAIN, "angle"):
                return _PLAIN
            case "multiply" | "divide" | "sin" | "cos" | "sqrt" if different:
                self.error("mixed-units", "units do not go together here", operation.place, "leave the units out")
            case "less" | "more" | "at_most" | "at_least" | "equal" | "unequal" if len(different) < 2:
                return _PLAIN
            case _ if len(different) < 2:
                return different[0] if different else _PLAIN
            case _:
                mixed = " and ".join(MEASURES[each] for each in different)
                self.error(
                    "mixed-units", f"{mixed} do not go together", operation.place, "use the same unit on both sides"
                )
        return _PLAIN

    def _number_called(self, reference: Reference) -> tuple[Number, str]:
        made = self.names.find(reference.name)
        if made is None:
            self._unknown(reference.name, reference.place, (NUMBER,), "number")
            return Name(reference.name), _PLAIN
        if made.family not in (NUMBER, SOMETHING):
            self.error(
                "not-a-number",
                f"'{cut(reference.name)}' is {some(made.family)}, not a number",
                reference.place,
                "only counters and names made by let stand in arithmetic",
            )
        return Name(reference.name), _PLAIN

    # Names

    def declare(self, made: Made) -> None:
        """Make a name known; two that are known at the same time cannot be equal."""
        before = self.names.find(made.name)
        if before is not None and before.family != SOMETHING and not self._unbalanced:
            self.error(
                "duplicate-name",
                f"the name '{cut(made.name)}' is taken since line {before.place.line}",
                made.place,
                f"choose another, such as {self._free(made.name)}",
            )
        self.names.make(made)

    def _free(self, name: str) -> str:
        stem = name.rstrip("0123456789") or name
        number = 2
        while self.names.find(f"{stem}{number}") or f"{stem}{number}" in self.names.everywhere:
            number += 1
        return cut(f"{stem}{number}")

    def called(self, name: Identifier, families: tuple[str, ...], wanted: str) -> Made | None:
        """What `name` stands for, which must be of these families ("a body", say `wanted`)."""
        made = self.names.find(name.name)
        if made is None:
            self._unknown(name.name, name.place, families, wanted)
            return None
        if made.family not in families and made.family != SOMETHING:
            self.error(
                "wrong-thing",
                f"'{cut(name.name)}' is {some(made.family)}, and this needs {some(wanted)}",
                name.place,
                self._alternatives(name.name, families),
            )
            return None
        return made

    def _alternatives(self, name: str, families: tuple[str, ...]) -> str:
        known = [each for each in self.names.known(families) if each not in EVENT_NAMES]
        suggestion = near(name, known)
        if suggestion:
            return f"did you mean '{cut(suggestion)}'?"
        return f"known here: {', '.join(cut(each) for each in known[:8])}" if known else ""

    def _unknown(self, name: str, place: Place, families: tuple[str, ...], wanted: str) -> None:
        if name in EVENT_NAMES:
            self.error("unknown-name", f"'{name}' is known only in the block of on collide, separate or touch", place,
                       "use a name that you gave with new")  # fmt: skip
            return
        elsewhere = self.names.everywhere.get(name)
        if name in self._lost or reserved(name) or (self._unbalanced and elsewhere is not None):
            return  # it stands in a statement or block that nobody understood, which has been said
        if elsewhere is None:
            hint = self._alternatives(name, families)
            if not hint.startswith("did"):
                self._lost.add(name)  # it was forgotten, not misspelt: once is enough
            if not hint:
                hint = f"make it first: let {cut(name)} 0;" if families == (NUMBER,) else "make it first, with new"
            self.error("unknown-name", f"there is no {wanted} called '{cut(name)}'", place, hint)
        elif (elsewhere.line, elsewhere.column) > (place.line, place.column):
            message = f"'{cut(name)}' is made later, on line {elsewhere.line}"
            self.error("unknown-name", message, place, "move this below it")
        else:
            message = f"'{cut(name)}' is known only inside the block on line {elsewhere.line} that makes it"
            self.error("unknown-name", message, place, "make it before that block, or give it a tag")

    # Colours, files, keys, corners, text

    def colour(self, text: Text) -> str:
        try:
            to_colour(text.value, "level", "colour")
        except ArgumentError:
            word = text.value.strip()
            if word.startswith("#"):
                hint = 'after # come 3, 4, 6 or 8 of the signs 0-9 and a-f, as in "#cc9966"'
            else:
                suggestion = near(word, COLOURS)
                hint = (
                    f"did you mean '{suggestion}'?" if suggestion else 'colours are names such as "red", or "#cc9966"'
                )
            self.error("unknown-colour", f"there is no colour '{cut(word)}'", text.place, hint)
        return text.value

    def picture(self, text: Text) -> str:
        return self._file(text, "pictures", (".png", ".jpg", ".jpeg", ".webp", ".gif", ".bmp"), "crate.png")

    def font(self, text: Text) -> str:
        return self._file(text, "fonts", (".ttf", ".otf", ".ttc"), "title.ttf")

    def choice(self, text: Text, word: str, choices: Mapping[str, str]) -> str:
        """What the engine calls one of the words that `word` may be."""
        if text.value not in choices:
            suggestion = near(text.value, choices)
            hint = f"did you mean '{suggestion}'?" if suggestion else f"{word} is {one_of(choices)}"
            self.error("unknown-choice", f"there is no {word} '{cut(text.value)}'", text.place, hint)
        return choices.get(text.value, text.value)

    def sound(self, text: Text) -> str:
        return self._file(text, "sounds", (".wav", ".ogg", ".mp3", ".flac"), "thud.ogg")

    def level(self, text: Text) -> str:
        if not text.value.endswith(".evil"):
            self.error(
                "bad-file",
                f"'{cut(text.value)}' is no level",
                text.place,
                'its name ends in .evil, as in "level2.evil"',
            )
            return text.value
        return self._file(text, "levels", (".evil",), "level2.evil")

    def _file(self, text: Text, kind: str, endings: tuple[str, ...], example: str) -> str:
        """The name of a file that lies in the level's folder."""
        name = text.value
        path = PurePosixPath(name)
        odd = not name or "\\" in name or ":" in name or "\0" in name or path.is_absolute() or ".." in path.parts
        if odd:
            self.error("bad-file", f"'{cut(name)}' is not a file in the level's folder", text.place,
                       f'write its name alone, as in "{example}"')  # fmt: skip
            return name
        if self.folder and not self._is_inside(name):
            files = self._files(endings)
            suggestion = near(name, files)
            if suggestion:
                hint = f"did you mean '{cut(suggestion)}'?"
            else:
                hint = (
                    f"there are {', '.join(cut(each) for each in files[:6])}" if files else f"there are no {kind} there"
                )
            self.error("missing-file", f"there is no file '{cut(name)}' in the level's folder", text.place, hint)
        return name

    def _is_inside(self, name: str) -> bool:
        try:
            folder = Path(self.folder).resolve()
            file = (folder / name).resolve()
            return file.is_file() and file.is_relative_to(folder)
        except (OSError, ValueError):
            return False

    def _files(self, endings: tuple[str, ...]) -> list[str]:
        try:
            return sorted(each for each in os.listdir(self.folder) if each.lower().endswith(endings))
        except OSError:
            return []

    def key(self, text: Text) -> str:
        name = text.value
        if name in KEY_NAMES:
            return name
        suggestion = near(name, KEY_NAMES, _KEY_MEANT) if name.strip() else "space"
        hint = (
            f'did you mean "{suggestion}"?' if suggestion else 'keys are "a" to "z", "space", "up", "left", "enter" ...'
        )
        self.error("unknown-key", f"there is no key '{cut(name)}'", text.place, hint)
        return name

    def points(self, spots: tuple[Spot, ...], word: str) -> tuple[Pair, ...]:
        """Points that are each a `word` ("corner") of something."""
        return tuple(self.pair(spot, f"a {word}", Range(least=-10_000.0, most=10_000.0), "length") for spot in spots)

    def corners(
        self, kind: Kind, spots: tuple[Spot, ...], place: Place, holes: tuple[tuple[Pair, ...], ...] = ()
    ) -> tuple[Pair, ...]:
        """Corners that make a shape round its holes, or the points of a path."""
        pairs = self.points(spots, "point" if kind.open else "corner")
        known, known_holes = fixed_points(pairs), [fixed_points(hole) for hole in holes]
        if known is not None and None not in known_holes:
            problem = _path_problem(known) if kind.open else _core.polygon_problem(known, known_holes)
            if problem:
                first, last = spots[0].place, spots[-1].place
                if first.line == last.line:
                    place = Place(first.line, first.column, last.column + last.length - first.column)
                message, _, hint = problem.partition("; ")
                self.error("bad-shape", f"this {kind.word} cannot be: {_from_one(message)}", place, hint)
        return pairs

    def pieces(self, text: Text) -> tuple[str | Number, ...]:
        """The fixed parts of a text and the numbers shown between them: `Score {score}`."""
        result: list[str | Number] = []
        plain, end = "", 0
        for match in _PIECE.finditer(text.value):
            plain += text.value[end : match.start()]
            end = match.end()
            piece = match.group()
            place = Place(text.place.line, text.place.column + 1 + match.start(), len(piece))
            if piece in ("{{", "}}"):
                plain += piece[0]
            elif match.group(1) is None:
                self.error("odd-brace", f"this {piece} has no partner", place, "{score} shows a number; {{ shows a {")
            else:
                name = match.group(1).strip()
                self._number_called(Reference(name, place))
                result += [plain, Name(name)]
                plain = ""
        plain += text.value[end:]
        result += [plain] if plain or not result else []
        return tuple(each.replace("\\n", "\n") if isinstance(each, str) else each for each in result)


def fixed_points(pairs: tuple[Pair, ...]) -> list[tuple[float, float]] | None:
    """Points that are known beforehand; None if one of them is not."""
    known = [(pair.x, pair.y) for pair in pairs if isinstance(pair.x, float) and isinstance(pair.y, float)]
    return known if len(known) == len(pairs) else None


def _path_problem(points: list[tuple[float, float]]) -> str:
    """What is wrong with a path, with its points counted from 0; "" for nothing."""
    for number, (here, there) in enumerate(pairwise(points)):
        if math.dist(here, there) < MIN_SIZE:
            return f"points {number} and {number + 1} are in one place; leave one of them out"
    return ""


def _from_one(message: str) -> str:
    """Corners and edges counted from 1, as people count."""

    def one_more(match: re.Match[str]) -> str:
        word, first, last = match.groups()
        return f"{word} {int(first) + 1}" + (f"-{int(last) + 1}" if last else "")

    message = re.sub(r"holes\[(\d+)\]", lambda match: f"hole {int(match.group(1)) + 1}", message)
    return re.sub(r"\b(corners?|edges?|points?|and) (\d+)(?:-(\d+))?", one_more, message)


def place_of(expression: Expression) -> Place:
    """Where an expression is written; of arithmetic, from its first part to its last on the same line."""
    if not isinstance(expression, Operation):
        return expression.place
    places = [expression.place, *(place_of(each) for each in expression.arguments)]
    line = min(place.line for place in places)
    here = [place for place in places if place.line == line]
    start = min(place.column for place in here)
    return Place(line, start, max(place.column + place.length for place in here) - start)
