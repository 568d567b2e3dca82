#pragma once
// Shapes that are moved without turning, and what they meet first (SPEC C9).
#include "collider/search.hpp"

namespace evil {

inline constexpr float kTouchGap = 1e-3f; // metres: what is so near is touched

struct Touching {
    double fraction;    // of the way
    Vec2 point, normal; // world; the normal points out of what was met
    float gap = 0.0f;   // metres between the two at the start, when they touch or overlap from the start
};

// Where `mine`, moved along `path`, comes as near as `gap` to `piece`. What it touches or overlaps from the start is met at
// once if the way leads into it, and not at all if it leads along it or out.
std::optional<Touching> touch(const Shapes& probe, const Piece& mine, const Pose& from, Vec2 path, const Shapes& shapes,
                              const Piece& piece, const Pose& at, float gap);

// The first shape that any piece of `probe` (placed in world coordinates) meets on its way along `path`; the point is where
// they touch. Ties as for rays.
std::optional<RayHit> shape_cast(const Scene& scene, const Shapes& probe, Vec2 path, const Filter& filter);
void shape_cast_all(const Scene& scene, const Shapes& probe, Vec2 path, const Filter& filter,
                    std::vector<RayHit>& hits);

} // namespace evil
