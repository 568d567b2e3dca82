#include "light/cascades.hpp"
#include "light/cascades_wide.hpp"
#include "math/functions.hpp"
#include <algorithm>

namespace evil::light {
namespace {

// Levels: the last one has rays of 64 cells in 256 directions. Further on, light keeps to the cones that it is in; what a
// level more would show is shadows of far, small things in light that is soft anyway.
constexpr int kTop = 5;
constexpr std::size_t kGrain = 8;         // rows of cells that a thread takes at a time
constexpr float kQuarterWay = 0.9003163f; // 2 sqrt(2) / pi: the mean of the unit vectors in a quarter of all directions

struct Quarter { // of all directions, rays going from row 0 to the last
    const Cells& cells;
    bool backward; // row 0 is the last one of the cells
    int rows, width, top;
    std::size_t stride; // of a row of rays

    int rows_at(int level) const { return (rows + (1 << level) - 1) >> level; }
    const float* cell_row(int row) const { return cells.row(0, backward ? rows - 1 - row : row); }
};

Quarter quarter_of(const Cells& cells, bool backward) {
    int top = 0;
    while (top < kTop && 1 << top < cells.height) ++top;
    return {cells, backward, cells.height, cells.width, top, static_cast<std::size_t>((cells.width + 7) / 8 * 8)};
}

struct Levels {                                // where each one's rays are
    std::array<std::size_t, kTop + 2> first{}; // in rows of rays

