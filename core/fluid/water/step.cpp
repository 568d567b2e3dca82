// One step of each water, in the order of their slots.
#include "fluid/water/scratch.hpp"
#include "world.hpp"
#include <algorithm>

namespace evil::fluid {
namespace {

// What was written from outside may be anything.
float sound(float value, float low, float high) { return value >= low ? std::min(value, high) : low; }

void fall(World& world, Water& water, float dt) {
    const Grid& g = water.grid;
    const float skin = 0.25f * water.particle_size;
    const Vec2 low = g.low + Vec2{skin, skin};
    const Vec2 high = g.low + Vec2{g.h * static_cast<float>(g.nx) - skin, g.h * static_cast<float>(g.ny) - skin};
    Particles& p = *water.particles;
    for (std::size_t k = 0; k < water.count; ++k) {
        float *at = &p.positions[2 * k], *speed = &p.velocities[2 * k];
        speed[0] = clamped(speed[0] + dt * world.gravity.x, kMostSwim);
        speed[1] = clamped(speed[1] + dt * world.gravity.y, kMostSwim);
        const Vec2 next{sound(at[0] + dt * speed[0], low.x, high.x), sound(at[1] + dt * speed[1], low.y, high.y)};
        if (next.x == low.x || next.x == high.x) speed[0] = 0.0f;
        if (next.y == low.y || next.y == high.y) speed[1] = 0.0f;
        if (banks_distance(water, next) < skin)
            speed[0] = speed[1] = 0.0f;
        else
            at[0] = next.x, at[1] = next.y;
    }
}

} // namespace

void step_waters(World& world, float dt) {
    for (std::uint32_t slot = 0; slot < world.fluids.water_slots.size(); ++slot) {
        if (!world.fluids.water_slots.taken(slot)) continue;
        Water& water = *world.fluids.waters[slot];
        update_banks(world, water);
        fall(world, water, dt);
    }
}

} // namespace evil::fluid
