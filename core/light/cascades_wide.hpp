#pragma once
// Rows of cells that hold rays are four planes one after another, `stride` floats each: the share of light that they let
// through, and the light that they meet. Rows of cones are three: the light that comes through them.
#include "math/cpu.hpp"
#include <cstddef>

namespace evil::light {

struct FirstRays {          // from each cell of a row to one of the next
    const float *from, *to; // the rows of cells, and their planes behind them
    std::size_t plane;      // floats from plane to plane
    int shift;              // -1 or 1: to which side
    bool glows;             // are there planes of what glows?
};

struct Pair {                // rays one behind the other
    const float *near, *far; // no far ones: beyond the map, where nothing is met
    int shift;               // cells to the side that the near ones end
};

struct Way {           // by which light comes through a cone
    const float* near; // rays; none: it starts where the cone does
    const float* far;  // light at their ends; none: they leave the map
    int shift;
    float angle, weight; // the cone's share of all directions, and this way's of the cone
};

struct Surround {
    float sky[3];  // where rays leave the map
    float fill[3]; // of it, what counts as seen where they are blocked
};

} // namespace evil::light

namespace evil {

// clang-format off
EVIL_WIDE(
void first_rays_wide(const light::FirstRays& rays, int count, std::size_t stride, float* to) noexcept;
// The mean of one pair or of two.
void join_rays_wide(const light::Pair* pairs, int pair_count, int count, std::size_t stride, float* to) noexcept;
void gather_rays_wide(const light::Way* ways, int way_count, const light::Surround& surround, int count,
                      std::size_t stride, float* to) noexcept;)
// clang-format on

} // namespace evil
