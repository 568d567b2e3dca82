#include "particles/foam.hpp"
#include "archive.hpp"
#include "draw/layers.hpp"
#include <algorithm>
#include <cmath>

namespace evil::particles {
namespace {

constexpr float kFull = 4.0f;                // particles of a cell that is full
constexpr std::size_t kMostCells = 1u << 18; // beyond that cells become larger
constexpr float kTallFall = 12.0f;           // spacings: who fell so far is fast
constexpr float kFromTrapped = 45.0f;        // flecks a second of a particle that is fast and traps much air
constexpr float kFromCrest = 24.0f;          // of one that stands up as a crest
constexpr float kDry = 0.22f, kWet = 0.8f;   // share of full cells round a fleck that flies, and of one that rises
constexpr float kFarthest = 1e9f;            // metres

// SplitMix64, as emitters have it.
float chance(std::uint64_t& state) {
    std::uint64_t z = state += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return static_cast<float>((z ^ (z >> 31)) >> 40) * 0x1p-24f;
}

float share(float value, float from, float to) { return std::clamp((value - from) / (to - from), 0.0f, 1.0f); }

struct Grid { // of cells round all liquid, with a rim of empty ones
    Vec2 low;
    float cell = 1.0f;
    int width = 0, height = 0;
    float per_count = 1.0f; // share of a full cell that a particle is

