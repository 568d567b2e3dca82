#pragma once
// What a water holds at points of the world.
#include "fluid/water/water.hpp"

namespace evil::fluid {

struct WaterSample {
    bool inside = false;  // is there liquid?
    float density = 0.0f; // kg/m2 of it, on average within a cell's side
    Vec2 velocity;
};

class WaterSampler { // of the particles as they are now
public:
    explicit WaterSampler(const Water& water);
    WaterSample at(Vec2 point) const;
    float depth(Vec2 point, Vec2 up) const; // metres of liquid over a point in it, along a unit vector

private:
    const Water& water_;
    std::vector<std::uint32_t> first_, order_; // of each cell its particles, one cell after the other
};

} // namespace evil::fluid
