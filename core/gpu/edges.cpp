#include "gpu/edges.hpp"
#include <algorithm>
#include <cmath>

namespace evil::gpu {
namespace {

constexpr double kMitreLimit = 4.0; // as in raster/outline.cpp, which draws the corners beyond it
constexpr double kTiny = 1e-6;      // pixels
constexpr int kMostLayers =
    255; // of a shape on itself, left of a part; bounds the memory that the maddest shape can take

// Where an edge is at a height, and at a place across. The same for both directions of an edge, to the bit, so that edges
// which cancel still do when they are cut.
double x_at(const Edge& e, double y) {
    if (y == e.y0 || y == e.y1) return y == e.y0 ? e.x0 : e.x1;
    const bool down = e.y0 < e.y1;
    const double x0 = down ? e.x0 : e.x1, y0 = down ? e.y0 : e.y1, x1 = down ? e.x1 : e.x0, y1 = down ? e.y1 : e.y0;
    return x0 + (y - y0) / (y1 - y0) * (x1 - x0);
}

double y_at(const Edge& e, double x) {
    const bool right = e.x0 < e.x1;
    const double x0 = right ? e.x0 : e.x1, y0 = right ? e.y0 : e.y1, x1 = right ? e.x1 : e.x0, y1 = right ? e.y1 : e.y0;
    return std::clamp(y0 + (x - x0) / (x1 - x0) * (y1 - y0), std::min(y0, y1), std::max(y0, y1));
}

void add_turns(Cut& scratch, double y0, double y1) { // what stands on the left side from y0 to y1
    if (y0 == y1) return;
    scratch.turns.push_back({y0, 1});
    scratch.turns.push_back({y1, -1});
}

void add_left_side(Cut& scratch, double x, std::vector<Edge>& out) {
    std::vector<Cut::Turn>& turns = scratch.turns;
    std::ranges::sort(turns, {}, &Cut::Turn::y); // equal heights add up, in whatever order
    int winding = 0;
    for (std::size_t i = 0; i < turns.size();) {
        const double y = turns[i].y;
        for (; i < turns.size() && turns[i].y == y; ++i) winding += turns[i].winding;
        if (winding == 0 || i == turns.size()) continue;
        const Edge edge = winding > 0 ? Edge{x, y, x, turns[i].y} : Edge{x, turns[i].y, x, y};
        if (!out.empty() && out.back().x0 == x && out.back().x1 == x && out.back().y1 == edge.y0 && winding == 1)
            out.back().y1 = edge.y1; // goes on
        else
            out.insert(out.end(), static_cast<std::size_t>(std::min(std::abs(winding), kMostLayers)), edge);
    }
    turns.clear();
}

raster::Point operator+(raster::Point a, raster::Point b) { return {a.x + b.x, a.y + b.y}; }
raster::Point operator-(raster::Point a, raster::Point b) { return {a.x - b.x, a.y - b.y}; }
raster::Point operator*(double s, raster::Point a) { return {s * a.x, s * a.y}; }
double dot(raster::Point a, raster::Point b) { return a.x * b.x + a.y * b.y; }
double length(raster::Point a) { return std::sqrt(dot(a, a)); }

} // namespace

void cut(std::span<const Edge> edges, const Bounds& part, std::vector<Edge>& out, Cut& scratch) {
    const double left = part.left, right = part.right, top = part.top, bottom = part.bottom;
    out.clear(), scratch.turns.clear();
    for (const Edge& whole : edges) {
        const double y0 = std::clamp(whole.y0, top, bottom), y1 = std::clamp(whole.y1, top, bottom);
        if (y0 == y1) continue;
        Edge e{x_at(whole, y0), y0, x_at(whole, y1), y1};
        if (e.x0 >= right && e.x1 >= right) continue;
        if (e.x0 <= left && e.x1 <= left) {
            add_turns(scratch, e.y0, e.y1);
            continue;
        }
        if (e.x0 < left) {
            const double y = y_at(e, left);
            add_turns(scratch, e.y0, y);
            e.x0 = left, e.y0 = y;
        } else if (e.x1 < left) {
            const double y = y_at(e, left);
            add_turns(scratch, y, e.y1);
            e.x1 = left, e.y1 = y;
        }
        if (e.x0 > right)
            e.y0 = y_at(e, right), e.x0 = right;
        else if (e.x1 > right)
            e.y1 = y_at(e, right), e.x1 = right;
        if (e.y0 != e.y1) out.push_back(e);
    }
    add_left_side(scratch, left, out);
}

bool covers(std::span<const Edge> edges, const Bounds& part) {
    if (edges.size() != 1) return false;
    const Edge& e = edges[0];
    return e.x0 <= part.left && e.x1 <= part.left && std::min(e.y0, e.y1) <= part.top &&
           std::max(e.y0, e.y1) >= part.bottom;
}

bool add_plain_stroke(raster::Loops& loops, std::span<const raster::Point> path, double half,
                      std::vector<raster::Point>& other) {
    const std::size_t count = path.size();
    if (count < 3) return false;
    other.clear();
    for (std::size_t i = 0; i < count; ++i) {
        const raster::Point before = path[i == 0 ? count - 1 : i - 1], at = path[i], after = path[(i + 1) % count];
        const double l0 = length(at - before), l1 = length(after - at);
        const raster::Point d0 = (1.0 / l0) * (at - before), d1 = (1.0 / l1) * (after - at);
        const raster::Point n0{-d0.y, d0.x}, n1{-d1.y, d1.x};
        const double one_plus_cos = 1.0 + dot(d0, d1), turn = d0.x * d1.y - d0.y * d1.x;
        const bool meets = half * std::fabs(turn) / one_plus_cos <= 0.5 * std::min(l0, l1);
        if (!(l0 > kTiny && l1 > kTiny && one_plus_cos * kMitreLimit * kMitreLimit >= 2.0 && meets)) return false;
        const raster::Point mitre = (half / one_plus_cos) * (n0 + n1);
        loops.points.push_back(at + mitre);
        other.push_back(at - mitre);
    }
    loops.ends.push_back(loops.points.size());
    loops.points.insert(loops.points.end(), other.rbegin(), other.rend());
    loops.ends.push_back(loops.points.size());
    return true;
}

} // namespace evil::gpu
