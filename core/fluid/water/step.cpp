// One step of each water, in the order of their slots.
#include "fluid/water/pouring.hpp"
#include "fluid/water/scratch.hpp"
#include "world.hpp"

namespace evil::fluid {
namespace {

void step(World& world, Water& water, std::uint32_t slot, float dt) {
    update_banks(world, water);
    apply_streams(world, water, slot, dt);
    take_in(world, water);         // sorted, out of bodies
    gather_flow(world, water, dt); // particles to faces
    find_liquid(world, water);     // cells and their surface
    press_flow(world, water, dt);  // nothing gathers; bodies are pushed
    drift_small_bodies(world, water, dt);
    scatter_flow(world, water, dt); // faces to particles, which move
    give_out(world, water, dt);
}

} // namespace

void step_waters(World& world, float dt) {
    for (std::uint32_t slot = 0; slot < world.fluids.water_slots.size(); ++slot)
        if (world.fluids.water_slots.taken(slot)) step(world, *world.fluids.waters[slot], slot, dt);
}

} // namespace evil::fluid
