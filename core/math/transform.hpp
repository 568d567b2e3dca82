#pragma once
// Rotations, rigid poses and affine maps of the plane.
#include "math/functions.hpp"
#include "math/vec2.hpp"

namespace evil {

struct Rot { // a rotation as cosine and sine
    float c = 1.0f, s = 0.0f;
    friend constexpr bool operator==(Rot, Rot) = default;
};
inline Rot rotation(double angle) {
    SinCos f = sincos(angle);
    return {f.cos, f.sin};
}
constexpr Vec2 rotate(Rot q, Vec2 a) { return {q.c * a.x - q.s * a.y, q.s * a.x + q.c * a.y}; }
constexpr Vec2 unrotate(Rot q, Vec2 a) { return {q.c * a.x + q.s * a.y, q.c * a.y - q.s * a.x}; }

struct Pose { // body to world without scale
    Vec2 p;
    Rot q;
    friend constexpr bool operator==(Pose, Pose) = default;
};
constexpr Vec2 transform(const Pose& t, Vec2 a) { return rotate(t.q, a) + t.p; }
constexpr Vec2 untransform(const Pose& t, Vec2 a) { return unrotate(t.q, a - t.p); }

// Any affine map of the plane, columns first as in a 4x4 matrix:
//   | a c tx |
//   | b d ty |
struct Affine {
    float a = 1, b = 0, c = 0, d = 1, tx = 0, ty = 0;
    friend constexpr bool operator==(const Affine&, const Affine&) = default;
};
constexpr Vec2 apply(const Affine& m, Vec2 v) { return {m.a * v.x + m.c * v.y + m.tx, m.b * v.x + m.d * v.y + m.ty}; }
constexpr Vec2 apply_linear(const Affine& m, Vec2 v) { return {m.a * v.x + m.c * v.y, m.b * v.x + m.d * v.y}; }
constexpr float determinant(const Affine& m) { return m.a * m.d - m.b * m.c; }
constexpr Affine compose(const Affine& m, const Affine& n) { // n first, then m
    return {m.a * n.a + m.c * n.b, m.b * n.a + m.d * n.b,          m.a * n.c + m.c * n.d,
            m.b * n.c + m.d * n.d, m.a * n.tx + m.c * n.ty + m.tx, m.b * n.tx + m.d * n.ty + m.ty};
}
constexpr Affine affine(const Pose& t) { return {t.q.c, t.q.s, -t.q.s, t.q.c, t.p.x, t.p.y}; }

} // namespace evil
