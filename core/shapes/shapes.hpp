#pragma once
// Shapes on bodies (SPEC C1). A Shape is what a user added; the collider sees its convex pieces.
#include "math/transform.hpp"
#include "refs.hpp"
#include "shapes/form.hpp"
#include <span>

namespace evil {

enum class ShapeKind : std::uint8_t { circle, polygon, particle };

struct Material {
    float density = 1.0f, friction = 0.6f, restitution = 0.0f;
};

struct Shape {
    ShapeKind kind = ShapeKind::circle;
    std::uint32_t body = kNone;
    std::uint32_t next = kNone;        // next shape on the same body, in the order they were added
    std::uint32_t first_piece = kNone; // its convex pieces, in order; a particle has none
    Affine local;                      // shape to body (SPEC P4)
    float radius = 0.0f;               // circle, before `local`
    float mass = 0.0f;                 // particle
    Material material;
    std::uint64_t serial = 0, born = 0, made = 0;
};

// A convex polygon with any number of corners, or a circle (no corners), in the body's frame.
struct Piece {
    std::uint32_t shape = kNone, body = kNone;
    std::uint32_t next = kNone; // next piece of the same shape
    std::uint32_t first = 0,
                  count =
                      0; // corners and outward normals in the pool, counter-clockwise; normal i is of edge i to i + 1
    Vec2 centre;         // of the circle, or of the polygon's corners' bounds
    float radius = 0.0f; // of a circle; 0 for a polygon
    float reach = 0.0f;  // distance from `centre` to the farthest point: the bounding circle of SPEC C2
};

using Part = std::vector<std::uint32_t>; // a convex part of a polygon, by the numbers of its corners

struct Shapes { // State: rows by slot
    Slots slots;
    std::vector<Shape> rows;
    std::vector<std::vector<Vec2>> corners; // polygon: as given, counter-clockwise, before `local`
    std::vector<std::vector<Part>> parts;   // polygon: how it splits
    Slots piece_slots;
    std::vector<Piece> pieces;
    std::vector<Form> forms; // by piece, baked with it
    std::vector<FormKind> form_kinds;
    std::vector<Vec2> points, normals; // the pool: ranges of live pieces, and of dead ones until pack()
    std::uint32_t live_points = 0;
    std::uint64_t next_serial = 0;
};

inline std::span<const Vec2> points_of(const Shapes& s, const Piece& p) { return {s.points.data() + p.first, p.count}; }
inline std::span<const Vec2> normals_of(const Shapes& s, const Piece& p) {
    return {s.normals.data() + p.first, p.count};
}

// A polygon's corners (counter-clockwise, already checked) and parts, or a circle, as a new row without a body.
std::uint32_t add_shape_row(Shapes& shapes, const Shape& shape, std::vector<Vec2> corners, std::vector<Part> parts);
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

} // namespace evil
