#pragma once
// Sine and cosine without a branch, so that compilers do several at once; of sincos() in functions.hpp, its inside. Functions
// are static: each instruction set has its own.
#include "math/functions.hpp"
#include <bit>
#include <cstdint>

namespace evil::series {

// pi/2 as a sum (Cody and Waite 1980). The leading parts have 33 bits, so that a count below 2^20 times such a part is exact
// and what is left after the subtraction keeps all its digits.
inline constexpr double kHalfPi[3] = {0x1.921fb544p+0, 0x1.0b4611a6p-34, 0x1.3198a2e037073p-69};
inline constexpr double kLargestReduced = 1.6e6; // radians: about 2^20 quarter turns

// Sum of c[0] + c[1] x + ... by Horner's rule.
template <int N> static constexpr double sum(const double (&c)[N], double x) {
    double total = c[N - 1];
    for (int i = N - 2; i >= 0; --i) total = total * x + c[i];
    return total;
}

// sin r / r and cos r in powers of r^2. On |r| <= pi/4 the first term left out is below 1e-13 of the sum.
inline constexpr double kSine[] = {1.0,          -1.0 / 6,        1.0 / 120,       -1.0 / 5040,
                                   1.0 / 362880, -1.0 / 39916800, 1.0 / 6227020800};
inline constexpr double kCosine[] = {1.0,         -1.0 / 2,       1.0 / 24,        -1.0 / 720,
                                     1.0 / 40320, -1.0 / 3628800, 1.0 / 479001600, -1.0 / 87178291200};

// For |angle| up to kLargestReduced. Adding 1.5 * 2^52 leaves the nearest whole number in the low bits of the double.
static inline SinCos sincos_reduced(double angle) noexcept {
    double shifted = angle * (2.0 / kPi) + 6755399441055744.0, quarters = shifted - 6755399441055744.0;
    double r = ((angle - quarters * kHalfPi[0]) - quarters * kHalfPi[1]) - quarters * kHalfPi[2];
    auto sine = std::bit_cast<std::uint32_t>(static_cast<float>(r * sum(kSine, r * r)));
    auto cosine = std::bit_cast<std::uint32_t>(static_cast<float>(sum(kCosine, r * r)));
    auto quarter = static_cast<std::uint32_t>(std::bit_cast<std::uint64_t>(shifted));
    std::uint32_t change = (sine ^ cosine) & (0u - (quarter & 1u)); // in odd quarters they change places
    return {std::bit_cast<float>(sine ^ change ^ (quarter & 2u) << 30),
            std::bit_cast<float>(cosine ^ change ^ ((quarter + 1u) & 2u) << 30)};
}

} // namespace evil::series
