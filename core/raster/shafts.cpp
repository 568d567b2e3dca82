#include "raster/shafts.hpp"
#include "raster/target.hpp"
#include <algorithm>

namespace evil::raster {
namespace {

constexpr float kFullGrey = 255.0f * kParts;

// Between which two pixels a place is, and how far on the way to the second; beyond the edge it is as at the edge.
struct Between {
    int first = 0;
    float part = 0.0f;
};
Between between(float place, int count) {
    place = std::min(std::max(0.0f, place - 0.5f), static_cast<float>(count - 1)); // 0 for what is no number
    const int first = static_cast<int>(place);
    return {first, place - static_cast<float>(first)};
}

// What is so far on the way from each pixel's middle to the point is the whole plane, smaller, round that point: its rows
// are rows and its columns columns.
Between towards(int pixel, float point, float share, int count) {
    const float middle = static_cast<float>(pixel) + 0.5f;
    return between(middle + share * (point - middle), count);
}

struct Places { // by column: after which pixel of a row, and how far
    const std::int32_t* first;
    const float* part;
};

// Adds what one tap of a row sees.
void add_tap(const Greys& above, const Between& down, float weight, const Places& places, ShaftScratch::Lines& lines) {
    const std::size_t width = static_cast<std::size_t>(above.width);
    const std::uint16_t* high = above.values + static_cast<std::size_t>(down.first) * width;
    const std::uint16_t* low = down.first + 1 < above.height ? high + width : high;
    const float upper = weight * (1.0f - down.part), lower = weight * down.part;
    float *row = lines.row.data(), *sum = lines.sum.data();
    for (std::size_t x = 0; x < width; ++x)
        row[x] = upper * static_cast<float>(high[x]) + lower * static_cast<float>(low[x]);
    row[width] = row[width - 1];
    for (std::size_t x = 0; x < width; ++x) {
        const float left = row[places.first[x]], right = row[places.first[x] + 1];
        sum[x] += left + places.part[x] * (right - left);
    }
}

} // namespace

ShaftTaps shaft_taps(float reach, int pass) {
    float step = reach;
    for (int i = 0; i <= pass; ++i) step /= static_cast<float>(kShaftTaps);
    ShaftTaps taps{};
    float weight = 1.0f, sum = 0.0f;
    for (int i = 0; i < kShaftTaps; ++i) {
        taps.at[i] = static_cast<float>(i) * step;
        taps.weight[i] = weight, sum += weight;
        weight /= 1.0f + kShaftFade * step; // a decay by backward Euler: the same everywhere
    }
    for (float& each : taps.weight) each /= sum;
    return taps;
}

void gather(const Greys& above, const Greys& to, Vec2 from, const ShaftTaps& taps, ShaftScratch& scratch,
            const Bands& bands) {
    const std::size_t width = static_cast<std::size_t>(to.width);
    scratch.first.resize(kShaftTaps * width);
    scratch.part.resize(kShaftTaps * width);
    for (int tap = 0; tap < kShaftTaps; ++tap)
        for (std::size_t x = 0; x < width; ++x) {
            const Between place = towards(static_cast<int>(x), from.x, taps.at[tap], to.width);
            scratch.first[tap * width + x] = place.first;
            scratch.part[tap * width + x] = place.part;
        }
    if (scratch.lines.size() < static_cast<std::size_t>(bands.most)) scratch.lines.resize(bands.most);
    for (ShaftScratch::Lines& lines : scratch.lines) lines.row.resize(width + 1), lines.sum.resize(width);
    each_band(bands, to.width, to.height, [&](const Rows& rows, std::size_t band) {
        ShaftScratch::Lines& lines = scratch.lines[band];
        for (int y = rows.first; y < rows.last; ++y) {
            std::ranges::fill(lines.sum, 0.5f);
            for (int tap = 0; tap < kShaftTaps; ++tap)
                add_tap(above, towards(y, from.y, taps.at[tap], to.height), taps.weight[tap],
                        {scratch.first.data() + tap * width, scratch.part.data() + tap * width}, lines);
            std::uint16_t* result = to.values + static_cast<std::size_t>(y) * width;
            for (std::size_t x = 0; x < width; ++x)
                result[x] = static_cast<std::uint16_t>(static_cast<std::int32_t>(lines.sum[x]));
        }
    });
}

Glow glow_of(const draw::Shafts& shafts) {
    const auto part = [&](int shift) { return static_cast<float>(shafts.colour >> shift & 255u) / 255.0f; };
    const float strength = shafts.strength * part(24);
    return {strength * part(0), strength * part(8), strength * part(16)};
}

std::uint16_t beyond(std::uint32_t channel, float threshold) {
    const float share = (static_cast<float>(channel) / kFullGrey - threshold) / (1.0f - threshold);
    return static_cast<std::uint16_t>(kFullGrey * std::clamp(share, 0.0f, 1.0f) + 0.5f);
}

} // namespace evil::raster
