"""`new smoke` and `new source` to commands."""

from __future__ import annotations

from typing import TYPE_CHECKING

from evilengine.script.fluids import SMOKE
from evilengine.script.shaping import Settings
from evilengine.script.syntax import New
from evilengine.script.words import KINDS
from evilengine.values import level as values
from evilengine.values.level import Called, Command

if TYPE_CHECKING:
    from evilengine.script.bodies import ThingBuilder


def add_fluid(builder: ThingBuilder, statement: New, settings: Settings) -> list[Command]:
    """The command of a `new` that makes a fluid, or what belongs to one; none, if that cannot be."""
    name = statement.name.name if statement.name else ""
    if statement.kind == SMOKE:
        kind = KINDS[SMOKE]
        sizes = [builder.size(*each) for each in zip(statement.sizes, kind.sizes, strict=False)]
        middle = builder._place(statement, settings).value
        options = tuple(builder._options(settings, "at"))
        if len(sizes) < len(kind.sizes):
            return []
        return [values.AddSmoke(statement.place, name, builder._area(sizes, middle, statement.place), options)]
    _check_outline(builder, statement, settings)
    smoke = builder.value(*settings["in"]) if "in" in settings else None
    options = tuple(builder._options(settings, "in"))
    return [values.AddSource(statement.place, name, smoke, options)] if isinstance(smoke, Called) else []


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
