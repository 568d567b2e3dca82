"""The words of smoke and fire: where gas is, what it is like, how it looks, and where it comes from."""

from __future__ import annotations

from typing import Any

from evilengine.script.word import PLACE, SIZE, Kind, Of, Property, Range, Size

SMOKE = "smoke"
SOURCE = "source"
FLUIDS = (SMOKE, SOURCE)
"""What `destroy` and `set` know of them."""
MOST_CELLS = 1024  # along a side; 16 million numbers of one smoke are enough for one level
MAX_SMOKES = 16  # that a level keeps alive; each is stepped whole, so a forgotten `every` stays playable
_AIR = "new smoke air 8 6 cells 32;\n"

FLUID_KINDS: tuple[Kind, ...] = (
    Kind(
        word="smoke",
        family=SMOKE,
        type="Smoke",
        sizes=(Size(name="width"), Size(name="height")),
        doc="An area of air, clear at first, for smoke and fire: it flows round things, pushes them and is pushed. "
        "Walls are all round it, unless it says `open`. A `source` fills it.",
        example="new smoke air 8 6 at 0 3 cells 128 openTop;\nnew source in air radius 0.3 rate 2 temperature 1;",
        meant=("gas", "fog", "cloud", "fire", "flame", "flames", "air"),
    ),
    Kind(
        word="source",
        family=SOURCE,
        type="Source",
        needs=("in",),
        doc="Where smoke and fire come from: a circle of a `radius`, or an area `wide` and `tall`. One with a `rate` "
        "less than 0 takes smoke away.",
        example=_AIR + "new source flame in air at 0 -2 radius 0.3 fuel 3 temperature 1;",
        meant=("torch", "chimney", "sink", "vent", "burner", "inlet"),
    ),
)

_smoke = Of((SMOKE,), "new smoke air 8 6 cells 32 ")
_source = Of((SOURCE,), _AIR + "new source flame in air radius 0.3 ")
_MUCH = Range(least=0.0, most=10_000.0)


def sides_of(of: Of, what: str) -> tuple[Property, ...]:
    """The flags that open one side each of a fluid's box."""
    sides = {"openTop": "top", "openBottom": "bottom", "openLeft": "left side", "openRight": "right side"}
    return tuple(of(word, "flag", f"{what} {side}.", word) for word, side in sides.items())


def _gas(word: str, doc: str, shown: str, **more: Any) -> Property:
    return _smoke(word, "number", doc, shown, **{"range": _MUCH, "settable": True, **more})


