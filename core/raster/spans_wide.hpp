#pragma once
// One copy of each inner loop for each instruction set; spans.hpp says what they do.
#include "math/cpu.hpp"
#include "raster/spans.hpp"
#include "raster/specks.hpp"

namespace evil {

// clang-format off
EVIL_WIDE(
void fill_wide(raster::Pixel* to, int count, raster::Pixel colour) noexcept;
void blend_flat_wide(raster::Pixel* to, int count, raster::Pixel colour) noexcept;
void blend_flat_masked_wide(raster::Pixel* to, const std::int32_t* mask, int count, raster::Pixel colour) noexcept;
void blend_row_wide(raster::Pixel* to, const raster::Pixel* from, int count, int cover) noexcept;
void blend_row_masked_wide(raster::Pixel* to, const raster::Pixel* from, const std::int32_t* mask, int count) noexcept;
void add_row_wide(raster::Pixel* to, const raster::Pixel* from, const std::int32_t* mask, int count) noexcept;
void multiply_row_wide(raster::Pixel* to, const raster::Pixel* from, const std::int32_t* mask, int count) noexcept;
void screen_row_wide(raster::Pixel* to, const raster::Pixel* from, const std::int32_t* mask, int count) noexcept;
std::int32_t integrate_wide(std::int32_t* cells, int count, std::int32_t sum, std::int32_t* mask) noexcept;
void ramp_wide(raster::Pixel* to, int count, const raster::Ramp& colours) noexcept;
void sample_wide(raster::Pixel* to, int count, const raster::Walk& walk) noexcept;
void modulate_wide(raster::Pixel* row, const raster::Pixel* by, int count) noexcept;
void modulate_flat_wide(raster::Pixel* row, int count, raster::Pixel by) noexcept;
void speck_wide(const raster::Target& target, const raster::SpeckPaint& paint) noexcept;
void light_up_wide(raster::Pixel* row, const std::uint32_t* factors, int count, const std::int32_t* dither) noexcept;)
// clang-format on

} // namespace evil
