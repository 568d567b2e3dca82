#pragma once
// Elementary functions with the same bits on every machine: plain arithmetic, no libm (whose last digit differs).
// The errors named here are upheld by tests/test_math.py.
#include <cstdint>

namespace evil {

inline constexpr double kPi = 3.14159265358979323846;

struct SinCos {
    float sin, cos;
};

// Sine and cosine of an angle in radians, within 0.501 units in the last place of a float for |angle| up to 1.6 million,
// an absolute 1e-7 up to a thousand million, and on the unit circle for every finite angle. (0, 1) if it is not finite.
SinCos sincos(double angle) noexcept;

// Direction of (x, y) in radians, -pi..pi, within 0.501 units in the last place. -0 counts as 0, and the direction of
// (0, 0), or of anything not a number, is 0: a body at rest has no business jumping by half a turn.
float atan2(float y, float x) noexcept;

double exponential(double x) noexcept; // relative error under 1e-15; 0 and infinity beyond the range of double
double logarithm(double x) noexcept;   // natural; error under 4e-16 relative, or absolute near 1. log(0) = -infinity
double power(double base, double exponent) noexcept; // base >= 0, relative error under 3e-13; power(0, 0) is 1

} // namespace evil
