#pragma once
// The debug view of light: what shines, how far, and where the shadows of bodies begin and end.
#include "draw/overlay.hpp"
#include "light/casters.hpp"
#include "light/lights.hpp"

namespace evil::draw {

struct LightInks {
    Rgba8 lamp, umbra, penumbra;
};

struct LightFrame {
    const Overlay& overlay;
    const World& world;
    const Affine& view; // world to pixels
    float alpha;        // 0..1 between the last two steps
    float points;       // pixels of a logical point
    LightInks inks;
};

// Returns how many lights are on. `casters`: scratch.
int draw_lights(const LightFrame& frame, const light::Lights& lights, light::Casters& casters);

} // namespace evil::draw
