#include "solver/solver.hpp"
#include "solver/contact_constraints.hpp"
#include "solver/contacts_wide.hpp"

namespace evil {
namespace {

constexpr std::size_t kBodiesAtOnce = 256, kBlocksAtOnce = 16; // chunks for threads: microseconds of work each

void gather_bodies(Solver& solver, const Bodies& bodies) {
    solver.bodies.assign(1, {});
    solver.force_steps.assign(1, {});
    solver.starts.assign(1, {});
    solver.body_slots.assign(1, kNone);
    solver.number_of.assign(bodies.slots.size(), 0);
    for (std::uint32_t slot = 0; slot < bodies.slots.size(); ++slot) {
        if (!bodies.slots.taken(slot)) continue;
        const Body& b = bodies.rows[slot];
        if (!moves(b) || !b.awake) continue;
        solver.number_of[slot] = static_cast<std::uint32_t>(solver.bodies.size());
        solver.body_slots.push_back(slot);
        solver.starts.push_back({b.centre, b.angle});
        solver.bodies.push_back({b.velocity.x, b.velocity.y, b.spin, b.inv_mass, 0, 0, 0, b.inv_inertia});
    }
    solver.force_steps.resize(solver.bodies.size());
}

// Bring the rows to where their bodies are: at the end, and within the step for generators that ask.
void write_back(const Solver& solver, Bodies& bodies, Threads& threads) {
    parallel_for(threads, solver.bodies.size() - 1, kBodiesAtOnce, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first + 1; i <= last; ++i) {
            const SolverBody& s = solver.bodies[i];
            Body& b = bodies.rows[solver.body_slots[i]];
            b.velocity = clamped({s.vx, s.vy}, kMaxSpeed);
            b.spin = clamped(s.spin, kMaxSpin);
            b.centre = clamped(solver.starts[i].centre + Vec2{s.moved_x, s.moved_y}, kWorldEdge);
            b.angle = solver.starts[i].angle + double(s.turned);
            place_by_centre(b);
        }
    });
}

float kept(float per_second, float h) {
    return per_second == 1.0f ? 1.0f : static_cast<float>(power(double(per_second), double(h)));
}

ForceStep force_step_of(Body& b, const Push& push, Vec2 gravity, float h) {
    ForceStep force;
    if (b.kind != BodyKind::dynamic) return force;
    b.acceleration = clamped(b.inv_mass * (b.force + push.force) + b.gravity_scale * gravity, kMaxForce); // (4.3)
    Vec2 gain = h * b.acceleration;
    float turning = b.inv_inertia * (b.torque + push.torque); // (4.6)
    force.keep[0] = force.keep[1] = kept(b.damping, h);
    force.keep[2] = kept(b.angular_damping, h);
    force.gain[0] = gain.x;
    force.gain[1] = gain.y;
    force.gain[2] = h * turning;
    return force;
}

// What forces do to each body in a substep.
void find_force_steps(Solver& solver, Bodies& bodies, std::span<const Push> pushes, Vec2 gravity, float h,
                      Threads& threads) {
    parallel_for(threads, solver.bodies.size() - 1, kBodiesAtOnce, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first + 1; i <= last; ++i) {
            std::uint32_t slot = solver.body_slots[i];
            solver.force_steps[i] =
                force_step_of(bodies.rows[slot], pushes.empty() ? Push{} : pushes[slot], gravity, h);
        }
    });
}

// Generators are asked before each substep, where the bodies are by then; the world's own gravity but once.
void ask_forces(Solver& solver, Bodies& bodies, const Forces& forces, Vec2 gravity, float h, int substep,
                Threads& threads) {
    if (forces.slots.count() > 0) {
        if (substep > 0) write_back(solver, bodies, threads);
        solver.pushes.assign(bodies.slots.size(), {});
        apply_forces(forces, bodies, gravity, h, solver.pushes);
        find_force_steps(solver, bodies, solver.pushes, gravity, h, threads);
    } else if (substep == 0) {
        find_force_steps(solver, bodies, {}, gravity, h, threads);
    }
}

