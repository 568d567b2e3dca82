#pragma once
#include "math/cpu.hpp"
#include "math/transform.hpp"
#include <cstddef>

namespace evil {
// rotation() of each angle, to the same bits.
EVIL_WIDE(void rotations(const double* angles, std::size_t count, Rot* out) noexcept;)
} // namespace evil
