"""The words that follow what is made, each with its value."""

from __future__ import annotations

from evilengine.script.air import AIR_PROPERTIES
from evilengine.script.characters import CHARACTER_PROPERTIES
from evilengine.script.filming import CAMERA_PROPERTIES
from evilengine.script.fluids import FLUID_PROPERTIES
from evilengine.script.joints import JOINT_PROPERTIES
from evilengine.script.lighting import LIGHT_PROPERTIES
from evilengine.script.meeting import MEETING
from evilengine.script.waters import WATER_PROPERTIES
from evilengine.script.word import FRACTION, NOT_NEGATIVE, PLACE, SIZE, Of, Property, Range

_placed = Of(("body", "drawing", "character", "medium", "ladder"))
_thing = Of(("body",), "new circle ball 0.5 at 0 3 physicsOn ")
_any = Of(("body", "character"), "new circle ball 0.5 at 0 3 physicsOn ")
_shape = Of(("body", "drawing"))
_look = Of(("body", "drawing", "character"))
_spring = Of(("spring",), "new circle ball 0.5 at 0 3 physicsOn;\nnew spring from ball to 0 8 ")
_force = Of(("force", "drag", "ladder"))
_medium = Of(("medium",), "new medium 8 2 at 0 -3 ")
_text = Of(("text",), 'text "Hello" at 20 20 ')
_sound = Of(("sound",), 'play "thud.ogg" ')
_heard = Of(("sound", "music"), 'play "thud.ogg" ')
_music = Of(("music",), 'music "wind.ogg" ')

