#pragma once
// The life of contacts: born with a pair of bounds, given a manifold each step, told as events when touching changes.
#include "collider/contact.hpp"

namespace evil {

// Keep the contacts whose pair is still there, drop the others, add new ones.
void match_pairs(Contacts& contacts, const Shapes& shapes);

// Manifolds where the bodies now are; each point takes over the impulses of the point with its id in the last step.
void update_manifolds(Contacts& contacts, const Shapes& shapes, const Bodies& bodies, float dt);

// After the solver: who touches whom, and what began or ended since the last step.
void find_events(Contacts& contacts, const Shapes& shapes, const Bodies& bodies);

// Before an object goes: drop the contacts of a shape, and remember to tell their end.
void forget_shape(Contacts& contacts, std::uint32_t shape);

} // namespace evil