    std::size_t at(int x, int y) const { return static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x); }
    // The cell of a place, one that has neighbours all round.
    bool find(Vec2 place, int& x, int& y) const {
        const Vec2 in = (1.0f / cell) * (place - low);
        if (!(in.x >= 1.0f && in.y >= 1.0f && in.x < static_cast<float>(width - 1) &&
              in.y < static_cast<float>(height - 1)))
            return false;
        x = static_cast<int>(in.x), y = static_cast<int>(in.y);
        return true;
    }
};

Grid fill_cells(Foam& foam, const Waters& waters) {
    Grid grid;
    Vec2 low{kFarthest, kFarthest}, high{-kFarthest, -kFarthest};
    for (const Vec2 at : waters.at)
        if (std::fabs(at.x) < kFarthest && std::fabs(at.y) < kFarthest) low = min(low, at), high = max(high, at);
    if (low.x > high.x) return grid;
    grid.cell = 2.0f * waters.spacing;
    const auto count = [&](float size) { return std::min(size / grid.cell, 1e6f) + 4.0f; };
    while (count(high.x - low.x) * count(high.y - low.y) > static_cast<float>(kMostCells)) grid.cell *= 2.0f;
    grid.low = {grid.cell * (std::floor(low.x / grid.cell) - 1.0f), grid.cell * (std::floor(low.y / grid.cell) - 1.0f)};
    grid.width = static_cast<int>((high.x - grid.low.x) / grid.cell) + 2;
    grid.height = static_cast<int>((high.y - grid.low.y) / grid.cell) + 2;
    grid.per_count = 4.0f * waters.spacing * waters.spacing / (kFull * grid.cell * grid.cell);
    foam.cells.assign(static_cast<std::size_t>(grid.width) * grid.height, {});
    for (std::size_t i = 0; i < waters.at.size(); ++i) {
        int x, y;
        if (!grid.find(waters.at[i], x, y)) continue;
        FoamCell& cell = foam.cells[grid.at(x, y)];
        cell.count += 1.0f, cell.velocity = cell.velocity + waters.velocity[i];
    }
    for (FoamCell& cell : foam.cells)
        if (cell.count > 0.0f) cell.velocity = (1.0f / cell.count) * cell.velocity, cell.count *= grid.per_count;
    return grid;
}

struct Round {        // what is round a place
    float wet = 0.0f; // share of full
    Vec2 flow;        // mean velocity
};

Round look_round(const Foam& foam, const Grid& grid, Vec2 place) {
    int x, y;
    if (!grid.find(place, x, y)) return {};
    const Vec2 in = (1.0f / grid.cell) * (place - grid.low) - Vec2{0.5f, 0.5f};
    const int left = static_cast<int>(in.x), bottom = static_cast<int>(in.y);
    const float fx = in.x - static_cast<float>(left), fy = in.y - static_cast<float>(bottom);
    Round round;
    for (int k = 0; k < 4; ++k) {
        const FoamCell& cell = foam.cells[grid.at(left + (k & 1), bottom + (k >> 1))];
        const float part = (k & 1 ? fx : 1.0f - fx) * (k >> 1 ? fy : 1.0f - fy) * cell.count;
        round.wet += part, round.flow = round.flow + part * cell.velocity;
    }
    if (round.wet > 0.0f) round.flow = (1.0f / round.wet) * round.flow;
    return round;
}

bool is_walled(const Grid& grid, const Waters& waters, int x, int y) { // is the middle of a cell beyond a wall?
    const Vec2 at = grid.low + grid.cell * Vec2{static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f};
    return (waters.closed[0] && at.x < waters.low.x) || (waters.closed[1] && at.x > waters.high.x) ||
           (waters.closed[2] && at.y < waters.low.y) || (waters.closed[3] && at.y > waters.high.y);
}

// How many flecks a second a particle throws up. Speeds are told by what falls here.
float births(const Foam& foam, const Grid& grid, const Waters& waters, std::size_t i, float fast) {
    const Vec2 at = waters.at[i], velocity = waters.velocity[i];
    const float energy = share(length_squared(velocity), 0.1f * fast * fast, 1.2f * fast * fast);
    int x, y;
    if (energy == 0.0f || !grid.find(at, x, y)) return 0.0f;
    float trapped = 0.0f, wet = 0.0f;
    Vec2 normal{}; // out of the liquid
    for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
            const FoamCell& cell = foam.cells[grid.at(x + dx, y + dy)];
            const Vec2 side{static_cast<float>(dx), static_cast<float>(dy)};
            const float full = is_walled(grid, waters, x + dx, y + dy) ? 1.0f : cell.count;
            wet += full, normal = normal - full * side;
            if (cell.count == 0.0f || (dx == 0 && dy == 0)) continue;
            const Vec2 apart = velocity - cell.velocity; // how much of it is towards that cell
            const float speed = length(apart);
            trapped += std::min(cell.count, 1.0f) * (speed + dot(apart, side) / length(side));
        }
    trapped *= share(wet, 8.6f, 7.0f); // where there is air
    const float crest = share(wet, 5.5f, 2.0f) * share(dot(normalised(normal), normalised(velocity)), 0.5f, 0.9f);
    return energy *
           (kFromTrapped * share(trapped, 1.2f * fast, 6.0f * fast) + kFromCrest * crest * share(wet, 0.7f, 1.5f));
}

// Those from `first` on came all the way from `foam.from` in this step: what they met stops them.
void stop_at_bodies(Foam& foam, std::size_t first, const World& world) {
    constexpr float kSkin = 1e-3f; // metres off what they met
    if (first == foam.flecks.size()) return;
    Bounds bounds{foam.from[first], foam.from[first]};
    for (std::size_t i = first; i < foam.flecks.size(); ++i)
        bounds = {min(bounds.low, min(foam.from[i], foam.flecks[i].at)),
                  max(bounds.high, max(foam.from[i], foam.flecks[i].at))};
    gather(foam.obstacles, world, bounds, ~0u);
    if (foam.obstacles.rows.empty()) return;
    for (std::size_t i = first; i < foam.flecks.size(); ++i) {
        Fleck& fleck = foam.flecks[i];
        const auto touch = first_touch(foam.obstacles, world, foam.from[i], fleck.at);
        if (!touch) continue;
        const Vec2 off = touch->point + kSkin * touch->normal;
        fleck.at = first_touch(foam.obstacles, world, foam.from[i], off) ? foam.from[i] : off; // a corner holds it
        const float into = dot(fleck.velocity - touch->velocity, touch->normal);
        if (into < 0.0f) fleck.velocity -= into * touch->normal;
    }
}

