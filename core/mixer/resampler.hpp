#pragma once
// Band-limited interpolation (Smith and Gossett 1984): each mixed frame is a weighted sum of the source frames round its
// place. The weights are a sinc under a Kaiser window, tabulated for a power of two of places between two frames and
// blended between those. A sound played faster than the mix gets a wider, lower sinc, which removes what would alias.
//
//     source   o   o   o   o   o   o   o        16 zero crossings of the sinc on each side
//                        |
//     mixed frame        x   = sum of o times weight(o - x)
#include "math/cpu.hpp"
#include "mixer/sound.hpp"
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace evil::mixer {

// The weights for speeds up to 2^(number/4).
struct Kernel {
    int taps = 0;       // a multiple of 8
    int phase_bits = 0; // 2^phase_bits places between two frames, and one row more for the blend
    std::vector<float> rows;
    int before() const { return taps / 2 - 1; } // taps before the frame that the place is at or after
};

inline constexpr int kKernels = 13;

// The kernel that a speed needs, in source frames a mixed frame (32.32 fixed point, at most kHighestSpeed).
int kernel_for(std::int64_t speed) noexcept;
Kernel make_kernel(int number);

// Kernels made so far. Made by the thread that commands, before it sends a command that needs one; read by the mixer.
using Kernels = std::array<std::unique_ptr<const Kernel>, kKernels>;

// Mixed frames from `places` in the source (whole part: index of the first tap; fraction: of 2^32).
void resample(const Kernel& kernel, const float* source, const std::int32_t* first_tap, const std::uint32_t* fraction,
              int count, float* out, InstructionSet set) noexcept;

} // namespace evil::mixer
