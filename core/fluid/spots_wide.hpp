#pragma once
// Eight places between the numbers of a field, and what is found there. Gas that flows evenly comes from eight places side
// by side: then whole registers are loaded, where otherwise each number is fetched by itself. For *_wide.cpp files.
#include "math/wide_fours.hpp"

namespace evil::EVIL_ISA {

struct Spots {
    Ints at; // the number to the lower left of each
    Floats s, t;
    std::int32_t first; // of lane 0
    bool in_a_row;      // do the others follow it, one by one?
};

EVIL_INLINE Spots spots_of(Floats x, Floats y, int columns, int rows, std::ptrdiff_t stride) {
    x = clamp(x, 0.0f, static_cast<float>(columns - 1));
    y = clamp(y, 0.0f, static_cast<float>(rows - 1));
    const Ints i = min(to_int(x), Ints(columns - 2)), j = min(to_int(y), Ints(rows - 2));
    const Ints at = j * Ints(static_cast<std::int32_t>(stride)) + i;
    const std::int32_t first = first_lane(at);
    return {at, x - to_float(i), y - to_float(j), first, all(at == Ints(first) + lane_numbers())};
}

struct Corners {
    Floats a, b, c, d; // below left and right, above left and right
};

EVIL_INLINE Corners corners(const float* field, const Spots& spots, std::ptrdiff_t stride) {
    Corners f;
    if (spots.in_a_row) {
        const float *low = field + spots.first, *high = low + stride;
        return {load(low), load(low + 1), load(high), load(high + 1)};
    }
    gather_pairs(field, spots.at, f.a, f.b);
    gather_pairs(field + stride, spots.at, f.c, f.d);
    return f;
}

EVIL_INLINE Floats between(const Corners& f, Floats s, Floats t) {
    const Floats low = f.a + s * (f.b - f.a), high = f.c + s * (f.d - f.c);
    return low + t * (high - low);
}
EVIL_INLINE Floats least_of(const Corners& f) { return min(min(f.a, f.b), min(f.c, f.d)); }
EVIL_INLINE Floats most_of(const Corners& f) { return max(max(f.a, f.b), max(f.c, f.d)); }

EVIL_INLINE Floats columns_from(int i) { return to_float(lane_numbers() + Ints(i)); }
EVIL_INLINE int lanes_of(int i, int columns) { return columns - i < kLanes ? columns - i : kLanes; }

} // namespace evil::EVIL_ISA
