#include "collider/contacts.hpp"
#include "collider/filter.hpp"

namespace evil {
namespace {

Contact new_contact(Pair pair, const Shapes& shapes) {
    Contact c;
    c.piece_a = pair.a;
    c.piece_b = pair.b;
    c.body_a = shapes.pieces[pair.a].body;
    c.body_b = shapes.pieces[pair.b].body;
    mark(c, shapes);
    return c;
}

const Traits& traits_of(std::uint32_t piece, const Shapes& shapes) {
    return shapes.rows[shapes.pieces[piece].shape].traits;
}

Pair key(const Contact& c) { return {c.piece_a, c.piece_b}; }

// A contact goes when not even the bounds meet any more. Its end is told if it touched.
void drop(Contacts& contacts, const Contact& c) {
    if (c.touching) contacts.scratch.parted.push_back(c);
}

} // namespace

void match_pairs(Contacts& contacts, const Shapes& shapes, Joints& joints, bool changed) {
    auto& s = contacts.scratch;
    s.parted.clear();
    bool tied = joints.matched != joints.next_serial; // then what touched may have to part
    joints.matched = joints.next_serial;
    bool all_had_rows = s.matched_rows == contacts.rows.size() && s.matched_rows == s.pairs.size();
    bool as_matched = s.matched.size() == s.pairs.size() && (!changed || s.matched == s.pairs);
    if (!tied && all_had_rows && as_matched) return;
    auto apart = [&](Pair pair) { return kept_apart(joints, shapes.pieces[pair.a].body, shapes.pieces[pair.b].body); };
    auto meet = [&](Pair pair) {
        return !apart(pair) && may_meet(traits_of(pair.a, shapes), traits_of(pair.b, shapes));
    };
    s.rows.clear();
    auto old = contacts.rows.begin(), end = contacts.rows.end();
    for (auto pair = s.pairs.begin(); pair != s.pairs.end();) {
        while (old != end && key(*old) < *pair) drop(contacts, *old++);
        auto kept = old; // most go on, in long runs
        while (kept != end && pair != s.pairs.end() && key(*kept) == *pair && !(tied && apart(*pair))) ++kept, ++pair;
        s.rows.insert(s.rows.end(), old, kept);
        old = kept;
        if (pair == s.pairs.end()) break;
        if (old != end && key(*old) < *pair) continue;
        if (old != end && key(*old) == *pair)
            drop(contacts, *old++);
        else if (meet(*pair))
            s.rows.push_back(new_contact(*pair, shapes));
        ++pair;
    }
    while (old != end) drop(contacts, *old++);
    std::swap(contacts.rows, s.rows);
    s.matched = s.pairs;
    s.matched_rows = contacts.rows.size();
}

void mark(Contact& c, const Shapes& shapes) {
    const Shape &a = shapes.rows[shape_a(c, shapes)], &b = shapes.rows[shape_b(c, shapes)];
    c.compound = shapes.pieces[a.first_piece].next != kNone || shapes.pieces[b.first_piece].next != kNone;
    const Traits &s = a.traits, &t = b.traits;
    bool sensor = s.sensor || t.sensor, one_way = s.one_way != Vec2{} || t.one_way != Vec2{};
    if (!sensor || !c.sensor()) c.terms = sensor ? Terms::sensor : one_way ? Terms::one_way : Terms::plain;
    c.surface_speed = s.surface_speed + t.surface_speed;
}

} // namespace evil
