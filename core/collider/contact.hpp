#pragma once
// Contacts: pairs of convex pieces whose bounds overlap, and the manifold where they touch.
#include "bodies.hpp"
#include "collider/placed.hpp"
#include "shapes/shapes.hpp"
#include <bit>
#include <cstddef>
#include <cstring>

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

// Does what the two do to each other hang on more than where they are? It follows from their shapes (see mark).
enum class Terms : std::uint8_t {
    plain,
    one_way,        // a shape of the two is solid from one side only
    sensor,         // one sees the other: it never has points
    settled_sensor, // looked at since the two rest
};

// Two lines of the cache. What follows from the shapes is not saved.
struct alignas(64) Contact {
    std::uint32_t piece_a = 0, piece_b = 0; // key, piece_a < piece_b
    std::uint32_t body_a = 0, body_b = 0;   // follow from the pieces
    Axis axis;
    std::uint8_t count = 0;               // points in the manifold
    bool fresh = true;                    // found in this step; not saved, since no step leaves one so
    bool touching = false;                // they overlapped, or pushed each other, in the last step
    bool struck = false;                  // and that was told as a hit
    Passage passage = Passage::undecided; // one_way: what holds until they are apart
    bool compound = false; // a shape of the two has other pieces that may touch too; follows from the shapes
    Terms terms = Terms::plain;
    Vec2 normal; // world, from a to b
    float friction = 0.0f, restitution = 0.0f;
    float surface_speed = 0.0f; // m/s that friction brings b to along the tangent (n turned right), seen from a
    ManifoldPoint points[2];

    bool sensor() const { return terms >= Terms::sensor; }
    void look_again() { terms = sensor() ? Terms::sensor : terms; } // one of the two may have changed
};

inline std::uint32_t shape_a(const Contact& c, const Shapes& shapes) { return shapes.pieces[c.piece_a].shape; }
inline std::uint32_t shape_b(const Contact& c, const Shapes& shapes) { return shapes.pieces[c.piece_b].shape; }
inline bool is_of_shape(const Contact& c, const Shapes& shapes, std::uint32_t shape) {
    return shape_a(c, shapes) == shape || shape_b(c, shapes) == shape;
}

// A contact as wide kernels read and write it: rows of eight floats, from the axis on. The last two share four floats.
struct ContactRows {
    static constexpr std::size_t kHead = 16, kFirst = 48, kMiddle = 80, kSecond = 88, kLast = 96; // bytes
    static constexpr std::size_t kImpulses[2] = {68, 108};                                        // in the second line
};
static_assert(std::endian::native == std::endian::little && sizeof(Contact) == 128 && sizeof(ManifoldPoint) == 40);
static_assert(offsetof(Contact, axis) == 16 && offsetof(Axis, of_b) == 2 && offsetof(Axis, known) == 3);
static_assert(offsetof(Contact, count) == 20 && offsetof(Contact, touching) == 22 && offsetof(Contact, struck) == 23);
static_assert(offsetof(Contact, passage) == 24 && offsetof(Contact, compound) == 25);
static_assert(offsetof(Contact, normal) == 28 && offsetof(Contact, friction) == 36);
static_assert(offsetof(Contact, surface_speed) == 44 && offsetof(Contact, points) == 48);
static_assert(offsetof(ManifoldPoint, separation) == 16 && offsetof(ManifoldPoint, normal_impulse) == 20);
static_assert(offsetof(ManifoldPoint, closing_speed) == 32 && offsetof(ManifoldPoint, id) == 36);

struct Pair {
    std::uint32_t a = 0, b = 0; // pieces, a < b
    friend auto operator<=>(Pair, Pair) = default;
};

// What a step asks of every contact, by row, so that it need not look at the rows themselves: there are few that it has to
// do something about. Of this step; written with the manifolds.
inline constexpr std::uint8_t kMeets = 1;    // it has points
inline constexpr std::uint8_t kDeep = 2;     // they overlap by more than kDeepOverlap
inline constexpr std::uint8_t kSeamed = 4;   // a piece of the two has neighbours (collider/seams.hpp)
inline constexpr std::uint8_t kBounces = 8;  // restitution is not 0
inline constexpr std::uint8_t kTelling = 16; // there may be something to tell of it (collider/events.hpp)

inline constexpr float kDeepOverlap = 0.02f; // metres; what less does to a body is not worth a look

struct Contacts {
    std::vector<Contact> rows;            // State, sorted by key
    struct {                              // Scratch
        std::vector<std::uint8_t> marks;  // by row
        std::vector<Pair> bodies;         // by row: a and b
        std::vector<Pair> pairs, matched; // found in this step; those that the rows were last matched with
        std::size_t matched_rows = 0;     // how many rows came of them
        std::uint64_t material_changes = ~std::uint64_t{0}; // Shapes' when materials were mixed last
        std::vector<Contact> rows;
        std::vector<Contact> parted; // touched in the last step, and now not even their bounds meet
    } scratch;
};

// What is to be asked of a contact as it is now; whether it is seamed is known to the pieces.
inline std::uint8_t marks_of(const Contact& c) {
    unsigned telling = c.sensor() || c.compound ? kTelling : 0u;
    if (c.count == 0) return static_cast<std::uint8_t>(c.touching || c.struck ? kTelling : telling);
    float deepest = c.points[c.count > 1 && c.points[1].separation < c.points[0].separation].separation;
    return static_cast<std::uint8_t>(telling | kMeets | (deepest <= -kDeepOverlap ? kDeep : 0u) |
                                     (c.restitution > 0.0f ? kBounces : 0u));
}

// visit(row) for those that have one of the marks, in order.
template <class Visit> void for_each_marked(const std::vector<std::uint8_t>& marks, std::uint8_t which, Visit&& visit) {
    std::size_t row = 0, count = marks.size();
    auto each = [&](std::size_t last) {
        for (; row < last; ++row)
            if (marks[row] & which) visit(static_cast<std::uint32_t>(row));
    };
    while (count - row >= 8) {
        std::uint64_t eight;
        std::memcpy(&eight, &marks[row], 8);
        (eight & which * 0x0101010101010101u) == 0 ? void(row += 8) : each(row + 8);
    }
    each(count);
}

} // namespace evil
