"""The words of water: where liquid may be, what it is like, how it looks, and how it comes and goes."""

from __future__ import annotations

from collections.abc import Mapping

from evilengine.script.fluids import sides_of
from evilengine.script.word import PLACE, SIZE, Kind, Of, Property, Range, Size, Statement

WATER = "water"
LIQUID = "liquid"
STREAM = "stream"
DRAIN = "drain"
FILLING = "filling"
WATERS = (WATER, STREAM, DRAIN)
"""What `destroy` and `set` know of them; liquids are changed, and stay."""
MAX_WATERS = 16  # that a level keeps alive, so a forgotten `every` stays playable
_POOL = "new water pool 8 4;\n"
_SIZES = (Size(name="width"), Size(name="height"))

WATER_STATEMENTS: tuple[Statement, ...] = (
    Statement(
        word="fill",
        form="fill WATER WIDTH HEIGHT [X Y] [PROPERTIES];",
        doc="Fills an area of a water, where nothing is, with liquid; its place is its middle.",
        example=_POOL + "fill pool 8 2 at 0 -1;",
        meant=("flood", "fillWith"),
    ),
    Statement(
        word="pour",
        form="pour WATER [as NAME] at X Y rate NUMBER [PROPERTIES];",
        doc="Lets liquid come into a water, so many square metres a second, from now on. `as` gives the stream a name, "
        "by which `set` changes it and `destroy` ends it.",
        example=_POOL + "pour pool as tap at 0 1.5 rate 0.5 velocity 0 -2;\nafter 3 { destroy tap; }",
        meant=("tap", "spout", "stream", "spill"),
    ),
    Statement(
        word="drain",
        form="drain WATER [as NAME] WIDTH HEIGHT [X Y] [PROPERTIES];",
        doc="Lets liquid go where an area is, from now on: all that comes there, or so much as `rate` says. `as` gives "
        "it a name.",
        example=_POOL + "fill pool 8 2 at 0 -1;\ndrain pool as hatch 1 0.2 at 3 -1.9 rate 0.5;",
        meant=("outlet", "plug", "leak", "empty"),
    ),
)

WATER_KINDS: tuple[Kind, ...] = (
    Kind(
        word="water",
        family=WATER,
        type="Water",
        sizes=_SIZES,
        doc="An area that may hold water, empty at first: `fill` and `pour` bring it. Things float in it or sink, by "
        "their `density`, and push it. Walls are all round it, unless it says `open`.",
        example=_POOL + "fill pool 8 2 at 0 -1;\nnew rectangle crate 0.8 0.8 at 0 1 density 0.5 physicsOn;",
        meant=("pool", "sea", "aquarium", "tank", "river", "ocean", "fluid"),
    ),
    Kind(
        word="liquid",
        family=LIQUID,
        type="Liquid",
        needs=("in",),
        doc="One more liquid for a water, such as oil, which floats on it. `fill` and `pour` say which they bring.",
        example=_POOL + 'new liquid oil in pool density 0.8 viscosity 0.01 colour "gold";\n'
        "fill pool 8 1 at 0 -1 liquid oil;",
        meant=("oil", "honey", "lava", "slime"),
    ),
)

FLOWS: Mapping[str, Kind] = {
    each.word: each
    for each in (
        Kind(word="fill", family=FILLING, type="", sizes=_SIZES, doc="", example=WATER_STATEMENTS[0].example),
        Kind(word="pour", family=STREAM, type="Stream", needs=("at", "rate"), doc="",
             example=WATER_STATEMENTS[1].example),
        Kind(word="drain", family=DRAIN, type="Stream", sizes=_SIZES, doc="", example=WATER_STATEMENTS[2].example),
    )
}  # fmt: skip
"""What the statements about water make, which `new` does not."""

_water = Of((WATER,), "new water pool 8 4 ")
_liquid = Of((LIQUID,), _POOL + "new liquid oil in pool ")
_wet = Of((WATER, LIQUID), _POOL + "new liquid oil in pool ")
_stream = Of((STREAM,), _POOL + "pour pool as tap at 0 1.5 rate 0.5 ")
_filling = Of((FILLING,), _POOL + "fill pool 8 2 at 0 -1 ")
_drain = Of((DRAIN,), _POOL + "drain pool as hatch 1 0.2 at 3 -1.9 ")
_flow = Of((STREAM, FILLING), _POOL + "pour pool as tap at 0 1.5 rate 0.5 ")
_standing = Of((STREAM, DRAIN), _POOL + "pour pool as tap at 0 1.5 rate 0.5 ")
_RATE = Range(least=0.0, most=10_000.0)
_LOOK = Range(least=0.0, most=10.0)

