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
class EarClipper {
public:
    explicit EarClipper(std::span<const Vec2> corners)
        : corners_(corners), previous_(corners.size()), next_(corners.size()), no_ear_(corners.size(), 0) {
        std::uint32_t n = static_cast<std::uint32_t>(corners.size());
        bool clockwise = signed_area(corners) < 0.0;
        for (std::uint32_t i = 0; i < n; ++i) {
            std::uint32_t left = i == 0 ? n - 1 : i - 1, right = i + 1 == n ? 0 : i + 1;
            previous_[i] = clockwise ? right : left;
            next_[i] = clockwise ? left : right;
        }
        for (std::uint32_t i = 0; i < n; ++i)
            if (turn_at(i) <= 0) blunt_.push_back(i);
    }

    bool clip(std::vector<std::uint32_t>& indices) {
        std::size_t left = corners_.size(), misses = 0;
        for (std::uint32_t i = 0; left > 3;) {
            if (misses > left) return false; // once round without an ear: the polygon is not simple
            if (no_ear_[i] || !is_ear(i)) {
                no_ear_[i] = 1;
                ++misses;
                i = next_[i];
                continue;
            }
            push(indices, i);
            next_[previous_[i]] = next_[i];
            previous_[next_[i]] = previous_[i];
            no_ear_[previous_[i]] = no_ear_[next_[i]] = 0;
            std::erase_if(blunt_,
                          [&](std::uint32_t j) { return (j == previous_[i] || j == next_[i]) && turn_at(j) > 0; });
            i = next_[next_[i]]; // skipping one makes triangles compact rather than a fan of slivers
            misses = 0;
            --left;
            last_ = i;
        }
        if (turn_at(last_) <= 0) return false;
        push(indices, last_);
        return true;
    }

private:
    int turn_at(std::uint32_t i) const { return turn(corners_[previous_[i]], corners_[i], corners_[next_[i]]); }

    bool is_ear(std::uint32_t i) const {
        if (turn_at(i) <= 0) return false;
        Vec2 a = corners_[previous_[i]], b = corners_[i], c = corners_[next_[i]];
        Vec2 low = min(a, min(b, c)), high = max(a, max(b, c));
        for (std::uint32_t j : blunt_) {
            Vec2 p = corners_[j];
            if (p.x < low.x || p.x > high.x || p.y < low.y || p.y > high.y) continue;
            if (j == previous_[i] || j == next_[i]) continue;
            if (turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0) return false;
        }
        return true;
    }

    void push(std::vector<std::uint32_t>& indices, std::uint32_t i) const {
        indices.insert(indices.end(), {previous_[i], i, next_[i]});
    }

    std::span<const Vec2> corners_;
    std::vector<std::uint32_t> previous_, next_;
    std::vector<std::uint8_t> no_ear_; // looked at, and no neighbour has gone since
    std::vector<std::uint32_t> blunt_; // corners that turn right or run straight
    std::uint32_t last_ = 0;
};

} // namespace

bool triangulate(std::span<const Vec2> corners, std::vector<std::uint32_t>& indices) {
    indices.clear();
    if (corners.size() < 3 || corners.size() > kMaxCorners) return false;
    indices.reserve(3 * (corners.size() - 2));
    if (EarClipper(corners).clip(indices)) return true;
    indices.clear();
    return false;
}

} // namespace evil
