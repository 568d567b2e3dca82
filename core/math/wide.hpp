#pragma once
// Eight floats or integers at a time, for *_wide.cpp files (math/cpu.hpp tells how those are built and called).
//
// There are always eight lanes: one AVX2 register, two of SSE2, NEON or a browser's SIMD, or eight plain values. So layouts
// and results do not depend on the machine; each operation is one IEEE operation on each lane, never a fused one, and sums
// over lanes have a fixed order.
//
//     Floats x = load(p);                        // unaligned; load_first(p, n) and store_first(p, n, x) for a rest of n < 8
//     Mask inside = (x > 0.0f) & (x < limit);    // numbers turn into eight equal lanes
//     x = select(inside, sqrt(x), 1.0f);         // both sides are computed
//     store(p, min(x, 2.0f));
//     Ints pixel = load(rgba);                   // std::uint32_t: eight pixels of 0xAABBGGRR
//     Floats red = to_float(pixel & 255), green = to_float((pixel >> 8) & 255);
//     store(rgba, round_to_int(red) | (round_to_int(green) << 8) | ...);
//
// Do not call inline functions of other headers from a wide file, unless they surely vanish: the linker keeps one copy
// of each, and if that is the AVX2 one, an older machine stops. Functions here are always inlined.
#include <cmath>
#include <cstddef>
#include <cstdint>

#if !defined(EVIL_ISA)
#error "math/wide.hpp is for *_wide.cpp files, which the build compiles once for each instruction set"
#endif

#if defined(EVIL_PLAIN) || !defined(__GNUC__)
#define EVIL_WIDTH 1
#elif defined(__AVX2__)
#define EVIL_WIDTH 8
#include <immintrin.h>
#else
#define EVIL_WIDTH 4
#if defined(__SSE2__)
#include <emmintrin.h>
#elif defined(__ARM_NEON) && defined(__aarch64__)
#include <arm_neon.h>
#endif
#endif

#if defined(__GNUC__)
#define EVIL_INLINE inline __attribute__((always_inline))
#else
#define EVIL_INLINE __forceinline
#endif

