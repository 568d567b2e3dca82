#include "collider/queries.hpp"

namespace evil {
namespace {

struct Exact { // a point or vector in a piece's frame, in double
    double x, y;
};
Exact operator-(Exact a, Exact b) { return {a.x - b.x, a.y - b.y}; }
double dot(Exact a, Exact b) { return a.x * b.x + a.y * b.y; }
Exact exact(Vec2 v) { return {v.x, v.y}; }
Exact along(Exact start, double t, Exact d) { return {start.x + t * d.x, start.y + t * d.y}; }

// A cosine and a sine of 32 bits are not quite of length 1: what undoes their rotation divides by what they are.
struct Unrotate {
    double c, s, over;
    explicit Unrotate(Rot q) : c(q.c), s(q.s), over(1.0 / (c * c + s * s)) {}
    Exact operator()(Exact v) const { return {(c * v.x + s * v.y) * over, (c * v.y - s * v.x) * over}; }
};
Exact to_local(const Pose& pose, Vec2 point) { return Unrotate(pose.q)(exact(point) - exact(pose.p)); }

Vec2 to_world(const Pose& pose, Exact normal) {
    double l = std::sqrt(dot(normal, normal)), over = l > 0.0 ? 1.0 / l : 0.0;
    Vec2 n{static_cast<float>(normal.x * over), static_cast<float>(normal.y * over)};
    return rotate(pose.q, n) + Vec2{}; // no -0
}

// A convex piece: corners, and how far its skin reaches out from them. A circle has one corner.
struct Outline {
    std::span<const Vec2> points, normals;
    double radius;
};
Outline outline_of(const Shapes& shapes, const Piece& piece) {
    if (piece.count == 0) return {{&piece.centre, 1}, {}, piece.radius};
    return {points_of(shapes, piece), normals_of(shapes, piece), piece.radius};
}
std::size_t next(const Outline& o, std::size_t i) { return i + 1 < o.points.size() ? i + 1 : 0; }

struct LocalEntry {
    double fraction = 2.0; // more than 1: none
    Exact normal{};
};

// Ray against circle: |s + t d - c|^2 = r^2, the smaller root.
void enter_circle(Exact centre, double radius, Exact start, Exact d, LocalEntry& best) {
    Exact s = start - centre;
    double a = dot(d, d), b = dot(s, d), c = dot(s, s) - radius * radius;
    double under = b * b - a * c;
    if (c < 0.0 || b >= 0.0 || under < 0.0 || a == 0.0) return;
    double t = std::max((-b - std::sqrt(under)) / a, 0.0);
    if (t < best.fraction) best = {t, along(s, t, d)};
}

// Ray against convex polygon: cut it by each edge's half plane (Cyrus and Beck 1978).
void enter_polygon(const Outline& o, Exact start, Exact d, LocalEntry& best) {
    double enter = -1.0, leave = 1.0;
    Exact normal{};
    for (std::size_t i = 0; i < o.points.size(); ++i) {
        Exact n = exact(o.normals[i]);
        double height = dot(n, start - exact(o.points[i])), slope = dot(n, d);
        if (slope == 0.0) {
            if (height > 0.0) return;
        } else if (slope < 0.0) {
            double t = -height / slope;
            if (t > enter) enter = t, normal = n;
        } else {
            leave = std::min(leave, -height / slope);
        }
        if (enter > leave) return;
    }
    if (enter >= 0.0) best = {enter, normal}; // else it starts inside, or leads away
}

// Ray against the edges, moved out by the skin, and the circles that it makes round the corners.
//
//       ____________
//     /  ._________.\      the skin of a piece starts at a corner's circle
//    |   |         | |     and goes on as an edge
void enter_rounded(const Outline& o, Exact start, Exact d, LocalEntry& best) {
    for (std::size_t i = 0; i < o.normals.size(); ++i) {
        Exact n = exact(o.normals[i]), from = along(exact(o.points[i]), o.radius, n);
        Exact edge = exact(o.points[next(o, i)]) - exact(o.points[i]);
        double height = dot(n, start - from), slope = dot(n, d);
        if (slope >= 0.0 || height < 0.0) continue;
        double t = -height / slope, at = dot(along(start, t, d) - from, edge);
        if (t < best.fraction && at >= 0.0 && at <= dot(edge, edge)) best = {t, n};
    }
    if (o.radius > 0.0)
        for (Vec2 corner : o.points) enter_circle(exact(corner), o.radius, start, d, best);
}

struct LocalNear {
    double distance; // from the corners' hull, without the skin
    Exact point;     // of the hull
};

LocalNear nearest_of_hull(const Outline& o, Exact p) {
    bool inside = o.points.size() > 2;
    LocalNear best{1e300, p};
    for (std::size_t i = 0; i < o.points.size(); ++i) {
        Exact a = exact(o.points[i]), edge = exact(o.points[next(o, i)]) - a, arm = p - a;
        if (inside && dot(exact(o.normals[i]), arm) > 0.0) inside = false;
        double whole = dot(edge, edge), t = whole > 0.0 ? std::clamp(dot(arm, edge) / whole, 0.0, 1.0) : 0.0;
        Exact q = along(a, t, edge), off = p - q;
        double distance = std::sqrt(dot(off, off));
        if (distance < best.distance) best = {distance, q};
    }
    return inside ? LocalNear{0.0, p} : best;
}

} // namespace

std::optional<Entry> enter(const Shapes& shapes, const Piece& piece, const Pose& pose, Vec2 start, Vec2 end) {
    Unrotate local(pose.q);
    Exact s = local(exact(start) - exact(pose.p)), d = local(exact(end) - exact(start));
    Outline o = outline_of(shapes, piece);
    LocalEntry best;
    if (piece.count == 0)
        enter_circle(exact(piece.centre), o.radius, s, d, best);
    else if (piece.count > 2 && piece.radius == 0.0f)
        enter_polygon(o, s, d, best);
    else if (nearest_of_hull(o, s).distance >= o.radius)
        enter_rounded(o, s, d, best);
    if (best.fraction > 1.0) return {};
    return Entry{best.fraction, to_world(pose, best.normal)};
}

bool contains(const Shapes& shapes, const Piece& piece, const Pose& pose, Vec2 point) {
    Outline o = outline_of(shapes, piece);
    return nearest_of_hull(o, to_local(pose, point)).distance <= o.radius;
}

Near nearest_point(const Shapes& shapes, const Piece& piece, const Pose& pose, Vec2 point) {
    Outline o = outline_of(shapes, piece);
    Exact p = to_local(pose, point);
    LocalNear near = nearest_of_hull(o, p);
    if (near.distance <= o.radius) return {0.0, point};
    Exact q = along(near.point, o.radius / near.distance, p - near.point);
    double c = pose.q.c, s = pose.q.s;
    Vec2 world{static_cast<float>(c * q.x - s * q.y + double(pose.p.x)),
               static_cast<float>(s * q.x + c * q.y + double(pose.p.y))};
    return {near.distance - o.radius, world};
}

} // namespace evil
