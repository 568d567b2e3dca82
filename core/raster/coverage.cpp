#include "raster/coverage.hpp"
#include <algorithm>
#include <cmath>

namespace evil::raster {
namespace {

// Fixed point: 1/256 pixel. Finer would not show in an 8-bit picture.
constexpr int kOne = 256;

struct Fixed {
    int x, y;
};

std::int32_t add(std::int32_t a, std::int32_t b) { // wraps round: thousands of windings must not be undefined
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) + static_cast<std::uint32_t>(b));
}

// The part of one edge inside one row, in pixel x..x+1: `height` is signed, x0 and x1 are where it enters and leaves.
void add_cell(std::int32_t* cells, std::uint64_t* touched, int cell, int height, int x0_plus_x1) {
    cells[cell] = add(cells[cell], height * (2 * kOne - x0_plus_x1));
    cells[cell + 1] = add(cells[cell + 1], height * x0_plus_x1);
    const int first = cell / kBlock, second = (cell + 1) / kBlock;
    touched[first / 64] |= std::uint64_t{1} << (first % 64);
    touched[second / 64] |= std::uint64_t{1} << (second % 64);
}

// The part of an edge within one row: from x0 to x1 while the height `rise` (signed by `sign`) is crossed.
void add_row(std::int32_t* cells, std::uint64_t* touched, int x0, int x1, int rise, int sign) {
    const int first = x0 / kOne, last = x1 / kOne;
    if (first == last) {
        add_cell(cells, touched, first, sign * rise, (x0 % kOne) + (x1 % kOne));
        return;
    }
    // Walk the pixels from left to right. The height is the same either way, so only the ends swap.
    const int left = std::min(x0, x1), right = std::max(x0, x1), run = right - left;
    const int from = left / kOne, to = right / kOne;
    // Height at the end of each pixel, without accumulated error: quotient and remainder of rise / run.
    int numerator = (kOne - left % kOne) * rise;
    int height = numerator / run, remainder = numerator % run;
    add_cell(cells, touched, from, sign * height, left % kOne + kOne);
    const int step = kOne * rise / run, step_remainder = kOne * rise % run;
    int done = height;
    for (int cell = from + 1; cell < to; ++cell) {
        height = step;
        remainder += step_remainder;
        if (remainder >= run) ++height, remainder -= run;
        add_cell(cells, touched, cell, sign * height, kOne);
        done += height;
    }
    if (done != rise) add_cell(cells, touched, to, sign * (rise - done), right % kOne);
}

// An edge inside the box, a above b. Coordinates in fixed point from the box's corner.
void add_line(Coverage& coverage, Fixed a, Fixed b, int sign) {
    const int height = b.y - a.y, top = coverage.rows.first - coverage.box.top;
    const int last_y = std::min(b.y, (coverage.rows.last - coverage.box.top) * kOne);
    int y = std::max(a.y, top * kOne);
    if (y >= last_y) return;
    // Position at the end of each row: floor of (b.x - a.x) * y / height, with its remainder carried along.
    const int run = b.x - a.x; // at most kMaxSide * 256: times 256 it still fits
    auto floor_divide = [height](auto n, int& remainder) {
        auto quotient = n / height;
        remainder = static_cast<int>(n % height);
        if (remainder < 0) --quotient, remainder += height;
        return static_cast<int>(quotient);
    };
    int remainder = 0, step_remainder = 0, next_x = 0;
    const int step = floor_divide(run * kOne, step_remainder);
    int x = y == a.y ? a.x : a.x + floor_divide(std::int64_t{run} * (y - a.y), remainder);
    int row = y / kOne;
    std::int32_t* cells = coverage.cells.data() + static_cast<std::size_t>(row - top) * coverage.stride;
    std::uint64_t* touched = coverage.touched.data() + static_cast<std::size_t>(row - top) * coverage.words;
    while (y < last_y) {
        const int row_end = (row + 1) * kOne;
        if (y == a.y && row_end < b.y) {
            next_x = a.x + floor_divide(run * (row_end - a.y), remainder);
        } else if (row_end < b.y) {
            next_x = x + step;
            remainder += step_remainder;
            if (remainder >= height) ++next_x, remainder -= height;
        } else {
            next_x = b.x;
        }
        const int next_y = std::min(row_end, b.y);
        add_row(cells, touched, x, next_x, next_y - y, sign);
        x = next_x, y = next_y, ++row;
        cells += coverage.stride, touched += coverage.words;
    }
}

