#pragma once
// How much of a piece lies in an area, and where the middle of that is: exact for polygons and circles in either.
#include "forces/forces.hpp"
#include "math/vec2d.hpp"

namespace evil {

struct Immersion { // square metres, and square metres times metres
    double area = 0.0;
    Vec2d moment;
};
inline Immersion operator+(Immersion a, Immersion b) { return {a.area + b.area, a.moment + b.moment}; }

struct ImmersionScratch {
    std::vector<Vec2d> outline, clipped;
};

// What of the piece, placed by `pose`, is in the area; both in the area's frame.
Immersion immersion(const Shapes& shapes, const Piece& piece, const Pose& pose, const Area& area,
                    ImmersionScratch& scratch);
double area_of(const Shapes& shapes, const Piece& piece); // all of it

} // namespace evil
