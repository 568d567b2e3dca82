#include "gpu/liquid.hpp"
#include <algorithm>
#include <bit>
#include <cstddef>

namespace evil::gpu {
namespace {

// To the nearest float of 16 bits; what is too small for a full one is 0.
std::uint16_t to_half(float value) {
    const auto bits = std::bit_cast<std::uint32_t>(std::clamp(value, -60000.0f, 60000.0f));
    const std::uint32_t size = (bits & 0x7fffffffu) + 0x1000u, sign = bits >> 16 & 0x8000u;
    return static_cast<std::uint16_t>(size < 0x38800000u ? sign : sign | ((size - 0x38000000u) >> 13));
}

} // namespace

std::array<Halves, 3> pack_liquid(const draw::LiquidMap& map) {
    const std::size_t count = static_cast<std::size_t>(map.stride) * map.height;
    std::array<Halves, 3> result;
    for (Halves& plane : result) plane.resize(4 * count);
    const auto put = [&](std::size_t texture, std::size_t channel, std::size_t plane) {
        const float* from = map.planes[plane].data();
        std::uint16_t* to = result[texture].data() + channel;
        for (std::size_t i = 0; i < count; ++i) to[4 * i] = to_half(from[i]);
    };
    for (std::size_t c = 0; c < 4; ++c) put(0, c, draw::kDepth + c);
    for (std::size_t c = 0; c < 3; ++c) put(1, c, draw::kThroughRed + c), put(2, c, draw::kOwnRed + c);
    return result;
}

} // namespace evil::gpu
