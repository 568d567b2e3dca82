#pragma once
#include "bind/module.hpp"
#include "shapes/rings.hpp"

namespace evil::bind {

// Corners from any sequence of pairs of numbers; NaN, infinities and too many pass, for check_polygon to speak of.
std::vector<Vec2> to_corners(nb::handle points, const char* owner, const char* argument);

// The same of an outline, with one list of corners for each hole; what check_polygon would refuse is refused.
OwnedRings to_rings(nb::handle points, nb::handle holes, const char* owner, const char* argument);

// evil.ShapeError that says what is wrong, unless check_polygon is content.
void refuse_bad_polygon(const Rings& rings, const char* owner, const char* argument);

} // namespace evil::bind
