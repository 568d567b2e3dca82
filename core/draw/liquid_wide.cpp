#include "draw/liquid_wide.hpp"
#include "math/wide.hpp"

namespace evil::EVIL_ISA {

void mean_of_five_wide(const float* from, int apart, float* to, int count) noexcept {
    for (int i = 0; i < count; i += kLanes) {
        const float* at = from + i;
        const Floats ends = load(at) + load(at + 4 * apart), sides = load(at + apart) + load(at + 3 * apart);
        store(to + i, (ends + sides * 4.0f + load(at + 2 * apart) * 6.0f) * 0.0625f);
    }
}

void mean_of_rows_wide(const float* const rows[5], float* to, int count) noexcept {
    for (int i = 0; i < count; i += kLanes) {
        const Floats ends = load(rows[0] + i) + load(rows[4] + i), sides = load(rows[1] + i) + load(rows[3] + i);
        store(to + i, (ends + sides * 4.0f + load(rows[2] + i) * 6.0f) * 0.0625f);
    }
}

// With a bell of 1.5 texels, the mean of a half plane lies 1.197 texels behind its edge: there the surface is.
void sharp_wide(const float* weight, const float* x, const float* y, float row, float one, float* sharp, float* whole,
                int count) noexcept {
    constexpr float kReach = 1.197f, kFew = 0.14f, kSlope = 8.0f, kOutside = -4.0f;
    for (int i = 0; i < count; i += kLanes) {
        const Floats sum = load(weight + i), per = Floats(1.0f) / max(sum, 1e-6f);
        const Floats column = to_float(lane_numbers()) + (static_cast<float>(i) + 0.5f);
        const Floats dx = load(x + i) * per - column, dy = load(y + i) * per - row;
        const Floats near = Floats(kReach) - sqrt(dx * dx + dy * dy);
        const Floats inside = max(min(near, (sum * one - kFew) * kSlope), kOutside);
        store(sharp + i, inside);
        store(whole + i, clamp(inside * 0.5f + 0.5f, 0.0f, 1.0f));
    }
}

// What is blurred with a bell of s goes through 1/2 with a slope of 1 / (s sqrt(2 pi)). The smooth surface gives way to one
// that is smoother still where the two hardly differ: there it only wavers as particles happen to lie.
void join_wide(const float* sharp, const float* smooth, const float* bulk, float* to, int count) noexcept {
    constexpr float kRoot = 2.5066f, kBell = 3.2f, kWide = 5.1f; // texels
    constexpr float kThin = 0.28f, kThick = 0.44f, kKept = 0.7f, kCalm = 0.6f, kWave = 1.4f;
    const auto ease = [](Floats t) { return t * t * (Floats(3.0f) - t * 2.0f); };
    for (int i = 0; i < count; i += kLanes) {
        const Floats own = load(sharp + i), all = load(bulk + i);
        const Floats even = (load(smooth + i) - 0.5f) * (kRoot * kBell), calm = (all - 0.5f) * (kRoot * kWide);
        const Floats rough = clamp((abs(even - calm) - kCalm) * (1.0f / (kWave - kCalm)), 0.0f, 1.0f);
        const Floats line = calm + (even - calm) * ease(rough);
        const Floats much = ease(clamp((all - kThin) * (1.0f / (kThick - kThin)), 0.0f, 1.0f));
        store(to + i, max(own + (line - own) * much, own - kKept));
    }
}

} // namespace evil::EVIL_ISA
