#include "raster/liquid.hpp"
#include "raster/liquid_wide.hpp"
#include <algorithm>
#include <cmath>

namespace evil::raster {
namespace {

using draw::LiquidMap;

struct Cubic { // uniform B-spline
    float part[4];
};
Cubic cubic(float t) {
    const float u = 1.0f - t, tt = t * t, ttt = tt * t;
    return {u * u * u / 6.0f, (3.0f * ttt - 6.0f * tt + 4.0f) / 6.0f, (3.0f * (t + tt - ttt) + 1.0f) / 6.0f,
            ttt / 6.0f};
}

struct Place { // between two texels
    int first;
    float part;
};
Place place_of(int pixel, float first, float step) {
    const float at = (static_cast<float>(pixel) + 0.5f - first) / step, low = std::floor(at);
    return {static_cast<int>(low), at - low};
}

struct Span { // of pixels between a map's second texel and its last but one, where cubics have all that they need
    int from, to;
};
Span span_of(float first, float step, int texels, int pixels) {
    const float low = first + step - 0.5f, high = first + step * static_cast<float>(texels - 2) - 0.5f;
    return {static_cast<int>(std::ceil(std::clamp(low, 0.0f, static_cast<float>(pixels)))),
            static_cast<int>(std::ceil(std::clamp(high, 0.0f, static_cast<float>(pixels))))};
}

void find_columns(const LiquidMap& map, Span span, LiquidScratch& scratch) {
    const std::size_t count = static_cast<std::size_t>(span.to - span.from), room = count + 8;
    scratch.column.assign(room, 1);
    scratch.part.assign(room, 0.0f);
    scratch.cubic.assign(4 * room, 0.0f);
    for (std::size_t i = 0; i < count; ++i) {
        const Place place = place_of(span.from + static_cast<int>(i), map.first.x, map.step);
        const Cubic weights = cubic(place.part);
        scratch.column[i] = place.first, scratch.part[i] = place.part;
        for (std::size_t k = 0; k < 4; ++k) scratch.cubic[k * room + i] = weights.part[k];
    }
    std::fill(scratch.column.begin() + static_cast<std::ptrdiff_t>(count), scratch.column.end(),
              scratch.column[count - 1]);
}

void mix_rows(const LiquidMap& map, const Place& place, std::size_t stride, float* texels, Set set) {
    const Cubic weights = cubic(place.part);
    for (std::size_t plane = 0; plane < draw::kLiquidPlanes; ++plane) {
        const float* row = map.planes[plane].data() + static_cast<std::size_t>(place.first) * stride;
        float* to = texels + plane * stride;
        if (plane == draw::kDepth)
            EVIL_PICK(set, mix_four_wide)(row - stride, stride, weights.part, to, map.width);
        else
            EVIL_PICK(set, mix_two_wide)(row, stride, place.part, to, map.width);
    }
}

} // namespace

void draw_liquid(const LiquidMap& map, const Target& target, LightRows* light, LiquidScratch& scratch,
                 const Bands& bands, Set set) {
    const Span across = span_of(map.first.x, map.step, map.width, target.width);
    const Span down = span_of(map.first.y, map.step, map.height, target.height);
    if (across.from >= across.to || down.from >= down.to) return;
    const std::size_t stride = static_cast<std::size_t>(map.stride);
    const std::size_t width = static_cast<std::size_t>(target.width);
    find_columns(map, across, scratch);
    if (scratch.texels.size() < static_cast<std::size_t>(bands.most)) scratch.texels.resize(bands.most);
    for (std::vector<float>& texels : scratch.texels) texels.resize(stride * draw::kLiquidPlanes + 8);
    scratch.behind.resize(width * static_cast<std::size_t>(target.height));

    const std::size_t room = scratch.column.size();
    LiquidRow all{};
    for (std::size_t k = 0; k < 4; ++k) all.cubic[k] = scratch.cubic.data() + k * room;
    all.column = scratch.column.data(), all.part = scratch.part.data();
    all.behind = scratch.behind.data(), all.width = target.width;
    all.top = std::max(down.from - map.reach, 0), all.bottom = std::min(down.to + map.reach, target.height);
    all.rim = 1.0f / map.rim_width;
    each_band(bands, target.width, all.bottom - all.top, [&](const Rows& rows, std::size_t) {
        for (int y = all.top + rows.first; y < all.top + rows.last; ++y)
            std::copy_n(row_of(target, y), width, &scratch.behind[width * y]);
    });
    each_band(bands, target.width, down.to - down.from, [&](const Rows& rows, std::size_t band) {
        LiquidRow row = all;
        float* texels = scratch.texels[band].data();
        for (std::size_t k = 0; k < draw::kLiquidPlanes; ++k) row.planes[k] = texels + k * stride;
        for (row.y = down.from + rows.first; row.y < down.from + rows.last; ++row.y) {
            mix_rows(map, place_of(row.y, map.first.y, map.step), stride, texels, set);
            row.light = light && map.lit ? row_of(*light, light->light, row.y, band, set) + across.from : nullptr;
            Pixel* to = row_of(target, row.y) + across.from;
            EVIL_PICK(set, liquid_row_wide)(to, across.from, across.to - across.from, row);
        }
    });
}

} // namespace evil::raster
