"""`new` to commands: bodies with their shapes, forces, and the values of properties."""

from __future__ import annotations

from evilengine.script.air import PARTICLES
from evilengine.script.arithmetic import formula
from evilengine.script.checker import place_of
from evilengine.script.fluid_building import add_fluid, add_water
from evilengine.script.fluids import FLUIDS
from evilengine.script.joints import JOINTS
from evilengine.script.lighting import LIGHT
from evilengine.script.names import DRAWING, SOMETHING, Made, family_made
from evilengine.script.settings import example_of
from evilengine.script.shaping import Settings, ShapeBuilder
from evilengine.script.syntax import Expression, Identifier, Literal, New, Setting, Spot, Text
from evilengine.script.waters import FILLING, LIQUID, WATERS
from evilengine.script.word import MOST_COLUMNS, PLACE, Property, Range, plain
from evilengine.script.words import KINDS, ONLY, has, kind_called, property_of
from evilengine.values import level as values
from evilengine.values.level import (
    Area,
    Called,
    Colours,
    Command,
    Formula,
    Make,
    Name,
    Number,
    Numbers,
    Option,
    Pair,
    Place,
    Value,
)

BODIES = ("body", "character")
"""What `this` and `other` may be, and joints hold."""
_MEASURE = {"angle": "angle", "length": "length", "time": "time", "mass": "mass", "spin": "spin", "point": "length"}

_PICTURED = (
    ("frames", "texture", "frames 4 1 fps 10"), ("tile", "texture", "tile 0.5"), ("slice", "texture", "slice 12"),
    ("fps", "frames", "frames 4 1 fps 10"), ("showing", "frames", "frames 4 1 showing 2"),
    ("plays", "frames", "frames 4 1 plays once"),
)  # fmt: skip
"""What is said about a picture, what that needs, and how it is said."""


