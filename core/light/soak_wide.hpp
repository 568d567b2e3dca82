#pragma once
#include "math/cpu.hpp"

namespace evil {

// clang-format off
EVIL_WIDE(
// Means from sums of windows, which then move on by one: numbers enter, others leave. `count` is a multiple of eight.
void move_windows_wide(float* means, float* sums, const float* enters, const float* leaves, float share,
                       int count) noexcept;)
// clang-format on

} // namespace evil
