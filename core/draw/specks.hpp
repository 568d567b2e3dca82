#pragma once
// Round things by the ten thousand: particles, in a frame's pixels. They need no mesh, so each is a few numbers.
#include "math/vec2.hpp"
#include <cstdint>

namespace evil::draw {

enum class SpeckForm : std::uint32_t { soft, disc }; // soft: fades from its middle to its rim; disc: a clear edge

struct Speck {            // an ellipse. Layout known to renderer/gl/pipeline.py (SPECK)
    Vec2 at, along;       // middle, and from there to the end of one half axis
    float across = 0.0f;  // length of the other half axis
    std::uint32_t colour; // straight, as draw::Rgba8
};
static_assert(sizeof(Speck) == 24);

} // namespace evil::draw
