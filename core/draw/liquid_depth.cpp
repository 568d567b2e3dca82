#include "draw/liquid_steps.hpp"
#include <algorithm>
#include <cmath>

namespace evil::draw {
namespace {

constexpr int kMostCells = 160; // along the longer side

// Along a line: each value becomes a mean in which others count less by `keep` a cell, both ways; it goes on beyond its ends.
void spread(float* line, int count, std::ptrdiff_t apart, float keep, std::vector<float>& back) {
    back.resize(static_cast<std::size_t>(count));
    const float share = (1.0f - keep) / (1.0f + keep), beyond = keep / (1.0f - keep);
    float sum = beyond * line[(count - 1) * apart];
    for (int i = count - 1; i >= 0; --i) back[static_cast<std::size_t>(i)] = sum, sum = keep * (sum + line[i * apart]);
    sum = line[0] / (1.0f - keep);
    for (int i = 0; i < count; ++i) {
        if (i > 0) sum = keep * sum + line[i * apart];
        line[i * apart] = share * (sum + back[static_cast<std::size_t>(i)]);
    }
}

void spread(std::vector<float>& plane, const LiquidDepths& grid, float keep, std::vector<float>& back) {
    for (int y = 0; y < grid.height; ++y)
        spread(plane.data() + static_cast<std::size_t>(y) * grid.width, grid.width, 1, keep, back);
    for (int x = 0; x < grid.width; ++x) spread(plane.data() + x, grid.height, grid.width, keep, back);
}

LiquidDepths lay_out(const Sea& sea) {
    Vec2 low{1e30f, 1e30f}, high{-1e30f, -1e30f};
    for (const Vec2 at : sea.at) {
        if (!(at.x >= sea.low.x && at.y >= sea.low.y && at.x <= sea.high.x && at.y <= sea.high.y)) continue;
        low = {std::min(low.x, at.x), std::min(low.y, at.y)}, high = {std::max(high.x, at.x), std::max(high.y, at.y)};
    }
    if (low.x > high.x) return {};
    const Vec2 size = high - low;
    LiquidDepths grid;
    grid.cell = std::max(2.0f * sea.spacing, std::max(size.x, size.y) / static_cast<float>(kMostCells));
    const float margin = 2.0f * grid.cell;
    // Cells keep their places in the world, so that what flows does not flicker.
    const auto first = [&](float at) { return std::floor((at - margin) / grid.cell); };
    grid.low = {first(low.x) * grid.cell, first(low.y) * grid.cell};
    grid.width = static_cast<int>((high.x + margin - grid.low.x) / grid.cell) + 2;
    grid.height = static_cast<int>((high.y + margin - grid.low.y) / grid.cell) + 2;
    return grid;
}

void count_air(LiquidScratch& scratch, const Sea& sea, const LiquidDepths& grid) {
    const float full = sea.spacing * sea.spacing / (grid.cell * grid.cell); // of a cell, by one particle
    for (const Vec2 at : sea.at) {
        const Vec2 cell = (1.0f / grid.cell) * (at - grid.low);
        if (!(cell.x >= 0.0f && cell.y >= 0.0f)) continue;
        const int x = static_cast<int>(cell.x), y = static_cast<int>(cell.y);
        if (x < grid.width && y < grid.height) scratch.air[static_cast<std::size_t>(y) * grid.width + x] -= full;
    }
    // What is solid lets no light in, as deep liquid does not; nor does what is beyond a wall.
    const auto open = [&](float first, float low, float high, bool from, bool to) {
        const float left = from ? std::max(first, low) : first,
                    right = to ? std::min(first + grid.cell, high) : first + grid.cell;
        return std::max(right - left, 0.0f) / grid.cell;
    };
    for (int y = 0; y < grid.height; ++y) {
        const float up =
            open(grid.low.y + grid.cell * static_cast<float>(y), sea.low.y, sea.high.y, sea.closed[2], sea.closed[3]);
        for (int x = 0; x < grid.width; ++x) {
            const float across = open(grid.low.x + grid.cell * static_cast<float>(x), sea.low.x, sea.high.x,
                                      sea.closed[0], sea.closed[1]);
            const std::size_t at = static_cast<std::size_t>(y) * grid.width + static_cast<std::size_t>(x);
            scratch.air[at] = scratch.filled[at] ? 0.0f : std::max(up * across + scratch.air[at], 0.0f);
        }
    }
}

} // namespace

LiquidDepths find_depths(LiquidScratch& scratch, const Sea& sea, float clarity, const World& world, float alpha) {
    const LiquidDepths grid = lay_out(sea);
    const std::size_t size = static_cast<std::size_t>(grid.width) * grid.height;
    scratch.air.assign(size, 0.0f), scratch.filled.assign(size, 0);
    if (size == 0) return grid;
    const float per = 1.0f / grid.cell;
    light::gather(scratch.casters, world, {per, 0, 0, per, -grid.low.x * per, -grid.low.y * per}, alpha);
    for (const light::Caster& caster : scratch.casters.rows)
        light::fill<std::uint8_t>(scratch.casters, caster, grid.width, grid.height, grid.width, scratch.filled, 1,
                                  light::Covers::middle);
    count_air(scratch, sea, grid);
    const float keep = std::clamp(1.0f - grid.cell / std::max(clarity, 2.0f * grid.cell), 0.0f, 0.99f);
    spread(scratch.air, grid, keep, scratch.row);
    scratch.darkness.resize(size);
    for (std::size_t i = 0; i < size; ++i) scratch.darkness[i] = std::clamp(1.0f - 2.0f * scratch.air[i], 0.0f, 1.0f);
    return grid;
}

} // namespace evil::draw
