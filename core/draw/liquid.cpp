#include "draw/liquid.hpp"
#include "draw/liquid_steps.hpp"
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
constexpr float kNothing = -3.0f;  // texels outside from which on a texel is never asked for its colours

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
constexpr Wave kWaves[] = {{0.50f, 0.12f, 1.7f, 0.5f}, {-0.31f, 0.27f, 1.3f, 0.8f}, {0.13f, -0.55f, 2.1f, 0.5f}};
constexpr std::size_t kWaveCount = std::size(kWaves);

void find_waves(LiquidScratch& scratch, const LiquidGrid& grid, const Sea& sea, const LiquidView& view) {
    const std::size_t width = grid.stride, height = static_cast<std::size_t>(grid.height), all = width + height;
    scratch.waves.resize(2 * kWaveCount * all);
    const Affine& m = grid.to_texel;
    const double det = static_cast<double>(determinant(m));
    for (std::size_t k = 0; k < kWaveCount; ++k) {
        const Wave& wave = kWaves[k];
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

Vec2 waver(const LiquidScratch& scratch, const LiquidGrid& grid, std::size_t x, std::size_t y) {
    const std::size_t width = grid.stride, all = width + static_cast<std::size_t>(grid.height);
    Vec2 sum{};
    for (std::size_t k = 0; k < kWaveCount; ++k) {
        const float* sines = scratch.waves.data() + 2 * k * all;
        const float sx = sines[x], cx = sines[all + x], sy = sines[width + y], cy = sines[all + width + y];
        sum = sum + kWaves[k].size * Vec2{sx * cy + cx * sy, cx * cy - sx * sy};
    }
    return sum;
}

struct Colours {
    float part[6];
};

Colours between(const LiquidTable& table, float darkness) {
    const float at = darkness * static_cast<float>(kLiquidTable - 1);
    const std::size_t low = std::min(static_cast<std::size_t>(at), static_cast<std::size_t>(kLiquidTable - 2));
    const float t = at - static_cast<float>(low);
    Colours result{};
    for (std::size_t c = 0; c < 6; ++c) result.part[c] = table[low][c] + t * (table[low + 1][c] - table[low][c]);
    return result;
}

// Where liquids meet, each has its share of the colours.
Colours colours_at(const LiquidScratch& scratch, const LiquidLook& look, std::size_t at, float darkness) {
    Colours sum = between(look.tables[0], darkness);
    const float all = scratch.weight[at];
    if (scratch.shares.empty() || !(all > 1e-4f)) return sum;
    float first = 1.0f;
    Colours others{};
    for (std::size_t k = 0; k < scratch.shares.size(); ++k) {
        const float share = std::clamp(scratch.shares[k][at] / all, 0.0f, 1.0f);
        if (share == 0.0f) continue;
        const Colours one = between(look.tables[k + 1], darkness);
        for (std::size_t c = 0; c < 6; ++c) others.part[c] += share * one.part[c];
        first -= share;
    }
    first = std::max(first, 0.0f);
    for (std::size_t c = 0; c < 6; ++c) sum.part[c] = first * sum.part[c] + others.part[c];
    return sum;
}

struct Shading { // what does not change over the map
    const LiquidLook& look;
    const LiquidScratch& scratch;
    const LiquidGrid& grid;
    const LiquidDepths& depths;
    Affine to_cell; // from a texel's middle
    Vec2 up;        // in the picture
    float lens, waver;
};

void shade_texel(LiquidMap& map, const Shading& s, std::size_t x, std::size_t y, std::size_t at, float inside) {
    const std::vector<float>& depth = s.scratch.smooth;
    const std::size_t stride = s.grid.stride;
    const std::size_t left = x > 0 ? at - 1 : at, right = x + 1 < static_cast<std::size_t>(s.grid.width) ? at + 1 : at;
    const std::size_t above = y > 0 ? at - stride : at;
    const std::size_t below = y + 1 < static_cast<std::size_t>(s.grid.height) ? at + stride : at;
    const Vec2 slope{0.5f * (depth[right] - depth[left]), 0.5f * (depth[below] - depth[above])}; // inwards
    const float near = 1.0f - std::clamp(inside / kBulge, 0.0f, 1.0f);
    const Vec2 wave = waver(s.scratch, s.grid, x, y);
    const Vec2 away = s.lens * near * near * slope + s.waver * (1.0f - near) * wave;
    const float steep = std::max(length(slope), 0.2f), towards = -dot(slope, s.up) / steep;
    const float free = std::clamp(s.scratch.wall[at] - inside + 0.5f, 0.0f, 1.0f); // no line along walls
    const Vec2 middle{static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f};
    const Colours colours =
        colours_at(s.scratch, s.look, at, darkness_at(s.scratch, s.depths, apply(s.to_cell, middle)));
    map.planes[kAwayX][at] = away.x;
    map.planes[kAwayY][at] = away.y;
    const float large = 0.5f + 0.5f * std::min(s.scratch.bulk[at] * 4.0f, 1.0f); // drops are no mere dots of light
    const float clear = std::min(length_squared(slope), 1.0f); // nor where it goes on behind a solid, and is uncertain
    map.planes[kRim][at] = s.look.rim * large * free * clear * (0.45f + 0.55f * std::max(towards, -0.6f));
    for (std::size_t c = 0; c < 6; ++c) map.planes[kThroughRed + c][at] = colours.part[c];
}

void shade(LiquidMap& map, const Shading& s) {
    for (auto& plane : map.planes) plane.assign(s.grid.size(), 0.0f);
    for (int y = 0; y < s.grid.height; ++y)
        for (int x = 0; x < s.grid.width; ++x) {
            const std::size_t at = static_cast<std::size_t>(y) * s.grid.stride + static_cast<std::size_t>(x);
            const float inside = s.scratch.smooth[at];
            const float room = map.step * s.scratch.wall[at] + kUnder;
            map.planes[kDepth][at] = std::min(map.step * inside, room);
            if (inside > kNothing)
                shade_texel(map, s, static_cast<std::size_t>(x), static_cast<std::size_t>(y), at, inside);
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
    fill_solids(scratch, grid, std::fabs(up.y) >= std::fabs(up.x));
    find_surface(scratch, grid, set);
    const LiquidDepths depths = find_depths(scratch, sea, look.clarity, world, alpha);
    find_waves(scratch, grid, sea, view);

    const float per = 1.0f / depths.cell;
    const Affine to_cell = compose({per, 0, 0, per, -depths.low.x * per, -depths.low.y * per}, inverse(grid.to_texel));
    map.rim_width = std::max(kRimPoints * view.points, 0.6f * map.step);
    map.lit = look.lit;
    shade(map, {look, scratch, grid, depths, to_cell, up, look.refraction * kLens * view.points,
                look.refraction * look.waves * kWaver * view.points});
    map.width = grid.width;
    map.stride = grid.stride;
    return true;
}

} // namespace evil::draw
