#pragma once
// Outlines in pixels, cut to what a part of the picture needs. A pixel's coverage is the sum over edges of the area to
// their right within it, so what lies right of a part can go, and what lies left counts as if it stood on its left side.
//
//      |     part     |
//    \ |              | /        the left edge becomes a piece of the part's left side,
//     \|              |/         the right one is left out
//      |              |
#include "gpu/quads.hpp"
#include "raster/outline.hpp"
#include <span>
#include <vector>

namespace evil::gpu {

struct Edge { // directed, in pixels; double, so that what is far outside is cut exactly where the picture ends
    double x0, y0, x1, y1;
};

using Bounds = raster::Box;

struct Cut { // scratch
    struct Turn {
        double y;
        int winding;
    };
    std::vector<Turn> turns;
};

// The edges that matter to the pixels within `part`.
void cut(std::span<const Edge> edges, const Bounds& part, std::vector<Edge>& out, Cut& scratch);

// Whether edges that `cut` gave cover every pixel of the part.
bool covers(std::span<const Edge> edges, const Bounds& part);

// Adds the stroke of `half` the width on either side of a closed path, as its outer and its inner loop. False if it is not
// that simple: a corner so sharp that it is rounded, an edge too short for its corners. `other` is scratch.
bool add_plain_stroke(raster::Loops& loops, std::span<const raster::Point> path, double half,
                      std::vector<raster::Point>& other);

} // namespace evil::gpu
