#pragma once
// Things that shine by themselves, as what surfaces send light on from: their triangles on the light map.
#include "light/casters.hpp"
#include "light/lights.hpp"
#include <vector>

namespace evil::draw {
struct DrawList;
}

namespace evil::light {

struct Glowing {
    Casters pieces;           // in pixels of the picture; `body`: which of the colours
    std::vector<Rgb> colours; // linear, of each thing
};

// What of the list glows. `levels`: linear light of 0..255.
void find_glowing(Glowing& glowing, const draw::DrawList& list, const std::vector<float>& levels);

// From pixels to another grid's coordinates.
void move_to(Glowing& glowing, const Affine& to_texel);

} // namespace evil::light
