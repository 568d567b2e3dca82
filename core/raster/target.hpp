#pragma once
// The picture that is drawn into.
#include <cstddef>
#include <cstdint>

namespace evil::raster {

// Bytes r, g, b, a in memory, colours multiplied with alpha. Where a picture is opaque, as a game's frame is, that is the
// same as straight colour.
using Pixel = std::uint32_t;

// Of a level of brightness, where pictures are spread out: four times 255 of them are less than 2^16.
inline constexpr int kParts = 64; // known to renderer/shaders/deep.glsl

struct Target {
    Pixel* pixels = nullptr; // rows from the top
    int width = 0, height = 0;
    int stride = 0; // pixels from one row to the next: more than the width for a part of a larger picture
};

inline constexpr int kMaxSide = 16384; // pixels; a position in 24.8 fixed point times a slope still fits 64 bits

inline Pixel* row_of(const Target& target, int y) {
    return target.pixels + static_cast<std::size_t>(y) * static_cast<std::size_t>(target.stride);
}

struct Box { // whole pixels: left and top are inside, right and bottom are not
    int left = 0, top = 0, right = 0, bottom = 0;
};

} // namespace evil::raster
