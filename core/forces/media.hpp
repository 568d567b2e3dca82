#pragma once
// Media (SPEC P2): areas that drag, blow and lift what is in them, each body by the share of it that is.
#include "forces/immersion.hpp"

namespace evil {

struct MediaScratch {
    ImmersionScratch pieces;
};

// A medium that is carried along wakes what lies in its way.
void stir_media(const Forces& forces, Bodies& bodies, const Shapes& shapes);

// Once a step, before it is solved: adds to what each awake body's forces have gathered.
void apply_media(const Forces& forces, Bodies& bodies, const Shapes& shapes, Vec2 gravity, float dt,
                 MediaScratch& scratch);

} // namespace evil
