#pragma once
#include "math/cpu.hpp"
#include <cstdint>

// The mixer's inner loops. `count` is any number of frames; nothing beyond it is read or written.
namespace evil::mixer {

// at + step * (first + i) for i = 0, 1, ...: counted from where a ramp began, so that it does not matter how it is cut.
struct Line {
    float at = 0.0f, step = 0.0f;
    std::int32_t first = 0;
};

EVIL_WIDE(
    // out[i] = sum over taps of source[first_tap[i] + tap] times the row between two phases that fraction[i] says.
    void resample_row(const float* rows, int taps, int phase_bits, const float* source, const std::int32_t* first_tap,
                      const std::uint32_t* fraction, int count, float* out) noexcept;

    // to[i] += from[i] * gain[i]
    void add_scaled(const float* from, int count, Line gain, float* to) noexcept;

    // row[i] *= curve(place[i]), where the curve rises from 0 at 0 to 1 at 1: a quarter of a sine, which keeps the power
    // of two sounds that cross; or its square, level at both ends, which starts and stops without a click.
    void apply_curve(float* row, int count, Line place, bool squared) noexcept;

    // a[i] += (b[i] - a[i]) * share[i]
    void blend(float* a, const float* b, int count, Line share) noexcept;)
} // namespace evil::mixer
