#pragma once
// Multigrid's work on one level, eight cells at a time. Cells lie by colour, red and black as on a chess board, so that all
// neighbours of one colour's are of the other, side by side:
//
//     row j:  cell i = 2k + s of colour c, s = (c + j) & 1        left and right: the other colour's k - 1 + s and k + s
//                                                                 below and above: its k in rows j - 1 and j + 1
#include "math/cpu.hpp"
#include <cstddef>
#include <cstdint>

namespace evil::fluid {

// What each cell gives to its neighbours: left, right, below, above; `diagonal` is all it gives, and more at an open side.
struct LevelView {
    int half, rows, tiles; // cells of a colour in a row; tiles of eight of them
    std::ptrdiff_t stride;
    float* p[2];
    float* b[2];
    const float *weight[2][4], *diagonal[2], *inverse[2]; // inverse: 0 in a solid
    const std::uint8_t* plain[2];                         // by row and tile: are all weights 1?
};

// Pass k of a smoothing goes over the rows from low + k * low_step up to, not including, high + k * high_step. A band that
// gets narrower needs nothing from its neighbours; one that begins empty and gets wider fills the gap between two of them.
struct Band {
    int low, high, low_step, high_step;
};

} // namespace evil::fluid

namespace evil {

// Gauss-Seidel, red then black, `passes` over the rows of a band; they follow each other row by row while the numbers are
// at hand.
EVIL_WIDE(void smooth(const fluid::LevelView& level, int passes, const fluid::Band& band) noexcept;)
// The residual of red cells (black ones have none after a sweep), summed into the coarse level's b; coarse p becomes 0.
EVIL_WIDE(void restrict_rows(const fluid::LevelView& fine, const fluid::LevelView& coarse, int first, int last,
                             float* room) noexcept;)
// The coarse correction, bilinear, to black cells; the sweep that follows makes red ones anew. `mirror`: 1 where a side is
// closed, -1 where it is open: left, right, bottom, top. `room`: for three rows.
EVIL_WIDE(void prolong_rows(const fluid::LevelView& fine, const fluid::LevelView& coarse, const float* mirror,
                            int first, int last, float* room) noexcept;)
// A row as it lies in a field, to a row by colour and back.
EVIL_WIDE(void split_row(const float* row, int half, float* even, float* odd) noexcept;)
EVIL_WIDE(void join_row(const float* even, const float* odd, int half, float* row) noexcept;)

} // namespace evil
