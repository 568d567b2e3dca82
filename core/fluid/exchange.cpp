// How gas pushes bodies: by its pressure on what of their outline lies in each cell, which is how they push it in the
// pressure's equation (Batty, Bertails and Bridson 2007), and by drag.
#include "fluid/flow.hpp"
#include "world.hpp"

namespace evil::fluid {
namespace {

constexpr float kDrag = 0.15f; // share of weight * speed^2 on each metre of outline: the wake that a grid cannot show
constexpr float kWakes = 0.5f; // m/s2 that gas must be able to give a sleeping body to wake it
constexpr float kMostPush = 1e4f; // m/s2: a squeezed pocket of gas may press without bounds
constexpr float kMoved = 0.25f;   // of the outline's square: gas that a body must move along, at most, a plate's too;
                                  // with less, what it is pushed by is late by a step and throws light bodies about

Vec2 flow_at(const Smoke& smoke, int i, int j) {
    const std::ptrdiff_t at = smoke.grid.at(i, j);
    return 0.5f * Vec2{smoke.u[at] + smoke.u[at + 1], smoke.v[at] + smoke.v[at + smoke.grid.stride]};
}

void add(const Step& step, const Shore& shore, float per_pressure, PushSum& sum) {
    const Smoke& smoke = step.smoke;
    const Body& b = step.world.bodies.rows[shore.body];
    const Grid& g = smoke.grid;
    const std::ptrdiff_t at = g.at(shore.i, shore.j);
    const float half =
        smoke.quality == Quality::high ? 2.0f * smoke.half_pressure[at] : 0.0f; // reflected: it counts twice
    const Vec2 place = g.low + g.h * Vec2{static_cast<float>(shore.i) + 0.5f, static_cast<float>(shore.j) + 0.5f};
    const Vec2 arm = place - b.centre, push = (per_pressure * (smoke.pressure[at] + half)) * shore.area;
    const Vec2 against = flow_at(smoke, shore.i, shore.j) - velocity_at(b, place);
    const float metres = length(shore.area), rate = kDrag * smoke.gas.weight * length(against) * metres;
    sum.push = sum.push + push;
    sum.turn += cross(arm, push);
    sum.drag = sum.drag + rate * against;
    sum.spin += rate * cross(arm, against);
    sum.rate += rate;
    sum.turning += rate * length_squared(arm);
    sum.slip += metres * length(against);
    sum.outline += metres;
}

// The gas that must move when the body does adds to its mass, or a light body would be thrown about by what it displaces;
// drag is implicit, so that it stops at the gas's own speed.
void push(const Step& step, const PushSum& sum, Body& b) {
    const float displaced = step.smoke.gas.weight * sum.outline * sum.outline * kMoved;
    const float shared = b.mass / (b.mass + displaced);
    const float slower = 1.0f / (1.0f + step.dt * sum.rate * b.inv_mass);
    const float calmer = 1.0f / (1.0f + step.dt * sum.turning * b.inv_inertia);
    // within a step, pressure takes a body at most half way to the speed of the gas round it
    const float most = 0.5f * sum.slip / (sum.outline * step.dt), round = 6.2831853f / sum.outline;
    const Vec2 pressed = clamped(shared * sum.push, std::min(most, kMostPush) * b.mass);
    const float turned = clamped(shared * sum.turn, std::min(most * round, kMostPush) * b.inertia);
    const Vec2 force = pressed + clamped(slower * sum.drag, kMostPush * b.mass);
    const float torque = turned + clamped(calmer * sum.spin, kMostPush * b.inertia);
    if (!b.awake) {
        if (length(force) < kWakes * b.mass && std::abs(torque) < kWakes * b.inertia) return;
        b.awake = true, b.still_time = 0.0f;
    }
    b.force = clamped(b.force + force, kMaxForce);
    b.torque = clamped(b.torque + torque, kMaxForce);
}

} // namespace

void push_bodies(const Step& step) {
    Scratch& s = step.scratch;
    if (step.smoke.gas.weight == 0.0f || s.solids.shores().empty()) return;
    const float per_pressure = step.smoke.gas.weight * step.smoke.grid.h / step.dt; // N/m2 for 1 m/s of ours
    std::vector<Body>& bodies = step.world.bodies.rows;
    s.sums_of_bodies.assign(bodies.size(), {});
    for (const Shore& shore : s.solids.shores())
        if (shore.body < bodies.size()) add(step, shore, per_pressure, s.sums_of_bodies[shore.body]);
    for (std::uint32_t slot = 0; slot < bodies.size(); ++slot)
        if (s.sums_of_bodies[slot].outline > 0.0f && bodies[slot].kind == BodyKind::dynamic)
            push(step, s.sums_of_bodies[slot], bodies[slot]);
}

} // namespace evil::fluid
