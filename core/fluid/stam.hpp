#pragma once
// Stam's stable fluids as the thesis describes them (4.5.3 to 4.5.5; Stam 2003, "Real-Time Fluid Dynamics for Games"): all
// in the middle of the cells, sources, diffusion and projection by Gauss-Seidel sweeps, semi-Lagrangian advection, a layer
// of cells round the box that nothing flows through. It knows no solids but the box.
#include "fluid/grid.hpp"
#include <span>
#include <vector>

namespace evil::fluid {

inline constexpr int kSweeps = 20; // of Gauss-Seidel, as published: more cost time, fewer leave more divergence

// How much gathered in the cells before the last projection and after it: root mean square, 1/s.
struct Gathering {
    float before = 0.0f, after = 0.0f;
};

struct StamScratch {
    std::vector<float> u, v, u_before, v_before, carried, carried_before, pressure, divergence;
};

// The velocity's step; `velocity`: x and y of each cell, m/s.
void move_by_stam(const Grid& grid, float viscosity, float dt, std::span<float> velocity, StamScratch& scratch);

Gathering gathered_by_stam(const Grid& grid, StamScratch& scratch);

// Then the step of what it carries: rows of `lanes` floats, of which the first `used` are diffused and moved along.
void carry_by_stam(const Grid& grid, float diffusion, float dt, std::span<float> carried, int lanes, int used,
                   StamScratch& scratch);

} // namespace evil::fluid
