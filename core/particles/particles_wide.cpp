#include "particles/particles_wide.hpp"
#include "math/wide.hpp"

namespace evil::EVIL_ISA {

// Velocity towards the wind's, then gravity, then place: with drag, what falls ends at a steady speed.
void move_particles(const particles::Motion& motion, const particles::Columns& columns, int count) noexcept {
    constexpr float kMaxSpeed = 1e5f; // m/s, as bodies.hpp has it
    const Floats dt(motion.dt), keep(motion.keep), wind_x(motion.wind_x), wind_y(motion.wind_y);
    const Floats push_x(motion.push_x), push_y(motion.push_y), last(static_cast<float>(motion.knots - 1));
    for (int i = 0; i < count; i += kLanes) {
        Floats vx = wind_x + (load(columns.vx + i) - wind_x) * keep + push_x;
        Floats vy = wind_y + (load(columns.vy + i) - wind_y) * keep + push_y;
        vx = clamp(vx, -kMaxSpeed, kMaxSpeed);
        vy = clamp(vy, -kMaxSpeed, kMaxSpeed);
        store(columns.vx + i, vx);
        store(columns.vy + i, vy);
        Floats part = load(columns.part + i), go = dt;
        if (motion.pace) go = dt * gather(motion.pace, round_to_int(clamp(part, 0.0f, 1.0f) * last));
        store(columns.x + i, load(columns.x + i) + vx * go);
        store(columns.y + i, load(columns.y + i) + vy * go);
        store(columns.part + i, part + load(columns.ageing + i) * dt);
        store(columns.turn + i, load(columns.turn + i) + load(columns.spin + i) * dt);
    }
}

} // namespace evil::EVIL_ISA
