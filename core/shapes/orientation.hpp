#pragma once
#include "math/vec2.hpp"

namespace evil {

// Which way the path a, b, c turns: +1 to the left, -1 to the right, 0 straight on (or straight back).
//
//          c        Twice the triangle's area is a sum of six products of two coordinates. A product of floats fits a double,
//         /  left   so the sum can be had without rounding (Shewchuk 1997, expansions), and the answer is always right.
//   a----b          Rounded arithmetic with an error bound settles nearly all cases before that.
int turn(Vec2 a, Vec2 b, Vec2 c) noexcept;

} // namespace evil
