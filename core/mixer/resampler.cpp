#include "mixer/resampler.hpp"
#include "math/functions.hpp"
#include "mixer/kernels_wide.hpp"
#include <bit>
#include <cmath>

namespace evil::mixer {
namespace {

constexpr int kCrossings = 16;      // zero crossings each side: 0.09 of the rate from passed to stopped
constexpr double kKaiserBeta = 9.0; // 90 dB of stop band; more would widen the way there
constexpr int kPhaseBits = 9;       // blending between 512 rows errs by -106 dB, less than the stop band lets through
constexpr std::int64_t kOne = 1ll << 32;

// Bessel's I0 by its power series, for the Kaiser window.
double bessel(double x) {
    double term = 1.0, total = 1.0;
    for (int k = 1; term > 1e-17 * total; ++k) {
        term *= (x / (2.0 * k)) * (x / (2.0 * k));
        total += term;
    }
    return total;
}

// sin(pi u) / (pi u), in double: the polynomial behind sincos is good to a float only, too coarse for -90 dB sums.
double sinc(double u) {
    if (u == 0.0) return 1.0;
    double nearest = std::floor(u + 0.5), r = kPi * (u - nearest), square = r * r, term = r, total = r;
    for (int k = 1; k <= 9; ++k) {
        term *= -square / ((2.0 * k) * (2.0 * k + 1.0));
        total += term;
    }
    bool odd = std::fmod(nearest, 2.0) != 0.0;
    return (odd ? -total : total) / (kPi * u);
}

// The continuous kernel at u zero crossings from its middle.
double weight(double u) {
    double inside = 1.0 - (u / kCrossings) * (u / kCrossings);
    return inside < 0.0 ? 0.0 : sinc(u) * bessel(kKaiserBeta * std::sqrt(inside));
}

// 2^(number/4), exact for the whole powers and rounded the same everywhere for the others.
double top_speed(int number) {
    constexpr double kRoots[4] = {1.0, 1.189207115002721, 1.4142135623730951, 1.681792830507429};
    return kRoots[number & 3] * static_cast<double>(1 << (number >> 2));
}

} // namespace

int kernel_for(std::int64_t speed) noexcept {
    double ratio = static_cast<double>(speed) / static_cast<double>(kOne);
    int number = 0;
    while (number < kKernels - 1 && ratio > top_speed(number)) ++number;
    return number;
}

Kernel make_kernel(int number) {
    double stretch = top_speed(number);
    Kernel kernel;
    kernel.taps = (static_cast<int>(std::ceil(2 * kCrossings * stretch)) + 7) / 8 * 8;
    kernel.phase_bits = kPhaseBits - number / 4; // a wider kernel is smoother
    const int phases = 1 << kernel.phase_bits;
    kernel.rows.resize(static_cast<std::size_t>(phases + 1) * static_cast<std::size_t>(kernel.taps));
    std::vector<double> row(static_cast<std::size_t>(kernel.taps));
    for (int phase = 0; phase <= phases; ++phase) {
        double total = 0.0;
        for (int tap = 0; tap < kernel.taps; ++tap) {
            double distance = tap - kernel.before() - static_cast<double>(phase) / phases;
            total += row[static_cast<std::size_t>(tap)] = weight(distance / stretch);
        }
        float* to = kernel.rows.data() + static_cast<std::size_t>(phase) * row.size();
        for (double each : row) *to++ = static_cast<float>(each / total); // a constant stays what it is
    }
    return kernel;
}

void resample(const Kernel& kernel, const float* source, const std::int32_t* first_tap, const std::uint32_t* fraction,
              int count, float* out, InstructionSet set) noexcept {
    EVIL_PICK(set, resample_row)
    (kernel.rows.data(), kernel.taps, kernel.phase_bits, source, first_tap, fraction, count, out);
}

} // namespace evil::mixer
