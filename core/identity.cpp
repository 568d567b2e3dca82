#include "identity.hpp"
#include <bit>

namespace evil {
namespace {

// 64 bits over words: multiply and rotate, and a last avalanche (as in Appleby's MurmurHash3 finaliser).
class Print {
public:
    Print& operator<<(std::uint64_t word) {
        h_ = std::rotl(h_ ^ (word * 0xff51afd7ed558ccdull), 29) * 0xc4ceb9fe1a85ec53ull;
        return *this;
    }
    Print& operator<<(float value) { return *this << std::uint64_t{std::bit_cast<std::uint32_t>(value)}; }
    Print& operator<<(double value) { return *this << std::bit_cast<std::uint64_t>(value); }
    Print& operator<<(Vec2 v) { return *this << v.x << v.y; }
    Print& operator<<(const Affine& m) { return *this << m.a << m.b << m.c << m.d << m.tx << m.ty; }
    Print& operator<<(const std::string& text) {
        *this << std::uint64_t{text.size()};
        for (char c : text) *this << std::uint64_t{static_cast<unsigned char>(c)};
        return *this;
    }
    Print& operator<<(const std::vector<Vec2>& points) {
        *this << std::uint64_t{points.size()};
        for (Vec2 p : points) *this << p;
        return *this;
    }
    std::uint64_t value() const {
        std::uint64_t h = (h_ ^ (h_ >> 33)) * 0xff51afd7ed558ccdull;
        return h ^ (h >> 33);
    }

private:
    std::uint64_t h_ = 0x9e3779b97f4a7c15ull;
};

std::uint64_t word(auto value) { return static_cast<std::uint64_t>(value); }

} // namespace

std::uint64_t fingerprint(const NewShape& shape) {
    const Shape& s = shape.shape;
    Print print;
    print << word(s.kind) << word(s.closed) << s.local << s.radius << s.mass << s.material.density
          << s.material.friction << s.material.restitution << shape.corners;
    return print.value();
}

std::uint64_t fingerprint(const Body& b, const std::string& tag, std::span<const NewShape> shapes) {
    Print print;
    print << word(b.kind) << word(b.bullet) << word(b.touchable) << b.pose.p << b.angle << b.velocity << b.spin
          << b.set_mass << b.damping << b.angular_damping << b.drag << b.gravity_scale << b.density << b.friction
          << b.restitution << tag;
    for (const NewShape& shape : shapes) print << fingerprint(shape);
    return print.value();
}

std::uint64_t fingerprint(const Force& f, const Area& area) {
    Print print;
    print << word(f.kind) << word(f.everywhere) << f.vector << f.anchor << word(f.at_anchor) << word(f.target)
          << f.stiffness << f.rest_length << f.damping << f.linear << f.quadratic << f.limit << f.density << f.note
          << area.centre << area.radius;
    for (const std::vector<Vec2>& part : area.parts) print << part;
    return print.value();
}

std::uint64_t fingerprint(const Joint& j) {
    Print print;
    print << word(j.kind) << word(j.collide) << word(j.body_a) << word(j.body_b) << j.anchor_a << j.anchor_b << j.axis
          << j.over_a << j.over_b << j.reference << j.ratio << j.breaking_force << j.breaking_torque;
    for (const JointDrive* d : {&j.along, &j.turn})
        print << word(d->held) << word(d->limited) << word(d->motor) << d->rest << d->lower << d->upper << d->speed
              << d->most << d->frequency << d->damping_ratio << d->stiffness << d->damping << d->spring_most;
    return print.value();
}

} // namespace evil