void integrate_velocities(Solver& solver, InstructionSet set, Threads& threads) {
    parallel_for(threads, solver.bodies.size() - 1, kBodiesAtOnce, [&](std::size_t first, std::size_t last) {
        EVIL_PICK(set, push_bodies)(&solver.bodies[first + 1], &solver.force_steps[first + 1], last - first);
    });
}

void integrate_positions(Solver& solver, InstructionSet set, float h, Threads& threads) {
    parallel_for(threads, solver.bodies.size() - 1, kBodiesAtOnce, [&](std::size_t first, std::size_t last) {
        EVIL_PICK(set, move_bodies)(&solver.bodies[first + 1], last - first, h);
    });
}

// Colour after colour, as blocks of one colour share no body that moves; those that may are handed over one by one.
template <class Between, class Walls>
void for_each_colour(Solver& solver, Threads& threads, Between between, Walls walls) {
    auto work = [&](const BlockRange& range, std::size_t first, std::size_t count) {
        ContactBlock* blocks = &solver.blocks[range.first + first];
        range.wall ? walls(solver.bodies.data(), blocks, count) : between(solver.bodies.data(), blocks, count);
    };
    for (const BlockRange& range : solver.colouring.ranges) {
        for (std::size_t i = 0; range.alone && i < range.count; ++i) work(range, i, 1);
        if (range.alone) continue;
        parallel_for(threads, range.count, kBlocksAtOnce,
                     [&](std::size_t first, std::size_t last) { work(range, first, last - first); });
    }
}

void warm_start_contacts(Solver& solver, InstructionSet set, Threads& threads) {
    for_each_colour(solver, threads, EVIL_PICK(set, warm_start), EVIL_PICK(set, warm_start_walls));
}

void push_contacts_apart(Solver& solver, StepSize step, const ContactSoftnesses& soft, Threads& threads) {
    float inv_h = 1.0f / step.h();
    auto between = EVIL_PICK(step.set, push_apart);
    auto walls = EVIL_PICK(step.set, push_apart_walls);
    for_each_colour(
        solver, threads, [&](auto* bodies, auto* k, std::size_t n) { between(bodies, k, n, inv_h, soft.between); },
        [&](auto* bodies, auto* k, std::size_t n) { walls(bodies, k, n, inv_h, soft.walls); });
}

void relax_contacts(Solver& solver, StepSize step, Threads& threads) {
    float inv_h = 1.0f / step.h();
    auto between = EVIL_PICK(step.set, relax);
    auto walls = EVIL_PICK(step.set, relax_walls);
    for_each_colour(
        solver, threads, [&](auto* bodies, auto* k, std::size_t n) { between(bodies, k, n, inv_h); },
        [&](auto* bodies, auto* k, std::size_t n) { walls(bodies, k, n, inv_h); });
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
        solver.paths.push_back({solver.body_slots[i], solver.starts[i].centre, solver.starts[i].angle});
}

} // namespace

void solve(Solver& solver, Bodies& bodies, Contacts& contacts, Joints& joints, const Forces& forces, Vec2 gravity,
           StepSize step, Threads& threads) {
    float h = step.h();
    ContactSoftnesses soft = softness_of(step);
    gather_bodies(solver, bodies);
    prepare_contacts(solver, bodies, contacts, step, threads);
    prepare_joints(solver, bodies, joints, step);
    for (int substep = 0; substep < step.substeps; ++substep) {
        ask_forces(solver, bodies, forces, gravity, h, substep, threads);
        integrate_velocities(solver, step.set, threads);
        warm_start_joints(solver, step.set);
        warm_start_contacts(solver, step.set, threads);
        solve_joints(solver, step.set);
        push_contacts_apart(solver, step, soft, threads);
        integrate_positions(solver, step.set, h, threads);
        relax_joints(solver, step.set);
        relax_contacts(solver, step, threads);
    }
    apply_restitution(solver, contacts, step);
    finish_contacts(solver, contacts, step, threads);
    store_joints(solver, joints, step);
    write_back(solver, bodies, threads);
    clear_gathered_forces(bodies);
    note_paths(solver);
}

} // namespace evil
