#include "fluid/flow.hpp"
#include "fluid/state.hpp"
#include "fluid/water/pouring.hpp"
#include "world.hpp"
#include <algorithm>
#include <cmath>

namespace evil {
namespace {

using fluid::Smoke;

constexpr float kLargest = 1e30f; // that is written

bool sensible(const Smoke& s) {
    auto length = [](int n) { return n >= fluid::kLeastCells && n <= fluid::kMostCells; };
    return length(s.grid.nx) && length(s.grid.ny) && s.grid.h > 0.0f && s.method <= fluid::Method::stam &&
           s.quality <= fluid::Quality::high;
}

// What the next step will bring into its ranges; a file holds numbers only.
void make_numbers(fluid::Views& views) {
    auto make = [](float& value) { value = clamped(value, kLargest); };
    for (fluid::Cell& cell : views.content) make(cell.density), make(cell.temperature), make(cell.fuel);
    std::ranges::for_each(views.velocity, make);
}

std::unique_ptr<Smoke> read_smoke(Reader& ar) {
    Smoke kind;
    visit_kind(ar, kind);
    const std::size_t cells = ar.count(0, sizeof(fluid::Cell)), coloured = ar.count(0, 4);
    ar.ok = ar.ok && sensible(kind) && cells == kind.grid.cells() && (coloured == 0 || coloured == 4 * cells);
    if (!ar.ok) return nullptr;
    const fluid::Grid grid = fluid::grid_of(kind.grid.nx, kind.grid.ny, kind.grid.low, kind.grid.h);
    std::unique_ptr<Smoke> smoke = fluid::make_smoke(grid, kind.method);
    smoke->quality = kind.quality, smoke->open = kind.open, smoke->side_speeds = kind.side_speeds;
    smoke->stick = kind.stick, smoke->gas = kind.gas, smoke->colour = kind.colour, smoke->serial = kind.serial,
    smoke->born = kind.born;
    smoke->views->colour.resize(coloured);
    visit_content(ar, *smoke);
    if (smoke->method == fluid::Method::stam) return smoke;                                     // which has no faces
    for (fluid::Field* field : {&smoke->u, &smoke->v, &smoke->pressure, &smoke->half_pressure}) // no step leaves more
        for (int j = 0; j <= grid.ny; ++j)
            for (std::ptrdiff_t at = grid.at(0, j); at <= grid.at(grid.nx, j); ++at)
                ar.ok = ar.ok && std::abs((*field)[at]) <= kLargest;
    return smoke;
}

} // namespace

void read_fluids(Reader& ar, SavedFluids& s) {
    Fluids& all = s.fluids;
    ar.value(all.next_serial);
    read_table(
        ar, s.smoke_taken, [&](std::size_t n) { all.smokes.resize(n); },
        [&](std::uint32_t slot) { all.smokes[slot] = read_smoke(ar); });
    read_table(
        ar, s.source_taken, [&](std::size_t n) { all.sources.resize(n); },
        [&](std::uint32_t slot) { visit(ar, all.sources[slot]); });
    read_waters(ar, s);
}

bool has_an_inside(const Area& area) {
    return (area.radius > 0.0f || !area.parts.empty()) &&
           std::ranges::all_of(area.parts, [](const auto& part) { return part.size() > 2; });
}

bool hold_together(const SavedFluids& s, const std::vector<bool>& body_taken) {
    auto taken = [](const std::vector<bool>& list, std::uint32_t slot) { return slot < list.size() && list[slot]; };
    for (std::uint32_t i = 0; i < s.smoke_taken.size(); ++i)
        if (s.smoke_taken[i] && s.fluids.smokes[i]->serial >= s.fluids.next_serial) return false;
    for (std::uint32_t i = 0; i < s.source_taken.size(); ++i) {
        if (!s.source_taken[i]) continue;
        const fluid::Source& source = s.fluids.sources[i];
        if (!taken(s.smoke_taken, source.smoke) || source.serial >= s.fluids.next_serial) return false;
        if (source.body != kNone && !taken(body_taken, source.body)) return false;
        if (!has_an_inside(source.area)) return false;
    }
    return waters_hold_together(s, body_taken);
}

void settle_fluids(World& world) {
    for (std::uint32_t i = 0; i < world.fluids.water_slots.size(); ++i)
        if (world.fluids.water_slots.taken(i) && world.fluids.waters[i]->particles->lent)
            settle(*world.fluids.waters[i]);
    for (std::uint32_t i = 0; i < world.fluids.smoke_slots.size(); ++i) {
        if (!world.fluids.smoke_slots.taken(i) || !world.fluids.smokes[i]->views->lent) continue;
        Smoke& smoke = *world.fluids.smokes[i];
        make_numbers(*smoke.views);
        if (smoke.method == fluid::Method::stam) continue;
        const fluid::Step step{smoke, *smoke.scratch, world, 0.0f};
        take_over(step); // whoever reads the file does not know what was written
        show(step);
    }
}

namespace {

// Were both made at once, and of the same? Another history may have made others in their place (identity.hpp); what never
// changes afterwards tells them apart.
bool made_alike(const Smoke& a, const Smoke& b) {
    return a.serial == b.serial && a.born == b.born && a.grid.nx == b.grid.nx && a.grid.ny == b.grid.ny &&
           a.grid.low == b.grid.low && a.grid.h == b.grid.h && a.method == b.method && a.quality == b.quality &&
           a.open == b.open && a.side_speeds == b.side_speeds && a.stick == b.stick && a.colour == b.colour;
}
bool made_alike(const fluid::Source& a, const fluid::Source& b) {
    return a.serial == b.serial && a.born == b.born && a.smoke == b.smoke && a.body == b.body &&
           a.area.centre == b.area.centre && a.area.radius == b.area.radius && a.area.parts == b.area.parts;
}

} // namespace

void restore_fluids(Fluids& now, SavedFluids& saved) {
    Fluids& then = saved.fluids;
    auto same_smoke = [&](std::uint32_t i) {
        return i < now.smokes.size() && now.smokes[i] && saved.smoke_taken[i] &&
               made_alike(*now.smokes[i], *then.smokes[i]);
    };
    auto same_source = [&](std::uint32_t i) {
        return now.source_slots.taken(i) && saved.source_taken[i] && made_alike(now.sources[i], then.sources[i]);
    };
    std::vector<bool> smokes(saved.smoke_taken.size()), sources(saved.source_taken.size());
    for (std::uint32_t i = 0; i < smokes.size(); ++i) {
        smokes[i] = same_smoke(i);
        if (!smokes[i]) continue;
        fluid::Views &shown = *now.smokes[i]->views, &read = *then.smokes[i]->views;
        std::ranges::copy(read.content, shown.content.begin());
        std::ranges::copy(read.velocity, shown.velocity.begin());
        shown.colour = std::move(read.colour);
        then.smokes[i]->views = now.smokes[i]->views;
    }
    for (std::uint32_t i = 0; i < sources.size(); ++i) sources[i] = same_source(i);
    now.smoke_slots.restore(saved.smoke_taken, smokes);
    now.source_slots.restore(saved.source_taken, sources);
    now.smokes = std::move(then.smokes);
    now.sources = std::move(then.sources);
    now.smokes.resize(now.smoke_slots.size());
    now.sources.resize(now.source_slots.size());
    restore_waters(now, saved);
    now.next_serial = then.next_serial;
}

} // namespace evil
