#pragma once
// Approximate phase (SPEC C2): which pieces' bounds overlap.
#include "collider/contact.hpp"
#include <span>

namespace evil {

struct Bounds {
    Vec2 low, high;
};
inline bool overlap(const Bounds& a, const Bounds& b) {
    return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}
inline bool contains(const Bounds& b, Vec2 p) {
    return b.low.x <= p.x && p.x <= b.high.x && b.low.y <= p.y && p.y <= b.high.y;
}

Bounds bounds_of(const Shapes& shapes, const Piece& piece, const Pose& pose);

// A grid of levels, made anew each step: on level l cells are 2^l times the smallest, and hold, by their centre, the pieces
// whose bounds are at most a cell wide. So whatever touches a piece lies in the nine cells round it, on each level.
struct BroadPhase { // Scratch
    static constexpr int kLevels = 40;
    struct Entry {
        std::uint64_t cell; // row and column, so that sorting goes along rows
        Bounds bounds;
        std::uint32_t piece, body;
        bool dynamic;
    };
    std::vector<Entry> levels[kLevels];
    std::vector<Pair> unsorted;
    std::vector<std::uint32_t> starts; // by piece: where its pairs go
};

// All pairs of pieces of different bodies, at least one of them dynamic, whose bounds, grown by the margin and by what
// each may move within dt, overlap. Sorted.
void find_pairs(BroadPhase& broad, const Shapes& shapes, const Bodies& bodies, float dt, std::vector<Pair>& pairs);

} // namespace evil
