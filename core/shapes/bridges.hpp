#pragma once
// From an outline with holes to one loop, which ear clipping can take.
#include "shapes/rings.hpp"

namespace evil {

// A loop of nodes, each at a corner; where a bridge ends, two nodes or more share one.
struct Loop {
    std::vector<std::uint32_t> corner, previous, next;
};

// The loop round what is solid, counter-clockwise. Each hole is joined to the rest by a bridge, an edge that the loop
// follows there and back. It begins at node 0, the outline's first corner; without holes, nodes are the corners.
//
//     ._____________.
//     |    .___.    |
//     |    | M |____R       M: the corner of the hole farthest to the right, R: one that it sees
//     |    |___|    |
//     |_____________|
Loop bridged(const Rings& rings);

// Does the direction from the node to p lie strictly within the loop's angle there?
bool opens_toward(const Loop& loop, std::span<const Vec2> corners, std::uint32_t node, Vec2 p);

} // namespace evil
