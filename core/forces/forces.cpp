#include "forces/forces.hpp"

namespace evil {
namespace {

void push_at(Push& push, Vec2 force, Vec2 arm) { // (4.7): torque is the perpendicular dot of the arm and the force
    push.force += force;
    push.torque += cross(arm, force);
}

// Mass that the point at `arm` shows along unit direction n, inverted.
float inv_mass_along(const Body& b, Vec2 arm, Vec2 n) {
    float turn = cross(arm, n);
    return b.inv_mass + b.inv_inertia * turn * turn;
}

// Hooke's law with a damper along the spring. A spring so stiff that a substep would overshoot is softened to the
// stiffest that a step of h can follow: k h^2 / m <= 1/2 (explicit integration is stable up to 4).
void apply_spring(const Force& f, const Bodies& bodies, std::uint32_t slot, float h, std::span<Push> pushes) {
    const Body& b = bodies.rows[slot];
    Vec2 arm = rotate(b.pose.q, f.anchor - b.local_centre), from = b.centre + arm;
    const Body* other = f.target != kNone ? &bodies.rows[f.target] : nullptr;
    Vec2 to = other ? transform(other->pose, f.vector) : f.vector;
    Vec2 d = to - from;
    float distance = length(d);
    if (!(distance > 1e-9f)) return; // no direction
    Vec2 n = (1.0f / distance) * d;
    Vec2 other_arm = other ? to - other->centre : Vec2{};
    float inv_mass = inv_mass_along(b, arm, n) + (other ? inv_mass_along(*other, other_arm, n) : 0.0f);
    if (!(inv_mass > 0.0f)) return;
    float mass = 1.0f / inv_mass;
    float stiffness = std::min(f.stiffness, 0.5f * mass / (h * h));
    float damping = f.damping / (1.0f + h * f.damping * inv_mass); // implicit: strong dampers stop, never reverse
    Vec2 velocity = velocity_at(b, from) - (other ? velocity_at(*other, to) : Vec2{});
    float size = stiffness * (distance - f.rest_length) - damping * dot(velocity, n);
    push_at(pushes[slot], size * n, arm);
    if (other) push_at(pushes[f.target], -size * n, other_arm);
}

// Linear and quadratic drag, implicit in the speed, so that it can stop a body but never turn it back.
void apply_drag(const Force& f, const Body& b, float h, Push& push) {
    float speed = length(b.velocity);
    float rate = b.drag * (f.linear + f.quadratic * speed); // N s/m
    push.force -= rate / (1.0f + h * rate * b.inv_mass) * b.velocity;
    // A body that turns is slowed too: as if its mass sat at its radius of gyration, r^2 = I / m.
    float turning = rate * b.inertia * b.inv_mass;
    push.torque -= turning / (1.0f + h * turning * b.inv_inertia) * b.spin;
}

// A finger's pull: a critically damped spring from the centre of mass toward the point, with a largest acceleration, so
// that walls hold against it. It carries the body's weight while it acts (SPEC I3).
void apply_pull(const Force& f, const Body& b, Vec2 gravity, float h, Push& push) {
    float omega = std::min(static_cast<float>(2.0 * kPi) * f.stiffness, 0.5f / h);
    Vec2 a = omega * omega * (f.vector - b.centre) - 2.0f * omega * b.velocity;
    float size = length(a);
    if (size > f.limit) a = (f.limit / size) * a;
    push.force += b.mass * (a - b.gravity_scale * gravity);
    float turning = omega * b.inertia; // and calms its turning
    push.torque -= turning / (1.0f + h * turning * b.inv_inertia) * b.spin;
}

void apply_one(const Force& f, const Bodies& bodies, std::uint32_t slot, Vec2 gravity, float h,
               std::span<Push> pushes) {
    const Body& b = bodies.rows[slot];
    if (b.kind != BodyKind::dynamic || !b.awake) return;
    switch (f.kind) {
    case ForceKind::gravity:
        pushes[slot].force += b.mass * f.vector;
        break;
    case ForceKind::constant:
        push_at(pushes[slot], f.vector, f.at_anchor ? rotate(b.pose.q, f.anchor - b.local_centre) : Vec2{});
        break;
    case ForceKind::spring:
        apply_spring(f, bodies, slot, h, pushes);
        break;
    case ForceKind::medium:
        break; // once a step, before it begins: forces/media.hpp
    case ForceKind::drag:
        apply_drag(f, b, h, pushes[slot]);
        break;
    case ForceKind::pull:
        apply_pull(f, b, gravity, h, pushes[slot]);
        break;
    case ForceKind::python:
        break; // asked once a step, before it begins
    }
}

} // namespace

bool contains(const Area& area, Vec2 point) {
    if (area.radius > 0.0f && length_squared(point - area.centre) <= area.radius * area.radius) return true;
    for (const auto& part : area.parts) {
        bool inside = true;
        for (std::size_t i = 0; i < part.size() && inside; ++i)
            inside = cross(part[(i + 1) % part.size()] - part[i], point - part[i]) >= 0.0f;
        if (inside) return true;
    }
    return false;
}

void apply_forces(const Forces& forces, const Bodies& bodies, Vec2 world_gravity, float h, std::span<Push> pushes) {
    for (std::uint32_t i = 0; i < forces.slots.size(); ++i) {
        if (!forces.slots.taken(i)) continue;
        const Force& f = forces.rows[i];
        if (f.everywhere) {
            for (std::uint32_t slot = 0; slot < bodies.slots.size(); ++slot)
                if (bodies.slots.taken(slot)) apply_one(f, bodies, slot, world_gravity, h, pushes);
        } else {
            for (std::uint32_t slot : f.bodies) apply_one(f, bodies, slot, world_gravity, h, pushes);
        }
    }
}

} // namespace evil
