#pragma once
// What gas looks like: a picture of its density, and one of its heat as light, each by a ramp of colours.
#include "fluid/smoke.hpp"
#include <span>
#include <vector>

namespace evil::fluid {

inline constexpr int kRamp = 64;

struct Ramp {
    std::array<std::uint32_t, kRamp> colours{}; // from nothing to all, 0xAABBGGRR with straight alpha
    float scale = 1.0f;                         // of a value of 1 the ramp shows 1 - exp(-scale)
};

// A picture has two pixels a cell each way, rows from the top. What they show lies on a quadratic B-spline through the cells,
// so that no cell is seen by itself: these are its shares a quarter of a cell off a cell's middle.
inline constexpr float kNear = 0.28125f, kHere = 0.6875f, kFar = 0.03125f;

enum class Shown : std::uint8_t { density, heat };

// Gas of several colours tints the ramp by each cell's own.
void paint(const Smoke& smoke, Shown shown, const Ramp& ramp, std::span<std::uint32_t> pixels);

// A fire: sums over what is hotter than `above`, and nearer to its place than to any other.
struct Blaze {
    float strength = 0.0f; // degrees above, times m2
    Vec2 middle;
    float size = 0.0f; // metres from the middle, on average
};
void find_blazes(const Smoke& smoke, float above, std::span<const Vec2> places, std::vector<Blaze>& blazes);

} // namespace evil::fluid
