#pragma once
// Elementary functions with the same bits on every machine: plain arithmetic, no libm (whose last digit differs).
#include <cstdint>

namespace evil {

inline constexpr double kPi = 3.14159265358979323846;

struct SinCos { float sin, cos; };
SinCos sincos(double angle) noexcept;           // radians; any finite angle
float atan2(float y, float x) noexcept;         // radians in [-pi, pi]
double power(double base, double exponent) noexcept; // base >= 0; power(0, 0) is 1

} // namespace evil
