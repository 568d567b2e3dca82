#pragma once
// Shapes on bodies (SPEC C1). A Shape is what a user added; the collider sees its convex pieces.
#include "math/transform.hpp"
#include "refs.hpp"
#include "shapes/form.hpp"
#include "shapes/rings.hpp"
#include <span>

namespace evil {

// A line is a segment with a skin: a capsule, or with none a bare segment. A chain is a path of bare segments.
enum class ShapeKind : std::uint8_t { circle, polygon, particle, line, chain };

struct Material {
    float density = 1.0f, friction = 0.6f, restitution = 0.0f;
};

// How a shape deals with those it meets. A body holds what its later shapes get.
struct Traits {
    std::uint32_t category = 1;       // bits: what it is
    std::uint32_t mask = 0xffffffffu; // bits: what it meets
    std::int32_t group = 0;           // two in one group, not 0, meet always if it is positive, never if negative
    bool sensor = false;              // sees what overlaps it, pushes nothing
    Vec2 one_way;                     // the side from which it is solid, body frame, of length 1; 0: from everywhere
    float surface_speed = 0.0f;       // m/s along its outline, clockwise: to the right on top
    friend bool operator==(const Traits&, const Traits&) = default;
};

struct Shape {
    ShapeKind kind = ShapeKind::circle;
    bool closed = false; // chain: its last point is joined to its first
    std::uint32_t body = kNone;
    std::uint32_t next = kNone;        // next shape on the same body, in the order they were added
    std::uint32_t first_piece = kNone; // its convex pieces, in order; a particle has none
    Affine local;                      // shape to body (SPEC P4)
    float radius = 0.0f; // of a circle, or of the skin round a polygon's or line's corners; before `local`
    float mass = 0.0f;   // particle
    Material material;
    Traits traits;
    std::uint64_t serial = 0, born = 0, made = 0;
};

// A convex core and a skin round it, in the body's frame. The core is a polygon (3 corners or more), a segment (2, and a
// normal to each side) or a point (none: `centre`); what touches it is within `radius` of the core.
struct Piece {
    std::uint32_t shape = kNone, body = kNone;
    std::uint32_t next = kNone; // next piece of the same shape
    std::uint32_t first = 0;    // of its corners and outward normals in the pool; normal i is of edge i to i + 1
    std::uint16_t count = 0;    // of corners, counter-clockwise
    bool sensor = false;        // as its shape
    std::uint8_t ghosts = 0;    // kGhostBefore, kGhostAfter: where the chain comes from and goes on, after the corners
    Vec2 centre;                // of the circle, or of the corners' bounds
    float radius = 0.0f;        // metres of skin: of a circle all of it, of most polygons none
    float reach = 0.0f;         // distance from `centre` to the farthest point: the bounding circle of SPEC C2
};

inline constexpr std::uint8_t kGhostBefore = 1, kGhostAfter = 2;
inline constexpr std::uint32_t kGhosts = 2; // places of a chain's piece in the pool, after its corners

using Part = std::vector<std::uint32_t>; // a convex part of a polygon, by the numbers of its corners

struct Shapes { // State: rows by slot
    Slots slots;
    std::vector<Shape> rows;
    std::vector<std::vector<Vec2>> corners; // before `local`; polygon: counter-clockwise; line: two; chain: its points
    std::vector<std::vector<std::uint32_t>> holes; // polygon: the first corner of each of its holes
    std::vector<std::vector<Part>> parts;          // polygon: how it splits
    Slots piece_slots;
    std::vector<Piece> pieces;
    std::vector<Form> forms; // by piece, baked with it
    std::vector<FormKind> form_kinds;
    std::vector<std::uint8_t> neighboured; // by piece: may it share a seam with another? (collider/seams.hpp)
    std::vector<FewCorners> few_corners;   // of boxes and polygons; shorter where the last pieces are neither
    std::uint64_t material_changes = 0;    // of shapes that are there: contacts mix materials anew when it moves
    std::vector<Vec2> points, normals;     // the pool: ranges of live pieces, and of dead ones until pack()
    std::uint32_t live_points = 0;
    std::uint64_t packed = 0; // how often the pool was packed: who keeps a copy of a piece must look again
    std::uint64_t next_serial = 0;
};

inline std::span<const Vec2> points_of(const Shapes& s, const Piece& p) { return {s.points.data() + p.first, p.count}; }
inline std::span<const Vec2> normals_of(const Shapes& s, const Piece& p) {
    return {s.normals.data() + p.first, p.count};
}

inline Rings rings_of(const Shapes& s, std::uint32_t shape) { return {s.corners[shape], s.holes[shape]}; }

// Places in the pool that a piece takes.
inline std::uint32_t room_of(const Piece& p, ShapeKind kind) {
    return kind == ShapeKind::chain ? p.count + kGhosts : p.count;
}

// How many pieces a shape with these corners and parts has, and how many corners has each.
std::size_t piece_count(const Shape& shape, std::span<const Vec2> corners, std::span<const Part> parts);
std::uint16_t corner_count(const Shape& shape, std::span<const Part> parts, std::size_t piece);

// A shape (its corners already checked) as a new row without a body.
std::uint32_t add_shape_row(Shapes& shapes, const Shape& shape, OwnedRings rings, std::vector<Part> parts);
void remove_shape_row(Shapes& shapes, std::uint32_t shape);

// Bake the pieces of a shape from its definition, its matrix and the body's scale. The pieces keep their slots.
void bake(Shapes& shapes, std::uint32_t shape, Vec2 scale);

// Move the live ranges of the pool together, in the order of the pieces' slots.
void pack(Shapes& shapes);

// The matrix from definition to body frame, the body's scale included.
inline Affine definition_to_body(const Shape& shape, Vec2 scale) {
    return compose(Affine{scale.x, 0, 0, scale.y, 0, 0}, shape.local);
}

// Does m keep circles round?
bool is_similarity(const Affine& m);

// Mass, first moment (mass times centre) and inertia about the body's origin of one shape as baked.
struct Moments {
    double mass = 0, x = 0, y = 0, inertia = 0;
};
Moments moments(const Shapes& shapes, std::uint32_t shape, Vec2 scale);

// What the shapes of the body that was weighed last add up to: one more is added to that, rather than to all of them anew.
struct Weighed { // Scratch
    std::uint32_t body = kNone, last_shape = kNone;
    Moments sum;
};

} // namespace evil
