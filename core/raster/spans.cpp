#include "raster/spans.hpp"
#include "raster/spans_wide.hpp"
#include "raster/surface_wide.hpp"

namespace evil::raster {

void fill(Set set, Pixel* to, int count, Pixel colour) noexcept { EVIL_PICK(set, fill_wide)(to, count, colour); }

void blend_flat(Set set, Pixel* to, int count, Pixel colour) noexcept {
    EVIL_PICK(set, blend_flat_wide)(to, count, colour);
}

void blend_flat(Set set, Pixel* to, const std::int32_t* mask, int count, Pixel colour) noexcept {
    EVIL_PICK(set, blend_flat_masked_wide)(to, mask, count, colour);
}

void blend_row(Set set, Pixel* to, const Pixel* from, int count, int cover) noexcept {
    EVIL_PICK(set, blend_row_wide)(to, from, count, cover);
}

void blend_row(Set set, Pixel* to, const Pixel* from, const std::int32_t* mask, int count) noexcept {
    EVIL_PICK(set, blend_row_masked_wide)(to, from, mask, count);
}

void add_row(Set set, Pixel* to, const Pixel* from, const std::int32_t* mask, int count) noexcept {
    EVIL_PICK(set, add_row_wide)(to, from, mask, count);
}

void multiply_row(Set set, Pixel* to, const Pixel* from, const std::int32_t* mask, int count) noexcept {
    EVIL_PICK(set, multiply_row_wide)(to, from, mask, count);
}

void screen_row(Set set, Pixel* to, const Pixel* from, const std::int32_t* mask, int count) noexcept {
    EVIL_PICK(set, screen_row_wide)(to, from, mask, count);
}

std::int32_t integrate(Set set, std::int32_t* cells, int count, std::int32_t sum, std::int32_t* mask) noexcept {
    return EVIL_PICK(set, integrate_wide)(cells, count, sum, mask);
}

void ramp(Set set, Pixel* to, int count, const Ramp& colours) noexcept {
    EVIL_PICK(set, ramp_wide)(to, count, colours);
}

void sample(Set set, Pixel* to, int count, const Walk& walk) noexcept { EVIL_PICK(set, sample_wide)(to, count, walk); }

void modulate(Set set, Pixel* row, const Pixel* by, int count) noexcept {
    EVIL_PICK(set, modulate_wide)(row, by, count);
}

void modulate_flat(Set set, Pixel* row, int count, Pixel by) noexcept {
    EVIL_PICK(set, modulate_flat_wide)(row, count, by);
}

void light_up(Set set, Pixel* row, const std::uint32_t* factors, int count, const std::int32_t* dither) noexcept {
    EVIL_PICK(set, light_up_wide)(row, factors, count, dither);
}

void spread_light(Set set, std::uint32_t* to, int count, const std::int32_t* const channels[3],
                  const Columns& columns) noexcept {
    EVIL_PICK(set, spread_light_wide)(to, count, channels, columns);
}

void bend(Set set, std::uint32_t* to, const std::uint32_t* factors, const Ways& ways, const Pixel* normals, int count,
          const Turn& turn) noexcept {
    EVIL_PICK(set, bend_wide)(to, factors, ways, normals, count, turn);
}

void shine(Set set, Pixel* row, const Pixel* glow, int count, float strength) noexcept {
    EVIL_PICK(set, shine_wide)(row, glow, count, strength);
}

} // namespace evil::raster
