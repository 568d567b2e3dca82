#pragma once
// Platforms that are solid from one side (Traits::one_way): what comes from there stands, what comes from elsewhere passes.
#include "collider/contact.hpp"

namespace evil {

// After the manifold of a contact that is marked one_way: decide, and take the points away while one passes the other. What
// was decided holds until they are apart.
void decide_passage(Contact& contact, const Shapes& shapes, const Bodies& bodies, float dt);

} // namespace evil
