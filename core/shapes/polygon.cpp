#include "shapes/polygon.hpp"
#include "math/functions.hpp"
#include "shapes/orientation.hpp"
#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <tuple>

namespace evil {
namespace {

using Corners = std::span<const Vec2>;
constexpr PolygonProblem kFine{};

PolygonProblem check_coordinates(Corners corners) {
    for (std::uint32_t i = 0; i < corners.size(); ++i)
        if (!is_finite(corners[i])) return {PolygonFault::not_finite, i, i};
    for (std::uint32_t i = 0; i < corners.size(); ++i)
        if (std::fabs(corners[i].x) > kMaxCoordinate || std::fabs(corners[i].y) > kMaxCoordinate)
            return {PolygonFault::too_large, i, i};
    return kFine;
}

// Sorted from left to right, a corner needs comparing only with the few that follow within reach.
PolygonProblem check_repeated(Corners corners) {
    std::vector<std::uint32_t> order(corners.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::sort(order, {}, [&](std::uint32_t i) { return std::tuple(corners[i].x, corners[i].y, i); });
    for (std::size_t i = 0; i < order.size(); ++i)
        for (std::size_t j = i + 1; j < order.size(); ++j) {
            Vec2 a = corners[order[i]], b = corners[order[j]];
            if (b.x - a.x >= kMinFeature) break;
            if (std::fabs(b.y - a.y) < kMinFeature)
                return {PolygonFault::repeated_corner, std::min(order[i], order[j]), std::max(order[i], order[j])};
        }
    return kFine;
}

// Do the closed segments pq and rs share a point? Each must have its ends on both sides of the other, or on it; in line, their
// bounds decide, which the caller has looked at.
bool meet(Vec2 p, Vec2 q, Vec2 r, Vec2 s) {
    return turn(p, q, r) * turn(p, q, s) <= 0 && turn(r, s, p) * turn(r, s, q) <= 0;
}

// Does the path p, q, r turn straight back at q?
bool folds_back(Vec2 p, Vec2 q, Vec2 r) {
    if (turn(p, q, r) != 0) return false;
    return p.x != q.x ? (p.x < q.x) != (q.x < r.x) : (p.y < q.y) != (q.y < r.y);
}

struct EdgeBounds {
    Vec2 low, high;
    std::uint32_t edge; // from this corner to the next
};

PolygonProblem check_crossing(const Rings& rings) {
    Corners corners = rings.corners;
    std::vector<std::uint32_t> after = followers(rings);
    std::size_t n = corners.size();
    std::vector<EdgeBounds> edges(n);
    for (std::uint32_t i = 0; i < n; ++i) {
        Vec2 a = corners[i], b = corners[after[i]];
        if (folds_back(a, b, corners[after[after[i]]])) return {PolygonFault::crossing_edges, i, after[i]};
        edges[i] = {min(a, b), max(a, b), i};
    }
    std::ranges::sort(edges, {}, [](const EdgeBounds& e) { return std::tuple(e.low.x, e.edge); });
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i + 1; j < n && edges[j].low.x <= edges[i].high.x; ++j) {
            if (edges[j].low.y > edges[i].high.y || edges[j].high.y < edges[i].low.y) continue;
            std::uint32_t a = std::min(edges[i].edge, edges[j].edge), b = std::max(edges[i].edge, edges[j].edge);
            if (after[a] == b || after[b] == a) continue; // neighbours meet in their common corner
            if (meet(corners[a], corners[after[a]], corners[b], corners[after[b]]))
                return {PolygonFault::crossing_edges, a, b};
        }
    return kFine;
}

struct Bounds {
    Vec2 low, high;
};
Bounds bounds_of(Corners ring) {
    Bounds bounds{ring[0], ring[0]};
    for (Vec2 c : ring) bounds = {min(bounds.low, c), max(bounds.high, c)};
    return bounds;
}

bool all_in_line(Corners ring) {
    return std::ranges::all_of(ring.subspan(2), [&](Vec2 c) { return turn(ring[0], ring[1], c) == 0; });
}

bool is_too_thin(Corners ring) {
    Bounds b = bounds_of(ring);
    double extent = std::max(double{b.high.x} - b.low.x, double{b.high.y} - b.low.y);
    return std::fabs(signed_area(ring)) < kMinFeature * extent;
}

// Even-odd along a ray to the right; `p` lies on no edge.
bool is_inside(Corners ring, Vec2 p) {
    bool inside = false;
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
        Vec2 low = ring[i].y < ring[j].y ? ring[i] : ring[j], high = ring[i].y < ring[j].y ? ring[j] : ring[i];
        if (low.y <= p.y && p.y < high.y && turn(low, high, p) > 0) inside = !inside;
    }
    return inside;
}

// Where no edges meet, one corner of a ring tells for all of it on which side of another it lies.
PolygonProblem check_nesting(const Rings& rings) {
    std::vector<Bounds> bounds;
    for (std::size_t i = 0; i < rings.count(); ++i) bounds.push_back(bounds_of(rings.ring(i)));
    auto lies_in = [&](std::size_t i, std::size_t j) {
        Vec2 p = rings.ring(i)[0], low = bounds[j].low, high = bounds[j].high;
        bool near = p.x >= low.x && p.x <= high.x && p.y >= low.y && p.y <= high.y;
        return near && is_inside(rings.ring(j), p);
    };
    for (std::uint32_t i = 1; i < rings.count(); ++i) {
        if (!lies_in(i, 0)) return {PolygonFault::hole_outside, i, 0};
        for (std::uint32_t j = 1; j < rings.count(); ++j)
            if (j != i && lies_in(i, j)) return {PolygonFault::hole_in_a_hole, i, j};
    }
    return kFine;
}

} // namespace

