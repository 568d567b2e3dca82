#include "shapes/shapes.hpp"
#include "shapes/rounded.hpp"
#include <algorithm>

namespace evil {
namespace {

void bake_circle(Piece& piece, const Shape& shape, const Affine& m) {
    piece.centre = {m.tx, m.ty};
    piece.radius = shape.radius * length({m.a, m.b});
    piece.reach = piece.radius;
}

// The piece's corners are in the pool: what follows from them.
void bake_core(Shapes& shapes, Piece& piece, float radius) {
    const Vec2* points = shapes.points.data() + piece.first;
    Vec2* normals = shapes.normals.data() + piece.first;
    std::uint32_t n = piece.count;
    Vec2 low = points[0], high = points[0];
    for (std::uint32_t i = 0; i < n; ++i) {
        normals[i] = normalised(right_of(points[i + 1 < n ? i + 1 : 0] - points[i]));
        low = min(low, points[i]);
        high = max(high, points[i]);
    }
    piece.centre = 0.5f * (low + high);
    piece.radius = radius;
    piece.reach = 0.0f;
    for (std::uint32_t i = 0; i < n; ++i) piece.reach = std::max(piece.reach, length(points[i] - piece.centre));
    piece.reach += radius;
}

void bake_polygon(Shapes& shapes, Piece& piece, std::span<const Vec2> corners, const Part& part, const Affine& m) {
    Vec2* points = shapes.points.data() + piece.first;
    bool mirrored = determinant(m) < 0.0f; // a mirrored polygon would run clockwise
    std::uint32_t n = piece.count;
    for (std::uint32_t i = 0; i < n; ++i) points[i] = apply(m, corners[part[mirrored ? n - 1 - i : i]]);
}

// Edge `i` of a path, and after it the corners before and behind.
void bake_edge(Shapes& shapes, Piece& piece, const Shape& shape, std::span<const Vec2> path, std::size_t i,
               const Affine& m) {
    Vec2* points = shapes.points.data() + piece.first;
    std::size_t n = path.size();
    auto at = [&](std::size_t k) { return apply(m, path[k % n]); };
    points[0] = at(i);
    points[1] = at(i + 1);
    if (shape.kind != ShapeKind::chain) return;
    bool before = shape.closed || i > 0, after = shape.closed || i + 2 < n;
    piece.ghosts = static_cast<std::uint8_t>((before ? kGhostBefore : 0) | (after ? kGhostAfter : 0));
    points[2] = at(i + n - 1);
    points[3] = at(i + 2);
}

void bake_form(Shapes& shapes, std::uint32_t p) {
    std::span<const Vec2> corners = points_of(shapes, shapes.pieces[p]), normals = normals_of(shapes, shapes.pieces[p]);
    FormOf made = form_of(shapes.pieces[p], corners, normals);
    shapes.forms[p] = made.form;
    shapes.form_kinds[p] = made.kind;
    if (made.kind != FormKind::box && made.kind != FormKind::polygon) return;
    if (shapes.few_corners.size() <= p) shapes.few_corners.resize(shapes.pieces.size());
    shapes.few_corners[p] = few_corners(made.form, corners, normals);
}

void release_pieces(Shapes& shapes, std::uint32_t shape) {
    for (std::uint32_t p = shapes.rows[shape].first_piece; p != kNone; p = shapes.pieces[p].next) {
        shapes.live_points -= room_of(shapes.pieces[p], shapes.rows[shape].kind);
        shapes.piece_slots.release(p);
    }
    shapes.rows[shape].first_piece = kNone;
    if (shapes.points.size() > 2 * shapes.live_points + 64) pack(shapes);
}

Moments about_origin(const MassProperties& m) { // the parallel axis theorem
    double x = m.centre.x, y = m.centre.y;
    return {m.mass, m.mass * x, m.mass * y, m.inertia + m.mass * (x * x + y * y)};
}

// Is it weighed by its outline, since its pieces overlap or are lines?
bool is_outline(const Shape& s) {
    return s.kind == ShapeKind::line || s.kind == ShapeKind::chain || (s.kind == ShapeKind::polygon && s.radius > 0.0f);
}

MassProperties outline_mass(const Shapes& shapes, std::uint32_t shape, Vec2 scale) {
    const Shape& row = shapes.rows[shape];
    Affine m = definition_to_body(row, scale);
    std::vector<Vec2> corners;
    for (Vec2 corner : shapes.corners[shape]) corners.push_back(apply(m, corner));
    float density = row.material.density;
    if (row.radius == 0.0f) return path_mass(corners, row.closed, density);
    turn_rings(corners, shapes.holes[shape]); // a mirrored polygon would run clockwise
    return rounded_mass({corners, shapes.holes[shape]}, row.radius * length({m.a, m.b}), density);
}

} // namespace

std::size_t piece_count(const Shape& shape, std::span<const Vec2> corners, std::span<const Part> parts) {
    switch (shape.kind) {
    case ShapeKind::circle:
    case ShapeKind::line:
        return 1;
    case ShapeKind::polygon:
        return parts.size();
    case ShapeKind::chain:
        return shape.closed ? corners.size() : corners.size() - 1;
    case ShapeKind::particle:
        break;
    }
    return 0;
}

std::uint16_t corner_count(const Shape& shape, std::span<const Part> parts, std::size_t piece) {
    if (shape.kind == ShapeKind::polygon) return static_cast<std::uint16_t>(parts[piece].size());
    return shape.kind == ShapeKind::circle ? 0 : 2;
}

std::uint32_t add_shape_row(Shapes& shapes, const Shape& shape, OwnedRings rings, std::vector<Part> parts) {
    std::uint32_t slot = shapes.slots.take();
    if (slot >= shapes.rows.size()) {
        shapes.rows.resize(slot + 1);
        shapes.corners.resize(slot + 1);
        shapes.holes.resize(slot + 1);
        shapes.parts.resize(slot + 1);
    }
    shapes.rows[slot] = shape;
    shapes.rows[slot].serial = shapes.next_serial++;
    shapes.corners[slot] = std::move(rings.corners);
    shapes.holes[slot] = std::move(rings.holes);
    shapes.parts[slot] = std::move(parts);

    std::size_t count = piece_count(shape, shapes.corners[slot], shapes.parts[slot]);
    std::uint32_t last = kNone;
    for (std::size_t i = 0; i < count; ++i) {
        std::uint32_t p = shapes.piece_slots.take();
        if (p >= shapes.pieces.size()) shapes.pieces.resize(p + 1);
        Piece& piece = shapes.pieces[p] = {};
        piece.shape = slot;
        piece.body = shape.body;
        piece.sensor = shape.traits.sensor;
        piece.first = static_cast<std::uint32_t>(shapes.points.size());
        piece.count = corner_count(shape, shapes.parts[slot], i);
        std::uint32_t room = room_of(piece, shape.kind);
        shapes.points.resize(shapes.points.size() + room);
        shapes.normals.resize(shapes.points.size());
        shapes.live_points += room;
        (last == kNone ? shapes.rows[slot].first_piece : shapes.pieces[last].next) = p;
        last = p;
    }
    return slot;
}

void remove_shape_row(Shapes& shapes, std::uint32_t shape) {
    release_pieces(shapes, shape);
    shapes.corners[shape].clear();
    shapes.holes[shape].clear();
    shapes.parts[shape].clear();
    shapes.rows[shape] = {};
    shapes.slots.release(shape);
}

void bake(Shapes& shapes, std::uint32_t shape, Vec2 scale) {
    const Shape& row = shapes.rows[shape];
    Affine m = definition_to_body(row, scale);
    std::size_t part = 0;
    shapes.forms.resize(shapes.pieces.size());
    shapes.form_kinds.resize(shapes.pieces.size());
    shapes.neighboured.resize(shapes.pieces.size());
    for (std::uint32_t p = row.first_piece; p != kNone; p = shapes.pieces[p].next, ++part) {
        Piece& piece = shapes.pieces[p];
        if (row.kind == ShapeKind::circle)
            bake_circle(piece, row, m);
        else if (row.kind == ShapeKind::polygon)
            bake_polygon(shapes, piece, shapes.corners[shape], shapes.parts[shape][part], m);
        else
            bake_edge(shapes, piece, row, shapes.corners[shape], part, m);
        if (piece.count > 0) bake_core(shapes, piece, row.radius * length({m.a, m.b}));
        bake_form(shapes, p);
    }
}

void pack(Shapes& shapes) {
    ++shapes.packed;
    std::vector<Vec2> points, normals;
    points.reserve(shapes.live_points);
    normals.reserve(shapes.live_points);
    for (std::uint32_t p = 0; p < shapes.piece_slots.size(); ++p) {
        if (!shapes.piece_slots.taken(p)) continue;
        Piece& piece = shapes.pieces[p];
        auto first = static_cast<std::uint32_t>(points.size());
        auto corners = shapes.points.begin() + piece.first, outward = shapes.normals.begin() + piece.first;
        std::uint32_t room = room_of(piece, shapes.rows[piece.shape].kind);
        points.insert(points.end(), corners, corners + room);
        normals.insert(normals.end(), outward, outward + room);
        piece.first = first;
    }
    shapes.points = std::move(points);
    shapes.normals = std::move(normals);
}

bool is_similarity(const Affine& m) {
    float u = m.a * m.a + m.b * m.b, v = m.c * m.c + m.d * m.d, skew = m.a * m.c + m.b * m.d;
    constexpr float kTolerance = 1e-4f; // what a few float32 matrix products lose
    return std::abs(u - v) <= kTolerance * std::max(u, v) && std::abs(skew) <= kTolerance * std::max(u, v);
}

Moments moments(const Shapes& shapes, std::uint32_t shape, Vec2 scale) {
    const Shape& row = shapes.rows[shape];
    if (row.kind == ShapeKind::particle) {
        double m = row.mass, x = scale.x * row.local.tx, y = scale.y * row.local.ty;
        return {m, m * x, m * y, m * (x * x + y * y)};
    }
    if (is_outline(row)) return about_origin(outline_mass(shapes, shape, scale));
    Moments sum;
    for (std::uint32_t p = row.first_piece; p != kNone; p = shapes.pieces[p].next) {
        const Piece& piece = shapes.pieces[p];
        MassProperties m = row.kind == ShapeKind::circle ? circle_mass(piece.radius, row.material.density)
                                                         : polygon_mass(points_of(shapes, piece), row.material.density);
        if (row.kind == ShapeKind::circle) m.centre = piece.centre;
        Moments part = about_origin(m);
        sum.mass += part.mass;
        sum.x += part.x;
        sum.y += part.y;
        sum.inertia += part.inertia;
    }
    return sum;
}

} // namespace evil
