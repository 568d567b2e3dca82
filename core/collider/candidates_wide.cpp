#include "collider/candidates_wide.hpp"
#include "math/wide_fours.hpp"

namespace evil::EVIL_ISA {

bool stay_within(const BoundsView& now, const BoundsView& grown, float* lows, float* highs, std::size_t first,
                 std::size_t last) noexcept {
    Mask within = first_lanes(kLanes);
    for (std::size_t i = first; i < last; i += kLanes) {
        Floats low_x = load(now.low_x + i), low_y = load(now.low_y + i);
        Floats high_x = load(now.high_x + i), high_y = load(now.high_y + i);
        within = within & (low_x >= load(grown.low_x + i)) & (low_y >= load(grown.low_y + i)) &
                 (high_x <= load(grown.high_x + i)) & (high_y <= load(grown.high_y + i));
        store_pairs(lows + 2 * i, low_x, low_y);
        store_pairs(highs + 2 * i, high_x, high_y);
    }
    return all(within);
}

void test_candidates(const CandidatesView& pairs, const float* lows, const float* highs, std::uint8_t* meet,
                     std::size_t first, std::size_t last) noexcept {
    for (std::size_t i = first; i < last; i += kLanes) {
        Ints a = load(pairs.a + i) << 1, b = load(pairs.b + i) << 1;
        Floats low_ax, low_ay, high_ax, high_ay, low_bx, low_by, high_bx, high_by;
        gather_pairs(lows, a, low_ax, low_ay);
        gather_pairs(highs, a, high_ax, high_ay);
        gather_pairs(lows, b, low_bx, low_by);
        gather_pairs(highs, b, high_bx, high_by);
        Mask both = (low_ax <= high_bx) & (low_bx <= high_ax) & (low_ay <= high_by) & (low_by <= high_ay);
        unsigned there = last - i < kLanes ? (1u << (last - i)) - 1u : 255u;
        meet[i / kLanes] = static_cast<std::uint8_t>(bits(both) & there);
    }
}

} // namespace evil::EVIL_ISA