namespace evil::EVIL_ISA {

inline constexpr int kLanes = 8;

// One register of the machine. Comparisons give all ones or all zeros.
namespace native {

inline constexpr int kWidth = EVIL_WIDTH, kParts = kLanes / kWidth;
#if EVIL_WIDTH == 1
using F = float;
using I = std::int32_t;
using U = std::uint32_t;
using AnyF = float; // as it lies in memory
using AnyI = std::int32_t;
EVIL_INLINE F spread(float v) { return v; }
EVIL_INLINE I spread(std::int32_t v) { return v; }
EVIL_INLINE I truth(bool v) { return -static_cast<I>(v); }
EVIL_INLINE F to_float(I v) { return static_cast<F>(v); }
EVIL_INLINE I truncate(F v) { return v >= -2147483648.0f && v < 2147483648.0f ? static_cast<I>(v) : INT32_MIN; }
#else
typedef float F __attribute__((vector_size(4 * EVIL_WIDTH)));
typedef std::int32_t I __attribute__((vector_size(4 * EVIL_WIDTH)));
typedef std::uint32_t U __attribute__((vector_size(4 * EVIL_WIDTH)));
typedef F AnyF __attribute__((aligned(4), may_alias)); // as it lies in memory
typedef I AnyI __attribute__((aligned(4), may_alias));
EVIL_INLINE F spread(float v) { return v - F{}; }
EVIL_INLINE I spread(std::int32_t v) { return v - I{}; }
EVIL_INLINE I truth(I v) { return v; }
EVIL_INLINE F to_float(I v) { return __builtin_convertvector(v, F); }
#endif

EVIL_INLINE F bits_to_float(I v) { return __builtin_bit_cast(F, v); }
EVIL_INLINE I float_to_bits(F v) { return __builtin_bit_cast(I, v); }
#if EVIL_WIDTH == 8
EVIL_INLINE I select(I m, I a, I b) { // one instruction where the other form is three
    return float_to_bits(_mm256_blendv_ps(bits_to_float(b), bits_to_float(a), bits_to_float(m)));
}
#else
EVIL_INLINE I select(I m, I a, I b) { return (a & m) | (b & ~m); }
#endif

// What vector expressions cannot say, or compilers would not make one instruction of.
#if EVIL_WIDTH == 8
EVIL_INLINE F sqrt(F v) { return _mm256_sqrt_ps(v); }
EVIL_INLINE F min(F a, F b) { return _mm256_min_ps(a, b); }
EVIL_INLINE F max(F a, F b) { return _mm256_max_ps(a, b); }
EVIL_INLINE F select(I m, F a, F b) { return _mm256_blendv_ps(b, a, bits_to_float(m)); }
EVIL_INLINE I truncate(F v) { return __builtin_bit_cast(I, _mm256_cvttps_epi32(v)); }
EVIL_INLINE unsigned signs(I m) { return static_cast<unsigned>(_mm256_movemask_ps(bits_to_float(m))); }
#elif EVIL_WIDTH == 4
EVIL_INLINE F select(I m, F a, F b) { return bits_to_float(select(m, float_to_bits(a), float_to_bits(b))); }
#if defined(__SSE2__)
EVIL_INLINE F sqrt(F v) { return _mm_sqrt_ps(v); }
EVIL_INLINE F min(F a, F b) { return _mm_min_ps(a, b); }
EVIL_INLINE F max(F a, F b) { return _mm_max_ps(a, b); }
EVIL_INLINE I truncate(F v) { return __builtin_bit_cast(I, _mm_cvttps_epi32(v)); }
EVIL_INLINE unsigned signs(I m) { return static_cast<unsigned>(_mm_movemask_ps(bits_to_float(m))); }
#else
EVIL_INLINE F min(F a, F b) { return select(a < b, a, b); }
EVIL_INLINE F max(F a, F b) { return select(a > b, a, b); }
EVIL_INLINE I truncate(F v) { // out of range saturates here and not on x86: made equal
    return select((v >= -2147483648.0f) & (v < 2147483648.0f), __builtin_convertvector(v, I), spread(INT32_MIN));
}
EVIL_INLINE unsigned signs(I m) { return (m[0] & 1u) | (m[1] & 2u) | (m[2] & 4u) | (m[3] & 8u); }
#if defined(__aarch64__)
EVIL_INLINE F sqrt(F v) { return __builtin_bit_cast(F, vsqrtq_f32(__builtin_bit_cast(float32x4_t, v))); }
#else
EVIL_INLINE F sqrt(F v) { return F{std::sqrt(v[0]), std::sqrt(v[1]), std::sqrt(v[2]), std::sqrt(v[3])}; }
#endif
#endif
#else
EVIL_INLINE F select(I m, F a, F b) { return m ? a : b; }
EVIL_INLINE F sqrt(F v) { return std::sqrt(v); }
EVIL_INLINE F min(F a, F b) { return a < b ? a : b; }
EVIL_INLINE F max(F a, F b) { return a > b ? a : b; }
EVIL_INLINE unsigned signs(I m) { return m < 0 ? 1u : 0u; }
#endif

} // namespace native

struct Floats {
    native::F part[native::kParts];
    Floats() = default;
    EVIL_INLINE Floats(float v) {
        for (native::F& p : part) p = native::spread(v);
    }
};

struct Ints { // 32 bits, two's complement; + - * wrap round
    native::I part[native::kParts];
    Ints() = default;
    EVIL_INLINE Ints(std::int32_t v) {
        for (native::I& p : part) p = native::spread(v);
    }
};

struct Mask { // each lane all ones (true) or all zeros
    native::I part[native::kParts];
};

// Result lanes part by part; the compiler unrolls it to one or two instructions.
#define EVIL_EACH(Result, expression)                                                                                  \
    Result r;                                                                                                          \
    for (int p = 0; p < native::kParts; ++p) r.part[p] = expression;                                                   \
    return r

EVIL_INLINE Floats operator+(Floats a, Floats b) { EVIL_EACH(Floats, a.part[p] + b.part[p]); }
EVIL_INLINE Floats operator-(Floats a, Floats b) { EVIL_EACH(Floats, a.part[p] - b.part[p]); }
EVIL_INLINE Floats operator*(Floats a, Floats b) { EVIL_EACH(Floats, a.part[p] * b.part[p]); }
EVIL_INLINE Floats operator/(Floats a, Floats b) { EVIL_EACH(Floats, a.part[p] / b.part[p]); }
EVIL_INLINE Floats operator-(Floats a) { EVIL_EACH(Floats, -a.part[p]); }
EVIL_INLINE Floats& operator+=(Floats& a, Floats b) { return a = a + b; }
EVIL_INLINE Floats& operator-=(Floats& a, Floats b) { return a = a - b; }
EVIL_INLINE Floats& operator*=(Floats& a, Floats b) { return a = a * b; }
EVIL_INLINE Floats sqrt(Floats a) { EVIL_EACH(Floats, native::sqrt(a.part[p])); }
EVIL_INLINE Floats min(Floats a, Floats b) { EVIL_EACH(Floats, native::min(a.part[p], b.part[p])); } // a < b ? a : b
EVIL_INLINE Floats max(Floats a, Floats b) { EVIL_EACH(Floats, native::max(a.part[p], b.part[p])); } // a > b ? a : b
EVIL_INLINE Floats clamp(Floats a, Floats least, Floats most) {
    return min(max(a, least), most);
} // NaN becomes `least`

EVIL_INLINE Mask operator<(Floats a, Floats b) { EVIL_EACH(Mask, native::truth(a.part[p] < b.part[p])); }
EVIL_INLINE Mask operator<=(Floats a, Floats b) { EVIL_EACH(Mask, native::truth(a.part[p] <= b.part[p])); }
EVIL_INLINE Mask operator>(Floats a, Floats b) { EVIL_EACH(Mask, native::truth(a.part[p] > b.part[p])); }
EVIL_INLINE Mask operator>=(Floats a, Floats b) { EVIL_EACH(Mask, native::truth(a.part[p] >= b.part[p])); }
EVIL_INLINE Mask operator==(Floats a, Floats b) { EVIL_EACH(Mask, native::truth(a.part[p] == b.part[p])); }

EVIL_INLINE Ints operator+(Ints a, Ints b) {
    EVIL_EACH(Ints, (native::I)((native::U)a.part[p] + (native::U)b.part[p]));
}
EVIL_INLINE Ints operator-(Ints a, Ints b) {
    EVIL_EACH(Ints, (native::I)((native::U)a.part[p] - (native::U)b.part[p]));
}
EVIL_INLINE Ints operator*(Ints a, Ints b) {
    EVIL_EACH(Ints, (native::I)((native::U)a.part[p] * (native::U)b.part[p]));
}
EVIL_INLINE Ints operator&(Ints a, Ints b) { EVIL_EACH(Ints, a.part[p] & b.part[p]); }
EVIL_INLINE Ints operator|(Ints a, Ints b) { EVIL_EACH(Ints, a.part[p] | b.part[p]); }
EVIL_INLINE Ints operator^(Ints a, Ints b) { EVIL_EACH(Ints, a.part[p] ^ b.part[p]); }
EVIL_INLINE Ints operator~(Ints a) { EVIL_EACH(Ints, ~a.part[p]); }
EVIL_INLINE Ints operator<<(Ints a, int n) { EVIL_EACH(Ints, (native::I)((native::U)a.part[p] << n)); } // n in 0..31
EVIL_INLINE Ints operator>>(Ints a, int n) { EVIL_EACH(Ints, a.part[p] >> n); } // keeps the sign
EVIL_INLINE Ints shift_right_unsigned(Ints a, int n) { EVIL_EACH(Ints, (native::I)((native::U)a.part[p] >> n)); }
EVIL_INLINE Mask operator<(Ints a, Ints b) { EVIL_EACH(Mask, native::truth(a.part[p] < b.part[p])); }
EVIL_INLINE Mask operator>(Ints a, Ints b) { EVIL_EACH(Mask, native::truth(a.part[p] > b.part[p])); }
EVIL_INLINE Mask operator==(Ints a, Ints b) { EVIL_EACH(Mask, native::truth(a.part[p] == b.part[p])); }

EVIL_INLINE Mask operator&(Mask a, Mask b) { EVIL_EACH(Mask, a.part[p] & b.part[p]); }
EVIL_INLINE Mask operator|(Mask a, Mask b) { EVIL_EACH(Mask, a.part[p] | b.part[p]); }
EVIL_INLINE Mask operator~(Mask a) { EVIL_EACH(Mask, ~a.part[p]); }
EVIL_INLINE Floats select(Mask m, Floats yes, Floats no) {
    EVIL_EACH(Floats, native::select(m.part[p], yes.part[p], no.part[p]));
}
EVIL_INLINE Ints select(Mask m, Ints yes, Ints no) {
    EVIL_EACH(Ints, native::select(m.part[p], yes.part[p], no.part[p]));
}
EVIL_INLINE Ints min(Ints a, Ints b) { return select(a < b, a, b); }
EVIL_INLINE Ints max(Ints a, Ints b) { return select(a > b, a, b); }

// Lane i of the mask as bit i.
EVIL_INLINE unsigned bits(Mask m) {
    unsigned all = 0;
    for (int p = 0; p < native::kParts; ++p) all |= native::signs(m.part[p]) << (p * native::kWidth);
    return all;
}
EVIL_INLINE bool any(Mask m) { return bits(m) != 0u; }
EVIL_INLINE bool all(Mask m) { return bits(m) == 255u; }

EVIL_INLINE Floats to_float(Ints a) { EVIL_EACH(Floats, native::to_float(a.part[p])); } // to nearest, ties to even
EVIL_INLINE Ints to_int(Floats a) {
    EVIL_EACH(Ints, native::truncate(a.part[p]));
} // toward zero; INT32_MIN if out of range
EVIL_INLINE Floats bits_to_float(Ints a) { EVIL_EACH(Floats, native::bits_to_float(a.part[p])); } // the same 32 bits
EVIL_INLINE Ints float_to_bits(Floats a) { EVIL_EACH(Ints, native::float_to_bits(a.part[p])); }
EVIL_INLINE Floats abs(Floats a) { return bits_to_float(float_to_bits(a) & 0x7fffffff); }

// Nearest integer, ties to even, for |a| < 2^22: adding 1.5 * 2^23 leaves the integer in the low bits of the float.
EVIL_INLINE Ints round_to_int(Floats a) { return float_to_bits(a + 12582912.0f) - 0x4b400000; }

// Largest integer not above a, for |a| < 2^31.
EVIL_INLINE Ints floor_to_int(Floats a) {
    Ints toward_zero = to_int(a);
    return toward_zero - select(to_float(toward_zero) > a, Ints(1), Ints(0));
}
// Largest whole number not above a, any a: from 2^23 on, floats are whole.
EVIL_INLINE Floats floor(Floats a) { return select(abs(a) < 8388608.0f, to_float(floor_to_int(a)), a); }

#undef EVIL_EACH

// Memory, in lane order. No alignment is needed.
EVIL_INLINE Floats load(const float* from) {
    Floats r;
    for (int p = 0; p < native::kParts; ++p)
        r.part[p] = *reinterpret_cast<const native::AnyF*>(from + p * native::kWidth);
    return r;
}
EVIL_INLINE Ints load(const std::int32_t* from) {
    Ints r;
    for (int p = 0; p < native::kParts; ++p)
        r.part[p] = *reinterpret_cast<const native::AnyI*>(from + p * native::kWidth);
    return r;
}
EVIL_INLINE Ints load(const std::uint32_t* from) { return load(reinterpret_cast<const std::int32_t*>(from)); }
EVIL_INLINE void store(float* to, Floats a) {
    for (int p = 0; p < native::kParts; ++p) *reinterpret_cast<native::AnyF*>(to + p * native::kWidth) = a.part[p];
}
EVIL_INLINE void store(std::int32_t* to, Ints a) {
    for (int p = 0; p < native::kParts; ++p) *reinterpret_cast<native::AnyI*>(to + p * native::kWidth) = a.part[p];
}
EVIL_INLINE void store(std::uint32_t* to, Ints a) { store(reinterpret_cast<std::int32_t*>(to), a); }

EVIL_INLINE Ints lane_numbers() { // 0, 1, ... 7
    constexpr std::int32_t numbers[kLanes] = {0, 1, 2, 3, 4, 5, 6, 7};
    return load(numbers);
}
EVIL_INLINE Mask first_lanes(int count) { return lane_numbers() < Ints(count); }

// The first `count` lanes (0..8) of memory; the other lanes are zero, and memory beyond is neither read nor written.
// Whole registers are by far the most, and a store under a mask takes AMD's processors ten times as long as a plain one.
EVIL_INLINE Ints load_first(const std::int32_t* from, int count) {
#if EVIL_WIDTH == 8
    if (count == kLanes) return load(from);
    Ints r;
    r.part[0] = __builtin_bit_cast(
        native::I, _mm256_maskload_epi32(from, __builtin_bit_cast(__m256i, first_lanes(count).part[0])));
    return r;
#else
    std::int32_t lanes[kLanes] = {};
    for (int i = 0; i < count; ++i) lanes[i] = from[i];
    return load(lanes);
#endif
}
EVIL_INLINE void store_first(std::int32_t* to, int count, Ints a) {
#if EVIL_WIDTH == 8
    if (count == kLanes) return store(to, a);
    _mm256_maskstore_epi32(to, __builtin_bit_cast(__m256i, first_lanes(count).part[0]),
                           __builtin_bit_cast(__m256i, a.part[0]));
#else
    std::int32_t lanes[kLanes];
    store(lanes, a);
    for (int i = 0; i < count; ++i) to[i] = lanes[i];
#endif
}
EVIL_INLINE Ints load_first(const std::uint32_t* from, int count) {
    return load_first(reinterpret_cast<const std::int32_t*>(from), count);
}
EVIL_INLINE void store_first(std::uint32_t* to, int count, Ints a) {
    store_first(reinterpret_cast<std::int32_t*>(to), count, a);
}
EVIL_INLINE Floats load_first(const float* from, int count) {
#if EVIL_WIDTH == 8
    if (count == kLanes) return load(from);
    Floats r;
    r.part[0] = _mm256_maskload_ps(from, __builtin_bit_cast(__m256i, first_lanes(count).part[0]));
    return r;
#else
    float lanes[kLanes] = {};
    for (int i = 0; i < count; ++i) lanes[i] = from[i];
    return load(lanes);
#endif
}
EVIL_INLINE void store_first(float* to, int count, Floats a) {
#if EVIL_WIDTH == 8
    if (count == kLanes) return store(to, a);
    _mm256_maskstore_ps(to, __builtin_bit_cast(__m256i, first_lanes(count).part[0]), a.part[0]);
#else
    float lanes[kLanes];
    store(lanes, a);
    for (int i = 0; i < count; ++i) to[i] = lanes[i];
#endif
}

// Eight bytes as eight integers 0..255, and back (the low byte of each lane).
EVIL_INLINE Ints load_bytes(const std::uint8_t* from) {
#if EVIL_WIDTH == 8
    Ints r;
    r.part[0] =
        __builtin_bit_cast(native::I, _mm256_cvtepu8_epi32(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(from))));
    return r;
#else
    std::int32_t lanes[kLanes];
    for (int i = 0; i < kLanes; ++i) lanes[i] = from[i];
    return load(lanes);
#endif
}
EVIL_INLINE void store_bytes(std::uint8_t* to, Ints a) {
    std::int32_t lanes[kLanes];
    store(lanes, a);
    for (int i = 0; i < kLanes; ++i) to[i] = static_cast<std::uint8_t>(lanes[i]);
}

