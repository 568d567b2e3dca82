"""The words that say how a thing deals with what it meets."""

from __future__ import annotations

from evilengine.script.word import Property, Range

BODY = ("body",)
_ON_BODY = "new circle ball 0.5 at 0 3 physicsOn "

MEETING: tuple[Property, ...] = (
    Property(
        word="sensor",
        takes="flag",
        families=BODY,
        option="sensor",
        settable="sensor",
        doc="It sees what overlaps it, and neither pushes nor is pushed.",
        example="new rectangle goal 2 1 at 0 3 sensor;",
        meant=("trigger", "ghost", "hollow", "zone"),
    ),
    Property(
        word="oneWay",
        takes="flag",
        families=BODY,
        option="one_way",
        settable="one_way",
        doc="Solid only from above, or from the side that its top is turned to: the rest passes through it.",
        example="new rectangle ledge 3 0.2 at 0 2 oneWay;",
        meant=("platform", "oneway", "passThrough", "jumpThrough"),
    ),
    Property(
        word="conveyor",
        takes="number",
        families=BODY,
        option="surface_speed",
        range=Range(least=-1000.0, most=1000.0),
        settable="surface_speed",
        doc="A belt: its top runs to the right this fast, in metres a second, and takes along what lies on it.",
        example="new rectangle belt 8 0.5 at 0 -2 conveyor 2;",
        meant=("belt", "treadmill", "surfaceSpeed"),
    ),
    Property(
        word="category",
        takes="whole",
        families=BODY,
        option="category",
        range=Range(least=1.0, most=4_294_967_295.0),
        settable="category",
        doc="What it is, as a sum of 1, 2, 4, 8 and so on; things that say nothing are 1.",
        example=_ON_BODY + "category 2;",
        meant=("categories",),
    ),
    Property(
        word="mask",
        takes="whole",
        families=BODY,
        option="mask",
        range=Range(least=0.0, most=4_294_967_295.0),
        settable="mask",
        doc="Which categories it meets, as their sum; it passes through all others. Without it, all.",
        example=_ON_BODY + "category 2 mask 5;",
        meant=("collidesWith", "meets", "filter"),
    ),
    Property(
        word="group",
        takes="whole",
        families=BODY,
        option="group",
        range=Range(least=-1_000_000.0, most=1_000_000.0),
        settable="group",
        doc="Two of one group meet always; if its number is negative, never. 0 is none.",
        example=_ON_BODY + "group -1;",
    ),
)
