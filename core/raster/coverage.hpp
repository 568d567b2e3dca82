#pragma once
// How much of each pixel a shape covers, exactly, from the shape's edges alone.
//
// Each edge adds, in each row that it crosses, the signed area to its right to the pixel it runs through, and the whole
// height that it crossed to the pixel after. A running sum along the row is then the coverage (the method of the font
// rasterisers LibArt, FreeType and font-rs; rows and touched blocks as in Blend2D). All of it is integer arithmetic, so the
// order of edges does not matter and every machine gets the same bits.
#include "raster/bands.hpp"
#include "raster/target.hpp"
#include <cstdint>
#include <span>
#include <vector>

namespace evil::raster {

struct Point { // target pixels; double, so that shapes far outside are cut exactly where the target ends
    double x = 0, y = 0;
};

inline constexpr int kFullCell = 1 << 17; // a whole pixel: 256 steps of height times 512 of doubled width
inline constexpr int kBlock = 8;          // pixels that share one bit of `touched`

struct Coverage {                       // scratch; all zero between shapes
    Box box;                            // the pixels that the shape may touch
    Rows rows;                          // and which of its rows are looked at
    int stride = 0, words = 0;          // cells and words of `touched` a row
    std::vector<std::int32_t> cells;    // what the running sum adds up
    std::vector<std::uint64_t> touched; // one bit for each block of cells that is not all zero
};

// Edges are cut and rounded by the whole box, so a row comes out the same whichever others are looked at.
void begin(Coverage& coverage, const Box& box, const Rows& rows); // rows within the box

// Adds the closed loop through the points. Loops may overlap; winding numbers add up. Points must be finite.
void add_loop(Coverage& coverage, std::span<const Point> points);

} // namespace evil::raster
