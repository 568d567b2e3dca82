"""The words of light: lamps, spots and suns, the ambient light, and what is lit."""

from __future__ import annotations

from evilengine.script.word import FRACTION, MOST_BITS, NOT_NEGATIVE, PLACE, SIZE, Kind, Of, Property, Range, Statement

LIGHT = "light"
_WALL = 'draw rectangle wall 20 12 at 0 0 colour "#887766" layer -1 lit;\n'

LIGHT_STATEMENTS: tuple[Statement, ...] = (
    Statement(
        word="ambient",
        form='ambient NUMBER;  ambient "COLOUR";',
        doc="The light that is everywhere on what is `lit`: 1 shows it as it is drawn, 0 not at all; or a colour in "
        "quotes. Without it, 0.15 where there are lights.",
        example="new circle ball 0.5 at 0 3 lit;\nambient 0.1;",
        meant=("ambience", "darkness", "night"),
    ),
    Statement(
        word="shadows",
        form="shadows on;  shadows off;",
        doc="Do things cast shadows at all? They do unless this says no.",
        example="new circle ball 0.5 at 0 3 lit;\nnew light at 0 4;\nshadows off;",
        meant=("shadow", "castShadows"),
    ),
)

LIGHT_KINDS: tuple[Kind, ...] = (
    Kind(
        word="light",
        family=LIGHT,
        type="Light",
        doc="A lamp; with `towards` and a place a spot, with `towards` alone a sun. It shines on what is `lit`.",
        example=_WALL + 'new light lamp at 0 3 colour "#ffd9a0" radius 8;',
        meant=("lamp", "spot", "sun", "torch", "lantern", "moon"),
    ),
)

_light = Of((LIGHT,), "new light at 0 3 ")

# fmt: off
LIGHT_PROPERTIES: tuple[Property, ...] = (
    _light("at", "point", "Where it is, in metres; on what it `follows`, counted from there.",
        example="new light at 0 3;", range=PLACE, settable=True, meant=("position", "pos", "place", "location")),
    _light("follows", "name", "The thing that it moves with, which casts no shadow in it.",
        example="new circle ball 0.5 at 0 3 physicsOn;\nnew light follows ball;", option="body",
        meant=("on", "of", "attached")),
    _light("towards", "angle", "Where it shines to: 0 is right, -90 down.", "towards -90", option="direction",
        range=Range(least=-36_000.0, most=36_000.0), settable="angle", meant=("direction",)),
    _light("cone", "angle", "How wide a spot opens.", "towards -90 cone 40", range=Range(least=1.0, most=360.0),
        settable=True, meant=("spread", "opening")),
    _light("softEdge", "number", "The share of a spot's opening, 0 to 1, in which it fades towards its sides.",
        "towards -90 softEdge 0.8", option="edge", range=FRACTION, settable=True, meant=("feather", "blur")),
    _light("colour", "colour", "Its colour.", 'colour "orange"', settable=True, spellings=("color",)),
    _light("temperature", "number", "Kelvin of what glows: a candle 1900, a bulb 2700, noon 5500, the sky 10000.",
        "temperature 2700", range=Range(least=1000.0, most=25_000.0), settable=True, meant=("kelvin", "warmth")),
    _light("intensity", "number", "How bright it is: 1 as bright as its colour.", "intensity 2",
        range=Range(least=0.0, most=1000.0), settable=True, meant=("brightness", "strength", "power", "energy")),
    _light("radius", "length", "How far its light goes.", "radius 8", range=SIZE, settable=True,
        meant=("range", "reach", "distance")),
    _light("softness", "length", "How large what shines is, from its middle to its rim: shadows are as soft.",
        "softness 0.4", option="size", range=NOT_NEGATIVE, settable=True, meant=("size", "soft", "penumbra")),
    _light("falloff", "number", "How fast it fades: 0 not before its end, 1 evenly, 2 as it does unless said.",
        "falloff 1", range=Range(least=0.0, most=60.0), settable=True, meant=("fade", "decay", "attenuation")),
    _light("noShadows", "flag", "It shines through everything.", "noShadows", option="shadows",
        settable="noShadows",
        meant=("shadowless", "unshadowed")),
    _light("texture", "picture", "A picture that it shines through, as a window; its corners are `radius` away.",
        meant=("image", "picture", "cookie", "mask", "slide")),
    _light("angle", "angle", "How far its picture is turned, in degrees against the clock.", "angle 30",
        range=Range(least=-36_000.0, most=36_000.0), meant=("turned", "rotation")),
    _light("static", "flag", "It stands still: what it shows of what stands still is worked out once.",
        "static", settable=True, meant=("baked", "fixed", "still")),
    _light("mask", "whole", "The categories of the things that cast shadows in it, as their sum; without it, all.",
        "mask 2", range=Range(least=0.0, most=MOST_BITS), settable=True, meant=("casters",)),
    _light("out", "flag", "It does not shine, until `set` says `out off`.", "out", option="on", settable="out",
        meant=("off", "dark", "unlit", "idle", "switchedOff", "on")),
)
# fmt: on
