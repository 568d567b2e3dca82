#pragma once
// A polygon's rings: its outline, and the outlines of its holes.
#include "math/vec2.hpp"
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace evil {

// The corners of all rings in one row, the outline's first: it runs counter-clockwise and the holes clockwise, so that what
// is solid lies to the left of every edge. Without holes it is a plain list of corners.
//
//     3___________2
//     |   5___6   |
//     |   |   |   |      corners 0 to 7, holes {4}
//     |   4___7   |
//     0___________1
struct Rings {
    std::span<const Vec2> corners;
    std::span<const std::uint32_t> holes; // the number of each hole's first corner, rising

    Rings(std::span<const Vec2> all, std::span<const std::uint32_t> holes_of = {}) : corners(all), holes(holes_of) {}
    Rings(const std::vector<Vec2>& all) : corners(all) {}

    std::size_t count() const { return holes.size() + 1; }
    std::size_t first(std::size_t ring) const { return ring == 0 ? 0 : holes[ring - 1]; }
    std::size_t end(std::size_t ring) const { return ring < holes.size() ? holes[ring] : corners.size(); }
    std::span<const Vec2> ring(std::size_t i) const { return corners.subspan(first(i), end(i) - first(i)); }
};

struct OwnedRings {
    std::vector<Vec2> corners;
    std::vector<std::uint32_t> holes;
    operator Rings() const { return {corners, holes}; }
};

// For each corner the number of the one that follows it in its ring.
std::vector<std::uint32_t> followers(const Rings& rings);

} // namespace evil
