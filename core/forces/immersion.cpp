#include "forces/immersion.hpp"
#include "math/functions.hpp"

namespace evil {
namespace {

struct Disc {
    Vec2d centre;
    double radius;
};

double angle_between(Vec2d u, Vec2d v) { // from u to v, -pi to pi
    return double(atan2(static_cast<float>(cross(u, v)), static_cast<float>(dot(u, v))));
}

// Green's theorem over the triangles that the edges make with the first corner.
Immersion of_polygon(std::span<const Vec2d> corners) {
    Immersion sum;
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        Vec2d u = corners[i] - corners[0], v = corners[i + 1] - corners[0];
        double area = 0.5 * cross(u, v);
        sum = sum + Immersion{area, area * (corners[0] + (1.0 / 3.0) * (u + v))};
    }
    return sum;
}

// The polygon cut along one line of the other's edges (Sutherland and Hodgman 1974): what lies to its left stays.
void cut(std::span<const Vec2d> corners, Vec2d from, Vec2d to, std::vector<Vec2d>& left) {
    left.clear();
    Vec2d along = to - from;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        Vec2d p = corners[i], q = corners[i + 1 < corners.size() ? i + 1 : 0];
        double at_p = cross(along, p - from), at_q = cross(along, q - from);
        if (at_p >= 0.0) left.push_back(p);
        if ((at_p < 0.0) != (at_q < 0.0)) left.push_back(p + (at_p / (at_p - at_q)) * (q - p));
    }
}

Immersion polygon_in_polygon(std::vector<Vec2d>& corners, std::span<const Vec2> part, std::vector<Vec2d>& spare) {
    for (std::size_t i = 0; i < part.size() && corners.size() > 2; ++i) {
        cut(corners, wide(part[i]), wide(part[i + 1 < part.size() ? i + 1 : 0]), spare);
        std::swap(corners, spare);
    }
    return corners.size() > 2 ? of_polygon(corners) : Immersion{};
}

// Round the disc's centre: the triangle to a piece of an edge within it, or the sector to a piece outside.
Immersion triangle(Vec2d p, Vec2d q) {
    double area = 0.5 * cross(p, q);
    return {area, (area / 3.0) * (p + q)};
}
Immersion sector(Vec2d p, Vec2d q, double radius) {
    double turn = angle_between(p, q), lp = length(p), lq = length(q);
    if (!(lp > 0.0) || !(lq > 0.0)) return {};
    Vec2d u = (1.0 / lp) * p, v = (1.0 / lq) * q;
    double cube = radius * radius * radius / 3.0;
    return {0.5 * radius * radius * turn, cube * Vec2d{v.y - u.y, u.x - v.x}};
}

// Each edge of the polygon sweeps, seen from the disc's centre, triangles where it is inside and sectors elsewhere; with
// their signs they add up to what the two share.
Immersion edge_in_disc(Vec2d p, Vec2d q, double radius) {
    Vec2d d = q - p;
    double a = dot(d, d), b = dot(p, d), c = dot(p, p) - radius * radius, under = b * b - a * c;
    if (!(a > 0.0)) return {};
    if (!(under > 0.0)) return sector(p, q, radius);
    double root = std::sqrt(under), enter = (-b - root) / a, leave = (-b + root) / a;
    if (enter >= 1.0 || leave <= 0.0) return sector(p, q, radius);
    Vec2d in = enter > 0.0 ? p + enter * d : p, out = leave < 1.0 ? p + leave * d : q;
    Immersion sum = triangle(in, out);
    if (enter > 0.0) sum = sum + sector(p, in, radius);
    if (leave < 1.0) sum = sum + sector(out, q, radius);
    return sum;
}

Immersion polygon_in_disc(std::span<const Vec2d> corners, Disc disc) {
    Immersion sum;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        Vec2d next = corners[i + 1 < corners.size() ? i + 1 : 0];
        sum = sum + edge_in_disc(corners[i] - disc.centre, next - disc.centre, disc.radius);
    }
    sum.moment = sum.moment + sum.area * disc.centre;
    return sum;
}

Immersion of_disc(Disc d) {
    double area = kPi * d.radius * d.radius;
    return {area, area * d.centre};
}

