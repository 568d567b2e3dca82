#pragma once
// Light soaks into bodies: it falls on the sides that face it and fades within them, as on a cut face that one looks at.
//
// A texel in a body takes the mean of the light in the air round it; deep inside there is little air near, and it is dark.
// With w for the air's share of a neighbourhood, a texel becomes (sum of light in its air) / max(w, 1/2): on a straight
// side, where w is 1/2, all of the light; at depth d, (1 - d / depth)^2 of it.
#include "threads.hpp"
#include <cstdint>
#include <span>
#include <vector>

namespace evil::light {

struct Soft { // a texel's light and how much of it is air
    float red, green, blue, air;
};

// `reach`: texels to where the light has faded, at least 1. Texels that are not solid stay as they are.
void soak(std::span<Soft> texels, std::span<const std::uint8_t> solid, int width, int height, int reach,
          std::vector<Soft>& blurred, std::vector<Soft>& other, Threads& threads);

} // namespace evil::light
