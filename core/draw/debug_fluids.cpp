#include "draw/debug_marks.hpp"
#include "fluid/water/water.hpp"

namespace evil::draw {
namespace {

template <class Rows, class Visit> void each_fluid(const Slots& slots, const Rows& rows, Visit visit) {
    for (std::uint32_t slot = 0; slot < slots.size(); ++slot)
        if (slots.taken(slot)) visit(*rows[slot]);
}

} // namespace

FluidScale draw_fluids(const FluidFrame& f) {
    FluidScale scale;
    Marks marks;
    const Fluids& all = f.world.fluids;
    const auto note = [&](const auto& fluid) { ++scale.fluids, mark(f, fluid, marks); };
    each_fluid(all.smoke_slots, all.smokes, note);
    each_fluid(all.water_slots, all.waters, note);
    scale.divergence = draw_tiles(f, marks.tiles);
    const auto cells = [&](const auto& fluid) {
        if (f.shows(FluidPart::cells)) draw_cells(f, fluid);
    };
    each_fluid(all.smoke_slots, all.smokes, cells);
    each_fluid(all.water_slots, all.waters, cells);
    each_fluid(all.water_slots, all.waters, [&](const fluid::Water& water) {
        scale.particles += static_cast<std::uint32_t>(water.count);
        if (f.shows(FluidPart::particles)) draw_particles(f, water);
    });
    scale.speed = draw_arrows(f, marks.arrows);
    return scale;
}

} // namespace evil::draw
