"""The words of joints: what ties two things together, and how."""

from __future__ import annotations

from typing import Any

from evilengine.script.word import NOT_NEGATIVE, PLACE, Kind, Of, Property, Range

_DOOR = "new rectangle wall 1 1;\nnew rectangle door 2 0.2 at 1 0 physicsOn;\n"
_BALL = "new circle hook 0.1 at 0 4;\nnew circle ball 0.4 at 2 2 physicsOn;\n"
_LIFT = "new rectangle tower 1 1;\nnew rectangle lift 2 0.2 at 2 0 physicsOn;\n"
_CAR = "new rectangle car 2 0.5 at 0 1 physicsOn;\nnew circle tyre 0.4 at -0.8 0.6 physicsOn;\n"
_WHEELS = "new circle large 2 at -2 0 physicsOn;\nnew circle small 1 at 1 0 physicsOn;\n"
_BLOCKS = "new rectangle left 1 1 at -2 0 physicsOn;\nnew rectangle right 1 1 at 2 0 physicsOn;\n"
_TURN = Range(least=-100_000.0, most=100_000.0)  # degrees, or degrees a second


def _tie(word: str, joint: str, doc: str, example: str, needs: tuple[str, ...] = (), **more: Any) -> Kind:
    """A joint of evil.joints; its properties are a family of their own."""
    return Kind(
        word=word, family=word, type=f"joints.{joint}", doc=doc, example=example, needs=("from", "to", *needs), **more
    )


def _of(families: tuple[str, ...], word: str, takes: str, doc: str, example: str, **more: Any) -> Property:
    return Of(families)(word, takes, doc, example=example, **more)


# fmt: off
JOINT_KINDS: tuple[Kind, ...] = (
    _tie("hinge", "Hinge",
        "A pin through two things: what comes after `to` turns about it, as far as `least` and `most`.",
        _DOOR + "new hinge from wall to door at 0 0 least -40 most 40;", needs=("at",),
        meant=("pivot", "pin", "joint", "revolute")),
    _tie("weld", "Weld", "Makes two things one; with a `frequency` it bends.", _DOOR + "new weld from wall to door;",
        meant=("glue", "fix")),
    _tie("rod", "Distance",
        "Keeps two things as far apart as they are, or `length`; with `stiffness` it is a spring between them.",
        _BALL + "new rod from hook to ball;", meant=("bar", "stick", "distance")),
    _tie("rope", "Rope", "Keeps two things no further apart than they are, or `length`.",
        _BALL + "new rope from hook to ball length 3;", meant=("string", "tether")),
    _tie("slider", "Slider", "Lets the thing after `to` slide along a line of the other, and not turn.",
        _LIFT + "new slider from tower to lift axis 0 1 least 0 most 3 slideSpeed 1;",
        meant=("rail", "prismatic", "piston")),
    _tie("axle", "Wheel",
        "A wheel, after `to`, on a thing with a springy suspension along `axis`; a motor by `motorSpeed`.",
        _CAR + "new axle from car to tyre motorSpeed -300;", meant=("wheel", "suspension")),
    _tie("gear", "Gear",
        "Ties the turning of two things: the one after `to` turns `ratio` times for each turn of the other.",
        _WHEELS + "new gear from large to small ratio -2;", meant=("cog", "teeth")),
    _tie("pulley", "Pulley",
        "A rope from one thing over two points to the other: what the one side loses, the other gains.",
        _BLOCKS + "new pulley from left to right over -2 4 across 2 4;", needs=("over", "across"),
        meant=("hoist", "tackle")),
)
JOINTS = tuple(kind.word for kind in JOINT_KINDS)

