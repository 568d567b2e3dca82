#pragma once
// Many numbers from Python: any buffer of floats or whole numbers (NumPy's arrays, array.array, memoryview, the world's
// own views), or a sequence of numbers or points. Errors name the argument and the place in it.
#include "bind/convert.hpp"
#include "bodies.hpp"
#include <optional>

namespace evil::bind {

struct Bounds { // what each number must be within, and how that is said
    double most;
    const char* said;
    bool round = false; // of a point: its distance from the origin is meant, not each coordinate
};

inline constexpr double kMaxAngle = 1e15; // radians; beyond it, an angle has no meaning left
inline constexpr Bounds kPlaces{kWorldEdge, "finite and within 1e7 metres of the origin", true},
    kAngles{kMaxAngle, "a finite number of radians, at most 1e15"},
    kSpeeds{kMaxSpeed, "finite and at most 1e5 m/s along each axis"},
    kSpins{kMaxSpin, "finite and at most 1e4 radians a second"},
    kPushes{kMaxForce, "finite and at most 1e30 along each axis"}, kFinite{3.4e38, "finite"};

// Points from (n, 2) or, in a buffer without columns, 2 n numbers.
std::vector<Vec2> to_points(nb::handle values, const char* owner, const char* argument, Bounds bounds);

// Numbers from (n,).
std::vector<double> to_numbers(nb::handle values, const char* owner, const char* argument, Bounds bounds);

// As many as are given, or one that stands for all: a point by itself, or a number.
template <class T> struct OneOrMany {
    std::vector<T> rows;
    bool one = false;
    T at(std::size_t i) const { return rows[one ? 0 : i]; }
};
OneOrMany<Vec2> to_point_or_points(nb::handle values, const char* owner, const char* argument, Bounds bounds);
OneOrMany<double> to_number_or_numbers(nb::handle values, const char* owner, const char* argument, Bounds bounds);

// Whole numbers, 0 or more, from (n,).
std::vector<std::uint32_t> to_indices(nb::handle values, const char* owner, const char* argument);

} // namespace evil::bind
