#pragma once
#include "math/cpu.hpp"
#include <cstddef>
#include <cstdint>

namespace evil {

struct BoundsView { // by piece, up to a whole eight
    const float *low_x, *low_y, *high_x, *high_y;
};

struct CandidatesView { // of pairs: the pieces' numbers, up to a whole eight
    const std::uint32_t *a, *b;
};

// first is a multiple of eight in both.
//
// Do the bounds of pieces first..last lie within the grown ones? Puts their corners into `lows` and `highs`, x and y in turn.
EVIL_WIDE(bool stay_within(const BoundsView& now, const BoundsView& grown, float* lows, float* highs, std::size_t first,
                           std::size_t last) noexcept;)
// Whose bounds meet: a bit for each of pairs first..last, in bytes by eight.
EVIL_WIDE(void test_candidates(const CandidatesView& pairs, const float* lows, const float* highs, std::uint8_t* meet,
                               std::size_t first, std::size_t last) noexcept;)

} // namespace evil
