#pragma once
// What becomes of the whole picture before text goes over it: bloom, tones, colours, vignette, grain.
#include <array>
#include <cstdint>

namespace evil::draw {

inline constexpr int kTones = 1024; // entries a channel: bloom adds up to three times white

struct Grading { // what the table of tones comes from
    float exposure = 1.0f, contrast = 1.0f;
    bool filmic = false;
    float tint[3] = {1, 1, 1};
    friend bool operator==(const Grading&, const Grading&) = default;
};

struct Post {
    float bloom = 0.0f;     // how much of what is bright is spread over its neighbours
    float threshold = 0.7f; // 0..1: what is darker does not shine
    float saturation = 1.0f, vignette = 0.0f, grain = 0.0f;
    std::uint32_t seed = 0; // of the grain, another each step
    Grading grading;
    bool graded = false;                   // the table is there
    std::array<float, 4 * kTones> table{}; // r, g, b, unused: 0..255 for a sum of light 0..1023, where 255 is white
};

// Fills the table. The filmic curve is Narkowicz's fit to ACES (2015), which bends what is brighter than white into reach.
void grade(Post& post, const Grading& grading);

} // namespace evil::draw
