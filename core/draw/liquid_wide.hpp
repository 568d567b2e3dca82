#pragma once
#include "math/cpu.hpp"

namespace evil {

namespace draw {

inline constexpr int kTones = 256; // entries of a liquid's table
inline constexpr int kWaves = 3;
inline constexpr int kMostKinds = 16;

struct LiquidShade {                    // one row of texels: what its colours come from, and where they go
    const float *depth, *above, *below; // texels inside: of this row, and of its neighbours
    const float *wall, *bulk, *weight;  // texels to what bounds it; how much liquid is near; particles
    int kinds;                          // of liquids
    const float* shares[kMostKinds];    // of `weight`, of each liquid but the first
    const float* tables;                // of each liquid six channels of kTones
    struct {
        const float *sines, *cosines; // by column
        float sine, cosine, size;     // of the row
    } waves[kWaves];
    const float* darkness; // of cells
    int cells_across, cells_down;
    float cell_x, cell_y, cell_x_step, cell_y_step; // where the first texel lies in them, and from one to the next
    float lens, waver, rim, step, under, bulge;
    float up_x, up_y;
    float* to[10]; // the map's planes
};

} // namespace draw

// clang-format off
EVIL_WIDE(
// The mean of five with weights 1 4 6 4 1, `apart` floats apart; the first one stands at from[0]. Works in eights.
void mean_of_five_wide(const float* from, int apart, float* to, int count) noexcept;
void mean_of_rows_wide(const float* const rows[5], float* to, int count) noexcept;
// Of one row of texels: how far inside the particles' means say that each is, in texels, and that as a share of it.
void sharp_wide(const float* weight, const float* x, const float* y, float row, float one, float* sharp, float* whole,
                int count) noexcept;
// The smooth surface where there is much liquid, the sharp one where there is little.
void join_wide(const float* sharp, const float* smooth, const float* bulk, float* to, int count) noexcept;
// Texels from `first` on, which have neighbours on either side. Works in eights.
void shade_liquid_wide(const draw::LiquidShade& row, int first, int count) noexcept;)
// clang-format on

} // namespace evil
