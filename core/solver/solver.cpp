#include "solver/solver.hpp"
#include "math/rotations_wide.hpp"
#include "solver/contact_constraints.hpp"
#include "solver/contacts_wide.hpp"
#include <atomic>

namespace evil {
namespace {

constexpr std::size_t kBodiesAtOnce = 256, kBlocksAtOnce = 16; // chunks for threads: microseconds of work each

void clear_gathered(Body& b) {
    b.force = {};
    b.torque = 0.0f;
}

// Numbers for the bodies that move, in the order of their slots. On the others no force acts.
void number_bodies(Solver& solver, Bodies& bodies) {
    solver.number_of.assign(bodies.slots.size(), 0);
    solver.body_slots.assign(1, kNone);
    for (std::uint32_t slot = 0; slot < bodies.slots.size(); ++slot) {
        Body& b = bodies.rows[slot];
        if (moves(b) && b.awake && bodies.slots.taken(slot)) {
            solver.number_of[slot] = static_cast<std::uint32_t>(solver.body_slots.size());
            solver.body_slots.push_back(slot);
        } else {
            clear_gathered(b);
        }
    }
    std::size_t count = solver.body_slots.size();
    solver.bodies.resize(count);
    solver.bodies[0] = {};
    solver.force_steps.resize(count);
    solver.pushed.assign(count, 0);
    solver.paths.resize(count - 1);
}

template <class Work> void for_each_body(Solver& solver, Threads& threads, Work work) {
    parallel_for(threads, solver.paths.size(), kBodiesAtOnce, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) work(i + 1, solver.paths[i]);
    });
}

// Bring a body to where its row is; `q`: turned so far.
void write_back(Body& b, const SolverBody& s, const Path& path, Rot q) {
    b.velocity = clamped({s.vx, s.vy}, kMaxSpeed);
    b.spin = clamped(s.spin, kMaxSpin);
    b.centre = clamped(path.start + Vec2{s.moved_x, s.moved_y}, kWorldEdge);
    b.angle = path.angle + double(s.turned);
    b.pose.q = q;
    b.pose.p = b.centre - rotate(q, b.local_centre);
}

template <class After>
void write_back_all(Solver& solver, Bodies& bodies, InstructionSet set, Threads& threads, After after) {
    parallel_for(threads, solver.paths.size(), kBodiesAtOnce, [&](std::size_t first, std::size_t last) {
        double angles[kBodiesAtOnce] = {};
        Rot turned[kBodiesAtOnce];
        for (std::size_t i = first; i < last; ++i)
            angles[i - first] = solver.paths[i].angle + double(solver.bodies[i + 1].turned);
        EVIL_PICK(set, rotations)(angles, last - first, turned);
        for (std::size_t i = first; i < last; ++i) {
            const Path& path = solver.paths[i];
            Body& b = bodies.rows[path.body];
            write_back(b, solver.bodies[i + 1], path, turned[i - first]);
            after(b);
        }
    });
}

float kept(float per_second, float h) {
    return per_second == 1.0f ? 1.0f : static_cast<float>(power(double(per_second), double(h)));
}

// What forces do to a body in a substep. Into its row number by number: the lanes of what has moved keep their 1 and 0.
void find_force_step(ForceStep& force, Body& b, const Push& push, Vec2 gravity, float h) {
    if (b.kind != BodyKind::dynamic) { // nothing but what the last substep made of it stays
        std::ranges::fill(force.keep, 1.0f);
        std::ranges::fill(force.gain, 0.0f);
        return;
    }
    b.acceleration = clamped(b.inv_mass * (b.force + push.force) + b.gravity_scale * gravity, kMaxForce); // (4.3)
    Vec2 gain = h * b.acceleration;
    force.keep[0] = force.keep[1] = kept(b.damping, h);
    force.keep[2] = kept(b.angular_damping, h);
    force.gain[0] = gain.x;
    force.gain[1] = gain.y;
    force.gain[2] = h * (b.inv_inertia * (b.torque + push.torque)); // (4.6)
}

