#include "math/mat4_wide.hpp"
#include "math/wide.hpp"

namespace evil::EVIL_ISA {
namespace {

struct Columns {
    Floats x, y, z, w;
}; // a matrix's columns, each twice

EVIL_INLINE Columns load_columns(const float* m) {
    return {load_four_twice(m), load_four_twice(m + 4), load_four_twice(m + 8), load_four_twice(m + 12)};
}

// Two vectors side by side, each times the matrix.
EVIL_INLINE Floats times(const Columns& m, Floats v) {
    return m.x * spread_in_four<0>(v) + m.y * spread_in_four<1>(v) + m.z * spread_in_four<2>(v) +
           m.w * spread_in_four<3>(v);
}

} // namespace

bool all_finite(const float* numbers, std::size_t count) noexcept {
    constexpr std::int32_t kExponent = 0x7f800000; // all ones in infinities and NaN, and in nothing else
    Mask bad = Ints(0) == Ints(1);
    std::size_t i = 0;
    for (; i + kLanes <= count; i += kLanes)
        bad = bad | ((float_to_bits(load(numbers + i)) & Ints(kExponent)) == Ints(kExponent));
    int rest = static_cast<int>(count - i);
    return !any(bad | ((float_to_bits(load_first(numbers + i, rest)) & Ints(kExponent)) == Ints(kExponent)));
}

void transform_points(const float* m, const float* points, float* out, std::size_t count) noexcept {
    Floats xx = m[0], yx = m[1], xy = m[4], yy = m[5], tx = m[12], ty = m[13], x, y;
    std::size_t i = 0;
    for (; i + kLanes <= count; i += kLanes) {
        load_pairs(points + 2 * i, x, y);
        store_pairs(out + 2 * i, xx * x + xy * y + tx, yx * x + yy * y + ty);
    }
    for (; i < count; ++i) {
        float px = points[2 * i], py = points[2 * i + 1];
        out[2 * i] = m[0] * px + m[4] * py + m[12];
        out[2 * i + 1] = m[1] * px + m[5] * py + m[13];
    }
}

void transform_vectors(const float* m, const float* vectors, float* out, std::size_t count) noexcept {
    Columns columns = load_columns(m);
    std::size_t i = 0;
    for (; i + 2 <= count; i += 2) store(out + 4 * i, times(columns, load(vectors + 4 * i)));
    if (i < count) store_first(out + 4 * i, 4, times(columns, load_first(vectors + 4 * i, 4)));
}

void multiply(const float* a, std::size_t a_stride, const float* b, std::size_t b_stride, float* out,
              std::size_t count) noexcept {
    for (std::size_t i = 0; i < count; ++i, a += a_stride, b += b_stride, out += 16) {
        Columns columns = load_columns(a);
        store(out, times(columns, load(b)));
        store(out + 8, times(columns, load(b + 8)));
    }
}

} // namespace evil::EVIL_ISA
