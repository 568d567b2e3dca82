#pragma once
#include "math/cpu.hpp"

namespace evil {

// clang-format off
EVIL_WIDE(
// The mean of five with weights 1 4 6 4 1, `apart` floats apart; the first one stands at from[0]. Works in eights.
void mean_of_five_wide(const float* from, int apart, float* to, int count) noexcept;
void mean_of_rows_wide(const float* const rows[5], float* to, int count) noexcept;
// Of one row of texels: how far inside the particles' means say that each is, in texels, and that as a share of it.
void sharp_wide(const float* weight, const float* x, const float* y, float row, float one, float* sharp, float* whole,
                int count) noexcept;
// The smooth surface where there is much liquid, the sharp one where there is little.
void join_wide(const float* sharp, const float* smooth, const float* bulk, float* to, int count) noexcept;)
// clang-format on

} // namespace evil
