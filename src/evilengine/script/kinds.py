"""What `new` can make."""

from __future__ import annotations

from collections.abc import Mapping

from evilengine.script.air import AIR_KINDS
from evilengine.script.characters import CHARACTER_KINDS
from evilengine.script.fluids import FLUID_KINDS
from evilengine.script.joints import JOINT_KINDS
from evilengine.script.lighting import LIGHT_KINDS
from evilengine.script.waters import WATER_KINDS
from evilengine.script.word import ANY, MAX_CORNERS, NOT_NEGATIVE, Kind, Range, Size

KINDS: Mapping[str, Kind] = {
    each.word: each
    for each in (
        Kind(
            word="walls",
            family="body",
            type="Rectangle",
            sizes=(Size(name="width"), Size(name="height")),
            shaped=("thickness",),
            doc="A room: four walls that stand round an area of this size. They are 1 metre thick, or `thickness`.",
            example='new walls 15 8 thickness 0.5 colour "dimgrey";',
            meant=("wall", "room", "border", "bounds", "frame", "walls"),
        ),
        Kind(
            word="rectangle",
            family="body",
            type="Rectangle",
            sizes=(Size(name="width"), Size(name="height")),
            shaped=("rounding",),
            doc="A rectangle; its place is its middle.",
            example="new rectangle crate 2 1 at 0 4 angle 30 physicsOn;",
            meant=("box", "square", "rect", "block", "crate", "platform", "floor", "ground"),
        ),
        Kind(
            word="circle",
            family="body",
            type="Circle",
            sizes=(Size(name="radius"),),
            doc="A circle; its place is its middle.",
            example="new circle ball 0.5 at 1 6 physicsOn;",
            meant=("ball", "disc", "disk", "round", "sphere", "oval", "ellipse"),
        ),
        Kind(
            word="triangle",
            family="body",
            type="Triangle",
            corners=(3, 3),
            shaped=("rounding",),
            needs=("at",),
            doc="A triangle with these three corners, counted from its place.",
            example="new triangle 0 0, 1 0, 0.5 1 at 3 3 physicsOn;",
            meant=("tri", "wedge", "ramp"),
        ),
        Kind(
            word="polygon",
            family="body",
            type="Polygon",
            corners=(3, MAX_CORNERS),
            shaped=("rounding", "hole"),
            needs=("at",),
            doc="A shape with any corners, counted from its place, in order round it. Its edges may not cross.",
            example="new polygon rock 0 0, 1 0, 1.2 0.8, 0.3 1.1 at 2 5 physicsOn;",
            meant=("poly", "shape", "hexagon", "pentagon", "star"),
        ),
        Kind(
            word="capsule",
            family="body",
            type="Capsule",
            sizes=(Size(name="width"), Size(name="height")),
            doc="A bar with round ends, lying or standing; its place is its middle.",
            example="new capsule pill 2 0.6 at 0 4 physicsOn;",
            meant=("pill", "stadium", "bean", "sausage"),
        ),
        Kind(
            word="segment",
            family="body",
            type="Segment",
            corners=(2, 2),
            open=True,
            doc="A straight line between two points, counted from its place; solid from both sides.",
            example="new segment ramp -6 -2, 2 -4;",
            meant=("line", "edge"),
        ),
        Kind(
            word="chain",
            family="body",
            type="Chain",
            corners=(2, MAX_CORNERS),
            open=True,
            shaped=("closed",),
            doc="Lines from point to point, counted from its place: hilly ground that things slide along smoothly.",
            example="new chain hills -8 -3, -4 -2, 0 -3.5, 5 -3, 8 -1;",
            meant=("path", "terrain", "polyline", "hills", "curve"),
        ),
        Kind(
            word="particle",
            family="body",
            type="Particle",
            sizes=(Size(name="mass", range=Range(above=0.0, most=1e6), measure="mass"),),
            doc="A grain with a mass and no size: forces move it, and it passes through everything.",
            example="new particle grain 1kg at 0 3 physicsOn;",
            meant=("point", "dot", "grain", "dust"),
        ),
        Kind(
            word="spring",
            family="spring",
            type="Spring",
            needs=("from", "to"),
            doc="A spring that pulls and pushes a thing toward a point or another thing.",
            example="new circle ball 0.5 at 0 3 physicsOn;\nnew spring from ball to 0 8 stiffness 20 length 2;",
            meant=("elastic", "band"),
        ),
        Kind(
            word="force",
            family="force",
            type="ConstantForce",
            sizes=(Size(name="x", range=ANY, measure=""), Size(name="y", range=ANY, measure="")),
            doc="A steady push with this strength to the right and up; on everything, or only on those named by `for`.",
            example="new circle ball 0.5 at 0 3 physicsOn;\nnew force wind 2 0 for ball;",
            meant=("push", "wind", "thrust"),
        ),
        Kind(
            word="drag",
            family="drag",
            type="Drag",
            sizes=(Size(name="strength", range=NOT_NEGATIVE, measure=""),),
            doc="Resistance, as of thick air: slows whatever moves; everything, or only those named by `for`.",
            example="new circle ball 0.5 at 0 3 physicsOn;\nnew drag 0.5 for ball;",
            meant=("resistance", "brake"),
        ),
        Kind(
            word="medium",
            family="medium",
            type="Medium",
            sizes=(Size(name="width"), Size(name="height")),
            needs=("drag",),
            doc="An area of water, wind or mud: it slows what is in it, lifts it by its density, and takes it along.",
            example="new medium pond 8 2 at 0 -3 drag 4;",
            meant=("mud", "area", "lake", "pond", "draught"),
        ),
        *CHARACTER_KINDS,
        *AIR_KINDS,
        *LIGHT_KINDS,
        *FLUID_KINDS,
        *WATER_KINDS,
        *JOINT_KINDS,
    )
}
