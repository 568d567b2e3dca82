#pragma once
#include "bind/module.hpp"
#include "math/vec2.hpp"
#include <span>
#include <vector>

namespace evil::bind {

// Corners from any sequence of pairs of numbers; NaN, infinities and too many pass, for check_polygon to speak of.
std::vector<Vec2> to_corners(nb::handle points, const char* owner, const char* argument);

// evil.ShapeError that says what is wrong, unless check_polygon is content.
void refuse_bad_polygon(std::span<const Vec2> corners, const char* owner, const char* argument);

} // namespace evil::bind