int to_fixed(double value, int limit) { // rounded; clamped to 0..limit pixels
    return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(limit)) * kOne + 0.5);
}

// Cuts an edge to the box. What lies left of it still covers the pixels to its right, so it is pushed onto the left side;
// what lies right of it covers nothing.
//
//    left |              | right
//   a*    |              |
//    . \  |              |
//    .   \|              |
//         *.             |
//         |  \           |
void add_edge(Coverage& coverage, Point a, Point b) {
    int sign = 1;
    if (a.y > b.y) std::swap(a, b), sign = -1; // so that an edge shared by two shapes is cut and rounded alike in both
    const int width = coverage.box.right - coverage.box.left, height = coverage.box.bottom - coverage.box.top;
    const int first = coverage.rows.first - coverage.box.top, last = coverage.rows.last - coverage.box.top;
    if (b.y <= first || a.y >= last || !(a.y < b.y)) return;
    if (a.x >= width && b.x >= width) return;
    if (a.y >= 0 && b.y <= height && std::min(a.x, b.x) >= 0 && std::max(a.x, b.x) <= width)
        return add_line(coverage, {to_fixed(a.x, width), to_fixed(a.y, height)},
                        {to_fixed(b.x, width), to_fixed(b.y, height)}, sign);
    const double slope = (b.x - a.x) / (b.y - a.y);
    auto x_at = [&](double y) { return std::clamp(a.x + slope * (y - a.y), std::min(a.x, b.x), std::max(a.x, b.x)); };
    Point p = a, q = b;
    if (a.y < 0) p = {x_at(0), 0};
    if (b.y > height) q = {x_at(height), static_cast<double>(height)};

    // Heights at which the edge crosses the left and right side, in order along it.
    double cut[2] = {p.y, q.y};
    auto y_at = [&](double x) { return std::clamp(a.y + (x - a.x) / slope, p.y, q.y); };
    const bool falls_left = q.x < p.x;
    if (std::min(p.x, q.x) < 0 && std::max(p.x, q.x) > 0) cut[falls_left ? 1 : 0] = y_at(0);
    if (std::min(p.x, q.x) < width && std::max(p.x, q.x) > width) cut[falls_left ? 0 : 1] = y_at(width);

    const Fixed start{to_fixed(p.x, width), to_fixed(p.y, height)}, end{to_fixed(q.x, width), to_fixed(q.y, height)};
    const int one = to_fixed(cut[0], height), other = std::max(one, to_fixed(cut[1], height));
    // Clamped, the parts outside run straight down the sides. At the right side they cover nothing that is seen.
    add_line(coverage, start, {start.x, one}, sign);
    add_line(coverage, {start.x, one}, {end.x, other}, sign);
    add_line(coverage, {end.x, other}, end, sign);
}

} // namespace

void begin(Coverage& coverage, const Box& box, const Rows& shown) {
    coverage.box = box, coverage.rows = shown;
    coverage.stride =
        (box.right - box.left + 2 + kBlock - 1) / kBlock * kBlock; // an edge on the right side needs two more
    coverage.words = (coverage.stride / kBlock + 63) / 64;
    const std::size_t rows = static_cast<std::size_t>(shown.last - shown.first);
    if (coverage.cells.size() < rows * coverage.stride) coverage.cells.resize(rows * coverage.stride);
    if (coverage.touched.size() < rows * coverage.words) coverage.touched.resize(rows * coverage.words);
}

void add_loop(Coverage& coverage, std::span<const Point> points) {
    if (points.size() < 3) return;
    const double left = coverage.box.left, top = coverage.box.top;
    Point last{points.back().x - left, points.back().y - top};
    for (const Point& point : points) {
        const Point next{point.x - left, point.y - top};
        add_edge(coverage, last, next);
        last = next;
    }
}

} // namespace evil::raster