// table[index] in each lane. Every index must be inside the table, also in lanes whose result is not used.
EVIL_INLINE Floats gather(const float* table, Ints index) {
    std::int32_t at[kLanes];
    float lanes[kLanes];
    store(at, index);
    for (int i = 0; i < kLanes; ++i) lanes[i] = table[at[i]];
    return load(lanes);
}
EVIL_INLINE Ints gather(const std::uint32_t* table, Ints index) {
#if EVIL_WIDTH == 8
    Ints r;
    r.part[0] = __builtin_bit_cast(native::I, _mm256_i32gather_epi32(reinterpret_cast<const int*>(table),
                                                                     __builtin_bit_cast(__m256i, index.part[0]), 4));
    return r;
#else
    std::int32_t at[kLanes];
    std::uint32_t lanes[kLanes];
    store(at, index);
    for (int i = 0; i < kLanes; ++i) lanes[i] = table[at[i]];
    return load(lanes);
#endif
}

// ((0+4)+(2+6)) + ((1+5)+(3+7)): the order of halving registers, kept on every machine.
EVIL_INLINE float sum(Floats a) {
    float v[kLanes];
    store(v, a);
    return ((v[0] + v[4]) + (v[2] + v[6])) + ((v[1] + v[5]) + (v[3] + v[7]));
}