JOINT_PROPERTIES: tuple[Property, ...] = (
    _of(JOINTS, "from", "name", "The first of the two things that it ties.", _DOOR + "new weld from wall to door;",
        option="a"),
    _of(JOINTS, "to", "name", "The second: what turns, slides or is driven against the first.",
        _DOOR + "new weld from wall to door;", option="b"),
    _of(("hinge", "weld", "slider", "axle"), "at", "point",
        "Where it holds the two; without it, at the second thing (of a weld, halfway).",
        _DOOR + "new hinge from wall to door at 0 0;", range=PLACE),
    _of(("slider", "axle"), "axis", "spot", "The way along which it slides or springs: to the right and up.",
        _LIFT + "new slider from tower to lift axis 0 1;", meant=("direction", "along")),
    _of(("hinge",), "least", "angle",
        "How far it may turn to the right, from where it stands at first: -40 for 40 degrees.",
        _DOOR + "new hinge from wall to door at 0 0 least -40 most 40;", range=_TURN,
        meant=("min", "minimum", "lower")),
    _of(("hinge",), "most", "angle", "How far it may turn to the left.",
        _DOOR + "new hinge from wall to door at 0 0 least -40 most 40;", range=_TURN,
        meant=("max", "maximum", "upper")),
    _of(("slider", "axle"), "least", "length", "How far back it may slide from where it is at first.",
        _LIFT + "new slider from tower to lift least 0 most 3;", range=PLACE, meant=("min", "minimum", "lower")),
    _of(("slider", "axle"), "most", "length", "How far it may slide from where it is at first.",
        _LIFT + "new slider from tower to lift least 0 most 3;", range=PLACE, meant=("max", "maximum", "upper")),
    _of(("hinge", "axle"), "motorSpeed", "spin", "Its motor turns this many degrees a second to the left; 0 brakes.",
        _DOOR + "new hinge from wall to door at 0 0 motorSpeed 90;", option="motor_speed", range=_TURN, settable=True,
        meant=("motor",)),
    _of(("hinge", "axle"), "torque", "number",
        "The most that its motor can turn with; without it, as much as it takes.",
        _DOOR + "new hinge from wall to door at 0 0 motorSpeed 90 torque 50;", option="max_torque", range=NOT_NEGATIVE,
        settable=True, meant=("maxTorque",)),
    _of(("slider",), "slideSpeed", "number", "Its motor slides this many metres a second; 0 brakes.",
        _LIFT + "new slider from tower to lift slideSpeed 1;", option="motor_speed",
        range=Range(least=-1000.0, most=1000.0), settable=True, meant=("motor",)),
    _of(("slider",), "effort", "number", "The most that its motor can push with; without it, as much as it takes.",
        _LIFT + "new slider from tower to lift slideSpeed 1 effort 50;", option="max_force", range=NOT_NEGATIVE,
        settable=True, meant=("maxForce",)),
    _of(("rod", "rope"), "length", "length", "How long it is; without it, as far as the two are apart.",
        _BALL + "new rope from hook to ball length 3;", range=Range(least=0.0, most=10_000.0)),
    _of(("rod", "hinge", "slider", "axle"), "stiffness", "number",
        "Makes it springy: how hard it pulls back for each metre, or radian.",
        _BALL + "new rod from hook to ball stiffness 40;", range=NOT_NEGATIVE),
    _of(("rod", "hinge", "slider", "axle"), "damping", "number", "How soon its spring stops swinging; 0 never stops.",
        _BALL + "new rod from hook to ball stiffness 40 damping 1;", range=NOT_NEGATIVE),
    _of(("weld",), "frequency", "number", "Lets it bend, and spring back this many times a second.",
        _DOOR + "new weld from wall to door frequency 4;", range=Range(least=0.0, most=1000.0)),
    _of(("gear", "pulley"), "ratio", "number",
        "Turns of the second for one of the first, less than 0 where teeth mesh; how much a second rope counts.",
        _WHEELS + "new gear from large to small ratio -2;", range=Range(least=-1000.0, most=1000.0)),
    _of(("pulley",), "over", "spot", "The point that the first one's rope runs over.",
        _BLOCKS + "new pulley from left to right over -2 4 across 2 4;", option="over_a", range=PLACE),
    _of(("pulley",), "across", "spot", "The point that the second one's rope runs over.",
        _BLOCKS + "new pulley from left to right over -2 4 across 2 4;", option="over_b", range=PLACE),
    _of(JOINTS, "breaks", "number", "The force, in newtons, at which it breaks; without it, it never does.",
        _DOOR + "new weld from wall to door breaks 500;", option="breaking_force",
        range=Range(above=0.0, most=1_000_000_000.0), meant=("breakingForce", "strength")),
    _of(JOINTS, "meeting", "flag", "The two may touch each other; without it, they pass through each other.",
        _BALL + "new rope from hook to ball length 3 meeting;", option="collide", meant=("collide", "solid")),
)
# fmt: on
