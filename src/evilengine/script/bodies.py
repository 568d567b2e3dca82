"""`new` to commands: bodies with their shapes, forces, and the values of properties."""

from __future__ import annotations

from evilengine.script.arithmetic import formula
from evilengine.script.checker import Checker
from evilengine.script.names import SOMETHING, Made, family_made
from evilengine.script.settings import example_of
from evilengine.script.syntax import Expression, Identifier, New, Setting, Spot, Text
from evilengine.script.word import PLACE, SIZE, Property, Size
from evilengine.script.words import KINDS, family_of, property_of
from evilengine.values import level as values
from evilengine.values.level import Area, Called, Command, Corners, Make, Number, Option, Pair, Place, Value

BODIES = ("body", "walls")
WALL_THICKNESS = 1.0
_MEASURE = {"angle": "angle", "length": "length", "time": "time", "mass": "mass", "spin": "spin", "point": "length"}


class ThingBuilder(Checker):
    """Builds what `new` makes."""

    def new(self, statement: New) -> list[Command]:
        commands: list[Command] = []
        if statement.kind is not None:
            settings = self._settings(statement)
            kind = KINDS[statement.kind]
            if kind.family == "body":
                commands = self._body(statement, settings)
            elif kind.family == "spring":
                commands = self._spring(statement, settings)
            else:
                commands = self._force(statement, settings)
        if statement.name is not None:
            still = "physicsOn" not in {each.word for each in statement.settings}
            self.declare(Made(statement.name.name, family_made(statement), statement.name.place, still=still))
        return commands

    def _settings(self, statement: New) -> dict[str, tuple[Setting, Property]]:
        """The properties of a `new` by their words, each once, and all that it needs."""
        assert statement.kind is not None
        kind = KINDS[statement.kind]
        found = self.by_word(statement.settings, family_of(kind))
        if not statement.broken:
            for word in kind.needs:
                if word not in found:
                    entry = property_of(word, family_of(kind))
                    hint = f"as in: {example_of(entry)}" if entry else ""
                    self.error("missing-property", f"a {kind.word} needs {word}", statement.place, hint)
        return found

    def by_word(self, settings: tuple[Setting, ...], family: str) -> dict[str, tuple[Setting, Property]]:
        found: dict[str, tuple[Setting, Property]] = {}
        for setting in settings:
            entry = property_of(setting.word, family)
            if entry is None:
                continue  # another kind's; the parser has said so
            if setting.word in found:
                self.error("said-twice", f"{setting.word} is said twice", setting.place, "keep one of them")
            found[setting.word] = setting, entry
        return found

    def _body(self, statement: New, settings: dict[str, tuple[Setting, Property]]) -> list[Command]:
        assert statement.kind is not None
        kind = KINDS[statement.kind]
        self._body_conflicts(settings)
        options: list[Option] = [Option("kind", _body_kind(settings))]
        sizes = [self._size(*each) for each in zip(statement.sizes, kind.sizes, strict=False)]
        place = self._thesis_place(statement, len(kind.sizes), settings)
        if "at" not in settings:
            options.append(Option("at", place or Pair(0.0, 0.0)))
        for word, (setting, entry) in settings.items():
            if word not in ("physicsOn", "moving", "thickness"):
                options.append(Option(entry.option, self.value(setting, entry)))
        shapes: tuple[tuple[Make, Pair], ...] = ()
        if kind.corners is not None:
            corners = self.corners(kind.word, statement.corners, statement.place) if not statement.broken else ()
            shapes = ((Make(kind.type, (Corners(corners),)), Pair(0.0, 0.0)),)
        elif len(sizes) == len(kind.sizes):
            if kind.word == "walls":
                shapes = self._walls(sizes[0], sizes[1], settings, statement.place)
            else:
                shapes = ((Make(kind.type, tuple(sizes)), Pair(0.0, 0.0)),)
        name = statement.name.name if statement.name else ""
        return [values.AddBody(statement.place, name, shapes, tuple(options))]

    def _size(self, expression: Expression, size: Size) -> Number:
        return self.number(expression, f"the {size.name}", size.range, "length" if size.range == SIZE else "")

    def _thesis_place(self, statement: New, sizes: int, settings: dict[str, tuple[Setting, Property]]) -> Pair | None:
        """The place that follows the sizes, as in `new rectangle 2 1 0 4`."""
        if len(statement.sizes) != sizes + 2:
            return None
        x, y = statement.sizes[sizes:]
        if "at" in settings:
            self.error("said-twice", "the place is said twice", settings["at"][0].place, "keep one of them")
        return self.pair(Spot(x, y, statement.place), "at", PLACE, "length")

    def _body_conflicts(self, settings: dict[str, tuple[Setting, Property]]) -> None:
        for one, other in (("density", "mass"), ("physicsOn", "moving")):
            if one in settings and other in settings:
                later = max(settings[one][0], settings[other][0], key=lambda each: (each.place.line, each.place.column))
                self.error("both-said", f"{one} and {other} exclude each other", later.place, "keep one of them")
        if "physicsOn" not in settings and "moving" not in settings:
            for word in ("velocity", "spin"):
                if word in settings:
                    message = f"{word} means nothing for a thing that stands still"
                    self.error("stands-still", message, settings[word][0].place, "add physicsOn")

    def _walls(
        self, width: Number, height: Number, settings: dict[str, tuple[Setting, Property]], place: Place
    ) -> tuple[tuple[Make, Pair], ...]:
        """Four rectangles round the room: below, above, left, right."""
        thickness: Number = WALL_THICKNESS
        if "thickness" in settings:
            setting, entry = settings["thickness"]
            (value,) = setting.values
            assert not isinstance(value, Text | Identifier | Spot)
            thickness = self.number(value, "thickness", entry.range, "length")

        def middle(size: Number) -> Number:
            return formula("divide", (formula("add", (size, thickness), place), 2.0), place)

        long = formula("add", (width, formula("multiply", (2.0, thickness), place)), place)
        up, across = middle(height), middle(width)
        level, upright = Make("Rectangle", (long, thickness)), Make("Rectangle", (thickness, height))
        return (
            (level, Pair(0.0, formula("negate", (up,), place))),
            (level, Pair(0.0, up)),
            (upright, Pair(formula("negate", (across,), place), 0.0)),
            (upright, Pair(across, 0.0)),
        )

    def _spring(self, statement: New, settings: dict[str, tuple[Setting, Property]]) -> list[Command]:
        options: list[Option] = []
        body = Called("")
        for word, (setting, entry) in settings.items():
            if word == "from":
                (name,) = setting.values
                assert isinstance(name, Identifier)
                made = self.called(name, BODIES, "thing")
                if made is not None and made.family != SOMETHING and made.still:
                    hint = "say from the thing that moves, to the one that stands still"
                    self.error(
                        "stands-still", f"'{name.name}' stands still, so no spring can move it", name.place, hint
                    )
                body = Called(name.name)
            else:
                options.append(Option(entry.option, self.value(setting, entry)))
        name_made = statement.name.name if statement.name else ""
        return [values.AddForce(statement.place, name_made, Make("Spring", (), tuple(options)), (body,))]

    def _force(self, statement: New, settings: dict[str, tuple[Setting, Property]]) -> list[Command]:
        assert statement.kind is not None
        kind = KINDS[statement.kind]
        sizes = [self._size(*each) for each in zip(statement.sizes, kind.sizes, strict=False)]
        bodies: list[Called] = []
        if "for" in settings:
            for name in settings["for"][0].values:
                assert isinstance(name, Identifier)
                self.called(name, BODIES, "thing")
                bodies.append(Called(name.name))
        force = Make(kind.type)
        if len(sizes) >= len(kind.sizes):
            match kind.word:
                case "force":
                    force = Make(kind.type, (Pair(sizes[0], sizes[1]),))
                case "drag":
                    force = Make(kind.type, (sizes[0],))
                case _:
                    force = self._medium(statement, sizes, settings)
        name_made = statement.name.name if statement.name else ""
        return [values.AddForce(statement.place, name_made, force, tuple(bodies))]

    def _medium(self, statement: New, sizes: list[Number], settings: dict[str, tuple[Setting, Property]]) -> Make:
        """A medium's area is given by its edges: left, bottom, right, top."""
        place = statement.place
        middle = self._thesis_place(statement, 2, settings) or Pair(0.0, 0.0)
        options: list[Option] = []
        for word, (setting, entry) in settings.items():
            value = self.value(setting, entry)
            if word == "at" and isinstance(value, Pair):
                middle = value
            else:
                options.append(Option(entry.option, value))

        def edge(centre: Number, size: Number, side: str) -> Number:
            return formula(side, (centre, formula("divide", (size, 2.0), place)), place)

        left, bottom = edge(middle.x, sizes[0], "subtract"), edge(middle.y, sizes[1], "subtract")
        right, top = edge(middle.x, sizes[0], "add"), edge(middle.y, sizes[1], "add")
        return Make("Medium", (Area(left, bottom, right, top),), tuple(options))

    # Property values

    def value(self, setting: Setting, entry: Property) -> Value:
        if entry.takes == "flag":
            return True
        item = setting.values[0]
        match item:
            case Text():
                if entry.takes == "colour":
                    return self.colour(item)
                return self.picture(item) if entry.takes == "picture" else item.value
            case Spot():
                measure = {"direction": "speed", "spot": ""}.get(entry.takes, "length")
                return self.pair(item, entry.word, entry.range, measure)
            case Identifier():
                made = self.called(item, BODIES, "thing")
                return Called(made.name if made else item.name)
            case _:
                return self._amount(item, entry)

    def _amount(self, item: Expression, entry: Property) -> Value:
        if entry.takes == "whole":
            return self.whole(item, entry.word, entry.range)
        value = self.number(item, entry.word, entry.range, _MEASURE.get(entry.takes, ""))
        if entry.takes in ("angle", "spin"):
            return formula("radians", (value,), item.place)
        return value


def _body_kind(settings: dict[str, tuple[Setting, Property]]) -> str:
    if "physicsOn" in settings:
        return "dynamic"
    return "kinematic" if "moving" in settings else "static"
