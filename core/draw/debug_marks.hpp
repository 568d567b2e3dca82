#pragma once
// What the debug view of fluids is made of, whatever the fluid: arrows and tiles that share one scale, and lines of cells.
#include "draw/debug_fluids.hpp"
#include "fluid/grid.hpp"
#include <algorithm>
#include <cmath>

namespace evil::draw {

// All in logical points.
inline constexpr float kArrowEvery = 18.0f, kTile = 6.0f;

// A part of a grid: whole squares of `side` cells, of which the last ones may be smaller.
struct Squares {
    int side = 1;
    int first_i = 0, last_i = 0, first_j = 0, last_j = 0; // in cells, of what is seen
};

struct Arrow {
    Vec2 at, velocity;
    float room; // pixels to the next
};

struct Tile {
    Vec2 low, high;   // metres
    float divergence; // 1/s
};

struct Marks { // of all fluids
    std::vector<Arrow> arrows;
    std::vector<Tile> tiles;
};

float pixels_a_metre(const FluidFrame& f);

// The squares of a grid that are seen, each at least so many points wide, and the same ones wherever the camera goes.
Squares seen(const FluidFrame& f, const fluid::Grid& g, float points);

inline Vec2 corner_of(const fluid::Grid& g, int i, int j) {
    return g.low + g.h * Vec2{static_cast<float>(i), static_cast<float>(j)};
}

// visit(low i, low j, high i, high j) for each square.
template <class Visit> void each_square(const fluid::Grid& g, const Squares& s, Visit visit) {
    for (int j = s.first_j; j < s.last_j; j += s.side)
        for (int i = s.first_i; i < s.last_i; i += s.side)
            visit(i, j, std::min(i + s.side, g.nx), std::min(j + s.side, g.ny));
}

void fill(const FluidFrame& f, Vec2 low, Vec2 high, Rgba8 colour);

// What `is` says of (i, j) holds for these cells: they are filled, a run of them at a time.
template <class Is> void fill_cells(const FluidFrame& f, const fluid::Grid& g, Rgba8 colour, Is is) {
    const Squares s = seen(f, g, 0.0f);
    for (int j = s.first_j; j < s.last_j; ++j)
        for (int i = s.first_i; i < s.last_i; ++i) {
            const int from = i;
            while (i < s.last_i && is(i, j)) ++i;
            if (i > from) fill(f, corner_of(g, from, j), corner_of(g, i, j + 1), colour);
        }
}

void draw_grid(const FluidFrame& f, const fluid::Grid& g, const std::array<bool, 4>& open);

// Each returns what the longest arrows or the full colours stand for; 0 where there is nothing to draw.
float draw_arrows(const FluidFrame& f, const std::vector<Arrow>& arrows);
float draw_tiles(const FluidFrame& f, const std::vector<Tile>& tiles);

// In debug_smoke.cpp.
void mark(const FluidFrame& f, const fluid::Smoke& smoke, Marks& marks);
void draw_cells(const FluidFrame& f, const fluid::Smoke& smoke);

// In debug_water.cpp.
void mark(const FluidFrame& f, const fluid::Water& water, Marks& marks);
void draw_cells(const FluidFrame& f, const fluid::Water& water);
void draw_particles(const FluidFrame& f, const fluid::Water& water);

} // namespace evil::draw
