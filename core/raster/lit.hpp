#pragma once
// The light map at the picture's own resolution, a row at a time, when something lit is first drawn there.
#include "light/light_map.hpp"
#include "raster/target.hpp"
#include <vector>

namespace evil::raster {

struct LightRows { // scratch of one frame
    const light::LightMap* map = nullptr;
    int width = 0, stride = 0;
    std::vector<std::uint32_t> factors;  // as light_up() takes them
    std::vector<bool> ready;             // by row
    std::vector<light::Factors> between; // one row of the map
};

void begin(LightRows& rows, const light::LightMap& map, const Target& target);
const std::uint32_t* row_of(LightRows& rows, int y);

// Sixteen numbers for light_up(), of a run that begins at pixel x, y.
const std::int32_t* dither_at(int x, int y);

} // namespace evil::raster
