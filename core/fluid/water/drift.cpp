// Bodies too small for the cells to see, as pebbles and corks: the pressure's slope lifts them, and drag carries them along.
#include "fluid/water/finder.hpp"
#include <algorithm>
#include <cmath>

namespace evil::fluid {
namespace {

constexpr float kDragging = 1.0f;  // coefficient of drag, by the width
constexpr float kCreeping = 0.5f;  // m/s: the speed below which drag grows with it, not with its square
constexpr float kAddedMass = 0.5f; // of what it displaces: what has to move along
constexpr float kWakes = 0.5f;     // m/s2

// The pressure's difference from one cell to the next along one way, of those that hold liquid.
float slope(const Field& p, const Field& wet, std::ptrdiff_t at, std::ptrdiff_t way) {
    const bool before = wet[at - way] > 0.0f, after = wet[at + way] > 0.0f;
    if (before && after) return 0.5f * (p[at + way] - p[at - way]);
    return after ? p[at + way] - p[at] : before ? p[at] - p[at - way] : 0.0f;
}

void drift(const World& world, Water& water, Body& b, float dt) {
    WaterScratch& s = *water.scratch;
    const Grid& g = water.grid;
    const Vec2 place = 1.0f / g.h * (b.centre - g.low);
    if (!(place.x >= 0.0f && place.y >= 0.0f && place.x < static_cast<float>(g.nx) &&
          place.y < static_cast<float>(g.ny)))
        return;
    const std::ptrdiff_t at = g.at(static_cast<int>(place.x), static_cast<int>(place.y));
    if (s.wet[at] == 0.0f) return;
    const float square = b.inertia / b.mass, area = kRound * square, width = 2.8f * std::sqrt(square);
    const float heavy = heaviest(water), density = heavy * s.mass[at];
    const Vec2 lift =
        -(area * heavy / dt) * Vec2{slope(water.pressure, s.wet, at, 1), slope(water.pressure, s.wet, at, g.stride)};
    const Vec2 flow = 0.5f * Vec2{s.u[at] + s.u[at + 1], s.v[at] + s.v[at + g.stride]};
    const Vec2 slip = flow - b.velocity, weight = b.mass * b.gravity_scale * world.gravity;
    const float rate = 0.5f * kDragging * density * width * (length(slip) + kCreeping);
    const float moved = b.mass + kAddedMass * density * area;
    const Vec2 drag = rate / (1.0f + dt * rate / moved) * slip;
    const Vec2 force = b.mass / moved * (lift + drag + weight) - weight;
    if (!b.awake) {
        const bool lifted = dot(force + weight, world.gravity) < -kWakes * b.mass * length(world.gravity);
        if (!lifted && length(drag) < kWakes * b.mass) return;
        b.awake = true, b.still_time = 0.0f;
    }
    b.force = clamped(b.force + clamped(force, kMostPush * b.mass), kMaxForce);
    const Vec2 lost = -0.5f * dt / (density * g.h * g.h) * drag; // by each of the two faces
    if (s.solids.across()[at] > 0.0f) s.u[at] += lost.x;
    if (s.solids.across()[at + 1] > 0.0f) s.u[at + 1] += lost.x;
    if (s.solids.up()[at] > 0.0f) s.v[at] += lost.y;
    if (s.solids.up()[at + g.stride] > 0.0f) s.v[at + g.stride] += lost.y;
}

} // namespace

void drift_small_bodies(World& world, Water& water, float dt) {
    std::vector<Body>& bodies = world.bodies.rows;
    for (std::uint32_t slot = 0; slot < bodies.size(); ++slot)
        if (world.bodies.slots.taken(slot) && is_small(bodies[slot], water.grid.h))
            drift(world, water, bodies[slot], dt);
}

} // namespace evil::fluid
