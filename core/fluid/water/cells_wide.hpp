#pragma once
// The water's work on particles and cells, eight at a time.
#include "fluid/water/press_wide.hpp"

namespace evil::fluid {

inline constexpr float kFullOfSolid = 2.0f, kFullOfFilm = 3.0f; // fullness that stands for what is no air

struct SwarmView { // particles, in cells and m/s; eight more may be read and written
    std::size_t count;
    float *x, *y, *u, *v;
    float* affine[4];
    const float* mass;
};

struct CellsView {
    std::ptrdiff_t stride;
    const float *across, *up, *per_room;
    float *rho, *wet, *mass;
    const float* skin; // pressure of the surface
    float *left, *right, *below, *above, *drain, *total, *inverse;
};

} // namespace evil::fluid

namespace evil {

// APIC (Jiang et al. 2015): pairs of weight * velocity and weight on left and lower faces, and of weight * mass and weight in
// the middle of cells, which begin at what is there.
EVIL_WIDE(void splat_particles(const fluid::SwarmView& swarm, std::ptrdiff_t stride, float* across, float* up,
                               float* middle) noexcept;)
// Back: velocities, how they change round each particle, and where it goes. `shift` moves particles beside; `cells`: dt / h.
EVIL_WIDE(void carry_particles(const fluid::SwarmView& swarm, std::ptrdiff_t stride, const float* u, const float* v,
                               const float* shift_u, const float* shift_v, float cells) noexcept;)

// How full the cells of a tile are, from the pairs.
EVIL_WIDE(void measure_cells(const fluid::CellsView& cells, const fluid::Tile* tiles, std::size_t count,
                             const float* pairs) noexcept;)
// Which cells hold liquid; true at `any` where a tile has some.
EVIL_WIDE(void find_wet(const fluid::CellsView& cells, const fluid::Tile* tiles, std::size_t count,
                        std::uint8_t* any) noexcept;)
// The weights of their faces, the surface where fullness is a half (ghost fluid: Gibou, Fedkiw, Cheng and Kang 2002).
EVIL_WIDE(void weigh_cells(const fluid::CellsView& cells, const fluid::Tile* tiles, std::size_t count) noexcept;)
// What flows into each cell.
EVIL_WIDE(void find_inflow_of(const fluid::CellsView& cells, const fluid::Tile* tiles, std::size_t count,
                              const float* u, const float* v, float* inflow) noexcept;)
// u and v lose the pressure's gradient, which brings them to no more than `most`, or than they were.
EVIL_WIDE(void flow_by_pressure(const fluid::CellsView& cells, const fluid::Tile* tiles, std::size_t count,
                                const float* p, float most, float* u, float* v) noexcept;)
// Faces in the air beside those of liquid move as these do: else what is on top would fall into what is below.
EVIL_WIDE(void extend_flow(const fluid::CellsView& cells, const fluid::Tile* tiles, std::size_t count, float* u,
                           float* v) noexcept;)
// What crowds each cell, for the pressure that moves particles apart.
EVIL_WIDE(void find_crowds(const fluid::CellsView& cells, const fluid::Tile* tiles, std::size_t count, float share,
                           float* crowd) noexcept;)

} // namespace evil
