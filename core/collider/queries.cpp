#include "collider/queries.hpp"

namespace evil {
namespace {

struct Entry {
    double fraction; // in double: a long ray still meets its target to the millimetre
    Vec2 normal;     // body frame
};

// Ray against circle: |p + t d - c|^2 = r^2, the smaller root.
std::optional<Entry> enter_circle(const Piece& piece, Vec2 start, Vec2 d) {
    double x = double(start.x) - piece.centre.x, y = double(start.y) - piece.centre.y;
    double a = double(d.x) * d.x + double(d.y) * d.y, b = x * d.x + y * d.y;
    double c = x * x + y * y - double(piece.radius) * piece.radius;
    double under = b * b - a * c;
    if (c < 0.0 || b >= 0.0 || under < 0.0 || a == 0.0) return {};
    double t = (-b - std::sqrt(under)) / a;
    if (t > 1.0) return {};
    t = std::max(t, 0.0);
    return Entry{t, normalised(Vec2{static_cast<float>(x + t * d.x), static_cast<float>(y + t * d.y)})};
}

// Ray against convex polygon: cut it by each edge's half plane (Cyrus and Beck 1978).
std::optional<Entry> enter_polygon(std::span<const Vec2> points, std::span<const Vec2> normals, Vec2 start, Vec2 d) {
    double enter = -1.0, leave = 1.0;
    Vec2 normal;
    for (std::size_t i = 0; i < points.size(); ++i) {
        Vec2 n = normals[i];
        double height = double(n.x) * (double(start.x) - points[i].x) + double(n.y) * (double(start.y) - points[i].y);
        double slope = double(n.x) * d.x + double(n.y) * d.y;
        if (slope == 0.0) {
            if (height > 0.0) return {};
        } else if (slope < 0.0) {
            double t = -height / slope;
            if (t > enter) enter = t, normal = n;
        } else {
            leave = std::min(leave, -height / slope);
        }
        if (enter > leave) return {};
    }
    if (enter < 0.0) return {}; // it starts inside, or leads away
    return Entry{enter, normal};
}

// Every live piece, by the order in which bodies and shapes were numbered.
template <class Visit> void for_each_piece(const Shapes& shapes, const Bodies& bodies, Visit&& visit) {
    for (std::uint32_t p = 0; p < shapes.piece_slots.size(); ++p)
        if (shapes.piece_slots.taken(p)) visit(shapes.pieces[p], bodies.rows[shapes.pieces[p].body]);
}

void add_once(std::vector<std::uint32_t>& found, std::uint32_t body) {
    if (std::ranges::find(found, body) == found.end()) found.push_back(body);
}

void by_creation(const Bodies& bodies, std::vector<std::uint32_t>& found) {
    std::ranges::sort(found, {}, [&](std::uint32_t body) { return bodies.rows[body].serial; });
}

} // namespace

std::optional<RayHit> ray_cast(const Shapes& shapes, const Bodies& bodies, Vec2 start, Vec2 end,
                               std::optional<BodyKind> only) {
    RayHit best;
    double nearest = 1.0;
    for_each_piece(shapes, bodies, [&](const Piece& piece, const Body& body) {
        if (only && body.kind != *only) return;
        Vec2 s = untransform(body.pose, start), d = unrotate(body.pose.q, end - start);
        std::optional<Entry> hit = piece.count == 0
                                       ? enter_circle(piece, s, d)
                                       : enter_polygon(points_of(shapes, piece), normals_of(shapes, piece), s, d);
        if (!hit || hit->fraction > nearest || (hit->fraction == nearest && best.body != kNone)) return;
        double t = nearest = hit->fraction;
        Vec2 point{static_cast<float>(start.x + t * (double(end.x) - start.x)),
                   static_cast<float>(start.y + t * (double(end.y) - start.y))};
        Vec2 normal = rotate(body.pose.q, hit->normal) + Vec2{}; // no -0
        best = {piece.shape, piece.body, point, normal, static_cast<float>(t)};
    });
    if (best.body == kNone) return {};
    return best;
}

bool contains(const Shapes& shapes, const Piece& piece, const Pose& pose, Vec2 point) {
    Vec2 local = untransform(pose, point);
    if (piece.count == 0) return length_squared(local - piece.centre) <= piece.radius * piece.radius;
    std::span<const Vec2> points = points_of(shapes, piece), normals = normals_of(shapes, piece);
    for (std::size_t i = 0; i < points.size(); ++i)
        if (dot(normals[i], local - points[i]) > 0.0f) return false;
    return true;
}

void bodies_at(const Shapes& shapes, const Bodies& bodies, Vec2 point, std::vector<std::uint32_t>& found) {
    for_each_piece(shapes, bodies, [&](const Piece& piece, const Body& body) {
        if (contains(shapes, piece, body.pose, point)) add_once(found, piece.body);
    });
    by_creation(bodies, found);
}

void bodies_overlapping(const Shapes& shapes, const Bodies& bodies, const Shapes& probe,
                        std::vector<std::uint32_t>& found) {
    for (std::uint32_t q = 0; q < probe.piece_slots.size(); ++q) {
        const Piece& mine = probe.pieces[q];
        Bounds bounds = bounds_of(probe, mine, Pose{});
        for_each_piece(shapes, bodies, [&](const Piece& piece, const Body& body) {
            if (!overlap(bounds, bounds_of(shapes, piece, body.pose))) return;
            Axis none;
            if (collide(place(probe, mine, Pose{}), place(shapes, piece, body.pose), 0.0f, none).count > 0)
                add_once(found, piece.body);
        });
    }
    by_creation(bodies, found);
}

} // namespace evil
