#pragma once
// The work of the water's pressure on the tiles of one level.
#include "math/cpu.hpp"
#include <cstddef>
#include <cstdint>

namespace evil::fluid {

struct Tile { // eight cells of a row
    std::int32_t i, j;
    std::ptrdiff_t at;
};

struct PressView {
    std::ptrdiff_t stride;
    const Tile* tiles;
    std::size_t count;
    const float *left, *right, *below, *above, *total, *inverse;
    float *z, *b;
};

} // namespace evil::fluid

namespace evil {

EVIL_WIDE(void press_start(const fluid::PressView& level) noexcept;) // red cells from z = 0; black ones are 0
EVIL_WIDE(void press_relax(const fluid::PressView& level, int colour) noexcept;) // Gauss-Seidel of one colour
EVIL_WIDE(void press_restrict(const fluid::PressView& fine, const fluid::PressView& coarse) noexcept;)
EVIL_WIDE(void press_prolong(const fluid::PressView& coarse, const fluid::PressView& fine) noexcept;)
// result = A p; gives p * result.
EVIL_WIDE(float press_apply(const fluid::PressView& level, const float* p, float* result) noexcept;)
EVIL_WIDE(float press_dot(const fluid::PressView& level, const float* p, const float* q) noexcept;)
// p += step * search, b -= step * image; gives b * b.
EVIL_WIDE(float press_advance(const fluid::PressView& level, float step, const float* search, const float* image,
                              float* p) noexcept;)
EVIL_WIDE(void press_turn(const fluid::PressView& level, float keep,
                          float* search) noexcept;) // search = z + keep * search

} // namespace evil