# fmt: off
WATER_PROPERTIES: tuple[Property, ...] = (
    Of((WATER, STREAM, FILLING, DRAIN))("at", "point",
        "Where its middle is, in metres; of a stream that `follows` something, counted from there.",
        example=_POOL + "fill pool 8 2 at 0 -1;", range=PLACE, meant=("position", "pos", "place", "location")),
    _water("particleSize", "length", "How large its particles are: at half of it, there are four times as many; 0.1 "
        "metres unless said.", "particleSize 0.05", option="particle_size", range=Range(least=0.005, most=100.0),
        meant=("size", "resolution", "cells", "detail", "particles")),
    *sides_of(_water, "Liquid may leave by its"),
    _water("open", "flag", "It has no walls: liquid that leaves it is gone.", "open",
        meant=("openSides", "openAll", "noWalls", "unbounded")),
    _wet("density", "number", "How heavy it is: what has less floats in it; 1 unless said.", "density 0.8",
        range=Range(above=0.0, most=1_000_000.0), settable=True, meant=("weight", "mass", "heavy")),
    _wet("viscosity", "number", "How thick it is, in square metres a second: 0.01 is oil, 1 honey; 0 unless said.",
        "viscosity 0.01", range=_RATE, settable=True, meant=("thick", "thickness", "drag")),
    _wet("surfaceTension", "number", "How strongly its surface draws together, to drops; 0 unless said.",
        "surfaceTension 0.5", option="surface_tension", range=_RATE, settable=True, meant=("tension", "drops")),
    _wet("colour", "colour", "Its colour.", 'colour "gold"', settable=True, spellings=("color",),
        meant=("tint", "fill")),
    Of((STREAM, FILLING, DRAIN))("in", "name", "The water that it is about, which stands first.",
        example=_POOL + "fill pool 8 2 at 0 -1;", option="water", of=(WATER,)),
    _liquid("in", "name", "The water that it is for.", "density 0.8", option="water", of=(WATER,),
        meant=("of", "into", "for")),
    _water("shades", "colours", "Its colours from the surface to the deep, two or more; made of its `colour` unless "
        "said.", 'shades "#66ccff66" "#003355ee"', option="ramp", meant=("ramp", "colours", "colors", "gradient")),
    _water("clarity", "length", "How many metres below its surface a third of the light is left; 1.5 unless said.",
        "clarity 3", range=SIZE, meant=("clear", "opacity", "transparency", "murky")),
    _water("refraction", "number", "How much what lies behind is displaced; 1 unless said.", "refraction 0.5",
        range=_LOOK, meant=("distortion",)),
    _water("waves", "number", "How much that wavers; 1 unless said.", "waves 0.3", range=_LOOK, meant=("ripples",)),
    _water("rim", "number", "How bright the line of its surface is; 0.8 unless said.", "rim 0.4",
        range=Range(least=0.0, most=1.0), meant=("line", "outline", "edge")),
    _water("foam", "number", "How much foam and spray it throws up; 1 unless said, 0 for none.", "foam 2", range=_LOOK,
        meant=("spray", "splash", "bubbles")),
    _water("unlit", "flag", "Lights do not fall on it: it is as bright in the dark.", "unlit", option="lit",
        meant=("unshaded", "flat")),
    _water("layer", "whole", "It lies over the things of this layer.", "layer 2",
        range=Range(least=-1000.0, most=1000.0), meant=("depth", "z", "order")),
    _flow("velocity", "direction", "How fast it comes, to the right and up, in metres a second; it falls unless said.",
        "velocity 0 -2", range=Range(least=-1000.0, most=1000.0), settable=True, meant=("speed", "flow", "towards")),
    _flow("liquid", "name", "Which liquid comes, if not the water itself.",
        example=_POOL + 'new liquid oil in pool density 0.8 colour "gold";\nfill pool 8 1 at 0 -1 liquid oil;',
        of=(LIQUID,), meant=("kind", "of", "what")),
    _standing("rate", "number", "How many square metres come, or go at most, in a second.", "velocity 0 -2",
        range=_RATE, settable=True, meant=("amount", "speed", "flow")),
    _standing("follows", "name", "The thing that it goes along with; it ends with that thing.",
        example=_POOL + "new circle can 0.2 at 0 1 physicsOn;\npour pool at 0 0.4 rate 0.3 follows can;",
        option="body", meant=("on", "attached", "body")),
    _standing("idle", "flag", "Nothing comes or goes, until `set` says `idle off`.", "idle", option="running",
        settable="idle", meant=("off", "stopped", "running", "paused")),
    _stream("radius", "length", "How wide it is, from its middle to its rim; as wide as it takes unless said.",
        "radius 0.2", range=SIZE, meant=("size", "width", "wide")),
    Of((FILLING, DRAIN))("angle", "angle", "How far its area is turned, in degrees against the clock.",
        example=_POOL + "fill pool 4 1 at 0 0 angle 30;", meant=("turned", "rotation")),
)
# fmt: on
