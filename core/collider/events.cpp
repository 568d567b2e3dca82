#include "collider/events.hpp"
#include "collider/narrow_phase.hpp"
#include <tuple>

namespace evil {
namespace {

// They overlapped or pushed. A pair that touched goes on touching until there is a gap, so that resting contacts, which
// hover round zero, do not end and begin again.
bool touches_now(const Contact& c) {
    float gap = c.touching ? kSlop : 0.0f;
    for (std::uint8_t i = 0; i < c.count; ++i)
        if (c.points[i].total_impulse > 0.0f || c.points[i].separation <= gap) return true;
    return false;
}

// They pushed each other, having come together that fast.
bool hits(const Contact& c, float speed) {
    for (std::uint8_t i = 0; i < c.count; ++i)
        if (c.points[i].total_impulse > 0.0f && c.points[i].closing_speed > speed) return true;
    return false;
}

bool at_rest(const Body& b) { return b.kind == BodyKind::fixed || (b.kind == BodyKind::dynamic && !b.awake); }

// Does the sensor of this pair see the other, where they are after the step? Of two at rest it knows.
bool sees(Contact& c, const Shapes& shapes, const Bodies& bodies) {
    const Body &a = bodies.rows[c.body_a], &b = bodies.rows[c.body_b];
    bool resting = at_rest(a) && at_rest(b);
    if (resting && c.terms == Terms::settled_sensor) return c.touching;
    c.terms = resting ? Terms::settled_sensor : Terms::sensor;
    Axis none;
    const Piece &p = shapes.pieces[c.piece_a], &q = shapes.pieces[c.piece_b];
    return collide(place(shapes, p, a.pose), place(shapes, q, b.pose), 0.0f, none).count > 0;
}

bool earlier(const Touch& s, const Touch& t) { return std::tie(s.order, s.sensor) < std::tie(t.order, t.sensor); }
bool same(const Touch& s, const Touch& t) { return s.order == t.order && s.sensor == t.sensor; }

// Where they touch and how hard. Of two that have parted: where they touched last.
void describe(Touch& t, const Contact& c, Vec2 centre_a) {
    float weight = 0.0f, share = 1.0f / static_cast<float>(c.count);
    float deepest = c.points[0].separation;
    Vec2 mean, pressed;
    for (std::uint8_t i = 0; i < c.count; ++i) {
        const ManifoldPoint& p = c.points[i];
        Vec2 at = centre_a + p.anchor_a;
        mean += share * at;
        pressed += p.total_impulse * at;
        weight += p.total_impulse;
        deepest = std::min(deepest, p.separation);
        t.speed = std::max(t.speed, p.closing_speed);
    }
    if (c.count == 0) mean = centre_a + c.points[0].anchor_a;
    t.point = weight > 0.0f ? (1.0f / weight) * pressed : mean; // where the push went through
    if (!is_finite(t.point)) t.point = mean;
    t.depth = std::max(0.0f, -deepest);
    t.impulse = clamped(weight, kMaxForce);
}

Touch touch_of(const Contact& c, const Shapes& shapes, const Bodies& bodies) {
    std::uint32_t in_a = shape_a(c, shapes), in_b = shape_b(c, shapes);
    bool swap =
        c.sensor() ? shapes.rows[in_b].traits.sensor : bodies.rows[c.body_b].serial < bodies.rows[c.body_a].serial;
    std::uint32_t a = swap ? c.body_b : c.body_a, b = swap ? c.body_a : c.body_b;
    std::uint32_t sa = swap ? in_b : in_a, sb = swap ? in_a : in_b;
    Touch t;
    t.a = {a, bodies.slots.generation(a)};
    t.b = {b, bodies.slots.generation(b)};
    t.shape_a = {sa, shapes.slots.generation(sa)};
    t.shape_b = {sb, shapes.slots.generation(sb)};
    t.order[0] = bodies.rows[a].serial;
    t.order[1] = bodies.rows[b].serial;
    t.order[2] = shapes.rows[sa].serial;
    t.order[3] = shapes.rows[sb].serial;
    t.sensor = c.sensor();
    if (t.sensor) return t;
    t.normal = swap ? -c.normal : c.normal;
    describe(t, c, bodies.rows[c.body_a].centre);
    return t;
}

// Several pieces of one pair of shapes are one touch: the deepest tells where, the impulses add up.
void join(Touch& into, const Touch& t) {
    float impulse = clamped(into.impulse + t.impulse, kMaxForce), speed = std::max(into.speed, t.speed);
    if (t.depth > into.depth || (t.depth == into.depth && t.impulse > into.impulse)) into = t;
    into.impulse = impulse;
    into.speed = speed;
}

// What may be told: simple contacts that changed, all pieces of compound ones, and those that are gone. Of those that are not
// marked, nothing has changed.
void gather_changes(Events& events, Contacts& contacts, const Shapes& shapes, const Bodies& bodies) {
    auto& changes = events.scratch.changes;
    changes.clear();
    auto add = [&](const Touch& touch, bool was, bool is, bool struck) {
        changes.push_back({touch, static_cast<std::uint32_t>(changes.size()), was, is, struck});
    };
    for (const Touch& t : events.lost) add(t, true, false, false);
    for (const Contact& c : contacts.scratch.parted) add(touch_of(c, shapes, bodies), true, false, false);
    for_each_marked(contacts.scratch.marks, kTelling, [&](std::uint32_t row) {
        Contact& c = contacts.rows[row];
        bool was = c.touching, struck = hits(c, events.hit_speed), again = struck && c.struck;
        c.touching = c.sensor() ? sees(c, shapes, bodies) : touches_now(c);
        c.struck = struck;
        if (c.compound ? was || c.touching : was != c.touching || (struck && !again))
            add(touch_of(c, shapes, bodies), was, c.touching, struck && !again);
    });
    events.lost.clear();
    contacts.scratch.parted.clear();
}

void tell(Events& events, const Events::Change& change) {
    bool sensor = change.touch.sensor;
    if (change.is && !change.was) (sensor ? events.entered : events.begun).push_back(change.touch);
    if (change.struck) events.hit.push_back(change.touch);
    if (!change.was || change.is) return;
    Touch& t = (sensor ? events.left : events.ended).emplace_back(change.touch);
    t.depth = t.impulse = t.speed = 0.0f;
}

void tell_changes(Events& events) {
    auto& changes = events.scratch.changes;
    events.begun.clear();
    events.ended.clear();
    events.hit.clear();
    events.entered.clear();
    events.left.clear();
    if (!std::ranges::is_sorted(changes, earlier, &Events::Change::touch))
        std::ranges::sort(changes, [](const Events::Change& c, const Events::Change& d) {
            return std::tie(c.touch.order, c.touch.sensor, c.number) <
                   std::tie(d.touch.order, d.touch.sensor, d.number);
        });
    for (std::size_t i = 0; i < changes.size();) {
        Events::Change& whole = changes[i++];
        for (; i < changes.size() && same(whole.touch, changes[i].touch); ++i) {
            const Events::Change& part = changes[i];
            if (part.is && whole.is)
                join(whole.touch, part.touch);
            else if (part.is)
                whole.touch = part.touch;
            whole.was |= part.was;
            whole.is |= part.is;
            whole.struck |= part.struck;
        }
        tell(events, whole);
    }
}

void by_creation(const Bodies& bodies, std::vector<BodyRef>& list) {
    std::ranges::sort(list, {}, [&](BodyRef ref) { return bodies.rows[ref.slot].serial; });
}

void tell_sleep(Events& events, Bodies& bodies) {
    for (std::uint32_t slot = 0; slot < bodies.slots.size(); ++slot) {
        Body& b = bodies.rows[slot];
        if (b.awake == b.told_awake) continue;
        b.told_awake = b.awake;
        if (bodies.slots.taken(slot))
            (b.awake ? events.woke : events.slept).push_back({slot, bodies.slots.generation(slot)});
    }
    by_creation(bodies, events.slept);
    by_creation(bodies, events.woke);
}

} // namespace

void find_events(Events& events, Contacts& contacts, const Shapes& shapes, Bodies& bodies, bool sleep_changed) {
    gather_changes(events, contacts, shapes, bodies);
    tell_changes(events);
    events.slept.clear();
    events.woke.clear();
    if (sleep_changed) tell_sleep(events, bodies);
}

std::vector<Touch> active_touches(const Contacts& contacts, const Shapes& shapes, const Bodies& bodies, bool sensors) {
    std::vector<Touch> all;
    for (const Contact& c : contacts.rows)
        if (c.touching && c.sensor() == sensors) all.push_back(touch_of(c, shapes, bodies));
    std::ranges::stable_sort(all, earlier);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (kept > 0 && same(all[kept - 1], all[i]))
            join(all[kept - 1], all[i]);
        else
            all[kept++] = all[i];
    }
    all.resize(kept);
    return all;
}

void lose(Events& events, const Contact& contact, const Shapes& shapes, const Bodies& bodies) {
    events.lost.push_back(touch_of(contact, shapes, bodies));
}

} // namespace evil
