#pragma once
// Approximate phase (SPEC C2): which pieces' bounds overlap.
#include "collider/candidates.hpp"
#include "collider/contact.hpp"
#include "collider/placed.hpp"
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

// Pieces of about the same size, by the cell that the middle of their bounds lies in. No bounds are wider than a cell, so
// whatever meets a piece lies in the nine cells round it.
struct Grid {
    double origin_x = 0, origin_y = 0, cell = 1; // metres
    double per_metre = 1;                        // cells
    std::int64_t columns = 0, rows = 0;
    std::uint32_t column_bits = 0;
    float widest = 0; // side of the bounds in it
    std::vector<std::uint64_t> cells;
    std::vector<float> low_x, low_y, high_x, high_y;
    std::vector<std::uint32_t> pieces, owners;
};

// Sizes differ, so there are a few grids, each for bounds within a factor of four. Which grids there are changes how long
// it takes to find the pairs, not which pairs are found.
struct BroadPhase { // Scratch
    Candidates candidates;
    struct Item {
        std::uint64_t cell;
        std::uint32_t piece;
    };
    std::vector<Grid> grids;
    std::size_t used = 0;                            // of them
    std::vector<std::vector<std::uint32_t>> members; // by grid: its pieces
    std::vector<Item> items, spare;
    std::vector<std::uint32_t> counts;
    std::vector<std::vector<std::uint64_t>> found; // by chunk of work
    std::vector<std::size_t> found_counts;
    std::vector<std::uint32_t> by_first, by_second; // by piece: where its pairs go
    std::vector<Pair> sorted;                       // by the second piece
};

// All pairs of pieces whose bounds overlap, at least one of a dynamic body or a sensor, of different bodies. Sorted. Pairs
// of very different size are tested along the sides of the larger form as well. False: they are as the last call left them
// in `pairs`, which is the same list in all calls.
bool find_pairs(BroadPhase& broad, const Placements& placed, std::vector<Pair>& pairs, InstructionSet set,
                Threads& threads);

} // namespace evil
