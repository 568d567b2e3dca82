#pragma once
// What smoke does to light: it takes some away, the more the thicker it is and the longer the way through it (Beer's law).
//
// Each lamp's light is followed outwards over a grid of the light map's texels by fours, ring after ring: on its way from the
// ring before it meets a texel's smoke. What a texel had is shared between the two that its light goes on to, so shadows
// grow softer with the way, and each texel costs the same, however much smoke there is.
#include "light/shade.hpp"
#include "world.hpp"
#include <span>
#include <vector>

namespace evil::light {

inline constexpr int kHazeStep = 4;

struct Smoky {               // a smoke that takes light away
    std::uint32_t smoke = 0; // its slot
    float shadow = 0.0f;     // share of a metre's light, small shares, at a density of 1
};

struct Haze {                                     // scratch of a frame
    int width = 0, height = 0;                    // in texels of four times the light map's side
    int left = 0, top = 0, right = 0, bottom = 0; // where there is any; right and bottom are not in it
    std::vector<float> thickness;                 // what is lost on the way straight through a texel, small shares
    std::vector<float> lost;                      // of one lamp
};

// False: no smoke is to be seen.
bool find_haze(Haze& haze, std::span<const Smoky> smokes, const World& world, const Affine& to_texel, int width,
               int height);

struct Veil { // the share of a lamp's light that comes through
    int width = 0, height = 0;
    std::vector<float> shares; // empty: all of it
};
void find_veil(Veil& veil, Haze& haze, const Lamp& lamp);

// Shares of a patch, times what comes through. False: all of it does, and nothing was written.
bool put_veil(const Veil& veil, const Patch& patch, const Shares& from, float* to);

} // namespace evil::light
