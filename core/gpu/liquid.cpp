#include "gpu/liquid.hpp"
#include "gpu/liquid_wide.hpp"

namespace evil::gpu {

void pack_liquid(const draw::LiquidMap& map, PackedLiquid& to) {
    using namespace draw;
    const std::size_t count = static_cast<std::size_t>(map.stride) * map.height; // a multiple of eight
    const LiquidPlane planes[3][4] = {{kDepth, kAwayX, kAwayY, kRim},
                                      {kThroughRed, kThroughGreen, kThroughBlue, kRim}, // the fourth is not used
                                      {kOwnRed, kOwnGreen, kOwnBlue, kRim}};
    for (std::size_t texture = 0; texture < 3; ++texture) {
        to[texture].resize(4 * count);
        const float* from[4];
        for (std::size_t c = 0; c < 4; ++c) from[c] = map.planes[planes[texture][c]].data();
        EVIL_PICK(best_instruction_set(), pack_halves_wide)
        (from, to[texture].data(), static_cast<int>(count));
    }
}

} // namespace evil::gpu
