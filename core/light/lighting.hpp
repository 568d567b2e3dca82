#pragma once
// One frame's light: the lights of a scene and the shapes of its world become the light map (SPEC G5, G7).
#include "light/casters.hpp"
#include "light/light_map.hpp"
#include "light/lights.hpp"
#include "light/soak.hpp"

namespace evil::light {

struct Look {
    Rgb ambient{};      // as on the screen: the light that is everywhere
    float strength = 1; // of the ambient light
    float depth = 0.5f; // metres that light soaks into bodies
    int step = 2;       // pixels a texel
    bool on = false;    // off: nothing is lit
};

struct Scratch {  // losing it changes nothing
    struct Cast { // a lamp and what may hide it
        Lamp lamp;
        std::vector<std::uint32_t> casters;
    };
    struct Row { // of patches, for whoever works on it
        std::vector<std::uint32_t> near;
        std::vector<Hidden> hidden;
    };
    Casters casters;
    std::vector<Cast> open, shaded; // lamps without and with shadows
    std::size_t open_count = 0, shaded_count = 0;
    std::vector<Row> rows;
    std::vector<float> planes; // red, green, blue: light of open lamps, then of shaded ones
    std::vector<std::uint8_t> solid;
    std::vector<Soft> soft, blurred, other;
};

// Lights whose body is gone are removed.
void remove_orphans(Lights& lights, const Slots& bodies);

// `view`: world to pixels of a picture of that size. Allocates nothing once the vectors have grown.
void compute(LightMap& map, Scratch& scratch, const Lights& lights, const Look& look, World& world, const Affine& view,
             float alpha, int width, int height);

} // namespace evil::light
