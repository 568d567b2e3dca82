#pragma once
// Contact solver (SPEC C4-C7): substepped soft contacts with a relax pass, restitution last.
//
// Catto, "Solver2D" (2024), https://box2d.org/posts/2024/02/solver2d/: "Soft Step". Each substep integrates velocities,
// starts from the last impulses, solves with a soft push out of overlap, moves the bodies, then solves again without
// the push so that it leaves no velocity behind.
#include "collider/continuous.hpp"
#include "forces/forces.hpp"

namespace evil {

struct SolverBody { // a body while it is solved; number 0 stands for all that never move
    Vec2 velocity;
    float spin = 0.0f;
    float inv_mass = 0.0f;
    Vec2 moved; // of the centre since the step began
    Rot turned; // since the step began
    float inv_inertia = 0.0f;
    float turned_angle = 0.0f; // radians since the step began
};

struct Start { // of a body's step
    Vec2 centre;
    double angle;
};

struct Softness { // of a contact as a spring and damper, in the solver's own terms
    float bias_rate, mass_scale, impulse_scale;
};

struct ConstraintPoint {
    Vec2 anchor_a, anchor_b; // at the start of the step
    float base_separation;   // separation less what the anchors account for
    float normal_mass, tangent_mass;
    float normal_impulse, tangent_impulse, total_impulse, closing_speed;
};

struct ContactConstraint {
    std::uint32_t contact; // row that it comes from
    std::uint32_t a, b;    // solver bodies
    Vec2 normal;
    float friction, restitution;
    float gained_speed; // closing speed that the last step's acceleration alone has given (SPEC C7)
    Softness soft;
    std::uint8_t count;
    ConstraintPoint points[2];
};

struct Solver { // Scratch
    std::vector<SolverBody> bodies;
    std::vector<Start> starts;             // of each solver body
    std::vector<std::uint32_t> body_slots; // of each solver body; [0] unused
    std::vector<Path> paths;               // of each solver body, for the walls
    std::vector<std::uint32_t> number_of;  // by body slot
    std::vector<ContactConstraint> constraints;
    std::vector<Push> pushes;               // by body slot
    std::vector<std::uint32_t> island_of;   // by body slot: root of its island
    std::vector<float> island_still;        // by root: shortest still time
    std::vector<std::uint8_t> island_awake; // by root
};

struct StepSize {
    float dt; // seconds, the whole step
    int substeps;
    float h() const { return dt / static_cast<float>(substeps); }
};

// Move all awake bodies by one step under forces and contacts.
void solve(Solver& solver, Bodies& bodies, Contacts& contacts, const Forces& forces, Vec2 gravity, StepSize step);

// Islands: bodies joined by contacts or springs. They wake together and sleep together.
void wake_islands(Solver& solver, Bodies& bodies, const Contacts& contacts, const Forces& forces);
void sleep_islands(Solver& solver, Bodies& bodies, const Shapes& shapes, float dt, bool allowed);

} // namespace evil
