// One step of each smoke, in the order of their slots.
#include "fluid/scratch.hpp"
#include "fluid/sources.hpp"
#include "world.hpp"
#include <algorithm>

namespace evil {
namespace fluid {
namespace {

constexpr float kMostHeat = 1e3f; // of a cell: fire in a sealed box may burn for ever
constexpr float kMostFlow = 1e4f; // m/s

// What is left of something that loses a share of itself a second.
float kept(float share_a_second, float dt) { return 1.0f / (1.0f + share_a_second * dt); }

// Fuel burns to heat and soot; heat and density are lost.
void react(Smoke& smoke, float dt) {
    const Gas& gas = smoke.gas;
    const float warm = kept(gas.cooling, dt), stays = kept(gas.fade, dt), unburnt = kept(gas.burning, dt);
    Views& views = *smoke.views;
    for (Cell& cell : views.content) {
        const float burnt = cell.fuel * (1.0f - unburnt);
        cell.fuel *= unburnt;
        cell.density = cell.density * stays + gas.soot * burnt;
        cell.temperature = std::clamp(cell.temperature * warm + gas.heat * burnt, -kMostHeat, kMostHeat);
    }
    if (stays < 1.0f)
        for (float& part : views.colour) part *= stays;
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

void step(Smoke& smoke, std::uint32_t slot, World& world, float dt) {
    Views& views = *smoke.views;
    react(smoke, dt);
    apply_sources(smoke, slot, world, dt);
    rise_by_stam(smoke, world.gravity, dt);
    std::span<float> content(&views.content[0].density, 4 * views.content.size());
    move_by_stam(smoke.grid, smoke.gas.viscosity, dt, views.velocity, smoke.scratch->stam);
    carry_by_stam(smoke.grid, smoke.gas.diffusion, dt, content, 4, 3, smoke.scratch->stam);
    if (!views.colour.empty())
        carry_by_stam(smoke.grid, smoke.gas.diffusion, dt, views.colour, 4, 3, smoke.scratch->stam);
    for (float& value : views.velocity) value = clamped(value, kMostFlow);
}

} // namespace
} // namespace fluid

void step_fluids(World& world, float dt) {
    for (std::uint32_t slot = 0; slot < world.fluids.smoke_slots.size(); ++slot)
        if (world.fluids.smoke_slots.taken(slot)) fluid::step(*world.fluids.smokes[slot], slot, world, dt);
}

} // namespace evil
