#pragma once
// Chains: joints in a row, each on a body of the one before, as ropes are and bridges. Solved one after the other, a push
// needs as many passes to get from one end to the other as there are links, and the chain stretches. Solved at once, as
// here, a chain of any length and load holds in one pass.
//
//     wall o----o----o----o----o ball        joint i shares a body with i - 1 and with i + 1, and with no other
//
// The equations of all joints of a chain are then a band: each has two unknowns (the push along x and y) and terms with those
// of its two neighbours alone. It is solved from one end to the other and back (block elimination; Golub and Van Loan,
// "Matrix Computations", 4.5), in time that grows with the number of joints.
//
// Joints in a row give way a little, as very stiff springs. Were they not to at all, a bridge that is pulled straight would
// bear what stands on it with pushes without bound, since nothing that pulls along it holds what presses across it, and
// throw it off. And the give makes equations solvable that say some things twice.
#include "math/vec2.hpp"
#include "solver/contact_blocks.hpp"
#include "solver/joints/joint_blocks.hpp"
#include <cstdint>
#include <span>

namespace evil {

struct Matrix2 { // doubles: what is left of a long chain's equations is small
    double xx = 0, xy = 0, yx = 0, yy = 0;
};

struct ChainLink {                  // a joint in a chain
    std::uint32_t joint = 0;        // its slot
    std::uint32_t a = 0, b = 0;     // rows of bodies
    bool shares_a = false;          // a, not b, is the body that it has in common with the link before
    bool begins = false;            // a chain: there is no link before
    Vec2 start_a, start_b, gap;     // arms and way from centre to centre when the step began
    Vec2 arm_a, arm_b, error;       // in this substep
    float turns_a = 0, turns_b = 0; // what a push turns of the bodies; see hold_still
    Vec2 impulse, total;
    Matrix2 inverse, before;       // of the equations: what is left of its own, and the terms with the link before
    double give_x = 0, give_y = 0; // what a push leaves over of the speed
    double x = 0, y = 0;           // right side, then solution
};

void begin_chains(std::span<ChainLink> links, std::span<const SolverBody> bodies, const JointPass& pass);
void warm_chains(std::span<const ChainLink> links, std::span<SolverBody> bodies);
void move_chains(std::span<ChainLink> links, std::span<SolverBody> bodies, const JointPass& pass);
void calm_chains(std::span<ChainLink> links, std::span<SolverBody> bodies, const JointPass& pass);

} // namespace evil
