#pragma once
// Pictures to draw from, with smaller copies for drawing them small.
#include "raster/target.hpp"
#include <cstdint>
#include <vector>

namespace evil::raster {

struct Picture {
    int width = 0, height = 0;
    std::vector<Pixel> texels;
};

struct Texture {                 // none: an id that was released, or never given out
    std::vector<Picture> levels; // each half as wide and high as the one before, down to one texel
};

// From width * height * 4 bytes of straight r, g, b, a. Sides are 1..kMaxSide.
Texture make_texture(const std::uint8_t* straight, int width, int height);

} // namespace evil::raster
