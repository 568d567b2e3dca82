#pragma once
// Bounds of many pieces as a tree of eights: what a query need not look at, eight boxes at a time.
#include "collider/broad_phase.hpp"
#include "collider/tree_wide.hpp"

namespace evil {

// The pieces lie in an order that keeps neighbours together (Hilbert's curve; Kamel and Faloutsos 1994), eight to a leaf,
// eight leaves to a node above, and so on: who is whose child follows from the numbers alone. A piece that comes later
// goes to the end of the order, one that goes leaves its place empty; build() puts all in order again.
struct Tree {                         // Scratch
    std::vector<std::uint32_t> order; // piece at each place, or kNone
    std::vector<Boxes> levels[kMostTreeLevels];
    int depth = 0;          // levels in use; the last one is a single node
    std::size_t sorted = 0; // places that build() filled
    double cost = 0.0;      // sum of the leaves' half perimeters when it was built: growth says that it is worn out
    std::vector<std::pair<std::uint64_t, std::uint32_t>> keys; // while it is built
};

struct TreeItem {
    std::uint32_t piece;
    Bounds bounds;
};

void build(Tree& tree, std::span<const TreeItem> items);
std::uint32_t append(Tree& tree, std::uint32_t piece, const Bounds& bounds); // its place
void set_bounds(Tree& tree, std::uint32_t place, const Bounds& bounds);      // and those of the nodes above
void clear_place(Tree& tree, std::uint32_t place);

// To give many places new bounds: put_bounds each, then refit once.
void put_bounds(Tree& tree, std::uint32_t place, const Bounds& bounds);
void refit(Tree& tree);
TreeView view_of(const Tree& tree);
bool worn_out(const Tree& tree); // has it lost so much of its order that building it anew pays?

} // namespace evil
