#pragma once
// A staggered grid of square cells (Harlow and Welch 1965): velocities live on the faces between cells, all else in their
// middle.
//
//        +---v---+---v---+        u of cell (i, j) is on its left side, v on its lower one; the last column has one more u,
//        |       |       |        the last row one more v. Cell (0, 0) is at the lower left.
//        u   c   u   c   u
//        |       |       |        An array has a row for each j, `stride` floats apart, and a rim round it, so that what
//        +---v---+---v---+        lies one beyond an edge may be read.
#include "math/vec2.hpp"
#include <cstddef>
#include <vector>

namespace evil::fluid {

inline constexpr int kLeastCells = 2, kMostCells = 2048; // each way
inline constexpr int kRim = 8;                           // floats before the first: eight keep rows aligned

struct Grid {
    int nx = 0, ny = 0;
    int stride = 0; // of rows, in floats: a multiple of 8
    Vec2 low;       // metres: the lower left corner
    float h = 1.0f; // metres: the side of a cell

    std::size_t cells() const { return static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny); }
    std::ptrdiff_t at(int i, int j) const { return static_cast<std::ptrdiff_t>(j) * stride + i; }
};

inline Grid grid_of(int nx, int ny, Vec2 low, float h) { return {nx, ny, (nx + 2 + 7) / 8 * 8, low, h}; }

// Numbers on a grid: cells 0..nx-1 by 0..ny-1, and faces up to nx or ny; from -1 to there all may be read.
class Field {
public:
    void lay_out(const Grid& grid) {
        stride_ = grid.stride;
        values_.assign(static_cast<std::size_t>(grid.stride) * static_cast<std::size_t>(grid.ny + 3) + 2 * kRim, 0.0f);
    }
    bool empty() const { return values_.empty(); }
    void clear() { values_.assign(values_.size(), 0.0f); }
    float* data() { return values_.data() + kRim + stride_; } // of (0, 0)
    const float* data() const { return values_.data() + kRim + stride_; }
    float& operator[](std::ptrdiff_t at) { return data()[at]; }
    float operator[](std::ptrdiff_t at) const { return data()[at]; }
    void swap(Field& other) noexcept {
        values_.swap(other.values_);
        std::swap(stride_, other.stride_);
    }

private:
    std::vector<float> values_;
    int stride_ = 0;
};

} // namespace evil::fluid
