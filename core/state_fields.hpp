#pragma once
// Which fields the State of a world has, for whoever writes, reads or sums it.
#include "archive.hpp"
#include "world.hpp"
#include <algorithm>

namespace evil {

// ---- fields, in one place for both directions (archives find them by their argument) ---

template <class A, Like<std::string> V> void visit(A& ar, V& text) {
    std::size_t n = ar.count(text.size());
    if constexpr (A::reading) text.resize(n);
    for (auto& c : text) ar.value(c);
}

template <class A, class Element> void visit(A& ar, std::vector<Element>& list);
template <class A, class Element> void visit(A& ar, const std::vector<Element>& list);

template <class A, Like<Body> V> void visit(A& ar, V& b) {
    visit(ar, b.kind, b.bullet, b.touchable, b.awake, b.told_awake, b.pose, b.angle, b.scale, b.centre, b.local_centre,
          b.velocity, b.spin, b.force, b.torque, b.acceleration, b.mass, b.inv_mass, b.inertia, b.inv_inertia,
          b.set_mass, b.damping, b.angular_damping, b.drag, b.gravity_scale, b.density, b.friction, b.restitution,
          b.still_time, b.serial, b.born, b.first_shape, b.last_shape);
}

template <class A, Like<Traits> V> void visit(A& ar, V& t) {
    visit(ar, t.category, t.mask, t.group, t.sensor, t.one_way, t.surface_speed);
}

template <class A, Like<Shape> V> void visit(A& ar, V& s) {
    visit(ar, s.kind, s.closed, s.body, s.next, s.first_piece, s.local, s.radius, s.mass, s.material.density,
          s.material.friction, s.material.restitution, s.traits, s.serial, s.born);
}

template <class A, Like<ManifoldPoint> V> void visit(A& ar, V& p) {
    visit(ar, p.anchor_a, p.anchor_b, p.separation, p.normal_impulse, p.tangent_impulse, p.total_impulse,
          p.closing_speed, p.id);
}

template <class A, Like<Contact> V> void visit(A& ar, V& c) {
    visit(ar, c.piece_a, c.piece_b, c.axis.edge, c.axis.of_b, c.axis.known, c.count, c.touching, c.struck, c.passage,
          c.normal, c.friction, c.restitution, c.points[0], c.points[1]);
}

template <class A, Like<Touch> V> void visit(A& ar, V& t) { // references by slot; generations are a process's own
    visit(ar, t.a.slot, t.b.slot, t.shape_a.slot, t.shape_b.slot, t.order[0], t.order[1], t.order[2], t.order[3],
          t.sensor, t.point, t.normal, t.depth, t.impulse, t.speed);
}

template <class A, Like<Force> V> void visit(A& ar, V& f) {
    visit(ar, f.kind, f.everywhere, f.vector, f.anchor, f.at_anchor, f.target, f.stiffness, f.rest_length, f.damping,
          f.linear, f.quadratic, f.limit, f.density, f.serial, f.born);
    visit(ar, f.bodies);
    visit(ar, f.note);
}

template <class A, Like<JointDrive> V> void visit(A& ar, V& d) {
    visit(ar, d.held, d.limited, d.motor, d.rest, d.lower, d.upper, d.speed, d.most, d.frequency, d.damping_ratio,
          d.stiffness, d.damping, d.spring_most, d.spring_impulse, d.motor_impulse, d.lower_impulse, d.upper_impulse);
}

template <class A, Like<Joint> V> void visit(A& ar, V& j) {
    visit(ar, j.kind, j.collide, j.body_a, j.body_b, j.anchor_a, j.anchor_b, j.axis, j.over_a, j.over_b, j.reference,
          j.ratio, j.along, j.turn, j.breaking_force, j.breaking_torque, j.impulse, j.force, j.torque, j.serial,
          j.born);
}

template <class A, Like<Abilities> V> void visit(A& ar, V& a) {
    visit(ar, a.speed, a.acceleration, a.deceleration, a.air_acceleration, a.air_deceleration, a.jump_height,
          a.jump_cut, a.coyote_time, a.jump_buffer, a.air_jumps, a.gravity_scale, a.fall_speed, a.max_slope,
          a.step_height, a.climb_speed, a.push_force, a.mass);
}

template <class A, Like<Ladder> V> void visit(A& ar, V& l) { visit(ar, l.low, l.high); }

template <class A, Like<Character> V> void visit(A& ar, V& c) { // what a step found out is told after it, and not saved
    visit(ar, c.body, c.abilities, c.wish.move, c.wish.climb, c.wish.jump);
    visit(ar, c.ladders);
    visit(ar, c.velocity, c.grounded, c.climbing, c.rising, c.crushed, c.ground, c.ground_normal, c.ground_velocity,
          c.wall, c.since_ground, c.belt, c.dropping, c.jump_wanted, c.jumps_left);
}

template <class A, Like<Area> V> void visit(A& ar, V& a) {
    visit(ar, a.centre, a.radius);
    visit(ar, a.parts);
}

template <class A, class Element> void visit(A& ar, std::vector<Element>& list) {
    list.resize(ar.count());
    for (auto& element : list) visit(ar, element);
}
template <class A, class Element> void visit(A& ar, const std::vector<Element>& list) {
    ar.count(list.size());
    for (auto& element : list) visit(ar, element);
}

// ---- tables: a bit a slot says which are taken, their rows follow ------------------------------------------------
// So a file asks for memory in proportion to its length, however few of its slots are taken.

inline void write_table(auto& ar, const Slots& slots, auto&& write_row) {
    std::uint32_t end = slots.size(); // of the taken ones; the free ones beyond are no part of the State
    while (end > 0 && !slots.taken(end - 1)) --end;
    ar.count(end);
    for (std::uint32_t first = 0; first < end; first += 8) {
        std::uint8_t bits = 0;
        for (std::uint32_t k = 0; k < 8; ++k) bits |= static_cast<std::uint8_t>(slots.taken(first + k) << k);
        ar.value(bits);
    }
    for (std::uint32_t slot = 0; slot < end; ++slot)
        if (slots.taken(slot)) write_row(slot);
}

inline constexpr std::size_t kMostSlotsRead = std::size_t{1} << 24;

inline void read_taken(Reader& ar, std::vector<bool>& taken) {
    std::uint64_t end = 0;
    ar.value(end);
    ar.ok = ar.ok && end <= kMostSlotsRead && (end + 7) / 8 <= ar.left();
    if (!ar.ok) return;
    taken.resize(end);
    for (std::size_t first = 0; first < end; first += 8) {
        std::uint8_t bits = 0;
        ar.value(bits);
        for (std::size_t k = 0; k < 8 && first + k < end; ++k) taken[first + k] = (bits >> k) & 1u;
        if (first + 8 >= end && bits >> (end - first - 1) != 1) ar.ok = false; // the last is taken, and none beyond
    }
}

void read_table(Reader& ar, std::vector<bool>& taken, auto&& grow, auto&& read_row) {
    read_taken(ar, taken);
    if (!ar.ok) return;
    grow(taken.size());
    for (std::uint32_t slot = 0; slot < taken.size() && ar.ok; ++slot)
        if (taken[slot]) read_row(slot);
}

inline void write_holes(auto& ar, const Shapes& shapes) { // few shapes have any
    auto has_some = [&](const auto& holes) { return !holes.empty(); };
    ar.count(static_cast<std::size_t>(std::ranges::count_if(shapes.holes, has_some)));
    for (std::uint32_t slot = 0; slot < shapes.holes.size(); ++slot) {
        if (shapes.holes[slot].empty()) continue;
        ar.value(slot);
        visit(ar, shapes.holes[slot]);
    }
}

inline void write_bodies(auto& ar, const World& w) {
    write_table(ar, w.bodies.slots, [&](std::uint32_t slot) {
        visit(ar, w.bodies.rows[slot]);
        visit(ar, w.bodies.tags[slot]);
        visit(ar, w.bodies.traits[slot]);
    });
    write_table(ar, w.shapes.slots, [&](std::uint32_t slot) {
        visit(ar, w.shapes.rows[slot]);
        visit(ar, w.shapes.corners[slot]);
        visit(ar, w.shapes.parts[slot]);
    });
    write_holes(ar, w.shapes);
    write_table(ar, w.shapes.piece_slots, [&](std::uint32_t slot) { // the rest of a piece follows from its shape
        visit(ar, w.shapes.pieces[slot].shape, w.shapes.pieces[slot].next);
    });
}

inline void write_forces(auto& ar, const World& w) {
    write_table(ar, w.forces.slots, [&](std::uint32_t slot) {
        visit(ar, w.forces.rows[slot]);
        visit(ar, w.forces.areas[slot]);
    });
}

inline void write_joints(auto& ar, const World& w) {
    write_table(ar, w.joints.slots, [&](std::uint32_t slot) { visit(ar, w.joints.rows[slot]); });
}

inline void write_contacts(auto& ar, const World& w) {
    visit(ar, w.contacts.rows);
    visit(ar, w.events.hit_speed, w.events.lost);
}

} // namespace evil
