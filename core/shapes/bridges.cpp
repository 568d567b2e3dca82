#include "shapes/bridges.hpp"
#include "shapes/orientation.hpp"
#include "shapes/polygon.hpp"
#include <algorithm>
#include <tuple>

namespace evil {
namespace {

constexpr std::uint32_t kNone = 0xffffffffu;

class Builder {
public:
    explicit Builder(const Rings& rings) : rings_(rings) {
        for (std::size_t i = 0; i < rings.count(); ++i) add_ring(i);
    }

    Loop build() {
        // From right to left: what a hole sees on its right is then joined already.
        std::vector<std::uint32_t> holes;
        for (std::size_t i = 1; i < rings_.count(); ++i) holes.push_back(rightmost(i));
        std::ranges::sort(holes, {}, [&](std::uint32_t m) { return std::tuple(-at(m).x, at(m).y); });
        for (std::uint32_t m : holes)
            if (std::uint32_t r = seen_from(m); r != kNone) join(r, m);
        return std::move(loop_);
    }

private:
    Vec2 at(std::uint32_t node) const { return rings_.corners[loop_.corner[node]]; }

    void add_ring(std::size_t i) {
        auto first = static_cast<std::uint32_t>(rings_.first(i)), end = static_cast<std::uint32_t>(rings_.end(i));
        bool turned = (signed_area(rings_.ring(i)) > 0.0) != (i == 0);
        for (std::uint32_t k = first; k < end; ++k) {
            std::uint32_t before = k == first ? end - 1 : k - 1, after = k + 1 == end ? first : k + 1;
            loop_.corner.push_back(k);
            loop_.previous.push_back(turned ? after : before);
            loop_.next.push_back(turned ? before : after);
        }
    }

    std::uint32_t rightmost(std::size_t ring) const {
        auto first = static_cast<std::uint32_t>(rings_.first(ring)), best = first;
        for (std::uint32_t k = first; k < rings_.end(ring); ++k)
            if (at(k).x > at(best).x || (at(k).x == at(best).x && at(k).y < at(best).y)) best = k;
        return best;
    }

    template <class F> void each_node(F&& f) const { // of what is joined so far
        std::uint32_t node = 0;
        do {
            f(node);
            node = loop_.next[node];
        } while (node != 0);
    }

    // Both edges, from low to high, meet the height of m on its right. They do not cross, so the one that begins higher up
    // tells which is nearer.
    bool is_nearer(std::uint32_t e, std::uint32_t f) const {
        Vec2 e0 = at(e), e1 = at(loop_.next[e]), f0 = at(f), f1 = at(loop_.next[f]);
        if (e0.y >= f0.y) {
            int side = turn(f0, f1, e0);
            return side != 0 ? side > 0 : turn(f0, f1, e1) > 0;
        }
        int side = turn(e0, e1, f0);
        return side != 0 ? side < 0 : turn(e0, e1, f1) < 0;
    }

    // A node that m sees (Eberly, Triangulation by Ear Clipping, 2002): where a ray to the right leaves the solid, through
    // the edge e, take its end P farther right. What hides P from m has a corner in the triangle of m, P and the place that
    // the ray hits; of those, m sees the one nearest in direction to the ray, and of these again the nearest one.
    std::uint32_t seen_from(std::uint32_t m) const {
        Vec2 from = at(m);
        std::uint32_t e = kNone;
        each_node([&](std::uint32_t k) {
            Vec2 low = at(k), high = at(loop_.next[k]);
            if (low.y > from.y || high.y <= from.y || turn(low, high, from) <= 0) return;
            if (e == kNone || is_nearer(k, e)) e = k;
        });
        if (e == kNone) return kNone; // it lies outside; whoever asks for that gets no triangles
        Vec2 low = at(e), high = at(loop_.next[e]);
        bool above = high.x >= low.x;
        Vec2 best = above ? high : low;
        each_node([&](std::uint32_t k) {
            Vec2 p = at(k);
            if (above ? p.y < from.y : p.y > from.y) return;
            if (turn(low, high, p) < 0 || p.x <= from.x) return;
            int side = turn(from, best, p) * (above ? 1 : -1);
            if (side < 0 || (side == 0 && p.x < best.x)) best = p;
        });
        std::uint32_t seen = kNone;
        each_node([&](std::uint32_t k) { // of those at one place, the one that looks this way
            if (at(k) == best && opens_toward(loop_, rings_.corners, k, from)) seen = k;
        });
        return seen;
    }

    // ... r m ... m' r' ...
    void join(std::uint32_t r, std::uint32_t m) {
        auto r2 = static_cast<std::uint32_t>(loop_.corner.size()), m2 = r2 + 1;
        loop_.corner.insert(loop_.corner.end(), {loop_.corner[r], loop_.corner[m]});
        loop_.previous.insert(loop_.previous.end(), {m2, loop_.previous[m]});
        loop_.next.insert(loop_.next.end(), {loop_.next[r], r2});
        loop_.next[loop_.previous[m]] = m2;
        loop_.previous[loop_.next[r]] = r2;
        loop_.next[r] = m;
        loop_.previous[m] = r;
    }

    const Rings& rings_;
    Loop loop_;
};

} // namespace

bool opens_toward(const Loop& loop, std::span<const Vec2> corners, std::uint32_t node, Vec2 p) {
    auto at = [&](std::uint32_t k) { return corners[loop.corner[k]]; };
    Vec2 a = at(loop.previous[node]), b = at(node), c = at(loop.next[node]);
    bool left_of_first = turn(a, b, p) > 0, left_of_second = turn(b, c, p) > 0;
    return turn(a, b, c) > 0 ? left_of_first && left_of_second : left_of_first || left_of_second;
}

Loop bridged(const Rings& rings) { return Builder(rings).build(); }

} // namespace evil
