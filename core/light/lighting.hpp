#pragma once
// One frame's light: the lights of a scene and the shapes of its world become the light map (SPEC G5, G7).
#include "light/bounce.hpp"
#include "light/casters.hpp"
#include "light/light_map.hpp"
#include "light/lights.hpp"
#include "light/shading.hpp"
#include "light/soak.hpp"

namespace evil::light {

enum class Quality : std::uint8_t { low, medium, high }; // hard shadows; soft ones; and light that surfaces send on

struct Look {
    Quality quality = Quality::medium;
    Rgb ambient{};                   // as on the screen: the light that is everywhere
    float strength = 1;              // of the ambient light
    float depth = 0.5f;              // metres that light soaks into bodies
    float bounce = 1.0f;             // high: how much of the light that falls on them surfaces send on
    float shade = 2.0f;              // high: metres within which bodies keep ambient light away
    int step = 2;                    // pixels a texel
    bool on = false;                 // off: nothing is lit
    bool directed = false;           // something lit has normals
    std::span<const Smoky> smokes{}; // that cast shadows
    bool shadows = true;             // false: every lamp shines through everything
};

struct Scratch { // losing it changes nothing
    Casters casters;
    Haze haze;
    std::vector<Cast> open, shaded; // lamps without and with shadows
    std::size_t open_count = 0, shaded_count = 0;
    std::vector<Block> blocks;
    std::vector<std::uint32_t> holders;  // bodies that a lamp is in
    std::vector<std::uint32_t> housings; // those of all lamps, and those that they are on
    std::vector<Baked> baked;            // by light
    std::vector<std::uint32_t> words;    // of what stands still
    std::vector<float> planes; // red, green, blue: light of open lamps, then of shaded ones; where directed, ways too
    std::vector<std::uint8_t> solid;
    SoakScratch soak[3]; // of light, and of where it comes from
    Bounce bounce;       // its colours are the caller's to find
};

// Lights whose body is gone are removed.
void remove_orphans(Lights& lights, const Slots& bodies);

// `view`: world to pixels of a picture of that size. Allocates nothing once the vectors have grown.
void compute(LightMap& map, Scratch& scratch, const Lights& lights, const Look& look, const World& world,
             const Affine& view, float alpha, int width, int height, Threads& threads);

} // namespace evil::light
