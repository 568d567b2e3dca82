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
    return c;
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

void take_over(Contact& c, const ManifoldSketch& sketch, const Body& a, const Body& b) {
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

// They overlapped or pushed. A pair that touched goes on touching until there is a gap, so that resting contacts, which
// hover round zero, do not end and begin again.
bool touches_now(const Contact& c) {
    float gap = c.touching ? kSlop : 0.0f;
    for (std::uint8_t i = 0; i < c.count; ++i)
        if (c.points[i].total_impulse > 0.0f || c.points[i].separation <= gap) return true;
    return false;
}

bool earlier(const Touch& s, const Touch& t) { return std::ranges::lexicographical_compare(s.order, t.order); }
bool same(const Touch& s, const Touch& t) { return std::ranges::equal(s.order, t.order); }

Touch touch_of(const Contact& c, const Shapes& shapes, const Bodies& bodies) {
    bool swap = bodies.rows[c.body_b].serial < bodies.rows[c.body_a].serial;
    std::uint32_t a = swap ? c.body_b : c.body_a, b = swap ? c.body_a : c.body_b;
    std::uint32_t sa = swap ? c.shape_b : c.shape_a, sb = swap ? c.shape_a : c.shape_b;
    Touch t;
    t.a = {a, bodies.slots.generation(a)};
    t.b = {b, bodies.slots.generation(b)};
    t.shape_a = {sa, shapes.slots.generation(sa)};
    t.shape_b = {sb, shapes.slots.generation(sb)};
    t.order[0] = bodies.rows[a].serial;
    t.order[1] = bodies.rows[b].serial;
    t.order[2] = shapes.rows[sa].serial;
    t.order[3] = shapes.rows[sb].serial;
    t.normal = swap ? -c.normal : c.normal;
    float weight = 0.0f, share = 1.0f / static_cast<float>(c.count);
    float deepest = c.points[0].separation;
    Vec2 mean, pressed;
    for (std::uint8_t i = 0; i < c.count; ++i) {
        const ManifoldPoint& p = c.points[i];
        Vec2 at = bodies.rows[c.body_a].centre + p.anchor_a;
        mean += share * at;
        pressed += p.total_impulse * at;
        weight += p.total_impulse;
        deepest = std::min(deepest, p.separation);
        t.speed = std::max(t.speed, p.closing_speed);
    }
    t.point = weight > 0.0f ? (1.0f / weight) * pressed : mean; // where the push went through
    if (!is_finite(t.point)) t.point = mean;
    t.depth = std::max(0.0f, -deepest);
    t.impulse = clamped(weight, kMaxForce);
    return t;
}

// Several pieces of one pair of shapes are one touch: the deepest tells where, the impulses add up.
void join(Touch& into, const Touch& t) {
    float impulse = clamped(into.impulse + t.impulse, kMaxForce), speed = std::max(into.speed, t.speed);
    if (t.depth > into.depth || (t.depth == into.depth && t.impulse > into.impulse)) into = t;
    into.impulse = impulse;
    into.speed = speed;
}

} // namespace

void match_pairs(Contacts& contacts, const Shapes& shapes) {
    auto& next = contacts.scratch.rows;
    next.clear();
    auto old = contacts.rows.begin();
    for (Pair pair : contacts.scratch.pairs) {
        while (old != contacts.rows.end() && Pair{old->piece_a, old->piece_b} < pair) ++old;
        bool kept = old != contacts.rows.end() && Pair{old->piece_a, old->piece_b} == pair;
        next.push_back(kept ? *old : new_contact(pair, shapes));
    }
    std::swap(contacts.rows, next);
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

void find_events(Contacts& contacts, const Shapes& shapes, const Bodies& bodies) {
    auto& now = contacts.scratch.touches;
    now.clear();
    for (Contact& c : contacts.rows) {
        c.touching = touches_now(c);
        if (c.touching) now.push_back(touch_of(c, shapes, bodies));
    }
    if (!std::ranges::is_sorted(now, earlier)) std::ranges::stable_sort(now, earlier);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < now.size(); ++i) {
        if (kept > 0 && same(now[kept - 1], now[i]))
            join(now[kept - 1], now[i]);
        else
            now[kept++] = now[i];
    }
    now.resize(kept);

    contacts.begun.clear();
    contacts.ended.clear();
    auto before = contacts.touches.begin(), before_end = contacts.touches.end();
    for (const Touch& t : now) {
        while (before != before_end && earlier(*before, t)) contacts.ended.push_back(*before++);
        if (before != before_end && same(*before, t))
            ++before;
        else
            contacts.begun.push_back(t);
    }
    while (before != before_end) contacts.ended.push_back(*before++);
    std::swap(contacts.touches, now);
}

void forget_shape(Contacts& contacts, std::uint32_t shape) {
    std::erase_if(contacts.rows, [&](const Contact& c) { return c.shape_a == shape || c.shape_b == shape; });
    for (Touch& t : contacts.touches)
        if (!t.gone && (t.shape_a.slot == shape || t.shape_b.slot == shape)) t.gone = true;
}

} // namespace evil
