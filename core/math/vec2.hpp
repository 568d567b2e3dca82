#pragma once
// 2D vectors (SPEC M1). Metres, y up.
#include <cmath>

namespace evil {

struct Vec2 {
    float x = 0.0f, y = 0.0f;

    friend constexpr bool operator==(Vec2, Vec2) = default;
    friend constexpr Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
    friend constexpr Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
    friend constexpr Vec2 operator-(Vec2 a) { return {-a.x, -a.y}; }
    friend constexpr Vec2 operator*(float s, Vec2 a) { return {s * a.x, s * a.y}; }
    friend constexpr Vec2 operator*(Vec2 a, float s) { return {s * a.x, s * a.y}; }
    constexpr Vec2& operator+=(Vec2 b) { return *this = *this + b; }
    constexpr Vec2& operator-=(Vec2 b) { return *this = *this - b; }
};

constexpr float dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }

// The determinant |a b|, also called perpendicular dot: positive when b lies to the left of a.
constexpr float cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }
constexpr Vec2 cross(float w, Vec2 r) { return {-w * r.y, w * r.x}; } // velocity of an arm r that turns at w
constexpr Vec2 left_of(Vec2 a) { return {-a.y, a.x}; }                // a turned by +90 degrees
constexpr Vec2 right_of(Vec2 a) {
    return {a.y, -a.x};
} // a turned by -90 degrees: outward from a counter-clockwise edge

constexpr float length_squared(Vec2 a) { return dot(a, a); }
inline float length(Vec2 a) { return std::sqrt(dot(a, a)); }
inline Vec2 normalised(Vec2 a) {
    float l = length(a);
    return l > 0.0f ? (1.0f / l) * a : Vec2{};
}
constexpr Vec2 lerp(Vec2 a, Vec2 b, float t) { return a + t * (b - a); }
constexpr Vec2 min(Vec2 a, Vec2 b) { return {a.x < b.x ? a.x : b.x, a.y < b.y ? a.y : b.y}; }
constexpr Vec2 max(Vec2 a, Vec2 b) { return {a.x > b.x ? a.x : b.x, a.y > b.y ? a.y : b.y}; }
inline bool is_finite(Vec2 a) { return std::isfinite(a.x) && std::isfinite(a.y); }

} // namespace evil
