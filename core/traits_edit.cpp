// How shapes deal with those they meet, changed by hand: what touches them wakes, and every pair is tested anew.
#include "world.hpp"

namespace evil {
namespace {

bool meets_alike(const Traits& s, const Traits& t) {
    return s.category == t.category && s.mask == t.mask && s.group == t.group && s.sensor == t.sensor &&
           s.one_way == t.one_way;
}

} // namespace

void set_traits(World& world, std::uint32_t shape, const Traits& traits) {
    Shape& row = world.shapes.rows[shape];
    if (row.traits == traits) return;
    auto of_shape = [&](const Contact& c) { return is_of_shape(c, world.shapes, shape); };
    wake_touching(world, row.body);
    if (!meets_alike(row.traits,
                     traits)) // a pair that meets still is found again in the next step, and nothing is told
        forget_contacts(world.events, world.contacts, world.shapes, world.bodies, of_shape);
    row.traits = traits;
    for (std::uint32_t p = row.first_piece; p != kNone; p = world.shapes.pieces[p].next)
        world.shapes.pieces[p].sensor = traits.sensor;
    for (Contact& c : world.contacts.rows)
        if (of_shape(c)) mark(c, world.shapes);
    note_edit(world.search, row.body);
}

} // namespace evil
