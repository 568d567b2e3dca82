#pragma once
#include "math/vec2.hpp"
#include <cstdint>

namespace evil {

struct Path { // of a body within a step, from here to where it is now
    std::uint32_t body;
    Vec2 start; // of its centre of mass
    double angle;
};

} // namespace evil
