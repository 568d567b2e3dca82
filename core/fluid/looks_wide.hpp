#pragma once
#include "fluid/looks.hpp"
#include "math/cpu.hpp"
#include <array>

namespace evil {

namespace fluid {

using Planes = std::array<float*, 4>; // one of each of a cell's numbers

struct
    PaintRow { // of cells, and the pixels of it. What is read has one more before the first cell, and eight after the last
    const float *shown, *open; // a cell's number, and how much of it is gas
    const float* parts[3];     // red, green and blue times density, or null: all of it has the ramp's colours
    int count;                 // of cells
    const Ramp* ramp;
    float own[3]; // the colour that the ramp was made for
    std::uint32_t* to;
};

} // namespace fluid

// clang-format off
EVIL_WIDE(
// Three rows of cells, each as much of it as `share` says, number by number. Works in eights.
void mix_cells_wide(const float* const rows[3], const float share[3], const fluid::Planes& to, int count) noexcept;
// Two pixels of each cell of a row.
void paint_row_wide(const fluid::PaintRow& row) noexcept;)
// clang-format on

} // namespace evil
