#pragma once
#include "light/shade.hpp"
#include "math/cpu.hpp"

namespace evil {

// clang-format off
EVIL_WIDE(
// Seen from the rim of a square. Where a caster hides nothing, it begins behind its end.
void outline_casters_wide(const light::Lamp& lamp, const light::Caster* casters, const std::uint32_t* which, int count,
                          const Vec2* corners, const light::Square& square, light::Outline* outlines) noexcept;
// Adds one lamp's light to a patch; `casters` are those that may hide some of it there, `hidden` has room for each.
void shade_patch_wide(const light::Lamp& lamp, const light::Caster* casters, const std::uint32_t* which, int count,
                      const Vec2* corners, const light::Patch& patch, const light::Planes& planes,
                      light::Hidden* hidden) noexcept;
// Of three planes, from `at` on. Linear light to the power of kToScreen, as packed factors; and sums of ways over light.
void pack_factors_wide(const float* const light[3], int at, int count, std::uint64_t* to) noexcept;
void pack_ways_wide(const float* const light[3], const float* const ways[3], int at, int count,
                    std::uint64_t* to) noexcept;)
// clang-format on

} // namespace evil
