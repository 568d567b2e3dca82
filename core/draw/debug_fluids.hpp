#pragma once
// The debug view of fluids: arrows of how they flow, where the flow spreads or gathers, and what their cells hold.
#include "draw/overlay.hpp"
#include "world.hpp"
#include <array>

namespace evil::draw {

// What is drawn; each can be left out. evilengine.scene.DebugView names them in the same order.
enum class FluidPart : std::uint8_t { flow, divergence, cells, particles, count };

// What has a colour of its own; in the order of DebugView too.
enum class FluidInk : std::uint8_t { flow, spreading, gathering, grid, solid, liquid, count };

struct FluidFrame {
    const Overlay& overlay;
    const World& world;
    const Affine& view; // world to pixels
    Vec2 screen;        // pixels
    float points;       // pixels of a logical point
    std::array<bool, static_cast<std::size_t>(FluidPart::count)> parts{};
    std::array<Rgba8, static_cast<std::size_t>(FluidInk::count)> inks{};

    bool shows(FluidPart part) const { return parts[static_cast<std::size_t>(part)]; }
    Rgba8 ink(FluidInk of) const { return inks[static_cast<std::size_t>(of)]; }
};

struct FluidScale {                          // what the legend says
    std::uint32_t fluids = 0, particles = 0; // in the world
    float speed = 0.0f;                      // m/s that the longest arrows stand for; 0: nothing flows
    float divergence = 0.0f; // 1/s that the full colours stand for; 0: nothing gathers, or nobody knows yet
};

// Smokes are watched from now on: what gathers in them is known after the next step.
FluidScale draw_fluids(const FluidFrame& frame);

} // namespace evil::draw
