"""The shapes of `new` and `draw` as the engine makes them: walls out of four, capsules out of a width and a height."""

from __future__ import annotations

from evilengine.script.arithmetic import formula
from evilengine.script.checker import Checker, fixed_points
from evilengine.script.syntax import Expression, Identifier, New, Setting, Spot, Text
from evilengine.script.word import Kind, Property, Size, plain
from evilengine.script.words import KINDS, ONLY, has, takes
from evilengine.values.errors import ShapeError
from evilengine.values.level import Corners, Formula, Holes, Let, Make, Name, Number, Option, Pair, Place
from evilengine.world.shapes import Polygon

WALL_THICKNESS = 1.0
Settings = dict[str, tuple[Setting, Property]]


class ShapeBuilder(Checker):
    """Builds the shapes of one thing."""

    measured: list[Let]
    """Numbers that what is being built needs more than once, so that `random` is asked once for each."""

    def once(self, number: Number, what: str, place: Place) -> Number:
        """The same number wherever it is used."""
        if not isinstance(number, Formula):
            return number
        self.measured.append(Let(place, f"its {what}", number))
        return Name(f"its {what}")

    def shapes(self, statement: New, settings: Settings) -> tuple[Make, ...]:
        """None where its sizes or corners are wrong, which has been said."""
        assert statement.kind is not None
        kind = KINDS[statement.kind]
        self._refuse_foreign(kind, settings)
        if kind.corners is not None:
            return (self._cornered(kind, statement, settings),)
        sizes = [self.size(*each) for each in zip(statement.sizes, kind.sizes, strict=False)]
        if len(sizes) < len(kind.sizes):
            return ()
        match kind.word:
            case "walls":
                return self._walls(sizes[0], sizes[1], settings, statement.place)
            case "capsule" | "character":
                return (self._capsule(kind, sizes[0], sizes[1], statement.place),)
            case "rectangle":
                return (Make(kind.type, tuple(sizes), self._rounding_of_rectangle(sizes, settings)),)
        return (Make(kind.type, tuple(sizes)),)

    def size(self, expression: Expression, size: Size) -> Number:
        return self.number(expression, f"the {size.name}", size.range, size.measure)

    def _refuse_foreign(self, kind: Kind, settings: Settings) -> None:
        for word, (setting, entry) in settings.items():
            if word not in ONLY and not takes(kind, entry):
                owners = ", ".join(each.word for each in KINDS.values() if word in each.shaped)
                self.error("wrong-property", f"{has(kind.word)} no {word}", setting.place, f"it is for {owners}")

    def _length(self, settings: Settings, word: str) -> Number | None:
        if word not in settings:
            return None
        setting, entry = settings[word]
        (value,) = setting.values
        assert not isinstance(value, Text | Identifier | Spot)
        return self.number(value, word, entry.range, "length")

    # Corners

    def _cornered(self, kind: Kind, statement: New, settings: Settings) -> Make:
        holes = self._holes(kind, statement)
        corners = self.corners(kind, statement.corners, statement.place, holes) if not statement.broken else ()
        arguments = corners if kind.corners in ((2, 2), (3, 3)) else (Corners(corners),)
        if "closed" in settings and kind.open:
            if len(corners) == 2:
                place = settings["closed"][0].place
                self.error("bad-shape", "a closed chain has three points or more", place, "leave closed out")
            return Make(kind.type, arguments, (Option("loop", True),))
        options = (Option("holes", Holes(tuple(map(Corners, holes)))),) if holes else ()
        rounding = self._length(settings, "rounding") if "rounding" in kind.shaped else None
        if rounding is None:
            return Make(kind.type, arguments, options)
        self._check_rounding(corners, holes, rounding, settings)
        return Make(kind.type, arguments, (*options, Option("rounding", rounding)))

    def _holes(self, kind: Kind, statement: New) -> tuple[tuple[Pair, ...], ...]:
        said = [setting.values for setting in statement.settings if setting.word == "hole"]
        rings = [tuple(spot for spot in each if isinstance(spot, Spot)) for each in said if "hole" in kind.shaped]
        return tuple(self.points(ring, "corner") for ring in rings)

    def _check_rounding(
        self, corners: tuple[Pair, ...], holes: tuple[tuple[Pair, ...], ...], rounding: Number, settings: Settings
    ) -> None:
        points, gaps = fixed_points(corners), [fixed_points(hole) for hole in holes]
        known = [gap for gap in gaps if gap is not None]
        if self.source.diagnostics or points is None or len(known) < len(gaps) or not isinstance(rounding, float):
            return
        try:
            Polygon(points, holes=known, rounding=rounding)
        except ShapeError as error:
            message, _, hint = str(error).removeprefix("Polygon: ").partition("; ")
            self.error("out-of-range", message, settings["rounding"][0].place, hint)

    # Sizes

    def _rounding_of_rectangle(self, sizes: list[Number], settings: Settings) -> tuple[Option, ...]:
        rounding = self._length(settings, "rounding")
        if rounding is None:
            return ()
        known = [each for each in sizes if isinstance(each, float)]
        if isinstance(rounding, float) and len(known) == 2 and rounding > 0.5 * min(known):
            message = f"the rounding of a rectangle of this size cannot be {plain(rounding)}"
            hint = f"at most {plain(0.5 * min(known))}, half of its shorter side"
            self.error("out-of-range", message, settings["rounding"][0].place, hint)
        return (Option("rounding", rounding),)

    #     +----------------+
    #    /a                b\      as high as wide it would be a circle, which has no direction to lie in
    #    \                  /
    #     +----------------+
    def _capsule(self, kind: Kind, width: Number, height: Number, place: Place) -> Make:
        if isinstance(width, float) and width == height:
            hint = f"write: circle {plain(0.5 * width)}" if kind.word == "capsule" else "let it be a little higher"
            self.error("bad-shape", f"a {kind.word} cannot be as wide as it is high", place, hint)
        width, height = self.once(width, "width", place), self.once(height, "height", place)
        radius = formula("divide", (formula("min", (width, height), place), 2.0), place)
        radius = self.once(radius, "radius", place)

        def ends(size: Number) -> tuple[Number, Number]:
            half = formula("divide", (size, 2.0), place)
            return formula("subtract", (radius, half), place), formula("subtract", (half, radius), place)

        (left, right), (bottom, top) = ends(width), ends(height)
        return Make("Capsule", (Pair(left, bottom), Pair(right, top), radius))

    def _walls(self, width: Number, height: Number, settings: Settings, place: Place) -> tuple[Make, ...]:
        """Four rectangles round the room: below, above, left, right."""
        said = self._length(settings, "thickness")
        width, height = self.once(width, "width", place), self.once(height, "height", place)
        thickness = self.once(WALL_THICKNESS if said is None else said, "thickness", place)

        def half(size: Number, more: Number) -> Number:
            return formula("add", (formula("divide", (size, 2.0), place), more), place)

        def wall(left: Number, bottom: Number, right: Number, top: Number) -> Make:
            corners = (Pair(left, bottom), Pair(right, bottom), Pair(right, top), Pair(left, top))
            return Make("Polygon", (Corners(corners),))

        def minus(number: Number) -> Number:
            return formula("negate", (number,), place)

        x, y = half(width, 0.0), half(height, 0.0)
        far_x, far_y = half(width, thickness), half(height, thickness)
        return (
            wall(minus(far_x), minus(far_y), far_x, minus(y)),
            wall(minus(far_x), y, far_x, far_y),
            wall(minus(far_x), minus(y), minus(x), y),
            wall(x, minus(y), far_x, y),
        )
