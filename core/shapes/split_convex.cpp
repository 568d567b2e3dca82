#include "math/vec2.hpp"
#include "shapes/orientation.hpp"
#include "shapes/polygon.hpp"
#include <algorithm>
#include <array>
#include <tuple>

namespace evil {
namespace {

constexpr std::uint32_t kNone = 0xffffffffu;

// A polygon cut into faces. Each face is a ring of half-edges; a diagonal is two of them, twins, one in each face.
struct HalfEdge {
    std::uint32_t from, next, previous, twin;
};

class Faces {
public:
    Faces(std::span<const Vec2> corners, std::span<const std::uint32_t> triangles) : corners_(corners) {
        edges_.resize(triangles.size());
        std::vector<std::uint32_t> sorted;
        for (std::uint32_t t = 0; t < triangles.size(); t += 3)
            for (std::uint32_t k = 0; k < 3; ++k) {
                edges_[t + k] = {triangles[t + k], t + (k + 1) % 3, t + (k + 2) % 3, kNone};
                sorted.push_back(t + k);
            }
        // Twins have the same two ends, so sorting by ends brings them together.
        auto ends = [this](std::uint32_t e) {
            return std::tuple(std::min(from(e), to(e)), std::max(from(e), to(e)), e);
        };
        std::ranges::sort(sorted, {}, ends);
        for (std::size_t i = 1; i < sorted.size(); ++i) {
            std::uint32_t a = sorted[i - 1], b = sorted[i];
            if (from(a) != to(b) || to(a) != from(b)) continue;
            edges_[a].twin = b;
            edges_[b].twin = a;
            diagonals_.push_back(a);
        }
        std::ranges::sort(diagonals_); // in the order in which the ears were cut
    }

    // Flips diagonals until each is the better of the two of its quadrilateral (Lawson 1977): the triangles become as round
    // as the corners allow, and so do the parts made of them. Rounding could make two flips undo each other, so rounds are counted.
    void make_round() {
        bool changed = true;
        for (std::size_t round = 0; changed && round < kMaxRounds; ++round) {
            changed = false;
            for (std::uint32_t e : diagonals_)
                if (should_flip(e)) {
                    flip(e);
                    changed = true;
                }
        }
    }

    void sort_longest_first() {
        auto length_of = [this](std::uint32_t e) { return length_squared(corners_[to(e)] - corners_[from(e)]); };
        std::ranges::sort(diagonals_, {}, [&](std::uint32_t e) { return std::tuple(-length_of(e), e); });
    }

    // Takes out diagonals that no convexity needs (Hertel and Mehlhorn 1983), in their order. Two at most stay for each
    // reflex corner, so there are at most four times as many parts as there must be.
    void merge() {
        for (std::uint32_t e : diagonals_) {
            HalfEdge &a = edges_[e], &b = edges_[a.twin];
            if (turn(corner(a.previous), corner(e), to_corner(b.next)) < 0) continue;
            if (turn(corner(b.previous), corner(a.twin), to_corner(a.next)) < 0) continue;
            join(a.previous, b.next);
            join(b.previous, a.next);
            a.from = b.from = kNone; // gone
        }
    }

    // The faces as corner numbers, without corners at which a face runs straight.
    std::vector<std::vector<std::uint32_t>> rings() const {
        std::vector<std::vector<std::uint32_t>> all;
        std::vector<std::uint8_t> seen(edges_.size(), 0);
        for (std::uint32_t first = 0; first < edges_.size(); ++first) {
            if (seen[first] || edges_[first].from == kNone) continue;
            std::vector<std::uint32_t>& ring = all.emplace_back();
            for (std::uint32_t e = first; !seen[e]; e = edges_[e].next) {
                seen[e] = 1;
                if (turn(corner(edges_[e].previous), corner(e), to_corner(e)) > 0) ring.push_back(from(e));
            }
        }
        return all;
    }

private:
    static constexpr std::size_t kMaxRounds = 32; // a thousand corners settle sooner

    std::uint32_t from(std::uint32_t e) const { return edges_[e].from; }
    std::uint32_t to(std::uint32_t e) const { return edges_[edges_[e].next].from; }
    Vec2 corner(std::uint32_t e) const { return corners_[from(e)]; }
    Vec2 to_corner(std::uint32_t e) const { return corners_[to(e)]; }

    void join(std::uint32_t a, std::uint32_t b) {
        edges_[a].next = b;
        edges_[b].previous = a;
    }

    //        c          e runs from a to b, with the triangle a b c on its left and b a d on its right.
    //      /   \        If the angles at c and d make more than half a turn, c-d is the better diagonal. It lies
    //    a ---> b       inside only where a and b are corners of the quadrilateral that turn left.
    //      \   /
    //        d
    bool should_flip(std::uint32_t e) const {
        std::uint32_t twin = edges_[e].twin;
        Vec2 a = corner(e), b = to_corner(e), c = corner(edges_[e].previous), d = corner(edges_[twin].previous);
        if (turn(c, a, d) <= 0 || turn(d, b, c) <= 0) return false;
        auto at = [](Vec2 o, Vec2 p, Vec2 q) { // cosine and sine of the angle p o q, times both lengths
            double px = double{p.x} - o.x, py = double{p.y} - o.y, qx = double{q.x} - o.x, qy = double{q.y} - o.y;
            return std::array{px * qx + py * qy, std::fabs(px * qy - py * qx)};
        };
        std::array u = at(c, a, b), v = at(d, a, b);
        double left = u[0] * v[1], right = u[1] * v[0]; // sin(c + d) < 0, by more than rounding
        return left + right < -1e-12 * (std::fabs(left) + std::fabs(right));
    }

    // e: a -> b becomes d -> c, in the triangles (d, c, a) of e and (c, d, b) of its twin.
    void flip(std::uint32_t e) {
        std::uint32_t twin = edges_[e].twin;
        std::uint32_t bc = edges_[e].next, ca = edges_[e].previous, ad = edges_[twin].next, db = edges_[twin].previous;
        edges_[e].from = from(db);
        edges_[twin].from = from(ca);
        for (auto [first, second, third] : {std::array{e, ca, ad}, std::array{twin, db, bc}}) {
            join(first, second);
            join(second, third);
            join(third, first);
        }
    }

    std::span<const Vec2> corners_;
    std::vector<HalfEdge> edges_;
    std::vector<std::uint32_t> diagonals_; // one half of each
};

} // namespace

std::vector<std::vector<std::uint32_t>> split_convex(const Rings& polygon) {
    std::vector<std::uint32_t> triangles;
    if (!triangulate(polygon, triangles)) return {};
    Faces faces(polygon.corners, triangles); // a bridge to a hole is a diagonal like any other here
    faces.make_round();

    // Longest first makes the roundest parts, the order of the ears makes fewer in star-like outlines. Few comes first.
    Faces by_ears = faces;
    faces.sort_longest_first();
    faces.merge();
    by_ears.merge();
    auto round = faces.rings(), few = by_ears.rings();
    return few.size() < round.size() ? few : round;
}

} // namespace evil
