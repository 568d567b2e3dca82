#pragma once
// A liquid's map on the picture (draw/liquid_map.hpp says the sums).
#include "draw/liquid_map.hpp"
#include "raster/bands.hpp"
#include "raster/lit.hpp"
#include "raster/spans.hpp"
#include <array>
#include <vector>

namespace evil::raster {

struct LiquidScratch {                      // losing it changes nothing
    std::vector<Pixel> behind;              // the picture before
    std::vector<std::vector<float>> texels; // by band: planes of one row of pixels, still a texel each
    std::vector<std::int32_t> column;       // by pixel: the texel on its left
    std::vector<float> part;                // by pixel: how far on the way to the next one
    std::vector<float> cubic;               // by pixel: four weights, a row of them each
};

struct LiquidRow { // what the inner loop is told of one row of pixels
    const float* planes[draw::kLiquidPlanes];
    const std::int32_t* column;
    const float* part;
    const float* cubic[4];
    const std::uint32_t* light; // null, or factors of 10 bits a channel, 512 for one
    const Pixel* behind;
    int width, top, bottom; // of what lies behind: pixels a row, and which rows
    int y;
    float rim; // one over the width of the bright line
};

void draw_liquid(const draw::LiquidMap& map, const Target& target, LightRows* light, LiquidScratch& scratch,
                 const Bands& bands, Set set);

} // namespace evil::raster
