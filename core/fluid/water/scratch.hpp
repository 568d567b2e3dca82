#pragma once
// What a water needs within a step, and would find again if it were lost.
#include "fluid/solids.hpp"
#include "fluid/water/water.hpp"

namespace evil::fluid {

struct WaterScratch {
    bool laid_out = false;
    Solids solids;
    Pressure faces;
};

// Where bodies are now.
void update_banks(const World& world, Water& water);

// Metres from a point to the nearest body, negative inside one, by what stands at the corners of its cell.
float banks_distance(const Water& water, Vec2 at);

} // namespace evil::fluid
