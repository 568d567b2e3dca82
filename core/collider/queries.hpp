#pragma once
// Questions to the world (SPEC C9): they change nothing.
#include "collider/broad_phase.hpp"
#include "collider/narrow_phase.hpp"
#include <optional>

namespace evil {

struct RayHit {
    std::uint32_t shape = kNone, body = kNone;
    Vec2 point, normal; // where the segment enters; the normal points out of the shape
    float fraction = 1.0f;
};

// The first shape that the segment enters, of bodies of one kind or of all. One that it starts in does not count.
std::optional<RayHit> ray_cast(const Shapes& shapes, const Bodies& bodies, Vec2 start, Vec2 end,
                               std::optional<BodyKind> only = {});

bool contains(const Shapes& shapes, const Piece& piece, const Pose& pose, Vec2 point);

// Bodies with a shape over the point, or overlapping any of the pieces of `probe` (placed in world coordinates), in creation order.
void bodies_at(const Shapes& shapes, const Bodies& bodies, Vec2 point, std::vector<std::uint32_t>& found);
void bodies_overlapping(const Shapes& shapes, const Bodies& bodies, const Shapes& probe,
                        std::vector<std::uint32_t>& found);

} // namespace evil
