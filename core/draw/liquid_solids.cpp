#include "draw/liquid_steps.hpp"
#include <algorithm>
#include <cmath>

namespace evil::draw {
namespace {

constexpr std::size_t kMostSides = 256; // of a convex shape, its round corners as light has them
constexpr float kNear = 3.0f;           // texels from a solid within which distances to it matter

using light::Caster;

struct Side { // of a convex shape: how far outside of it a point is, where it is the nearest one
    Vec2 normal;
    float at;
};

// Distances to a caster, where they are less than what is known.
template <class Put>
void each_near(const light::Casters& casters, const Caster& caster, const LiquidGrid& grid, Put put) {
    const float reach = caster.radius + kNear;
    const auto texel = [](float at, int most) {
        return static_cast<int>(std::clamp(at, 0.0f, static_cast<float>(most)));
    };
    const int left = texel(caster.middle.x - reach, grid.width),
              right = texel(caster.middle.x + reach + 1.0f, grid.width);
    const int top = texel(caster.middle.y - reach, grid.height),
              bottom = texel(caster.middle.y + reach + 1.0f, grid.height);
    const std::span<const Vec2> corners = std::span(casters.corners).subspan(caster.first, caster.count);
    float area = 0.0f;
    for (std::size_t i = 0; i < corners.size(); ++i)
        area += cross(corners[i] - corners[0], corners[(i + 1) % corners.size()] - corners[0]);
    Side sides[kMostSides];
    const std::size_t count = std::min(corners.size(), kMostSides);
    for (std::size_t i = 0; i < count; ++i) {
        const Vec2 along = corners[(i + 1) % corners.size()] - corners[i];
        const Vec2 normal = normalised(area > 0.0f ? Vec2{along.y, -along.x} : Vec2{-along.y, along.x});
        sides[i] = {normal, dot(normal, corners[i])};
    }
    for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x) {
            const Vec2 at{static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f};
            float distance = -1e9f;
            if (count == 0) distance = length(at - caster.middle) - caster.radius;
            for (std::size_t i = 0; i < count; ++i)
                distance = std::max(distance, dot(sides[i].normal, at) - sides[i].at);
            put(static_cast<std::size_t>(y) * grid.stride + static_cast<std::size_t>(x), distance);
        }
}

// The walls of its area: how far inside of each a texel is, which changes evenly over the map.
void put_walls(std::vector<float>& wall, const Sea& sea, const LiquidGrid& grid) {
    const Affine& m = grid.to_texel;
    const Vec2 across = normalised({m.a, m.b}), up = normalised({m.c, m.d}); // the world's axes
    const Vec2 low = apply(m, sea.low), high = apply(m, sea.high);
    const Vec2 normals[4] = {across, -1.0f * across, up, -1.0f * up};
    for (std::size_t k = 0; k < 4; ++k) {
        if (!sea.closed[k]) continue;
        const float start = -dot(normals[k], k % 2 == 0 ? low : high);
        for (int y = 0; y < grid.height; ++y) {
            float* row = wall.data() + static_cast<std::size_t>(y) * grid.stride;
            const float first = start + normals[k].y * (static_cast<float>(y) + 0.5f) + 0.5f * normals[k].x;
            for (int x = 0; x < grid.width; ++x)
                row[x] = std::min(row[x], first + normals[k].x * static_cast<float>(x));
        }
    }
}

struct Level {
    std::vector<float>*mean, *weight;
    int width, height, stride;
    int across, down; // how many texels of the finer level make one of it each way: 1 or 2
};

// A coarser level: means of two or four texels, by their weights.
void halve(const Level& from, const Level& to) {
    for (int y = 0; y < to.height; ++y)
        for (int x = 0; x < to.width; ++x) {
            float sum = 0.0f, weights = 0.0f;
            for (int j = 0; j < to.down; ++j)
                for (int i = 0; i < to.across; ++i) {
                    const int fx = to.across * x + i, fy = to.down * y + j;
                    if (fx >= from.width || fy >= from.height) continue;
                    const std::size_t at = static_cast<std::size_t>(fy) * from.stride + static_cast<std::size_t>(fx);
                    sum += (*from.weight)[at] * (*from.mean)[at], weights += (*from.weight)[at];
                }
            const std::size_t at = static_cast<std::size_t>(y) * to.stride + static_cast<std::size_t>(x);
            (*to.mean)[at] = weights > 0.0f ? sum / weights : 0.0f;
            (*to.weight)[at] = std::min(weights, 1.0f);
        }
}

struct Taps { // along one axis: two texels of a coarser level, and the share of the second
    int near, far;
    float part;
};
Taps taps(int at, int by, int count) {
    const int near = std::min(at / by, count - 1);
    if (by == 1) return {near, near, 0.0f};
    return {near, std::clamp(near + 2 * (at & 1) - 1, 0, count - 1), 0.25f};
}

// What a level does not know it takes from the coarser one, between whose texels it lies.
void take_from(const Level& coarse, const Level& fine) {
    for (int y = 0; y < fine.height; ++y)
        for (int x = 0; x < fine.width; ++x) {
            const std::size_t at = static_cast<std::size_t>(y) * fine.stride + static_cast<std::size_t>(x);
            const float known = (*fine.weight)[at];
            if (known >= 1.0f) continue;
            const Taps i = taps(x, coarse.across, coarse.width), j = taps(y, coarse.down, coarse.height);
            const auto row = [&](int line) {
                const float* from = coarse.mean->data() + static_cast<std::size_t>(line) * coarse.stride;
                return from[i.near] + i.part * (from[i.far] - from[i.near]);
            };
            const float mean = row(j.near) + j.part * (row(j.far) - row(j.near));
            (*fine.mean)[at] = known * (*fine.mean)[at] + (1.0f - known) * mean;
        }
}

} // namespace