std::vector<std::uint32_t> followers(const Rings& rings) {
    std::vector<std::uint32_t> after(rings.corners.size());
    std::iota(after.begin(), after.end(), 1u);
    for (std::size_t i = 0; i < rings.count(); ++i)
        after[rings.end(i) - 1] = static_cast<std::uint32_t>(rings.first(i));
    return after;
}

PolygonProblem check_polygon(const Rings& rings) {
    for (std::uint32_t i = 0; i < rings.count(); ++i)
        if (rings.ring(i).size() < 3) return {PolygonFault::too_few_corners, i};
    if (rings.corners.size() > kMaxCorners) return {PolygonFault::too_many_corners};
    if (PolygonProblem p = check_coordinates(rings.corners); p != kFine) return p;
    if (PolygonProblem p = check_repeated(rings.corners); p != kFine) return p;
    for (std::uint32_t i = 0; i < rings.count(); ++i)
        if (all_in_line(rings.ring(i))) return {PolygonFault::zero_area, i};
    if (PolygonProblem p = check_crossing(rings); p != kFine) return p;
    for (std::uint32_t i = 0; i < rings.count(); ++i)
        if (is_too_thin(rings.ring(i))) return {PolygonFault::zero_area, i};
    return check_nesting(rings);
}

namespace {

// Corners and rings in words. Those of a hole are counted from its own first one.
class Words {
public:
    explicit Words(const Rings& rings) : rings_(rings) {}

    static std::string number(double value) {
        char text[32];
        return std::string(text, std::to_chars(text, text + sizeof text, value, std::chars_format::general, 6).ptr);
    }
    std::string corner(std::uint32_t i) const {
        Vec2 at = rings_.corners[i];
        return std::to_string(i - first(i)) + " (" + number(at.x) + ", " + number(at.y) + ")" + of_hole(i);
    }
    std::string edge(std::uint32_t i) const {
        std::size_t n = rings_.ring(ring(i)).size(), k = i - first(i);
        return std::to_string(k) + "-" + std::to_string(k + 1 == n ? 0 : k + 1) + of_hole(i);
    }
    static std::string hole(std::uint32_t ring) { return "holes[" + std::to_string(ring - 1) + "]"; }

private:
    std::size_t ring(std::uint32_t i) const {
        return static_cast<std::size_t>(std::ranges::upper_bound(rings_.holes, i) - rings_.holes.begin());
    }
    std::size_t first(std::uint32_t i) const { return rings_.first(ring(i)); }
    std::string of_hole(std::uint32_t i) const {
        return ring(i) == 0 ? "" : " of " + hole(static_cast<std::uint32_t>(ring(i)));
    }
    const Rings& rings_;
};

} // namespace

std::string describe(const PolygonProblem& problem, const Rings& rings) {
    Words words(rings);
    std::uint32_t i = problem.first, j = problem.second;
    bool in_hole = i > 0;
    switch (problem.fault) {
    case PolygonFault::none:
        return "nothing is wrong";
    case PolygonFault::too_few_corners:
        return std::to_string(rings.ring(i).size()) + " corners " + (in_hole ? "of " + words.hole(i) + " " : "") +
               "are too few; a " + (in_hole ? "hole" : "polygon") + " needs 3 or more";
    case PolygonFault::too_many_corners:
        return std::to_string(rings.corners.size()) + " corners are too many; at most " + std::to_string(kMaxCorners) +
               " are allowed";
    case PolygonFault::not_finite:
        return "corner " + words.corner(i) + " must be finite; NaN or infinity came in";
    case PolygonFault::too_large:
        return "corner " + words.corner(i) + " is too far out; coordinates may be " + words.number(kMaxCoordinate) +
               " metres at most";
    case PolygonFault::repeated_corner:
        return "corners " + words.corner(i) + " and " + words.corner(j) + " are nearer than " +
               words.number(kMinFeature) + " metres; leave one out (the last corner need not repeat the first)";
    case PolygonFault::crossing_edges:
        return "edges " + words.edge(i) + " and " + words.edge(j) +
               " cross or touch; give the corners in order round the outline" +
               (rings.count() > 1 ? ", and holes within it and apart from each other" : "");
    case PolygonFault::zero_area:
        return in_hole ? "the corners of " + words.hole(i) + " lie in one line, or nearly; a hole needs an area"
                       : "the corners lie in one line, or nearly; a polygon needs an area";
    case PolygonFault::hole_outside:
        return words.hole(i) + " lies outside the outline; a hole must be within it";
    case PolygonFault::hole_in_a_hole:
        return words.hole(i) + " lies within " + words.hole(j) + "; what is solid there is a polygon of its own";
    }
    return "unknown";
}

