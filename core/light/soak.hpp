#pragma once
// Light soaks into bodies: it falls on the sides that face it and fades within them, as on a cut face that one looks at.
//
// A texel in a body takes the mean of the light in the air round it; deep inside there is little air near, and it is dark.
// With w for the air's share of a neighbourhood, a texel becomes (sum of light in its air) / max(w, 1/2): on a straight
// side, where w is 1/2, all of the light; at depth d, (1 - d / depth)^2 of it.
//
// The mean is taken twice over a square, along rows and then down columns. All four passes go down the map together, each a
// few rows ahead of the next, so that what one leaves is still in the cache when the other takes it.
#include "math/cpu.hpp"
#include <cstdint>
#include <span>
#include <vector>

namespace evil::light {

struct Soft { // a texel's light and how much of it is air
    float red, green, blue, air;
};

struct Spread {              // scratch of one mean
    std::vector<Soft> rows;  // means along them, until all of their column's window are there
    std::vector<Soft> fresh; // rows of which the mean is taken next
    std::vector<Soft> sums;  // of the windows of one row
};

struct SoakScratch {
    Spread first, second;
    std::vector<Soft> row;
};

// Adds three planes to three others, of rows `width` long, a multiple of eight: light as it is in the air, and soaked into what is `solid`.
// `reach`: texels to where the light has faded, at least 1.
void add_soaked(float* const to[3], const float* const from[3], std::span<const std::uint8_t> solid, int width,
                int height, int reach, InstructionSet set, SoakScratch& scratch);

} // namespace evil::light
