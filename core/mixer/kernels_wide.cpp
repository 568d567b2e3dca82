#include "mixer/kernels_wide.hpp"
#include "math/wide.hpp"

namespace evil::mixer::EVIL_ISA {
namespace {

using namespace evil::EVIL_ISA;

// Call step(i, n) for each eight frames, the last time with what is left.
template <class Step> EVIL_INLINE void each_eight(int count, Step step) {
    for (int i = 0; i < count; i += kLanes) step(i, count - i < kLanes ? count - i : kLanes);
}

EVIL_INLINE Floats load_up_to(const float* from, int n) { return n == kLanes ? load(from) : load_first(from, n); }
EVIL_INLINE void store_up_to(float* to, int n, Floats v) {
    if (n == kLanes)
        store(to, v);
    else
        store_first(to, n, v);
}

EVIL_INLINE Floats at(Line line, int i) {
    return Floats(line.at) + Floats(line.step) * to_float(lane_numbers() + Ints(line.first + i));
}

// sin(pi/2 t) for 0 <= t <= 1, within 4e-6: Taylor's terms, the last one such that 1 gives 1.
EVIL_INLINE Floats quarter_sine(Floats t) {
    constexpr float a1 = 1.5707964f, a3 = -0.64596410f, a5 = 0.079692626f, a7 = -0.0046817541f;
    constexpr float a9 = 1.0f - (a1 + a3 + a5 + a7);
    Floats s = t * t;
    return t * (Floats(a1) + s * (Floats(a3) + s * (Floats(a5) + s * (Floats(a7) + s * Floats(a9)))));
}

} // namespace

void resample_row(const float* rows, int taps, int phase_bits, const float* source, const std::int32_t* first_tap,
                  const std::uint32_t* fraction, int count, float* out) noexcept {
    for (int i = 0; i < count; ++i) {
        const float* row =
            rows + static_cast<std::size_t>(fraction[i] >> (32 - phase_bits)) * static_cast<std::size_t>(taps);
        const float* next = row + taps;
        const float* from = source + first_tap[i];
        Floats between = static_cast<float>((fraction[i] << phase_bits) >> 8) * 0x1p-24f;
        Floats total = 0.0f;
        for (int tap = 0; tap < taps; tap += kLanes) {
            Floats a = load(row + tap);
            total += (a + (load(next + tap) - a) * between) * load(from + tap);
        }
        out[i] = sum(total);
    }
}

void add_scaled(const float* from, int count, Line gain, float* to) noexcept {
    each_eight(count, [&](int i, int n) {
        store_up_to(to + i, n, load_up_to(to + i, n) + load_up_to(from + i, n) * at(gain, i));
    });
}

void apply_curve(float* row, int count, Line place, bool squared) noexcept {
    each_eight(count, [&](int i, int n) {
        Floats curve = quarter_sine(clamp(at(place, i), 0.0f, 1.0f));
        if (squared) curve *= curve;
        store_up_to(row + i, n, load_up_to(row + i, n) * curve);
    });
}

void blend(float* a, const float* b, int count, Line share) noexcept {
    each_eight(count, [&](int i, int n) {
        Floats x = load_up_to(a + i, n);
        store_up_to(a + i, n, x + (load_up_to(b + i, n) - x) * at(share, i));
    });
}

} // namespace evil::mixer::EVIL_ISA
