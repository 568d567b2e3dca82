#pragma once
// What the inner loop of lighting is given: lamps and casters in the light map's own coordinates, a texel long.
//
// A lamp is a disc. From a point p it is seen as a line across the way to its middle, and a convex caster hides one interval
// of that line, which its two tangents through p bound. What is seen is what the union of the intervals leaves: umbra is
// exactly 0, full light exactly 1, and the half shadow between is as wide as it should be, however many casters there are.
//
//        lamp
//       --===--        the line; = is hidden
//         \ \          .
//          \|\         .   tangents
//          [ ] caster
//            \\        .
//             p
#include "math/transform.hpp"
#include "math/vec2.hpp"
#include <cstdint>

namespace evil::light {

struct Caster { // convex: `count` corners in order, either way round, or a circle round `middle`
    Vec2 middle;
    float radius = 0.0f;     // of the circle, or of one round all corners
    std::uint32_t first = 0; // of its corners
    std::uint32_t count = 0; // none: a circle
    std::uint32_t body = 0, category = 1;
    bool still = false; // of a static body
};
static_assert(sizeof(Caster) == 8 * sizeof(float), "shade_wide.cpp reads eight at a time");

struct Lamp {
    Vec2 at;            // its middle. Of a sun: unused
    Vec2 way;           // of length 1: where a spot or a sun shines to
    float size = 0.0f;  // half the line's length; of a sun, at kFar
    float reach = 0.0f; // to where it ends
    int quarters = 8;   // of the falloff's exponent
    bool parallel = false, spot = false;
    float cone_middle = 0.0f, cone_slope = 0.0f; // a spot's share of light is (cosine - middle) * slope, within 0..1
    float glow[3] = {};                          // linear
    float height = 0.0f;                         // before the picture
    // What it shines through: linear light, by rows; null: nothing. A sun's picture repeats, a lamp's is dark beyond its
    // edge. Where in it a texel lies, with its first texel's middle at 0.
    const float* slide[3] = {};
    int slide_width = 0, slide_height = 0;
    Affine to_slide;
};

inline constexpr float kFar = 65536.0f; // texels to a sun: further than a map is wide, near enough for floats

struct Planes { // rows of floats, `stride` apart: red, green, blue
    float* light[3];
    float *across[3], *down[3]; // null, or the sums of light times the way that it comes from
};

inline constexpr int kPatch = 8; // texels: a patch is as wide as the kernel's lanes, and as high

struct Patch { // eight texels wide, `rows` high
    int x, y, rows, stride;
};

// The share of a lamp's light at each texel of a patch, before its colour: rows `stride` apart.
struct Shares {
    float* at;
    int stride;
};

inline constexpr float kUnknown = -1.0f; // a share that has not been worked out

struct Hidden { // scratch of one texel row of a patch: where the intervals begin and end, eight lanes each
    float from[8], to[8];
};

struct Square { // of texels; those below the map's last row are none
    int x, y, side;
    float half() const { return 0.5f * static_cast<float>(side); }
    Vec2 middle() const { return {static_cast<float>(x) + half(), static_cast<float>(y) + half()}; }
    float radius() const { return 1.41421356f * half(); } // to its corners
};

struct Strip {        // between a disc of texels and a lamp
    Vec2 from, along; // of length 1
    float distance, radius, widening;
};

struct Outline { // of a caster on the lamp's line, over the texels of a square: where it begins and ends
    float from_least, from_most, to_least, to_most;
};

struct Near { // casters that matter to a patch
    const Caster* casters;
    const Vec2* corners;
    const std::uint32_t* which;
    int count;
    Hidden* hidden; // has room for each
};

} // namespace evil::light
