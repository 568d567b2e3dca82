#pragma once
// Exact phase (SPEC C2, C3): manifolds of two convex pieces.
#include "collider/contact.hpp"

namespace evil {

// A piece where it is: its corners and normals in the body's frame, and the body's pose.
struct Placed {
    const Piece& piece;
    std::span<const Vec2> points, normals;
    Pose pose;
};
Placed place(const Shapes& shapes, const Piece& piece, const Pose& pose);

struct ManifoldSketch { // a manifold in world coordinates, before it is matched with the last one
    std::uint8_t count = 0;
    Vec2 normal; // from a to b
    struct {
        Vec2 at; // midway between the surfaces
        float separation;
        std::uint32_t id;
    } points[2];
};

// The manifold of a and b if they are within `margin` metres of each other, else one without points. `axis` is what the
// last call remembered for this pair, and is remembered anew.
ManifoldSketch collide(const Placed& a, const Placed& b, float margin, Axis& axis);

} // namespace evil
