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

// The least box that holds all texels which are not clear; empty, at 0, 0, if there are none.
Box seen_part(const Picture& picture);

// Whether nothing is to be seen of two texels each way in all four corners.
bool corners_are_clear(const Picture& picture);

} // namespace evil::raster
