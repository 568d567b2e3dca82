#pragma once
// What comes into a water and goes from it while it runs, and what is done to it by hand.
#include "fluid/water/water.hpp"

namespace evil::fluid {

inline constexpr float kMostPouring =
    1e6f; // m2 a second of a stream; one that drains as much takes all that it reaches

StreamRef add_stream(World& world, Stream stream);
void destroy_stream(World& world, std::uint32_t stream);

// One step of the streams of a water, whose banks are up to date. One that pours puts particles where there is room
// between bodies and others, and keeps what finds none for later, up to what its area holds.
void apply_streams(World& world, Water& water, std::uint32_t slot, float dt);

// Takes away what is in the area; returns how many particles went.
std::size_t clear(Water& water, const Area& area);

// Pushes what is round a point: in its middle to `velocity`, less towards `radius`.
void stir(Water& water, Vec2 at, float radius, Vec2 velocity);

// What was written from outside may be anything: particles are brought back into the box, numbers into their ranges.
void settle(Water& water);

} // namespace evil::fluid
