#pragma once
// A draw list as quads for a graphics card, in as few draw calls as their pictures allow.
#include "gpu/edges.hpp"
#include "gpu/quads.hpp"
#include "gpu/shapes.hpp"
#include <vector>

namespace evil::gpu {

struct Scratch {
    raster::Loops loops;
    std::vector<raster::Point> path, other;
    std::vector<Edge> edges, visible, row, cell;
    Cut cut;
};

// Fills `frame`. `held` says by id which textures there are; what names another is drawn without one.
void collect(Frame& frame, Shapes& shapes, Scratch& scratch, const draw::DrawList& list, const std::vector<bool>& held,
             int width, int height);

} // namespace evil::gpu
