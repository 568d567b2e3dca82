#pragma once
// The picture that is drawn into.
#include <cstddef>
#include <cstdint>

namespace evil::raster {

// Bytes r, g, b, a in memory, colours multiplied with alpha. Where a picture is opaque, as a game's frame is, that is the
// same as straight colour.
using Pixel = std::uint32_t;

struct Target {
    Pixel* pixels = nullptr; // rows from the top, without gaps
    int width = 0, height = 0;
};

inline constexpr int kMaxSide = 16384; // pixels; a position in 24.8 fixed point times a slope still fits 64 bits

inline Pixel* row_of(const Target& target, int y) {
    return target.pixels + static_cast<std::size_t>(y) * static_cast<std::size_t>(target.width);
}

struct Box { // whole pixels: left and top are inside, right and bottom are not
    int left = 0, top = 0, right = 0, bottom = 0;
};

} // namespace evil::raster
