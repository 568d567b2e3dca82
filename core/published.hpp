#pragma once
// What the world shows to readers after each step. Slot-indexed; a slot whose generation is even holds no body.
#include "math/transform.hpp"
#include <cstdint>
#include <span>

namespace evil {

struct Poses {
    std::span<const Pose> previous, present; // before and after the last step: a frame is drawn between the two
    std::span<const Vec2> scale;
    std::span<const std::uint32_t> generation; // odd: alive. A reference is good while its generation equals this one
};

} // namespace evil
