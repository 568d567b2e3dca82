#include "identity.hpp"
#include "state_fields.hpp"

namespace evil {

std::uint64_t fingerprint(const NewShape& shape) {
    const Shape& s = shape.shape;
    HashWriter print;
    visit(print, s.kind, s.closed, s.local, s.radius, s.mass, s.material.density, s.material.friction,
          s.material.restitution);
    visit(print, shape.rings.corners);
    visit(print, shape.rings.holes);
    return print.sum();
}

std::uint64_t fingerprint(const Body& b, const std::string& tag, std::span<const NewShape> shapes) {
    HashWriter print;
    visit(print, b.kind, b.bullet, b.touchable, b.pose.p, b.angle, b.velocity, b.spin, b.set_mass, b.damping,
          b.angular_damping, b.drag, b.gravity_scale, b.density, b.friction, b.restitution);
    visit(print, tag);
    for (const NewShape& shape : shapes) print.value(fingerprint(shape));
    return print.sum();
}

std::uint64_t fingerprint(const Force& f, const Area& area) {
    HashWriter print;
    visit(print, f.kind, f.everywhere, f.vector, f.anchor, f.at_anchor, f.target, f.stiffness, f.rest_length, f.damping,
          f.linear, f.quadratic, f.limit, f.density);
    visit(print, f.note);
    visit(print, area);
    return print.sum();
}

std::uint64_t fingerprint(const Joint& j) {
    HashWriter print;
    visit(print, j.kind, j.collide, j.body_a, j.body_b, j.anchor_a, j.anchor_b, j.axis, j.over_a, j.over_b, j.reference,
          j.ratio, j.breaking_force, j.breaking_torque);
    for (const JointDrive* d : {&j.along, &j.turn})
        visit(print, d->held, d->limited, d->motor, d->rest, d->lower, d->upper, d->speed, d->most, d->frequency,
              d->damping_ratio, d->stiffness, d->damping, d->spring_most);
    return print.sum();
}

} // namespace evil
