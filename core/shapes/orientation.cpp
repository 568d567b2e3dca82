#include "shapes/orientation.hpp"

namespace evil {
namespace {

int sign(double v) { return (v > 0.0) - (v < 0.0); }

int exact_turn(Vec2 a, Vec2 b, Vec2 c) noexcept {
    double ax = a.x, ay = a.y, bx = b.x, by = b.y, cx = c.x, cy = c.y;
    const double terms[6] = {ax * by, -ax * cy, bx * cy, -bx * ay, cx * ay, -cx * by};
    double parts[6]; // never overlapping, growing in size; their sum is exact
    for (int count = 0; count < 6; ++count) {
        double carry = terms[count];
        for (int i = 0; i < count; ++i) { // two-sum (Knuth): total + lost is carry + parts[i], exactly
            double total = carry + parts[i], shared = total - carry;
            parts[i] = (carry - (total - shared)) + (parts[i] - shared);
            carry = total;
        }
        parts[count] = carry;
    }
    for (int i = 5; i > 0; --i)
        if (parts[i] != 0.0) return sign(parts[i]);
    return sign(parts[0]);
}

} // namespace

int turn(Vec2 a, Vec2 b, Vec2 c) noexcept {
    double left = (double{b.x} - a.x) * (double{c.y} - a.y), right = (double{b.y} - a.y) * (double{c.x} - a.x);
    double area = left - right, bound = 4e-16 * (std::fabs(left) + std::fabs(right)); // four roundings of 2^-53 at most
    return std::fabs(area) > bound ? sign(area) : exact_turn(a, b, c);
}

} // namespace evil
