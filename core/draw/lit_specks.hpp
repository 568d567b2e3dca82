#pragma once
// Particles in the light: each takes the light of its middle, which is one look into the light map (SPEC G8).
#include "draw/draw_list.hpp"

namespace evil::draw {

bool has_lit_specks(const DrawList& list);

// Multiplies the colours of the frame's lit specks with the light that there is; none without a light map.
void light_specks(DrawList& list);

} // namespace evil::draw
