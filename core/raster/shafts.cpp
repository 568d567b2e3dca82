#include "raster/shafts.hpp"
#include <algorithm>

namespace evil::raster {
namespace {

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

void gather(const Greys& above, const Greys& to, Vec2 from, const ShaftTaps& taps, ShaftScratch& scratch) {
    const std::size_t width = static_cast<std::size_t>(to.width);
    scratch.first.resize(kShaftTaps * width);
    scratch.part.resize(kShaftTaps * width);
    scratch.row.resize(width + 1);
    scratch.sum.resize(width);
    for (int tap = 0; tap < kShaftTaps; ++tap)
        for (std::size_t x = 0; x < width; ++x) {
            const Between place = towards(static_cast<int>(x), from.x, taps.at[tap], to.width);
            scratch.first[tap * width + x] = place.first;
            scratch.part[tap * width + x] = place.part;
        }
    float *row = scratch.row.data(), *sum = scratch.sum.data();
    for (int y = 0; y < to.height; ++y) {
        std::fill_n(sum, width, 0.5f);
        for (int tap = 0; tap < kShaftTaps; ++tap) {
            const Between place = towards(y, from.y, taps.at[tap], to.height);
            const std::uint8_t* high = above.values + static_cast<std::size_t>(place.first) * width;
            const std::uint8_t* low = place.first + 1 < to.height ? high + width : high;
            const float weight = taps.weight[tap], upper = weight * (1.0f - place.part), lower = weight * place.part;
            for (std::size_t x = 0; x < width; ++x)
                row[x] = upper * static_cast<float>(high[x]) + lower * static_cast<float>(low[x]);
            row[width] = row[width - 1];
            const std::int32_t* first = scratch.first.data() + tap * width;
            const float* part = scratch.part.data() + tap * width;
            for (std::size_t x = 0; x < width; ++x) {
                const float left = row[first[x]], right = row[first[x] + 1];
                sum[x] += left + part[x] * (right - left);
            }
        }
        std::uint8_t* result = to.values + static_cast<std::size_t>(y) * width;
        for (std::size_t x = 0; x < width; ++x)
            result[x] = static_cast<std::uint8_t>(static_cast<std::int32_t>(sum[x]));
    }
}

Glow glow_of(const draw::Shafts& shafts) {
    const auto part = [&](int shift) { return static_cast<float>(shafts.colour >> shift & 255u) / 255.0f; };
    const float strength = shafts.strength * part(24);
    return {strength * part(0), strength * part(8), strength * part(16)};
}

std::uint8_t beyond(int channel, float threshold) {
    const float share = (static_cast<float>(channel) / 255.0f - threshold) / (1.0f - threshold);
    return static_cast<std::uint8_t>(255.0f * std::clamp(share, 0.0f, 1.0f) + 0.5f);
}

} // namespace evil::raster
