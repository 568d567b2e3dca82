#pragma once
#include "math/cpu.hpp"
#include <cstddef>

// Kernels behind math/mat4.hpp; matrices, points and vectors as plain floats. Strides count floats: 0 repeats one matrix.
namespace evil {
EVIL_WIDE(bool all_finite(const float* numbers, std::size_t count) noexcept;
          void transform_points(const float* matrix, const float* points, float* out, std::size_t count) noexcept;
          void transform_vectors(const float* matrix, const float* vectors, float* out, std::size_t count) noexcept;
          void multiply(const float* a, std::size_t a_stride, const float* b, std::size_t b_stride, float* out,
                        std::size_t count) noexcept;)
} // namespace evil