double signed_area(Corners corners) noexcept {
    double twice = 0.0;
    for (std::size_t i = 2; i < corners.size(); ++i) { // triangles from corner 0: their signs add up
        double ax = double{corners[i - 1].x} - corners[0].x, ay = double{corners[i - 1].y} - corners[0].y;
        double bx = double{corners[i].x} - corners[0].x, by = double{corners[i].y} - corners[0].y;
        twice += ax * by - ay * bx;
    }
    return twice / 2.0;
}

void make_counter_clockwise(std::span<Vec2> ring) noexcept {
    if (signed_area(ring) < 0.0) std::ranges::reverse(ring.subspan(1));
}

void turn_rings(std::span<Vec2> corners, std::span<const std::uint32_t> holes) noexcept {
    Rings rings(corners, holes);
    make_counter_clockwise(corners.first(rings.end(0)));
    for (std::size_t i = 1; i < rings.count(); ++i) {
        std::span<Vec2> hole = corners.subspan(rings.first(i), rings.ring(i).size());
        if (signed_area(hole) > 0.0) std::ranges::reverse(hole.subspan(1));
    }
}

bool is_convex(Corners corners) noexcept {
    std::size_t n = corners.size();
    for (std::size_t i = 0; i < n; ++i)
        if (turn(corners[i], corners[(i + 1) % n], corners[(i + 2) % n]) < 0) return false;
    return n >= 3;
}

MassProperties circle_mass(float radius, float density) noexcept {
    double square = double{radius} * radius, mass = density * kPi * square;
    return {mass, mass * square / 2.0, {}};
}

// A triangle (0, a, b) of area A has its centre at (a + b) / 3 and the second moment A (a.a + a.b + b.b) / 6 about 0.
// Sums over the triangles from corner 0, signed, give the polygon's; then the parallel axis theorem moves to the centre.
MassProperties polygon_mass(Corners corners, float density) noexcept {
    double area = 0.0, x = 0.0, y = 0.0, moment = 0.0;
    for (std::size_t i = 2; i < corners.size(); ++i) {
        double ax = double{corners[i - 1].x} - corners[0].x, ay = double{corners[i - 1].y} - corners[0].y;
        double bx = double{corners[i].x} - corners[0].x, by = double{corners[i].y} - corners[0].y;
        double part = (ax * by - ay * bx) / 2.0;
        area += part;
        x += part * (ax + bx) / 3.0;
        y += part * (ay + by) / 3.0;
        moment += part * (ax * ax + ay * ay + ax * bx + ay * by + bx * bx + by * by) / 6.0;
    }
    if (area == 0.0) return {};
    x /= area;
    y /= area;
    double about_centre = (moment - area * (x * x + y * y)) * density;
    return {std::fabs(area) * density,
            std::fabs(about_centre),
            {static_cast<float>(corners[0].x + x), static_cast<float>(corners[0].y + y)}};
}

// Andrew 1979: from left to right along the bottom, then back along the top, dropping corners that do not turn left.
std::vector<std::uint32_t> convex_hull(Corners points) {
    std::vector<std::uint32_t> order(points.size()), hull;
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::sort(order, {}, [&](std::uint32_t i) { return std::tuple(points[i].x, points[i].y, i); });
    auto same = [&](std::uint32_t i, std::uint32_t j) { return points[i] == points[j]; };
    order.erase(std::unique(order.begin(), order.end(), same), order.end());
    if (order.size() < 3) return order;
    auto walk = [&](auto begin, auto end) {
        std::size_t start = hull.size();
        for (auto i = begin; i != end; ++i) {
            while (hull.size() >= start + 2 &&
                   turn(points[hull[hull.size() - 2]], points[hull.back()], points[*i]) <= 0)
                hull.pop_back();
            hull.push_back(*i);
        }
        hull.pop_back(); // the first of the other walk
    };
    walk(order.begin(), order.end());
    walk(order.rbegin(), order.rend());
    return hull;
}

} // namespace evil
