#pragma once
// Outlines with a skin of one radius round their corners: capsules, rounded polygons, and lines as thin as can be seen.
#include "shapes/polygon.hpp"
#include "shapes/shapes.hpp"

namespace evil {

inline constexpr float kRod = 0.01f;  // metres: a segment or chain without a skin weighs as a rod this thick
inline constexpr float kLine = 0.04f; // metres: and is drawn this thick; two pixels at the usual 50 a metre

// The corners that a skin of this radius rounds off just so that the polygon keeps its edges. Its straight edges move in
// by the radius; corners that turn inward stay sharp. Empty when some edge would be gone before.
//
//     ____________         ____________
//    |            |       (  ________  )
//    |            |       | |  core  | |      the skin is the core's neighbourhood: what is within `radius` of it
//    |____________|       (__________ _)
OwnedRings inset(const Rings& rings, float radius);

// The largest radius that `inset` takes, within a thousandth.
float largest_inset(const Rings& rings);

// Mass properties of closed rings (simple; two corners alone are a line) with a skin round what they enclose.
MassProperties rounded_mass(const Rings& rings, float radius, float density) noexcept;
MassProperties path_mass(std::span<const Vec2> points, bool closed, float density) noexcept; // rods along a path

// The same rings as a polygon to draw, with short edges round its corners: at most an eight-hundredth of the radius
// inside the true one. Two corners without a radius are drawn as thick as kLine.
OwnedRings rounded_outline(const Rings& rings, float radius);

// A path as thick as kLine: up its right side and back down its left. Sharp bends are cut off, and a closed path is parted
// where nobody sees it, in the middle of an edge.
std::vector<Vec2> path_outline(std::span<const Vec2> points, bool closed);

// A shape's outline to draw, before `local`. Empty for circles and particles, which have none.
OwnedRings drawn_outline(const Shape& shape, const Rings& rings);

} // namespace evil
