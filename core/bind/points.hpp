#pragma once
// Many points, or many numbers, of Python in one go: from any buffer of floats or a list.
#include "bind/convert.hpp"
#include <vector>

namespace evil::bind {

// Finite points from a buffer of 32- or 64-bit floats of shape (n, 2), however it lies in memory, or from a list of points; or one
// point, which then stands for all. evil.ArgumentError / ArgumentTypeError name owner, argument and row.
struct Points {
    std::vector<Vec2> rows;
    bool one = false; // a single point was given
    Vec2 at(std::size_t i) const { return rows[one ? 0 : i]; }
};
Points to_points(nb::handle source, const char* owner, const char* argument);

// The same for numbers: a buffer of shape (n,), a list, or one number for all.
struct Numbers {
    std::vector<float> rows;
    bool one = false;
    float at(std::size_t i) const { return rows[one ? 0 : i]; }
};
Numbers to_numbers(nb::handle source, const char* owner, const char* argument);

} // namespace evil::bind
