"""The words that say how a thing deals with what it meets."""

from __future__ import annotations

from evilengine.script.word import MOST_BITS, Of, Property, Range

_any = Of(("body", "character"), "new circle ball 0.5 at 0 3 physicsOn ")
_thing = Of(("body",))

# fmt: off
MEETING: tuple[Property, ...] = (
    _thing("sensor", "flag", "It sees what overlaps it, and neither pushes nor is pushed.",
        example="new rectangle goal 2 1 at 0 3 sensor;", settable=True, meant=("trigger", "ghost", "hollow", "zone")),
    _thing("oneWay", "flag",
        "Solid only from above, or from the side that its top is turned to: the rest passes through it.",
        example="new rectangle ledge 3 0.2 at 0 2 oneWay;", option="one_way", settable=True,
        meant=("platform", "oneway", "passThrough", "jumpThrough")),
    _thing("conveyor", "number",
        "A belt: its top runs to the right this fast, in metres a second, and takes along what lies on it.",
        example="new rectangle belt 8 0.5 at 0 -2 conveyor 2;", option="surface_speed",
        range=Range(least=-1000.0, most=1000.0), settable=True, meant=("belt", "treadmill", "surfaceSpeed")),
    _any("category", "whole", "What it is, as a sum of 1, 2, 4, 8 and so on; things that say nothing are 1.",
        "category 2", range=Range(least=1.0, most=MOST_BITS), settable=True, meant=("categories",)),
    _any("mask", "whole", "Which categories it meets, as their sum; it passes through all others. Without it, all.",
        "category 2 mask 5", range=Range(least=0.0, most=MOST_BITS), settable=True,
        meant=("collidesWith", "meets", "filter")),
    _any("group", "whole", "Two of one group meet always; if its number is negative, never. 0 is none.", "group -1",
        range=Range(least=-1_000_000.0, most=1_000_000.0), settable=True),
)
# fmt: on
