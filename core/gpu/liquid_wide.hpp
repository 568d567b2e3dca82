#pragma once
#include "math/cpu.hpp"
#include <cstdint>

namespace evil {

// clang-format off
EVIL_WIDE(
// Four planes as texels of four floats of 16 bits, to the nearest; what is too small for a full one is 0. Works in eights.
void pack_halves_wide(const float* const planes[4], std::uint16_t* to, int count) noexcept;)
// clang-format on

} // namespace evil
