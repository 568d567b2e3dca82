#pragma once
// 4x4 matrices (SPEC M2, M3): float32[16], column after column, as OpenGL keeps them. Vectors are columns: a * b applies b first.
//
//     | m[0] m[4] m[8]  m[12] |   a point (x, y) of the plane is the column (x, y, 0, 1);
//     | m[1] m[5] m[9]  m[13] |   an affine map of the plane leaves row 3 at (0, 0, 0, 1)
//     | m[2] m[6] m[10] m[14] |
//     | m[3] m[7] m[11] m[15] |
//
// Each element of a product is ((a0 b0 + a1 b1) + a2 b2) + a3 b3, one at a time and in batches alike: the same bits.
#include "math/cpu.hpp"
#include "math/transform.hpp"
#include <array>
#include <cstddef>
#include <optional>
#include <span>

namespace evil {

struct Vec4 {
    float x = 0.0f, y = 0.0f, z = 0.0f, w = 0.0f;
    friend constexpr bool operator==(Vec4, Vec4) = default;
};

struct Mat4 {
    std::array<float, 16> m{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    friend constexpr bool operator==(const Mat4&, const Mat4&) = default;
};

constexpr Vec4 operator*(const Mat4& a, Vec4 v) {
    const auto& m = a.m;
    return {m[0] * v.x + m[4] * v.y + m[8] * v.z + m[12] * v.w, m[1] * v.x + m[5] * v.y + m[9] * v.z + m[13] * v.w,
            m[2] * v.x + m[6] * v.y + m[10] * v.z + m[14] * v.w, m[3] * v.x + m[7] * v.y + m[11] * v.z + m[15] * v.w};
}
constexpr Mat4 operator*(const Mat4& a, const Mat4& b) {
    Mat4 r;
    for (std::size_t column = 0; column < 16; column += 4)
        for (std::size_t row = 0; row < 4; ++row)
            r.m[column + row] = a.m[row] * b.m[column] + a.m[row + 4] * b.m[column + 1] +
                                a.m[row + 8] * b.m[column + 2] + a.m[row + 12] * b.m[column + 3];
    return r;
}
constexpr Mat4 transpose(const Mat4& a) {
    Mat4 r;
    for (std::size_t i = 0; i < 16; ++i) r.m[i] = a.m[i % 4 * 4 + i / 4];
    return r;
}

constexpr Mat4 mat4(const Affine& t) { return {{t.a, t.b, 0, 0, t.c, t.d, 0, 0, 0, 0, 1, 0, t.tx, t.ty, 0, 1}}; }
constexpr Affine affine(const Mat4& a) {
    return {a.m[0], a.m[1], a.m[4], a.m[5], a.m[12], a.m[13]};
} // its share of the plane
constexpr Mat4 scaling(float x, float y) { return mat4(Affine{x, 0, 0, y, 0, 0}); }
constexpr Mat4 translation(float x, float y) { return mat4(Affine{1, 0, 0, 1, x, y}); }
inline Mat4 rotation4(float angle) { return mat4(affine(Pose{{}, rotation(angle)})); }

// The matrix that undoes `a`, computed in double; none if there is none within the range of floats.
std::optional<Mat4> inverse(const Mat4& a) noexcept;

bool all_finite(std::span<const float> numbers, InstructionSet set = best_instruction_set()) noexcept;

// Batches. `out` is as long as the input and does not overlap it; two spans of matrices are equally long, or one holds one.
void transform_points(const Mat4& a, std::span<const Vec2> points, std::span<Vec2> out,
                      InstructionSet set = best_instruction_set()) noexcept;
void transform_vectors(const Mat4& a, std::span<const Vec4> vectors, std::span<Vec4> out,
                       InstructionSet set = best_instruction_set()) noexcept;
void multiply(std::span<const Mat4> a, std::span<const Mat4> b, std::span<Mat4> out,
              InstructionSet set = best_instruction_set()) noexcept;

// One matrix for each point or vector. Reading the matrices is what takes the time, so there is nothing to widen.
void transform_each(std::span<const Mat4> a, std::span<const Vec2> points, std::span<Vec2> out) noexcept;
void transform_each(std::span<const Mat4> a, std::span<const Vec4> vectors, std::span<Vec4> out) noexcept;

} // namespace evil
