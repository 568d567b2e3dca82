#pragma once
// Rows of four floats, two at a time.
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

} // namespace evil::EVIL_ISA
