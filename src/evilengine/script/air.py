"""The words of what lies behind, between and before things: backgrounds, planes, particles, and the lens."""

from __future__ import annotations

from typing import Any

from evilengine.script.word import BLENDS, FRACTION, NOT_NEGATIVE, PLACE, SIZE, Kind, Of, Property, Range, Statement

PARTICLES = "particles"
_HERO = "new circle ball 0.5 at 0 3 physicsOn;\n"
_PARALLAX = Range(least=0.0, most=100.0)

AIR_STATEMENTS: tuple[Statement, ...] = (
    Statement(
        word="background",
        form='background "COLOUR";  background "PICTURE" [PROPERTIES];',
        doc="What is behind everything: a colour, or a picture file in the level's folder. Each picture lies in front "
        "of those that were said before it.",
        example='background "midnightblue";',
        meant=("sky", "backdrop"),
    ),
    Statement(
        word="plane",
        form="plane LAYER [PROPERTIES];",
        doc="How all that is on a layer is seen: farther off, in one colour, through fog, out of focus.",
        example='draw circle moon 1 at 5 3 layer -2;\nplane -2 parallax 0.3 fog "#8fa3b840";',
        meant=("layers", "depthLayer", "scenery"),
    ),
    Statement(
        word="lens",
        form="lens PROPERTIES;",
        doc="What is done to the whole picture before text goes over it: glow, colours, darker corners, grain.",
        example='new circle lamp 0.5 at 0 3 colour "white";\nlens bloom 0.6 vignette 0.4;',
        meant=("post", "effects", "filter", "shader", "postprocessing"),
    ),
)

AIR_KINDS: tuple[Kind, ...] = (
    Kind(
        word="particles",
        family=PARTICLES,
        type="Emitter",
        doc="Sparks, smoke, rain: many small things that are seen and not felt.",
        example='new particles fire at 0 -3 rate 100 size 0.6 endSize 0.1 colour "orange" fade "#ff000000" glowing;',
        meant=("emitter", "sparks", "smoke", "rain", "fire", "effect"),
    ),
)

_background = Of(("background",), 'background "hills.png" ')
_plane = Of(("plane",), "plane -2 ")
_lens = Of(("lens",), "lens ")
_particles = Of((PARTICLES,), "new particles sparks rate 50 ")


def _light(word: str, doc: str, shown: str, most: float, **more: Any) -> Property:
    return _lens(word, "number", doc, shown, range=Range(least=0.0, most=most), **more)


