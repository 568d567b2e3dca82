#include "draw/lit_specks.hpp"
#include <algorithm>

namespace evil::draw {
namespace {

using light::Factors;

// A texel and how far on the way to the next one, in 256ths.
struct Place {
    int texel, next;
    Factors weight;
};
Place place_of(float pixel, float first, float step, int count) {
    const float at = std::min(std::max(0.0f, (pixel - first) / step), static_cast<float>(count - 1));
    const int texel = static_cast<int>(at);
    return {texel, std::min(texel + 1, count - 1), static_cast<Factors>((at - static_cast<float>(texel)) * 256.0f)};
}

Factors mix(Factors a, Factors b, Factors weight) {
    return (a * (256 - weight) + b * weight) >> 8 & light::kAllFactors;
}

Factors light_at(const light::LightMap& map, Vec2 pixel) {
    const Place x = place_of(pixel.x, map.first.x, map.step, map.width);
    const Place y = place_of(pixel.y, map.first.y, map.step, map.height);
    const auto row = [&](int at) {
        const Factors* texels = map.texels.data() + static_cast<std::size_t>(at) * map.width;
        return mix(texels[x.texel], texels[x.next], x.weight);
    };
    return mix(row(y.texel), row(y.next), y.weight);
}

Rgba8 lit(Rgba8 colour, Factors light) {
    Rgba8 result = colour & 0xff000000u;
    for (int channel = 0; channel < 3; ++channel) {
        const Factors factor = light >> (2 - channel) * light::kFactorApart & light::kFactorMask;
        const Factors value = ((colour >> 8 * channel & 255u) * factor + light::kFactorOne / 2) / light::kFactorOne;
        result |= static_cast<Rgba8>(std::min<Factors>(value, 255)) << 8 * channel;
    }
    return result;
}

} // namespace

bool has_lit_specks(const DrawList& list) {
    return std::ranges::any_of(list.interludes.rows, [](const Interlude& one) { return one.lit; });
}

void light_specks(DrawList& list) {
    if (!list.light.on) return;
    for (const Interlude& one : list.interludes.rows) {
        if (!one.lit) continue;
        for (Speck& speck : std::span(list.interludes.specks).subspan(one.first, one.count))
            speck.colour = lit(speck.colour, light_at(list.light, speck.at));
    }
}

} // namespace evil::draw
