#include "draw/liquid.hpp"
#include "draw/liquid_steps.hpp"
#include "draw/liquid_wide.hpp"
#include <algorithm>
#include <cmath>

namespace evil::draw {
namespace {

constexpr float kRound = 12.0f;    // texels round what is seen that take part in how it is seen
constexpr float kLens = 9.0f;      // logical points by which the surface displaces what lies behind, at most
constexpr float kWaver = 2.2f;     // logical points, inside
constexpr float kBulge = 7.0f;     // texels from the surface in which it bends light
constexpr float kRimPoints = 2.5f; // logical points that the bright line is wide
constexpr float kUnder = 0.5f;     // pixels that it goes under walls, so that no seam is seen
constexpr float kNothing = -4.0f;  // texels outside, where it is said of a texel that it is
constexpr int kLeftOut = 8;        // texels at either end of a row, of the kRound where nothing is seen

struct Extent {
    float left = 1e9f, top = 1e9f, right = -1e9f, bottom = -1e9f;
};

// Texels lie on the picture's grid, keep their places in the world while the camera moves, and cover what is seen.
bool lay_out(LiquidMap& map, LiquidGrid& grid, LiquidScratch& scratch, const Sea& sea, const LiquidView& view) {
    const float scale = std::sqrt(std::fabs(determinant(view.to_pixel))), apart = sea.spacing * scale;
    const float least = std::max(2.0f, std::round(2.0f * view.points));
    if (!(apart > 0.0f && apart < kFarOff)) return false;
    const float s = map.step = std::max(std::round(0.5f * apart), least), round = kRound * s;
    const float width = static_cast<float>(view.width), height = static_cast<float>(view.height);
    scratch.near.clear();
    scratch.at.resize(sea.at.size());
    Extent box;
    for (std::uint32_t i = 0; i < sea.at.size(); ++i) {
        const Vec2 at = scratch.at[i] = apply(view.to_pixel, sea.at[i] - view.back * sea.velocity[i]);
        if (!(at.x > -round && at.y > -round && at.x < width + round && at.y < height + round)) continue;
        scratch.near.push_back(i);
        box = {std::min(box.left, at.x), std::min(box.top, at.y), std::max(box.right, at.x),
               std::max(box.bottom, at.y)};
    }
    if (scratch.near.empty()) return false;
    const auto start = [s](float origin) { return origin - s * std::floor(origin / s); };
    const auto first = [&](float least_pixel, float origin) {
        return start(origin) + s * (std::floor((least_pixel - start(origin)) / s) - kRound);
    };
    map.first = {first(box.left, view.to_pixel.tx), first(box.top, view.to_pixel.ty)};
    grid.width = map.width = static_cast<int>((box.right - map.first.x) / s + kRound) + 1;
    grid.height = map.height = static_cast<int>((box.bottom - map.first.y) / s + kRound) + 1;
    grid.stride = (grid.width + 7) / 8 * 8 + 8;
    const float t = 1.0f / s;
    grid.to_texel = compose({t, 0, 0, t, 0.5f - map.first.x * t, 0.5f - map.first.y * t}, view.to_pixel);
    grid.scale = scale * t;
    grid.one = 1.0f / std::min(s * s / (apart * apart), 0.25f);
    for (const std::uint32_t i : scratch.near)
        scratch.at[i] = {(scratch.at[i].x - map.first.x) * t + 0.5f, (scratch.at[i].y - map.first.y) * t + 0.5f};
    return true;
}

// Waves that run through the liquid: each is a product of what a texel's column and its row say.
struct Wave {
    float across, up, pace, size; // by a particle's spacing, by a second, of all
};
constexpr Wave kWaveTable[] = {{0.50f, 0.12f, 1.7f, 0.5f}, {-0.31f, 0.27f, 1.3f, 0.8f}, {0.13f, -0.55f, 2.1f, 0.5f}};
constexpr std::size_t kWaveCount = std::size(kWaveTable);
static_assert(kWaveCount == kWaves);

void find_waves(LiquidScratch& scratch, const LiquidGrid& grid, const Sea& sea, const LiquidView& view) {
    const std::size_t width = grid.stride, height = static_cast<std::size_t>(grid.height), all = width + height;
    scratch.waves.resize(2 * kWaveCount * all);
    const Affine& m = grid.to_texel;
    const double det = static_cast<double>(determinant(m));
    for (std::size_t k = 0; k < kWaveCount; ++k) {
        const Wave& wave = kWaveTable[k];
        const double kx = wave.across / sea.spacing * 0.5, ky = wave.up / sea.spacing * 0.5;
        const double along = (kx * m.d - ky * m.b) / det, down = (ky * m.a - kx * m.c) / det; // a texel, by the inverse
        const double origin = wave.pace * view.time - along * m.tx - down * m.ty;
        float* sines = scratch.waves.data() + 2 * k * all;
        for (std::size_t x = 0; x < width; ++x) {
            const SinCos f = sincos(origin + along * static_cast<double>(x));
            sines[x] = f.sin, sines[all + x] = f.cos;
        }
        for (std::size_t y = 0; y < height; ++y) {
            const SinCos f = sincos(down * static_cast<double>(y));
            sines[width + y] = f.sin, sines[all + width + y] = f.cos;
        }
    }
}

struct Shading { // what does not change over the map
    const LiquidLook& look;
    LiquidScratch& scratch;
    const LiquidGrid& grid;
    const LiquidDepths& depths;
    Affine to_cell; // from a texel's middle
    Vec2 up;        // in the picture
    float lens, waver;
};

// The tables as the inner loop wants them: channel by channel.
void lay_tables(LiquidScratch& scratch, const LiquidLook& look) {
    scratch.tables.resize(look.tables.size() * 6 * kTones);
    float* to = scratch.tables.data();
    for (const LiquidTable& table : look.tables)
        for (std::size_t c = 0; c < 6; ++c)
            for (int tone = 0; tone < kTones; ++tone) {
                const float at = static_cast<float>(tone) * static_cast<float>(kLiquidTable - 1) / (kTones - 1);
                const std::size_t low =
                    std::min(static_cast<std::size_t>(at), static_cast<std::size_t>(kLiquidTable - 2));
                const float t = at - static_cast<float>(low);
                *to++ = table[low][c] + t * (table[low + 1][c] - table[low][c]);
            }
}

LiquidShade shade_of(LiquidMap& map, const Shading& s, int y) {
    const std::size_t stride = static_cast<std::size_t>(s.grid.stride), row = static_cast<std::size_t>(y) * stride;
    const std::size_t all = stride + static_cast<std::size_t>(s.grid.height);
    const float* depth = s.scratch.smooth.data() + row;
    LiquidShade shade{};
    shade.depth = depth, shade.above = depth - stride, shade.below = depth + stride;
    shade.wall = s.scratch.wall.data() + row, shade.bulk = s.scratch.bulk.data() + row;
    shade.weight = s.scratch.weight.data() + row;
    shade.kinds = static_cast<int>(s.look.tables.size()), shade.tables = s.scratch.tables.data();
    for (std::size_t k = 0; k < s.scratch.shares.size(); ++k) shade.shares[k + 1] = s.scratch.shares[k].data() + row;
    for (std::size_t k = 0; k < kWaveCount; ++k) {
        const float* sines = s.scratch.waves.data() + 2 * k * all;
        const std::size_t line = stride + static_cast<std::size_t>(y);
        shade.waves[k] = {sines, sines + all, sines[line], sines[all + line], kWaveTable[k].size};
    }
    const Vec2 cell = apply(s.to_cell, {0.5f, static_cast<float>(y) + 0.5f});
    shade.darkness = s.scratch.darkness.data();
    shade.cells_across = s.depths.width, shade.cells_down = s.depths.height;
    shade.cell_x = cell.x - 0.5f, shade.cell_y = cell.y - 0.5f;
    shade.cell_x_step = s.to_cell.a, shade.cell_y_step = s.to_cell.b;
    shade.lens = s.lens, shade.waver = s.waver, shade.rim = s.look.rim;
    shade.step = map.step, shade.under = kUnder, shade.bulge = 1.0f / kBulge;
    shade.up_x = s.up.x, shade.up_y = s.up.y;
    for (std::size_t k = 0; k < kLiquidPlanes; ++k) shade.to[k] = map.planes[k].data() + row;
    return shade;
}

// The map's rim, where nothing is seen, is left out.
void shade(LiquidMap& map, const Shading& s, InstructionSet set) {
    for (auto& plane : map.planes) plane.resize(s.grid.size());
    std::vector<float>& depth = map.planes[kDepth];
    for (int y = 0; y < s.grid.height; ++y) {
        const auto row = depth.begin() + static_cast<std::ptrdiff_t>(y) * s.grid.stride;
        const bool rim = y == 0 || y + 1 == s.grid.height;
        std::fill(row, row + (rim ? s.grid.stride : kLeftOut), kNothing * map.step);
        std::fill(row + s.grid.width - kLeftOut, row + s.grid.stride, kNothing * map.step);
        if (!rim) EVIL_PICK(set, shade_liquid_wide)(shade_of(map, s, y), kLeftOut, s.grid.width - 2 * kLeftOut);
    }
}

Affine inverse(const Affine& m) {
    const float by = 1.0f / determinant(m);
    const Affine r{m.d * by, -m.b * by, -m.c * by, m.a * by, 0, 0};
    const Vec2 origin = apply_linear(r, {m.tx, m.ty});
    return {r.a, r.b, r.c, r.d, -origin.x, -origin.y};
}

} // namespace

bool map_liquid(LiquidMap& map, LiquidScratch& scratch, const Sea& sea, const LiquidLook& look, const LiquidView& view,
                const World& world, float alpha) {
    LiquidGrid grid;
    if (look.tables.empty() || !lay_out(map, grid, scratch, sea, view)) return false;
    const InstructionSet set = world.instruction_set;
    const Vec2 up = normalised(apply_linear(view.to_pixel, view.up));
    sum_particles(scratch, sea, grid, look.tables.size(), set);
    find_sharp(scratch, grid, set);
    find_solids(scratch, sea, grid, world, alpha);
    fill_gaps(scratch, grid, set);
    fill_solids(scratch, grid, std::fabs(up.y) >= std::fabs(up.x));
    fill_shares(scratch, grid);
    find_surface(scratch, grid, set);
    const LiquidDepths depths = find_depths(scratch, sea, look.clarity, world, alpha);
    find_waves(scratch, grid, sea, view);

    const float per = 1.0f / depths.cell;
    const Affine to_cell = compose({per, 0, 0, per, -depths.low.x * per, -depths.low.y * per}, inverse(grid.to_texel));
    map.rim_width = std::max(kRimPoints * view.points, 0.6f * map.step);
    map.lit = look.lit;
    const float lens = look.refraction * kLens * view.points,
                waver = look.refraction * look.waves * kWaver * view.points;
    lay_tables(scratch, look);
    shade(map, {look, scratch, grid, depths, to_cell, up, lens, waver}, set);
    map.reach = static_cast<int>(std::min(1.5f * lens + 2.0f * waver, 4096.0f)) + 2;
    map.width = grid.width;
    map.stride = grid.stride;
    return true;
}

} // namespace evil::draw
