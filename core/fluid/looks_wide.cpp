#include "fluid/looks_wide.hpp"
#include "math/wide.hpp"

namespace evil::EVIL_ISA {
namespace {

struct Twice { // what two pixels of each of eight cells show
    Floats left, right;
};

// A number of eight cells, from the first on, at a quarter of a cell to the left and to the right of their middles.
EVIL_INLINE Twice twice(const float* first) {
    const Floats before = load(first - 1), most = load(first) * fluid::kHere, after = load(first + 1);
    return {before * fluid::kNear + most + after * fluid::kFar, before * fluid::kFar + most + after * fluid::kNear};
}

// 1 - exp(-x) without exp: to the cubic term, which no eye tells from it.
EVIL_INLINE Ints entry(const fluid::Ramp& ramp, Floats value) {
    const Floats x = clamp(value * ramp.scale, 0.0f, 50.0f);
    const Floats shown = Floats(1.0f) - Floats(1.0f) / (x * (x * (x * (1.0f / 6.0f) + 0.5f) + 1.0f) + 1.0f);
    return round_to_int(shown * static_cast<float>(fluid::kRamp - 1));
}

// Gas of several colours tints the ramp by its own.
EVIL_INLINE Ints tinted(Ints colour, const Floats parts[3], Floats density, const float own[3]) {
    const Floats per = Floats(1.0f) / max(density, 1e-6f);
    Ints result = colour & static_cast<std::int32_t>(0xff000000u);
    for (int k = 0; k < 3; ++k) {
        const Floats channel = to_float(shift_right_unsigned(colour, 8 * k) & 255);
        const Floats by = parts[k] * per * (1.0f / (own[k] > 0.02f ? own[k] : 0.02f));
        result = result | (round_to_int(clamp(channel * by, 0.0f, 255.0f)) << (8 * k));
    }
    return result;
}

} // namespace

void mix_cells_wide(const float* const rows[3], const float share[3], const fluid::Planes& to, int count) noexcept {
    for (int i = 0; i < count; i += kLanes) {
        float even[2 * kLanes], odd[2 * kLanes]; // the first and the third of each cell, the second and the fourth
        for (int half = 0; half < 2; ++half) {
            float cells[2 * kLanes];
            for (int k = 0; k < 2; ++k) {
                const int at = 4 * i + (2 * half + k) * kLanes;
                store(cells + k * kLanes,
                      load(rows[0] + at) * share[0] + load(rows[1] + at) * share[1] + load(rows[2] + at) * share[2]);
            }
            Floats x, y;
            load_pairs(cells, x, y);
            store(even + half * kLanes, x), store(odd + half * kLanes, y);
        }
        Floats first, second, third, fourth;
        load_pairs(even, first, third), load_pairs(odd, second, fourth);
        store(to[0] + i, first), store(to[1] + i, second), store(to[2] + i, third), store(to[3] + i, fourth);
    }
}

// Solids hold no gas: a value is that of the gas round a pixel, up to the solid's face, and fades behind it.
void paint_row_wide(const fluid::PaintRow& row) noexcept {
    constexpr float kFace = 0.5f; // how much of a pixel at a face is gas
    for (int i = 0; i < row.count; i += kLanes) {
        const Twice sums = twice(row.shown + i);
        const int left_over = row.count - i;
        if (left_over >= kLanes && !any(max(sums.left, sums.right) > 0.0f)) { // most of the air is clear
            for (int k = 0; k < 2; ++k)
                store(row.to + 2 * i + k * kLanes, Ints(static_cast<std::int32_t>(row.ramp->colours[0])));
            continue;
        }
        const Twice open = twice(row.open + i);
        const Floats left = Floats(1.0f) / max(open.left, kFace), right = Floats(1.0f) / max(open.right, kFace);
        const Twice value{sums.left * left, sums.right * right};
        Ints low = gather(row.ramp->colours.data(), entry(*row.ramp, value.left));
        Ints high = gather(row.ramp->colours.data(), entry(*row.ramp, value.right));
        if (row.parts[0]) {
            Floats of_left[3], of_right[3];
            for (int k = 0; k < 3; ++k) {
                const Twice part = twice(row.parts[k] + i);
                of_left[k] = part.left, of_right[k] = part.right;
            }
            low = tinted(low, of_left, sums.left, row.own), high = tinted(high, of_right, sums.right, row.own);
        }
        if (left_over >= kLanes) {
            store_pairs(reinterpret_cast<float*>(row.to + 2 * i), bits_to_float(low), bits_to_float(high));
            continue;
        }
        std::uint32_t lows[kLanes], highs[kLanes];
        store(lows, low), store(highs, high);
        for (int k = 0; k < left_over; ++k) row.to[2 * (i + k)] = lows[k], row.to[2 * (i + k) + 1] = highs[k];
    }
}

} // namespace evil::EVIL_ISA
