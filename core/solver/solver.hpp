#pragma once
// Contact solver (SPEC C4-C7): substepped soft contacts with a relax pass, restitution last.
//
// Catto, "Solver2D" (2024), https://box2d.org/posts/2024/02/solver2d/: "Soft Step". Each substep integrates velocities,
// starts from the last impulses, solves with a soft push out of overlap, moves the bodies, then solves again without
// the push so that it leaves no velocity behind. Contacts are coloured and solved eight at a time (contacts_wide.cpp).
#include "collider/contact.hpp"
#include "collider/path.hpp"
#include "forces/forces.hpp"
#include "math/cpu.hpp"
#include "solver/colouring.hpp"
#include "solver/contact_blocks.hpp"
#include "solver/joints/joint_solver.hpp"
#include "threads.hpp"

namespace evil {

struct Bounce { // a contact with restitution
    std::uint32_t edge;
    float restitution;
    float gained_speed; // closing speed that the last step's acceleration alone has given (SPEC C7)
};

struct EdgesFrom { // what the edges followed from: while it is the same, so are they
    std::vector<std::uint8_t> marks, pushed;
    std::vector<Pair> bodies;
    std::vector<std::uint32_t> number_of;
};

struct Solver { // Scratch
    std::vector<SolverBody> bodies;
    std::vector<ForceStep> force_steps;    // of each solver body
    std::vector<std::uint32_t> body_slots; // of each solver body; [0] unused
    std::vector<Path> paths;               // of each solver body but [0], which stands still
    std::vector<std::uint32_t> number_of;  // by body slot
    std::vector<std::uint8_t> pushed;      // of each solver body: have contacts any effect on it?
    std::vector<Edge> edges;               // of each contact that is solved
    std::vector<Bounce> bounces;           // of those with restitution
    EdgesFrom edges_from;                  // what the edges followed from
    std::vector<std::uint32_t> unsolved;   // rows of contacts with points between bodies that nothing moves
    Colouring colouring;                   // of the edges
    std::vector<ContactBlock> blocks;
    std::vector<BlockSource> sources; // of the blocks
    JointSolver joints;
    std::vector<Push> pushes;               // by body slot
    bool islands_known = false;             // in this step: they are only looked for when someone sleeps or may
    std::vector<std::uint32_t> island_of;   // by body slot: root of its island
    std::vector<float> island_still;        // by root: shortest still time
    std::vector<std::uint8_t> island_awake; // by root
};

struct StepSize {
    float dt; // seconds, the whole step
    int substeps;
    InstructionSet set; // which kernels; the bits are the same with any
    float hit_speed;    // m/s: contacts that close faster are told of (collider/events.hpp)
    float h() const { return dt / static_cast<float>(substeps); }
};

// Move all awake bodies by one step under forces, joints and contacts.
void solve(Solver& solver, Bodies& bodies, Contacts& contacts, Joints& joints, const Forces& forces, Vec2 gravity,
           StepSize step, Threads& threads);

// Islands: bodies joined by contacts, joints or springs. They wake together and sleep together.
void wake_islands(Solver& solver, Bodies& bodies, const Contacts& contacts, const Joints& joints, const Forces& forces);
// True: someone's sleep may be other than what was told of it last.
bool sleep_islands(Solver& solver, Bodies& bodies, const Contacts& contacts, const Joints& joints, const Forces& forces,
                   const Shapes& shapes, float dt, bool allowed, Threads& threads);

} // namespace evil
