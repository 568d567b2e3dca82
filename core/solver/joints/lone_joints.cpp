#include "solver/joints/lone_joints.hpp"

namespace evil {
namespace {

Vec2 direction(Vec2 v, float& size) {
    size = length(v);
    return size > 1e-9f ? (1.0f / size) * v : Vec2{0, -1};
}

// A pulley's rope: from where it runs over to the anchor, b's counted `ratio` times.
//
//     over_a o------o over_b
//            |      |
//            a      b        |rope a| + ratio |rope b| stays
void begin_pulley(LoneJoint& k, const SolverBody& a, const SolverBody& b, float turned_a, float turned_b) {
    Vec2 arm_a = rotate(rotation(double(turned_a)), {k.start_ax, k.start_ay});
    Vec2 arm_b = rotate(rotation(double(turned_b)), {k.start_bx, k.start_by});
    Vec2 along_a = direction(Vec2{k.rope_ax + a.moved_x, k.rope_ay + a.moved_y} + arm_a, k.length_a);
    Vec2 along_b = direction(Vec2{k.rope_bx + b.moved_x, k.rope_by + b.moved_y} + arm_b, k.length_b);
    k.ax = along_a.x;
    k.ay = along_a.y;
    k.bx = k.ratio * along_b.x;
    k.by = k.ratio * along_b.y;
    k.turn_a = cross(arm_a, along_a);
    k.turn_b = k.ratio * cross(arm_b, along_b);
    k.error = k.length_a + k.ratio * k.length_b - k.wanted;
}

void begin_gear(LoneJoint& k, float turned_a, float turned_b) {
    k.turn_a = -k.ratio;
    k.turn_b = 1.0f;
    k.error = k.base + (turned_b - k.ratio * turned_a);
}

void push(SolverBody& body, float x, float y, float turning, float impulse) {
    body.vx += body.inv_mass * impulse * x;
    body.vy += body.inv_mass * impulse * y;
    body.spin += body.inv_inertia * impulse * turning;
}

void push_both(const LoneJoint& k, std::span<SolverBody> bodies, float impulse) {
    push(bodies[k.a], k.ax, k.ay, k.turn_a, impulse);
    push(bodies[k.b], k.bx, k.by, k.turn_b, impulse);
}

float inv_mass_of(const SolverBody& body, float x, float y, float turning) {
    return body.inv_mass * (x * x + y * y) + body.inv_inertia * turning * turning;
}

// Half of what swinging at a rope's end does to its length: going round, not along a line. (x, y) is `ratio` long.
float bend_of(const SolverBody& body, float x, float y, float ratio, float size, float h) {
    float across = (body.vy * x - body.vx * y) / ratio;
    return size > 1e-6f ? ratio * clamped(0.5f * h * across / size, 0.5f) * across : 0.0f;
}

void push(LoneJoint& k, std::span<SolverBody> bodies, Softness soft, float bend) {
    const SolverBody &a = bodies[k.a], &b = bodies[k.b];
    float speed = (a.vx * k.ax + a.vy * k.ay + a.spin * k.turn_a) + (b.vx * k.bx + b.vy * k.by + b.spin * k.turn_b);
    float impulse = -k.mass * (soft.keep * (speed + bend) + soft.pull * k.error) - soft.leak * k.impulse;
    impulse = clamped(k.impulse + impulse, kMaxForce) - k.impulse;
    k.impulse += impulse;
    push_both(k, bodies, impulse);
}

} // namespace

LoneJoint lone_joint(const Joint& j, std::uint32_t slot, std::uint32_t row_a, std::uint32_t row_b,
                     const Bodies& bodies) {
    const Body &a = bodies.rows[j.body_a], &b = bodies.rows[j.body_b];
    LoneJoint k{};
    k.joint = slot;
    k.a = row_a;
    k.b = row_b;
    k.pulley = j.kind == JointKind::pulley;
    k.ratio = j.ratio;
    Vec2 arm_a = arm_of(a, j.anchor_a), arm_b = arm_of(b, j.anchor_b);
    Vec2 rope_a = a.centre - j.over_a, rope_b = b.centre - j.over_b;
    k.start_ax = arm_a.x;
    k.start_ay = arm_a.y;
    k.start_bx = arm_b.x;
    k.start_by = arm_b.y;
    k.rope_ax = rope_a.x;
    k.rope_ay = rope_a.y;
    k.rope_bx = rope_b.x;
    k.rope_by = rope_b.y;
    k.wanted = j.along.rest;
    k.base = static_cast<float>(b.angle - double(j.ratio) * a.angle - j.reference);
    k.impulse = j.impulse.x;
    return k;
}

void begin_lone(std::span<LoneJoint> joints, std::span<SolverBody> bodies) {
    for (LoneJoint& k : joints) {
        if (k.pulley)
            begin_pulley(k, bodies[k.a], bodies[k.b], bodies[k.a].turned, bodies[k.b].turned);
        else
            begin_gear(k, bodies[k.a].turned, bodies[k.b].turned);
        float inv_mass =
            inv_mass_of(bodies[k.a], k.ax, k.ay, k.turn_a) + inv_mass_of(bodies[k.b], k.bx, k.by, k.turn_b);
        k.mass = inv_mass > 0.0f && inv_mass < 1e38f ? 1.0f / inv_mass : 0.0f;
    }
}

void warm_lone(std::span<LoneJoint> joints, std::span<SolverBody> bodies) {
    for (const LoneJoint& k : joints) push_both(k, bodies, k.impulse);
}

void move_lone(std::span<LoneJoint> joints, std::span<SolverBody> bodies, const JointPass& pass) {
    for (LoneJoint& k : joints) {
        float bend = k.pulley ? bend_of(bodies[k.a], k.ax, k.ay, 1.0f, k.length_a, pass.h) +
                                    bend_of(bodies[k.b], k.bx, k.by, k.ratio, k.length_b, pass.h)
                              : 0.0f;
        push(k, bodies, pass.stiff, bend);
    }
}

void calm_lone(std::span<LoneJoint> joints, std::span<SolverBody> bodies) {
    begin_lone(joints, bodies);
    for (LoneJoint& k : joints) {
        push(k, bodies, {}, 0.0f);
        k.total += k.impulse;
    }
}

} // namespace evil
