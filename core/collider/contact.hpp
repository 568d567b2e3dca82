#pragma once
// Contacts: pairs of convex pieces whose bounds overlap, and the manifold where they touch.
#include "bodies.hpp"
#include "collider/placed.hpp"
#include "shapes/shapes.hpp"

namespace evil {

struct ManifoldPoint {
    Vec2 anchor_a, anchor_b;     // from each body's centre of mass, world axes
    float separation = 0.0f;     // metres; negative: overlap
    float normal_impulse = 0.0f; // newton seconds of the last substep: where the next step starts from
    float tangent_impulse = 0.0f;
    float total_impulse = 0.0f; // normal impulse over the whole last step
    float closing_speed = 0.0f; // m/s along the normal before the last step was solved; negative: they part
    std::uint32_t id = 0;       // which features met: the same id is the same point
};

// The axis that separated a pair last time, or that was the contact's normal: tried first (SPEC C3).
struct Axis {
    std::uint16_t edge = 0;
    bool of_b = false, known = false;
};

// A contact with a platform that is solid from one side.
enum class Passage : std::uint8_t { undecided, solid, passing };

struct Contact {
    std::uint32_t piece_a = 0, piece_b = 0; // key, piece_a < piece_b
    std::uint32_t shape_a = 0, shape_b = 0, body_a = 0, body_b = 0;
    Axis axis;
    std::uint8_t count = 0;               // points in the manifold
    bool fresh = true;                    // found in this step; not saved, since no step leaves one so
    bool touching = false;                // they overlapped, or pushed each other, in the last step
    bool struck = false;                  // and that was told as a hit
    Passage passage = Passage::undecided; // one_way: what holds until they are apart
    // What follows from the shapes (see mark), not saved:
    bool compound = false; // a shape of the two has other pieces that may touch too
    bool sensor = false;   // one sees the other: it never has points
    bool one_way = false;  // a shape of the two is solid from one side only
    bool settled = false;  // sensor: looked at since the two rest; not saved either
    Vec2 normal;           // world, from a to b
    float friction = 0.0f, restitution = 0.0f;
    float surface_speed =
        0.0f; // m/s that friction brings b to along the tangent (n turned right), seen from a; see mark
    ManifoldPoint points[2];
};

struct Pair {
    std::uint32_t a = 0, b = 0; // pieces, a < b
    friend auto operator<=>(Pair, Pair) = default;
};

struct Contacts {
    std::vector<Contact> rows;            // State, sorted by key
    struct {                              // Scratch
        std::vector<Pair> pairs, matched; // found in this step; those that the rows were last matched with
        std::size_t matched_rows = 0;     // how many rows came of them
        std::uint64_t material_changes = ~std::uint64_t{0}; // Shapes' when materials were mixed last
        std::vector<Contact> rows;
        std::vector<Contact> parted; // touched in the last step, and now not even their bounds meet
    } scratch;
};

} // namespace evil
