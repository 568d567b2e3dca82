#pragma once
// A draw list as quads for a graphics card, in as few draw calls as their pictures allow.
#include "gpu/edges.hpp"
#include "gpu/quads.hpp"
#include "gpu/shapes.hpp"
#include "gpu/sprites.hpp"
#include <vector>

namespace evil::gpu {

struct Scratch {
    raster::Loops loops;
    std::vector<raster::Point> path, other;
    std::vector<Edge> edges, visible, row, cell;
    Cut cut;
};

struct Pictures {
    std::vector<bool> held; // by id, which textures there are; what names another is drawn without one
    Places places;          // where in the atlas those are that have a place there
};

// Fills `frame`.
void collect(Frame& frame, Shapes& shapes, Scratch& scratch, const draw::DrawList& list, const Pictures& pictures,
             int width, int height);

} // namespace evil::gpu
