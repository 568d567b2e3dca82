#include "solver/solver.hpp"
#include "solver/contact_constraints.hpp"
#include "solver/contacts_wide.hpp"

namespace evil {
namespace {

void gather_bodies(Solver& solver, const Bodies& bodies) {
    solver.bodies.assign(1, {});
    solver.starts.assign(1, {});
    solver.turned.assign(1, 0.0f);
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
        solver.bodies.push_back({b.velocity.x, b.velocity.y, b.spin, b.inv_mass, 0, 0, 0, b.inv_inertia});
        solver.turned.push_back(0.0f);
    }
}

// Bring the rows to where their bodies are: at the end, and within the step for generators that ask.
void write_back(const Solver& solver, Bodies& bodies) {
    for (std::size_t i = 1; i < solver.bodies.size(); ++i) {
        const SolverBody& s = solver.bodies[i];
        Body& b = bodies.rows[solver.body_slots[i]];
        b.velocity = clamped({s.vx, s.vy}, kMaxSpeed);
        b.spin = clamped(s.spin, kMaxSpin);
        b.centre = clamped(solver.starts[i].centre + Vec2{s.moved_x, s.moved_y}, kWorldEdge);
        b.angle = solver.starts[i].angle + double(solver.turned[i]);
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
        Vec2 velocity = clamped(kept(b.damping, h) * Vec2{s.vx, s.vy} + h * b.acceleration, kMaxSpeed);       // (4.2)
        s.vx = velocity.x;
        s.vy = velocity.y;
        s.spin = clamped(kept(b.angular_damping, h) * s.spin + h * turning, kMaxSpin); // (4.5)
    }
}

// Within a quarter turn, to 2e-4: contacts only ask how far their points have moved since the step began.
float sine(float angle) {
    constexpr float kQuarter = static_cast<float>(0.5 * kPi);
    float x = clamped(angle, kQuarter), x2 = x * x;
    return x * (1.0f - x2 * (1.0f / 6.0f - x2 * (1.0f / 120.0f - x2 * (1.0f / 5040.0f))));
}

void integrate_positions(Solver& solver, float h) {
    for (std::size_t i = 1; i < solver.bodies.size(); ++i) {
        SolverBody& s = solver.bodies[i];
        Vec2 velocity = clamped({s.vx, s.vy}, kMaxSpeed);
        s.vx = velocity.x;
        s.vy = velocity.y;
        s.spin = clamped(s.spin, kMaxSpin);
        s.moved_x += h * s.vx; // (4.1)
        s.moved_y += h * s.vy;
        solver.turned[i] += h * s.spin; // (4.4)
        s.turned_sine = sine(solver.turned[i]);
    }
}

void clear_gathered_forces(Bodies& bodies) { // also of what does not move: it may become dynamic
    for (Body& b : bodies.rows) {
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

void solve(Solver& solver, Bodies& bodies, Contacts& contacts, Joints& joints, const Forces& forces, Vec2 gravity,
           StepSize step) {
    float h = step.h();
    gather_bodies(solver, bodies);
    fill_blocks(solver, bodies, contacts, step);
    prepare_joints(solver, bodies, joints, step);
    SolverBody* rows = solver.bodies.data();
    ContactBlock* blocks = solver.blocks.data();
    std::size_t count = solver.blocks.size();
    for (int substep = 0; substep < step.substeps; ++substep) {
        if (forces.slots.count() > 0) {
            if (substep > 0) write_back(solver, bodies);
            std::ranges::fill(solver.pushes, Push{});
            apply_forces(forces, bodies, gravity, h, solver.pushes);
        }
        integrate_velocities(solver, bodies, gravity, h);
        warm_start_joints(solver, step.set);
        EVIL_PICK(step.set, warm_start)(rows, blocks, count);
        solve_joints(solver, step.set);
        EVIL_PICK(step.set, push_apart)(rows, blocks, count, 1.0f / h);
        integrate_positions(solver, h);
        relax_joints(solver, step.set);
        EVIL_PICK(step.set, relax)(rows, blocks, count, 1.0f / h);
    }
    apply_restitution(solver, step);
    store_impulses(solver, contacts);
    store_joints(solver, joints, step);
    write_back(solver, bodies);
    clear_gathered_forces(bodies);
    note_paths(solver);
}

} // namespace evil
