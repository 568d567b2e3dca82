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

// What a surface does with light that falls on it aslant, by a picture of its normals: the map also holds, for each channel,
// where the light comes from, as the mean over all light of the unit vectors towards it, right and down in the picture
// (directional lightmaps: McTaggart 2004, "Half-Life 2 / Valve Source Shading"; here one vector a channel, so that lamps of two
// colours each light their own side). With n for the normal and D for that mean, a surface gets
//
//     max(0, n.z + kSlant (n.x D.x + n.y D.y))      of the light
//
// which is Lambert's law for lamps that stand well before the picture, divided by what a flat surface gets: (0, 0, 1) gets
// exactly the map's light. Ambient light comes from where one looks from.
inline constexpr float kSlant = 1.5f; // cotangent of how high a far lamp stands before the picture: 34 degrees
inline constexpr float kHeight =
    0.125f; // how far a lamp stands before it, of its radius: what is near is lit from the front

struct LightMap {          // result: valid for one frame
    bool on = false;       // off: lit things are drawn as they are
    bool directed = false; // whether `across` and `down` are there
    int width = 0, height = 0;
    float step = 1.0f; // pixels from texel to texel
    Vec2 first;        // pixels: where the centre of the first texel lies; at most half a step inside the picture
    std::vector<Factors> texels; // rows from the top
    std::vector<Factors> across,
        down; // the same for where light comes from: 0 is -1, kFactorOne / 2 nowhere, kFactorOne 1
};

} // namespace evil::light