// The lower four lanes and the upper four change places.
EVIL_INLINE Floats swap_fours(Floats a) {
    Floats r;
#if EVIL_WIDTH == 8
    r.part[0] = _mm256_permute2f128_ps(a.part[0], a.part[0], 1);
#else
    for (int p = 0; p < native::kParts; ++p) r.part[p] = a.part[(p + native::kParts / 2) % native::kParts];
#endif
    return r;
}

// Two groups of four lanes, as columns of 4x4 matrices use them.
EVIL_INLINE Floats load_four_twice(const float* from) {
#if EVIL_WIDTH == 8
    Floats r;
    r.part[0] = _mm256_broadcast_ps(reinterpret_cast<const __m128*>(from));
    return r;
#else
    float lanes[kLanes];
    for (int i = 0; i < kLanes; ++i) lanes[i] = from[i & 3];
    return load(lanes);
#endif
}
// Lane k of each group of four in all of its four places.
template <int k> EVIL_INLINE Floats spread_in_four(Floats a) {
    Floats r;
#if EVIL_WIDTH == 8
    r.part[0] = __builtin_shufflevector(a.part[0], a.part[0], k, k, k, k, k + 4, k + 4, k + 4, k + 4);
#elif EVIL_WIDTH == 4
    for (int p = 0; p < 2; ++p) r.part[p] = __builtin_shufflevector(a.part[p], a.part[p], k, k, k, k);
#else
    for (int i = 0; i < kLanes; ++i) r.part[i] = a.part[(i & 4) + k];
#endif
    return r;
}

