#pragma once
// One copy of each inner loop for each instruction set; rows of pixels, eight at a time.
#include "math/cpu.hpp"
#include "raster/target.hpp"

namespace evil::raster {

struct Finish {        // a row of the finished picture
    const Pixel* glow; // bloom, two rows of which are mixed already, at half the size; null for none
    int y;
    float bloom, saturation, vignette, grain;
    float across, down; // 2 over the width, over the height
    std::uint32_t seed;
    const float* table;
};

} // namespace evil::raster

namespace evil {

// clang-format off
EVIL_WIDE(
// to[i] = the mean of two pixels of each row. `to` has room for the count rounded up to eights, and `a` and `b` for twice that.
void halve_row_wide(raster::Pixel* to, const raster::Pixel* a, const raster::Pixel* b, int count) noexcept;
// to[i] = (3 near + far) / 4
void mix_rows_wide(raster::Pixel* to, const raster::Pixel* near, const raster::Pixel* far, int count) noexcept;
// to[i] = to[i] + share / 256 of (half the row `from`, doubled - to[i]); from[-1] and from[one past the last] are read.
void double_row_wide(raster::Pixel* to, const raster::Pixel* from, int count, int share) noexcept;
void add_double_row_wide(raster::Pixel* to, const raster::Pixel* from, int count) noexcept; // the same, as light
void keep_bright_wide(raster::Pixel* row, int count, float threshold) noexcept;
void finish_row_wide(raster::Pixel* row, int count, const raster::Finish& how) noexcept;)
// clang-format on

} // namespace evil
