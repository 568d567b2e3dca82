#include "collider/seams.hpp"
#include <algorithm>
#include <span>

namespace evil {
namespace {

constexpr float kFlush =
    0.1f * kSlop;                // metres: surfaces that differ by less are one; more, and real steps would vanish
constexpr float kOnSeam = kSlop; // metres from the other piece: a manifold's points are no nearer to the true ones

struct Touching { // a contact as its mover meets it
    const Piece *still, *mover;
    Pose pose, mover_pose; // of their bodies
    int count;             // of points; with none there is only what follows
    Vec2 point;            // on the still piece's surface, where it is deepest
    Vec2 normal;           // from the still piece to the mover
    float depth;           // metres, 0 when they are apart
};

Touching seen(const Seams::Side& side, const Contacts& contacts, const Shapes& shapes, const Bodies& bodies) {
    const Contact& c = contacts.rows[side.row];
    const ManifoldPoint& p = c.count > 1 && c.points[1].separation < c.points[0].separation ? c.points[1] : c.points[0];
    const Body &a = bodies.rows[c.body_a], &b = bodies.rows[c.body_b], &still = side.from_a ? b : a;
    const Piece &p_a = shapes.pieces[c.piece_a], &p_b = shapes.pieces[c.piece_b];
    Touching t{side.from_a ? &p_b : &p_a,
               side.from_a ? &p_a : &p_b,
               still.pose,
               side.from_a ? a.pose : b.pose,
               c.count,
               {},
               {},
               0.0f};
    if (c.count == 0) return t;
    t.normal = side.from_a ? -c.normal : c.normal;
    t.point = still.centre + (side.from_a ? p.anchor_b : p.anchor_a) - 0.5f * p.separation * t.normal;
    t.depth = std::max(0.0f, -p.separation);
    return t;
}

// How far a piece reaches out in front of the plane through `point`.
float in_front(const Shapes& shapes, const Piece& piece, const Pose& pose, Vec2 point, Vec2 normal) {
    Vec2 p = untransform(pose, point), n = unrotate(pose.q, normal);
    if (piece.count == 0) return dot(n, piece.centre - p) + piece.radius;
    std::span<const Vec2> corners = points_of(shapes, piece);
    float most = dot(n, corners[0] - p);
    for (Vec2 corner : corners.subspan(1)) most = std::max(most, dot(n, corner - p));
    return most + piece.radius;
}
float in_front(const Shapes& shapes, const Touching& t, Vec2 point, Vec2 normal) {
    return in_front(shapes, *t.still, t.pose, point, normal);
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

// The direction in which the piece faces where it is touched: its edge's, since the contact's may be the mover's. Without
// points, that of the edge that the mover is farthest in front of.
Vec2 facing(const Shapes& shapes, const Touching& t) {
    if (t.still->count == 0) return t.normal;
    std::span<const Vec2> corners = points_of(shapes, *t.still), normals = normals_of(shapes, *t.still);
    Vec2 best;
    float most = -1e30f;
    for (std::size_t i = 0; i < normals.size(); ++i) {
        Vec2 n = rotate(t.pose.q, normals[i]);
        float along = t.count > 0 ? dot(n, t.normal)
                                  : -in_front(shapes, *t.mover, t.mover_pose, transform(t.pose, corners[i]), -n);
        if (along > most) most = along, best = n;
    }
    return best;
}

// Is this direction (world) that of one of the piece's edges?
bool is_face(const Shapes& shapes, const Piece& piece, const Pose& pose, Vec2 normal) {
    constexpr float kFace = 0.9999f; // cosine; 0.8 degrees
    Vec2 n = unrotate(pose.q, normal);
    return std::ranges::any_of(normals_of(shapes, piece), [&](Vec2 face) { return dot(face, n) > kFace; });
}

// Does something round touch a corner? It is nowhere deeper in the piece than there. Where tiles bend uphill, the next one's
// top begins at such a corner, and what rolls toward it must not feel it sooner than the top.
bool rounds_corner(const Shapes& shapes, const Touching& t) {
    return t.mover->radius > 0.0f && t.still->radius == 0.0f && !is_face(shapes, *t.still, t.pose, t.normal) &&
           !is_face(shapes, *t.mover, t.mover_pose, -t.normal);
}

bool gives_way(const Shapes& shapes, const Touching& ghost, const Touching& other, float size) {
    float flush = std::min(kFlush, size);
    if (!within(shapes, other, ghost.point, std::min(kOnSeam, size) + other.depth)) return false;
    if (in_front(shapes, other, ghost.point, ghost.normal) <= flush) return false;
    Vec2 face = facing(shapes, other);
    float height = rounds_corner(shapes, ghost) ? 0.0f : in_front(shapes, ghost, ghost.point, face);
    return height <= in_front(shapes, other, ghost.point, face) + flush;
}

void add_side(Seams& seams, std::uint32_t row, std::uint32_t mover, const Body& other, std::uint32_t body,
              bool from_a) {
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
    for_each_marked(contacts.scratch.marks, kSeamed, [&](std::uint32_t row) {
        const Contact& c = contacts.rows[row];
        bool of_a = shapes.neighboured[c.piece_a] != 0, of_b = shapes.neighboured[c.piece_b] != 0;
        if (c.sensor() || (c.terms == Terms::one_way && c.count == 0))
            return; // nothing solid: what is let through covers nothing
        // Those without points count too: what they cover, nobody can touch.
        if (of_b) add_side(seams, row, c.piece_a, bodies.rows[c.body_b], c.body_b, true);
        if (of_a) add_side(seams, row, c.piece_b, bodies.rows[c.body_a], c.body_a, false);
    });
}

// One that gives way to another may itself be what a third gives way to; were all to go, the last would take its reason along.
void find_ghosts(Seams& seams, std::uint32_t mover, std::span<const Seams::Side> of_whole, const Contacts& contacts,
                 const Shapes& shapes, const Bodies& bodies) {
    float small = 0.05f * shapes.pieces[mover].reach; // to a grain of sand, millimetres are real
    for (const Seams::Side& side : of_whole) {
        Touching ghost = seen(side, contacts, shapes, bodies);
        if (ghost.count == 0) continue;
        auto hides = [&](const Seams::Side& other) {
            return other.row != side.row && gives_way(shapes, ghost, seen(other, contacts, shapes, bodies), small);
        };
        if (std::ranges::any_of(of_whole, hides)) seams.hidden.push_back(side.row);
    }
}

// Only what belongs together hides each other: in a crowd a mover touches many that do not.
void find_ghosts(Seams& seams, std::uint32_t mover, const Contacts& contacts, const Shapes& shapes,
                 const Bodies& bodies) {
    auto& sides = seams.of_one;
    sides.clear();
    for (std::uint32_t i = seams.first[mover]; i != kNone; i = seams.sides[i].next) sides.push_back(seams.sides[i]);
    std::ranges::sort(sides, [](const Seams::Side& s, const Seams::Side& t) {
        return s.whole != t.whole ? s.whole < t.whole : s.row < t.row;
    });
    for (auto from = sides.begin(); from != sides.end();) {
        auto to = std::find_if(from, sides.end(), [&](const Seams::Side& s) { return s.whole != from->whole; });
        if (to - from > 1) find_ghosts(seams, mover, {from, to}, contacts, shapes, bodies);
        from = to;
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
    for (std::uint32_t row : seams.hidden) {
        contacts.rows[row].count = 0;
        contacts.scratch.marks[row] = marks_of(contacts.rows[row]);
    }
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
