#pragma once
// What happens between the instances of a frame: specks, and what is done to all that has been drawn so far.
#include "draw/blend.hpp"
#include "draw/liquid_map.hpp"
#include "draw/post.hpp"
#include "draw/specks.hpp"
#include <cstdint>
#include <vector>

namespace evil::draw {

enum class InterludeKind : std::uint8_t { specks, blur, shafts, liquid, post };

struct Shafts {                                            // of light, from what is bright
    Vec2 from;                                             // pixels: which point they go away from
    std::uint32_t colour = 0xffffffffu;                    // straight; with alpha as how strong they are
    float strength = 1.0f, reach = 1.0f, threshold = 0.5f; // reach: how much of the way to that point a pixel sees
};

struct Interlude {
    std::uint32_t before = 0; // index of the instance that follows it
    InterludeKind kind = InterludeKind::specks;
    std::uint32_t first = 0, count = 0; // rows of specks; or which shafts, or liquid
    SpeckForm form = SpeckForm::soft;
    Blend blend = Blend::over; // how the specks meet what is behind
    bool lit = false;          // the specks are in the light
    float radius = 0.0f;       // of a blur, in pixels
};

struct Interludes {
    std::vector<Interlude> rows; // in the order in which they are done: `before` never falls
    std::vector<Speck> specks;
    std::vector<Shafts> shafts;
    std::vector<LiquidMap> liquids; // the first `liquid_count` of them; others keep their memory
    std::uint32_t liquid_count = 0;
    Post post; // of the one of that kind, if there is one

    void clear() { rows.clear(), specks.clear(), shafts.clear(), liquid_count = 0; }
};

} // namespace evil::draw
