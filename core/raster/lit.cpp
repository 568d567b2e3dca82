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

struct Place { // a texel, the next one, and how far on the way to that, in 256ths
    int texel, next, weight;
};

Place place_of(int pixel, float first, float step, int count) {
    const float at = std::clamp((static_cast<float>(pixel) + 0.5f - first) / step, 0.0f, static_cast<float>(count - 1));
    const int texel = std::min(static_cast<int>(at), std::max(count - 2, 0));
    return {texel, std::min(texel + 1, count - 1), static_cast<int>((at - static_cast<float>(texel)) * 256.0f)};
}

// Texels between two rows of the map, channel by channel.
void mix(const LightRows& rows, const Factors* above, const Factors* below, int weight, std::int32_t* const to[3]) {
    const auto share = static_cast<Factors>(weight);
    for (int x = 0; x < rows.map->width; ++x) {
        const Factors sum = above[x] * (256 - share) + below[x] * share;
        for (int c = 0; c < 3; ++c)
            to[c][x] = static_cast<std::int32_t>(sum >> ((2 - c) * light::kFactorApart + 8) & light::kFactorMask);
    }
}

} // namespace

void begin(LightRows& rows, const light::LightMap& map, const Target& target, const Bands& bands) {
    rows.map = &map;
    if (!map.on) return;
    rows.width = target.width;
    rows.stride = target.width + 8; // read in eights
    if (rows.between.size() < static_cast<std::size_t>(bands.most)) rows.between.resize(bands.most);
    for (LightRows::Between& row : rows.between)
        for (std::vector<std::int32_t>& channel : row.channel) channel.resize(static_cast<std::size_t>(map.width) + 8);
    rows.texel.resize(rows.stride), rows.next.resize(rows.stride), rows.weight.resize(rows.stride);
    for (int x = 0; x < rows.stride; ++x) {
        const Place place = place_of(x, map.first.x, map.step, map.width);
        rows.texel[x] = place.texel, rows.next[x] = place.next, rows.weight[x] = place.weight;
    }
    const auto use = [&](LightRows::Plane& plane, const std::vector<Factors>& texels) {
        plane.texels = &texels;
        plane.factors.resize(static_cast<std::size_t>(rows.stride) * target.height);
        plane.ready.assign(target.height, 0);
    };
    use(rows.light, map.texels);
    if (map.directed) use(rows.across, map.across), use(rows.down, map.down);
}

const std::uint32_t* row_of(LightRows& rows, LightRows::Plane& plane, int y, std::size_t band, Set set) {
    std::uint32_t* row = plane.factors.data() + static_cast<std::size_t>(rows.stride) * y;
    if (plane.ready[y]) return row;
    plane.ready[y] = 1;
    const light::LightMap& map = *rows.map;
    const Place down = place_of(y, map.first.y, map.step, map.height);
    const Factors* texels = plane.texels->data();
    auto& channel = rows.between[band].channel;
    std::int32_t* const between[3] = {channel[0].data(), channel[1].data(), channel[2].data()};
    mix(rows, texels + static_cast<std::size_t>(down.texel) * map.width,
        texels + static_cast<std::size_t>(down.next) * map.width, down.weight, between);
    const bool near = map.step >= 2.0f; // three and a half texels at most, and the next one
    spread_light(set, row, rows.width, between, {rows.texel.data(), rows.next.data(), rows.weight.data(), near});
    return row;
}

const std::int32_t* dither_at(int x, int y) { return kDither[y & 7].data() + (x & 7); }

} // namespace evil::raster
