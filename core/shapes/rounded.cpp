#include "shapes/rounded.hpp"
#include "math/functions.hpp"
#include "math/vec2d.hpp"
#include <algorithm>
#include <cmath>

namespace evil {
namespace {

Vec2d outward(Vec2d a, Vec2d b) { // of the edge from a to b of a counter-clockwise outline
    Vec2d d = b - a;
    double l = length(d);
    return l > 0.0 ? Vec2d{d.y / l, -d.x / l} : Vec2d{};
}

// Area, first and second moment about the first corner, of a sum of simple pieces.
struct Sum {
    double area = 0.0, x = 0.0, y = 0.0, second = 0.0;

    void triangle(Vec2d a, Vec2d b, Vec2d c) { // signed: counter-clockwise adds
        double part = 0.5 * cross(b - a, c - a);
        area += part;
        x += part * (a.x + b.x + c.x) / 3.0;
        y += part * (a.y + b.y + c.y) / 3.0;
        second += part * (dot(a, a) + dot(b, b) + dot(c, c) + dot(a, b) + dot(b, c) + dot(c, a)) / 6.0;
    }
    // Of the disc of radius r round c, what lies from direction m to direction n, by the left.
    void sector(Vec2d c, Vec2d m, Vec2d n, double r) {
        double angle = double{evil::atan2(static_cast<float>(cross(m, n)), static_cast<float>(dot(m, n)))};
        if (angle < 0.0 || (angle == 0.0 && dot(m, n) < 0.0)) angle += 2.0 * kPi; // back at a line's end: half a turn
        double part = 0.5 * r * r * angle, cubed = r * r * r / 3.0;
        Vec2d first{cubed * (n.y - m.y), cubed * (m.x - n.x)}; // about c
        area += part;
        x += part * c.x + first.x;
        y += part * c.y + first.y;
        second += part * dot(c, c) + 2.0 * dot(c, first) + 0.5 * r * r * part;
    }
    MassProperties mass(Vec2 origin, double density) const {
        if (!(area > 0.0)) return {};
        double cx = x / area, cy = y / area;
        double about_centre = std::max(second - area * (cx * cx + cy * cy), 0.0);
        return {area * density,
                about_centre * density,
                {static_cast<float>(origin.x + cx), static_cast<float>(origin.y + cy)}};
    }
};

// The corner moved so that both its edges move in by the radius.
Vec2d moved_in(Vec2d before, Vec2d at, Vec2d after, double radius) {
    Vec2d m = outward(before, at), n = outward(at, after);
    return at - (radius / std::max(1.0 + dot(m, n), 1e-9)) * (m + n);
}

} // namespace

OwnedRings inset(const Rings& rings, float radius) {
    OwnedRings core{std::vector<Vec2>(rings.corners.size()), {rings.holes.begin(), rings.holes.end()}};
    for (std::size_t i = 0; i < rings.count(); ++i) {
        std::span<const Vec2> ring = rings.ring(i);
        std::span<Vec2> moved = std::span(core.corners).subspan(rings.first(i), ring.size());
        std::size_t n = ring.size();
        for (std::size_t k = 0; k < n; ++k)
            moved[k] = narrow(moved_in(wide(ring[k > 0 ? k - 1 : n - 1]), wide(ring[k]),
                                       wide(ring[k + 1 < n ? k + 1 : 0]), double{radius}));
        for (std::size_t k = 0; k < n; ++k) {
            std::size_t j = k + 1 < n ? k + 1 : 0;
            if (!(dot(moved[j] - moved[k], ring[j] - ring[k]) > 0.0f)) return {};
        }
    }
    bool usable = check_polygon(core).fault == PolygonFault::none && signed_area(Rings(core).ring(0)) > 0.0;
    return usable ? core : OwnedRings{};
}

float largest_inset(const Rings& rings) {
    Vec2 low = rings.corners[0], high = rings.corners[0];
    for (Vec2 c : rings.corners) {
        low = min(low, c);
        high = max(high, c);
    }
    float fits = 0.0f, fails = std::max(high.x - low.x, high.y - low.y);
    for (int halving = 0; halving < 40 && fails - fits > 1e-3f * fits; ++halving) {
        float middle = 0.5f * (fits + fails);
        (inset(rings, middle).corners.empty() ? fails : fits) = middle;
    }
    return fits;
}

// The core, a strip along each edge, and at each corner the sector between two strips; where the outline turns inward two
// strips overlap in a kite, which is taken out once.
MassProperties rounded_mass(const Rings& rings, float radius, float density) noexcept {
    double r = double{radius};
    Vec2d origin = wide(rings.corners[0]);
    Sum sum;
    for (std::size_t ring = 0; ring < rings.count(); ++ring) {
        std::span<const Vec2> corners = rings.ring(ring);
        std::size_t n = corners.size();
        auto at = [&](std::size_t i) { return wide(corners[i % n]) - origin; };
        for (std::size_t i = 2; i < n; ++i) sum.triangle(at(0), at(i - 1), at(i));
        for (std::size_t i = 0; i < n && r > 0.0; ++i) {
            Vec2d p = at(i), q = at(i + 1), s = at(i + 2), m = outward(p, q), k = outward(q, s);
            sum.triangle(p, p + r * m, q + r * m);
            sum.triangle(p, q + r * m, q);
            if (n == 2 || cross(m, k) >= 0.0) {
                sum.sector(q, m, k, r);
            } else {
                Vec2d kite = q + (r / std::max(1.0 + dot(m, k), 1e-9)) * (m + k);
                sum.triangle(q, q + r * m, kite); // clockwise here, so these two count as negative
                sum.triangle(q, kite, q + r * k);
            }
        }
    }
    return sum.mass(rings.corners[0], double{density});
}

MassProperties path_mass(std::span<const Vec2> points, bool closed, float density) noexcept {
    std::size_t n = points.size(), edges = closed ? n : n - 1;
    double length = 0.0, x = 0.0, y = 0.0, second = 0.0;
    for (std::size_t i = 0; i < edges; ++i) {
        Vec2d a = wide(points[i]) - wide(points[0]), b = wide(points[i + 1 < n ? i + 1 : 0]) - wide(points[0]);
        double l = evil::length(b - a);
        length += l;
        x += 0.5 * l * (a.x + b.x);
        y += 0.5 * l * (a.y + b.y);
        second += l * (dot(a, a) + dot(a, b) + dot(b, b)) / 3.0;
    }
    if (!(length > 0.0)) return {};
    x /= length;
    y /= length;
    double weight = double{kRod} * double{density};
    return {length * weight,
            std::max(second - length * (x * x + y * y), 0.0) * weight,
            {static_cast<float>(points[0].x + x), static_cast<float>(points[0].y + y)}};
}

namespace {

void round_ring(std::span<const Vec2> corners, float radius, std::vector<Vec2>& outline) {
    constexpr double kStep = kPi / 32.0; // radians between corners of an arc
    std::size_t n = corners.size();
    bool square_ends = n == 2 && radius == 0.0f;
    double r = square_ends ? 0.5 * double{kLine} : double{radius};
    for (std::size_t i = 0; i < n; ++i) {
        Vec2d p = wide(corners[i > 0 ? i - 1 : n - 1]), q = wide(corners[i]), s = wide(corners[i + 1 < n ? i + 1 : 0]);
        Vec2d m = outward(p, q), k = outward(q, s);
        if (n > 2 && cross(m, k) <= 1e-6) { // straight on, or inward: the edges meet in one place
            outline.push_back(narrow(q + (r / std::max(1.0 + dot(m, k), 1e-9)) * (m + k)));
            continue;
        }
        double angle =
            n == 2 ? kPi : double{evil::atan2(static_cast<float>(cross(m, k)), static_cast<float>(dot(m, k)))};
        int steps = square_ends ? 1 : static_cast<int>(std::ceil(angle / kStep));
        for (int step = 0; step <= steps; ++step) {
            SinCos turn = sincos(angle * step / steps);
            double c = double{turn.cos}, d = double{turn.sin};
            outline.push_back(narrow(q + r * Vec2d{c * m.x - d * m.y, d * m.x + c * m.y}));
        }
    }
}

} // namespace

OwnedRings rounded_outline(const Rings& rings, float radius) {
    if (radius == 0.0f && rings.corners.size() > 2)
        return {{rings.corners.begin(), rings.corners.end()}, {rings.holes.begin(), rings.holes.end()}};
    OwnedRings outline;
    for (std::size_t i = 0; i < rings.count(); ++i) {
        if (i > 0) outline.holes.push_back(static_cast<std::uint32_t>(outline.corners.size()));
        round_ring(rings.ring(i), radius, outline.corners);
    }
    return outline;
}

std::vector<Vec2> path_outline(std::span<const Vec2> points, bool closed) {
    constexpr double kSharpest = 0.25; // of the cosine of half a bend: at sharper ones the corner would stand out far
    std::vector<Vec2d> path;
    for (Vec2 p : points) path.push_back(wide(p));
    if (closed) {
        Vec2d along = path[1] - path[0];
        path.push_back(path[0]);
        path.push_back(path[0] + 0.4999 * along);
        path[0] = path[0] + 0.5 * along;
    }
    std::size_t n = path.size();
    double half = 0.5 * double{kLine};
    std::vector<Vec2> right, left;
    for (std::size_t i = 0; i < n; ++i) {
        Vec2d m = outward(path[i > 0 ? i - 1 : 0], path[i > 0 ? i : 1]);
        Vec2d k = outward(path[i + 1 < n ? i : n - 2], path[i + 1 < n ? i + 1 : n - 1]);
        Vec2d off = (half / std::max(1.0 + dot(m, k), 2.0 * kSharpest * kSharpest)) * (m + k);
        right.push_back(narrow(path[i] + off));
        left.push_back(narrow(path[i] - off));
    }
    right.insert(right.end(), left.rbegin(), left.rend());
    return right;
}

OwnedRings drawn_outline(const Shape& shape, const Rings& rings) {
    switch (shape.kind) {
    case ShapeKind::circle:
    case ShapeKind::particle:
        return {};
    case ShapeKind::polygon:
    case ShapeKind::line:
        return rounded_outline(rings, shape.radius);
    case ShapeKind::chain:
        return {path_outline(rings.corners, shape.closed), {}};
    }
    return {};
}

} // namespace evil
