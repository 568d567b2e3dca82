// How gas and bodies push each other. Pressure acts on what of a body's outline lies in each cell, which is how bodies push
// gas in the pressure's equation (Batty, Bertails and Bridson 2007). A light one must move the gas round it before it moves
// itself: what it is pushed by is then found as if it were gas of its own density (Carlson, Mucha and Turk 2004), or it
// would overshoot, ever more from step to step. Drag is the wake that a grid cannot show; what it gives to bodies it takes
// from the gas.
#include "fluid/flow.hpp"
#include <algorithm>

namespace evil::fluid {
namespace {

constexpr float kDrag = 0.15f;    // share of weight * speed^2 on each metre of outline
constexpr float kWakes = 0.5f;    // m/s2 that gas must be able to give a sleeping body to wake it
constexpr float kMostPush = 1e4f; // m/s2: a squeezed pocket of gas may press without bounds
constexpr float kYields =
    0.5f; // mass of gas in its place, of its own, from which on a body moves before gas goes round it
constexpr float kMostEase =
    4.0f; // beyond, it is taken along as if it were as heavy as that: the rest is hard to solve for

Vec2 flow_at(const Smoke& smoke, int i, int j) {
    const std::ptrdiff_t at = smoke.grid.at(i, j);
    return 0.5f * Vec2{smoke.u[at] + smoke.u[at + 1], smoke.v[at] + smoke.v[at + smoke.grid.stride]};
}

Vec2 middle_of(const Grid& g, const Shore& shore) {
    return g.low + g.h * Vec2{static_cast<float>(shore.i) + 0.5f, static_cast<float>(shore.j) + 0.5f};
}

void add(Ride& ride, Vec2 place, Vec2 push) {
    ride.push = ride.push + push;
    ride.turn += cross(place - ride.centre, push);
}

// visit(wall, its body's ride, is it a left face?) for the faces that free bodies cover.
template <class Visit> void each_free_wall(Scratch& s, Visit visit) {
    for (const Wall& wall : s.solids.walls_across())
        if (Ride& ride = s.rides[wall.body]; ride.ease > 0.0f) visit(wall, ride, true);
    for (const Wall& wall : s.solids.walls_up())
        if (Ride& ride = s.rides[wall.body]; ride.ease > 0.0f) visit(wall, ride, false);
}

// The pressure's impulse on each of them: `times` that of one projection.
void press(const Step& step, const Field& p, float times) {
    const Grid& g = step.smoke.grid;
    const float per_face = times * step.smoke.gas.weight * g.h * g.h;
    each_free_wall(step.scratch, [&](const Wall& wall, Ride& ride, bool left) {
        const float push = per_face * wall.closed * (p[wall.at - (left ? 1 : g.stride)] - p[wall.at]);
        add(ride, wall.place, left ? Vec2{push, 0.0f} : Vec2{0.0f, push});
    });
}

// The faces that free bodies cover let pressure through, as easily as they are light.
void loosen(const Step& step) {
    Scratch& s = step.scratch;
    const Grid& g = step.smoke.grid;
    Field &across = s.low, &up = s.high; // free between two carryings
    s.loose.clear();
    for (const Ride& ride : s.rides) {
        if (!(ride.ease > 0.0f)) continue;
        s.loose.push_back(ride.faces);
        for (int j = ride.faces.low; j <= ride.faces.high + 1; ++j) // and those beyond, which may be on the box's side
            for (std::ptrdiff_t at = g.at(ride.faces.left, j); at <= g.at(ride.faces.right + 1, j); ++at)
                across[at] = s.solids.across()[at], up[at] = s.solids.up()[at];
    }
    each_free_wall(s, [&](const Wall& wall, const Ride& ride, bool left) {
        (left ? across : up)[wall.at] += wall.closed * std::min(ride.ease, kMostEase);
    });
    s.pressure.set_faces(g, across, up, s.loose);
}

// What drag makes of its speed: implicit, so that it stops at the gas's own; all three at once, as they pull at each other.
void take_drag(Ride& ride, const Body& b) {
    const Grip& g = ride.grip;
    if (!(b.mass > 0.0f) || g.x + g.y == 0.0f) return;
    const double x = double(b.mass) + g.x, y = double(b.mass) + g.y;
    double turn = 0.0;
    if (b.inv_inertia > 0.0f) {
        const double own = double(b.inertia) + g.turn - g.x_turn * g.x_turn / x - g.y_turn * g.y_turn / y;
        turn = (g.push_turn - g.x_turn * g.push_x / x - g.y_turn * g.push_y / y) / own;
    }
    ride.dragged = {static_cast<float>((g.push_x - g.x_turn * turn) / x),
                    static_cast<float>((g.push_y - g.y_turn * turn) / y)};
    ride.twisted = static_cast<float>(turn);
    ride.velocity = ride.velocity + ride.dragged, ride.spin += ride.twisted;
}

} // namespace

Vec2 velocity_at(const Ride& ride, Vec2 place) {
    return clamped(ride.velocity + cross(ride.spin, place - ride.centre), kMostFlow);
}

void see_bodies(const Step& step) {
    Scratch& s = step.scratch;
    const Grid& g = step.smoke.grid;
    const std::vector<Body>& bodies = step.world.bodies.rows;
    s.rides.assign(bodies.size(), {});
    auto see = [&](const Wall& wall) {
        Ride& ride = s.rides[wall.body];
        const Body& b = bodies[wall.body];
        const int j = static_cast<int>(wall.at / g.stride), i = static_cast<int>(wall.at - j * g.stride);
        if (ride.covers == 0.0f) {
            ride.velocity = b.velocity, ride.spin = b.spin, ride.centre = b.centre;
            ride.dynamic = b.kind == BodyKind::dynamic && step.smoke.gas.weight > 0.0f;
            ride.faces = {i, j, i, j};
        }
        Patch& faces = ride.faces;
        faces = {std::min(faces.left, i), std::min(faces.low, j), std::max(faces.right, i), std::max(faces.high, j)};
        ride.covers += 0.5f * wall.closed * g.h * g.h;
        ride.arms += 0.5f * wall.closed * g.h * g.h * length_squared(wall.place - b.centre);
    };
    for (const Wall& wall : s.solids.walls_across()) see(wall);
    for (const Wall& wall : s.solids.walls_up()) see(wall);
    s.any_free = false;
    for (std::size_t slot = 0; slot < s.rides.size(); ++slot) {
        Ride& ride = s.rides[slot];
        if (!ride.dynamic || ride.covers == 0.0f) continue;
        ride.ease = step.smoke.gas.weight * ride.covers * bodies[slot].inv_mass;
        s.any_free = s.any_free || ride.ease > 0.0f;
    }
}

void drag_bodies(const Step& step) {
    Scratch& s = step.scratch;
    Smoke& smoke = step.smoke;
    const Grid& g = smoke.grid;
    const Field &across = s.solids.across(), &up = s.solids.up();
    const float per_face = smoke.gas.weight * g.h * g.h;
    s.wakes.clear();
    for (const Shore& shore : s.solids.shores()) {
        Ride& ride = s.rides[shore.body];
        const std::ptrdiff_t at = g.at(shore.i, shore.j);
        const Vec2 place = middle_of(g, shore), against = flow_at(smoke, shore.i, shore.j) - velocity_at(ride, place);
        const float rate = kDrag * length(against) * length(shore.area) * step.dt / (g.h * g.h);
        const Vec2 gas = 0.5f * Vec2{across[at] + across[at + 1], up[at] + up[at + g.stride]}; // shares of a cell
        const Wake wake{at,
                        shore.body,
                        place,
                        against,
                        rate * gas.x / std::max(gas.x + rate, 1e-6f),
                        rate * gas.y / std::max(gas.y + rate, 1e-6f),
                        gas};
        s.wakes.push_back(wake);
        const float x = per_face * wake.x, y = per_face * wake.y; // kg
        const Vec2 arm = place - ride.centre;
        Grip& grip = ride.grip;
        grip.x += x, grip.y += y, grip.push_x += x * against.x, grip.push_y += y * against.y;
        grip.x_turn -= x * arm.y, grip.y_turn += y * arm.x, grip.turn += x * arm.y * arm.y + y * arm.x * arm.x;
        grip.push_turn += y * arm.x * against.y - x * arm.y * against.x;
    }
    for (std::size_t slot = 0; slot < s.rides.size(); ++slot) {
        Ride& ride = s.rides[slot];
        if (ride.dynamic && step.world.bodies.rows[slot].awake) take_drag(ride, step.world.bodies.rows[slot]);
    }
    for (const Wake& wake : s.wakes) {
        Ride& ride = s.rides[wake.body];
        const Vec2 against = wake.against - ride.dragged - cross(ride.twisted, wake.place - ride.centre),
                   taken{wake.x * against.x, wake.y * against.y}; // of a cell's mass
        if (ride.dynamic) add(ride, wake.place, per_face * taken);
        const Vec2 slower{wake.gas.x > 0.0f ? 0.5f * taken.x / wake.gas.x : 0.0f,
                          wake.gas.y > 0.0f ? 0.5f * taken.y / wake.gas.y : 0.0f};
        smoke.u[wake.at] -= slower.x, smoke.u[wake.at + 1] -= slower.x;
        smoke.v[wake.at] -= slower.y, smoke.v[wake.at + g.stride] -= slower.y;
    }
}

void take_along(const Step& step, const Field& pressure, float times) {
    Scratch& s = step.scratch;
    if (!s.any_free) return;
    Field& loose = s.carried; // free, too
    loosen(step);
    loose = pressure;
    gather_inflow(step);
    s.pressure.solve(step.smoke.grid, s.inflow, loose, kCycles, step.world.instruction_set, step.world.threads);
    s.pressure.set_faces(step.smoke.grid, s.solids.across(), s.solids.up(), s.loose);
    for (Ride& ride : s.rides) ride.before = ride.push, ride.turn_before = ride.turn;
    press(step, loose, times);
    for (std::size_t slot = 0; slot < s.rides.size(); ++slot) {
        Ride& ride = s.rides[slot];
        const Body& b = step.world.bodies.rows[slot];
        if (!(ride.ease > 0.0f)) continue;
        // no lighter than `kMostEase` says, and no easier to turn than what it covers would be
        const float share = std::min(kMostEase / ride.ease, 1.0f), inertia = b.mass * ride.arms / ride.covers;
        const Vec2 push = share * (ride.push - ride.before);
        const float turn =
            share * (ride.turn - ride.turn_before) * std::min(b.inertia / std::max(inertia, 1e-30f), 1.0f);
        ride.push = ride.before + push, ride.turn = ride.turn_before + turn;
        if (!(ride.ease > kYields) || !b.awake) continue;
        ride.velocity = ride.velocity + (b.inv_mass / times) * push;
        ride.spin += b.inv_inertia / times * turn;
        ride.more = ((times - 1.0f) * b.inv_mass / times) * push;
        ride.more_spin = (times - 1.0f) * b.inv_inertia / times * turn;
    }
}

void reflect_rides(const Step& step) {
    for (Ride& ride : step.scratch.rides) ride.velocity = ride.velocity + ride.more, ride.spin += ride.more_spin;
}

void push_bodies(const Step& step) {
    Scratch& s = step.scratch;
    for (std::size_t slot = 0; slot < s.rides.size(); ++slot) {
        const Ride& ride = s.rides[slot];
        if (!ride.dynamic) continue;
        Body& b = step.world.bodies.rows[slot];
        const Vec2 force = clamped((1.0f / step.dt) * ride.push, kMostPush * b.mass);
        const float torque = clamped(ride.turn / step.dt, kMostPush * b.inertia);
        if (!b.awake) {
            if (length(force) < kWakes * b.mass && std::abs(torque) < kWakes * b.inertia) continue;
            b.awake = true, b.still_time = 0.0f;
        }
        b.force = clamped(b.force + force, kMaxForce);
        b.torque = clamped(b.torque + torque, kMaxForce);
    }
}

} // namespace evil::fluid
