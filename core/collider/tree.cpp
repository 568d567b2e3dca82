#include "collider/tree.hpp"
#include <cmath>

namespace evil {
namespace {

constexpr float kFar = 3e38f;
constexpr Boxes kEmpty = {{kFar, kFar, kFar, kFar, kFar, kFar, kFar, kFar},
                          {kFar, kFar, kFar, kFar, kFar, kFar, kFar, kFar},
                          {-kFar, -kFar, -kFar, -kFar, -kFar, -kFar, -kFar, -kFar},
                          {-kFar, -kFar, -kFar, -kFar, -kFar, -kFar, -kFar, -kFar}};

void put(Boxes& boxes, std::uint32_t lane, const Bounds& b) {
    boxes.low_x[lane] = b.low.x, boxes.low_y[lane] = b.low.y;
    boxes.high_x[lane] = b.high.x, boxes.high_y[lane] = b.high.y;
}

Bounds around(const Boxes& boxes) {
    Bounds all{{boxes.low_x[0], boxes.low_y[0]}, {boxes.high_x[0], boxes.high_y[0]}};
    for (int i = 1; i < 8; ++i) {
        all.low = min(all.low, {boxes.low_x[i], boxes.low_y[i]});
        all.high = max(all.high, {boxes.high_x[i], boxes.high_y[i]});
    }
    return all;
}

// Place along Hilbert's curve of a cell in a grid of 2^16 by 2^16: quadrant by quadrant, each turned as the curve turns.
std::uint32_t along_curve(std::uint32_t x, std::uint32_t y) {
    std::uint32_t place = 0;
    for (std::uint32_t half = 1u << 15; half > 0; half >>= 1) {
        bool right = x & half, upper = y & half;
        place = place << 2 | ((right ? 3u : 0u) ^ (upper ? 1u : 0u));
        if (upper) continue;
        if (right) x = ~x, y = ~y;
        std::swap(x, y);
    }
    return place;
}

std::uint32_t cell(float value, float low, float size) {
    return static_cast<std::uint32_t>(std::clamp((value - low) / size, 0.0f, 1.0f) * 65535.0f);
}

// Neighbours get neighbouring keys. What is much larger than most comes last, or it would make wide the box of every leaf.
void sort_items(Tree& tree, std::span<const TreeItem> items) {
    Bounds all = items[0].bounds;
    double total = 0.0;
    for (const TreeItem& item : items) {
        all.low = min(all.low, item.bounds.low);
        all.high = max(all.high, item.bounds.high);
        total += double(item.bounds.high.x - item.bounds.low.x) + double(item.bounds.high.y - item.bounds.low.y);
    }
    float size = std::max({all.high.x - all.low.x, all.high.y - all.low.y, 1e-30f});
    float large = static_cast<float>(8.0 * total / static_cast<double>(items.size()));
    tree.keys.clear();
    for (std::uint32_t i = 0; i < items.size(); ++i) {
        const Bounds& b = items[i].bounds;
        Vec2 centre = 0.5f * b.low + 0.5f * b.high;
        std::uint64_t last = b.high.x - b.low.x + b.high.y - b.low.y > large;
        tree.keys.push_back(
            {last << 32 | along_curve(cell(centre.x, all.low.x, size), cell(centre.y, all.low.y, size)), i});
    }
    std::ranges::sort(tree.keys);
}

double half_perimeters(const Tree& tree) {
    double sum = 0.0;
    for (const Boxes& leaf : tree.levels[0]) {
        Bounds b = around(leaf);
        if (b.low.x <= b.high.x) sum += double(b.high.x - b.low.x) + double(b.high.y - b.low.y);
    }
    return sum;
}

// As many nodes on each level as the order needs.
void fit_levels(Tree& tree) {
    std::size_t nodes = (tree.order.size() + 7) / 8;
    tree.depth = 0;
    for (std::size_t last = 0; last != 1 && nodes > 0; last = nodes, nodes = (nodes + 7) / 8)
        tree.levels[tree.depth++].resize(nodes, kEmpty);
}

void raise_bounds(Tree& tree, std::uint32_t place) { // from its leaf up to the root
    for (int level = 0; level + 1 < tree.depth; ++level) {
        place /= 8;
        put(tree.levels[level + 1][place / 8], place % 8, around(tree.levels[level][place]));
    }
}

} // namespace

void build(Tree& tree, std::span<const TreeItem> items) {
    tree.order.clear();
    for (auto& level : tree.levels) level.clear();
    tree.depth = 0;
    tree.sorted = items.size();
    tree.cost = 0.0;
    if (items.empty()) return;
    sort_items(tree, items);
    tree.order.resize(items.size());
    fit_levels(tree);
    for (std::uint32_t place = 0; place < items.size(); ++place) {
        const TreeItem& item = items[tree.keys[place].second];
        tree.order[place] = item.piece;
        put_bounds(tree, place, item.bounds);
    }
    refit(tree);
    tree.cost = half_perimeters(tree);
}

std::uint32_t append(Tree& tree, std::uint32_t piece, const Bounds& bounds) {
    std::uint32_t place = static_cast<std::uint32_t>(tree.order.size());
    int depth = tree.depth;
    tree.order.push_back(piece);
    fit_levels(tree);
    put_bounds(tree, place, bounds);
    if (tree.depth > depth)
        refit(tree); // a new root over all that was there
    else
        raise_bounds(tree, place);
    return place;
}

void put_bounds(Tree& tree, std::uint32_t place, const Bounds& bounds) {
    put(tree.levels[0][place / 8], place % 8, bounds);
}

void set_bounds(Tree& tree, std::uint32_t place, const Bounds& bounds) {
    put_bounds(tree, place, bounds);
    raise_bounds(tree, place);
}

void clear_place(Tree& tree, std::uint32_t place) {
    tree.order[place] = kNone;
    set_bounds(tree, place, {{kFar, kFar}, {-kFar, -kFar}});
}

void refit(Tree& tree) {
    for (int level = 0; level + 1 < tree.depth; ++level)
        for (std::uint32_t node = 0; node < tree.levels[level].size(); ++node)
            put(tree.levels[level + 1][node / 8], node % 8, around(tree.levels[level][node]));
}

TreeView view_of(const Tree& tree) {
    TreeView view{{}, tree.depth};
    for (int level = 0; level < tree.depth; ++level) view.levels[level] = tree.levels[level].data();
    return view;
}

bool worn_out(const Tree& tree) {
    constexpr std::size_t kFew = 64;
    if (tree.order.size() - tree.sorted > kFew + tree.sorted / 4) return true;
    return tree.sorted > kFew && half_perimeters(tree) > 2.0 * tree.cost;
}

} // namespace evil
