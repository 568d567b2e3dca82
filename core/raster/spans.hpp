#pragma once
// The inner loops of the software renderer: runs of pixels within one row. Integer arithmetic throughout, so every
// instruction set gives the same bits.
#include "math/cpu.hpp"
#include "raster/target.hpp"
#include <cstdint>

namespace evil::raster {

// Colours of a run that change linearly: r, g, b, a as 16.16 fixed point at the first pixel and from one to the next.
struct Ramp {
    std::int32_t start[4], step[4];
    std::int32_t least[4], most[4]; // each channel stays within; 0..255 in 16.16
};

// A walk through one picture in straight steps, one for each pixel of a run.
struct Walk {
    const Pixel* texels = nullptr;
    std::int32_t width = 0, height = 0; // 1..kMaxSide
    // In place: texels in 16.16, kept inside the picture by its edge. Repeated: a whole picture is 2^32.
    bool repeat = false;
    std::uint32_t u = 0, v = 0, du = 0, dv = 0;
};

// Which copies of the loops run.
using Set = InstructionSet;

void fill(Set set, Pixel* to, int count, Pixel colour) noexcept;
void blend_flat(Set set, Pixel* to, int count, Pixel colour) noexcept;
void blend_flat(Set set, Pixel* to, const std::int32_t* mask, int count, Pixel colour) noexcept;
void blend_row(Set set, Pixel* to, const Pixel* from, int count, int cover) noexcept; // cover 0..255
void blend_row(Set set, Pixel* to, const Pixel* from, const std::int32_t* mask, int count) noexcept;
// The other ways in which colours meet (draw::Blend): what they add takes no part in alpha.
void add_row(Set set, Pixel* to, const Pixel* from, const std::int32_t* mask, int count) noexcept;
void multiply_row(Set set, Pixel* to, const Pixel* from, const std::int32_t* mask, int count) noexcept;
void screen_row(Set set, Pixel* to, const Pixel* from, const std::int32_t* mask, int count) noexcept;

// Running sum of `count` cells, a multiple of eight, from `sum` on: 0..255 to mask. Clears the cells; returns the new sum.
std::int32_t integrate(Set set, std::int32_t* cells, int count, std::int32_t sum, std::int32_t* mask) noexcept;

// These write in eights: `to` must have room for `count` rounded up.
void ramp(Set set, Pixel* to, int count, const Ramp& colours) noexcept;
void sample(Set set, Pixel* to, int count, const Walk& walk) noexcept; // bilinear
void modulate(Set set, Pixel* row, const Pixel* by, int count) noexcept;
void modulate_flat(Set set, Pixel* row, int count, Pixel by) noexcept;

// Multiplies with factors of 10 bits a channel, red lowest, of which 512 is one; alpha stays, and no channel exceeds it.
// `dither` holds sixteen numbers of 0..511, those of eight pixels twice: what is rounded away differs from pixel to pixel,
// so that faint light has no steps. Writes in eights, and reads as many factors.
void light_up(Set set, Pixel* row, const std::uint32_t* factors, int count, const std::int32_t* dither) noexcept;

// Such factors of a row of pixels, from three channels of `light::kFactorBits` bits for each texel of a row of the light map:
// between two of those, `weight` 256ths on the way from one to the next. Writes in eights; each channel can be read for eight
// texels more than it has.
struct Columns { // of the pixels
    const std::int32_t *texel, *next, *weight;
    bool near; // eight pixels in a row lie between eight texels
};
void spread_light(Set set, std::uint32_t* to, int count, const std::int32_t* const channels[3],
                  const Columns& columns) noexcept;

// What becomes of such factors by normals (light/light_map.hpp), r, g, b for x, y, z with 128 for zero: x goes along
// (xx, xy) in the picture and y along (yx, yy). Ways are 10 bits a channel, 256 for nowhere. Writes and reads in eights.
struct Turn {
    float xx = 0, xy = 0, yx = 0, yy = 0;
};
struct Ways {
    const std::uint32_t *across, *down;
};
void bend(Set set, std::uint32_t* to, const std::uint32_t* factors, const Ways& ways, const Pixel* normals, int count,
          const Turn& turn) noexcept;

// Adds what shines by itself, `strength` times, as light adds up: on the screen about as squares do. No channel exceeds alpha.
void shine(Set set, Pixel* row, const Pixel* glow, int count, float strength) noexcept;

// round(a * b / 255) for a, b in 0..255.
constexpr int multiply_255(int a, int b) {
    int t = a * b + 128;
    return (t + (t >> 8)) >> 8;
}
constexpr Pixel scale_pixel(Pixel pixel, int by) { // all four channels
    Pixel result = 0;
    for (int shift = 0; shift < 32; shift += 8)
        result |= static_cast<Pixel>(multiply_255(static_cast<int>(pixel >> shift & 255), by)) << shift;
    return result;
}
constexpr Pixel premultiply(Pixel straight) {
    return (scale_pixel(straight, static_cast<int>(straight >> 24)) & 0x00ffffffu) | (straight & 0xff000000u);
}

} // namespace evil::raster
