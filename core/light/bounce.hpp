#pragma once
// Light that does not come from lamps straight: what lit surfaces send on, and the ambient light as far as it gets in between
// bodies. The quality "high" has it.
#include "light/cascades.hpp"
#include "light/casters.hpp"
#include "light/glowing.hpp"
#include "light/lights.hpp"

namespace evil::draw {
struct Scene;
}

namespace evil::light {

struct Bounce {                // scratch
    std::vector<float> levels; // linear light of 0..255
    std::vector<Rgb> colours;  // by body slot: what share of light it sends back
    Glowing glowing;
    std::vector<std::uint32_t> bodies; // by texel: the body's slot, after those what glows, and kNone in the air
    std::vector<float> planes;         // red, green, blue; and the ways that each comes from
    Cells cells;
    Cascades cascades;
};

struct BounceLook {
    Rgb ambient{};         // linear
    float strength = 1.0f; // of the light that surfaces send on
    float reach = 1.0f;    // texels: what is nearer keeps some of the ambient light away
};

struct BounceMap { // its texels; planes of red, green and blue one after another
    int width, height, stride;
    Affine from_pixel;    // of the picture, to texels
    int left, top;        // of the world's texels, the first one's number: where cascades begin follows from that
    const float* open;    // light of lamps that shine through everything, and the ambient light
    float* shaded;        // that of the others
    float *across, *down; // the ways that theirs comes from, right and down; none where nothing has normals
};

// What bodies look like in even white light, of their drawings' colours the one in front; and what glows.
void find_colours(Bounce& bounce, const draw::Scene& scene, const draw::DrawList& list, const World& world);

// Adds to what is shaded the light of surfaces, less what of the ambient light is kept away.
void add_bounced(Bounce& bounce, const BounceMap& map, const BounceLook& look, const Casters& casters, Threads& threads,
                 InstructionSet set);

} // namespace evil::light
