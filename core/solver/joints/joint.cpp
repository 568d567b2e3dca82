#include "solver/joints/joint.hpp"

namespace evil {
namespace {

void link_side(Joints& joints, std::uint32_t joint, std::size_t side, std::uint32_t body) {
    if (body >= joints.of_body.size()) joints.of_body.resize(body + 1);
    BodyJoints& list = joints.of_body[body];
    JointLinks& own = joints.links[joint];
    own.before[side] = kNone;
    own.next[side] = list.first;
    if (list.first != kNone) {
        std::size_t there = joints.rows[list.first].body_a == body ? 0 : 1;
        joints.links[list.first].before[there] = joint;
    }
    list.first = joint;
    ++list.count;
}

void unlink_side(Joints& joints, std::uint32_t joint, std::size_t side, std::uint32_t body) {
    BodyJoints& list = joints.of_body[body];
    const JointLinks& own = joints.links[joint];
    auto side_of = [&](std::uint32_t j) { return joints.rows[j].body_a == body ? 0u : 1u; };
    if (own.before[side] == kNone)
        list.first = own.next[side];
    else
        joints.links[own.before[side]].next[side_of(own.before[side])] = own.next[side];
    if (own.next[side] != kNone) joints.links[own.next[side]].before[side_of(own.next[side])] = own.before[side];
    --list.count;
}

Vec2 unit_or(Vec2 v, Vec2 otherwise) {
    float l = length(v);
    return l > 1e-9f ? (1.0f / l) * v : otherwise;
}

} // namespace

void link(Joints& joints, std::uint32_t joint) {
    joints.links.resize(joints.rows.size());
    link_side(joints, joint, 0, joints.rows[joint].body_a);
    link_side(joints, joint, 1, joints.rows[joint].body_b);
}

void unlink(Joints& joints, std::uint32_t joint) {
    unlink_side(joints, joint, 0, joints.rows[joint].body_a);
    unlink_side(joints, joint, 1, joints.rows[joint].body_b);
}

void link_all(Joints& joints) {
    joints.links.assign(joints.rows.size(), {});
    joints.of_body.clear();
    for (std::uint32_t j = 0; j < joints.slots.size(); ++j)
        if (joints.slots.taken(j)) link(joints, j);
}

bool kept_apart(const Joints& joints, std::uint32_t body, std::uint32_t other) {
    const auto& of = joints.of_body;
    if (body >= of.size() || other >= of.size() || of[body].count == 0 || of[other].count == 0) return false;
    if (of[other].count < of[body].count) std::swap(body, other); // the floor may hold thousands, a crate but a few
    bool apart = false;
    for_joints_of(joints, body, [&](std::uint32_t j, std::uint32_t end) {
        apart = apart || (end == other && !joints.rows[j].collide);
    });
    return apart;
}

bool is_axial(JointKind kind) { return kind == JointKind::slider || kind == JointKind::wheel; }

JointState state_of(const Joint& j, const Bodies& bodies) {
    const Body &a = bodies.rows[j.body_a], &b = bodies.rows[j.body_b];
    JointState s;
    s.at_a = a.centre + arm_of(a, j.anchor_a);
    s.at_b = b.centre + arm_of(b, j.anchor_b);
    double ratio = j.kind == JointKind::gear ? double(j.ratio) : 1.0;
    s.angle = static_cast<float>(b.angle - ratio * a.angle - j.reference);
    s.turning = b.spin - static_cast<float>(ratio) * a.spin;
    Vec2 v_a = velocity_at(a, s.at_a), v_b = velocity_at(b, s.at_b), d = s.at_b - s.at_a;
    if (j.kind == JointKind::pulley) {
        Vec2 rope_a = s.at_a - j.over_a, rope_b = s.at_b - j.over_b;
        s.length = length(rope_a) + j.ratio * length(rope_b);
        s.lengthening = dot(v_a, unit_or(rope_a, {0, -1})) + j.ratio * dot(v_b, unit_or(rope_b, {0, -1}));
    } else if (is_axial(j.kind)) {
        Vec2 axis = rotate(a.pose.q, j.axis);
        s.length = dot(d, axis);
        s.lengthening = dot(v_b - v_a, axis) + a.spin * dot(d, left_of(axis));
    } else {
        s.length = length(d);
        s.lengthening = dot(v_b - v_a, unit_or(d, {1, 0}));
    }
    return s;
}

} // namespace evil
