#include "fluid/carry_wide.hpp"
#include "math/wide_fours.hpp"

namespace evil::EVIL_ISA {

using fluid::Plan;

namespace {

struct Spots { // of eight cells
    std::int32_t at[kLanes];
    float s[kLanes], t[kLanes];
};

EVIL_INLINE void find_spots(const Plan& plan, const float* dx, const float* dy, float sign, int i, int j,
                            Spots& spots) {
    const std::ptrdiff_t at = j * plan.stride + i;
    Floats x = to_float(lane_numbers() + Ints(i)) + Floats(sign) * load(dx + at);
    Floats y = Floats(static_cast<float>(j)) + Floats(sign) * load(dy + at);
    x = clamp(x, 0.0f, static_cast<float>(plan.nx - 1));
    y = clamp(y, 0.0f, static_cast<float>(plan.ny - 1));
    const Ints column = min(to_int(x), Ints(plan.nx - 2)), row = min(to_int(y), Ints(plan.ny - 2));
    store(spots.at, row * Ints(plan.nx) + column);
    store(spots.s, x - to_float(column));
    store(spots.t, y - to_float(row));
}

struct Corners {
    Floats a, b, c, d;
};
EVIL_INLINE Corners corners(const float* cells, int nx, const Spots& spots, int k) {
    const float* low = cells + 4 * static_cast<std::ptrdiff_t>(spots.at[k]);
    const float* other = cells + 4 * static_cast<std::ptrdiff_t>(spots.at[k + 1]);
    const std::ptrdiff_t above = 4 * static_cast<std::ptrdiff_t>(nx);
    return {load_fours(low, other), load_fours(low + 4, other + 4), load_fours(low + above, other + above),
            load_fours(low + above + 4, other + above + 4)};
}
EVIL_INLINE Floats between(const Corners& f, const Spots& spots, int k) {
    const Floats s = spread_fours(spots.s[k], spots.s[k + 1]), t = spread_fours(spots.t[k], spots.t[k + 1]);
    const Floats low = f.a + s * (f.b - f.a), high = f.c + s * (f.d - f.c);
    return low + t * (high - low);
}

EVIL_INLINE Mask fourth() { return (lane_numbers() & Ints(3)) == Ints(3); }

} // namespace

void carry_cells(const Plan& plan, const float* cells, const float* dx, const float* dy, float* carried, int first,
                 int last) noexcept {
    Spots spots;
    for (int j = first; j < last; ++j)
        for (int i = 0; i < plan.nx; i += kLanes) {
            find_spots(plan, dx, dy, -1.0f, i, j, spots);
            float* to = carried + 4 * (static_cast<std::ptrdiff_t>(j) * plan.nx + i);
            for (int k = 0; k < kLanes && i + k < plan.nx; k += 2) {
                Floats value = between(corners(cells, plan.nx, spots, k), spots, k);
                const Floats real = spread_in_four<3>(value);
                if (!all(real == Floats(1.0f))) {
                    const Floats whole = value / max(real, 1e-6f);
                    value = select(real == Floats(1.0f), value, select(fourth(), Floats(0.0f), whole));
                }
                store_first(to + 4 * k, i + k + 1 < plan.nx ? 8 : 4, value);
            }
        }
}

void correct_cells(const Plan& plan, const float* cells, const float* carried, const float* dx, const float* dy,
                   const float* open, float* result, float* sums, int first, int last) noexcept {
    Spots from, to;
    for (int j = first; j < last; ++j) {
        Floats before(0.0f), after(0.0f);
        for (int i = 0; i < plan.nx; i += kLanes) {
            find_spots(plan, dx, dy, -1.0f, i, j, from);
            find_spots(plan, dx, dy, 1.0f, i, j, to);
            const std::ptrdiff_t row = 4 * (static_cast<std::ptrdiff_t>(j) * plan.nx + i);
            const float* gas = open + j * plan.stride + i;
            for (int k = 0; k < kLanes && i + k < plan.nx; k += 2) {
                const int count = i + k + 1 < plan.nx ? 8 : 4;
                const Floats value = load_first(cells + row + 4 * k, count),
                             plain = load_first(carried + row + 4 * k, count);
                const Corners f = corners(cells, plan.nx, from, k);
                const Floats back = between(corners(carried, plan.nx, to, k), to, k);
                const Floats least = min(min(f.a, f.b), min(f.c, f.d)), most = max(max(f.a, f.b), max(f.c, f.d));
                const Floats better = clamp(plain + Floats(0.5f) * (value - back), least, most);
                const Floats sound = min(spread_in_four<3>(plain), spread_in_four<3>(back));
                Floats now = select(sound == Floats(1.0f), better, plain);
                now = select(fourth(), Floats(1.0f), now) * spread_fours(gas[k], gas[k + 1]);
                store_first(result + row + 4 * k, count, now);
                before += value;
                after += select(first_lanes(count), now, Floats(0.0f));
            }
        }
        float lanes[2][kLanes];
        store(lanes[0], before);
        store(lanes[1], after);
        sums[2 * j] = lanes[0][0] + lanes[0][4];
        sums[2 * j + 1] = lanes[1][0] + lanes[1][4];
    }
}

} // namespace evil::EVIL_ISA
