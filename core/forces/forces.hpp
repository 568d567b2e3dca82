#pragma once
// Force generators (SPEC P2): one row may act on many bodies, and is asked for its force before each substep.
#include "bodies.hpp"
#include "shapes/shapes.hpp"
#include <span>
#include <string>

namespace evil {

enum class ForceKind : std::uint8_t { gravity, constant, spring, drag, medium, pull, python };

struct Force {
    ForceKind kind = ForceKind::gravity;
    bool everywhere = false; // acts on every dynamic body; `bodies` is empty
    Vec2 vector; // gravity: acceleration; constant: newtons; spring, pull: where to, in world or `target`'s frame;
                 // medium: its velocity, world or `target`'s frame
    Vec2 anchor; // spring, constant: the point of the body it acts on, body frame
    bool at_anchor = false;       // constant: acts at `anchor`, not at the centre of mass
    std::uint32_t target = kNone; // spring: the body at its other end; medium: the body that carries it
    float stiffness = 0.0f;       // spring: N/m. pull: natural frequency in Hz
    float rest_length = 0.0f;     // spring: metres
    float damping = 0.0f;         // spring: N s/m along it
    float linear = 0.0f;          // drag, medium: N s/m for a body of drag 1
    float quadratic = 0.0f;       // drag, medium: N s2/m2
    float limit = 0.0f;           // pull: largest acceleration, m/s2
    float density = 0.0f;         // medium: what it lifts by, kg/m2
    std::uint64_t serial = 0, born = 0, made = 0;
    std::vector<std::uint32_t> bodies; // slots, in the order they were attached
    std::string note;                  // python: what its author keeps with it; the core only saves it
};

struct Area { // a medium's: a circle, or convex parts, in the world or the frame of the body that carries it
    Vec2 centre;
    float radius = 0.0f;
    std::vector<std::vector<Vec2>> parts; // each counter-clockwise
};

struct Forces { // State: rows by slot
    Slots slots;
    std::vector<Force> rows;
    std::vector<Area> areas;
    std::uint64_t next_serial = 0;
};

struct Push { // what acts on a body within a substep
    Vec2 force;
    float torque = 0.0f;
};

// Add what every generator gives for a substep of h seconds to `pushes`, by body slot. Sleeping bodies get nothing.
void apply_forces(const Forces& forces, const Bodies& bodies, Vec2 world_gravity, float h, std::span<Push> pushes);

bool contains(const Area& area, Vec2 point);

} // namespace evil