void find_solids(LiquidScratch& scratch, const Sea& sea, const LiquidGrid& grid, const World& world, float alpha) {
    light::gather(scratch.casters, world, grid.to_texel, alpha);
    scratch.wall.assign(grid.size(), 1e3f);
    put_walls(scratch.wall, sea, grid);
    scratch.solid = scratch.wall;
    for (const Caster& caster : scratch.casters.rows) {
        const bool bounds = world.bodies.rows[caster.body].kind != BodyKind::dynamic;
        each_near(scratch.casters, caster, grid, [&](std::size_t at, float distance) {
            scratch.solid[at] = std::min(scratch.solid[at], distance);
            if (bounds) scratch.wall[at] = std::min(scratch.wall[at], distance);
        });
    }
}

namespace {

// Pull and push (after Gortler et al. 1996): where `scratch.known` is less than 1, `plane` becomes what is round there. It
// looks along the rows, or the columns, first, so many halvings far.
void fill(std::vector<float>& plane, LiquidScratch& scratch, const LiquidGrid& grid, bool upright, std::size_t along) {
    constexpr std::size_t kLevels = 11;
    scratch.means.resize(kLevels), scratch.weights.resize(kLevels);
    std::array<Level, kLevels + 1> levels;
    levels[0] = {&plane, &scratch.known, grid.width, grid.height, grid.stride, 1, 1};
    for (std::size_t k = 0; k < kLevels; ++k) {
        const int across = upright || k >= along ? 2 : 1, down = !upright || k >= along ? 2 : 1;
        const int width = (levels[k].width + across - 1) / across, height = (levels[k].height + down - 1) / down;
        scratch.means[k].resize(static_cast<std::size_t>(width) * height);
        scratch.weights[k].resize(static_cast<std::size_t>(width) * height);
        levels[k + 1] = {&scratch.means[k], &scratch.weights[k], width, height, width, across, down};
        halve(levels[k], levels[k + 1]);
    }
    for (std::size_t k = kLevels; k > 0; --k) take_from(levels[k], levels[k - 1]);
}

} // namespace

// Liquid goes on behind what is solid as it is round it, so that its surface meets walls squarely and goes on behind what
// swims; the gap that particles leave along a solid is not seen either. A surface goes straight on: it looks along the level
// first, six halvings far.
void fill_solids(LiquidScratch& scratch, const LiquidGrid& grid, bool upright) {
    constexpr float kGap = 2.0f; // texels along a solid in which air is not believed
    scratch.known.resize(grid.size());
    bool any = false;
    for (std::size_t i = 0; i < grid.size(); ++i) {
        const float free = std::clamp(scratch.solid[i] * (1.0f / kGap), 0.0f, 1.0f);
        any |= free < 1.0f;
        scratch.known[i] = scratch.solid[i] <= 0.0f ? 0.0f : free + (1.0f - free) * scratch.whole[i];
    }
    if (any) fill(scratch.whole, scratch, grid, upright, 6);
}

// Which liquid it is behind what swims is what it is round there, too: the shares of those where no particle is near.
void fill_shares(LiquidScratch& scratch, const LiquidGrid& grid) {
    constexpr float kSome = 1e-3f; // of a particle
    if (scratch.shares.empty() || scratch.casters.rows.empty()) return;
    for (auto& plane : scratch.shares) {
        for (std::size_t i = 0; i < grid.size(); ++i) {
            const float weight = scratch.weight[i];
            scratch.known[i] = std::min(weight, 1.0f);
            plane[i] = weight > 0.0f ? plane[i] / weight : 0.0f;
        }
        fill(plane, scratch, grid, false, 0);
        for (std::size_t i = 0; i < grid.size(); ++i) plane[i] *= std::max(scratch.weight[i], kSome);
    }
    for (float& weight : scratch.weight) weight = std::max(weight, kSome);
}

} // namespace evil::draw
