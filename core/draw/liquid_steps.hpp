#pragma once
// The steps from particles to a map, one file a subject; draw/liquid.cpp takes them in turn.
#include "draw/liquid.hpp"
#include "world.hpp"

namespace evil::draw {

inline constexpr float kFarOff = 1e6f; // texels: what is beyond is nowhere, as is what is no number

struct LiquidGrid {                        // of the map's texels
    int width = 0, height = 0, stride = 0; // rows have room for eights
    Affine to_texel;                       // from the world; a texel's middle lies at .5
    float scale = 1.0f;                    // texels a metre
    float one = 1.0f;                      // what a weight is multiplied with so that a full one is 1
    std::size_t size() const { return static_cast<std::size_t>(stride) * height; }
};

// liquid_field.cpp: where the surface is.
void sum_particles(LiquidScratch& scratch, const Sea& sea, const LiquidGrid& grid, std::size_t liquids,
                   InstructionSet set);
void find_sharp(LiquidScratch& scratch, const LiquidGrid& grid, InstructionSet set);
void fill_gaps(LiquidScratch& scratch, const LiquidGrid& grid, InstructionSet set);
void find_surface(LiquidScratch& scratch, const LiquidGrid& grid, InstructionSet set);

// liquid_solids.cpp: what bounds it, and what swims in it.
void find_solids(LiquidScratch& scratch, const Sea& sea, const LiquidGrid& grid, const World& world, float alpha);
void fill_solids(LiquidScratch& scratch, const LiquidGrid& grid, bool upright);
void fill_shares(LiquidScratch& scratch, const LiquidGrid& grid); // is up in the picture rather up or down?

// liquid_depth.cpp: how far from the air it is.
struct LiquidDepths { // coarse, in the world's axes
    int width = 0, height = 0;
    Vec2 low;
    float cell = 1.0f;
};
LiquidDepths find_depths(LiquidScratch& scratch, const Sea& sea, float clarity, const World& world, float alpha);
float darkness_at(const LiquidScratch& scratch, const LiquidDepths& depths,
                  Vec2 cell); // 0 at the surface, 1 in the deep

} // namespace evil::draw
