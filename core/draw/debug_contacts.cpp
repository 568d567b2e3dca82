#include "draw/debug.hpp"

namespace evil::draw {
namespace {

// All in logical points.
constexpr float kArrow = 2.0f;
constexpr float kDot = 3.0f;
constexpr float kNormal = 22.0f;     // length of a normal: seen well, and shorter than a crate of a metre
constexpr float kMostPush = 140.0f;  // beyond, arrows hide the scene
constexpr float kRestSpeed = 0.164f; // m/s that a body falls within a sixtieth of a second: a push against it is
                                     // drawn as long as a normal

// The push of a point over the last step, on b: the normal one is known, friction keeps the last substep's share of it.
Vec2 push_of(const Contact& contact, const ManifoldPoint& point) {
    const float share = point.normal_impulse > 0.0f ? point.total_impulse / point.normal_impulse : 0.0f;
    const Vec2 tangent{contact.normal.y, -contact.normal.x}; // the normal turned right
    return point.total_impulse * contact.normal + (share * point.tangent_impulse) * tangent;
}

// Pushes differ by thousands within one heap, so an arrow four times as long is one sixteen times as strong.
void draw_push(const DebugFrame& f, const Contact& contact, const ManifoldPoint& point, Vec2 at) {
    const Body &a = f.world.bodies.rows[contact.body_a], &b = f.world.bodies.rows[contact.body_b];
    const float sign = b.inv_mass > 0.0f ? 1.0f : -1.0f; // what is pushed against a wall is a
    const Vec2 push = sign * push_of(contact, point);
    const float speed = length(push) * std::max(a.inv_mass, b.inv_mass); // of the lighter
    const float reach = std::min(kNormal * std::sqrt(speed / kRestSpeed), kMostPush);
    arrow(f.overlay, at, at + f.points(reach) * f.seen(push), f.points(kArrow), f.ink(Ink::impulse));
}

} // namespace

void draw_contact(const DebugFrame& f, const Contact& contact) {
    const Vec2 centre = f.world.bodies.rows[contact.body_a].centre;
    for (int i = 0; i < contact.count; ++i) {
        const Vec2 at = f.pixel(centre + contact.points[i].anchor_a);
        if (f.shows(Part::contacts)) {
            arrow(f.overlay, at, at + f.points(kNormal) * f.seen(contact.normal), f.points(kArrow),
                  f.ink(Ink::contact));
            disc(f.overlay, at, f.points(kDot), f.ink(Ink::contact));
        }
        if (f.shows(Part::impulses)) draw_push(f, contact, contact.points[i], at);
    }
}

} // namespace evil::draw
