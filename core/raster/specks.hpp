#pragma once
// Specks in software: each pixel by its distance from the middle.
#include "draw/interludes.hpp"
#include "raster/spans.hpp"
#include <span>

namespace evil::raster {

struct SpeckPaint { // one of them, cut to the target; u and v are 1 on its rim
    Box box;
    float u, v;               // at the middle of the box's first pixel
    float u_x, v_x, u_y, v_y; // from a pixel to the next, right and down
    float along, across;      // one over the half axes, in pixels
    bool disc = false;
    draw::Blend blend = draw::Blend::over;
    Pixel colour = 0; // multiplied with alpha
};

void draw_specks(std::span<const draw::Speck> specks, const draw::Interlude& run, const Target& target, Set set);

} // namespace evil::raster
