#include "draw/liquid_steps.hpp"
#include "draw/liquid_wide.hpp"
#include <algorithm>
#include <cmath>

namespace evil::draw {
namespace {

// Blurs a plane with a bell of a variance of apart^2 texels, `passes` times. Beyond its edges it goes on as there.
void blur(std::vector<float>& plane, LiquidScratch& scratch, const LiquidGrid& grid, int apart, int passes,
          InstructionSet set) {
    const int width = grid.width, reach = 2 * apart;
    scratch.other.resize(grid.size());
    scratch.row.resize(static_cast<std::size_t>(grid.stride) + 2 * reach + 16);
    for (int pass = 0; pass < passes; ++pass) {
        for (int y = 0; y < grid.height; ++y) {
            const float* from = plane.data() + static_cast<std::size_t>(y) * grid.stride;
            float* row = scratch.row.data();
            std::fill_n(row, reach, from[0]);
            std::copy_n(from, width, row + reach);
            std::fill_n(row + reach + width, grid.stride - width + reach, from[width - 1]);
            EVIL_PICK(set, mean_of_five_wide)
            (row, apart, scratch.other.data() + static_cast<std::size_t>(y) * grid.stride, width);
        }
        for (int y = 0; y < grid.height; ++y) {
            const float* rows[5];
            for (int k = 0; k < 5; ++k) {
                const int from = std::clamp(y + (k - 2) * apart, 0, grid.height - 1);
                rows[k] = scratch.other.data() + static_cast<std::size_t>(from) * grid.stride;
            }
            EVIL_PICK(set, mean_of_rows_wide)
            (rows, plane.data() + static_cast<std::size_t>(y) * grid.stride, width);
        }
    }
}

struct Bell { // a quadratic B-spline: three texels and what each gets
    int first;
    float part[3];
};
Bell bell(float at) {
    const float middle = std::floor(at), t = at - middle;
    return {static_cast<int>(middle) - 1,
            {0.5f * (1.0f - t) * (1.0f - t), 0.75f - (t - 0.5f) * (t - 0.5f), 0.5f * t * t}};
}

void splat(float* plane, int stride, const Bell& x, const Bell& y, float value) {
    for (int j = 0; j < 3; ++j) {
        float* row = plane + static_cast<std::size_t>(y.first + j) * stride + x.first;
        const float part = y.part[j] * value;
        for (int i = 0; i < 3; ++i) row[i] += part * x.part[i];
    }
}

} // namespace

void sum_particles(LiquidScratch& scratch, const Sea& sea, const LiquidGrid& grid, std::size_t liquids,
                   InstructionSet set) {
    const std::size_t size = grid.size();
    for (auto* plane : {&scratch.weight, &scratch.sharp, &scratch.whole}) plane->assign(size, 0.0f);
    scratch.shares.resize(liquids - 1);
    for (auto& plane : scratch.shares) plane.assign(size, 0.0f);
    const float right = static_cast<float>(grid.width) - 2.0f, bottom = static_cast<float>(grid.height) - 2.0f;
    for (const std::uint32_t i : scratch.near) {
        const Vec2 at = scratch.at[i];
        if (!(at.x >= 2.0f && at.y >= 2.0f && at.x < right && at.y < bottom)) continue;
        const Bell x = bell(at.x), y = bell(at.y);
        splat(scratch.weight.data(), grid.stride, x, y, 1.0f);
        splat(scratch.sharp.data(), grid.stride, x, y, at.x);
        splat(scratch.whole.data(), grid.stride, x, y, at.y);
        const std::size_t kind = sea.kind.empty() ? 0 : sea.kind[i];
        if (kind > 0 && kind < liquids) splat(scratch.shares[kind - 1].data(), grid.stride, x, y, 1.0f);
    }
    for (auto* plane : {&scratch.weight, &scratch.sharp, &scratch.whole}) blur(*plane, scratch, grid, 1, 2, set);
    for (auto& plane : scratch.shares) blur(plane, scratch, grid, 1, 2, set);
}

void find_sharp(LiquidScratch& scratch, const LiquidGrid& grid, InstructionSet set) {
    for (int y = 0; y < grid.height; ++y) {
        const std::size_t row = static_cast<std::size_t>(y) * grid.stride;
        float *x_sum = scratch.sharp.data() + row, *y_sum = scratch.whole.data() + row;
        EVIL_PICK(set, sharp_wide)
        (scratch.weight.data() + row, x_sum, y_sum, static_cast<float>(y) + 0.5f, grid.one, x_sum, y_sum, grid.width);
    }
}

// Particles that flow apart lie in clumps, with gaps between them that are no air: there is as much liquid round them as
// where it is full. Beside what is solid, half of what is round is missing.
void fill_gaps(LiquidScratch& scratch, const LiquidGrid& grid, InstructionSet set) {
    constexpr float kBell = 2.5f; // texels, of what is blurred so
    constexpr float kHalf = 0.3989f / kBell, kFrom = 0.65f, kFull = 0.85f;
    scratch.known = scratch.weight;
    blur(scratch.known, scratch, grid, 2, 1, set);
    for (std::size_t i = 0; i < grid.size(); ++i) {
        const float room = std::clamp(0.5f + kHalf * scratch.solid[i], 0.5f, 1.0f);
        const float full = (scratch.known[i] * grid.one - kFrom * room) / ((kFull - kFrom) * room);
        scratch.whole[i] = std::max(scratch.whole[i], std::min(full, 1.0f));
    }
}

void find_surface(LiquidScratch& scratch, const LiquidGrid& grid, InstructionSet set) {
    scratch.smooth = scratch.whole;
    blur(scratch.smooth, scratch, grid, 1, 2, set);
    blur(scratch.smooth, scratch, grid, 2, 2, set);
    scratch.bulk = scratch.smooth;
    blur(scratch.bulk, scratch, grid, 4, 1, set);
    for (int y = 0; y < grid.height; ++y) {
        const std::size_t row = static_cast<std::size_t>(y) * grid.stride;
        EVIL_PICK(set, join_wide)
        (scratch.sharp.data() + row, scratch.smooth.data() + row, scratch.bulk.data() + row,
         scratch.smooth.data() + row, grid.width);
    }
}

} // namespace evil::draw
