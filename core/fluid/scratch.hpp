#pragma once
// What a smoke needs within a step, and would find again if it were lost.
#include "fluid/smoke.hpp"
#include "fluid/solids.hpp"
#include "fluid/stam.hpp"

namespace evil::fluid {

struct PushSum { // of what gas does to one body, over its shores
    Vec2 push;
    float turn = 0.0f;    // by pressure, about its centre
    Vec2 drag;            // rate times the speed against the gas
    float spin = 0.0f;    // and what that turns
    float rate = 0.0f;    // kg/s
    float turning = 0.0f; // the same for turning, kg m2/s
    float slip = 0.0f;    // metres of outline times the speed against the gas
    float outline = 0.0f; // metres
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
    std::vector<PushSum> sums_of_bodies;
    StamScratch stam;
};

} // namespace evil::fluid
