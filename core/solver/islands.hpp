#pragma once
// Islands: bodies joined by contacts, joints or springs. They wake together and sleep together.
#include "bodies.hpp"
#include "collider/contact.hpp"
#include "forces/forces.hpp"
#include "solver/joints/joint.hpp"

namespace evil {

// By body slot: the root of its island, which is the lowest slot of it. What does not move is in none: it is its own root.
void find_islands(std::vector<std::uint32_t>& island_of, const Bodies& bodies, const Contacts& contacts,
                  const Joints& joints, const Forces& forces);

} // namespace evil
