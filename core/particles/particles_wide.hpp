#pragma once
// What every particle goes through each step, eight at a time.
#include "math/cpu.hpp"

namespace evil::particles {

struct Motion { // of one emitter in one step
    float dt;
    float keep;                           // share of the speed against the wind that is left
    float wind_x, wind_y, push_x, push_y; // push: m/s that gravity gives in the step
    const float* pace;                    // by part of life, or null: as fast as it flies
    int knots;
};

struct Columns {
    float *x, *y, *vx, *vy, *part, *turn;
    const float *ageing, *spin;
};

} // namespace evil::particles

namespace evil {

EVIL_WIDE(void move_particles(const particles::Motion& motion, const particles::Columns& columns, int count) noexcept;)

} // namespace evil
