#pragma once
// A liquid's map as three textures of floats of 16 bits, four a texel.
#include "draw/liquid_map.hpp"
#include <array>
#include <cstdint>
#include <vector>

namespace evil::gpu {

using Halves = std::vector<std::uint16_t>;
using PackedLiquid = std::array<Halves, 3>;

// Depth, displacement and rim; what comes through; own colour. Rows are as long as the map's, padding included.
void pack_liquid(const draw::LiquidMap& map, PackedLiquid& to);

} // namespace evil::gpu
