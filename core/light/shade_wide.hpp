#pragma once
#include "light/shade.hpp"
#include "math/cpu.hpp"

namespace evil {

// clang-format off
EVIL_WIDE(
// Keeps those of `count` casters that come near a strip, in their order; returns how many.
int keep_near_wide(const light::Strip& strip, const light::Caster* casters, std::uint32_t* which, int count) noexcept;
// Seen from the rim of a square. Where a caster hides nothing, it begins behind its end.
void outline_casters_wide(const light::Lamp& lamp, const light::Caster* casters, const std::uint32_t* which, int count,
                          const Vec2* corners, const light::Square& square, light::Outline* outlines) noexcept;
// Writes one lamp's shares of a patch; `near` are those casters that may hide some of it there.
void shade_patch_wide(const light::Lamp& lamp, const light::Near& near, const light::Patch& patch,
                      const light::Shares& shares) noexcept;
// The same where the shares are known but for the first `moving` casters: rows in which those hide nothing stay as they are.
void shade_kept_wide(const light::Lamp& lamp, const light::Near& near, int moving, const light::Patch& patch,
                     const light::Shares& kept, const light::Shares& shares) noexcept;
// Whether all shares of a patch are known.
bool knows_patch_wide(const light::Patch& patch, const light::Shares& shares) noexcept;
// Adds the light of a lamp whose shares are known.
void light_patch_wide(const light::Lamp& lamp, const light::Patch& patch, const light::Shares& shares,
                      const light::Planes& planes) noexcept;
// Of three planes, from `at` on. Linear light to the power of kToScreen, as packed factors; and sums of ways over light.
void pack_factors_wide(const float* const light[3], int at, int count, std::uint64_t* to) noexcept;
void pack_ways_wide(const float* const light[3], const float* const ways[3], int at, int count,
                    std::uint64_t* to) noexcept;)
// clang-format on

} // namespace evil
