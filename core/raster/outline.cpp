#include "raster/outline.hpp"
#include <algorithm>
#include <cmath>

namespace evil::raster {
namespace {

constexpr double kSagitta = 1.0 / 32; // pixels between a circle's arc and its chord: 1/64 to either side cannot be seen
constexpr int kMostChords = 6144;     // enough for a radius of 240,000 pixels
constexpr double kTiny = 1e-9;        // pixels

Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
Point operator*(double s, Point a) { return {s * a.x, s * a.y}; }
double dot(Point a, Point b) { return a.x * b.x + a.y * b.y; }
double cross(Point a, Point b) { return a.x * b.y - a.y * b.x; }
double length(Point a) { return std::sqrt(dot(a, a)); }
Point left_of(Point a) { return {-a.y, a.x}; }
Point to_pixels(const Affine& m, double x, double y) {
    return {double{m.a} * x + double{m.c} * y + double{m.tx}, double{m.b} * x + double{m.d} * y + double{m.ty}};
}

void end_loop(Loops& loops) { loops.ends.push_back(loops.points.size()); }

void add_loop_of(Loops& loops, std::initializer_list<Point> points) {
    loops.points.insert(loops.points.end(), points);
    end_loop(loops);
}

// Corners on a circle of a radius that gives the polygon the circle's area, so that its edge lies half inside, half outside.
const std::vector<Point>& unit_circle(Loops& loops, int count) {
    std::vector<Point>& corners = loops.circles[count];
    if (!corners.empty()) return corners;
    corners.resize(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        SinCos f = sincos(2.0 * kPi * i / count);
        corners[static_cast<std::size_t>(i)] = {f.cos, f.sin};
    }
    const double area = 0.5 * count * cross(corners[0], corners[1]), grow = std::sqrt(kPi / area);
    for (Point& corner : corners) corner = grow * corner;
    return corners;
}

// Chords for a radius in pixels: 8, 12, 16, 24, ..., the first that keeps to kSagitta (radius * (1 - cos(pi / n))).
int chords_for(double radius) {
    const double wanted = kPi * std::sqrt(radius / (2.0 * kSagitta));
    int count = 8;
    while (count < wanted && count < kMostChords) count = count % 3 == 0 ? count / 3 * 4 : count / 2 * 3;
    return count;
}

// Bound of how far `m` stretches any direction.
double stretch(const Affine& m) {
    const double a = m.a, b = m.b, c = m.c, d = m.d;
    return std::sqrt(std::max(a * a + b * b + std::fabs(a * c + b * d), c * c + d * d + std::fabs(a * c + b * d)));
}

void circle_path(Loops& loops, std::vector<Point>& out, const Affine& m, Vec2 centre, double radius) {
    const double size = radius * stretch(m);
    if (!(size < 1e15)) return;
    const Point middle = to_pixels(m, centre.x, centre.y);
    Affine turn = m;
    turn.tx = turn.ty = 0;
    for (Point corner : unit_circle(loops, chords_for(size)))
        out.push_back(middle + radius * to_pixels(turn, corner.x, corner.y));
}

// A circle that stays one has a ring as its stroke; both edges smooth at any width.
bool add_ring(Loops& loops, const Affine& m, Vec2 centre, double radius, double width) {
    const double x = double{m.a} * m.a + double{m.b} * m.b, y = double{m.c} * m.c + double{m.d} * m.d;
    const double skew = double{m.a} * m.c + double{m.b} * m.d;
    if (!(std::fabs(x - y) <= 1e-5 * x) || !(std::fabs(skew) <= 1e-5 * x) || !(x > 0)) return false;
    const double half = 0.5 * width / std::sqrt(x); // in the circle's own units
    circle_path(loops, loops.points, m, centre, radius + half);
    end_loop(loops);
    if (radius > half) {
        const std::size_t start = loops.points.size();
        circle_path(loops, loops.points, m, centre, radius - half);
        std::reverse(loops.points.begin() + static_cast<std::ptrdiff_t>(start), loops.points.end());
        end_loop(loops);
    }
    return true;
}

// A corner of a stroked path: where the strips of the edges before and after it end, on either side.
struct Corner {
    Point at, left_in, left_out, right_in, right_out;
};

// The outside of a bend, between the normals n0 and n1 of its edges, turning clockwise with y up:
//
//      n0  tip            mitre: fan at, at + n0, tip, at + n1
//     ----*--*            round: the arc from n0 to n1 in place of the tip
//         | / \ n1
//     ---at    *
//          \    \        .
void add_outside(Loops& loops, Point at, Point n0, Point n1, double half) {
    loops.points.push_back(at);
    loops.points.push_back(at + half * n0);
    const double one_plus_cos = 1.0 + dot(n0, n1);
    if (one_plus_cos * kMitreLimit * kMitreLimit >= 2.0) {
        loops.points.push_back(at + (half / one_plus_cos) * (n0 + n1));
    } else {
        const int parts = half < 2 ? 8 : half < 32 ? 16 : 64;
        // Halve the turn until one part is left; the start of a half turn has no mean of normals, so it goes by n0's side.
        Point middle = n0 + n1;
        if (length(middle) < 1e-6) middle = {n0.y, -n0.x};
        middle = (1.0 / length(middle)) * middle;
        Point arc[65];
        arc[0] = n0, arc[parts / 2] = middle, arc[parts] = n1;
        for (int step = parts / 4; step >= 1; step /= 2)
            for (int i = step; i < parts; i += 2 * step) {
                Point mean = arc[i - step] + arc[i + step];
                arc[i] = (1.0 / length(mean)) * mean;
            }
        for (int i = 1; i < parts; ++i) loops.points.push_back(at + half * arc[i]);
    }
    loops.points.push_back(at + half * n1);
    end_loop(loops);
}

Corner add_corner(Loops& loops, Point before, Point at, Point after, double half) {
    const double l0 = length(at - before), l1 = length(after - at);
    const Point d0 = (1.0 / l0) * (at - before), d1 = (1.0 / l1) * (after - at);
    const Point n0 = left_of(d0), n1 = left_of(d1);
    const double turn = cross(d0, d1), one_plus_cos = 1.0 + dot(d0, d1);
    Corner corner{at, at + half * n0, at + half * n1, at - half * n0, at - half * n1};
    // Inside the bend the strips meet in the mitre's point, unless an edge is too short for it: then they overlap there.
    const bool meet = one_plus_cos > 1e-6 && half * std::fabs(turn) / one_plus_cos <= 0.5 * std::min(l0, l1);
    const Point mitre = meet ? (half / one_plus_cos) * (n0 + n1) : Point{};
    if (turn > 0) {
        if (meet) corner.left_in = corner.left_out = at + mitre;
        add_outside(loops, at, -1.0 * n1, -1.0 * n0, half);
    } else {
        if (meet) corner.right_in = corner.right_out = at - mitre;
        add_outside(loops, at, n0, n1, half);
    }
    return corner;
}

void add_strip(Loops& loops, const Corner& a, const Corner& b) {
    add_loop_of(loops, {a.at, a.left_out, b.left_in, b.at, b.right_in, a.right_out});
}

// The closed path as strips and the outsides of its bends, all wound the same way: they share edges, which cancel, so
// nothing shows where they meet.
void add_stroke(Loops& loops, double width) {
    std::vector<Point>& path = loops.path;
    auto same = [](Point a, Point b) { return length(b - a) < kTiny; };
    path.erase(std::unique(path.begin(), path.end(), same), path.end());
    while (path.size() > 1 && same(path.back(), path.front())) path.pop_back();
    const std::size_t count = path.size();
    if (count < 2) return;
    const double half = 0.5 * width;
    const Corner first = add_corner(loops, path[count - 1], path[0], path[1], half);
    Corner last = first;
    for (std::size_t i = 1; i < count; ++i) {
        const Corner next = add_corner(loops, path[i - 1], path[i], path[i + 1 == count ? 0 : i + 1], half);
        add_strip(loops, last, next);
        last = next;
    }
    add_strip(loops, last, first);
}

} // namespace

void clear(Loops& loops) {
    loops.points.clear();
    loops.ends.clear();
}

void add_mesh(Loops& loops, const draw::DrawList& list, const draw::Mesh& mesh, const Affine& to_pixel, double width) {
    const bool stroked = width > 0;
    std::vector<Point>& out = stroked ? loops.path : loops.points;
    auto end_ring = [&] {
        if (stroked)
            add_stroke(loops, width);
        else
            end_loop(loops);
    };
    if (mesh.kind == draw::MeshKind::circle) {
        const Vec2 centre = list.vertices[mesh.first_vertex].at;
        if (stroked && add_ring(loops, to_pixel, centre, mesh.radius, width)) return;
        loops.path.clear();
        circle_path(loops, out, to_pixel, centre, mesh.radius);
        return end_ring();
    }
    draw::each_ring(list, mesh, [&](std::span<const draw::Vertex> ring) {
        loops.path.clear();
        for (const draw::Vertex& corner : ring) out.push_back(to_pixels(to_pixel, corner.at.x, corner.at.y));
        end_ring();
    });
}

} // namespace evil::raster
