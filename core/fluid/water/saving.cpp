#include "fluid/state.hpp"
#include "fluid/water/pouring.hpp"
#include "fluid/water/scratch.hpp"
#include <algorithm>
#include <cmath>

namespace evil {
namespace {

using fluid::Particles;
using fluid::Water;

bool sensible(const Water& w) {
    auto length = [](int n) { return n >= fluid::kLeastCells && n <= fluid::kMostCells; };
    return length(w.grid.nx) && length(w.grid.ny) && w.particle_size > 0.0f &&
           w.grid.h == fluid::kCellsOfParticle * w.particle_size;
}

std::unique_ptr<Water> read_water(Reader& ar) {
    Water kind;
    visit_kind(ar, kind);
    visit(ar, kind.liquids);
    kind.count = ar.count(0, kParticleBytes);
    ar.ok = ar.ok && sensible(kind) && !kind.liquids.empty() && kind.liquids.size() <= fluid::kMostLiquids &&
            kind.count <= fluid::kMostParticles && kind.grid.cells() * sizeof(float) <= ar.left();
    if (!ar.ok) return nullptr;
    const fluid::Grid grid = fluid::grid_of(kind.grid.nx, kind.grid.ny, kind.grid.low, kind.grid.h);
    std::unique_ptr<Water> water = fluid::make_water(grid, kind.particle_size);
    water->open = kind.open, water->liquids = kind.liquids, water->serial = kind.serial, water->born = kind.born;
    ar.ok = ar.ok && fluid::make_room(*water, kind.count);
    if (!ar.ok) return nullptr;
    water->count = kind.count;
    visit_particles(ar, water->count, *water->particles);
    visit_rows(ar, water->grid, water->pressure);
    visit(ar, water->afloat);
    const auto liquids = static_cast<std::uint8_t>(water->liquids.size());
    for (std::size_t k = 0; k < water->count; ++k) ar.ok = ar.ok && water->particles->liquid[k] < liquids;
    return water;
}

} // namespace

void read_waters(Reader& ar, SavedFluids& s) {
    read_table(
        ar, s.water_taken, [&](std::size_t n) { s.fluids.waters.resize(n); },
        [&](std::uint32_t slot) { s.fluids.waters[slot] = read_water(ar); });
    read_table(
        ar, s.stream_taken, [&](std::size_t n) { s.fluids.streams.resize(n); },
        [&](std::uint32_t slot) { visit(ar, s.fluids.streams[slot]); });
}

bool waters_hold_together(const SavedFluids& s, const std::vector<bool>& body_taken) {
    for (std::uint32_t i = 0; i < s.water_taken.size(); ++i) {
        if (!s.water_taken[i]) continue;
        const Water& water = *s.fluids.waters[i];
        if (water.serial >= s.fluids.next_serial) return false;
        if (!std::ranges::is_sorted(water.afloat, std::ranges::less_equal{}, &fluid::Afloat::body)) return false;
        for (const fluid::Liquid& liquid : water.liquids)
            if (!(liquid.density > 0.0f && liquid.viscosity >= 0.0f && liquid.surface_tension >= 0.0f)) return false;
        settle(*s.fluids.waters[i]); // whatever they say, particles are in their box
    }
    for (std::uint32_t i = 0; i < s.stream_taken.size(); ++i) {
        if (!s.stream_taken[i]) continue;
        const fluid::Stream& stream = s.fluids.streams[i];
        if (stream.water >= s.water_taken.size() || !s.water_taken[stream.water]) return false;
        if (stream.liquid >= s.fluids.waters[stream.water]->liquids.size()) return false;
        if (stream.body != kNone && !(stream.body < body_taken.size() && body_taken[stream.body])) return false;
        if (!(std::abs(stream.rate) <= fluid::kMostPouring) || !(stream.due >= 0.0f)) return false;
        if (stream.serial >= s.fluids.next_serial || !has_an_inside(stream.area)) return false;
    }
    return true;
}

std::vector<std::uint32_t> liquids_of(const SavedFluids& s) {
    std::vector<std::uint32_t> numbers;
    for (std::uint32_t slot = 0; slot < s.water_taken.size(); ++slot)
        for (std::uint32_t i = 0; s.water_taken[slot] && i < s.fluids.waters[slot]->liquids.size(); ++i)
            numbers.push_back(static_cast<std::uint32_t>(fluid::kMostLiquids) * slot + i);
    return numbers;
}

void restore_waters(Fluids& now, SavedFluids& saved) {
    Fluids& then = saved.fluids;
    std::vector<bool> waters(saved.water_taken.size()), streams(saved.stream_taken.size());
    for (std::uint32_t i = 0; i < waters.size(); ++i) {
        waters[i] = i < now.waters.size() && now.waters[i] && saved.water_taken[i] &&
                    now.waters[i]->serial == then.waters[i]->serial && now.waters[i]->born == then.waters[i]->born;
        if (!waters[i] || now.waters[i]->particles->capacity < then.waters[i]->count) continue;
        Particles &shown = *now.waters[i]->particles, &read = *then.waters[i]->particles; // views show what was saved
        const auto n = static_cast<std::ptrdiff_t>(then.waters[i]->count);
        std::copy_n(read.positions.begin(), 2 * n, shown.positions.begin());
        std::copy_n(read.velocities.begin(), 2 * n, shown.velocities.begin());
        std::copy_n(read.affine.begin(), 4 * n, shown.affine.begin());
        std::copy_n(read.liquid.begin(), n, shown.liquid.begin());
        then.waters[i]->particles = now.waters[i]->particles;
    }
    for (std::uint32_t i = 0; i < streams.size(); ++i)
        streams[i] = now.stream_slots.taken(i) && saved.stream_taken[i] &&
                     now.streams[i].serial == then.streams[i].serial && now.streams[i].born == then.streams[i].born;
    now.water_slots.restore(saved.water_taken, waters);
    now.stream_slots.restore(saved.stream_taken, streams);
    now.waters = std::move(then.waters);
    now.streams = std::move(then.streams);
    now.waters.resize(now.water_slots.size());
    now.streams.resize(now.stream_slots.size());
}

} // namespace evil
