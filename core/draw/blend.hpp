#pragma once
// How a colour meets what is behind it; s and d multiplied with alpha, channel by channel.
#include <cstdint>

namespace evil::draw {

enum class Blend : std::uint8_t {
    over,     // s + d (1 - alpha of s)
    add,      // s + d: light
    multiply, // s d + d (1 - alpha of s): shade, coloured glass
    screen,   // s + d (1 - s): light that never burns out
};
inline constexpr int kBlends = 4;

} // namespace evil::draw
