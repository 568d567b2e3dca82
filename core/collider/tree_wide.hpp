#pragma once
// Walks through a tree: eight boxes at a time. Each calls back for every place whose box it cannot rule out; which places
// those are, and in which order, is the same with every instruction set.
#include "math/cpu.hpp"
#include <cstdint>

namespace evil {

inline constexpr int kMostTreeLevels = 11; // 8^11 places: more than there are numbers for

struct alignas(32) Boxes { // eight boxes side by side; one that holds nothing is turned inside out
    float low_x[8], low_y[8], high_x[8], high_y[8];
};

struct TreeView { // levels[0]: eight pieces to a node, and so on up to the root; see tree.hpp
    const Boxes* levels[kMostTreeLevels];
    int depth;
};

// A segment, or a box moved along one, which is the same for boxes that have grown by its half sides.
struct Sweep {
    float x, y, dx, dy, half_x, half_y;
};

using Visit = float (*)(void* context, std::uint32_t place); // returns how far, from now on, is of interest

EVIL_WIDE(
    // Pieces that the sweep meets from 0 to `limit` of its way, the nearer first as a rule.
    void walk_along(const TreeView& tree, const Sweep& sweep, float limit, Visit visit, void* context) noexcept;
    // Pieces whose boxes overlap one.
    void walk_inside(const TreeView& tree, const float low[2], const float high[2], Visit visit,
                     void* context) noexcept;
    // Pieces whose boxes are nearer to a point than `limit` (square metres), the nearer first as a rule.
    void walk_outward(const TreeView& tree, float x, float y, float limit, Visit visit, void* context) noexcept;)

} // namespace evil
