#pragma once
// The State of a water, for whoever writes, reads or sums it.
#include "fluid/water/water.hpp"
#include "state_fields.hpp"

namespace evil {

template <class A, Like<fluid::Stream> V> void visit(A& ar, V& s) {
    visit(ar, s.water, s.body, s.rate, s.velocity, s.liquid, s.due, s.poured, s.running, s.serial, s.born);
    visit(ar, s.area);
}

template <class A, Like<fluid::Liquid> V> void visit(A& ar, V& l) {
    visit(ar, l.density, l.viscosity, l.surface_tension, l.colour.r, l.colour.g, l.colour.b, l.serial);
}

template <class A, Like<fluid::Afloat> V> void visit(A& ar, V& a) {
    visit(ar, a.body, a.serial, a.velocity, a.gained, a.spin, a.gained_spin, a.force, a.torque);
}

template <class A, Like<fluid::Water> V> void visit_kind(A& ar, V& w) { // what the rest needs to know first
    visit(ar, w.grid.nx, w.grid.ny, w.grid.low, w.grid.h, w.particle_size, w.serial, w.born);
    visit(ar, w.open[0], w.open[1], w.open[2], w.open[3]);
}

template <class A, class AnyField> void visit_rows(A& ar, const fluid::Grid& grid, AnyField& field) {
    for (int j = 0; j <= grid.ny; ++j)
        for (int i = 0; i <= grid.nx; ++i) ar.value(field[grid.at(i, j)]);
}

template <class A, class AnyParticles> void visit_particles(A& ar, std::size_t count, AnyParticles& p) {
    for (std::size_t k = 0; k < 2 * count; k += 2) ar.values(p.positions[k], p.positions[k + 1]);
    for (std::size_t k = 0; k < 2 * count; k += 2) ar.values(p.velocities[k], p.velocities[k + 1]);
    for (std::size_t k = 0; k < 4 * count; k += 4)
        ar.values(p.affine[k], p.affine[k + 1], p.affine[k + 2], p.affine[k + 3]);
    for (std::size_t k = 0; k < count; ++k) ar.value(p.liquid[k]);
}
inline constexpr std::size_t kParticleBytes = 33; // as that writes one

struct Fluids;
struct SavedFluids;

void write_waters(auto& ar, const Fluids& all) {
    write_table(ar, all.water_slots, [&](std::uint32_t slot) {
        const fluid::Water& water = *all.waters[slot];
        visit_kind(ar, water);
        visit(ar, water.liquids);
        ar.count(water.count);
        visit_particles(ar, water.count, *water.particles);
        visit_rows(ar, water.grid, water.pressure);
        visit(ar, water.afloat);
    });
    write_table(ar, all.stream_slots, [&](std::uint32_t slot) { visit(ar, all.streams[slot]); });
}

void read_waters(Reader& ar, SavedFluids& saved);
bool waters_hold_together(const SavedFluids& saved, const std::vector<bool>& body_taken);
// The numbers of all liquids: kMostLiquids times the slot of their water, and their place in its row.
std::vector<std::uint32_t> liquids_of(const SavedFluids& saved);
void restore_waters(Fluids& fluids, SavedFluids& saved);

} // namespace evil
