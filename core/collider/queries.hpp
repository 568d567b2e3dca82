#pragma once
// Questions to one piece (SPEC C9): where a ray enters it, whether it covers a point, how near it is.
#include "collider/broad_phase.hpp"
#include "collider/narrow_phase.hpp"
#include <optional>

namespace evil {

struct Entry {
    double fraction; // of the ray; in double, so that a long one still meets its target to the millimetre
    Vec2 normal;     // out of the piece, world axes
};

// Where the segment enters the piece. One that starts inside does not enter.
std::optional<Entry> enter(const Shapes& shapes, const Piece& piece, const Pose& pose, Vec2 start, Vec2 end);

bool contains(const Shapes& shapes, const Piece& piece, const Pose& pose, Vec2 point);

struct Near {
    double distance; // 0 for a point that is covered
    Vec2 point;      // of the piece, nearest to the one asked about
};
Near nearest_point(const Shapes& shapes, const Piece& piece, const Pose& pose, Vec2 point);

} // namespace evil
