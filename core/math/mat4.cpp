#include "math/mat4.hpp"
#include "math/mat4_wide.hpp"
#include <cassert>
#include <cmath>

namespace evil {

static_assert(sizeof(Mat4) == 64 && sizeof(Vec4) == 16 && sizeof(Vec2) == 8);

// Laplace's expansion along pairs of columns: six 2x2 determinants of the left two, six of the right two.
std::optional<Mat4> inverse(const Mat4& a) noexcept {
    double m[16];
    for (std::size_t i = 0; i < 16; ++i) m[i] = a.m[i];
    auto left = [&](int r, int s) { return m[r] * m[4 + s] - m[s] * m[4 + r]; };
    auto right = [&](int r, int s) { return m[8 + r] * m[12 + s] - m[8 + s] * m[12 + r]; };
    double l01 = left(0, 1), l02 = left(0, 2), l03 = left(0, 3), l12 = left(1, 2), l13 = left(1, 3), l23 = left(2, 3);
    double r01 = right(0, 1), r02 = right(0, 2), r03 = right(0, 3), r12 = right(1, 2), r13 = right(1, 3),
           r23 = right(2, 3);
    double determinant = l01 * r23 - l02 * r13 + l03 * r12 + l12 * r03 - l13 * r02 + l23 * r01;
    const double adjugate[16] = {m[5] * r23 - m[6] * r13 + m[7] * r12,     -m[1] * r23 + m[2] * r13 - m[3] * r12,
                                 m[13] * l23 - m[14] * l13 + m[15] * l12,  -m[9] * l23 + m[10] * l13 - m[11] * l12,
                                 -m[4] * r23 + m[6] * r03 - m[7] * r02,    m[0] * r23 - m[2] * r03 + m[3] * r02,
                                 -m[12] * l23 + m[14] * l03 - m[15] * l02, m[8] * l23 - m[10] * l03 + m[11] * l02,
                                 m[4] * r13 - m[5] * r03 + m[7] * r01,     -m[0] * r13 + m[1] * r03 - m[3] * r01,
                                 m[12] * l13 - m[13] * l03 + m[15] * l01,  -m[8] * l13 + m[9] * l03 - m[11] * l01,
                                 -m[4] * r12 + m[5] * r02 - m[6] * r01,    m[0] * r12 - m[1] * r02 + m[2] * r01,
                                 -m[12] * l12 + m[13] * l02 - m[14] * l01, m[8] * l12 - m[9] * l02 + m[10] * l01};
    Mat4 r;
    for (std::size_t i = 0; i < 16; ++i) {
        r.m[i] = static_cast<float>(adjugate[i] / determinant + 0.0); // + 0 turns -0 into 0
        if (!std::isfinite(r.m[i])) return std::nullopt;
    }
    return r;
}

bool all_finite(std::span<const float> numbers, InstructionSet set) noexcept {
    return numbers.empty() || EVIL_PICK(set, all_finite)(numbers.data(), numbers.size());
}

void transform_points(const Mat4& a, std::span<const Vec2> points, std::span<Vec2> out, InstructionSet set) noexcept {
    assert(points.size() == out.size());
    if (points.empty()) return;
    EVIL_PICK(set, transform_points)(a.m.data(), &points.data()->x, &out.data()->x, points.size());
}

void transform_vectors(const Mat4& a, std::span<const Vec4> vectors, std::span<Vec4> out, InstructionSet set) noexcept {
    assert(vectors.size() == out.size());
    if (vectors.empty()) return;
    EVIL_PICK(set, transform_vectors)(a.m.data(), &vectors.data()->x, &out.data()->x, vectors.size());
}

void multiply(std::span<const Mat4> a, std::span<const Mat4> b, std::span<Mat4> out, InstructionSet set) noexcept {
    assert((a.size() == out.size() || a.size() == 1) && (b.size() == out.size() || b.size() == 1));
    if (out.empty()) return;
    EVIL_PICK(set, multiply)
    (a.data()->m.data(), a.size() == 1 ? 0 : 16, b.data()->m.data(), b.size() == 1 ? 0 : 16, out.data()->m.data(),
     out.size());
}

void transform_each(std::span<const Mat4> a, std::span<const Vec2> points, std::span<Vec2> out) noexcept {
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = apply(affine(a[i]), points[i]);
}

void transform_each(std::span<const Mat4> a, std::span<const Vec4> vectors, std::span<Vec4> out) noexcept {
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = a[i] * vectors[i];
}

} // namespace evil
