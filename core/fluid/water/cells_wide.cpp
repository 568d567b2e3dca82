#include "fluid/water/cells_wide.hpp"
#include "math/wide.hpp"

namespace evil::EVIL_ISA {

using fluid::CellsView;
using fluid::kFullOfFilm;
using fluid::kFullOfSolid;
using fluid::Tile;

namespace {

constexpr float kHalf = 0.5f;     // of the fullness at rest: there the surface is
constexpr float kNearest = 10.0f; // cells per distance from a cell's middle to the surface, at most
constexpr float kDoubt = 0.1f;    // of the fullness: what a cell beside air may seem too full by

// 1 / distance from the middle of a cell with liquid to the surface, towards one without; the edge of the box is half a
// cell away; a film lets nothing out.
EVIL_INLINE Floats per_distance(Floats liquid, Floats air) {
    const Floats rate = (liquid - air) / max(liquid - Floats(kHalf), Floats(0.05f));
    const Floats shut = select(air < Floats(kFullOfFilm), Floats(2.0f), Floats(0.0f));
    return select(air < Floats(kFullOfSolid), clamp(rate, 1.0f, kNearest), shut);
}

// How easily a face's liquid is moved: it weighs what the cells beside it do.
EVIL_INLINE Floats ease(Floats mass, Floats other_mass) { return Floats(2.0f) / (mass + other_mass); }

struct Here { // what is in eight cells
    Floats wet, rho, mass;
};
EVIL_INLINE Here look(const CellsView& c, std::ptrdiff_t at) {
    return {load(c.wet + at), load(c.rho + at), load(c.mass + at)};
}

struct FaceWeights {
    Floats liquid, air;
};
EVIL_INLINE FaceWeights weigh(const CellsView& c, const Here& here, const float* open, std::ptrdiff_t other) {
    const Here there = look(c, other);
    const Floats weight = load(open) * here.wet;
    return {weight * there.wet * ease(here.mass, there.mass),
            weight * (Floats(1.0f) - there.wet) * per_distance(here.rho, there.rho) / here.mass};
}

} // namespace

void measure_cells(const CellsView& c, const Tile* tiles, std::size_t count, const float* pairs) noexcept {
    for (std::size_t k = 0; k < count; ++k) {
        const std::ptrdiff_t at = tiles[k].at;
        float particles[kLanes], mass[kLanes];
        for (int i = 0; i < kLanes; ++i) mass[i] = pairs[2 * (at + i)], particles[i] = pairs[2 * (at + i) + 1];
        const Floats some = load(particles);
        store(c.mass + at, select(some > 0.0f, load(mass) / some, Floats(1.0f)));
        const Floats per_room = load(c.per_room + at);
        store(c.rho + at, select(per_room > 0.0f, load(particles) * per_room, Floats(kFullOfSolid)));
    }
}

void find_wet(const CellsView& c, const Tile* tiles, std::size_t count, std::uint8_t* any_wet) noexcept {
    for (std::size_t k = 0; k < count; ++k) {
        const std::ptrdiff_t at = tiles[k].at;
        const Floats sides = min(load(c.rho + at - 1), load(c.rho + at + 1));
        const Floats ends = min(load(c.rho + at - c.stride), load(c.rho + at + c.stride));
        const Mask full = (load(c.rho + at) > Floats(kHalf)) | (min(sides, ends) > Floats(kHalf));
        const Mask wet = full & (load(c.per_room + at) > 0.0f);
        store(c.wet + at, select(wet, Floats(1.0f), Floats(0.0f)));
        any_wet[k] = any(wet);
    }
}

void weigh_cells(const CellsView& c, const Tile* tiles, std::size_t count) noexcept {
    for (std::size_t k = 0; k < count; ++k) {
        const std::ptrdiff_t at = tiles[k].at, s = c.stride;
        const Here here = look(c, at);
        const FaceWeights left = weigh(c, here, c.across + at, at - 1),
                          right = weigh(c, here, c.across + at + 1, at + 1);
        const FaceWeights below = weigh(c, here, c.up + at, at - s), above = weigh(c, here, c.up + at + s, at + s);
        const Floats drain = (left.air + right.air) + (below.air + above.air);
        const Floats total = ((left.liquid + right.liquid) + (below.liquid + above.liquid)) + drain;
        store(c.left + at, left.liquid);
        store(c.right + at, right.liquid);
        store(c.below + at, below.liquid);
        store(c.above + at, above.liquid);
        store(c.drain + at, drain);
        store(c.total + at, total);
        store(c.inverse + at, select(total > 0.0f, Floats(1.0f) / total, Floats(0.0f)));
    }
}

void find_inflow_of(const CellsView& c, const Tile* tiles, std::size_t count, const float* u, const float* v,
                    float* inflow) noexcept {
    for (std::size_t k = 0; k < count; ++k) {
        const std::ptrdiff_t at = tiles[k].at, s = c.stride;
        const Floats across = load(c.across + at) * load(u + at) - load(c.across + at + 1) * load(u + at + 1);
        const Floats up = load(c.up + at) * load(v + at) - load(c.up + at + s) * load(v + at + s);
        store(inflow + at, load(c.wet + at) * (across + up) + load(c.drain + at) * load(c.skin + at));
    }
}

void flow_by_pressure(const CellsView& c, const Tile* tiles, std::size_t count, const float* p, float most, float* u,
                      float* v) noexcept {
    for (std::size_t k = 0; k < count; ++k) {
        const std::ptrdiff_t at = tiles[k].at;
        const Here here = look(c, at);
        const Floats pressure = load(p + at), above_skin = (pressure - load(c.skin + at)) / here.mass;
        auto lose = [&](const float* open, float* flow, std::ptrdiff_t other) {
            const Here there = look(c, other);
            const Floats other_pressure = load(p + other),
                         other_above = (other_pressure - load(c.skin + other)) / there.mass;
            const Floats outward =
                here.wet * (Floats(1.0f) - there.wet) * above_skin * per_distance(here.rho, there.rho);
            const Floats inward =
                there.wet * (Floats(1.0f) - here.wet) * other_above * per_distance(there.rho, here.rho);
            const Floats within = here.wet * there.wet * ease(here.mass, there.mass) * (pressure - other_pressure);
            const Floats before = load(flow + at);
            const Floats bound = max(max(before, -before), most);
            const Floats after = clamp(before - (within + (outward - inward)), -bound, bound);
            store(flow + at, select(load(open + at) > 0.0f, after, before));
        };
        lose(c.across, u, at - 1);
        lose(c.up, v, at - c.stride);
    }
}

void extend_flow(const CellsView& c, const Tile* tiles, std::size_t count, float* u, float* v) noexcept {
    for (std::size_t k = 0; k < count; ++k) {
        const std::ptrdiff_t at = tiles[k].at;
        const std::ptrdiff_t below = tiles[k].j > 0 ? at - c.stride : at; // below the box is nothing to ask
        auto extend = [&](const float* open, float* flow, std::ptrdiff_t beside) {
            auto known = [&](std::ptrdiff_t face) {
                const Mask wet = load(c.wet + face) + load(c.wet + face - beside) > 0.0f;
                return wet & (load(open + face) > 0.0f);
            };
            const Mask open_air = (load(open + at) > 0.0f) & ~known(at);
            if (!any(open_air)) return;
            Floats sum(0.0f), number(0.0f);
            for (std::ptrdiff_t other : {at - 1, at + 1, below, at + c.stride}) {
                const Mask sure = known(other);
                sum += select(sure, load(flow + other), Floats(0.0f));
                number += select(sure, Floats(1.0f), Floats(0.0f));
            }
            const Mask found = open_air & (number > 0.0f);
            store(flow + at, select(found, sum / max(number, 1.0f), load(flow + at)));
        };
        extend(c.across, u, 1);
        extend(c.up, v, c.stride);
    }
}

void find_crowds(const CellsView& c, const Tile* tiles, std::size_t count, float share, float* crowd) noexcept {
    for (std::size_t k = 0; k < count; ++k) {
        const std::ptrdiff_t at = tiles[k].at;
        const Floats more = clamp(load(c.rho + at) - Floats(1.0f), -0.5f, 0.5f);
        // beside air nobody knows how much is missing, nor quite what is too much
        const Mask sure = load(c.drain + at) == Floats(0.0f);
        store(crowd + at,
              load(c.wet + at) * Floats(share) * select(sure, more, max(more - Floats(kDoubt), Floats(0.0f))));
    }
}

} // namespace evil::EVIL_ISA
