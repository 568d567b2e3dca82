#include "bulk.hpp"

namespace evil {
namespace {

// Wake what was moved and what touches it, in one pass over the contacts.
void wake_around(World& world, const std::vector<bool>& moved) {
    for (std::uint32_t body = 0; body < moved.size(); ++body)
        if (moved[body]) wake(world, body);
    for (Contact& c : world.contacts.rows) {
        if (!moved[c.body_a] && !moved[c.body_b]) continue;
        c.look_again();
        if (c.sensor()) continue;
        if (moved[c.body_a]) wake(world, c.body_b);
        if (moved[c.body_b]) wake(world, c.body_a);
    }
}

// change(body, i) says whether it changed anything; what changed is shown where it is at once, and wakes.
template <class Change> void move_all(World& world, std::span<const std::uint32_t> bodies, Change change) {
    std::vector<bool> moved(world.bodies.rows.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        std::uint32_t slot = bodies[i];
        if (!change(world.bodies.rows[slot], i)) continue;
        moved[slot] = true;
        place_by_origin(world.bodies.rows[slot]);
        publish(world, slot);
        world.previous[slot] = world.present[slot];
    }
    wake_around(world, moved);
}

Vec2 point_of(const Body& body, std::span<const Vec2> points, std::size_t i) {
    return points.empty() ? body.centre : points[i];
}

} // namespace

MassProblem add_many(World& world, const Recipe& recipe, const Starts& starts, const std::string& tag,
                     std::vector<BodyRef>& added) {
    added.reserve(starts.positions.size());
    Body row = recipe.row;
    for (std::size_t i = 0; i < starts.positions.size(); ++i) {
        row.pose.p = starts.positions[i];
        if (!starts.angles.empty()) row.angle = starts.angles[i];
        if (!starts.velocities.empty()) row.velocity = starts.velocities[i];
        if (!starts.spins.empty()) row.spin = starts.spins[i];
        Added<BodyRef> one = add_body(world, row, tag, recipe.shapes, recipe.traits);
        if (one.problem != MassProblem::none) return one.problem; // the first, or none: where it is changes no mass
        added.push_back(one.ref);
    }
    return MassProblem::none;
}

void set_positions(World& world, std::span<const std::uint32_t> bodies, std::span<const Vec2> values) {
    move_all(world, bodies, [&](Body& b, std::size_t i) {
        if (b.pose.p == values[i]) return false;
        b.pose.p = values[i];
        return true;
    });
}

void set_angles(World& world, std::span<const std::uint32_t> bodies, std::span<const double> values) {
    move_all(world, bodies, [&](Body& b, std::size_t i) {
        // an angle that came out of the published array is the body's own, which has more digits
        if (b.angle == values[i] || double(static_cast<float>(b.angle)) == values[i]) return false;
        b.angle = values[i];
        return true;
    });
}

void set_velocities(World& world, std::span<const std::uint32_t> bodies, std::span<const Vec2> values) {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        Body& b = world.bodies.rows[bodies[i]];
        if (b.velocity == values[i]) continue;
        b.velocity = values[i];
        wake(world, bodies[i]);
        publish(world, bodies[i]);
    }
}

void set_spins(World& world, std::span<const std::uint32_t> bodies, std::span<const float> values) {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        Body& b = world.bodies.rows[bodies[i]];
        if (b.spin == values[i]) continue;
        b.spin = values[i];
        wake(world, bodies[i]);
    }
}

void push_bodies(World& world, std::span<const std::uint32_t> bodies, std::span<const Vec2> forces,
                 std::span<const Vec2> points) {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        Body& b = world.bodies.rows[bodies[i]];
        b.force = clamped(b.force + forces[i], kMaxForce);
        b.torque = clamped(b.torque + cross(point_of(b, points, i) - b.centre, forces[i]), kMaxForce);
        wake(world, bodies[i]);
    }
}

void kick_bodies(World& world, std::span<const std::uint32_t> bodies, std::span<const Vec2> impulses,
                 std::span<const Vec2> points) {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        Body& b = world.bodies.rows[bodies[i]];
        b.velocity = clamped(b.velocity + b.inv_mass * impulses[i], kMaxSpeed);
        b.spin = clamped(b.spin + b.inv_inertia * cross(point_of(b, points, i) - b.centre, impulses[i]), kMaxSpin);
        wake(world, bodies[i]);
        publish(world, bodies[i]);
    }
}

} // namespace evil
