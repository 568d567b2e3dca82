#pragma once
// The life of contacts: born with a pair of bounds, given a manifold each step. What of it is told: collider/events.hpp.
#include "collider/contact.hpp"
#include "solver/joints/joint.hpp"

namespace evil {

// Keep the contacts whose pair is still there, drop the others, add new ones; none between bodies that a joint keeps apart.
// `changed`: the pairs may be others than in the last step.
void match_pairs(Contacts& contacts, const Shapes& shapes, Joints& joints, bool changed);

// Manifolds where the bodies now are; each point takes over the impulses of the point with its id in the last step.
void update_manifolds(Contacts& contacts, const Placements& placed, const Shapes& shapes, const Bodies& bodies,
                      float dt, InstructionSet set, Threads& threads);
// The same by collide() alone: what the wide kernels are tested against.
void update_manifolds_one_by_one(Contacts& contacts, const Shapes& shapes, const Bodies& bodies, float dt);

// What a contact is by its shapes alone.
void mark(Contact& contact, const Shapes& shapes);

} // namespace evil