void bear(Foam& foam, const Grid& grid, const Waters& waters, const World& world, float fast, float amount, float dt) {
    if (grid.width == 0) return;
    const std::size_t old = foam.flecks.size();
    foam.from.resize(old);
    for (std::size_t i = 0; i < waters.at.size(); ++i) {
        float due = amount * dt * births(foam, grid, waters, i, fast);
        if (due == 0.0f) continue;
        for (due += chance(foam.random); due >= 1.0f && foam.flecks.size() < kMostFlecks; due -= 1.0f) {
            const Vec2 off{2.0f * chance(foam.random) - 1.0f, 2.0f * chance(foam.random) - 1.0f};
            const Vec2 kick{2.0f * chance(foam.random) - 1.0f, 2.0f * chance(foam.random) - 1.0f};
            Fleck fleck;
            fleck.at = waters.at[i] + 0.8f * waters.spacing * off;
            fleck.velocity = waters.velocity[i] + 0.15f * fast * kick;
            const float size = chance(foam.random);
            fleck.size = size * size;
            fleck.life = fleck.whole = 0.7f + 2.2f * fleck.size + 1.2f * chance(foam.random);
            foam.flecks.push_back(fleck);
            foam.from.push_back(waters.at[i]);
        }
    }
    stop_at_bodies(foam, old, world);
}

bool is_inside(Vec2 at, const Waters& w) {
    return (w.closed[0] || at.x >= w.low.x) && (w.closed[1] || at.x <= w.high.x) && (w.closed[2] || at.y >= w.low.y) &&
           (w.closed[3] || at.y <= w.high.y);
}

// So do the walls of the water.
void keep_inside(Fleck& fleck, const Waters& w) {
    if (w.closed[0] && fleck.at.x < w.low.x) fleck.at.x = w.low.x, fleck.velocity.x = std::max(fleck.velocity.x, 0.0f);
    if (w.closed[1] && fleck.at.x > w.high.x)
        fleck.at.x = w.high.x, fleck.velocity.x = std::min(fleck.velocity.x, 0.0f);
    if (w.closed[2] && fleck.at.y < w.low.y) fleck.at.y = w.low.y, fleck.velocity.y = std::max(fleck.velocity.y, 0.0f);
    if (w.closed[3] && fleck.at.y > w.high.y)
        fleck.at.y = w.high.y, fleck.velocity.y = std::min(fleck.velocity.y, 0.0f);
}

void move(Foam& foam, const Grid& grid, const Waters& waters, const World& world, float dt) {
    constexpr float kRise = 0.6f, kDrag = 12.0f, kAir = 0.4f; // of gravity; a second
    foam.from.clear();
    for (Fleck& fleck : foam.flecks) {
        foam.from.push_back(fleck.at);
        const Round round = look_round(foam, grid, fleck.at);
        fleck.wet = std::min(round.wet, 1.0f);
        if (round.wet < kDry) {
            fleck.velocity = (1.0f - kAir * dt) * fleck.velocity + dt * waters.gravity;
            fleck.life -= 0.35f * dt;
        } else if (round.wet < kWet) {
            fleck.velocity = round.flow;
            fleck.life -= dt;
        } else {
            const float take = std::min(kDrag * dt, 1.0f);
            fleck.velocity = fleck.velocity + take * (round.flow - fleck.velocity) - kRise * dt * waters.gravity;
            fleck.life -= 0.25f * dt;
        }
        fleck.at = fleck.at + dt * fleck.velocity;
        keep_inside(fleck, waters);
    }
    stop_at_bodies(foam, 0, world);
    std::erase_if(foam.flecks, [&](const Fleck& fleck) {
        const bool here = std::fabs(fleck.at.x) < kFarthest && std::fabs(fleck.at.y) < kFarthest;
        return !(fleck.life > 0.0f && here && is_inside(fleck.at, waters));
    });
}

} // namespace

