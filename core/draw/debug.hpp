#pragma once
// The debug view (SPEC G12): what the physics sees, drawn over the world.
#include "draw/overlay.hpp"
#include "world.hpp"
#include <array>

namespace evil::draw {

// What is drawn; each can be left out. evilengine.scene.DebugView names them in the same order.
enum class Part : std::uint8_t {
    shapes,     // outlines of shapes, and areas of media
    contacts,   // points with their normals
    impulses,   // pushes of contacts
    joints,     // what ties bodies together
    bounds,     // boxes round the pieces that shapes are made of
    islands,    // which bodies wake and sleep together
    centres,    // of mass
    velocities, // arrows to where bodies would be
    count
};

// What has a colour of its own; in the order of DebugView too.
enum class Ink : std::uint8_t {
    still,
    kinematic,
    awake,
    asleep,
    sensor,
    medium,
    contact,
    impulse,
    joint,
    bound,
    centre,
    velocity,
    count
};

struct DebugLook {
    std::array<Rgba8, static_cast<std::size_t>(Ink::count)> inks{};
    std::array<bool, static_cast<std::size_t>(Part::count)> parts{};
    float points = 1.0f; // pixels of a logical point: lines keep their width on any screen
};

struct DebugCount { // islands: 0 where nobody asked for them
    std::uint32_t bodies = 0, asleep = 0, contacts = 0, joints = 0, islands = 0;
};

// A world at a time, and the picture that it is drawn on.
struct DebugFrame {
    const Overlay& overlay;
    const World& world;
    const Affine& view; // world to pixels
    float alpha;        // 0..1 between the last two steps
    const DebugLook& look;

    Rgba8 ink(Ink of) const { return look.inks[static_cast<std::size_t>(of)]; }
    bool shows(Part part) const { return look.parts[static_cast<std::size_t>(part)]; }
    float points(float length) const { return length * look.points; } // as pixels
    Vec2 pixel(Vec2 at) const { return apply(view, at); }
    Vec2 seen(Vec2 direction) const { return normalised(apply_linear(view, direction)); }
    Pose pose(std::uint32_t body) const;
};

DebugCount draw_debug(const DebugFrame& frame);

// In debug_joints.cpp.
void draw_joint(const DebugFrame& frame, const Joint& joint);
// In debug_contacts.cpp.
void draw_contact(const DebugFrame& frame, const Contact& contact);

} // namespace evil::draw