class ThingBuilder(ShapeBuilder):
    """Builds what `new` makes."""

    def new(self, statement: New) -> list[Command]:
        commands: list[Command] = []
        self.measured = []
        if statement.kind is not None:
            settings = self._settings(statement)
            kind = kind_called(statement.kind)
            if statement.drawn:
                commands = self._drawing(statement, settings)
            elif kind.family == "body":
                commands = self._body(statement, settings)
            elif kind.word in JOINTS:
                commands = self._joint(statement, settings)
            elif kind.family == "character":
                commands = self._character(statement, settings)
            elif kind.family == LIGHT:
                self._light_conflicts(settings)
                name = statement.name.name if statement.name else ""
                commands = [values.AddLight(statement.place, name, tuple(self._options(settings)))]
            elif kind.family == PARTICLES:
                self._exclude(settings, "glowing", "blend")
                name = statement.name.name if statement.name else ""
                commands = [values.AddParticles(statement.place, name, tuple(self._options(settings)))]
            elif kind.family in FLUIDS:
                commands = add_fluid(self, statement, settings)
            elif kind.family in (*WATERS, LIQUID, FILLING):
                commands = add_water(self, statement, settings)
            elif kind.family == "spring":
                commands = self._spring(statement, settings)
            elif kind.family == "ladder":
                commands = self._ladder(statement, settings)
            else:
                commands = self._force(statement, settings)
        if statement.name is not None:
            said = {each.word for each in statement.settings}
            made = Made(statement.name.name, family_made(statement), statement.name.place,
                        still="physicsOn" not in said, sees="sensor" in said)  # fmt: skip
            self.declare(made)
        return [*self.measured, *commands]

    def _settings(self, statement: New) -> Settings:
        """The properties of a `new` by their words, each once, and all that it needs."""
        assert statement.kind is not None
        kind = kind_called(statement.kind)
        family = DRAWING if statement.drawn else kind.family
        found = self.by_word(statement.settings, family)
        if not statement.broken:
            for word in kind.needs:
                if word not in found:
                    entry = property_of(word, family)
                    hint = f"as in: {example_of(entry)}" if entry else ""
                    self.error("missing-property", f"{has(kind.word, 'needs')} {word}", statement.place, hint)
        return found

    def by_word(self, settings: tuple[Setting, ...], family: str) -> Settings:
        found: Settings = {}
        for setting in settings:
            entry = property_of(setting.word, family)
            if entry is None:
                continue  # another kind's; the parser has said so
            if setting.word in found and entry.takes != "corners":
                self.error("said-twice", f"{setting.word} is said twice", setting.place, "keep one of them")
            found[setting.word] = setting, entry
        return found

    def _body(self, statement: New, settings: Settings) -> list[Command]:
        self._body_conflicts(settings)
        self._picture_conflicts(statement, settings)
        options: list[Option] = [Option("kind", _body_kind(settings))]
        options.append(self._place(statement, settings))
        shapes = self.shapes(statement, settings)
        options += self._options(settings, "at", "physicsOn", "moving")
        name = statement.name.name if statement.name else ""
        return [values.AddBody(statement.place, name, shapes, tuple(options))]

    def _character(self, statement: New, settings: Settings) -> list[Command]:
        self._picture_conflicts(statement, settings)
        options = [self._place(statement, settings)]
        if "velocity" in settings:
            hint = "throw it later, as in: set hero velocity 0 12;"
            self.error("stands-still", "a new character stands", settings["velocity"][0].place, hint)
        options += self._options(settings, "at", "velocity")
        shapes = self.shapes(statement, settings)
        name = statement.name.name if statement.name else ""
        return [values.AddCharacter(statement.place, name, shapes[0], tuple(options))] if shapes else []

    def _ladder(self, statement: New, settings: Settings) -> list[Command]:
        kind = KINDS["ladder"]
        sizes = [self.size(*each) for each in zip(statement.sizes, kind.sizes, strict=False)]
        if len(sizes) < len(kind.sizes):
            return []
        area = self._area(sizes, self._place(statement, settings).value, statement.place)
        return [values.AddLadder(statement.place, area, self._those(settings, ("character",), "character"))]

    def _those(self, settings: Settings, families: tuple[str, ...], wanted: str) -> tuple[Called, ...]:
        """The things named by `for`."""
        named = settings["for"][0].values if "for" in settings else ()
        for name in named:
            assert isinstance(name, Identifier)
            self.called(name, families, wanted)
        return tuple(Called(name.name) for name in named if isinstance(name, Identifier))

    def _drawing(self, statement: New, settings: Settings) -> list[Command]:
        self._picture_conflicts(statement, settings)
        options = [self._place(statement, settings)]
        options += self._options(settings, "at")
        shapes = self.shapes(statement, settings)
        name = statement.name.name if statement.name else ""
        return [values.AddDrawing(statement.place, name, shapes[0], tuple(options))] if shapes else []

    def _options(self, settings: Settings, *without: str) -> list[Option]:
        """Its properties but those, and but those of its shape."""
        said = [(setting, entry) for word, (setting, entry) in settings.items() if word not in without]
        return [Option(entry.option, self.value(setting, entry)) for setting, entry in said if entry.part != "shape"]

    def _place(self, statement: New, settings: Settings) -> Option:
        """Where it is: said by `at`, or after the sizes; without either, in the middle."""
        assert statement.kind is not None
        after_sizes = self._thesis_place(statement, len(kind_called(statement.kind).sizes), settings)
        if "at" in settings:
            return Option("at", self.value(*settings["at"]))
        return Option("at", after_sizes or Pair(0.0, 0.0))

    def _thesis_place(self, statement: New, sizes: int, settings: Settings) -> Pair | None:
        """The place that follows the sizes, as in `new rectangle 2 1 0 4`."""
        if len(statement.sizes) != sizes + 2:
            return None
        x, y = statement.sizes[sizes:]
        if "at" in settings:
            self.error("said-twice", "the place is said twice", settings["at"][0].place, "keep one of them")
        return self.pair(Spot(x, y, statement.place), "at", PLACE, "length")

    def _body_conflicts(self, settings: Settings) -> None:
        for one, other in (("density", "mass"), ("physicsOn", "moving")):
            self._exclude(settings, one, other)
        if "physicsOn" not in settings and "moving" not in settings:
            for word in ("velocity", "spin"):
                if word in settings:
                    message = f"{word} means nothing for a thing that stands still"
                    self.error("stands-still", message, settings[word][0].place, "add physicsOn")

    def _exclude(self, settings: Settings, one: str, other: str) -> None:
        if one in settings and other in settings:
            later = max(settings[one][0], settings[other][0], key=lambda each: (each.place.line, each.place.column))
            self.error("both-said", f"{one} and {other} exclude each other", later.place, "keep one of them")

    def _light_conflicts(self, settings: Settings) -> None:
        """A sun has neither place nor cone, and what says where a light shines to says how its picture is turned."""
        if "towards" in settings and "cone" in settings and not {"at", "follows"} & settings.keys():
            message = "a light that shines from far away has no cone"
            self.error("both-said", message, settings["cone"][0].place, "say where it is, as in: at 0 3")
        self._exclude(settings, "towards", "angle")

    def _picture_conflicts(self, statement: New, settings: Settings) -> None:
        """What is said about a picture needs one, and the number of its frames is known beforehand."""
        for word, needed, shown in _PICTURED:
            if word in settings and needed not in settings:
                hint = f'as in: texture "coin.png" {shown}'
                self.error("missing-property", f"{word} needs {needed}", settings[word][0].place, hint)
        for one, other in (("showing", "fps"), ("showing", "plays"), ("slice", "tile")):
            self._exclude(settings, one, other)
        self._corner_conflicts(statement, settings)
        if "frames" in settings:
            (spot,) = settings["frames"][0].values
            assert isinstance(spot, Spot)
            for side, what in ((spot.x, "the columns of frames"), (spot.y, "the rows of frames")):
                self.whole(side, what, Range(least=1, most=MOST_COLUMNS))

    def _corner_conflicts(self, statement: New, settings: Settings) -> None:
        """Only a rectangle has borders, and a colour is for each corner."""
        kind = KINDS[statement.kind or ""]
        if "slice" in settings and kind.word not in ONLY["slice"]:
            self.error("wrong-property", f"{has(kind.word)} no borders to slice", settings["slice"][0].place,
                       "slice is for rectangle")  # fmt: skip
        if "colours" not in settings:
            return
        setting = settings["colours"][0]
        self._exclude(settings, "colour", "colours")
        corners = 4 if kind.word == "rectangle" else len(statement.corners)
        if kind.word not in ONLY["colours"]:
            self.error("wrong-property", f"{has(kind.word)} no corners to colour", setting.place, "say: colour")
        elif len(setting.values) != corners and not statement.broken:
            message = f"this {kind.word} has {corners} corners, but {len(setting.values)} colours"
            self.error("wrong-count", message, setting.place, "write one for each")

    def _spring(self, statement: New, settings: Settings) -> list[Command]:
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

    def _joint(self, statement: New, settings: Settings) -> list[Command]:
        """The two things come first, then what the joint needs at a place; two ends of a range are one pair."""
        assert statement.kind is not None
        given = {entry.option: self.value(setting, entry) for setting, entry in settings.values()}
        least, most = given.pop("least", None), given.pop("most", None)
        if isinstance(least, (float, Name, Formula)) or isinstance(most, (float, Name, Formula)):
            far = values.FARTHEST_LIMIT
            given["limits"] = Pair(
                least if isinstance(least, (float, Name, Formula)) else -far,
                most if isinstance(most, (float, Name, Formula)) else far,
            )
        first = [given.pop(name) for name in ("a", "b") if name in given]
        options = tuple(Option(name, value) for name, value in given.items())
        name_made = statement.name.name if statement.name else ""
        return [
            values.AddJoint(statement.place, name_made, Make(kind_called(statement.kind).type, tuple(first), options))
        ]

    def _force(self, statement: New, settings: Settings) -> list[Command]:
        assert statement.kind is not None
        kind = kind_called(statement.kind)
        sizes = [self.size(*each) for each in zip(statement.sizes, kind.sizes, strict=False)]
        bodies = self._those(settings, BODIES, "thing")
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
        return [values.AddForce(statement.place, name_made, force, bodies)]

    def _medium(self, statement: New, sizes: list[Number], settings: Settings) -> Make:
        middle = self._place(statement, settings).value
        area = self._area(sizes, middle, statement.place)
        return Make("Medium", (area,), tuple(self._options(settings, "at")))

    def _area(self, sizes: list[Number], middle: Value, place: Place) -> Area:
        """An area by its edges."""
        assert isinstance(middle, Pair)
        width, height = self.once(sizes[0], "width", place), self.once(sizes[1], "height", place)
        x, y = self.once(middle.x, "x", place), self.once(middle.y, "y", place)

        def edge(centre: Number, size: Number, side: str) -> Number:
            return formula(side, (centre, formula("divide", (size, 2.0), place)), place)

        return Area(
            edge(x, width, "subtract"), edge(y, height, "subtract"), edge(x, width, "add"), edge(y, height, "add")
        )

    # Property values

    def value(self, setting: Setting, entry: Property) -> Value:
        if entry.takes == "flag":
            return True
        if entry.takes == "switch":
            return not any(isinstance(each, Identifier) and each.name == "off" for each in setting.values)
        if entry.takes in ("span", "sides"):
            return self._numbers(setting, entry)
        if entry.takes == "colours":
            return Colours(tuple(self.colour(each) for each in setting.values if isinstance(each, Text)))
        item = setting.values[0]
        match item:
            case Text():
                if entry.takes == "colour":
                    return self.colour(item)
                if entry.choices is not None:
                    return self.choice(item, entry.word, entry.choices)
                check = {"picture": self.picture, "font": self.font}.get(entry.takes)
                return check(item) if check else item.value
            case Spot():
                measure = {"direction": "speed", "spot": ""}.get(entry.takes, "length")
                return self.pair(item, entry.word, entry.range, measure)
            case Identifier():
                families = entry.of or BODIES
                made = self.called(item, families, "thing" if families[0] == "body" else families[0])
                return Called(made.name if made else item.name)
            case _:
                return self._amount(item, entry)

    def _numbers(self, setting: Setting, entry: Property) -> Value:
        """One number, or several: of a span, the least and the most."""
        said = [each for each in setting.values if not isinstance(each, Text | Identifier | Spot)]
        found = [self.number(each, entry.word, entry.range, entry.measure) for each in said]
        if len(found) == 1:
            return found[0]
        if entry.takes == "sides":
            return Numbers(tuple(found))
        low, high = found
        if isinstance(low, float) and isinstance(high, float) and low > high:
            hint = f"write {entry.word} {plain(high)} {plain(low)}"
            self.error("out-of-range", f"{entry.word} has its least number first", place_of(said[0]), hint)
        return Pair(low, high)

    def _amount(self, item: Expression, entry: Property) -> Value:
        if entry.takes == "whole":
            return self.whole(item, entry.word, entry.range)
        if entry.takes == "index" and isinstance(item, Literal) and item.value != int(item.value):
            self.error("not-whole", f"{entry.word} is a whole number", item.place, f"write {round(item.value)}")
        value = self.number(item, entry.word, entry.range, _MEASURE.get(entry.takes, ""))
        if entry.takes in ("angle", "spin"):
            return formula("radians", (value,), item.place)
        return value


def _body_kind(settings: Settings) -> str:
    if "physicsOn" in settings:
        return "dynamic"
    return "kinematic" if "moving" in settings else "static"
