#pragma once
#include "math/cpu.hpp"
#include "raster/liquid.hpp"

namespace evil {

// clang-format off
EVIL_WIDE(
// Means of two rows of texels, and of four. Work in eights.
void mix_two_wide(const float* first, std::size_t stride, float part, float* to, int count) noexcept;
void mix_four_wide(const float* first, std::size_t stride, const float part[4], float* to, int count) noexcept;
// A run of pixels that begins at column x.
void liquid_row_wide(raster::Pixel* to, int x, int count, const raster::LiquidRow& row) noexcept;)
// clang-format on

} // namespace evil
