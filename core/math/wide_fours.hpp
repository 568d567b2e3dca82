#pragma once
// Rows of four floats, two at a time, and pairs of neighbours.
#include "math/wide.hpp"

namespace evil::EVIL_ISA {

// Four floats from one place and four from another.
EVIL_INLINE Floats load_fours(const float* lower, const float* upper) {
#if EVIL_WIDTH == 8
    Floats r;
    r.part[0] = _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(lower)), _mm_loadu_ps(upper), 1);
    return r;
#else
    float lanes[kLanes];
    for (int i = 0; i < 4; ++i) lanes[i] = lower[i], lanes[i + 4] = upper[i];
    return load(lanes);
#endif
}
EVIL_INLINE void store_fours(float* lower, float* upper, Floats a) {
#if EVIL_WIDTH == 8
    _mm_storeu_ps(lower, _mm256_castps256_ps128(a.part[0]));
    _mm_storeu_ps(upper, _mm256_extractf128_ps(a.part[0], 1));
#else
    float lanes[kLanes];
    store(lanes, a);
    for (int i = 0; i < 4; ++i) lower[i] = lanes[i], upper[i] = lanes[i + 4];
#endif
}
// One float in the lower four lanes, another in the upper four.
EVIL_INLINE Floats spread_fours(float lower, float upper) {
#if EVIL_WIDTH == 8
    Floats r;
    r.part[0] = _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_set1_ps(lower)), _mm_set1_ps(upper), 1);
    return r;
#else
    const float lanes[kLanes] = {lower, lower, lower, lower, upper, upper, upper, upper};
    return load(lanes);
#endif
}
// Of eight lanes, lane k in the lower four and lane k + 1 in the upper four; k is even.
EVIL_INLINE Floats spread_two_of(Floats a, int k) {
#if EVIL_WIDTH == 8
    constexpr std::int32_t lanes[4][kLanes] = {
        {0, 0, 0, 0, 1, 1, 1, 1}, {2, 2, 2, 2, 3, 3, 3, 3}, {4, 4, 4, 4, 5, 5, 5, 5}, {6, 6, 6, 6, 7, 7, 7, 7}};
    Floats r;
    r.part[0] = _mm256_permutevar8x32_ps(a.part[0], __builtin_bit_cast(__m256i, load(lanes[k / 2]).part[0]));
    return r;
#else
    float lanes[kLanes];
    store(lanes, a);
    return spread_fours(lanes[k], lanes[k + 1]);
#endif
}

EVIL_INLINE std::int32_t first_lane(Ints a) {
#if EVIL_WIDTH == 1
    return a.part[0];
#else
    return a.part[0][0];
#endif
}

// table[index] and table[index + 1] in each lane. Both must be inside the table, also in lanes whose result is not used.
EVIL_INLINE void gather_pairs(const float* table, Ints index, Floats& first, Floats& second) {
    std::int32_t at[kLanes];
    store(at, index);
#if EVIL_WIDTH == 8
    auto two = [&](int i, int k) { // the pairs of two lanes, as 64 bits each
        const __m128 low = _mm_castsi128_ps(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(table + at[i])));
        return _mm_loadh_pi(low, reinterpret_cast<const __m64*>(table + at[k]));
    };
    const __m256 even = _mm256_insertf128_ps(_mm256_castps128_ps256(two(0, 1)), two(4, 5), 1);
    const __m256 odd = _mm256_insertf128_ps(_mm256_castps128_ps256(two(2, 3)), two(6, 7), 1);
    first.part[0] = _mm256_shuffle_ps(even, odd, 0x88);
    second.part[0] = _mm256_shuffle_ps(even, odd, 0xdd);
#else
    float lanes[2][kLanes];
    for (int i = 0; i < kLanes; ++i) lanes[0][i] = table[at[i]], lanes[1][i] = table[at[i] + 1];
    first = load(lanes[0]);
    second = load(lanes[1]);
#endif
}

} // namespace evil::EVIL_ISA
