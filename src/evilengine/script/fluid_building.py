"""`new smoke`, `new water` and what belongs to them to commands."""

from __future__ import annotations

from typing import TYPE_CHECKING

from evilengine.script.fluids import SMOKE
from evilengine.script.shaping import Settings
from evilengine.script.syntax import New
from evilengine.script.waters import FILLING, LIQUID, WATER
from evilengine.script.words import kind_called
from evilengine.values import level as values
from evilengine.values.level import Area, Called, Command, Make

if TYPE_CHECKING:
    from evilengine.script.bodies import ThingBuilder


def add_fluid(builder: ThingBuilder, statement: New, settings: Settings) -> list[Command]:
    """The command of a `new` that makes a fluid, or what belongs to one; none, if that cannot be."""
    name = statement.name.name if statement.name else ""
    if statement.kind == SMOKE:
        area, options = _box(builder, statement, settings), tuple(builder._options(settings, "at"))
        return [values.AddSmoke(statement.place, name, area, options)] if area else []
    _check_outline(builder, statement, settings)
    smoke = builder.value(*settings["in"]) if "in" in settings else None
    options = tuple(builder._options(settings, "in"))
    return [values.AddSource(statement.place, name, smoke, options)] if isinstance(smoke, Called) else []


def add_water(builder: ThingBuilder, statement: New, settings: Settings) -> list[Command]:
    """The same for a water, its liquids, and what fills, pours and drains."""
    name, place = statement.name.name if statement.name else "", statement.place
    if statement.kind == WATER:
        area, options = _box(builder, statement, settings), tuple(builder._options(settings, "at"))
        return [values.AddWater(place, name, area, options)] if area else []
    target = settings.get("in")
    water = builder.value(*target) if target else None
    options = tuple(builder._options(settings, "in", "at"))
    if not isinstance(water, Called):
        return []
    if statement.kind == LIQUID:
        return [values.AddLiquid(place, name, water, options)]
    kind = kind_called(str(statement.kind))
    sizes = tuple(builder.size(*each) for each in zip(statement.sizes, kind.sizes, strict=False))
    if len(sizes) < len(kind.sizes):
        return []
    shape = Make("Rectangle", sizes) if sizes else None
    options = (builder._place(statement, settings), *options)
    if shape is not None and kind.family == FILLING:
        return [values.FillWater(place, water, shape, options)]
    return [values.AddStream(place, name, water, shape, options)]


def _box(builder: ThingBuilder, statement: New, settings: Settings) -> Area | None:
    """The area that its sizes and its place say; None where they do not."""
    kind = kind_called(str(statement.kind))
    sizes = [builder.size(*each) for each in zip(statement.sizes, kind.sizes, strict=False)]
    middle = builder._place(statement, settings).value
    return builder._area(sizes, middle, statement.place) if len(sizes) == len(kind.sizes) else None


def _check_outline(builder: ThingBuilder, statement: New, settings: Settings) -> None:
    """A source is a circle or a rectangle, and never both."""
    if statement.broken:
        return
    sides = [word for word in ("wide", "tall") if word in settings]
    if "radius" in settings:
        for word in (*sides, *(("angle",) if "angle" in settings else ())):
            message = f"a source with a radius is a circle, which has no {word}"
            builder.error("both-said", message, settings[word][0].place, "leave radius out for a rectangle")
    elif len(sides) < 2:
        hint = "as in: radius 0.3, or wide 4 tall 0.5"
        builder.error("missing-property", "a source needs a radius, or wide and tall", statement.place, hint)
