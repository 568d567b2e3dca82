"""The words of characters: what they are, what they can do, and where they climb."""

from __future__ import annotations

from evilengine.script.word import NOT_NEGATIVE, Kind, Of, Property, Range, Size

TELLINGS = {"walk": "move", "climb": "climb", "jump": "jump", "letGo": "let_go", "drop": "drop"}
"""What `tell` says -> the engine's method."""
AXES = ("walk", "climb")
"""Those that take a number."""
KEYS = ("left", "right", "up", "down", "jump")
"""What `drive` gives keys to."""
_HERO = "new character hero 0.6 1.5 at 0 1 "

CHARACTER_KINDS: tuple[Kind, ...] = (
    Kind(
        word="character",
        family="character",
        type="Capsule",
        sizes=(Size(name="width"), Size(name="height")),
        doc="Someone who walks, jumps, climbs and pushes: `drive` gives it to the player, `tell` steers it without.",
        example="new character hero 0.6 1.5 at 0 1 jumpHeight 2.5;\ndrive hero;",
        meant=("hero", "player", "person", "man", "actor"),
    ),
    Kind(
        word="ladder",
        family="ladder",
        type="Area",
        sizes=(Size(name="width"), Size(name="height")),
        doc="An area where characters climb: those named by `for`, or all that there are. Draw what it looks like.",
        example=_HERO[:-1] + ";\nnew ladder 0.8 4 at 3 2 for hero;\ndraw rectangle 0.8 4 at 3 2 layer -1;",
        meant=("stairs", "climbable", "vine"),
    ),
)

_able = Of(("character",), _HERO)
_RATE = Range(above=0.0, most=10_000.0)

# fmt: off
CHARACTER_PROPERTIES: tuple[Property, ...] = (
    _able("walkSpeed", "number", "How fast it walks, in metres a second; 5 unless said.", "walkSpeed 7", option="speed",
        range=Range(least=0.0, most=1000.0), settable=True, part="character", meant=("speed", "velocityX", "runSpeed")),
    _able("acceleration", "number", "How soon it walks that fast, in metres a second each second; 60 unless said.",
        "acceleration 30", range=_RATE, settable=True, part="character", meant=("accel",)),
    _able("deceleration", "number", "How soon it stands again; 60 unless said.", "deceleration 20", range=_RATE,
        settable=True, part="character", meant=("brake", "decel")),
    _able("airAcceleration", "number", "As `acceleration`, in the air; 30 unless said.", "airAcceleration 10",
        option="air_acceleration", range=_RATE, settable=True, part="character", meant=("airControl",)),
    _able("airDeceleration", "number", "As `deceleration`, in the air; 10 unless said.", "airDeceleration 2",
        option="air_deceleration", range=_RATE, settable=True, part="character"),
    _able("jumpHeight", "length", "How high it jumps while the key is held; 2 metres unless said.", "jumpHeight 2.5",
        option="jump_height", range=Range(least=0.0, most=1000.0), settable=True, part="character",
        meant=("jump", "jumpSpeed", "jumpPower", "jumpForce")),
    _able("jumpCut", "number", "How much of its speed upwards it keeps when the key is let go early; 0.4 unless said.",
        "jumpCut 0.5", option="jump_cut", range=Range(least=0.0, most=1.0), settable=True, part="character"),
    _able("airJumps", "whole", "How often it may jump again before it lands; 0 unless said.", "airJumps 1",
        option="air_jumps", range=Range(least=0.0, most=1000.0), settable=True, part="character",
        meant=("doubleJump", "jumps")),
    _able("coyoteTime", "time", "How long after an edge it may still jump; 0.1 seconds unless said.", "coyoteTime 0.2",
        option="coyote_time", range=Range(least=0.0, most=10.0), settable=True, part="character", meant=("coyote",)),
    _able("jumpBuffer", "time", "How long before it lands a jump may be asked for; 0.1 seconds unless said.",
        "jumpBuffer 0.2", option="jump_buffer", range=Range(least=0.0, most=10.0), settable=True, part="character",
        meant=("buffer",)),
    _able("gravityScale", "number", "How strongly gravity pulls on it; 2 unless said, for a crisp jump.",
        "gravityScale 1", option="gravity_scale", range=Range(least=0.0, most=1000.0), settable=True, part="character",
        meant=("gravityFactor",)),
    _able("fallSpeed", "number", "How fast it falls at most, in metres a second; 25 unless said.", "fallSpeed 15",
        option="fall_speed", range=Range(above=0.0, most=1000.0), settable=True, part="character",
        meant=("maxFall", "terminalVelocity")),
    _able("maxSlope", "angle", "The steepest slope that it walks on, in degrees; 50 unless said.", "maxSlope 40",
        option="max_slope", range=Range(least=0.0, most=89.0), settable=True, part="character", meant=("slope",)),
    _able("stepHeight", "length", "How high a step it walks onto without a jump; 0.3 metres unless said.",
        "stepHeight 0.5", option="step_height", range=Range(least=0.0, most=1000.0), settable=True, part="character",
        meant=("stairHeight",)),
    _able("climbSpeed", "number", "How fast it climbs ladders, in metres a second; 3 unless said.", "climbSpeed 4",
        option="climb_speed", range=Range(least=0.0, most=1000.0), settable=True, part="character"),
    _able("pushForce", "number", "How hard it pushes, in newtons; 40 for each kilogram unless said.", "pushForce 100",
        option="push_force", range=NOT_NEGATIVE, settable=True, part="character", meant=("strength", "power", "force")),
    _able("velocity", "direction", "Throws it: `set` alone knows it, since a new character stands.",
        example=_HERO[:-1] + ';\non key "x" { set hero velocity 0 12; }', range=Range(least=-1000.0, most=1000.0),
        settable=True, part="character", meant=("throw", "launch")),
)
# fmt: on