// x0 y0 x1 y1 ... x7 y7 in memory, as eight x and eight y; and back.
EVIL_INLINE void load_pairs(const float* from, Floats& x, Floats& y) {
#if EVIL_WIDTH == 8
    Floats a = load(from), b = load(from + kLanes);
    x.part[0] = __builtin_shufflevector(a.part[0], b.part[0], 0, 2, 4, 6, 8, 10, 12, 14);
    y.part[0] = __builtin_shufflevector(a.part[0], b.part[0], 1, 3, 5, 7, 9, 11, 13, 15);
#elif EVIL_WIDTH == 4
    Floats a = load(from), b = load(from + kLanes);
    x.part[0] = __builtin_shufflevector(a.part[0], a.part[1], 0, 2, 4, 6);
    y.part[0] = __builtin_shufflevector(a.part[0], a.part[1], 1, 3, 5, 7);
    x.part[1] = __builtin_shufflevector(b.part[0], b.part[1], 0, 2, 4, 6);
    y.part[1] = __builtin_shufflevector(b.part[0], b.part[1], 1, 3, 5, 7);
#else
    for (int i = 0; i < kLanes; ++i) {
        x.part[i] = from[2 * i];
        y.part[i] = from[2 * i + 1];
    }
#endif
}
EVIL_INLINE void store_pairs(float* to, Floats x, Floats y) {
    Floats a, b;
#if EVIL_WIDTH == 8
    a.part[0] = __builtin_shufflevector(x.part[0], y.part[0], 0, 8, 1, 9, 2, 10, 3, 11);
    b.part[0] = __builtin_shufflevector(x.part[0], y.part[0], 4, 12, 5, 13, 6, 14, 7, 15);
#elif EVIL_WIDTH == 4
    a.part[0] = __builtin_shufflevector(x.part[0], y.part[0], 0, 4, 1, 5);
    a.part[1] = __builtin_shufflevector(x.part[0], y.part[0], 2, 6, 3, 7);
    b.part[0] = __builtin_shufflevector(x.part[1], y.part[1], 0, 4, 1, 5);
    b.part[1] = __builtin_shufflevector(x.part[1], y.part[1], 2, 6, 3, 7);
#else
    for (int i = 0; i < kLanes; ++i) {
        (i < 4 ? a : b).part[2 * i % kLanes] = x.part[i];
        (i < 4 ? a : b).part[2 * i % kLanes + 1] = y.part[i];
    }
#endif
    store(to, a);
    store(to + kLanes, b);
}

} // namespace evil::EVIL_ISA
