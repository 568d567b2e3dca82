#pragma once
// Rigid bodies (SPEC P1, P3, P4): the State that the solver moves.
#include "math/transform.hpp"
#include "refs.hpp"
#include "shapes/shapes.hpp"
#include <string>

namespace evil {

enum class BodyKind : std::uint8_t { fixed, kinematic, dynamic }; // "static" is a word of C++'s own

inline constexpr float kMaxSpeed = 1e5f; // m/s; beyond it positions lose their decimals within a second
inline constexpr float kMaxSpin = 1e4f;  // rad/s
inline constexpr float kWorldEdge =
    1e7f; // metres from the origin; a body that gets there stays there, so that no infinity is born
inline constexpr float kMaxMass = 1e12f, kMinMass = 1e-12f;

// Into [-limit, limit], and not-a-number into 0: whatever was asked for, no NaN leaves a step.
inline float clamped(float value, float limit) {
    if (value > limit) return limit;
    if (value < -limit) return -limit;
    return value == value ? value : 0.0f;
}
inline Vec2 clamped(Vec2 v, float limit) { return {clamped(v.x, limit), clamped(v.y, limit)}; }

inline constexpr float kMaxForce = 1e30f; // newtons, and whatever else only has to stay finite

inline constexpr float kUnknown = -1.0f; // of what is never negative: to be worked out when it is asked for

// What every step reads of every body comes first, in 64 bytes, so that one line of the cache holds it (collider/placed.hpp);
// what it does to those that move fills the next.
struct alignas(64) Body {
    BodyKind kind = BodyKind::dynamic;
    bool bullet = false, touchable = false, awake = true;
    float spin = 0.0f;      // angular velocity
    Pose pose;              // body to world: p is the origin that shapes are placed by, q the rotation by `angle`
    Vec2 centre;            // centre of mass, world
    Vec2 velocity;          // of the centre of mass
    Vec2 local_centre;      // centre of mass, body frame
    double angle = 0.0;     // radians, not wrapped; double so that a wheel may turn for hours
    Vec2 scale{1, 1};       // of every shape on the body
    bool told_awake = true; // what was told of it last: a change is an event

    Vec2 force; // gathered since the last step, cleared by it
    float torque = 0.0f;
    Vec2 acceleration; // of the last step, by forces alone: a resting contact takes it out (SPEC C7)

    float mass = 0.0f, inv_mass = 0.0f, inertia = 0.0f, inv_inertia = 0.0f; // inertia about the centre of mass
    float damping = 1.0f, angular_damping = 1.0f;                           // fraction of velocity kept per second
    float gravity_scale = 1.0f;
    float still_time = 0.0f; // seconds below the sleep speeds
    float reach = kUnknown;  // metres from the centre of mass to the farthest point; it follows from the shapes

    float drag = 1.0f;
    float set_mass = 0.0f; // what the user asked for; 0: the shapes' densities decide
    float density = 1.0f, friction = 0.6f, restitution = 0.0f; // what a shape gets that is added without its own

    std::uint64_t serial = 0;                              // order of creation, never used again within a world
    std::uint64_t born = 0;                                // step at which it was added
    std::uint64_t made = 0;                                // fingerprint of what it was made from; see identity.hpp
    std::uint32_t first_shape = kNone, last_shape = kNone; // its shapes in the order they were added
};

inline bool moves(const Body& b) { return b.kind != BodyKind::fixed; }
inline Vec2 velocity_at(const Body& b, Vec2 world_point) { return b.velocity + cross(b.spin, world_point - b.centre); }

// Bring what depends on angle and centre in step with them.
inline void place_by_centre(Body& b) {
    b.pose.q = rotation(b.angle);
    b.pose.p = b.centre - rotate(b.pose.q, b.local_centre);
}
inline void place_by_origin(Body& b) {
    b.pose.q = rotation(b.angle);
    b.centre = transform(b.pose, b.local_centre);
}

struct Bodies { // State: rows by slot
    Slots slots;
    std::vector<Body> rows;
    std::vector<std::string> tags; // "" : none
    std::vector<Traits> traits;    // of shapes to come
    std::uint64_t next_serial = 0;
};

} // namespace evil
