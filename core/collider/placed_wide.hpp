#pragma once
#include "math/cpu.hpp"
#include <cstddef>
#include <cstdint>

namespace evil {

struct PlacingRows { // tables of eight floats a row, each row aligned to 32 bytes
    const float* bodies;
    std::uint32_t body_rows; // rows of a body; the first two are read
    const float* forms;
    const std::uint32_t* owners; // by piece: its body
    float* placed;               // two rows a piece
    float *low_x, *low_y, *high_x, *high_y;
    std::int32_t* octaves;
    std::uint32_t pieces;
    float dt, margin;
};

// Pieces first..last, in eights; writes whole eights. `pieces` is how many there are.
EVIL_WIDE(void place_pieces(const PlacingRows& rows, std::size_t first, std::size_t last) noexcept;)

} // namespace evil
