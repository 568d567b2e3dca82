#pragma once
// Tables of 32-byte rows, read and written eight rows at a time: each field of the rows becomes eight lanes.
#include "math/wide.hpp"

namespace evil::EVIL_ISA {

#if EVIL_WIDTH == 8
EVIL_INLINE void transpose(__m256 r[8], Floats field[8]) {
    __m256 t[8];
    for (int i = 0; i < 8; i += 2) {
        t[i] = _mm256_unpacklo_ps(r[i], r[i + 1]);
        t[i + 1] = _mm256_unpackhi_ps(r[i], r[i + 1]);
    }
    for (int i = 0; i < 8; i += 4) {
        r[i] = _mm256_shuffle_ps(t[i], t[i + 2], 0x44);
        r[i + 1] = _mm256_shuffle_ps(t[i], t[i + 2], 0xee);
        r[i + 2] = _mm256_shuffle_ps(t[i + 1], t[i + 3], 0x44);
        r[i + 3] = _mm256_shuffle_ps(t[i + 1], t[i + 3], 0xee);
    }
    for (int i = 0; i < 4; ++i) {
        field[i].part[0] = _mm256_permute2f128_ps(r[i], r[i + 4], 0x20);
        field[i + 4].part[0] = _mm256_permute2f128_ps(r[i], r[i + 4], 0x31);
    }
}

// Back: row i in the lower half of r[i], row i + 4 in the upper one.
EVIL_INLINE void interleave(const Floats field[4], __m256 r[4]) {
    __m256 t0 = _mm256_unpacklo_ps(field[0].part[0], field[1].part[0]);
    __m256 t1 = _mm256_unpackhi_ps(field[0].part[0], field[1].part[0]);
    __m256 t2 = _mm256_unpacklo_ps(field[2].part[0], field[3].part[0]);
    __m256 t3 = _mm256_unpackhi_ps(field[2].part[0], field[3].part[0]);
    r[0] = _mm256_shuffle_ps(t0, t2, 0x44);
    r[1] = _mm256_shuffle_ps(t0, t2, 0xee);
    r[2] = _mm256_shuffle_ps(t1, t3, 0x44);
    r[3] = _mm256_shuffle_ps(t1, t3, 0xee);
}
#endif

// Rows of eight floats, 32 bytes each and aligned to that: row numbers[i] of the table becomes lane i of field[0..7]. Where
// rows begin may be told instead, in floats: then `each` is 1.
template <std::size_t each = 8>
EVIL_INLINE void load_rows(const float* table, const std::uint32_t* numbers, Floats field[8]) {
#if EVIL_WIDTH == 8
    __m256 r[8];
    for (int i = 0; i < 8; ++i) r[i] = _mm256_load_ps(table + each * numbers[i]);
    transpose(r, field);
#else
    float lanes[8][kLanes];
    for (int i = 0; i < kLanes; ++i)
        for (int k = 0; k < 8; ++k) lanes[k][i] = table[each * numbers[i] + static_cast<std::size_t>(k)];
    for (int k = 0; k < 8; ++k) field[k] = load(lanes[k]);
#endif
}

// Eight objects, and floats that lie so many bytes into each of them; they need no alignment.
template <class T> EVIL_INLINE const float* floats_in(const T* object, std::size_t at) {
    return reinterpret_cast<const float*>(reinterpret_cast<const char*>(object) + at);
}
template <class T> EVIL_INLINE float* floats_in(T* object, std::size_t at) {
    return reinterpret_cast<float*>(reinterpret_cast<char*>(object) + at);
}

// Eight floats of objects[i] become lane i of field[0..7].
template <class T> EVIL_INLINE void load_rows_at(const T* const* objects, std::size_t at, Floats field[8]) {
#if EVIL_WIDTH == 8
    __m256 r[8];
    for (int i = 0; i < 8; ++i) r[i] = _mm256_loadu_ps(floats_in(objects[i], at));
    transpose(r, field);
#else
    float lanes[8][kLanes];
    for (int i = 0; i < kLanes; ++i)
        for (int k = 0; k < 8; ++k) lanes[k][i] = floats_in(objects[i], at)[k];
    for (int k = 0; k < 8; ++k) field[k] = load(lanes[k]);
#endif
}

// Lane i of field[0..3] into four floats of objects[i].
template <class T> EVIL_INLINE void store_half_rows_at(T* const* objects, std::size_t at, const Floats field[4]) {
#if EVIL_WIDTH == 8
    __m256 r[4];
    interleave(field, r);
    for (int i = 0; i < 4; ++i) {
        _mm_storeu_ps(floats_in(objects[i], at), _mm256_castps256_ps128(r[i]));
        _mm_storeu_ps(floats_in(objects[i + 4], at), _mm256_extractf128_ps(r[i], 1));
    }
#else
    float lanes[4][kLanes];
    for (int k = 0; k < 4; ++k) store(lanes[k], field[k]);
    for (int i = 0; i < kLanes; ++i)
        for (int k = 0; k < 4; ++k) floats_in(objects[i], at)[k] = lanes[k][i];
#endif
}

// Lane i of field[0..7] into eight floats of objects[i].
template <class T> EVIL_INLINE void store_rows_at(T* const* objects, std::size_t at, const Floats field[8]) {
    store_half_rows_at(objects, at, field);
    store_half_rows_at(objects, at + 16, field + 4);
}

// Lane i of field[0..3] into the first four floats of row numbers[i]. Rows that come twice take the later lane.
template <std::size_t each = 8>
EVIL_INLINE void store_half_rows(float* table, const std::uint32_t* numbers, const Floats field[4]) {
#if EVIL_WIDTH == 8
    __m256 r[4];
    interleave(field, r);
    for (int i = 0; i < 4; ++i) _mm_store_ps(table + each * numbers[i], _mm256_castps256_ps128(r[i]));
    for (int i = 0; i < 4; ++i) _mm_store_ps(table + each * numbers[i + 4], _mm256_extractf128_ps(r[i], 1));
#else
    float lanes[4][kLanes];
    for (int k = 0; k < 4; ++k) store(lanes[k], field[k]);
    for (int i = 0; i < kLanes; ++i)
        for (int k = 0; k < 4; ++k) table[each * numbers[i] + static_cast<std::size_t>(k)] = lanes[k][i];
#endif
}

// Lane i of field[0..7] into row i * stride of the table, which is aligned to 32 bytes.
EVIL_INLINE void store_rows(float* table, std::size_t stride, const Floats field[8]) {
#if EVIL_WIDTH == 8
    __m256 t[8], r[8];
    for (int i = 0; i < 8; i += 2) {
        t[i] = _mm256_unpacklo_ps(field[i].part[0], field[i + 1].part[0]);
        t[i + 1] = _mm256_unpackhi_ps(field[i].part[0], field[i + 1].part[0]);
    }
    for (int i = 0; i < 8; i += 4) {
        r[i] = _mm256_shuffle_ps(t[i], t[i + 2], 0x44);
        r[i + 1] = _mm256_shuffle_ps(t[i], t[i + 2], 0xee);
        r[i + 2] = _mm256_shuffle_ps(t[i + 1], t[i + 3], 0x44);
        r[i + 3] = _mm256_shuffle_ps(t[i + 1], t[i + 3], 0xee);
    }
    for (std::size_t i = 0; i < 4; ++i) {
        _mm256_store_ps(table + 8 * stride * i, _mm256_permute2f128_ps(r[i], r[i + 4], 0x20));
        _mm256_store_ps(table + 8 * stride * (i + 4), _mm256_permute2f128_ps(r[i], r[i + 4], 0x31));
    }
#else
    float lanes[8][kLanes];
    for (int k = 0; k < 8; ++k) store(lanes[k], field[k]);
    for (std::size_t i = 0; i < kLanes; ++i)
        for (std::size_t k = 0; k < 8; ++k) table[8 * stride * i + k] = lanes[k][i];
#endif
}

} // namespace evil::EVIL_ISA
