#pragma once
// Shafts of light: what is bright shines on towards the eye, away from a point of the picture, and dark things before it
// throw long shadows (after Mitchell, "Volumetric Light Scattering as a Post-Process", GPU Gems 3, chapter 13, 2007).
//
// Each pixel takes the mean of what is bright on the way from it to that point. That is done at a quarter of the size,
// and in passes of a few samples each, of which every one sees what the one before it has gathered (Sousa, "Crysis Next
// Gen Effects", GDC 2008): three of five are as good as 125.
#include "draw/interludes.hpp"
#include "raster/bands.hpp"
#include <cstdint>
#include <vector>

namespace evil::raster {

inline constexpr int kShaftPasses = 3, kShaftTaps = 5; // known to renderer/gl/filters.py
inline constexpr float kShaftFade = 2.0f;              // how much less what is farther off counts

struct ShaftTaps { // of one pass: shares of the way to the point, and how much each counts, which together is 1
    float at[kShaftTaps], weight[kShaftTaps];
};
ShaftTaps shaft_taps(float reach, int pass);

struct ShaftScratch { // losing it changes nothing
    std::vector<std::uint16_t> bright, gathered;
    std::vector<std::int32_t> first; // of a pass, by tap and column
    std::vector<float> part;
    struct Lines { // of one row, by band
        std::vector<float> row, sum;
    };
    std::vector<Lines> lines;
};

struct Greys { // one number a pixel, in parts of a level: 0 to 255 * kParts
    std::uint16_t* values;
    int width, height;
};

// One pass, from one plane into another of that size. `from` is in their pixels.
void gather(const Greys& above, const Greys& to, Vec2 from, const ShaftTaps& taps, ShaftScratch& scratch,
            const Bands& bands);

struct Glow { // what each part of a plane adds, 0..1 and more
    float red, green, blue;
};
Glow glow_of(const draw::Shafts& shafts);

// How bright a channel of the picture is beyond the threshold; both in parts of a level.
std::uint16_t beyond(std::uint32_t channel, float threshold);

} // namespace evil::raster
