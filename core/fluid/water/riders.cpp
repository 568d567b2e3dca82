// Bodies in the pressure's equation (Batty, Bertails and Bridson 2007): what they close of cells' faces moves as they do,
// and pressure moves those that are free.
#include "fluid/water/finder.hpp"
#include <algorithm>
#include <cmath>

namespace evil::fluid {
namespace {

constexpr float kHeld = 0.05f;    // share of a gain: less than that is how a step rounds
constexpr float kWakes = 0.5f;    // m/s2 by which the push on a sleeping body must change to wake it
constexpr float kSqueezed = 8.0f; // how many times as fast as a body that nothing stops may be what it squeezes out
constexpr float kBuoy = 0.005f;   // of what is displaced: a body so light is thrown about by how cells round

// Reaches by body, in the order of their cells.
void sort_reaches(WaterScratch& s, std::size_t bodies) {
    s.reaches_of.assign(bodies + 1, 0);
    for (const Reach& reach : s.unsorted_reaches) ++s.reaches_of[reach.body + 1];
    s.riders.clear();
    for (std::uint32_t slot = 0; slot < bodies; ++slot) {
        const std::uint32_t count = s.reaches_of[slot + 1];
        s.reaches_of[slot + 1] += s.reaches_of[slot];
        if (count == 0) continue;
        Rider rider;
        rider.body = slot, rider.first = s.reaches_of[slot], rider.last = rider.first + count;
        s.riders.push_back(rider);
    }
    s.reaches.resize(s.unsorted_reaches.size());
    for (const Reach& reach : s.unsorted_reaches) s.reaches[s.reaches_of[reach.body]++] = reach;
}

// What joints and contacts kept a body from in the last step they will keep it from again: the share of a gain that was
// lost, and for velocities the direction, times the root of the share.
Vec2 stop_of(Vec2 missing, Vec2 gained) {
    const float size = length(missing), most = -dot(gained, missing);
    if (!(most > kHeld * length_squared(gained)) || size == 0.0f) return {};
    return std::sqrt(std::min(size * size / most, 1.0f)) / size * missing;
}
float stop_of(float missing, float gained) {
    const float share = gained != 0.0f ? -missing / gained : 0.0f;
    return share > kHeld ? std::min(share, 1.0f) : 0.0f;
}

const Afloat* remembered(const Water& water, std::uint32_t slot, const Body& body) {
    const auto it = std::ranges::lower_bound(water.afloat, slot, {}, &Afloat::body);
    return it != water.afloat.end() && it->body == slot && it->serial == body.serial ? &*it : nullptr;
}

void set_free(Rider& rider, const Body& b, const Afloat* last, const Loop& loop, Vec2 gravity, float per_push,
              float dt) {
    rider.per_mass = per_push * b.inv_mass, rider.per_inertia = per_push * b.inv_inertia;
    Vec2 gain = dt * (b.gravity_scale * gravity + b.inv_mass * (b.force + loop.lift));
    float spin = dt * b.inv_inertia * (b.torque + loop.turn);
    if (last) {
        rider.stop = stop_of(b.velocity - last->velocity, last->gained);
        const float turning = 1.0f - stop_of(b.spin - last->spin, last->gained_spin);
        gain -= dot(rider.stop, gain) * rider.stop;
        spin *= turning, rider.per_inertia *= turning;
    }
    rider.velocity += gain, rider.spin += spin;
}

// The pressure of a cell is that of its middle. A body's surface in it lies deeper or higher, and so it is pressed harder or
// less: without that, a body of a few cells would lose or gain a fifth of its lift by where it lies between them.
void add_head(const World& world, Water& water, const Reach& reach, int i, int j, float dt) {
    WaterScratch& s = *water.scratch;
    const Grid& g = water.grid;
    const Body& b = world.bodies.rows[reach.body];
    if (b.kind != BodyKind::dynamic) return;
    const float most = water.pressure[reach.at] * g.h / dt; // none pulls, and what falls freely presses on nothing
    const float head = g.h * s.mass[reach.at] * dot(world.gravity, surface_near(water, i, j, reach.body));
    const float displaced = heaviest(water) * kRound * b.inertia / b.mass,
                share = b.mass / (b.mass + kBuoy * displaced);
    const float push = share * heaviest(water) * g.h * clamped(head, most);
    Loop& loop = s.loops[reach.body];
    loop.lift += push * Vec2{reach.x, reach.y};
    loop.turn += push * reach.turn;
}

} // namespace

void find_riders(const World& world, Water& water, float dt) {
    WaterScratch& s = *water.scratch;
    const Grid& g = water.grid;
    s.unsorted_reaches.clear(), s.reaches.clear(), s.riders.clear();
    if (!s.solids.any()) return;
    s.loops.assign(world.bodies.rows.size(), {});
    Finder finder(world, water);
    for (const Tile& tile : s.wet_tiles)
        if (s.near[static_cast<std::size_t>(tile.at / 8)])
            for (int i = tile.i; i < std::min(tile.i + 8, g.nx); ++i)
                if (s.wet[g.at(i, tile.j)] > 0.0f)
                    for (const Reach& reach : finder.look_at(i, tile.j)) {
                        s.unsorted_reaches.push_back(reach);
                        add_head(world, water, reach, i, tile.j, dt);
                    }
    add_films(world, water, dt);
    sort_reaches(s, world.bodies.rows.size());
    const float per_push = heaviest(water) * g.h * g.h;
    for (Rider& rider : s.riders) {
        const Body& b = world.bodies.rows[rider.body];
        rider.velocity = b.velocity, rider.spin = b.spin;
        rider.free = b.kind == BodyKind::dynamic && b.awake;
        if (rider.free)
            set_free(rider, b, remembered(water, rider.body, b), s.loops[rider.body], world.gravity, per_push, dt);
        for (std::uint32_t k = rider.first; k < rider.last; ++k) {
            const Reach& reach = s.reaches[k];
            s.inflow[reach.at] -= reach.x * rider.velocity.x + reach.y * rider.velocity.y + reach.turn * rider.spin;
        }
    }
}

// Liquid that is shut in and squeezed has nowhere to go, and what little gives way to it would be shot off. So pressure makes
// nothing faster than the fastest is, than a fall through the box, or than what a body wider than the gap beside it presses
// out. Added up, the two would drive each other on, liquid the body and the body the liquid.
float most_flow(const World& world, const Water& water, float dt) {
    const WaterScratch& s = *water.scratch;
    const Grid& g = water.grid;
    const float fall = std::sqrt(2.0f * length(world.gravity) * g.h * static_cast<float>(g.nx + g.ny));
    float fastest = std::max({s.swarm.fastest, fall, g.h / dt});
    for (const Rider& rider : s.riders) {
        const Patch& p = s.loops[rider.body].patch;
        const float wide = 0.5f * g.h * static_cast<float>(std::max(p.right - p.left, p.high - p.low));
        const float speed = length(rider.velocity) + std::abs(rider.spin) * wide;
        fastest = std::max(fastest, rider.free ? speed : kSqueezed * speed);
    }
    return fastest;
}

// The force that the pressure puts on a body: it too is made no faster than that, or than it is.
Vec2 within_reason(Vec2 force, const Body& b, float most, float dt) {
    auto along = [&](float push, float speed) {
        const float bound = std::max(std::abs(speed), most), change = push / b.mass * dt;
        return clamped((clamped(speed + change, bound) - speed) / dt, kMostPush) * b.mass;
    };
    return {along(force.x, b.velocity.x), along(force.y, b.velocity.y)};
}

void push_riders(World& world, Water& water, float dt) {
    WaterScratch& s = *water.scratch;
    const float per_push = heaviest(water) * water.grid.h * water.grid.h / dt;
    const float most = most_flow(world, water, dt);
    s.afloat.clear();
    for (const Rider& rider : s.riders) {
        Body& b = world.bodies.rows[rider.body];
        if (b.kind != BodyKind::dynamic) continue;
        const PushOf sum = push_of(rider, s.reaches, water.pressure.data());
        const Loop& loop = s.loops[rider.body];
        const Vec2 push{static_cast<float>(sum.x) * per_push, static_cast<float>(sum.y) * per_push};
        const Vec2 force = within_reason(push + loop.lift, b, most, dt);
        const float torque = clamped(static_cast<float>(sum.turn) * per_push + loop.turn, kMostPush * b.inertia);
        const Afloat* last = remembered(water, rider.body, b);
        if (!b.awake) {
            const Vec2 change = last ? force - last->force : force;
            const float turn = last ? torque - last->torque : torque;
            if (length(change) < kWakes * b.mass && std::abs(turn) < kWakes * b.inertia) {
                if (last) s.afloat.push_back(*last);
                continue;
            }
            b.awake = true, b.still_time = 0.0f;
        }
        Afloat now{rider.body, b.serial, {}, {}, 0.0f, 0.0f, force, torque};
        b.force = clamped(b.force + force, kMaxForce);
        b.torque = clamped(b.torque + torque, kMaxForce);
        now.gained = dt * (b.gravity_scale * world.gravity + b.inv_mass * b.force);
        now.gained_spin = dt * b.inv_inertia * b.torque;
        now.velocity = b.velocity + now.gained, now.spin = b.spin + now.gained_spin;
        s.afloat.push_back(now);
    }
    water.afloat.swap(s.afloat);
}

} // namespace evil::fluid