void step(Foam& foam, const Waters& waters, const World& world, float amount, float dt) {
    if (foam.flecks.empty() && (amount == 0.0f || waters.at.empty())) return;
    const float fall = std::max(length(waters.gravity), 1.0f),
                fast = std::sqrt(2.0f * fall * kTallFall * waters.spacing);
    const Grid grid = fill_cells(foam, waters);
    move(foam, grid, waters, world, dt);
    bear(foam, grid, waters, world, fast, amount, dt);
}

void collect(const Foam& foam, const FoamView& view, std::int32_t layer, draw::DrawList& out) {
    if (foam.flecks.empty()) return;
    draw::Interlude run;
    run.before = draw::end_of_layer(out, layer);
    run.first = static_cast<std::uint32_t>(out.interludes.specks.size());
    run.form = draw::SpeckForm::disc, run.lit = view.lit;
    const float scale = std::sqrt(std::fabs(determinant(view.to_pixel)));
    for (const Fleck& fleck : foam.flecks) {
        const Vec2 at = apply(view.to_pixel, fleck.at - view.back * fleck.velocity);
        if (!(at.x > -64.0f && at.y > -64.0f && at.x < view.screen.x + 64.0f && at.y < view.screen.y + 64.0f)) continue;
        const float young = std::min(fleck.life / (0.6f * fleck.whole), 1.0f),
                    dry = 1.0f - share(fleck.wet, kDry, kWet);
        const float width = (0.14f + 0.3f * fleck.size) * view.spacing * scale * (0.6f + 0.4f * young);
        const float half = std::max(width, 0.55f * view.points);
        const float seen = std::min(width / half, 1.0f); // what is smaller than a point is fainter instead
        const Vec2 way = apply_linear(view.to_pixel, (0.5f / 60.0f) * fleck.velocity); // smeared by half a frame's way
        const float long_way = length(way), along = half + 0.7f * dry * std::min(long_way, 6.0f * half);
        draw::Speck speck;
        speck.at = at;
        speck.along = long_way > 1e-3f ? (along / long_way) * way : Vec2{half, 0.0f};
        speck.across = half;
        const float solid = (0.35f + 0.4f * dry) * young * seen;
        const auto alpha = static_cast<std::uint32_t>(static_cast<float>(view.tint >> 24) * solid + 0.5f);
        speck.colour = (view.tint & 0x00ffffffu) | alpha << 24;
        out.interludes.specks.push_back(speck);
    }
    run.count = static_cast<std::uint32_t>(out.interludes.specks.size()) - run.first;
    if (run.count > 0) out.interludes.rows.push_back(run);
}

std::vector<std::uint8_t> snapshot(const Foam& foam) {
    BytesWriter ar;
    ar.value(foam.random);
    ar.count(foam.flecks.size());
    for (const Fleck& fleck : foam.flecks) {
        const float numbers[8] = {fleck.at.x, fleck.at.y,  fleck.velocity.x, fleck.velocity.y,
                                  fleck.life, fleck.whole, fleck.size,       fleck.wet};
        for (const float number : numbers) ar.value(number);
    }
    return ar.take();
}

bool restore(Foam& foam, std::span<const std::uint8_t> bytes) {
    Reader ar(bytes);
    Foam read;
    ar.value(read.random);
    const std::size_t count = ar.count(0, 8 * sizeof(float));
    if (!ar.ok || count > kMostFlecks) return false;
    read.flecks.resize(count);
    for (Fleck& fleck : read.flecks) {
        float numbers[8];
        for (float& number : numbers) {
            ar.value(number);
            ar.ok &= std::fabs(number) <= kFarthest;
        }
        fleck = {{numbers[0], numbers[1]}, {numbers[2], numbers[3]}, numbers[4], numbers[5], numbers[6], numbers[7]};
        ar.ok &= fleck.whole > 0.0f;
    }
    if (!ar.ok || !ar.at_end()) return false;
    foam = std::move(read);
    return true;
}

} // namespace evil::particles
