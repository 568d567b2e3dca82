#include "solver/solver.hpp"
#include "solver/contact_constraints.hpp"

namespace evil {
namespace {

void gather_bodies(Solver& solver, const Bodies& bodies) {
    solver.bodies.assign(1, {});
    solver.starts.assign(1, {});
    solver.body_slots.assign(1, kNone);
    solver.number_of.assign(bodies.slots.size(), 0);
    solver.pushes.assign(bodies.slots.size(), {});
    for (std::uint32_t slot = 0; slot < bodies.slots.size(); ++slot) {
        if (!bodies.slots.taken(slot)) continue;
        const Body& b = bodies.rows[slot];
        if (!moves(b) || !b.awake) continue;
        solver.number_of[slot] = static_cast<std::uint32_t>(solver.bodies.size());
        solver.body_slots.push_back(slot);
        solver.starts.push_back({b.centre, b.angle});
        solver.bodies.push_back({b.velocity, b.spin, b.inv_mass, {}, {}, b.inv_inertia, 0.0f});
    }
}

// Bring the rows to where their bodies are: at the end, and within the step for generators that ask.
void write_back(const Solver& solver, Bodies& bodies) {
    for (std::size_t i = 1; i < solver.bodies.size(); ++i) {
        const SolverBody& s = solver.bodies[i];
        Body& b = bodies.rows[solver.body_slots[i]];
        b.velocity = clamped(s.velocity, kMaxSpeed);
        b.spin = clamped(s.spin, kMaxSpin);
        b.centre = clamped(solver.starts[i].centre + s.moved, kWorldEdge);
        b.angle = solver.starts[i].angle + double(s.turned_angle);
        place_by_centre(b);
    }
}

float kept(float per_second, float h) {
    return per_second == 1.0f ? 1.0f : static_cast<float>(power(double(per_second), double(h)));
}

void integrate_velocities(Solver& solver, Bodies& bodies, Vec2 gravity, float h) {
    for (std::size_t i = 1; i < solver.bodies.size(); ++i) {
        SolverBody& s = solver.bodies[i];
        Body& b = bodies.rows[solver.body_slots[i]];
        if (b.kind != BodyKind::dynamic) continue;
        Push push = solver.pushes[solver.body_slots[i]];
        b.acceleration = clamped(s.inv_mass * (b.force + push.force) + b.gravity_scale * gravity, kMaxForce); // (4.3)
        float turning = s.inv_inertia * (b.torque + push.torque);                                             // (4.6)
        s.velocity = clamped(kept(b.damping, h) * s.velocity + h * b.acceleration, kMaxSpeed);                // (4.2)
        s.spin = clamped(kept(b.angular_damping, h) * s.spin + h * turning, kMaxSpin);                        // (4.5)
    }
}

void integrate_positions(Solver& solver, float h) {
    for (std::size_t i = 1; i < solver.bodies.size(); ++i) {
        SolverBody& s = solver.bodies[i];
        s.velocity = clamped(s.velocity, kMaxSpeed);
        s.spin = clamped(s.spin, kMaxSpin);
        s.moved += h * s.velocity; // (4.1)
        float turn = h * s.spin;   // (4.4)
        s.turned_angle += turn;
        Rot q{s.turned.c - turn * s.turned.s, s.turned.s + turn * s.turned.c};
        float size = std::sqrt(q.c * q.c + q.s * q.s);
        s.turned = {q.c / size, q.s / size};
    }
}

void clear_gathered_forces(const Solver& solver, Bodies& bodies) {
    for (std::size_t i = 1; i < solver.bodies.size(); ++i) {
        Body& b = bodies.rows[solver.body_slots[i]];
        b.force = {};
        b.torque = 0.0f;
    }
}

void note_paths(Solver& solver) {
    solver.paths.clear();
    for (std::size_t i = 1; i < solver.bodies.size(); ++i)
        solver.paths.push_back({solver.body_slots[i], solver.starts[i].centre});
}

} // namespace

void solve(Solver& solver, Bodies& bodies, Contacts& contacts, const Forces& forces, Vec2 gravity, StepSize step) {
    float h = step.h();
    gather_bodies(solver, bodies);
    prepare_contacts(solver, bodies, contacts, step);
    for (int substep = 0; substep < step.substeps; ++substep) {
        if (forces.slots.count() > 0) {
            if (substep > 0) write_back(solver, bodies);
            std::ranges::fill(solver.pushes, Push{});
            apply_forces(forces, bodies, gravity, h, solver.pushes);
        }
        integrate_velocities(solver, bodies, gravity, h);
        warm_start(solver);
        solve_contacts(solver, h, Pass::push_apart);
        integrate_positions(solver, h);
        solve_contacts(solver, h, Pass::relax);
        sum_impulses(solver);
    }
    apply_restitution(solver);
    store_impulses(solver, contacts);
    write_back(solver, bodies);
    clear_gathered_forces(solver, bodies);
    note_paths(solver);
}

} // namespace evil
