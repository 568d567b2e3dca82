#pragma once
// How bright the picture is, on a grid coarser than its pixels: what both renderers multiply lit things with.
//
// Lights add up in linear light, and what is drawn is multiplied in linear light too. As colour is linear light to the power
// of kToScreen, (c^g * L)^(1/g) = c * L^(1/g): the map holds L to that power, and a pixel needs one product a channel.
#include "math/vec2.hpp"
#include <cstdint>
#include <vector>

namespace evil::light {

inline constexpr double kToScreen = 29.0 / 64.0; // 1 / 2.207: a chain of square roots gives it, the same everywhere

// Three factors of 0 to just under 2 in units of 1/4096, blue lowest, 21 bits apart: so that a sum of two, weighted in
// 256ths, is one multiplication for all three.
using Factors = std::uint64_t;
inline constexpr int kFactorBits = 13, kFactorOne = 1 << 12, kFactorApart = 21;
inline constexpr Factors kFactorMask = (Factors{1} << kFactorBits) - 1;
inline constexpr Factors kAllFactors = kFactorMask | kFactorMask << kFactorApart | kFactorMask << 2 * kFactorApart;

struct LightMap {    // result: valid for one frame
    bool on = false; // off: lit things are drawn as they are
    int width = 0, height = 0;
    float step = 1.0f; // pixels from texel to texel
    Vec2 first;        // pixels: where the centre of the first texel lies; at most half a step inside the picture
    std::vector<Factors> texels; // rows from the top
};

} // namespace evil::light
