#include "shapes/bridges.hpp"
#include "shapes/orientation.hpp"
#include "shapes/polygon.hpp"

namespace evil {
namespace {

// Ear clipping (Meisters 1975). An ear is a corner that turns left and whose triangle with its neighbours holds no other
// corner, its border included. Every simple polygon has two, straight corners or not, and cutting one off leaves a simple
// polygon; with exact turns the search therefore cannot get stuck.
//
//        b         Whatever enters the triangle does so through ac, and the corner that reaches furthest turns right or runs
//       / \        straight, so only such corners are looked at. While a and c stay its neighbours, b cannot become an ear:
//   ...a---c...    that corner is none either. So b is looked at again only when a neighbour has gone, and the time grows
//                  with corners times blunt corners.
//
// A loop with bridges to holes is cut like any other, but a place that several nodes share may stick into a triangle though
// each node turns left, so these nodes count as blunt as long as they are there. At the ear's own corners, what else is at
// that place lies outside the angle of the loop there: so ac must lie within that angle.
class EarClipper {
public:
    explicit EarClipper(const Rings& rings)
        : corners_(rings.corners), loop_(bridged(rings)), shared_(loop_.corner.size(), 0),
          no_ear_(loop_.corner.size(), 0) {
        for (auto i = static_cast<std::uint32_t>(corners_.size()); i < loop_.corner.size(); ++i)
            shared_[i] = shared_[loop_.corner[i]] = 1;
        for (std::uint32_t i = 0; i < loop_.corner.size(); ++i)
            if (is_blunt(i)) blunt_.push_back(i);
    }

    bool clip(std::vector<std::uint32_t>& indices) {
        const std::vector<std::uint32_t>&next = loop_.next, &previous = loop_.previous;
        std::size_t left = loop_.corner.size(), misses = 0;
        for (std::uint32_t i = 0; left > 3;) {
            if (misses > left) return false; // once round without an ear: the polygon is not simple
            if (no_ear_[i] || !is_ear(i)) {
                no_ear_[i] = 1;
                ++misses;
                i = next[i];
                continue;
            }
            push(indices, i);
            loop_.next[previous[i]] = next[i];
            loop_.previous[next[i]] = previous[i];
            no_ear_[previous[i]] = no_ear_[next[i]] = 0;
            std::erase_if(blunt_, [&](std::uint32_t j) {
                return j == i || ((j == previous[i] || j == next[i]) && !is_blunt(j));
            });
            i = next[next[i]]; // skipping one makes triangles compact rather than a fan of slivers
            misses = 0;
            --left;
            last_ = i;
        }
        if (turn_at(last_) <= 0) return false;
        push(indices, last_);
        return true;
    }

private:
    Vec2 at(std::uint32_t node) const { return corners_[loop_.corner[node]]; }
    int turn_at(std::uint32_t i) const { return turn(at(loop_.previous[i]), at(i), at(loop_.next[i])); }
    bool is_blunt(std::uint32_t i) const { return shared_[i] || turn_at(i) <= 0; }

    bool is_ear(std::uint32_t i) const {
        if (turn_at(i) <= 0) return false;
        std::uint32_t before = loop_.previous[i], after = loop_.next[i];
        Vec2 a = at(before), b = at(i), c = at(after);
        if (shared_[before] && !opens_toward(before, c)) return false;
        if (shared_[after] && !opens_toward(after, a)) return false;
        Vec2 low = min(a, min(b, c)), high = max(a, max(b, c));
        for (std::uint32_t j : blunt_) {
            Vec2 p = at(j);
            if (p.x < low.x || p.x > high.x || p.y < low.y || p.y > high.y) continue;
            if (p == a || p == b || p == c) continue;
            if (turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0) return false;
        }
        return true;
    }

    bool opens_toward(std::uint32_t i, Vec2 p) const { return evil::opens_toward(loop_, corners_, i, p); }

    void push(std::vector<std::uint32_t>& indices, std::uint32_t i) const {
        indices.insert(indices.end(), {loop_.corner[loop_.previous[i]], loop_.corner[i], loop_.corner[loop_.next[i]]});
    }

    std::span<const Vec2> corners_;
    Loop loop_;
    std::vector<std::uint8_t> shared_; // is there a bridge at the node's place?
    std::vector<std::uint8_t> no_ear_; // looked at, and no neighbour has gone since
    std::vector<std::uint32_t> blunt_; // nodes that turn right or run straight, and shared ones
    std::uint32_t last_ = 0;
};

} // namespace

bool triangulate(const Rings& rings, std::vector<std::uint32_t>& indices) {
    indices.clear();
    if (rings.corners.size() > kMaxCorners) return false;
    for (std::size_t i = 0; i < rings.count(); ++i)
        if (rings.ring(i).size() < 3) return false;
    indices.reserve(3 * (rings.corners.size() + 2 * rings.holes.size() - 2));
    if (EarClipper(rings).clip(indices)) return true;
    indices.clear();
    return false;
}

} // namespace evil
