#pragma once
// What liquid looks like: particles become one smooth surface, as deep and as clear as the liquid is.
//
// Where the surface is: on a grid of half a particle's spacing, each texel knows the mean position of the particles round it,
// weighted by a bell; it is inside if that is near (Zhu and Bridson, "Animating Sand as a Fluid", 2005, 4). So a single drop
// is round, and what matters is where particles are, not how densely they happen to lie. That is then smoothed as surface
// tension does (Merriman, Bence and Osher 1992: blur what is inside, and cut at one half) where there is much liquid, but
// not where it is thin: a pool's line is straight, and a jet stays whole.
//
// How deep it is: the share of air round a place, in which air counts less the farther it is: a flat surface's own depth
// goes as 1 - exp(-depth / clarity), and thin things are clear all through.
#include "draw/liquid_map.hpp"
#include "light/casters.hpp"
#include "math/transform.hpp"
#include <cstdint>
#include <span>

namespace evil::draw {

inline constexpr int kLiquidTable = 64;
inline constexpr int kMostLiquids = 16;

using LiquidTable =
    std::array<std::array<float, 6>, kLiquidTable>; // through and own colour, from the surface to the deep

struct Sea {                            // what there is of it; all spans as long as each other
    std::span<const Vec2> at, velocity; // metres, m/s
    std::span<const std::uint8_t> kind; // which liquid; empty: all the first
    float spacing = 0.1f;               // metres between particles
    Vec2 low, high;                     // its area
    std::array<bool, 4> closed{};       // is there a wall: left, right, bottom, top
};

struct LiquidLook {
    std::vector<LiquidTable> tables; // by liquid
    float clarity = 1.0f;            // metres down to where a third of the light is left
    float refraction = 1.0f;         // how far what lies behind is displaced
    float rim = 1.0f;                // 0..1: how bright the surface's line is
    float waves = 1.0f;              // how much the light wavers inside
    bool lit = true;
};

struct LiquidView { // of one frame
    Affine to_pixel;
    int width, height; // pixels
    float points;      // pixels of a logical point
    float back;        // seconds that particles are shown before where they are
    double time;       // seconds, for the waves
    Vec2 up;           // in the world, of length 1, or 0 without gravity
};

struct LiquidScratch {                                            // losing it changes nothing
    std::vector<Vec2> at;                                         // in texels
    std::vector<std::uint32_t> near;                              // particles that matter
    std::vector<float> sums, other, row;                          // weight, moments: four a texel
    std::vector<std::vector<float>> shares;                       // of each liquid but the first
    std::vector<float> sharp, whole, smooth, weight, bulk, known; // a texel each
    std::vector<float> wall, solid;                               // distances to what bounds it, and to anything solid
    std::vector<std::vector<float>> means, weights;               // of the pyramid that fills what is hidden by solids
    std::vector<float> air, darkness;                             // coarse, over all of the liquid
    std::vector<std::uint8_t> filled;
    std::vector<float> waves, tables;
    light::Casters casters;
};

// Fills the map; false if nothing of the liquid is to be seen. Allocates nothing once the vectors have grown.
bool map_liquid(LiquidMap& map, LiquidScratch& scratch, const Sea& sea, const LiquidLook& look, const LiquidView& view,
                const World& world, float alpha);

} // namespace evil::draw
