#pragma once
// Between contacts as the collider knows them and the blocks that are solved.
#include "solver/solver.hpp"

namespace evil {

void fill_blocks(Solver& solver, const Bodies& bodies, const Contacts& contacts, StepSize step);
void apply_restitution(Solver& solver, StepSize step);
void store_impulses(const Solver& solver, Contacts& contacts);

} // namespace evil
