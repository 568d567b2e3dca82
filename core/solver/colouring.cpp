#include "solver/colouring.hpp"
#include <bit>

namespace evil {
namespace {

// Colours 0..63 between bodies, 64 for those that found none, 65..128 at walls, 129 for those.
constexpr std::uint32_t kOverflow = kColours, kWalls = kColours + 1, kWallOverflow = 2 * kColours + 1;
constexpr std::uint32_t kAll = 2 * kColours + 2;

bool alone(std::uint32_t colour) { return colour == kOverflow || colour == kWallOverflow; }

std::uint32_t take_lowest(std::uint64_t& a, std::uint64_t& b, std::uint32_t first, std::uint32_t overflow) {
    std::uint64_t taken = a | b;
    if (taken == ~std::uint64_t{0}) return overflow;
    auto lowest = static_cast<std::uint32_t>(std::countr_one(taken));
    a |= std::uint64_t{1} << lowest;
    b |= std::uint64_t{1} << lowest;
    return first + lowest;
}

} // namespace

void colour(Colouring& c, const std::vector<Edge>& edges, std::uint32_t bodies, std::uint32_t lanes) {
    c.used_between.assign(bodies, 0);
    c.used_walls.assign(bodies, 0);
    c.counts.assign(kAll, 0);
    c.colour.resize(edges.size());
    c.places.resize(edges.size());
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const Edge& e = edges[i];
        std::uint32_t colour = e.wall() ? take_lowest(c.used_walls[e.a], c.used_walls[e.a], kWalls, kWallOverflow)
                                        : take_lowest(c.used_between[e.a], c.used_between[e.b], 0, kOverflow);
        c.colour[i] = static_cast<std::uint8_t>(colour);
        ++c.counts[colour];
    }
    c.next.resize(kAll); // in lanes: block times lanes plus lane
    c.ranges.clear();
    std::uint32_t block = 0;
    for (std::uint32_t colour = 0; colour < kAll; ++colour) {
        c.next[colour] = block * lanes;
        std::uint32_t count = alone(colour) ? c.counts[colour] : (c.counts[colour] + lanes - 1) / lanes;
        if (count > 0) c.ranges.push_back({block, count, colour >= kWalls, alone(colour)});
        block += count;
    }
    c.blocks = block;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        std::uint32_t& at = c.next[c.colour[i]];
        c.places[i] = {at / lanes, at % lanes};
        at += alone(c.colour[i]) ? lanes : 1;
    }
}

} // namespace evil
