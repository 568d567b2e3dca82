#include "collider/contacts.hpp"
#include "collider/narrow_phase.hpp"

namespace evil {
namespace {

Contact new_contact(Pair pair, const Shapes& shapes) {
    Contact c;
    c.piece_a = pair.a;
    c.piece_b = pair.b;
    c.shape_a = shapes.pieces[pair.a].shape;
    c.shape_b = shapes.pieces[pair.b].shape;
    c.body_a = shapes.pieces[pair.a].body;
    c.body_b = shapes.pieces[pair.b].body;
    mark(c, shapes);
    return c;
}

// A contact goes when not even the bounds meet any more. Its end is told if it touched.
void drop(Contacts& contacts, const Contact& c) {
    if (c.touching) contacts.scratch.parted.push_back(c);
}

// Contacts in advance of touching, so that a fast body is slowed just enough (SPEC C8); no further than half the smaller
// piece, since beyond that a face's plane says little about where the other will be.
float margin_of(const Piece& p, const Piece& q, const Body& a, const Body& b, float dt) {
    float arms = std::abs(a.spin) * p.reach + std::abs(b.spin) * q.reach;
    float path = dt * (length(b.velocity - a.velocity) + arms);
    return kMargin + std::min(path, 0.5f * std::min(p.reach, q.reach));
}

// Whatever moves a body by hand wakes those it has contacts with.
bool at_rest(const Body& b) { return b.kind == BodyKind::fixed || (b.kind == BodyKind::dynamic && !b.awake); }

// The manifold of bodies that have parted stays as it was last: it says where they touched.
void take_over(Contact& c, const ManifoldSketch& sketch, const Body& a, const Body& b) {
    if (sketch.count == 0) {
        c.count = 0;
        return;
    }
    ManifoldPoint old[2] = {c.points[0], c.points[1]};
    std::uint8_t old_count = c.count;
    c.count = sketch.count;
    c.normal = sketch.normal;
    for (std::uint8_t i = 0; i < 2; ++i) {
        ManifoldPoint& point = c.points[i] = {};
        if (i >= c.count) continue;
        point.id = sketch.points[i].id;
        point.separation = sketch.points[i].separation;
        point.anchor_a = sketch.points[i].at - a.centre;
        point.anchor_b = sketch.points[i].at - b.centre;
        for (std::uint8_t j = 0; j < old_count; ++j) {
            if (old[j].id != point.id) continue;
            point.normal_impulse = old[j].normal_impulse;
            point.tangent_impulse = old[j].tangent_impulse;
        }
    }
}

} // namespace

void match_pairs(Contacts& contacts, const Shapes& shapes, Joints& joints) {
    auto& next = contacts.scratch.rows;
    next.clear();
    contacts.scratch.parted.clear();
    bool tied = joints.matched != joints.next_serial; // then what touched may have to part
    joints.matched = joints.next_serial;
    auto old = contacts.rows.begin(), end = contacts.rows.end();
    for (Pair pair : contacts.scratch.pairs) {
        while (old != end && Pair{old->piece_a, old->piece_b} < pair) drop(contacts, *old++);
        bool kept = old != end && Pair{old->piece_a, old->piece_b} == pair;
        if ((!kept || tied) && kept_apart(joints, shapes.pieces[pair.a].body, shapes.pieces[pair.b].body)) {
            if (kept) drop(contacts, *old++);
            continue;
        }
        next.push_back(kept ? *old++ : new_contact(pair, shapes));
    }
    while (old != end) drop(contacts, *old++);
    std::swap(contacts.rows, next);
}

void mark(Contact& c, const Shapes& shapes) {
    c.compound = shapes.pieces[shapes.rows[c.shape_a].first_piece].next != kNone ||
                 shapes.pieces[shapes.rows[c.shape_b].first_piece].next != kNone;
}

void update_manifolds(Contacts& contacts, const Shapes& shapes, const Bodies& bodies, float dt) {
    for (Contact& c : contacts.rows) {
        const Body &a = bodies.rows[c.body_a], &b = bodies.rows[c.body_b];
        if (!c.fresh && at_rest(a) && at_rest(b)) continue; // nothing has changed between them
        c.fresh = false;
        const Material &m = shapes.rows[c.shape_a].material, &n = shapes.rows[c.shape_b].material;
        c.friction = std::sqrt(m.friction * n.friction); // SPEC C5
        c.restitution = std::max(m.restitution, n.restitution);
        const Piece &p = shapes.pieces[c.piece_a], &q = shapes.pieces[c.piece_b];
        float margin = margin_of(p, q, a, b, dt);
        take_over(c, collide(place(shapes, p, a.pose), place(shapes, q, b.pose), margin, c.axis), a, b);
    }
}

} // namespace evil
