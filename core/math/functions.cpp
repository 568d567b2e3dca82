#include "math/functions.hpp"
#include "math/sincos.hpp"
#include <bit>
#include <cmath>
#include <limits>

// Each function reduces its argument to a short interval, sums the Taylor series there in double, and undoes the reduction.
// Of the C library only operations with one right answer (IEEE 754) are used: floor, fmod, and comparisons.

namespace evil {
namespace {

using series::sum;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// ln 2 as a sum, as pi/2 in sincos.hpp.
constexpr double kLn2[2] = {0x1.62e42fefp-1, 0x1.473de6af278edp-34};

// atan(k/8): the nearest is subtracted by tan(a - b) = (tan a - tan b) / (1 + tan a tan b), which leaves |t| <= 1/16.
constexpr double kAtanOfEighths[] = {0.0,
                                     0.12435499454676144,
                                     0.24497866312686414,
                                     0.35877067027057225,
                                     0.4636476090008061,
                                     0.5585993153435624,
                                     0.6435011087932844,
                                     0.7188299996216245,
                                     0.7853981633974483};
constexpr double kAtan[] = {1.0, -1.0 / 3, 1.0 / 5, -1.0 / 7, 1.0 / 9, -1.0 / 11};

constexpr double kExp[] = {
    1.0,        1.0,         1.0 / 2,      1.0 / 6,       1.0 / 24,       1.0 / 120,       1.0 / 720,
    1.0 / 5040, 1.0 / 40320, 1.0 / 362880, 1.0 / 3628800, 1.0 / 39916800, 1.0 / 479001600, 1.0 / 6227020800};

// 2^n for n in -1022..1023, from the bits of its exponent.
double two_to(int n) { return std::bit_cast<double>(static_cast<std::uint64_t>(n + 1023) << 52); }

// atan t for 0 <= t <= 1.
double atan_of_ratio(double t) {
    int k = static_cast<int>(8.0 * t + 0.5);
    double near = k / 8.0;
    double rest = (t - near) / (1.0 + t * near);
    return kAtanOfEighths[k] + rest * sum(kAtan, rest * rest);
}

} // namespace

SinCos sincos(double angle) noexcept {
    if (!(angle <= series::kLargestReduced && angle >= -series::kLargestReduced)) {
        if (!std::isfinite(angle)) return {0.0f, 1.0f};
        angle = std::fmod(angle, 2.0 * kPi);
    }
    return series::sincos_reduced(angle);
}

float atan2(float y, float x) noexcept {
    if (std::isnan(x) || std::isnan(y)) return 0.0f;
    double across = std::fabs(x), up = std::fabs(y);
    bool steep = up > across;
    double longer = steep ? up : across, shorter = steep ? across : up;
    if (longer == 0.0) return 0.0f;
    double angle = atan_of_ratio(shorter == longer ? 1.0 : shorter / longer); // two infinities make 45 degrees
    if (steep) angle = kPi / 2.0 - angle;
    if (x < 0.0f) angle = kPi - angle;
    return static_cast<float>(y < 0.0f ? -angle : angle);
}

double exponential(double x) noexcept {
    if (std::isnan(x)) return kNaN;
    if (x > 709.79) return kInfinity;
    if (x < -745.2) return 0.0;
    double n = std::floor(x * (1.0 / (kLn2[0] + kLn2[1])) + 0.5);
    double r = (x - n * kLn2[0]) - n * kLn2[1];
    int half = static_cast<int>(n) / 2; // in two factors: 2^n itself may lie outside the range of normal numbers
    return sum(kExp, r) * two_to(half) * two_to(static_cast<int>(n) - half);
}

double logarithm(double x) noexcept {
    if (!(x >= 0.0)) return kNaN;
    if (x == 0.0) return -kInfinity;
    if (x == kInfinity) return kInfinity;
    int exponent = 0;
    if (x < std::numeric_limits<double>::min()) { // subnormal: no leading one to read the exponent from
        x *= 0x1p54;
        exponent = -54;
    }
    // x = 2^exponent m with m in sqrt(1/2)..sqrt(2), then log m = 2 atanh((m - 1) / (m + 1)).
    std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
    exponent += static_cast<int>(bits >> 52) - 1023;
    double m = std::bit_cast<double>((bits & 0x000fffffffffffffu) | 0x3ff0000000000000u);
    if (m > 1.4142135623730951) {
        m *= 0.5;
        ++exponent;
    }
    double s = (m - 1.0) / (m + 1.0), square = s * s, series = 0.0;
    for (int odd = 21; odd >= 3; odd -= 2) series = series * square + 1.0 / odd;
    return exponent * kLn2[0] + (2.0 * s + (2.0 * s * square * series + exponent * kLn2[1]));
}

double power(double base, double exponent) noexcept {
    if (exponent == 0.0 || base == 1.0) return 1.0;
    if (exponent == 1.0) return base;
    return exponential(exponent * logarithm(base));
}

} // namespace evil