    explicit Levels(const Quarter& q) {
        for (int n = 0; n <= q.top; ++n)
            first[n + 1] = first[n] + static_cast<std::size_t>(q.rows_at(n)) * ((1u << n) + 1u);
    }
};

float* ray_row(Cascades& scratch, const Quarter& q, const Levels& levels, int level, int row, int ray) {
    const std::size_t number = levels.first[level] + static_cast<std::size_t>(row) * ((1u << level) + 1u) + ray;
    return scratch.rays.data() + number * 4 * q.stride;
}

float* cone_row(std::vector<float>& cones, const Quarter& q, int level, int row, int cone) {
    return cones.data() + (static_cast<std::size_t>(row) << level | static_cast<unsigned>(cone)) * 3 * q.stride;
}

int aside(int level, int ray) { return 2 * ray - (1 << level); } // how many cells a ray ends to the side

// Shares of all directions: a heap, in which a cone's two halves lie at twice its place.
void measure_cones(std::vector<float>& angles, int top) {
    const int last = 2 << top;
    if (angles.size() == 2 * static_cast<std::size_t>(last)) return;
    angles.resize(2 * static_cast<std::size_t>(last));
    const auto direction = [last](int k) { return atan2(static_cast<float>(2 * k - last), static_cast<float>(last)); };
    for (int i = 0; i < last; ++i) angles[last + i] = (direction(i + 1) - direction(i)) / static_cast<float>(2.0 * kPi);
    for (int i = last - 1; i > 0; --i) angles[i] = angles[2 * i] + angles[2 * i + 1];
}

void trace_first(Cascades& scratch, const Quarter& q, const Levels& levels, Threads& threads, InstructionSet set) {
    parallel_for(threads, q.rows, kGrain, [&](std::size_t first, std::size_t last) {
        for (int row = static_cast<int>(first); row < static_cast<int>(last); ++row)
            for (int ray = 0; ray < 2; ++ray) {
                float* to = ray_row(scratch, q, levels, 0, row, ray);
                if (row + 1 == q.rows) { // they leave the map
                    std::fill_n(to, q.stride, 1.0f);
                    std::fill_n(to + q.stride, 3 * q.stride, 0.0f);
                    continue;
                }
                EVIL_PICK(set, first_rays_wide)
                ({q.cell_row(row), q.cell_row(row + 1), q.cells.plane_size(), aside(0, ray), q.cells.glows}, q.width,
                 q.stride, to);
            }
    });
}

// Level n + 1 from level n: two equal rays one behind the other; between two of those, the mean of both ways round.
void join(Cascades& scratch, const Quarter& q, const Levels& levels, int n, Threads& threads, InstructionSet set) {
    const int rays = (2 << n) + 1, below = q.rows_at(n);
    const auto jobs = static_cast<std::size_t>(q.rows_at(n + 1)) * rays;
    parallel_for(threads, jobs, kGrain, [&](std::size_t first, std::size_t last) {
        for (std::size_t job = first; job < last; ++job) {
            const int row = static_cast<int>(job) / rays, ray = static_cast<int>(job) % rays, half = ray / 2;
            const auto pair = [&](int one, int two) {
                const float* far = 2 * row + 1 < below ? ray_row(scratch, q, levels, n, 2 * row + 1, two) : nullptr;
                return Pair{ray_row(scratch, q, levels, n, 2 * row, one), far, aside(n, one)};
            };
            const bool between = ray % 2 == 1;
            const Pair pairs[2] = {pair(half, half + between), pair(half + between, half)};
            EVIL_PICK(set, join_rays_wide)
            (pairs, between ? 2 : 1, q.width, q.stride, ray_row(scratch, q, levels, n + 1, row, ray));
        }
    });
}

Surround surround_of(const Sky& sky, int level) {
    const float far =
        std::min(static_cast<float>(1 << level) / sky.reach, 1.0f); // a level's rays meet things so far off
    Surround surround;
    for (int c = 0; c < 3; ++c) surround.sky[c] = sky.colour[c], surround.fill[c] = sky.colour[c] * far;
    return surround;
}

// The last level's cones, row by row from the far end: light goes on from row to row in the cone that it is in.
void gather_top(Cascades& scratch, const Quarter& q, const Levels& levels, const Sky& sky, Threads& threads,
                InstructionSet set) {
    const int n = q.top;
    const Surround surround = surround_of(sky, n);
    std::vector<float>& cones = scratch.cones[n & 1];
    for (int row = q.rows_at(n) - 1; row >= 0; --row)
        parallel_for(threads, std::size_t{1} << n, kGrain, [&](std::size_t first, std::size_t last) {
            for (int i = static_cast<int>(first); i < static_cast<int>(last); ++i) {
                const float* far = row + 1 < q.rows_at(n) ? cone_row(cones, q, n, row + 1, i) : nullptr;
                const auto way = [&](int ray) {
                    return Way{ray_row(scratch, q, levels, n, row, ray), far, aside(n, ray),
                               scratch.angles[(1 << n) + i], 0.5f};
                };
                const Way ways[2] = {way(i), way(i + 1)};
                EVIL_PICK(set, gather_rays_wide)
                (ways, 2, surround, q.width, q.stride, cone_row(cones, q, n, row, i));
            }
        });
}

// A cone's two halves at level n + 1, whose rows are every second one of level n: from a row between, one ray goes to the
// next; from a row that both have, half is seen at once and half at the end of a ray twice as long.
void gather(Cascades& scratch, const Quarter& q, const Levels& levels, int n, const Sky& sky, Threads& threads,
            InstructionSet set) {
    const Surround surround = surround_of(sky, n);
    std::vector<float>&cones = scratch.cones[n & 1], &above = scratch.cones[(n + 1) & 1];
    const auto jobs = static_cast<std::size_t>(q.rows_at(n)) << n;
    parallel_for(threads, jobs, kGrain, [&](std::size_t first, std::size_t last) {
        for (std::size_t job = first; job < last; ++job) {
            const int row = static_cast<int>(job >> n), i = static_cast<int>(job) & ((1 << n) - 1), next = row / 2 + 1;
            std::array<Way, 4> ways;
            int count = 0;
            for (int ray = i; ray <= i + 1; ++ray) {
                const int half = i + ray;
                const float angle = scratch.angles[(2 << n) + half];
                const float* far = next < q.rows_at(n + 1) ? cone_row(above, q, n + 1, next, half) : nullptr;
                if (row % 2 == 1) {
                    ways[count++] = {ray_row(scratch, q, levels, n, row, ray), far, aside(n, ray), angle, 1.0f};
                    continue;
                }
                ways[count++] = {nullptr, cone_row(above, q, n + 1, row / 2, half), 0, angle, 0.5f};
                ways[count++] = {ray_row(scratch, q, levels, n + 1, row / 2, 2 * ray), far, aside(n + 1, 2 * ray),
                                 angle, 0.5f};
            }
            EVIL_PICK(set, gather_rays_wide)
            (ways.data(), count, surround, q.width, q.stride, cone_row(cones, q, n, row, i));
        }
    });
}

// Adds what comes from a quarter of all directions to three planes of rows, and to those of a lean if there are any.
void add_quarter(Cascades& scratch, const Cells& cells, bool backward, const Sky& sky, std::vector<float>& result,
                 std::vector<float>& lean, Threads& threads, InstructionSet set) {
    const Quarter q = quarter_of(cells, backward);
    const Levels levels(q);
    scratch.rays.resize(levels.first[q.top + 1] * 4 * q.stride);
    for (std::vector<float>& cones : scratch.cones)
        cones.resize(std::max(cones.size(), (static_cast<std::size_t>(q.rows) + (1u << q.top)) * 3 * q.stride));
    measure_cones(scratch.angles, q.top);
    trace_first(scratch, q, levels, threads, set);
    for (int n = 0; n < q.top; ++n) join(scratch, q, levels, n, threads, set);
    gather_top(scratch, q, levels, sky, threads, set);
    for (int n = q.top - 1; n >= 0; --n) gather(scratch, q, levels, n, sky, threads, set);
    parallel_for(threads, q.rows, kGrain, [&](std::size_t begin, std::size_t end) {
        for (int row = static_cast<int>(begin); row < static_cast<int>(end); ++row)
            for (int c = 0; c < 3; ++c) {
                const float* from = cone_row(scratch.cones[0], q, 0, row, 0) + c * q.stride;
                const int at = backward ? q.rows - 1 - row : row;
                const std::size_t first = (static_cast<std::size_t>(c) * q.rows + at) * q.stride;
                float* to = result.data() + first;
                for (int x = 0; x < q.width; ++x) to[x] += from[x];
                if (lean.empty()) continue;
                to = lean.data() + first;
                const float way = backward ? -kQuarterWay : kQuarterWay;
                for (int x = 0; x < q.width; ++x) to[x] += way * from[x];
            }
    });
}

constexpr int kBlock = 16; // cells: a square that stays in the nearest cache while it is turned

template <class Put> void each_turned(int width, int height, Threads& threads, Put&& put) {
    parallel_for(threads, height, kBlock, [&](std::size_t top, std::size_t bottom) {
        for (int left = 0; left < width; left += kBlock)
            for (int y = static_cast<int>(top); y < static_cast<int>(bottom); ++y)
                for (int x = left; x < std::min(left + kBlock, width); ++x) put(x, y);
    });
}

void turn(Cells& turned, const Cells& cells, Threads& threads) {
    turned.resize(cells.height, cells.width, cells.glows);
    for (int plane = 0; plane < cells.planes(); ++plane) {
        const float* from = cells.row(plane, 0);
        float* to = turned.row(plane, 0);
        each_turned(cells.width, cells.height, threads, [&](int x, int y) {
            to[static_cast<std::size_t>(x) * turned.stride + y] = from[static_cast<std::size_t>(y) * cells.stride + x];
        });
    }
}

} // namespace

void spread(Cascades& scratch, const Cells& cells, const Sky& sky, const Found& found, Threads& threads,
            InstructionSet set) {
    const int width = cells.width, height = cells.height;
    turn(scratch.turned, cells, threads);
    const Cells* ways[2] = {&cells, &scratch.turned};
    for (int way = 0; way < 2; ++way) {
        std::vector<float>& result = scratch.results[way];
        result.assign(3 * static_cast<std::size_t>((ways[way]->width + 7) / 8 * 8) * ways[way]->height, 0.0f);
        scratch.leans[way].assign(found.across[0] ? result.size() : 0, 0.0f);
        for (const bool backward : {false, true})
            add_quarter(scratch, *ways[way], backward, sky, result, scratch.leans[way], threads, set);
    }
    const std::size_t straight = static_cast<std::size_t>((width + 7) / 8 * 8),
                      turned = static_cast<std::size_t>((height + 7) / 8 * 8);
    for (int c = 0; c < 3; ++c) {
        const float* one = scratch.results[0].data() + c * straight * height;
        const float* other = scratch.results[1].data() + c * turned * width;
        each_turned(width, height, threads, [&](int x, int y) {
            found.light[c][static_cast<std::size_t>(y) * found.stride + x] =
                one[y * straight + x] + other[x * turned + y];
        });
        if (!found.across[0]) continue;
        one = scratch.leans[0].data() + c * straight * height, other = scratch.leans[1].data() + c * turned * width;
        each_turned(width, height, threads, [&](int x, int y) {
            const std::size_t at = static_cast<std::size_t>(y) * found.stride + x;
            found.down[c][at] = one[y * straight + x], found.across[c][at] = other[x * turned + y];
        });
    }
}

} // namespace evil::light
