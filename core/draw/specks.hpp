#pragma once
// Round things by the ten thousand: particles, in a frame's pixels. They need no mesh, so each is a few numbers.
#include "math/vec2.hpp"
#include <cstdint>
#include <vector>

namespace evil::draw {

enum class SpeckForm : std::uint32_t { soft, disc }; // soft: fades from its middle to its rim; disc: a clear edge

struct Speck {            // an ellipse. Layout known to renderer/gl/pipeline.py (SPECK)
    Vec2 at, along;       // middle, and from there to the end of one half axis
    float across = 0.0f;  // length of the other half axis
    std::uint32_t colour; // straight, as draw::Rgba8
};
static_assert(sizeof(Speck) == 24);

struct SpeckRun { // specks of one look, drawn before an instance of the list
    std::uint32_t before = 0;
    std::uint32_t first = 0, count = 0;
    SpeckForm form = SpeckForm::soft;
    bool adds = false; // light is added to what is behind, rather than covering it
};

struct Specks {
    std::vector<Speck> rows;
    std::vector<SpeckRun> runs; // `before` never falls

    void clear() { rows.clear(), runs.clear(); }
};

} // namespace evil::draw
