#pragma once
// Between contacts as the collider knows them and the blocks that are solved.
#include "solver/solver.hpp"

namespace evil {

struct ContactSoftnesses {
    ContactSoftness between, walls;
};
ContactSoftnesses softness_of(StepSize step);

void prepare_contacts(Solver& solver, const Bodies& bodies, Contacts& contacts, StepSize step, Threads& threads);
void apply_restitution(Solver& solver, const Contacts& contacts, StepSize step);
void finish_contacts(Solver& solver, Contacts& contacts, StepSize step, Threads& threads);

} // namespace evil
