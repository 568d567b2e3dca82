#pragma once
// What a smoke holds at points of the world: between the middles of cells, and nothing outside.
#include "fluid/smoke.hpp"

namespace evil::fluid {

struct Sample {
    float density = 0.0f, temperature = 0.0f, fuel = 0.0f;
    Vec2 velocity;
};
Sample sample(const Smoke& smoke, Vec2 at);

double mass_of(const Smoke& smoke); // density times area

} // namespace evil::fluid
