#pragma once
#include "solver/solver.hpp"

namespace evil {

enum class Pass { push_apart, relax };

void prepare_contacts(Solver& solver, const Bodies& bodies, const Contacts& contacts, StepSize step);
void warm_start(Solver& solver);
void solve_contacts(Solver& solver, float h, Pass pass);
void sum_impulses(Solver& solver);
void apply_restitution(Solver& solver);
void store_impulses(const Solver& solver, Contacts& contacts);

} // namespace evil