// What a chord at signed distance `to_chord` from the centre leaves of the disc beyond it, towards unit vector `out`.
Immersion segment(Disc d, Vec2d out, double to_chord) {
    double c = std::clamp(to_chord / d.radius, -1.0, 1.0), s = std::sqrt(1.0 - c * c);
    double half = double(atan2(static_cast<float>(s), static_cast<float>(c))), square = d.radius * d.radius;
    double area = square * (half - s * c);
    return {area, area * d.centre + (2.0 / 3.0 * square * d.radius * s * s * s) * out};
}

//      ( a  (x) b  )      the lens is a segment of each, on either side of the chord through where the circles cross
Immersion disc_in_disc(Disc a, Disc b) {
    Vec2d between = b.centre - a.centre;
    double distance = length(between);
    if (distance >= a.radius + b.radius) return {};
    if (distance <= std::abs(a.radius - b.radius)) return of_disc(a.radius < b.radius ? a : b);
    Vec2d out = (1.0 / distance) * between;
    double chord = 0.5 * (distance + (a.radius * a.radius - b.radius * b.radius) / distance);
    return segment(a, out, chord) + segment(b, -out, distance - chord);
}

// The corners, each with a fan of short edges round it where the piece has a skin. They lie so far out that the fan's area
// is that of the arc.
constexpr int kFan = 8; // edges of a right angle
void outline_of(const Shapes& shapes, const Piece& piece, const Pose& pose, std::vector<Vec2d>& outline) {
    outline.clear();
    std::span<const Vec2> points = points_of(shapes, piece), normals = normals_of(shapes, piece);
    for (std::size_t i = 0; i < points.size(); ++i) {
        Vec2d corner = wide(transform(pose, points[i]));
        if (piece.radius == 0.0f) {
            outline.push_back(corner);
            continue;
        }
        Vec2d from = wide(rotate(pose.q, normals[i > 0 ? i - 1 : points.size() - 1]));
        double turn = angle_between(from, wide(rotate(pose.q, normals[i])));
        if (turn < 0.0) turn += 2.0 * kPi; // the two ends of a segment turn by half a turn, to the left
        int edges = std::max(1, static_cast<int>(std::ceil(turn / (0.5 * kPi) * kFan)));
        double step = turn / edges;
        SinCos by = sincos(step);
        double radius = double(piece.radius) * (step > 1e-6 ? std::sqrt(step / std::max(double(by.sin), 1e-9)) : 1.0);
        Vec2d ray = from;
        for (int k = 0; k <= edges; ++k) {
            outline.push_back(corner + radius * ray);
            ray = {double(by.cos) * ray.x - double(by.sin) * ray.y, double(by.sin) * ray.x + double(by.cos) * ray.y};
        }
    }
}

bool has_extent(const Piece& piece) { return piece.count == 0 || piece.count > 2 || piece.radius > 0.0f; }

} // namespace

Immersion immersion(const Shapes& shapes, const Piece& piece, const Pose& pose, const Area& area,
                    ImmersionScratch& scratch) {
    Immersion sum;
    if (!has_extent(piece)) return sum;
    bool round = piece.count == 0;
    Disc disc{wide(transform(pose, piece.centre)), double(piece.radius)};
    if (area.radius > 0.0f) {
        Disc whole{wide(area.centre), double(area.radius)};
        if (round) return disc_in_disc(disc, whole);
        outline_of(shapes, piece, pose, scratch.outline);
        return polygon_in_disc(scratch.outline, whole);
    }
    for (const std::vector<Vec2>& part : area.parts) {
        scratch.outline.clear();
        if (round)
            for (Vec2 corner : part) scratch.outline.push_back(wide(corner));
        else
            outline_of(shapes, piece, pose, scratch.outline);
        sum = sum + (round ? polygon_in_disc(scratch.outline, disc)
                           : polygon_in_polygon(scratch.outline, part, scratch.clipped));
    }
    return sum;
}

double area_of(const Shapes& shapes, const Piece& piece) {
    if (piece.count == 0) return kPi * double(piece.radius) * double(piece.radius);
    if (!has_extent(piece)) return 0.0;
    std::span<const Vec2> points = points_of(shapes, piece);
    double area = 0.0, round = 0.0, r = double(piece.radius);
    for (std::size_t i = 0; i < points.size(); ++i) {
        Vec2d p = wide(points[i]), q = wide(points[i + 1 < points.size() ? i + 1 : 0]), o = wide(points[0]);
        area += 0.5 * cross(p - o, q - o);
        round += length(q - p);
    }
    return area + round * r + kPi * r * r;
}

} // namespace evil
