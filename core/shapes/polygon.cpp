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

std::uint32_t after(std::uint32_t i, std::size_t n) { return i + 1 == n ? 0 : i + 1; }

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

bool all_in_line(Corners corners) {
    return std::ranges::all_of(corners.subspan(2), [&](Vec2 c) { return turn(corners[0], corners[1], c) == 0; });
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

PolygonProblem check_crossing(Corners corners) {
    std::size_t n = corners.size();
    std::vector<EdgeBounds> edges(n);
    for (std::uint32_t i = 0; i < n; ++i) {
        Vec2 a = corners[i], b = corners[after(i, n)];
        if (folds_back(a, b, corners[after(after(i, n), n)])) return {PolygonFault::crossing_edges, i, after(i, n)};
        edges[i] = {min(a, b), max(a, b), i};
    }
    std::ranges::sort(edges, {}, [](const EdgeBounds& e) { return std::tuple(e.low.x, e.edge); });
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i + 1; j < n && edges[j].low.x <= edges[i].high.x; ++j) {
            if (edges[j].low.y > edges[i].high.y || edges[j].high.y < edges[i].low.y) continue;
            std::uint32_t a = std::min(edges[i].edge, edges[j].edge), b = std::max(edges[i].edge, edges[j].edge);
            if (after(a, n) == b || after(b, n) == a) continue; // neighbours meet in their common corner
            if (meet(corners[a], corners[after(a, n)], corners[b], corners[after(b, n)]))
                return {PolygonFault::crossing_edges, a, b};
        }
    return kFine;
}

bool is_too_thin(Corners corners) {
    Vec2 low = corners[0], high = corners[0];
    for (Vec2 c : corners) {
        low = min(low, c);
        high = max(high, c);
    }
    double extent = std::max(double{high.x} - low.x, double{high.y} - low.y);
    return std::fabs(signed_area(corners)) < kMinFeature * extent;
}

} // namespace

PolygonProblem check_polygon(Corners corners) {
    if (corners.size() < 3) return {PolygonFault::too_few_corners};
    if (corners.size() > kMaxCorners) return {PolygonFault::too_many_corners};
    if (PolygonProblem p = check_coordinates(corners); p != kFine) return p;
    if (PolygonProblem p = check_repeated(corners); p != kFine) return p;
    if (all_in_line(corners)) return {PolygonFault::zero_area};
    if (PolygonProblem p = check_crossing(corners); p != kFine) return p;
    return is_too_thin(corners) ? PolygonProblem{PolygonFault::zero_area} : kFine;
}

std::string describe(const PolygonProblem& problem, Corners corners) {
    auto number = [](double value) {
        char text[32];
        return std::string(text, std::to_chars(text, text + sizeof text, value, std::chars_format::general, 6).ptr);
    };
    auto corner = [&](std::uint32_t i) {
        return std::to_string(i) + " (" + number(corners[i].x) + ", " + number(corners[i].y) + ")";
    };
    auto edge = [&](std::uint32_t i) { return std::to_string(i) + "-" + std::to_string(after(i, corners.size())); };
    std::uint32_t i = problem.first, j = problem.second;
    switch (problem.fault) {
    case PolygonFault::none:
        return "nothing is wrong";
    case PolygonFault::too_few_corners:
        return std::to_string(corners.size()) + " corners are too few; a polygon needs 3 or more";
    case PolygonFault::too_many_corners:
        return std::to_string(corners.size()) + " corners are too many; at most " + std::to_string(kMaxCorners) +
               " are allowed";
    case PolygonFault::not_finite:
        return "corner " + corner(i) + " must be finite; NaN or infinity came in";
    case PolygonFault::too_large:
        return "corner " + corner(i) + " is too far out; coordinates may be " + number(kMaxCoordinate) +
               " metres at most";
    case PolygonFault::repeated_corner:
        return "corners " + corner(i) + " and " + corner(j) + " are nearer than " + number(kMinFeature) +
               " metres; leave one out (the last corner need not repeat the first)";
    case PolygonFault::crossing_edges:
        return "edges " + edge(i) + " and " + edge(j) + " cross or touch; give the corners in order round the outline";
    case PolygonFault::zero_area:
        return "the corners lie in one line, or nearly; a polygon needs an area";
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

void make_counter_clockwise(std::span<Vec2> corners) noexcept {
    if (signed_area(corners) < 0.0) std::ranges::reverse(corners.subspan(1));
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