# fmt: off
FLUID_PROPERTIES: tuple[Property, ...] = (
    _smoke("at", "point", "Where its middle is, in metres. Without it, `0 0`.", "at 0 3", range=PLACE,
        meant=("position", "pos", "place", "location")),
    _smoke("cells", "whole", "How fine it is: so many square cells along its longer side; 256 unless said.",
        example="new smoke air 8 6 cells 128;", range=Range(least=2.0, most=MOST_CELLS),
        meant=("resolution", "grid", "size", "detail")),
    *sides_of(_smoke, "Gas may leave and enter by its"),
    _smoke("open", "flag", "It has no walls: gas may leave and enter by all four sides.", "open",
        meant=("openSides", "openAll", "noWalls", "unbounded")),
    _gas("buoyancy", "How strongly heat rises: at a temperature of 1, so many times as things fall; 0.5 unless said.",
        "buoyancy 0.8", range=Range(least=-10_000.0, most=10_000.0), meant=("rise", "lift")),
    _gas("vorticity", "How strongly small whirls are kept alive; 0 unless said.", "vorticity 3",
        range=Range(least=0.0, most=1000.0), meant=("swirl", "whirls", "turbulence", "curl")),
    _gas("viscosity", "How thick it is, in square metres a second; 0 unless said.", "viscosity 0.01",
        meant=("thick", "thickness")),
    _gas("diffusion", "How fast smoke spreads by itself, in square metres a second; 0 unless said.", "diffusion 0.01",
        meant=("spread", "spreading")),
    _gas("cooling", "The share of its heat that is lost in a second; 0.3 unless said.", "cooling 1"),
    _gas("vanishing", "The share of its smoke that is lost in a second; 0 unless said.", "vanishing 0.1",
        option="fade", meant=("fade", "dissipation", "fading", "decay")),
    _gas("burning", "The share of its fuel that burns in a second; 3 unless said.", "burning 2", meant=("burn",)),
    _gas("heat", "How hot a unit of fuel burns; 2 unless said.", "heat 3"),
    _gas("soot", "How much smoke a unit of fuel leaves; 0.3 unless said.", "soot 0.1", meant=("ash",)),
    _gas("weight", "How hard it pushes things, in kilograms a square metre; 0.1 unless said.", "weight 1",
        meant=("mass", "density", "push")),
    _smoke("breeze", "direction", "How fast it is drawn along, to the right and up: wind.", "breeze 2 0", option="wind",
        range=Range(least=-1000.0, most=1000.0), settable=True, meant=("wind", "velocity", "current")),
    _gas("breezePull", "The share of the difference to its breeze that is made up in a second; 0.5 unless said.",
        "breeze 2 0 breezePull 2", option="wind_pull", meant=("windPull",)),
    _smoke("slippery", "flag", "Gas that is thick slips along its walls.", "viscosity 0.01 slippery", option="stick",
        meant=("slip", "frictionless")),
    _smoke("fine", "flag", "Whirls live far longer, for nearly twice the work.", "fine", option="quality",
        meant=("quality", "highQuality")),
    _smoke("colour", "colour", "The colour of its smoke; that of a source may be another.", 'colour "slategrey"',
        spellings=("color",), meant=("tint", "fill")),
    _smoke("shades", "colours", "Its colours from thin to thick, two or more; `colour`, ever less clear, unless said.",
        'shades "#00000000" "#66666688" "#ddddddee"', option="ramp", meant=("ramp", "colours", "colors", "gradient")),
    _smoke("fireShades", "colours", "The colours of its heat from cold to hot; black, red, orange, white unless said.",
        'fireShades "black" "indigo" "cyan" "white"', option="fire", meant=("fire", "fireRamp", "flames")),
    _smoke("opacity", "number", "How much of its shades a smoke of 1 shows; 2 unless said.", "opacity 4",
        range=Range(least=0.01, most=100.0), meant=("alpha", "thick")),
    _smoke("glow", "number", "How bright its fire is, on what is `lit` round it too; 1 unless said, 0 for none.",
        "glow 2", range=Range(least=0.0, most=16.0), meant=("brightness", "intensity", "shine")),
    _smoke("lightRadius", "length", "How far its fire lights what is round it; 8 metres unless said, 0 for not at all.",
        "lightRadius 4", option="light_radius", range=Range(least=0.0, most=10_000.0), meant=("radius", "reach")),
    _smoke("shadow", "number", "How much of a lamp's light a metre of a smoke of 1 takes away; 1 unless said, 0 for no "
        "shadow.", "shadow 0.5", range=Range(least=0.0, most=100.0), meant=("shadows", "shade", "darkness")),
    _smoke("unlit", "flag", "Lights do not fall on it: it is as bright in the dark.", "unlit", option="lit",
        meant=("unshaded", "flat")),
    _smoke("layer", "whole", "It lies over the things of this layer.", "layer 2",
        range=Range(least=-1000.0, most=1000.0), meant=("depth", "z", "order")),
    _source("in", "name", "The smoke that it fills.", example=_AIR + "new source in air radius 0.3 rate 2;",
        option="smoke", of=(SMOKE,), meant=("into", "of", "inside")),
    _source("at", "point", "Where it is, in metres; on what it `follows`, counted from there.", "at 0 -2 rate 2",
        range=PLACE, meant=("position", "pos", "place", "location")),
    _source("follows", "name", "The thing that it goes along with; it ends with that thing.",
        example=_AIR + "new circle lamp 0.2 at 0 2 physicsOn;\nnew source in air radius 0.2 follows lamp rate 1;",
        option="body", meant=("on", "attached", "body")),
    _source("radius", "length", "It is a circle, so far from its middle to its rim.", "rate 2", range=SIZE,
        meant=("size",)),
    _source("wide", "length", "How wide its area is, which is a rectangle.",
        example=_AIR + "new source in air wide 4 tall 0.5 rate 1;", range=SIZE, meant=("width",)),
    _source("tall", "length", "How high its area is.", example=_AIR + "new source in air wide 4 tall 0.5 rate 1;",
        range=SIZE, meant=("height",)),
    _source("angle", "angle", "How far its area is turned, in degrees against the clock.",
        example=_AIR + "new source in air wide 4 tall 0.5 angle 30 rate 1;", meant=("turned", "rotation")),
    _source("rate", "number", "How much smoke comes in a second; less than 0 takes that share of it away.", "rate 2",
        range=Range(least=-10_000.0, most=10_000.0), settable=True, meant=("amount", "density", "strength")),
    _source("temperature", "number", "How hot it makes what is there; 1 rises well, and glows.", "temperature 1",
        range=Range(least=-1000.0, most=1000.0), settable=True, meant=("heat", "hot", "warmth")),
    _source("fuel", "number", "How much fuel comes in a second, which burns by and by: fire.", "fuel 3 temperature 1",
        range=_MUCH, settable=True, meant=("gas", "flame", "fire")),
    _source("velocity", "direction", "How fast it blows to the right and up, in metres a second.",
        "rate 2 velocity 0 3", range=Range(least=-1000.0, most=1000.0), settable=True,
        meant=("speed", "wind", "blows", "flow", "breeze")),
    _source("colour", "colour", "The colour of its smoke, if not that of all.", 'rate 2 colour "orange"',
        spellings=("color",), meant=("tint",)),
    _source("idle", "flag", "It gives nothing, until `set` says `idle off`.", "rate 2 idle", option="running",
        settable="idle", meant=("off", "stopped", "running", "paused")),
)
# fmt: on
