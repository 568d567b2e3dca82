#pragma once
// The State of a world's fluids, for whoever writes, reads or sums it.
#include "fluid/smoke.hpp"
#include "fluid/water/state.hpp"
#include "state_fields.hpp"

namespace evil {

template <class A, Like<fluid::Source> V> void visit(A& ar, V& s) {
    visit(ar, s.smoke, s.body, s.rate, s.fuel, s.temperature, s.blows, s.velocity, s.colour.r, s.colour.g, s.colour.b,
          s.running, s.serial, s.born);
    visit(ar, s.area);
}

template <class A, Like<fluid::Gas> V> void visit(A& ar, V& g) {
    visit(ar, g.viscosity, g.diffusion, g.buoyancy, g.vorticity, g.cooling, g.fade, g.burning, g.heat, g.soot, g.weight,
          g.wind, g.wind_pull);
}

template <class A, Like<fluid::Smoke> V> void visit_kind(A& ar, V& s) { // what the rest needs to know first
    visit(ar, s.grid.nx, s.grid.ny, s.grid.low, s.grid.h, s.method, s.quality, s.serial, s.born);
    visit(ar, s.open[0], s.open[1], s.open[2], s.open[3], s.side_speeds[0], s.side_speeds[1], s.side_speeds[2],
          s.side_speeds[3], s.stick, s.colour.r, s.colour.g, s.colour.b);
    visit(ar, s.gas);
}

template <class A, Like<fluid::Smoke> V> void visit_content(A& ar, V& s) {
    auto& views = *s.views;
    for (auto& cell : views.content) ar.values(cell.density, cell.temperature, cell.fuel, cell.open);
    for (auto& part : views.colour) ar.value(part);
    for (auto& value : views.velocity) ar.value(value);
    if (s.method == fluid::Method::stam) return;
    for (auto* field : {&s.u, &s.v, &s.pressure, &s.half_pressure}) visit_rows(ar, s.grid, *field);
}

void write_fluids(auto& ar, const Fluids& all) {
    ar.value(all.next_serial);
    write_table(ar, all.smoke_slots, [&](std::uint32_t slot) {
        const fluid::Smoke& smoke = *all.smokes[slot];
        visit_kind(ar, smoke);
        ar.count(smoke.views->content.size());
        ar.count(smoke.views->colour.size());
        visit_content(ar, smoke);
    });
    write_table(ar, all.source_slots, [&](std::uint32_t slot) { visit(ar, all.sources[slot]); });
    write_waters(ar, all);
}

struct SavedFluids { // what is read before the world is touched
    Fluids fluids;
    std::vector<bool> smoke_taken, source_taken, water_taken, stream_taken;
};
void read_fluids(Reader& ar, SavedFluids& saved);
bool has_an_inside(const Area& area);
bool hold_together(const SavedFluids& saved, const std::vector<bool>& body_taken);
void restore_fluids(Fluids& fluids,
                    SavedFluids& saved); // views that others hold show what was saved, if it is as large

} // namespace evil
