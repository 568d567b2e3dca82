#include "collider/gjk.hpp"
#include <algorithm>
#include <utility>

namespace evil {
namespace {

struct Turn { // a rotation in double
    double c = 1.0, s = 0.0;
};
Turn wide(Rot q) { return {double{q.c}, double{q.s}}; }
Vec2d rotate(Turn q, Vec2d a) { return {q.c * a.x - q.s * a.y, q.s * a.x + q.c * a.y}; }
Vec2d unrotate(Turn q, Vec2d a) { return {q.c * a.x + q.s * a.y, q.c * a.y - q.s * a.x}; }

struct Placement { // a proxy somewhere; places are told from the origin of the first of the two
    std::span<const Vec2> points;
    Turn q;
    Vec2d p;

    Vec2d corner(std::uint32_t i) const { return rotate(q, evil::wide(points[i])) + p; }
    std::uint32_t farthest(Vec2d direction) const {
        Vec2d d = unrotate(q, direction);
        std::uint32_t best = 0;
        double most = dot(d, evil::wide(points[0]));
        for (std::uint32_t i = 1; i < points.size(); ++i) {
            double along = dot(d, evil::wide(points[i]));
            if (along > most) most = along, best = i;
        }
        return best;
    }
};

struct Corner { // of the Minkowski difference b - a
    Vec2d at, a, b;
    std::uint32_t of_a, of_b;
    double weight = 1.0;
};

struct Simplex {
    Corner corners[3];
    std::uint8_t count = 0;

    Vec2d nearest() const {
        Vec2d sum;
        for (std::uint8_t i = 0; i < count; ++i) sum = sum + corners[i].weight * corners[i].at;
        return sum;
    }
    void keep(int i) {
        corners[0] = corners[i];
        corners[0].weight = 1.0;
        count = 1;
    }
    void keep(int i, int j, double weight_i, double weight_j) {
        Corner first = corners[i], second = corners[j];
        double sum = weight_i + weight_j;
        first.weight = weight_i / sum;
        second.weight = weight_j / sum;
        corners[0] = first;
        corners[1] = second;
        count = 2;
    }
};

// Drop the corners that the point nearest to the origin does not need, by the Voronoi regions of the simplex (Ericson 2005,
// 5.1.2 and 5.1.5); weights are areas or lengths over against each corner.
void reduce_segment(Simplex& s) {
    Vec2d p = s.corners[0].at, q = s.corners[1].at, d = q - p;
    double at_p = dot(q, d), at_q = -dot(p, d);
    if (at_q <= 0.0) return s.keep(0);
    if (at_p <= 0.0) return s.keep(1);
    s.keep(0, 1, at_p, at_q);
}

void reduce_triangle(Simplex& s) {
    Vec2d w[3] = {s.corners[0].at, s.corners[1].at, s.corners[2].at};
    auto share = [&](int i, int j) { return dot(w[j], w[j] - w[i]); }; // of corner i on edge i-j; not normalised
    double whole = cross(w[1] - w[0], w[2] - w[0]);
    double area[3] = {whole * cross(w[1], w[2]), whole * cross(w[2], w[0]), whole * cross(w[0], w[1])};
    for (int i = 0; i < 3; ++i) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        if (share(j, i) <= 0.0 && share(k, i) <= 0.0) return s.keep(i);
    }
    for (int i = 0; i < 3; ++i) { // edge j-k, over against corner i
        int j = (i + 1) % 3, k = (i + 2) % 3;
        if (area[i] <= 0.0 && share(j, k) > 0.0 && share(k, j) > 0.0) return s.keep(j, k, share(j, k), share(k, j));
    }
    double sum = area[0] + area[1] + area[2];
    if (sum > 0.0)
        for (int i = 0; i < 3; ++i) s.corners[i].weight = area[i] / sum;
}

Nearest nearest_of(const Simplex& s) {
    Nearest n;
    n.count = s.count;
    for (std::uint8_t i = 0; i < s.count; ++i) {
        n.a = n.a + s.corners[i].weight * s.corners[i].a;
        n.b = n.b + s.corners[i].weight * s.corners[i].b;
        n.corner_a[i] = s.corners[i].of_a;
        n.corner_b[i] = s.corners[i].of_b;
    }
    return n;
}

constexpr int kMaxRounds = 64;      // each round drops a corner for good; polygons of a thousand corners take about ten
constexpr double kProgress = 1e-12; // of the squared distance: less is rounding
constexpr double kInside = 1e-18;   // square metres: the origin lies on the simplex

Nearest distance(const Placement& a, const Placement& b) {
    Simplex s;
    auto corner = [&](Vec2d direction) { // the corner of b - a that lies farthest along
        Corner c;
        c.of_a = a.farthest(-direction);
        c.of_b = b.farthest(direction);
        c.a = a.corner(c.of_a);
        c.b = b.corner(c.of_b);
        c.at = c.b - c.a;
        return c;
    };
    s.corners[0] = corner(a.p - b.p);
    s.count = 1;
    for (int round = 0; round < kMaxRounds; ++round) {
        if (s.count == 2) reduce_segment(s);
        if (s.count == 3) reduce_triangle(s);
        Vec2d v = s.nearest();
        double square = dot(v, v);
        if (s.count == 3 || square <= kInside) return nearest_of(s); // core stays 0
        Corner next = corner(-v);
        bool known = false;
        for (std::uint8_t i = 0; i < s.count; ++i)
            known = known || (s.corners[i].of_a == next.of_a && s.corners[i].of_b == next.of_b);
        if (known || square - dot(v, next.at) <= kProgress * square) break;
        s.corners[s.count++] = next;
    }
    Nearest n = nearest_of(s);
    Vec2d v = n.b - n.a;
    n.core = length(v);
    n.normal = n.core > 0.0 ? (1.0 / n.core) * v : Vec2d{};
    return n;
}

// ---- motion ------------------------------------------------------------------------------------------------------

struct Moving { // a proxy on its way
    const Proxy& proxy;
    const Motion& motion;
    double reach = 0.0; // metres from the turning point to the farthest point of the core

