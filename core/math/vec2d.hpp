#pragma once
// 2D vectors in double, for geometry that must stay right far from the origin.
#include "math/vec2.hpp"
#include <concepts>

namespace evil {

struct Vec2d {
    double x = 0.0, y = 0.0;

    friend constexpr Vec2d operator+(Vec2d a, Vec2d b) { return {a.x + b.x, a.y + b.y}; }
    friend constexpr Vec2d operator-(Vec2d a, Vec2d b) { return {a.x - b.x, a.y - b.y}; }
    friend constexpr Vec2d operator-(Vec2d a) { return {-a.x, -a.y}; }
    friend constexpr Vec2d operator*(double s, Vec2d a) { return {s * a.x, s * a.y}; }
};

constexpr Vec2d wide(Vec2 a) { return {double{a.x}, double{a.y}}; }
constexpr Vec2 narrow(Vec2d a) { return {static_cast<float>(a.x), static_cast<float>(a.y)}; }
constexpr double dot(Vec2d a, Vec2d b) { return a.x * b.x + a.y * b.y; }
constexpr double cross(Vec2d a, Vec2d b) { return a.x * b.y - a.y * b.x; }
constexpr Vec2d left_of(Vec2d a) { return {-a.y, a.x}; }
template <std::same_as<Vec2d> V> double length(V a) { // so that length({x, y}) is of floats
    return std::sqrt(dot(a, a));
}

} // namespace evil
