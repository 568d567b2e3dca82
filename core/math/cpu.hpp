#pragma once
// Which instruction set the wide kernels run with.
//
// A file X_wide.cpp is compiled once for each set of the build, with EVIL_ISA naming it (sse2, avx2, ...); its functions live
// in namespace evil::EVIL_ISA, so that the copies do not meet. A header declares all copies at once, and a plain .cpp picks:
//
//     // fill.hpp
//     void fill(std::span<float> row, float value, InstructionSet set = best_instruction_set()) noexcept;
//     // fill_wide.hpp
//     EVIL_WIDE(void fill(float* row, std::size_t count, float value) noexcept;)
//     // fill_wide.cpp
//     namespace evil::EVIL_ISA { void fill(float* row, std::size_t count, float value) noexcept { ... math/wide.hpp ... } }
//     // fill.cpp
//     void fill(std::span<float> row, float value, InstructionSet set) noexcept {
//         EVIL_PICK(set, fill)(row.data(), row.size(), value);
//     }
//
// Every set gives the same bits: tests run the same work on each of runnable_instruction_sets() and compare.
#include <span>

namespace evil {

enum class InstructionSet { plain, base, sse2, avx2 };

const char* name(InstructionSet set) noexcept;

// What this build holds and this machine can run, slowest first. `plain`, one float at a time, is the yardstick.
std::span<const InstructionSet> runnable_instruction_sets() noexcept;
InstructionSet best_instruction_set() noexcept;

} // namespace evil

// The build defines EVIL_ISA for wide files and EVIL_HAS_... for the core's other files (CMakeLists.txt).
// clang-format off
#if defined(EVIL_ISA)
#define EVIL_WIDE(...) namespace EVIL_ISA { __VA_ARGS__ }
#elif defined(EVIL_HAS_AVX2)
#define EVIL_WIDE(...) namespace plain { __VA_ARGS__ } namespace sse2 { __VA_ARGS__ } namespace avx2 { __VA_ARGS__ }
#define EVIL_PICK(set, function)                                     \
    ((set) == ::evil::InstructionSet::avx2   ? &avx2::function       \
     : (set) == ::evil::InstructionSet::sse2 ? &sse2::function       \
                                             : &plain::function)
#else
#define EVIL_WIDE(...) namespace base { __VA_ARGS__ }
#define EVIL_PICK(set, function) (static_cast<void>(set), &base::function)
#endif
// clang-format on