# fmt: off
AIR_PROPERTIES: tuple[Property, ...] = (
    _background("parallax", "number",
        "How much of the camera's motion it makes: 1 moves with the world, 0 stays on the screen. It is repeated then.",
        example="plane -2 parallax 0.3;", range=_PARALLAX),
    _background("tall", "length", "How high the picture is; without it, it covers what is seen.",
        option="height", range=SIZE, meant=("height", "size")),
    _background("colour", "colour", "A colour that its own are multiplied with.", spellings=("color",),
        meant=("tint",)),
    _background("layer", "whole", "The layer that it lies in, behind the things of that layer that are made later.",
        range=Range(least=-1000.0, most=1000.0), meant=("z", "order")),
    _background("repeated", "switch", "It is repeated to both sides, as one with a `parallax` is unless told `off`.",
        option="repeat", meant=("repeat", "tiled", "loop", "wrap")),
    _background("lit", "flag", "Lights shine on it, and it is dark where none does."),
    _plane("parallax", "number",
        "How much of the camera's motion it makes: 1 moves with the world, 0 stays on the screen, 2 is before it.",
        "parallax 0.3", range=_PARALLAX, meant=("scroll", "distance")),
    _plane("tint", "colour", "What all its colours are multiplied with; black makes silhouettes.", 'tint "black"',
        meant=("colour", "color", "silhouette")),
    _plane("fog", "colour", "Fog over it and all behind it: a colour, whose alpha is how thick it is.",
        'fog "#8fa3b840"', meant=("mist", "haze")),
    _plane("fogAbove", "colour", "The fog's colour at the top of the picture; `fog` is at the bottom then.",
        'fog "#8fa3b880" fogAbove "#8fa3b800"', option="fog_above"),
    _plane("blur", "number", "How far it and all behind it is out of focus, in points of the screen.", "blur 3",
        range=Range(least=0.0, most=500.0), meant=("soft", "unfocused")),
    _plane("hidden", "switch", "It is not seen, until told `hidden off`.", "hidden", meant=("invisible", "hide")),
    _plane("fogLit", "switch", "Lights fall on its fog, and what stands in their way throws shadows through it.",
        'fog "#8fa3b840" fogLit', option="fog_lit"),
    _plane("shafts", "point", "Where shafts of light come from: what is bright on it or behind shines on, away from "
        "that point, and what is dark does not.", "shafts 5 3", option="shafts.at", range=PLACE,
        meant=("rays", "godRays", "beams")),
    _plane("shaftColour", "colour", "The colour of its shafts of light.", 'shafts 5 3 shaftColour "gold"',
        option="shafts.colour", spellings=("shaftColor",)),
    _plane("shaftStrength", "number", "How bright its shafts of light are; 1 unless said.",
        "shafts 5 3 shaftStrength 0.5", option="shafts.strength", range=Range(least=0.0, most=8.0)),
    _plane("shaftReach", "number", "How long its shafts of light are: 1 reaches all the way from that point.",
        "shafts 5 3 shaftReach 0.5", option="shafts.reach", range=Range(least=0.05, most=1.0)),
    _plane("shaftThreshold", "number", "How bright a thing must be to shine through: 1 is white; 0.5 unless said.",
        "shafts 5 3 shaftThreshold 0.3", option="shafts.threshold", range=Range(least=0.0, most=0.99)),
    _light("bloom", "How much of its light what is bright gives to what is near it.", "bloom 0.6", 3.0,
        meant=("glow", "shine")),
    _light("threshold", "How bright a thing must be to shine: 1 is white; 0.6 unless said.",
        "bloom 0.6 threshold 0.8", 1.0, option="bloom_threshold"),
    _light("exposure", "How bright all light is: 1 as drawn, 2 twice as bright.", "exposure 1.5", 16.0,
        meant=("brightness",)),
    _light("contrast", "How far light and dark are apart: 1 as drawn, 0 one grey.", "contrast 1.2", 4.0),
    _light("saturation", "How colourful it is: 1 as drawn, 0 black and white.", "saturation 0.5", 4.0,
        meant=("colourful", "grey")),
    _lens("tint", "colour", "A colour that all light is multiplied with, as by a filter.", 'tint "#ffe0b0"',
        meant=("colour", "color", "warmth")),
    _light("vignette", "How much darker the corners are: 1 is black.", "vignette 0.4", 1.0, meant=("corners",)),
    _light("filmGrain", "How strong the grain of the film is.", "filmGrain 0.03", 1.0, option="grain",
        meant=("noise", "grain")),
    _lens("filmic", "switch", "Light and dark bend softly, as on film.", "filmic exposure 1.5"),
    _lens("perspective", "switch", "What is far off is small, and things with a `depth` show their sides.",
        "perspective", meant=("3d", "depth")),
    _lens("eyeDistance", "length", "How far the eye is from the world in perspective: what lies so far behind it "
        "is half as large; 12 unless said.", "perspective eyeDistance 20", option="distance",
        range=Range(least=0.1, most=1e6),
        meant=("distance", "eye", "fieldOfView", "fov")),
    _particles("at", "point", "Where they are born, in metres; on what it `follows`, counted from there.",
        example="new particles sparks at 0 2 rate 50;", range=PLACE, settable=True,
        meant=("position", "pos", "place", "location")),
    _particles("follows", "name", "The thing that they come from, wherever it goes.",
        example=_HERO + "new particles trail follows ball rate 30;", option="body", meant=("on", "of", "attached")),
    _particles("rate", "number", "How many are born a second.", example="new particles sparks at 0 2 rate 50;",
        range=NOT_NEGATIVE, settable=True, meant=("count", "perSecond", "amount")),
    _particles("bursting", "index", "How many are born at once, now; without a `rate`, the last of them ends it all.",
        example="new particles sparks at 0 2 bursting 40;", option="burst",
        range=Range(least=0.0, most=1_048_576.0), settable=True, meant=("burst", "explosion", "explode", "puff")),
    _particles("most", "whole", "How many there may be; who comes later is not born. 10000 unless said.", "most 200",
        range=Range(least=1.0, most=1_048_576.0), settable=True, meant=("limit", "max", "maximum")),
    _particles("idle", "flag", "None are born at its rate, until `set` says `idle off`.", "idle", option="running",
        settable="idle", meant=("off", "stopped", "running", "paused")),
    _particles("wide", "length", "How wide the area is that they are born in.", "wide 8", range=SIZE,
        meant=("width", "area")),
    _particles("tall", "length", "How high the area is that they are born in.", "tall 2", range=SIZE,
        meant=("height",)),
    _particles("towards", "angle", "Which way they fly: 0 is right, 90 up, as they do unless said.", "towards 180",
        option="direction", range=Range(least=-36_000.0, most=36_000.0), settable=True, meant=("direction", "angle")),
    _particles("cone", "angle", "How wide they fan out; 360 is all ways.", "cone 60",
        range=Range(least=0.0, most=360.0), settable=True, meant=("spread", "fan")),
    _particles("flying", "span", "How fast they fly off, in metres a second, or the least and the most; 1 unless said.",
        "flying 2 5", option="speed", measure="speed", range=Range(least=0.0, most=10_000.0), settable=True,
        meant=("speed", "velocity", "force")),
    _particles("lasting", "span", "How long each is there, or the least and the most; 1 second unless said.",
        "lasting 0.5 2", option="life", measure="time", range=Range(least=0.01, most=10_000.0), settable=True,
        meant=("life", "lifetime", "duration", "age")),
    _particles("size", "length", "How large each is.", "size 0.3", range=SIZE, meant=("radius", "scale")),
    _particles("endSize", "length", "How large each is at its end.", "size 0.3 endSize 1.5", option="end_size",
        range=Range(least=0.0, most=10_000.0)),
    _particles("varies", "number", "How much smaller some are: 0 to 1.", "varies 0.5", option="size_varies",
        range=FRACTION),
    _particles("colour", "colour", "Their colour.", 'colour "orange"', spellings=("color",)),
    _particles("fade", "colour", "The colour that they turn to; with an alpha of 00 they fade away.",
        'colour "orange" fade "#ff000000"', meant=("endColour", "endColor", "fadeTo")),
    _particles("gravityScale", "number", "How strongly gravity pulls on them: 1 as usual, 0 not at all, -1 upwards.",
        "gravityScale -0.2", option="gravity_scale", range=Range(least=-1000.0, most=1000.0), settable=True),
    _particles("drag", "number", "How fast they take on the speed of the breeze.", "drag 1 breeze 3 0",
        range=Range(least=0.0, most=1000.0), settable=True),
    _particles("breeze", "direction", "How fast the air moves, to the right and up; it is felt by `drag`.",
        "drag 1 breeze 3 0", option="wind", range=Range(least=-1000.0, most=1000.0), settable=True, meant=("wind",)),
    _particles("spin", "spin", "How fast those with a texture turn, in degrees a second.",
        'texture "leaf.png" spin 90', range=Range(least=-36_000.0, most=36_000.0)),
    _particles("texture", "picture", "A picture in place of round specks.", meant=("image", "picture", "sprite")),
    _particles("stretch", "time", "Draws each as long as its way in that many seconds: sparks, rain.", "stretch 0.05",
        range=Range(least=0.0, most=10.0), meant=("streak", "trail")),
    _particles("lit", "flag", "They take the light of where they are.", "lit", settable=True, meant=("shaded",)),
    _particles("blend", "choice", "How they meet what is behind: they cover it, add light to it, multiply with it as "
        "soot does, or brighten it and never burn out.", "blend screen", choices=BLENDS, settable=True,
        meant=("blending", "mix", "mode", "blendMode")),
    _particles("glowing", "flag", "They add light to what is behind, as fire does: `blend add`.", "glowing",
        meant=("glow", "additive", "shining")),
    _particles("sharp", "flag", "They have a clear edge.", "sharp", option="soft", meant=("hard", "disc")),
    _particles("bouncing", "flag", "They run into things, and bounce off.", "bouncing", option="collide",
        meant=("solid", "colliding", "collides")),
    _particles("restitution", "number", "How well they bounce off: 0 not at all, 1 as fast as they came; 0.3 unless "
        "said.", "bouncing restitution 0.6", option="bounce", range=FRACTION, settable=True,
        meant=("bounce", "bounciness", "bouncy")),
    _particles("friction", "number", "What slows those that slide along a thing; 0.4 unless said.",
        "bouncing friction 1", range=Range(least=0.0, most=10.0), settable=True, meant=("grip",)),
    _particles("ending", "flag", "They end where they touch a thing.", "bouncing ending", option="dies",
        meant=("dying", "dies")),
    _particles("layer", "whole", "They lie over the things of this layer.", "layer 2",
        range=Range(least=-1000.0, most=1000.0), settable=True, meant=("depth", "z", "order")),
)
# fmt: on
