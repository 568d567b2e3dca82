#pragma once
// Joints (SPEC P8): what ties two bodies together, and how they stand.
//
// A joint holds some of the three ways in which b can move against a, and leaves others free. What is left free along one
// coordinate (metres along an axis, or radians of turning) may be driven: by a spring, a motor, and limits at both ends.
#include "bodies.hpp"
#include "refs.hpp"
#include <cmath>

namespace evil {

enum class JointKind : std::uint8_t { distance, hinge, slider, weld, wheel, motor, rope, gear, pulley };

using JointRef = Ref<struct JointTag>;

inline constexpr float kNoLimit = kMaxForce; // a greatest force, or a breaking force, that is never reached

// One coordinate of a joint: metres for `along`, radians for `turn`.
struct JointDrive {
    bool held = false;    // stiff at `rest`
    bool limited = false; // kept between lower and upper
    bool motor = false;   // driven at `speed`, with at most `most` newtons or newton metres
    float rest = 0.0f;    // where a spring pulls to, or where it is held
    float lower = 0.0f, upper = 0.0f;
    float speed = 0.0f, most = 0.0f;
    float frequency = 0.0f, damping_ratio = 0.0f; // of a spring: hertz of the two bodies on it; 0 Hz: none
    float stiffness = 0.0f, damping = 0.0f;       // or N/m and N s/m (N m/rad, N m s/rad); 0 and 0: none
    float spring_most = kNoLimit;                 // greatest force of the spring
    // newton seconds (newton metre seconds) of the last substep: where the next step starts from
    float spring_impulse = 0.0f, motor_impulse = 0.0f, lower_impulse = 0.0f, upper_impulse = 0.0f;
};

struct Joint {
    JointKind kind = JointKind::distance;
    bool collide = false; // may its two bodies touch each other?
    std::uint32_t body_a = kNone, body_b = kNone;
    Vec2 anchor_a, anchor_b; // where it holds each body, body frames
    Vec2 axis{1, 0};         // slider, wheel: the way that is free, in a's frame
    Vec2 over_a, over_b;     // pulley: the points of the world that its rope runs over
    double reference = 0.0;  // angle of b less that of a (gear: less `ratio` times a's) that counts as none
    float ratio = 1.0f;      // gear: turns of b for one of a. pulley: how much more b's rope weighs in the sum
    JointDrive along, turn;
    float breaking_force = kNoLimit, breaking_torque = kNoLimit;

    Vec2 impulse;        // of the last substep: on b, along x and y (point) or across the axis and turning (axis)
    Vec2 force;          // newtons on b in the last step
    float torque = 0.0f; // newton metres on b in the last step

    std::uint64_t serial = 0, born = 0, made = 0;
};

inline bool holds(const Joint& j) {
    return length_squared(j.force) <= j.breaking_force * j.breaking_force && std::abs(j.torque) <= j.breaking_torque;
}

struct JointLinks { // a joint in the rings of its two bodies' joints; follows from the rows
    std::uint32_t next[2] = {kNone, kNone}, before[2] = {kNone, kNone}; // [0] in a's list, [1] in b's; a joint's slot
};

struct BodyJoints { // by body slot
    std::uint32_t first = kNone, count = 0;
};

struct BrokenJoint { // what a joint was when it gave way
    JointRef ref;
    BodyRef a, b;
    std::uint64_t serial;
    Vec2 force;
    float torque;
};

struct Joints {
    Slots slots;             // State
    std::vector<Joint> rows; // State, by slot
    std::uint64_t next_serial = 0;
    std::uint64_t matched = ~std::uint64_t{0}; // Scratch: serial up to which contacts know who is kept apart
    std::vector<JointLinks> links;             // by slot: each body's joints as a list
    std::vector<BodyJoints> of_body;           // by body slot
    bool unchecked = true;                     // Scratch: may one have been pulled harder than it holds?
    std::vector<BrokenJoint> broken;           // results of the last step, in order of creation
};

// The list of a body's joints: add a joint to, or take it out of, those of both its bodies.
void link(Joints& joints, std::uint32_t joint);
void unlink(Joints& joints, std::uint32_t joint);
void link_all(Joints& joints); // after a restore

// Call `visit(slot of the joint, slot of the other body)` for each joint of a body. `visit` may not destroy them.
template <class Visit> void for_joints_of(const Joints& joints, std::uint32_t body, Visit&& visit) {
    if (body >= joints.of_body.size()) return;
    for (std::uint32_t j = joints.of_body[body].first; j != kNone;) {
        const Joint& row = joints.rows[j];
        std::size_t side = row.body_a == body ? 0 : 1;
        std::uint32_t next = joints.links[j].next[side];
        visit(j, side == 0 ? row.body_b : row.body_a);
        j = next;
    }
}

// Are the two tied by a joint that keeps them from touching each other?
bool kept_apart(const Joints& joints, std::uint32_t body, std::uint32_t other);

// From a body's centre of mass to an anchor, which is a point of the body before it is scaled.
inline Vec2 arm_of(const Body& b, Vec2 anchor) {
    return rotate(b.pose.q, Vec2{b.scale.x * anchor.x, b.scale.y * anchor.y} - b.local_centre);
}

// ---- how a joint stands, from where its bodies are ----

struct JointState {
    Vec2 at_a, at_b;          // anchors, world
    float angle = 0.0f;       // radians, of b against a (gear: off its ratio)
    float turning = 0.0f;     // radians a second, the same
    float length = 0.0f;      // metres between the anchors; slider, wheel: along the axis; pulley: the ropes' sum
    float lengthening = 0.0f; // metres a second, the same
};
JointState state_of(const Joint& joint, const Bodies& bodies);

bool is_axial(JointKind kind); // slider and wheel: their length is along an axis and may be negative

} // namespace evil
