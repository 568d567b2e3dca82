#pragma once
// Specks in software: each pixel by its distance from the middle.
#include "draw/interludes.hpp"
#include "raster/bands.hpp"
#include "raster/spans.hpp"
#include <span>

namespace evil::raster {

struct SpeckPaint { // one of them, cut to the target; u and v are 1 on its rim
    Box box;
    Rows rows;                // which of its rows are drawn
    float u, v;               // at the middle of the box's first pixel
    float u_x, v_x, u_y, v_y; // from a pixel to the next, right and down
    float along, across;      // one over the half axes, in pixels
    bool disc = false;
    draw::Blend blend = draw::Blend::over;
    Pixel colour = 0; // multiplied with alpha
};

// Which rows one may touch, and somewhat more.
Rows reach_of(const draw::Speck& speck, int height);

// Those of the run that may touch a band, as far as they lie in its rows.
void draw_specks(std::span<const draw::Speck> specks, const draw::Interlude& run, const Bins& bins, std::size_t band,
                 const Rows& rows, const Target& target, Set set);

} // namespace evil::raster
