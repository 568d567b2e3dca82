#pragma once
// One thing of a frame: its outline, the pixels that it covers, and what colours they get.
#include "draw/draw_list.hpp"
#include "raster/bands.hpp"
#include "raster/coverage.hpp"
#include "raster/lit.hpp"
#include "raster/outline.hpp"
#include "raster/paint.hpp"
#include "raster/target.hpp"
#include <vector>

namespace evil::raster {

struct Desk { // what a band's things are drawn with; losing it changes nothing
    Coverage coverage;
    Loops loops;
    Paint paint;
    std::vector<std::int32_t> mask;
    std::vector<Pixel> row, glow;    // colours of one row, and what shines by itself
    std::vector<std::uint32_t> bent; // light on it, as its normals take it up
};

void make_room(Desk& desk, int width); // of a target

struct Strip { // a band that is being drawn
    Rows rows;
    std::size_t band;
    Desk& desk;
};

// Draws what of it lies in the strip. The mesh must be there and sound. `light`: of a frame that has any.
void draw_instance(const draw::DrawList& list, const draw::Instance& instance, const Pictures& pictures,
                   const Target& target, const Strip& strip, LightRows* light, Set set);

// Pixels of the target that it may touch, and somewhat more.
Box reach_of(const draw::DrawList& list, const draw::Instance& instance, const Target& target);

} // namespace evil::raster