    Moving(const Proxy& p, const Motion& m) : proxy(p), motion(m) {
        if (m.turn == 0.0) return;
        for (Vec2 point : p.points) reach = std::max(reach, length(evil::wide(point) - evil::wide(m.round)));
    }
    Turn turned(double t) const {
        Turn q = wide(motion.start.q);
        if (motion.turn == 0.0) return q;
        Turn more = wide(rotation(t * motion.turn));
        return {q.c * more.c - q.s * more.s, q.s * more.c + q.c * more.s};
    }
    Vec2d origin(double t, Turn q) const {
        Vec2d round = evil::wide(motion.round);
        return evil::wide(motion.start.p) + rotate(wide(motion.start.q), round) + t * evil::wide(motion.path) -
               rotate(q, round);
    }
};

Placement placement(const Moving& m, double t, Vec2d from) {
    Turn q = m.turned(t);
    return {m.proxy.points, q, m.origin(t, q) - from};
}

// The share of the whole time that may pass before a gap can have closed: straight motion closes `speed` of it, and turning
// at most twice each reach.
double safe_time(double gap, double speed, double turning, double reaches) {
    double by_both = gap / std::max(speed + turning, 1e-300);
    if (gap <= 2.0 * reaches) return by_both;
    return std::max(by_both, speed > 0.0 ? (gap - 2.0 * reaches) / speed : 2.0);
}

constexpr int kMaxAdvances = 160; // grazing spins need the most; straight motion three to six

} // namespace

Proxy proxy_of(const Shapes& shapes, const Piece& piece) {
    if (piece.count == 0) return {{&piece.centre, 1}, piece.radius};
    return {points_of(shapes, piece), piece.radius};
}

Nearest distance(const Proxy& a, const Pose& at_a, const Proxy& b, const Pose& at_b) {
    Vec2d offset = evil::wide(at_b.p) - evil::wide(at_a.p);
    Nearest n = distance(Placement{a.points, wide(at_a.q), {}}, Placement{b.points, wide(at_b.q), offset});
    n.distance = n.core - double{a.radius} - double{b.radius};
    return n;
}

Pose pose_at(const Motion& motion, double t) {
    Proxy none;
    Moving m(none, motion);
    Turn q = m.turned(t);
    return {narrow(m.origin(t, q)), {static_cast<float>(q.c), static_cast<float>(q.s)}};
}

Impact cast(const Proxy& a, const Motion& move_a, const Proxy& b, const Motion& move_b, double gap) {
    Moving first(a, move_a), second(b, move_b);
    Vec2d path = evil::wide(move_b.path) - evil::wide(move_a.path);
    double turning = std::abs(move_a.turn) * first.reach + std::abs(move_b.turn) * second.reach;
    double reaches = (move_a.turn != 0.0 ? first.reach : 0.0) + (move_b.turn != 0.0 ? second.reach : 0.0);
    double skins = double{a.radius} + double{b.radius}, near = 0.75 * gap;
    Impact hit;
    double t = 0.0;
    for (int advance = 0;; ++advance) {
        Placement at_a = placement(first, t, {});
        Vec2d origin = std::exchange(at_a.p, {}); // both are told from a's, so that far from the world's it stays exact
        Nearest n = distance(at_a, placement(second, t, origin));
        double apart = n.core - skins;
        if (apart <= gap || advance == kMaxAdvances) {
            hit.state = advance == 0 ? Meeting::overlap : Meeting::touch;
            hit.t = t;
            hit.normal = narrow(n.normal);
            hit.point = narrow(origin + n.b - double{b.radius} * n.normal);
            return hit;
        }
        double closing = std::max(-dot(n.normal, path), 0.0);
        if (closing + turning <= 0.0) return hit;
        t += safe_time(apart - near, closing, turning, reaches);
        if (t >= 1.0) return hit;
    }
}

} // namespace evil
