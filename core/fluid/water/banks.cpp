// Where water may not be: the bodies' shapes, by their distances at the corners of cells.
#include "fluid/water/scratch.hpp"
#include "world.hpp"
#include <algorithm>
#include <cmath>

namespace evil::fluid {
namespace {

constexpr float kNearBody = 1.5f; // cells
constexpr float kPerCell = kCellsOfParticle * kCellsOfParticle;

// The share of a cell that is outside of bodies: as if their surface were straight and along an axis.
float volume_of(const Field& distance, std::ptrdiff_t at, int stride) {
    const float corners = (distance[at] + distance[at + 1]) + (distance[at + stride] + distance[at + stride + 1]);
    return std::clamp(0.5f + 0.25f * corners, 0.0f, 1.0f);
}

void measure_patch(Water& water, const Patch& nodes) {
    WaterScratch& s = *water.scratch;
    const Grid& g = water.grid;
    const Field& distance = s.solids.distance();
    const int left = std::max(nodes.left - 1, 0), low = std::max(nodes.low - 1, 0);
    const int right = std::min(nodes.right, g.nx), high = std::min(nodes.high, g.ny);
    for (int j = low; j < high; ++j)
        for (int i = left; i < right; ++i) s.volume[g.at(i, j)] = volume_of(distance, g.at(i, j), g.stride);
    // what particles in a cell's own and the next ones add to it: a hat over three cells
    for (int j = std::max(low - 1, 0); j < std::min(high + 1, g.ny); ++j)
        for (int i = std::max(left - 1, 0); i < std::min(right + 1, g.nx); ++i) {
            const std::ptrdiff_t at = g.at(i, j);
            auto row = [&](std::ptrdiff_t middle) {
                return 0.75f * s.volume[middle] + 0.125f * (s.volume[middle - 1] + s.volume[middle + 1]);
            };
            const float room = 0.75f * row(at) + 0.125f * (row(at - g.stride) + row(at + g.stride));
            s.per_room[at] = s.solids.is_open(at, g.stride) ? 1.0f / (kPerCell * std::max(room, 0.1f)) : 0.0f;
        }
    const std::ptrdiff_t tiles = g.stride / 8;
    for (int j = low; j < high; ++j)
        for (int tile = left / 8; tile <= std::max(right - 1, left) / 8; ++tile) {
            bool near = false;
            for (int i = 8 * tile; i <= std::min(8 * tile + 8, g.nx); ++i)
                near = near || std::min(distance[g.at(i, j)], distance[g.at(i, j + 1)]) < kNearBody;
            s.near[static_cast<std::size_t>(j * tiles + tile)] = near;
        }
}

// Outside the box there is as much room as its open sides give.
void open_rim(Water& water) {
    const Grid& g = water.grid;
    Field& volume = water.scratch->volume;
    auto room = [&](Side side) { return water.open[side] ? 1.0f : 0.0f; };
    for (int j = 0; j < g.ny; ++j) volume[g.at(-1, j)] = room(kLeft), volume[g.at(g.nx, j)] = room(kRight);
    for (int i = 0; i < g.nx; ++i) volume[g.at(i, -1)] = room(kBottom), volume[g.at(i, g.ny)] = room(kTop);
}

} // namespace

void lay_out(Water& water) {
    WaterScratch& s = *water.scratch;
    if (s.laid_out) return;
    s.laid_out = true;
    const Grid& g = water.grid;
    s.solids.lay_out(g, water.open, false);
    s.press.lay_out(g);
    for (Field* field : {&s.volume, &s.per_room, &s.u, &s.v, &s.shift_u, &s.shift_v, &s.rho, &s.wet, &s.mass, &s.skin,
                         &s.inflow, &s.spread})
        field->lay_out(g);
    for (Pairs* pairs : {&s.gathered_u, &s.gathered_v, &s.gathered}) pairs->lay_out(g);
    const auto tiles = static_cast<std::size_t>(g.stride / 8);
    s.near.assign(tiles * static_cast<std::size_t>(g.ny + 1), 0);
    s.live.assign(s.near.size(), 0);
    s.met.assign(8 * s.near.size(), 0);
    s.marked.assign((tiles * static_cast<std::size_t>(g.ny + 3) + 2 + 7) / 8 * 8, 0);
    s.first.assign(static_cast<std::size_t>(g.stride * (g.ny + 1)), 0);
    for (int j = 0; j < g.ny; ++j) // where there was liquid, pressure is to be cleared once it left
        for (int i = 0; i < g.nx; i += 8) {
            const float* eight = water.pressure.data() + g.at(i, j);
            if (std::any_of(eight, eight + 8, [](float p) { return p != 0.0f; }))
                s.active.push_back({i, j, g.at(i, j)});
        }
    open_rim(water);
}

void update_banks(const World& world, Water& water) {
    lay_out(water);
    for (const Patch& patch : water.scratch->solids.redraw(world, water.grid, world.instruction_set))
        measure_patch(water, patch);
}

Bank bank_at(const Water& water, float x, float y) {
    const Grid& g = water.grid;
    const int i = std::clamp(static_cast<int>(x), 0, g.nx - 1), j = std::clamp(static_cast<int>(y), 0, g.ny - 1);
    const float s = x - static_cast<float>(i), t = y - static_cast<float>(j);
    const Field& d = water.scratch->solids.distance();
    const Field& owner = water.scratch->solids.owner();
    const std::ptrdiff_t low = g.at(i, j), high = g.at(i, j + 1);
    const float below = d[low + 1] - d[low], above = d[high + 1] - d[high];
    const float left = d[high] - d[low], right = d[high + 1] - d[low + 1];
    const Vec2 slope{below + t * (above - below), left + s * (right - left)};
    std::ptrdiff_t nearest = low;
    for (std::ptrdiff_t at : {low + 1, high, high + 1})
        if (d[at] < d[nearest]) nearest = at;
    const std::uint32_t body = owner[nearest] > 0.0f ? static_cast<std::uint32_t>(owner[nearest]) - 1 : kNone;
    return {d[low] + s * below + t * slope.y, normalised(slope), body};
}

Vec2 surface_near(const Water& water, int i, int j, std::uint32_t body) {
    const Bank bank = bank_at(water, static_cast<float>(i) + 0.5f, static_cast<float>(j) + 0.5f);
    return bank.body == body ? -std::clamp(bank.distance, -1.0f, 1.0f) * bank.away : Vec2{};
}

} // namespace evil::fluid
