// One step of each smoke, in the order of their slots.
#include "fluid/flow.hpp"
#include "fluid/sources.hpp"
#include "fluid/water/water.hpp"
#include "world.hpp"
#include <algorithm>

namespace evil {
namespace fluid {
namespace {

// What was written from outside may be anything.
void make_finite(Views& views) {
    for (Cell& cell : views.content) {
        cell.density = std::max(clamped(cell.density, kMostDensity), 0.0f);
        cell.fuel = std::max(clamped(cell.fuel, kMostDensity), 0.0f);
        cell.temperature = clamped(cell.temperature, kMostHeat);
    }
    for (float& value : views.velocity) value = clamped(value, kMostFlow);
}

void rise_by_stam(Smoke& smoke, Vec2 gravity, float dt) {
    const Gas& gas = smoke.gas;
    const Vec2 lift = (-gas.buoyancy * dt) * gravity;
    const float pull = std::min(gas.wind_pull * dt, 1.0f);
    Views& views = *smoke.views;
    for (std::size_t i = 0; i < views.content.size(); ++i) {
        float* velocity = &views.velocity[2 * i];
        const float t = views.content[i].temperature;
        velocity[0] += t * lift.x + pull * (gas.wind.x - velocity[0]);
        velocity[1] += t * lift.y + pull * (gas.wind.y - velocity[1]);
    }
}

// Density, then heat, then fuel: how many of them there are anywhere.
int used_lanes(const Views& views) {
    int used = 1;
    for (const Cell& cell : views.content) {
        if (cell.fuel != 0.0f) return 3;
        if (cell.temperature != 0.0f) used = 2;
    }
    return used;
}

void step_by_stam(Smoke& smoke, std::uint32_t slot, World& world, float dt) {
    Views& views = *smoke.views;
    settle_content({smoke, *smoke.scratch, world, dt});
    apply_sources(smoke, slot, world, dt);
    rise_by_stam(smoke, world.gravity, dt);
    std::span<float> content(&views.content[0].density, 4 * views.content.size());
    StamScratch& scratch = smoke.scratch->stam;
    move_by_stam(smoke.grid, smoke.gas.viscosity, dt, views.velocity, scratch);
    if (smoke.scratch->watched) smoke.scratch->gathering = gathered_by_stam(smoke.grid, scratch);
    carry_by_stam(smoke.grid, smoke.gas.diffusion, dt, content, 4, used_lanes(views), scratch);
    if (!views.colour.empty()) carry_by_stam(smoke.grid, smoke.gas.diffusion, dt, views.colour, 4, 3, scratch);
    for (float& value : views.velocity) value = clamped(value, kMostFlow);
}

void lay_out(Smoke& smoke) {
    Scratch& s = *smoke.scratch;
    if (s.laid_out) return;
    s.laid_out = true;
    for (Field* field :
         {&s.x, &s.y, &s.dx, &s.dy, &s.carried, &s.low, &s.high, &s.u, &s.v, &s.inflow, &s.heat, &s.curl})
        field->lay_out(smoke.grid);
    s.cells.resize(4 * smoke.grid.cells()), s.other_cells.resize(4 * smoke.grid.cells());
    s.sums.resize(2 * static_cast<std::size_t>(smoke.grid.ny));
    s.solids.lay_out(smoke.grid, smoke.open);
    s.pressure.lay_out(smoke.grid, smoke.open);
}

// Half a step, projected; what the projection took away is taken away once more, and the second half carries that on.
void reflect_half_way(const Step& step) {
    Smoke& smoke = step.smoke;
    Scratch& s = step.scratch;
    find_way(step, 0.5f * step.dt);
    carry_flow(step);
    s.u = smoke.u, s.v = smoke.v;
    take_along(step, smoke.half_pressure, 2.0f);
    project(step, smoke.half_pressure);
    reflect_rides(step);
    find_way(step, step.dt); // the flow half way through the step is the best guess for all of it
    carry_content(step);
    find_way(step, 0.5f * step.dt);
    const std::ptrdiff_t rows = smoke.grid.at(0, smoke.grid.ny + 1);
    EVIL_PICK(step.world.instruction_set, reflect)(smoke.u.data(), s.u.data(), rows);
    EVIL_PICK(step.world.instruction_set, reflect)(smoke.v.data(), s.v.data(), rows);
    smoke.u.swap(s.u), smoke.v.swap(s.v);
    carry_flow(step);
}

void step_staggered(Smoke& smoke, std::uint32_t slot, World& world, float dt) {
    lay_out(smoke);
    const Step step{smoke, *smoke.scratch, world, dt};
    if (smoke.views->lent) take_over(step);
    step.scratch.solids.update(world, smoke.grid, step.scratch.pressure, world.instruction_set);
    see_bodies(step);
    if (smoke.quality == Quality::high) {
        reflect_half_way(step);
    } else {
        find_way(step, dt);
        carry_content(step);
        carry_flow(step);
    }
    spread_content(step);
    settle_content(step);
    apply_sources(smoke, slot, world, dt);
    drive(step);
    thicken_flow(step);
    drag_bodies(step);
    take_along(step, smoke.pressure, 1.0f);
    project(step, smoke.pressure);
    watch(step);
    push_bodies(step);
    show(step);
}

void step(Smoke& smoke, std::uint32_t slot, World& world, float dt) {
    if (smoke.views->lent) make_finite(*smoke.views);
    if (smoke.method == Method::stam)
        step_by_stam(smoke, slot, world, dt);
    else
        step_staggered(smoke, slot, world, dt);
}

} // namespace
} // namespace fluid

void step_fluids(World& world, float dt) {
    for (std::uint32_t slot = 0; slot < world.fluids.smoke_slots.size(); ++slot)
        if (world.fluids.smoke_slots.taken(slot)) fluid::step(*world.fluids.smokes[slot], slot, world, dt);
    fluid::step_waters(world, dt);
}

} // namespace evil
