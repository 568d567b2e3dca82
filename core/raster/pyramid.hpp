#pragma once
// Pictures that are spread out: halved again and again and then doubled, with a blend at each step ("dual filtering",
// Bjorge 2015; the blend of each step as in Jimenez 2014). A wide blur costs hardly more than a narrow one.
#include "draw/interludes.hpp"
#include "raster/bands.hpp"
#include "raster/shafts.hpp"
#include "raster/spans.hpp"
#include <vector>

namespace evil::raster {

struct Pyramid { // scratch: the picture's halves, quarters, ...
    struct Level {
        int width = 0, height = 0;
        std::vector<std::uint32_t> pixels; // rows of Deep, red and blue first, padded to whole lanes and a lane more
        std::size_t stride = 0;
    };
    struct Lines {                                // of one row, by band
        std::vector<std::uint32_t> between, glow; // of Deep
        std::vector<Pixel> full, other;
        std::vector<std::int32_t> mask;
    };
    std::vector<Level> levels;
    std::vector<Lines> lines;
    ShaftScratch shafts;
};

// How far down a blur of that many pixels goes, and how much of the lowest level there is in the one above it.
struct Depth {
    int levels = 0;
    float share = 0.0f; // 0..1
};
Depth depth_of(float radius);

inline constexpr int kBloomLevels = 6;

void blur(const Target& target, float radius, Pyramid& pyramid, const Bands& bands, Set set);
void shine(const Target& target, const draw::Shafts& shafts, Pyramid& pyramid, const Bands& bands, Set set);
void finish(const Target& target, const draw::Post& post, Pyramid& pyramid, const Bands& bands, Set set);

} // namespace evil::raster
