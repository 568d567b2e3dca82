#include "raster/lit.hpp"
#include <algorithm>
#include <array>
#include <cmath>

namespace evil::raster {
namespace {

using light::Factors;

// Which order the pixels of an 8x8 square are rounded up in: neighbours as differently as can be (Bayer 1973).
constexpr int rank_of(int x, int y) {
    int rank = 0;
    for (int bit = 0; bit < 3; ++bit) {
        const int across = x >> bit & 1, down = y >> bit & 1;
        rank |= ((across ^ down) << 1 | down) << (2 * (2 - bit));
    }
    return rank;
}

constexpr auto kDither = [] {
    std::array<std::array<std::int32_t, 16>, 8> rows{};
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 16; ++x) rows[y][x] = rank_of(x & 7, y) * 8 + 4;
    return rows;
}();

LightRows::Place place_of(int pixel, float first, float step, int count) {
    const float at = std::clamp((static_cast<float>(pixel) + 0.5f - first) / step, 0.0f, static_cast<float>(count - 1));
    const int texel = std::min(static_cast<int>(at), std::max(count - 2, 0));
    return {texel, std::min(texel + 1, count - 1), static_cast<Factors>((at - static_cast<float>(texel)) * 256.0f)};
}

Factors mix(Factors a, Factors b, Factors weight) {
    return (a * (256 - weight) + b * weight) >> 8 & light::kAllFactors;
}

std::uint32_t to_ten_bits(Factors f) {
    const auto channel = [f](int place) {
        return static_cast<std::uint32_t>(f >> place * light::kFactorApart & light::kFactorMask) >>
               (light::kFactorBits - 10);
    };
    return channel(2) | channel(1) << 10 | channel(0) << 20;
}

} // namespace

void begin(LightRows& rows, const light::LightMap& map, const Target& target) {
    rows.map = &map;
    if (!map.on) return;
    rows.width = target.width;
    rows.stride = target.width + 8; // read in eights
    rows.between.resize(map.width);
    rows.columns.resize(target.width);
    for (int x = 0; x < target.width; ++x) rows.columns[x] = place_of(x, map.first.x, map.step, map.width);
    const auto use = [&](LightRows::Plane& plane, const std::vector<Factors>& texels) {
        plane.texels = &texels;
        plane.factors.resize(static_cast<std::size_t>(rows.stride) * target.height);
        plane.ready.assign(target.height, false);
    };
    use(rows.light, map.texels);
    if (map.directed) use(rows.across, map.across), use(rows.down, map.down);
}

const std::uint32_t* row_of(LightRows& rows, LightRows::Plane& plane, int y) {
    std::uint32_t* row = plane.factors.data() + static_cast<std::size_t>(rows.stride) * y;
    if (plane.ready[y]) return row;
    plane.ready[y] = true;
    const light::LightMap& map = *rows.map;
    const LightRows::Place down = place_of(y, map.first.y, map.step, map.height);
    const Factors* above = plane.texels->data() + static_cast<std::size_t>(down.texel) * map.width;
    const Factors* below = plane.texels->data() + static_cast<std::size_t>(down.next) * map.width;
    for (int x = 0; x < map.width; ++x) rows.between[x] = mix(above[x], below[x], down.weight);
    const Factors* between = rows.between.data();
    for (int x = 0; x < rows.width; ++x) {
        const LightRows::Place& across = rows.columns[x];
        row[x] = to_ten_bits(mix(between[across.texel], between[across.next], across.weight));
    }
    return row;
}

const std::int32_t* dither_at(int x, int y) { return kDither[y & 7].data() + (x & 7); }

} // namespace evil::raster
