#pragma once
// Whitewater: flecks of spray, foam and bubbles that a liquid throws up (Ihmsen, Akinci, Akinci and Teschner 2012, "Unified
// spray, foam and bubbles for particle-based fluids"). They follow the liquid, which does not feel them.
//
// Flecks are born where liquid is fast, and traps air or stands up as a crest. What the paper sums over neighbours is
// summed over the nine cells round a particle here. A fleck with little liquid round it flies, one with much of it rises
// through it, and between the two it drifts on the surface and fades. Bodies and walls stop it.
#include "draw/draw_list.hpp"
#include "particles/obstacles.hpp"
#include <cstdint>
#include <span>
#include <vector>

namespace evil::particles {

inline constexpr std::uint32_t kMostFlecks = 8192;

struct Fleck {
    Vec2 at, velocity;  // metres, m/s
    float life = 0.0f;  // seconds left on the surface
    float whole = 1.0f; // that it had
    float size = 0.0f;  // 0..1, from the smallest to the largest
    float wet = 0.0f;   // 0..1: how much liquid was round it
};

struct FoamCell { // of twice the particles' spacing; scratch
    float count = 0.0f;
    Vec2 velocity; // sum, then mean
};

struct Foam {
    // State
    std::uint64_t random = 0;
    std::vector<Fleck> flecks; // in the order of birth
    // Scratch
    std::vector<FoamCell> cells;
    std::vector<Vec2> from; // where the flecks were
    Obstacles obstacles;
};

struct Waters { // what a step is told of the liquid
    std::span<const Vec2> at, velocity;
    float spacing = 0.1f; // metres between particles
    Vec2 low, high;       // its area
    bool closed[4] = {};  // left, right, bottom, top
    Vec2 gravity;
};

// What there is moves and fades; then what is due is born, `amount` times as much as by itself.
void step(Foam& foam, const Waters& waters, const World& world, float amount, float dt);

struct FoamView {
    Affine to_pixel;
    Vec2 screen;
    float back; // seconds that they are shown before where they are
    float spacing, points;
    bool lit;
    draw::Rgba8 tint;
};
void collect(const Foam& foam, const FoamView& view, std::int32_t layer, draw::DrawList& out);

std::vector<std::uint8_t> snapshot(const Foam& foam);
bool restore(Foam& foam, std::span<const std::uint8_t> bytes); // false: they are none

} // namespace evil::particles
