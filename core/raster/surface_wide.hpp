#pragma once
// What light becomes on surfaces that are not flat, or shine themselves; spans.hpp says what these do.
#include "math/cpu.hpp"
#include "raster/spans.hpp"

namespace evil {

// clang-format off
EVIL_WIDE(
void bend_wide(std::uint32_t* to, const std::uint32_t* factors, const raster::Ways& ways, const raster::Pixel* normals,
               int count, const raster::Turn& turn) noexcept;
void shine_wide(raster::Pixel* row, const raster::Pixel* glow, int count, float strength) noexcept;
void spread_light_wide(std::uint32_t* to, int count, const std::int32_t* const channels[3],
                       const raster::Columns& columns) noexcept;)
// clang-format on

} // namespace evil
