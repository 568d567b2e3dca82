#include "fluid/carry_wide.hpp"
#include "fluid/spots_wide.hpp"

namespace evil::EVIL_ISA {

using fluid::Plan;

namespace {

// Where the eight cells from (i, j) on come from, or go to.
EVIL_INLINE Spots find_spots(const Plan& plan, const float* dx, const float* dy, float sign, int i, int j) {
    const std::ptrdiff_t at = j * plan.stride + i;
    return spots_of(columns_from(i) + Floats(sign) * load(dx + at),
                    Floats(static_cast<float>(j)) + Floats(sign) * load(dy + at), plan.nx, plan.ny, plan.nx);
}

// Round spots k and k + 1: two cells a register.
EVIL_INLINE Corners two_corners(const float* cells, int nx, const Spots& spots, const std::int32_t* at, int k) {
    const std::ptrdiff_t above = 4 * static_cast<std::ptrdiff_t>(nx);
    const float* low = cells + 4 * static_cast<std::ptrdiff_t>(at[k]);
    if (spots.in_a_row) return {load(low), load(low + 4), load(low + above), load(low + above + 4)};
    const float* other = cells + 4 * static_cast<std::ptrdiff_t>(at[k + 1]);
    return {load_fours(low, other), load_fours(low + 4, other + 4), load_fours(low + above, other + above),
            load_fours(low + above + 4, other + above + 4)};
}
EVIL_INLINE Floats two_between(const Corners& f, const Spots& spots, int k) {
    return between(f, spread_two_of(spots.s, k), spread_two_of(spots.t, k));
}

EVIL_INLINE Mask fourth() { return (lane_numbers() & Ints(3)) == Ints(3); }

} // namespace

void carry_cells(const Plan& plan, const float* cells, const float* dx, const float* dy, float* carried, int first,
                 int last) noexcept {
    std::int32_t at[kLanes];
    for (int j = first; j < last; ++j)
        for (int i = 0; i < plan.nx; i += kLanes) {
            const Spots spots = find_spots(plan, dx, dy, -1.0f, i, j);
            store(at, spots.at);
            float* to = carried + 4 * (static_cast<std::ptrdiff_t>(j) * plan.nx + i);
            for (int k = 0; k < kLanes && i + k < plan.nx; k += 2) {
                Floats value = two_between(two_corners(cells, plan.nx, spots, at, k), spots, k);
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
    std::int32_t from_at[kLanes], to_at[kLanes];
    for (int j = first; j < last; ++j) {
        Floats before(0.0f), after(0.0f);
        for (int i = 0; i < plan.nx; i += kLanes) {
            const Spots from = find_spots(plan, dx, dy, -1.0f, i, j), to = find_spots(plan, dx, dy, 1.0f, i, j);
            store(from_at, from.at);
            store(to_at, to.at);
            const Floats gas = load(open + j * plan.stride + i);
            const std::ptrdiff_t row = 4 * (static_cast<std::ptrdiff_t>(j) * plan.nx + i);
            for (int k = 0; k < kLanes && i + k < plan.nx; k += 2) {
                const int count = i + k + 1 < plan.nx ? 8 : 4;
                const Floats value = load_first(cells + row + 4 * k, count),
                             plain = load_first(carried + row + 4 * k, count);
                const Corners f = two_corners(cells, plan.nx, from, from_at, k);
                const Floats back = two_between(two_corners(carried, plan.nx, to, to_at, k), to, k);
                const Floats better = clamp(plain + Floats(0.5f) * (value - back), least_of(f), most_of(f));
                const Floats sound = min(spread_in_four<3>(plain), spread_in_four<3>(back));
                Floats now = select(sound == Floats(1.0f), better, plain);
                now = select(fourth(), Floats(1.0f), now) * spread_two_of(gas, k);
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

void settle_cells(const Plan& plan, const fluid::Fate& fate, const float* cells, float* result, float* seconds,
                  int first, int last) noexcept {
    const float gives[4] = {fate.soot, fate.heat, 0.0f, 0.0f}, bounds[4] = {3e38f, fate.most, 3e38f, 3e38f};
    const Floats one = load_four_twice(fate.first), other = load_four_twice(fate.then), given = load_four_twice(gives),
                 most = load_four_twice(bounds);
    for (int j = first; j < last; ++j) {
        const std::ptrdiff_t row = 4 * static_cast<std::ptrdiff_t>(j) * plan.nx;
        for (int i = 0; i < 4 * plan.nx; i += kLanes) {
            const int count = lanes_of(i, 4 * plan.nx);
            const Floats now = load_first(cells + row + i, count);
            const Floats burnt = spread_in_four<2>(now) * Floats(fate.burns);
            store_first(result + row + i, count, clamp(now * one * other + given * burnt, -most, most));
        }
        if (seconds == nullptr) continue;
        for (int i = 0; i < plan.nx; ++i) seconds[j * plan.stride + i] = result[row + 4 * i + 1];
    }
}

} // namespace evil::EVIL_ISA
