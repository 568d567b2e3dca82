// Particles to the swarm, sorted by their cells, and back.
#include "fluid/water/scratch.hpp"
#include "world.hpp"
#include <algorithm>
#include <cmath>
#include <cstring>

namespace evil::fluid {
namespace {

constexpr float kSkin = 0.1f; // cells that particles keep from walls and bodies
constexpr std::size_t kSpare = 8;
constexpr float kMostDrift = 0.2f; // cells a step
constexpr float kLightest = 1e-3f; // of the heaviest: as air is beside water; beyond, no pressure could be found
constexpr float kDrift = 0.05f;    // s: how long a drop of one liquid falls in another until it has its speed

struct Limits { // of places, in cells
    float right, top;
};

Limits limits_of(const Grid& g) { return {static_cast<float>(g.nx) - kSkin, static_cast<float>(g.ny) - kSkin}; }

// What was written from outside may be anything: not-a-number becomes `low`.
float within(float value, float low, float high) { return value > low ? std::min(value, high) : low; }

bool is_near(const Water& water, float x, float y) {
    const Grid& g = water.grid;
    const int i = std::clamp(static_cast<int>(x), 0, g.nx - 1), j = std::clamp(static_cast<int>(y), 0, g.ny - 1);
    return water.scratch->near[static_cast<std::size_t>(j * (g.stride / 8) + i / 8)] != 0;
}

// Out of a body, along with which it then moves as far as that pushes it; `ahead`: seconds that the body goes on first.
void keep_out(const World& world, const Water& water, Vec2& place, Vec2& velocity, float ahead) {
    const Grid& g = water.grid;
    const Limits limits = limits_of(g);
    for (int turn = 0; turn < 2; ++turn) {
        if (!is_near(water, place.x, place.y)) return;
        Bank bank = bank_at(water, place.x, place.y);
        Vec2 speed;
        if (bank.body != kNone && moves(world.bodies.rows[bank.body])) {
            speed = velocity_at(world.bodies.rows[bank.body], g.low + g.h * place);
            if (ahead > 0.0f) { // where it is now, seen from the body as it will be
                const Vec2 seen = place - (ahead / g.h) * speed;
                const Limits all = limits;
                bank = bank_at(water, within(seen.x, kSkin, all.right), within(seen.y, kSkin, all.top));
            }
        }
        if (!(bank.distance < kSkin)) return;
        place += (kSkin - bank.distance) * bank.away;
        place = {within(place.x, kSkin, limits.right), within(place.y, kSkin, limits.top)};
        const float into = dot(velocity - speed, bank.away);
        if (into < 0.0f) velocity -= into * bank.away;
    }
}

void make_room(Swarm& swarm, std::size_t count) {
    if (swarm.x.size() >= count + kSpare) return;
    const std::size_t room = std::max(count + kSpare, 2 * swarm.x.size());
    for (auto* list : {&swarm.x, &swarm.y, &swarm.u, &swarm.v, &swarm.mass}) list->resize(room);
    for (auto& list : swarm.affine) list.resize(room);
    swarm.liquid.resize(room), swarm.cell.resize(room), swarm.place.resize(room);
}

void place_particles(const World& world, Water& water) {
    WaterScratch& s = *water.scratch;
    const Grid& g = water.grid;
    const Limits limits = limits_of(g);
    Particles& p = *water.particles;
    const float per_cell = 1.0f / g.h;
    const std::ptrdiff_t tiles = g.stride / 8;
    for (std::size_t k = 0; k < water.count; ++k) {
        Vec2 place{within(per_cell * (p.positions[2 * k] - g.low.x), kSkin, limits.right),
                   within(per_cell * (p.positions[2 * k + 1] - g.low.y), kSkin, limits.top)};
        if (is_near(water, place.x, place.y)) {
            Vec2 velocity = clamped(Vec2{p.velocities[2 * k], p.velocities[2 * k + 1]}, kMostSwim);
            keep_out(world, water, place, velocity, 0.0f);
            p.velocities[2 * k] = velocity.x, p.velocities[2 * k + 1] = velocity.y;
        }
        const std::ptrdiff_t at = g.at(static_cast<int>(place.x), static_cast<int>(place.y));
        s.swarm.place[k] = place;
        s.swarm.cell[k] = static_cast<std::int32_t>(at);
        ++s.first[static_cast<std::size_t>(at)];
        s.marked[static_cast<std::size_t>(at / 8 + tiles + 1)] = 2;
    }
}

// Visits the marks of tiles in order: eight that are none cost no more than one.
template <class Visit> void each_marked(std::vector<std::uint8_t>& marked, Visit visit) {
    for (std::size_t word = 0; word < marked.size(); word += 8) {
        std::uint64_t eight = 0;
        std::memcpy(&eight, &marked[word], 8);
        if (eight == 0) continue;
        for (std::size_t k = word; k < word + 8; ++k)
            if (marked[k]) visit(k);
    }
}

Tile tile_of(const Grid& g, std::size_t mark) {
    const std::ptrdiff_t tiles = g.stride / 8, number = static_cast<std::ptrdiff_t>(mark) - tiles - 1;
    const auto j = static_cast<std::int32_t>((number + tiles) / tiles - 1); // rounded down from -1 on
    return {static_cast<std::int32_t>(8 * (number - j * tiles)), j, 8 * number};
}

void find_tiles(WaterScratch& s, const Grid& g) {
    const std::size_t tiles = static_cast<std::size_t>(g.stride / 8);
    s.active.swap(s.active_before);
    s.occupied.clear(), s.active.clear();
    each_marked(s.marked, [&](std::size_t k) {
        if (s.marked[k] == 2) s.occupied.push_back(tile_of(g, k));
        for (std::size_t row : {k - tiles, k, k + tiles})
            for (std::size_t at : {row - 1, row, row + 1})
                if (s.marked[k] == 2 && !s.marked[at]) s.marked[at] = 1;
    });
    each_marked(s.marked, [&](std::size_t k) {
        s.active.push_back(tile_of(g, k));
        s.marked[k] = 0;
    });
}

} // namespace

void take_in(const World& world, Water& water) {
    WaterScratch& s = *water.scratch;
    const Grid& g = water.grid;
    const Particles& p = *water.particles;
    Swarm& swarm = s.swarm;
    for (const Tile& tile : s.occupied) std::fill_n(&s.first[static_cast<std::size_t>(tile.at)], 8, 0u);
    make_room(swarm, water.count);
    place_particles(world, water);
    find_tiles(s, g);
    std::uint32_t sum = 0;
    for (const Tile& tile : s.occupied)
        for (std::size_t at = static_cast<std::size_t>(tile.at); at < static_cast<std::size_t>(tile.at) + 8; ++at) {
            const std::uint32_t here = s.first[at];
            s.first[at] = sum;
            sum += here;
        }
    const float heavy = heaviest(water);
    std::array<float, kMostLiquids> mass{};
    for (std::size_t k = 0; k < water.liquids.size(); ++k)
        mass[k] = std::max(water.liquids[k].density / heavy, kLightest);
    const std::size_t last_liquid = water.liquids.size() - 1;
    float fastest = 0.0f;
    for (std::size_t k = 0; k < water.count; ++k) {
        const std::size_t to = s.first[static_cast<std::size_t>(swarm.cell[k])]++;
        swarm.x[to] = swarm.place[k].x, swarm.y[to] = swarm.place[k].y;
        swarm.u[to] = clamped(p.velocities[2 * k], kMostSwim),
        swarm.v[to] = clamped(p.velocities[2 * k + 1], kMostSwim);
        fastest = std::max({fastest, std::abs(swarm.u[to]), std::abs(swarm.v[to])});
        for (std::size_t d = 0; d < 4; ++d) swarm.affine[d][to] = clamped(g.h * p.affine[4 * k + d], kMostSwim);
        const std::size_t liquid = std::min<std::size_t>(p.liquid[k], last_liquid);
        swarm.liquid[to] = static_cast<std::uint8_t>(liquid);
        swarm.mass[to] = mass[liquid];
    }
    swarm.count = water.count, swarm.fastest = fastest;
    for (std::size_t k = swarm.count; k < swarm.count + kSpare; ++k) swarm.x[k] = swarm.y[k] = 1.0f;
}

namespace {

// Within a cell all liquids move alike: what is heavier than its cell sinks through what is lighter, in cells.
Vec2 drift_of(const Water& water, Vec2 gravity, float mass, Vec2 place, float dt) {
    const WaterScratch& s = *water.scratch;
    const std::ptrdiff_t at = water.grid.at(static_cast<int>(place.x), static_cast<int>(place.y));
    if (s.wet[at] == 0.0f) return {};
    const float heavier = mass / s.mass[at] - 1.0f;
    return clamped((dt * kDrift * heavier / water.grid.h) * gravity, kMostDrift);
}

} // namespace

void give_out(const World& world, Water& water, float dt) {
    const Grid& g = water.grid;
    const Limits limits = limits_of(g);
    const Swarm& swarm = water.scratch->swarm;
    const float right = static_cast<float>(g.nx), top = static_cast<float>(g.ny), per_cell = 1.0f / g.h;
    Particles& p = *water.particles;
    const bool mixed = water.liquids.size() > 1;
    std::size_t to = 0;
    for (std::size_t k = 0; k < swarm.count; ++k) {
        Vec2 place{swarm.x[k], swarm.y[k]}, velocity{swarm.u[k], swarm.v[k]};
        if ((water.open[kLeft] && place.x < 0.0f) || (water.open[kRight] && place.x > right) ||
            (water.open[kBottom] && place.y < 0.0f) || (water.open[kTop] && place.y > top))
            continue;
        place = {within(place.x, kSkin, limits.right), within(place.y, kSkin, limits.top)};
        if (mixed) place += drift_of(water, world.gravity, swarm.mass[k], place, dt);
        if (mixed) place = {within(place.x, kSkin, limits.right), within(place.y, kSkin, limits.top)};
        if (is_near(water, place.x, place.y)) keep_out(world, water, place, velocity, dt);
        p.positions[2 * to] = g.low.x + g.h * place.x, p.positions[2 * to + 1] = g.low.y + g.h * place.y;
        p.velocities[2 * to] = clamped(velocity.x, kMostSwim),
                         p.velocities[2 * to + 1] = clamped(velocity.y, kMostSwim);
        for (std::size_t d = 0; d < 4; ++d)
            p.affine[4 * to + d] = clamped(per_cell * swarm.affine[d][k], kMostSwim / g.h);
        p.liquid[to++] = swarm.liquid[k];
    }
    water.count = to;
}

} // namespace evil::fluid
