#include "solver/contact_constraints.hpp"

namespace evil {
namespace {

constexpr float kContactHertz = 30.0f;   // stiffness of a soft contact; at most a quarter of the substep rate is stable
constexpr float kContactDamping = 10.0f; // damping ratio: overlap is pushed out without a bounce
constexpr float kPushSpeed = 3.0f;       // m/s: the fastest that overlap is pushed out; more, and piles burst apart
constexpr float kRestitutionSpeed = 0.25f; // m/s: slower impacts do not bounce (SPEC C7); at zero, stacks never rest

// Catto, "Soft Constraints", GDC 2011: a spring of that frequency and damping ratio, integrated implicitly over h.
Softness softness(float hertz, float h) {
    float omega = static_cast<float>(2.0 * kPi) * hertz;
    float a1 = 2.0f * kContactDamping + h * omega, a2 = h * omega * a1, a3 = 1.0f / (1.0f + a2);
    return {omega / a1, a2 * a3, a3};
}

float inverse(float k) { return k > 0.0f ? 1.0f / k : 0.0f; }

// The denominator of (4.8): what one newton second along `direction` changes of the relative speed there.
float effective_mass(const SolverBody& a, const SolverBody& b, Vec2 arm_a, Vec2 arm_b, Vec2 direction) {
    float turn_a = cross(arm_a, direction), turn_b = cross(arm_b, direction);
    return inverse(a.inv_mass + b.inv_mass + a.inv_inertia * turn_a * turn_a + b.inv_inertia * turn_b * turn_b);
}

Vec2 relative_velocity(const SolverBody& a, const SolverBody& b, Vec2 arm_a, Vec2 arm_b) {
    return b.velocity + cross(b.spin, arm_b) - a.velocity - cross(a.spin, arm_a);
}

void push(SolverBody& a, SolverBody& b, Vec2 arm_a, Vec2 arm_b, Vec2 impulse) { // (4.9), (4.10)
    a.velocity -= a.inv_mass * impulse;
    a.spin -= a.inv_inertia * cross(arm_a, impulse);
    b.velocity += b.inv_mass * impulse;
    b.spin += b.inv_inertia * cross(arm_b, impulse);
}

Vec2 acceleration_of(const Bodies& bodies, std::uint32_t slot) {
    const Body& b = bodies.rows[slot];
    return b.kind == BodyKind::dynamic ? b.acceleration : Vec2{};
}

ConstraintPoint prepare_point(const ManifoldPoint& p, const SolverBody& a, const SolverBody& b, Vec2 normal) {
    ConstraintPoint q{};
    q.anchor_a = p.anchor_a;
    q.anchor_b = p.anchor_b;
    q.base_separation = p.separation - dot(p.anchor_b - p.anchor_a, normal);
    q.normal_mass = effective_mass(a, b, p.anchor_a, p.anchor_b, normal);
    q.tangent_mass = effective_mass(a, b, p.anchor_a, p.anchor_b, right_of(normal));
    q.normal_impulse = p.normal_impulse;
    q.tangent_impulse = p.tangent_impulse;
    q.closing_speed = -dot(relative_velocity(a, b, p.anchor_a, p.anchor_b), normal);
    return q;
}

} // namespace

void prepare_contacts(Solver& solver, const Bodies& bodies, const Contacts& contacts, StepSize step) {
    float h = step.h(), hertz = std::min(kContactHertz, 0.25f / h);
    Softness between_bodies = softness(hertz, h), against_wall = softness(2.0f * hertz, h);
    solver.constraints.clear();
    for (std::uint32_t row = 0; row < contacts.rows.size(); ++row) {
        const Contact& c = contacts.rows[row];
        std::uint32_t na = solver.number_of[c.body_a], nb = solver.number_of[c.body_b];
        if (c.count == 0 || (na == 0 && nb == 0)) continue;
        const SolverBody &a = solver.bodies[na], &b = solver.bodies[nb];
        ContactConstraint k{};
        k.contact = row;
        k.a = na;
        k.b = nb;
        k.normal = c.normal;
        k.friction = c.friction;
        k.restitution = c.restitution;
        k.soft = a.inv_mass == 0.0f || b.inv_mass == 0.0f ? against_wall : between_bodies;
        Vec2 gained = acceleration_of(bodies, c.body_b) - acceleration_of(bodies, c.body_a);
        k.gained_speed = std::max(0.0f, -step.dt * dot(gained, c.normal));
        k.count = c.count;
        for (std::uint8_t i = 0; i < c.count; ++i) k.points[i] = prepare_point(c.points[i], a, b, c.normal);
        solver.constraints.push_back(k);
    }
}

void warm_start(Solver& solver) {
    for (ContactConstraint& k : solver.constraints) {
        SolverBody a = solver.bodies[k.a], b = solver.bodies[k.b];
        Vec2 tangent = right_of(k.normal);
        for (std::uint8_t i = 0; i < k.count; ++i) {
            ConstraintPoint& p = k.points[i];
            push(a, b, rotate(a.turned, p.anchor_a), rotate(b.turned, p.anchor_b),
                 p.normal_impulse * k.normal + p.tangent_impulse * tangent);
        }
        if (k.a) solver.bodies[k.a] = a;
        if (k.b) solver.bodies[k.b] = b;
    }
}

void solve_contacts(Solver& solver, float h, Pass pass) {
    float inv_h = 1.0f / h;
    for (ContactConstraint& k : solver.constraints) {
        SolverBody a = solver.bodies[k.a], b = solver.bodies[k.b];
        Vec2 moved = b.moved - a.moved, tangent = right_of(k.normal);
        for (std::uint8_t i = 0; i < k.count; ++i) {
            ConstraintPoint& p = k.points[i];
            Vec2 arm_a = rotate(a.turned, p.anchor_a), arm_b = rotate(b.turned, p.anchor_b);
            float separation = p.base_separation + dot(moved + arm_b - arm_a, k.normal);
            float bias = 0.0f, mass_scale = 1.0f, impulse_scale = 0.0f;
            if (separation > 0.0f) {
                bias = separation * inv_h; // speculative: take only what would make them overlap (SPEC C8)
            } else if (pass == Pass::push_apart) {
                bias = std::max(k.soft.bias_rate * std::min(separation + kSlop, 0.0f), -kPushSpeed);
                mass_scale = k.soft.mass_scale;
                impulse_scale = k.soft.impulse_scale;
            }
            float speed = dot(relative_velocity(a, b, arm_a, arm_b), k.normal);
            float impulse = -p.normal_mass * mass_scale * (speed + bias) - impulse_scale * p.normal_impulse;
            float total = std::max(p.normal_impulse + impulse, 0.0f);
            impulse = total - p.normal_impulse;
            p.normal_impulse = total;
            push(a, b, arm_a, arm_b, impulse * k.normal);
        }
        for (std::uint8_t i = 0; i < k.count; ++i) { // friction within Coulomb's cone, at rest and sliding (SPEC C5)
            ConstraintPoint& p = k.points[i];
            Vec2 arm_a = rotate(a.turned, p.anchor_a), arm_b = rotate(b.turned, p.anchor_b);
            float speed = dot(relative_velocity(a, b, arm_a, arm_b), tangent);
            float most = k.friction * p.normal_impulse;
            float total = std::clamp(p.tangent_impulse - p.tangent_mass * speed, -most, most);
            push(a, b, arm_a, arm_b, (total - p.tangent_impulse) * tangent);
            p.tangent_impulse = total;
        }
        if (k.a) solver.bodies[k.a] = a;
        if (k.b) solver.bodies[k.b] = b;
    }
}

void sum_impulses(Solver& solver) {
    for (ContactConstraint& k : solver.constraints)
        for (std::uint8_t i = 0; i < k.count; ++i) k.points[i].total_impulse += k.points[i].normal_impulse;
}

// (4.8) with the speed before the step: the solver has brought the closing speed to 0, this adds e times it outwards.
void apply_restitution(Solver& solver) {
    for (ContactConstraint& k : solver.constraints) {
        if (k.restitution == 0.0f) continue;
        SolverBody a = solver.bodies[k.a], b = solver.bodies[k.b];
        for (std::uint8_t i = 0; i < k.count; ++i) {
            ConstraintPoint& p = k.points[i];
            if (p.total_impulse == 0.0f || p.closing_speed - k.gained_speed <= kRestitutionSpeed) continue;
            Vec2 arm_a = rotate(a.turned, p.anchor_a), arm_b = rotate(b.turned, p.anchor_b);
            float speed = dot(relative_velocity(a, b, arm_a, arm_b), k.normal);
            float impulse = -p.normal_mass * (speed - k.restitution * p.closing_speed);
            impulse = std::max(impulse, -p.normal_impulse); // the sum may not pull
            p.total_impulse += impulse;                     // but the next step does not start from a bounce
            push(a, b, arm_a, arm_b, impulse * k.normal);
        }
        if (k.a) solver.bodies[k.a] = a;
        if (k.b) solver.bodies[k.b] = b;
    }
}

void store_impulses(const Solver& solver, Contacts& contacts) {
    auto finite = [](float v) { return std::isfinite(v) ? v : 0.0f; };
    for (const ContactConstraint& k : solver.constraints) {
        for (std::uint8_t i = 0; i < k.count; ++i) {
            ManifoldPoint& p = contacts.rows[k.contact].points[i];
            p.normal_impulse = finite(k.points[i].normal_impulse);
            p.tangent_impulse = finite(k.points[i].tangent_impulse);
            p.total_impulse = finite(k.points[i].total_impulse);
            p.closing_speed = finite(k.points[i].closing_speed);
        }
    }
}

} // namespace evil