// Rows of the bodies, and what forces do where no generator has to be asked.
void fill_bodies(Solver& solver, Bodies& bodies, const Forces& forces, Vec2 gravity, float h, Threads& threads) {
    bool asked = forces.slots.count() > 0;
    for_each_body(solver, threads, [&](std::size_t i, Path& path) {
        std::uint32_t slot = solver.body_slots[i];
        Body& b = bodies.rows[slot];
        path = {slot, b.centre, b.angle};
        solver.bodies[i] = {b.velocity.x, b.velocity.y, b.spin, b.inv_mass, 0, 0, 0, b.inv_inertia};
        solver.pushed[i] = b.inv_mass > 0.0f;
        if (!asked) find_force_step(solver.force_steps[i], b, {}, gravity, h);
    });
}

// Generators are asked before each substep, where the bodies are by then.
void ask_forces(Solver& solver, Bodies& bodies, const Forces& forces, Vec2 gravity, float h, int substep,
                InstructionSet set, Threads& threads) {
    if (forces.slots.count() == 0) return;
    if (substep > 0) write_back_all(solver, bodies, set, threads, [](Body&) {});
    solver.pushes.assign(bodies.slots.size(), {});
    apply_forces(forces, bodies, gravity, h, solver.pushes);
    for_each_body(solver, threads, [&](std::size_t i, const Path& path) {
        find_force_step(solver.force_steps[i], bodies.rows[path.body], solver.pushes[path.body], gravity, h);
    });
}

void integrate_velocities(Solver& solver, InstructionSet set, bool warm, Threads& threads) {
    parallel_for(threads, solver.bodies.size() - 1, kBodiesAtOnce, [&](std::size_t first, std::size_t last) {
        EVIL_PICK(set, push_bodies)(&solver.bodies[first + 1], &solver.force_steps[first + 1], last - first, warm);
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

// Did any two slide on each other?
bool relax_contacts(Solver& solver, StepSize step, Threads& threads) {
    std::atomic<bool> slid = false;
    float inv_h = 1.0f / step.h();
    auto between = EVIL_PICK(step.set, relax);
    auto walls = EVIL_PICK(step.set, relax_walls);
    for_each_colour(
        solver, threads,
        [&](auto* bodies, auto* k, std::size_t n) {
            if (between(bodies, k, n, inv_h)) slid.store(true, std::memory_order_relaxed);
        },
        [&](auto* bodies, auto* k, std::size_t n) { walls(bodies, k, n, inv_h); });
    return slid.load();
}

void finish_bodies(Solver& solver, Bodies& bodies, InstructionSet set, Threads& threads) {
    write_back_all(solver, bodies, set, threads, clear_gathered);
}

} // namespace

void solve(Solver& solver, Bodies& bodies, Contacts& contacts, Joints& joints, const Forces& forces, Vec2 gravity,
           StepSize step, Threads& threads) {
    float h = step.h();
    ContactSoftnesses soft = softness_of(step);
    number_bodies(solver, bodies);
    fill_bodies(solver, bodies, forces, gravity, h, threads);
    prepare_contacts(solver, bodies, contacts, step, threads);
    prepare_joints(solver, bodies, joints, step);
    bool joined = joints.slots.count() > 0;
    // Where nothing slides, what a body's contacts did to it in one substep is what they start the next one with: no look
    // at each of them is needed. In the first substep they are new, and joints start in their own way.
    bool warm = false;
    for (int substep = 0; substep < step.substeps; ++substep) {
        ask_forces(solver, bodies, forces, gravity, h, substep, step.set, threads);
        integrate_velocities(solver, step.set, warm, threads);
        warm_start_joints(solver, step.set);
        if (!warm) warm_start_contacts(solver, step.set, threads);
        solve_joints(solver, step.set);
        push_contacts_apart(solver, step, soft, threads);
        integrate_positions(solver, step.set, h, threads);
        relax_joints(solver, step.set);
        warm = !relax_contacts(solver, step, threads) && !joined;
    }
    apply_restitution(solver, contacts, step);
    finish_contacts(solver, contacts, step, threads);
    store_joints(solver, joints, step);
    finish_bodies(solver, bodies, step.set, threads);
}

} // namespace evil
