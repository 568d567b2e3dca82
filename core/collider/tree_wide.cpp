#include "collider/tree_wide.hpp"
#include "math/wide.hpp"
#include <bit>

namespace evil::EVIL_ISA {
namespace {

constexpr float kCare = 1.000002f; // more than the roundings of a few products take away: a box is never missed by them

struct Waiting { // a node to look into
    float near;
    std::uint32_t node;
    int level;
};

struct Stack { // at most seven are left behind on each level
    Waiting rows[8 * kMostTreeLevels];
    int count = 0;
};

EVIL_INLINE int lowest_lane(unsigned found) {
#if defined(__GNUC__)
    return __builtin_ctz(found);
#else
    int lane = 0;
    while (!(found >> lane & 1u)) ++lane;
    return lane;
#endif
}

// The lanes of `found` by how near they are: into `lanes`, the nearest last. Each goes straight to its place, which is how
// many come before it: branches on distances could not be foretold. No distance is not-a-number, or two would share a place.
EVIL_INLINE int by_distance(unsigned found, const float* near, int* lanes) {
    Floats distances = load(near);
    for (unsigned rest = found; rest != 0u; rest &= rest - 1u) {
        int lane = lowest_lane(rest);
        Floats mine = near[lane];
        unsigned before = bits(distances > mine) | (bits(distances == mine) & ((1u << lane) - 1u));
        lanes[std::popcount(before & found)] = lane;
    }
    return std::popcount(found);
}

// From the root down, always into the nearest box first. `look(boxes, near)` gives the lanes to look into, as bits.
template <class Look>
EVIL_INLINE void walk(const TreeView& tree, float& limit, Visit visit, void* context, const Look& look) {
    if (tree.depth == 0) return;
    Stack stack;
    Waiting at{0.0f, 0, tree.depth - 1};
    for (;;) {
        float near[kLanes];
        int lanes[kLanes];
        int count = by_distance(look(tree.levels[at.level][at.node], near), near, lanes);
        std::uint32_t first = 8 * at.node;
        if (at.level > 0 && count > 0) { // straight on into the nearest, the others wait
            for (int i = 0; i + 1 < count; ++i)
                stack.rows[stack.count++] = {near[lanes[i]], first + static_cast<std::uint32_t>(lanes[i]),
                                             at.level - 1};
            at = {near[lanes[count - 1]], first + static_cast<std::uint32_t>(lanes[count - 1]), at.level - 1};
            continue;
        }
        while (count-- > 0)
            if (near[lanes[count]] <= limit * kCare)
                limit = visit(context, first + static_cast<std::uint32_t>(lanes[count]));
        do {
            if (stack.count == 0) return;
            at = stack.rows[--stack.count];
        } while (at.near > limit * kCare);
    }
}

// 1 / d, and for a ray along the axis a number so large that only a box around it is met.
EVIL_INLINE float inverse(float d) { return d > 1e-30f || d < -1e-30f ? 1.0f / d : 1e30f; }

} // namespace

// Between entering and leaving all slabs of a box (Kay and Kajiya 1986), rounded to its safe side (Ize 2013).
void walk_along(const TreeView& tree, const Sweep& s, float limit, Visit visit, void* context) noexcept {
    Floats x = s.x, y = s.y, half_x = s.half_x, half_y = s.half_y, over_x = inverse(s.dx), over_y = inverse(s.dy);
    walk(tree, limit, visit, context, [&](const Boxes& boxes, float* near) {
        Floats low_x = load(boxes.low_x), high_x = load(boxes.high_x);
        Floats x1 = (low_x - half_x - x) * over_x, x2 = (high_x + half_x - x) * over_x;
        Floats y1 = (load(boxes.low_y) - half_y - y) * over_y, y2 = (load(boxes.high_y) + half_y - y) * over_y;
        Floats enter = max(max(min(x1, x2), min(y1, y2)), 0.0f), leave = min(max(x1, x2), max(y1, y2));
        store(near, enter);
        return bits((enter <= leave * kCare) & (enter <= limit * kCare) & (low_x <= high_x));
    });
}

void walk_inside(const TreeView& tree, const float low[2], const float high[2], Visit visit, void* context) noexcept {
    Floats left = low[0], bottom = low[1], right = high[0], top = high[1];
    float limit = 1.0f;
    walk(tree, limit, visit, context, [&](const Boxes& boxes, float* near) {
        store(near, Floats(0.0f));
        Floats low_x = load(boxes.low_x), high_x = load(boxes.high_x);
        return bits((low_x <= right) & (high_x >= left) & (load(boxes.low_y) <= top) & (load(boxes.high_y) >= bottom) &
                    (low_x <= high_x));
    });
}

void walk_outward(const TreeView& tree, float px, float py, float limit, Visit visit, void* context) noexcept {
    Floats x = px, y = py;
    walk(tree, limit, visit, context, [&](const Boxes& boxes, float* near) {
        Floats low_x = load(boxes.low_x), high_x = load(boxes.high_x);
        Floats dx = max(max(low_x - x, x - high_x), 0.0f);
        Floats dy = max(max(load(boxes.low_y) - y, y - load(boxes.high_y)), 0.0f);
        Floats away = dx * dx + dy * dy;
        store(near, away);
        return bits((away <= limit * kCare) & (low_x <= high_x));
    });
}

} // namespace evil::EVIL_ISA
