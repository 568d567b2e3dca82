#include "fluid/state.hpp"
#include "snapshot.hpp"

namespace evil {
Sums sums(const World& world) {
    HashWriter bodies, contacts, forces;
    write_bodies(bodies, world);
    write_contacts(contacts, world);
    visit(forces, world.gravity);
    write_forces(forces, world);
    write_joints(forces, world);
    if (!world.characters.rows.empty()) visit(bodies, world.characters.rows);
    if (world.fluids.any()) write_fluids(forces, world.fluids);
    return {bodies.sum(), contacts.sum(), forces.sum()};
}

} // namespace evil
