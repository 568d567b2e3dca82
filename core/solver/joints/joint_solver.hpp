#pragma once
// Joints inside the contact solver's substeps: each is prepared once a step, then solved with the contacts.
#include "math/cpu.hpp"
#include "solver/colouring.hpp"
#include "solver/joints/chains.hpp"
#include "solver/joints/joint.hpp"
#include "solver/joints/joint_blocks.hpp"

namespace evil {

struct Solver;
struct StepSize;

struct SolvedJoint {           // where a joint went
    std::uint32_t joint, a, b; // rows of the solver's bodies
    Place place;
    bool link = false;                   // holds a point stiffly, whatever it does about turning
    bool seen = false, in_chain = false; // by find_chains; what is in a chain has a block for its turning alone
};

struct JointColours { // while the edges stay as they are, so do the colours
    std::vector<Edge> edges;
    Colouring colouring;
};

struct JointSolver { // Scratch
    std::vector<SolvedJoint> at_points, at_axes;
    JointColours point_colours, axis_colours;
    std::vector<PointBlock> points;
    std::vector<AxisBlock> axes;
    std::vector<DriveBlock> drives;
    std::vector<SoftLanes> softs;
    std::vector<LoneJoint> alone;
    std::vector<ChainLink> links;         // of chains, each from one end to the other
    std::vector<std::uint32_t> ends, row; // while chains are looked for: by body, its two joints; a row of joints
    JointPass pass;
    bool fresh = true; // arms and errors are still to be found
};

// Once a step: find those whose bodies move, and give each its lane.
void prepare_joints(Solver& solver, const Bodies& bodies, const Joints& joints, StepSize step);
// In every substep: before the first push, with the contacts, and after the bodies have moved.
void warm_start_joints(Solver& solver, InstructionSet set);
void solve_joints(Solver& solver, InstructionSet set);
void relax_joints(Solver& solver, InstructionSet set);
// At its end: impulses for the next step, and forces for whoever reads them.
void store_joints(const Solver& solver, Joints& joints, StepSize step);

} // namespace evil
