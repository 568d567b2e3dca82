#pragma once
// The light map at the picture's own resolution, a row at a time, when something lit is first drawn there.
#include "light/light_map.hpp"
#include "raster/bands.hpp"
#include "raster/spans.hpp"
#include "raster/target.hpp"
#include <vector>

namespace evil::raster {

struct LightRows { // scratch of one frame
    struct Plane {
        const std::vector<light::Factors>* texels = nullptr;
        std::vector<std::uint32_t> factors; // 10 bits a channel, red lowest
        std::vector<std::uint8_t> ready;    // by row; not bits, as rows next to each other are of several threads
    };
    struct Between { // red, green and blue of one row of the map
        std::vector<std::int32_t> channel[3];
    };
    const light::LightMap* map = nullptr;
    int width = 0, stride = 0;
    Plane light, across, down;                     // as light_up() and bend() take them
    std::vector<Between> between;                  // by band
    std::vector<std::int32_t> texel, next, weight; // where in that row each column of the picture lies
};

void begin(LightRows& rows, const light::LightMap& map, const Target& target, const Bands& bands);
// A row of one of its planes, for the band that it is in.
const std::uint32_t* row_of(LightRows& rows, LightRows::Plane& plane, int y, std::size_t band, Set set);

// Sixteen numbers for light_up(), of a run that begins at pixel x, y.
const std::int32_t* dither_at(int x, int y);

} // namespace evil::raster
