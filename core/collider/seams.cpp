#include "collider/seams.hpp"

namespace evil {
namespace {

constexpr float kFlush = 0.1f * kSlop; // metres: surfaces that differ by less are one; more, and real steps would vanish

struct Touching { // a contact as its mover meets it
    const Piece* still;
    Pose pose;     // of the still piece's body
    Vec2 point;    // on the still piece's surface, where it is deepest
    Vec2 normal;   // from the still piece to the mover
    float depth;   // metres, 0 when they are apart
};

Touching seen(const Seams::Side& side, const Contacts& contacts, const Shapes& shapes, const Bodies& bodies) {
    const Contact& c = contacts.rows[side.row];
    const ManifoldPoint& p = c.count > 1 && c.points[1].separation < c.points[0].separation ? c.points[1] : c.points[0];
    const Body& still = bodies.rows[side.from_a ? c.body_b : c.body_a];
    Vec2 normal = side.from_a ? -c.normal : c.normal;
    Vec2 midway = still.centre + (side.from_a ? p.anchor_b : p.anchor_a);
    return {&shapes.pieces[side.from_a ? c.piece_b : c.piece_a], still.pose, midway - 0.5f * p.separation * normal,
            normal, std::max(0.0f, -p.separation)};
}

// How far the piece reaches out in front of the plane through `point`.
float in_front(const Shapes& shapes, const Touching& t, Vec2 point, Vec2 normal) {
    Vec2 p = untransform(t.pose, point), n = unrotate(t.pose.q, normal);
    if (t.still->count == 0) return dot(n, t.still->centre - p) + t.still->radius;
    std::span<const Vec2> corners = points_of(shapes, *t.still);
    float most = dot(n, corners[0] - p);
    for (Vec2 corner : corners.subspan(1)) most = std::max(most, dot(n, corner - p));
    return most + t.still->radius;
}

float square_distance(Vec2 p, Vec2 a, Vec2 b) { // from the segment a-b
    Vec2 edge = b - a;
    float along = dot(p - a, edge), whole = length_squared(edge);
    float part = whole > 0.0f ? std::min(std::max(along / whole, 0.0f), 1.0f) : 0.0f;
    return length_squared(p - a - part * edge);
}

bool within(const Shapes& shapes, const Touching& t, Vec2 point, float more) {
    Vec2 p = untransform(t.pose, point);
    float reach = t.still->radius + more, square = reach * reach;
    if (length_squared(p - t.still->centre) > (t.still->reach + more) * (t.still->reach + more)) return false;
    if (t.still->count == 0) return true;
    std::span<const Vec2> corners = points_of(shapes, *t.still), normals = normals_of(shapes, *t.still);
    bool inside = corners.size() > 2;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (square_distance(p, corners[i], corners[i + 1 < corners.size() ? i + 1 : 0]) <= square) return true;
        inside = inside && dot(normals[i], p - corners[i]) <= 0.0f;
    }
    return inside;
}

bool gives_way(const Shapes& shapes, const Touching& ghost, const Touching& other, float flush) {
    return within(shapes, other, ghost.point, flush + other.depth) &&
           in_front(shapes, other, ghost.point, ghost.normal) > flush &&
           in_front(shapes, ghost, other.point, other.normal) <= flush;
}

void add_side(Seams& seams, std::uint32_t row, std::uint32_t mover, const Body& other, std::uint32_t body, bool from_a) {
    std::uint32_t whole = other.kind == BodyKind::fixed ? kNone : body;
    if (seams.first[mover] == kNone) seams.movers.push_back(mover);
    seams.sides.push_back({row, seams.first[mover], whole, from_a});
    seams.first[mover] = static_cast<std::uint32_t>(seams.sides.size() - 1);
}

void gather(Seams& seams, const Contacts& contacts, const Shapes& shapes, const Bodies& bodies) {
    seams.sides.clear();
    seams.movers.clear();
    seams.hidden.clear();
    seams.first.resize(shapes.pieces.size(), kNone);
    for (std::uint32_t row = 0; row < contacts.rows.size(); ++row) {
        const Contact& c = contacts.rows[row];
        bool of_a = shapes.neighboured[c.piece_a] != 0, of_b = shapes.neighboured[c.piece_b] != 0;
        if (c.count == 0 || !(of_a || of_b)) continue;
        if (of_b) add_side(seams, row, c.piece_a, bodies.rows[c.body_b], c.body_b, true);
        if (of_a) add_side(seams, row, c.piece_b, bodies.rows[c.body_a], c.body_a, false);
    }
}

// One that gives way to another may itself be what a third gives way to; were all to go, the last would take its reason along.
void find_ghosts(Seams& seams, std::uint32_t mover, const Contacts& contacts, const Shapes& shapes,
                 const Bodies& bodies) {
    float flush = std::min(kFlush, 0.05f * shapes.pieces[mover].reach);
    for (std::uint32_t i = seams.first[mover]; i != kNone; i = seams.sides[i].next) {
        const Seams::Side& side = seams.sides[i];
        Touching ghost = seen(side, contacts, shapes, bodies);
        for (std::uint32_t j = seams.first[mover]; j != kNone; j = seams.sides[j].next) {
            const Seams::Side& other = seams.sides[j];
            if (i == j || other.whole != side.whole) continue;
            if (!gives_way(shapes, ghost, seen(other, contacts, shapes, bodies), flush)) continue;
            seams.hidden.push_back(side.row);
            break;
        }
    }
}

} // namespace

void drop_ghosts(Seams& seams, Contacts& contacts, const Shapes& shapes, const Bodies& bodies) {
    gather(seams, contacts, shapes, bodies);
    for (std::uint32_t mover : seams.movers) {
        std::uint32_t only = seams.first[mover];
        if (seams.sides[only].next != kNone) find_ghosts(seams, mover, contacts, shapes, bodies);
        seams.first[mover] = kNone;
    }
    for (std::uint32_t row : seams.hidden) contacts.rows[row].count = 0;
}

void note_neighbours(Shapes& shapes, const Body& body) {
    bool alone = body.kind != BodyKind::fixed && body.first_shape == body.last_shape;
    for (std::uint32_t s = body.first_shape; s != kNone; s = shapes.rows[s].next)
        for (std::uint32_t p = shapes.rows[s].first_piece; p != kNone; p = shapes.pieces[p].next)
            shapes.neighboured[p] = !alone || shapes.pieces[shapes.rows[s].first_piece].next != kNone;
}

void note_neighbours(Shapes& shapes, const Body& body, std::uint32_t added) {
    std::uint32_t first = body.first_shape;
    if (first == added || shapes.rows[first].next == added) return note_neighbours(shapes, body);
    for (std::uint32_t p = shapes.rows[added].first_piece; p != kNone; p = shapes.pieces[p].next)
        shapes.neighboured[p] = 1;
}

} // namespace evil
