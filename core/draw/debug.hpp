#pragma once
// The debug view (SPEC G12): what the physics sees, drawn over the world.
#include "draw/overlay.hpp"
#include "world.hpp"

namespace evil::draw {

struct DebugColours {
    Rgba8 still, kinematic, awake, asleep; // outlines by what the body does
    Rgba8 contact, centre, velocity;
    Rgba8 sensor, medium;
};

struct DebugLook {
    DebugColours colours;
    float points = 1.0f; // pixels of a logical point: lines keep their width on any screen
    bool velocities = false;
};

struct DebugCount {
    std::uint32_t bodies = 0, asleep = 0, contacts = 0;
};

// Appends outlines of media and shapes, contact points with their normals, centres of mass and, if asked for, velocities.
DebugCount draw_debug(const Overlay& overlay, const World& world, const Affine& view, float alpha,
                      const DebugLook& look);

} // namespace evil::draw
