#include "collider/one_way.hpp"

namespace evil {
namespace {

constexpr float kFacing =
    0.5f; // cosine of the angle (60 degrees) within which a normal counts as the platform's solid side
constexpr float kSunk = 2 * kSlop; // metres of overlap at which a body still stands on top; a resting one has kSlop

// Does the platform's solid side face the other, and is the other still out of it? `outward` points from platform to other.
bool stands(const Contact& c, Vec2 solid, Vec2 outward, float sunk) {
    if (dot(outward, solid) < kFacing) return false;
    float deepest = c.points[0].separation;
    for (std::uint8_t i = 1; i < c.count; ++i) deepest = std::min(deepest, c.points[i].separation);
    return deepest >= -sunk;
}

// One that comes from the solid side so fast that it is already inside when it is first seen was outside a step ago.
float path_within(const Contact& c, const Body& platform, const Body& other, Vec2 solid, float dt) {
    if (c.passage != Passage::undecided) return 0.0f;
    return dt * std::max(0.0f, dot(platform.velocity - other.velocity, solid));
}

bool solid_side(const Contact& c, const Traits& traits, const Body& platform, const Body& other, Vec2 outward,
                float dt) {
    if (traits.one_way == Vec2{}) return true;
    Vec2 solid = rotate(platform.pose.q, traits.one_way);
    return stands(c, solid, outward, kSunk + path_within(c, platform, other, solid, dt));
}

} // namespace

void decide_passage(Contact& c, const Shapes& shapes, const Bodies& bodies, float dt) {
    if (c.count == 0) {
        c.passage = Passage::undecided;
        return;
    }
    if (c.passage != Passage::solid) {
        const Body &a = bodies.rows[c.body_a], &b = bodies.rows[c.body_b];
        bool solid = solid_side(c, shapes.rows[shape_a(c, shapes)].traits, a, b, c.normal, dt) &&
                     solid_side(c, shapes.rows[shape_b(c, shapes)].traits, b, a, -c.normal, dt);
        c.passage = solid ? Passage::solid : Passage::passing;
    }
    if (c.passage == Passage::passing) c.count = 0;
}

} // namespace evil
