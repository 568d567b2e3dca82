#pragma once
// One copy of each inner loop for each instruction set; rows of pixels, eight at a time.
#include "math/cpu.hpp"
#include "raster/target.hpp"

namespace evil::raster {

// A row of a picture that is being spread out: red and blue share a number, and green and alpha, 16 bits each, in parts of
// a level. So many steps after each other lose nothing that is seen, and four of them can be summed.
struct Deep {
    std::uint32_t *rb, *ga;
};

struct Finish { // a row of the finished picture
    Deep glow;  // bloom, two rows of which are mixed already, and doubled; null for none
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
void halve_picture_wide(raster::Deep to, const raster::Pixel* a, const raster::Pixel* b, int count) noexcept;
void halve_row_wide(raster::Deep to, raster::Deep a, raster::Deep b, int count) noexcept;
// to[i] = (3 near + far) / 4
void mix_rows_wide(raster::Deep to, raster::Deep near, raster::Deep far, int count) noexcept;
// to[i] = to[i] + share / 256 of (half the row `from`, doubled - to[i]); from[-1] and from[one past the last] are read.
void double_row_wide(raster::Deep to, raster::Deep from, int count, int share) noexcept;
void double_picture_wide(raster::Pixel* to, raster::Deep from, int count, int share) noexcept;
void add_double_row_wide(raster::Deep to, raster::Deep from, int count) noexcept; // the same, as light
void keep_bright_wide(raster::Deep row, int count, float threshold) noexcept;
void finish_row_wide(raster::Pixel* row, int count, const raster::Finish& how) noexcept;)
// clang-format on

} // namespace evil