# fmt: off
PROPERTIES: tuple[Property, ...] = (
    _placed("at", "point",
        "Where it is, in metres: to the right and up from the origin. Without it, in the middle: `0 0`.",
        example="new circle 0.5 at 2 3;", range=PLACE, settable="position",
        meant=("position", "pos", "place", "location")),
    _sound("at", "place",
        "Where it is heard from: a point, or a thing that it goes along with. Without it, from everywhere.", "at 3 0",
        range=PLACE, meant=("position", "pos", "place", "location", "on")),
    _heard("volume", "number", "How loud: 1 is as recorded, 0 silent.", "volume 0.5", range=Range(least=0.0, most=8.0),
        meant=("loudness", "gain", "loud")),
    _sound("pitch", "number", "How high: 2 is an octave up and twice as fast, 0.5 an octave down.", "pitch 0.8",
        range=Range(least=0.0625, most=4.0), meant=("tone", "rate", "speed")),
    _music("fade", "time", "Seconds in which it takes over from the music before it; 1 is usual.", "fade 3",
        range=Range(least=0.0, most=120.0), meant=("crossfade", "blend")),
    _shape("angle", "angle", "How far it is turned, in degrees against the clock.",
        example="new rectangle 2 1 at 0 4 angle 30;", settable=True, meant=("rotation", "rotate", "turn", "rotated")),
    _thing("physicsOn", "flag",
        "It falls, rolls and can be pushed. Without it a thing stands still, and others collide with it.",
        example="new circle 0.5 at 0 3 physicsOn;", option="kind",
        meant=("physics", "dynamic", "solid", "movable", "physicson")),
    _thing("moving", "flag", "It keeps its `velocity` and `spin` whatever it meets, like a lift or a mill.",
        example="new rectangle lift 3 0.3 at 0 -2 moving velocity 0 1;", option="kind",
        meant=("kinematic", "moves", "motion")),
    _thing("velocity", "direction", "How fast it moves to the right and up, in metres a second.", "velocity 3 0",
        range=Range(least=-1000.0, most=1000.0), settable=True, meant=("speed", "vel")),
    _thing("spin", "spin", "How fast it turns, in degrees a second against the clock.", "spin 90",
        option="angular_velocity", range=Range(least=-36_000.0, most=36_000.0), settable=True,
        meant=("angularVelocity", "rotationSpeed", "spinning")),
    _any("touchable", "flag", "Fingers and the mouse can drag it.", "touchable", settable=True,
        meant=("draggable", "drag", "grab", "touch", "clickable")),
    *MEETING,
    _any("density", "number", "How heavy its material is; water is 1, and so is everything that says nothing.",
        "density 3", range=Range(above=0.0, most=1_000_000.0)),
    _any("mass", "mass", "How heavy it is as a whole, instead of `density`.", "mass 2",
        range=Range(above=0.0, most=1_000_000.0), meant=("weight",)),
    _any("friction", "number", "How rough it is: 0 slides like ice, 1 grips like rubber.", "friction 0.6",
        range=Range(least=0.0, most=10.0), settable=True, meant=("grip", "rough", "roughness")),
    _thing("restitution", "number", "How well it bounces: 0 not at all, 1 back to where it fell from.",
        "restitution 0.8", range=FRACTION, settable=True, meant=("bounce", "bounciness", "bouncy", "elasticity")),
    _thing("damping", "number", "How much of its speed it keeps each second: 1 keeps all, 0.5 half.", "damping 0.5",
        range=FRACTION, settable=True),
    _thing("spinDamping", "number", "How much of its spin it keeps each second: 1 keeps all, 0.5 half.",
        "spin 360 spinDamping 0.5", option="angular_damping", range=FRACTION, settable=True,
        meant=("angularDamping", "rotationDamping")),
    _thing("drag", "number", "How strongly a medium that it passes through holds it back: 1 as usual, 0 not at all.",
        "drag 2", range=NOT_NEGATIVE, settable=True),
    _thing("gravityScale", "number", "How strongly gravity pulls on it: 1 as usual, 0 not at all, -1 upwards.",
        "gravityScale 0.2", option="gravity_scale", range=Range(least=-1000.0, most=1000.0), settable=True,
        meant=("float", "floating", "gravityFactor")),
    _thing("bullet", "flag", "It is so fast that extra care keeps it from passing through thin things.",
        example="new circle 0.05 at -7 0 physicsOn bullet velocity 200 0;", meant=("fast", "ccd")),
    _any("tag", "tag", "A word that many things may share. Events take a tag in quotes in place of a name.",
        example='new circle 0.3 at 1 2 tag "coin";\nnew circle ball 0.5 at 0 3 physicsOn;\n'
        'on collide ball "coin" { destroy other; }', settable=True, meant=("group", "class", "label", "team")),
    _look("colour", "colour", 'Its colour: a name such as `red`, or `"#rrggbb"` in quotes.',
        example='new circle 0.5 at 0 3 colour "#cc9966";', settable=True, part="drawings", spellings=("color",),
        meant=("fill", "tint", "paint", "col")),
    _look("texture", "picture", "A picture drawn on it: the name of a file in the level's folder.", settable=True,
        part="drawings", meant=("image", "picture", "sprite", "skin", "img")),
    _look("frames", "spot", "How many frames its picture has side by side and one below another; they take turns.",
        meant=("sheet", "animation", "spritesheet", "columns")),
    _look("fps", "number", "How many of its frames are shown in a second; 12 is usual.",
        range=Range(least=0.001, most=1000.0), meant=("framerate", "frameRate")),
    _look("tile", "length", "How wide and high its picture is, which is laid again and again.", range=SIZE,
        meant=("tiled", "tiles")),
    _look("layer", "whole", "What is drawn over what: a whole number; higher is in front, 0 is usual.",
        example="new circle 0.5 at 0 3 layer 2;", range=Range(least=-1000.0, most=1000.0), settable=True,
        part="drawings", meant=("zIndex", "z", "order")),
    _look("lit", "flag", "Lights shine on it, and it is dark where none does.",
        example="new circle 0.5 at 0 3 lit;", settable=True, part="drawings",
        meant=("shaded", "dark")),
    _look("behind", "length", "How far it is behind its layer, with `lens perspective`; less than 0 is before it.",
        example="lens perspective;\nnew rectangle 1 1 at 2 1 behind 4;", range=Range(least=-10_000.0, most=10_000.0),
        settable=True, part="drawings", meant=("farther", "away")),
    _look("depth", "length", "How far it reaches back, with `lens perspective`: its sides are seen.",
        example="lens perspective;\nnew rectangle 1 1 at 2 1 depth 0.5;", range=Range(least=0.0, most=10_000.0),
        settable=True, part="drawings", meant=("deep", "extrude", "sides")),
    _look("normalMap", "picture", "A picture of which way each point of it faces, so that lights show bumps.",
        option="normal_map", meant=("normals", "bumps", "bumpMap")),
    _look("glowMap", "picture", "A picture of what of it shines by itself.", option="glow_map",
        meant=("emissive", "emission")),
    _look("glow", "number", "How strongly it shines by itself: 1 as its picture or its colour says, 0 not at all.",
        example="new circle coal 0.2 at 0 3 lit glow 1;", range=Range(least=0.0, most=64.0), settable=True,
        part="drawings", meant=("shine", "shines", "luminous")),
    _look("hidden", "flag", "It is there but not seen.", example="new rectangle 4 1 at 0 -2 hidden;", settable=True,
        part="drawings", meant=("invisible", "hide", "unseen")),
    _shape("thickness", "length", "How thick the walls of a room are.", example="new walls 15 8 thickness 0.5;",
        range=SIZE, part="shape", meant=("thick",)),
    _shape("rounding", "length", "The radius of its corners that point outward; its sides stay where they are.",
        example="new rectangle crate 2 1 at 0 4 rounding 0.2 physicsOn;", range=NOT_NEGATIVE, part="shape",
        meant=("rounded", "roundness", "cornerRadius", "smooth")),
    _shape("hole", "corners", "A hole in a polygon, with these corners; each has a `hole` of its own.",
        example="new polygon frame 0 0, 4 0, 4 3, 0 3 hole 0.5 0.5, 3.5 0.5, 3.5 2.5, 0.5 2.5 at -2 -2;", part="shape",
        meant=("holes", "gap", "window", "opening", "cutout")),
    _shape("closed", "flag", "A chain whose last point is joined to its first.",
        example="new chain -4 0, 0 -3, 4 0, 0 3 closed;", option="loop", part="shape", meant=("loop", "loops", "ring")),
    _spring("from", "name", "The thing that the spring pulls on.",
        example="new circle ball 0.5 at 0 3 physicsOn;\nnew spring from ball to 0 8;"),
    _spring("to", "place", "The other end: a point, or the name of another thing.",
        example="new circle ball 0.5 at 0 3 physicsOn;\nnew circle hook 0.1 at 0 8;\nnew spring from ball to hook;",
        range=PLACE),
    _spring("stiffness", "number", "How hard it pulls for each metre of stretch.", "stiffness 20",
        range=Range(above=0.0, most=1_000_000.0), meant=("strength", "hardness", "k")),
    _spring("length", "length", "How long it is when nothing pulls on it.", "length 2", option="rest_length",
        range=Range(least=0.0, most=10_000.0), meant=("restLength", "rest")),
    _spring("damping", "number", "How soon it stops swinging; 0 never stops.", "damping 0.5", range=NOT_NEGATIVE),
    _force("for", "names", "The things that it acts on; without it, everything.",
        example="new circle a 0.5 at 0 3 physicsOn;\nnew circle b 0.5 at 2 3 physicsOn;\nnew force 2 0 for a b;",
        meant=("of", "target", "targets")),
    _medium("drag", "number", "How strongly it holds back what moves through it: 0 is empty space, 4 is thick.",
        "drag 4", option="linear", range=NOT_NEGATIVE, meant=("thick", "viscosity")),
    _medium("density", "number",
        "How strongly it lifts: as water at 1, so that what is less dense floats; not at all without it.",
        example="new medium lake 8 2 at 0 -3 density 1 drag 4;", range=NOT_NEGATIVE, meant=("buoyancy", "lift")),
    _medium("velocity", "direction",
        "How fast it moves itself to the right and up, in metres a second: wind, or a current.",
        example="new medium draught 2 6 at 0 0 velocity 0 9 drag 2;", range=Range(least=-1000.0, most=1000.0),
        meant=("speed", "wind", "flow", "current")),
    _text("at", "spot", "Where it stands on the screen: points to the right and down from the top left corner.",
        example='text "Hello" at 20 20;', range=Range(least=-10_000.0, most=10_000.0), settable=True,
        meant=("position", "pos", "place", "location")),
    _text("size", "number", "How tall its letters are, in points; 16 is usual.", "size 32",
        range=Range(least=4.0, most=400.0), settable=True, meant=("height", "fontSize", "font")),
    _text("colour", "colour", "The colour of its letters.", 'colour "gold"', settable=True, spellings=("color",),
        meant=("fill", "tint", "paint", "col")),
    _text("width", "number", "How wide its lines may be, in points; longer ones break.", "width 200",
        range=Range(above=0.0, most=10_000.0), settable=True, meant=("wrap", "maxWidth")),
    *CHARACTER_PROPERTIES,
    *AIR_PROPERTIES,
    *CAMERA_PROPERTIES,
    *LIGHT_PROPERTIES,
    *FLUID_PROPERTIES,
    *WATER_PROPERTIES,
    *JOINT_PROPERTIES,
)
# fmt: on
