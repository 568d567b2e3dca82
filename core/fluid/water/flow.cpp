// From particles to cells and faces, the pressure there, and back.
#include "fluid/water/scratch.hpp"
#include "world.hpp"
#include <algorithm>

namespace evil::fluid {
namespace {

constexpr float kTolerance = 1e-3f;      // of the divergence, that pressure leaves
constexpr float kSpreadTolerance = 0.1f; // of the crowding
constexpr float kMostShift = 1.0f;       // cells
constexpr float kSpreadShare = 0.2f;     // of the crowding that one step takes away
constexpr int kMostRounds = 36, kMostSpreadRounds = 6;

SwarmView view_of(Swarm& swarm) {
    return {swarm.count,
            swarm.x.data(),
            swarm.y.data(),
            swarm.u.data(),
            swarm.v.data(),
            {swarm.affine[0].data(), swarm.affine[1].data(), swarm.affine[2].data(), swarm.affine[3].data()},
            swarm.mass.data()};
}

// Active tiles but for those below the box, which come first, and above it, which come last: beyond them there is nothing.
std::span<const Tile> inner_tiles(const Water& water) {
    const std::vector<Tile>& active = water.scratch->active;
    std::size_t first = 0, last = active.size();
    while (first < last && active[first].j < 0) ++first;
    while (last > first && active[last - 1].j > water.grid.ny) --last;
    return std::span(active).subspan(first, last - first);
}

// What fell beyond the edge of the box belongs to the cells along it: they slip.
void fold_rim(WaterScratch& s, const Grid& g) {
    float *u = s.gathered_u.data(), *v = s.gathered_v.data();
    auto move = [](float* pairs, std::ptrdiff_t from, std::ptrdiff_t to) {
        pairs[2 * to] += pairs[2 * from], pairs[2 * to + 1] += pairs[2 * from + 1];
    };
    for (const Tile& tile : s.active) {
        if (tile.j == -1 || tile.j == g.ny)
            for (std::ptrdiff_t k = tile.at; k < tile.at + 8; ++k) move(u, k, tile.j < 0 ? k + g.stride : k - g.stride);
        if (tile.j < 0 || tile.j > g.ny) continue;
        if (tile.i == 0) move(v, tile.at - 1, tile.at);
        if (tile.i == g.nx / 8 * 8) move(v, g.at(g.nx, tile.j), g.at(g.nx - 1, tile.j));
    }
}

void mirror_rim(WaterScratch& s, const Grid& g, Field& u, Field& v) {
    for (const Tile& tile : s.active) {
        if (tile.j == -1 || tile.j == g.ny) {
            const float* from = u.data() + (tile.j < 0 ? tile.at + g.stride : tile.at - g.stride);
            std::copy_n(from, 8, u.data() + tile.at);
        }
        if (tile.j < 0 || tile.j > g.ny) continue;
        if (tile.i == 0) v[tile.at - 1] = v[tile.at];
        if (tile.i == g.nx / 8 * 8) v[g.at(g.nx, tile.j)] = v[g.at(g.nx - 1, tile.j)];
    }
}

// Nothing goes through the closed sides of the box.
void close_sides(const Water& water, Field& u, Field& v) {
    const Grid& g = water.grid;
    for (const Tile& tile : water.scratch->active) {
        if (tile.j < 0 || tile.j > g.ny) continue;
        if (tile.i == 0 && !water.open[kLeft]) u[tile.at] = 0.0f;
        if (tile.i == g.nx / 8 * 8 && !water.open[kRight]) u[g.at(g.nx, tile.j)] = 0.0f;
        if ((tile.j == 0 && !water.open[kBottom]) || (tile.j == g.ny && !water.open[kTop]))
            std::fill_n(v.data() + tile.at, 8, 0.0f);
    }
}

template <class Visit> void each_shut_face(const Water& water, const Field& open, int wide, int high, Visit visit) {
    const WaterScratch& s = *water.scratch;
    for (const Tile& tile : s.active) {
        if (tile.j < 0 || tile.j >= high || !s.near[static_cast<std::size_t>(tile.at / 8)]) continue;
        for (int i = tile.i; i < std::min(tile.i + 8, wide); ++i)
            if (open[tile.at + (i - tile.i)] == 0.0f) visit(i, tile.j, tile.at + (i - tile.i));
    }
}

// Faces inside a body have the velocity of the flow beside them, but for what would go into the body.
void slide_along(const World& world, Water& water, Field& flow, const Field& open, bool sideways) {
    const WaterScratch& s = *water.scratch;
    const Grid& g = water.grid;
    const std::ptrdiff_t beside = sideways ? 1 : g.stride, along = sideways ? g.stride : 1;
    const int wide = sideways ? g.nx + 1 : g.nx, high = sideways ? g.ny : g.ny + 1;
    each_shut_face(water, open, wide, high, [&](int i, int j, std::ptrdiff_t at) {
        if (sideways ? i == 0 || i == g.nx : j == 0 || j == g.ny) return;
        float sum = 0.0f, count = 0.0f;
        for (std::ptrdiff_t other : {at - along, at + along, at - beside, at + beside})
            if (open[other] > 0.0f && (s.wet[other] > 0.0f || s.wet[other - beside] > 0.0f))
                sum += flow[other], count += 1.0f;
        const Vec2 middle{static_cast<float>(i) + (sideways ? 0.0f : 0.5f),
                          static_cast<float>(j) + (sideways ? 0.5f : 0.0f)};
        const Bank bank = bank_at(water, middle.x, middle.y);
        Vec2 body;
        if (bank.body != kNone && moves(world.bodies.rows[bank.body]))
            body = velocity_at(world.bodies.rows[bank.body], g.low + g.h * middle);
        const float own = sideways ? body.x : body.y, out = sideways ? bank.away.x : bank.away.y;
        const float slip = (count > 0.0f ? sum / count : flow[at]) - own;
        flow[at] = own + slip * (1.0f - out * out);
    });
}

} // namespace

CellsView WaterScratch::view(const Water& water) {
    PressLevel& level = press.finest();
    return {water.grid.stride,   solids.across().data(),
            solids.up().data(),  per_room.data(),
            rho.data(),          wet.data(),
            mass.data(),         skin.data(),
            level.left.data(),   level.right.data(),
            level.below.data(),  level.above.data(),
            level.drain.data(),  level.total.data(),
            level.inverse.data()};
}

void gather_flow(const World& world, Water& water, float dt) {
    WaterScratch& s = *water.scratch;
    const Grid& g = water.grid;
    for (Pairs* pairs : {&s.gathered_u, &s.gathered_v, &s.gathered})
        for (const Tile& tile : s.active) std::fill_n(pairs->data() + 2 * tile.at, 16, 0.0f);
    EVIL_PICK(world.instruction_set, splat_particles)
    (view_of(s.swarm), g.stride, s.gathered_u.data(), s.gathered_v.data(), s.gathered.data());
    fold_rim(s, g);
    const float right = dt * world.gravity.x, up = dt * world.gravity.y;
    for (const Tile& tile : s.active)
        for (std::ptrdiff_t k = tile.at; k < tile.at + 8; ++k) {
            const float *u = s.gathered_u.data() + 2 * k, *v = s.gathered_v.data() + 2 * k;
            s.u[k] = u[1] > 0.0f ? u[0] / u[1] + right : 0.0f;
            s.v[k] = v[1] > 0.0f ? v[0] / v[1] + up : 0.0f;
            s.shift_u[k] = s.shift_v[k] = 0.0f;
        }
    close_sides(water, s.u, s.v);
}

void find_liquid(const World& world, Water& water) {
    WaterScratch& s = *water.scratch;
    const CellsView cells = s.view(water);
    const InstructionSet set = world.instruction_set;
    for (Field* field : {&s.rho, &s.wet})
        for (const Tile& tile : s.active_before) std::fill_n(field->data() + tile.at, 8, 0.0f);
    const std::span<const Tile> inner = inner_tiles(water);
    s.any_wet.resize(inner.size());
    EVIL_PICK(set, measure_cells)(cells, s.active.data(), s.active.size(), s.gathered.data());
    EVIL_PICK(set, find_wet)(cells, inner.data(), inner.size(), s.any_wet.data());
    find_gaps(world, water);
    s.wet_tiles.clear();
    s.press.begin();
    for (std::size_t k = 0; k < inner.size(); ++k)
        if (s.any_wet[k]) s.wet_tiles.push_back(inner[k]), s.press.add_tile(inner[k]);
    EVIL_PICK(set, weigh_cells)(cells, s.wet_tiles.data(), s.wet_tiles.size());
    s.press.finish(set);
    for (const auto& tiles : {std::span(s.active_before), std::span(s.active)})
        for (const Tile& tile : tiles)
            for (std::ptrdiff_t k = tile.at; k < tile.at + 8; ++k)
                if (s.wet[k] == 0.0f) water.pressure[k] = s.spread[k] = 0.0f;
}

void press_flow(World& world, Water& water, float dt) {
    WaterScratch& s = *water.scratch;
    const CellsView cells = s.view(water);
    const InstructionSet set = world.instruction_set;
    const std::span<const Tile> wet = s.wet_tiles, active = inner_tiles(water);
    stretch_skin(water, dt);
    thicken(world, water, dt);
    still_films(water);
    EVIL_PICK(set, find_inflow_of)(cells, wet.data(), wet.size(), s.u.data(), s.v.data(), s.inflow.data());
    find_riders(world, water, dt);
    s.rounds = s.press.solve(s.inflow, water.pressure, {s.riders, s.reaches}, kTolerance, kMostRounds, set);
    EVIL_PICK(set, flow_by_pressure)(cells, active.data(), active.size(), water.pressure.data(),
                                     most_flow(world, water, dt), s.u.data(), s.v.data());
    EVIL_PICK(set, extend_flow)(cells, active.data(), active.size(), s.u.data(), s.v.data());
    push_riders(world, water, dt);
    drop_skin(water);
    slide_along(world, water, s.u, s.solids.across(), true);
    slide_along(world, water, s.v, s.solids.up(), false);
    close_sides(water, s.u, s.v);
    mirror_rim(s, water.grid, s.u, s.v);

    EVIL_PICK(set, find_crowds)(cells, wet.data(), wet.size(), kSpreadShare, s.inflow.data());
    for (const Tile& tile : wet) std::fill_n(s.spread.data() + tile.at, 8, 0.0f);
    s.spread_rounds = s.press.solve(s.inflow, s.spread, {}, kSpreadTolerance, kMostSpreadRounds, set);
    EVIL_PICK(set, flow_by_pressure)(cells, active.data(), active.size(), s.spread.data(), kMostShift, s.shift_u.data(),
                                     s.shift_v.data());
    close_sides(water, s.shift_u, s.shift_v);
    mirror_rim(s, water.grid, s.shift_u, s.shift_v);
}

void scatter_flow(const World& world, Water& water, float dt) {
    WaterScratch& s = *water.scratch;
    EVIL_PICK(world.instruction_set, carry_particles)
    (view_of(s.swarm), water.grid.stride, s.u.data(), s.v.data(), s.shift_u.data(), s.shift_v.data(),
     dt / water.grid.h);
}

} // namespace evil::fluid
