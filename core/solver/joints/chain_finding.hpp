#pragma once
#include "bodies.hpp"
#include "solver/joints/joint.hpp"

namespace evil {

struct JointSolver;
struct SolverBody;

// Which of the joints at points lie in a row, three and more of them, and their links from one end to the other. The row
// of a ring has no end, and a net's bodies have more than two joints: those are solved one joint after the other.
void find_chains(JointSolver& solver, std::span<const SolverBody> rows, const Bodies& bodies, const Joints& joints);

} // namespace evil
