#pragma once
// What a smoke needs within a step, and would find again if it were lost.
#include "fluid/smoke.hpp"
#include "fluid/solids.hpp"
#include "fluid/stam.hpp"

namespace evil::fluid {

struct Grip {                                                        // of drag on a body: sums over its shores
    double x = 0.0, y = 0.0, turn = 0.0, x_turn = 0.0, y_turn = 0.0; // kg, kg m2, kg m: the gas that takes on its speed
    double push_x = 0.0, push_y = 0.0, push_turn = 0.0;              // on it, as if it stayed as fast as it is
};

struct Ride { // how gas meets one body within a step, and takes it along
    Vec2 velocity;
    float spin = 0.0f;
    Vec2 centre;
    bool dynamic = false; // and gas weighs something
    Patch faces;          // that it covers: from left and low up to right and high, these too
    float covers = 0.0f;  // m2
    float arms = 0.0f;    // m4: that times the squares of the distances from its centre
    float ease = 0.0f;    // mass of the gas that would be in its place, a unit of its own
    Vec2 push, before;    // kg m/s within the step, and before the last projection
    float turn = 0.0f, turn_before = 0.0f;
    Grip grip;
    Vec2 dragged; // m/s that drag makes it faster
    float twisted = 0.0f;
    Vec2 more; // m/s that the reflection adds
    float more_spin = 0.0f;
};

struct Wake { // a shore where gas drags at a body
    std::ptrdiff_t at;
    std::uint32_t body;
    Vec2 place, against;
    float x, y; // of a cell's mass, what takes on the body's speed
    Vec2 gas;   // of a cell, what is gas, for either component
};

struct Scratch {
    bool laid_out = false;
    bool watched = false; // does anybody ask for `gathering`?
    Gathering gathering;
    Solids solids;
    Pressure pressure;
    Field x, y;                     // the velocity in the middle of cells
    Field dx, dy;                   // the way that gas came within the step, in cells
    Field carried, low, high, u, v; // of a component that is being moved
    Field inflow, heat, curl;
    std::vector<float> cells, other_cells, colours, other_colours; // four floats a cell
    float correction = 1.0f; // of the density in `other_cells`, which carrying it lost or gained
    std::vector<float> sums; // of rows
    std::vector<Ride> rides; // by body
    std::vector<Wake> wakes;
    std::vector<Patch> loose; // of faces that free bodies cover
    bool any_free = false;
    StamScratch stam;
};

} // namespace evil::fluid
