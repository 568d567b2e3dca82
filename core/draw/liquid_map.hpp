#pragma once
// A liquid as renderers are given it: a map coarser than the picture, of how far inside the liquid a texel is, how far what
// lies behind is displaced, what share of it comes through, and what colour the liquid adds. Both renderers do the same sums:
//
//     inside = clamp(depth + 0.5)                            depth by cubic B-splines, the rest by straight lines
//     seen   = behind(here + away) * through + (own + rim * (1 - depth / rim_width)^2) * light
//     pixel  = behind(here) + inside * (seen - behind(here))
#include "math/vec2.hpp"
#include <array>
#include <cstdint>
#include <vector>

namespace evil::draw {

enum LiquidPlane : std::uint8_t { // of a map
    kDepth,                       // pixels that a texel's middle is inside the liquid; less than 0: outside
    kAwayX,
    kAwayY, // pixels from which what lies behind is seen
    kRim,   // 0..1: how bright the surface's line is
    kThroughRed,
    kThroughGreen,
    kThroughBlue, // 0..1
    kOwnRed,
    kOwnGreen,
    kOwnBlue, // 0..1
    kLiquidPlanes
};

struct LiquidMap {
    int width = 0, height = 0, stride = 0; // texels; rows may be read in eights
    float step = 2.0f;                     // pixels from texel to texel, two at the least
    Vec2 first;             // pixels: where the middle of the first texel lies, which may be outside the picture
    float rim_width = 1.0f; // pixels
    int reach = 0;          // pixels: nothing is displaced farther
    bool lit = false;       // its own colour is multiplied with the light map, where that is on
    std::array<std::vector<float>, kLiquidPlanes> planes; // rows from the top
};

} // namespace evil::draw
