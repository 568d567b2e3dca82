// Viscosity and diffusion: what gas evens out by itself. Both cost nothing while they are 0.
#include "fluid/flow.hpp"
#include <algorithm>
#include <cmath>

namespace evil::fluid {
namespace {

constexpr float kErrorLeft = 1e-4f; // of the error of an implicit step
constexpr int kMostSweeps = 120;    // enough for 400 cells of spread a step; honey beyond stays a little thinner
constexpr float kStable = 0.2f;     // share that a cell may give each neighbour in an explicit step
constexpr int kMostParts = 32;      // explicit steps in one: then nearly all is even, however strong diffusion is

struct Component {
    Field &value, &spare, &wanted;
    const Field& share;
    int first_column, last_column, first_row, last_row; // that may change: not those on the box's sides
    Side low, high;                                     // along which it slides
    std::ptrdiff_t beside;                              // from a number to what lies beyond these sides
};

// Beyond a closed side, what makes the mean with the number before it the side's own speed; beyond an open one the same.
void set_beyond(const Smoke& smoke, const Component& c, Field& field) {
    const Grid& g = smoke.grid;
    auto beyond = [&](Side side, std::ptrdiff_t inside, std::ptrdiff_t outside) {
        field[outside] =
            smoke.open[side] || !smoke.stick ? field[inside] : 2.0f * smoke.side_speeds[side] - field[inside];
    };
    const bool rows = c.beside == g.stride;
    const int count = rows ? g.nx + 1 : g.ny + 1, last = rows ? g.ny - 1 : g.nx - 1;
    for (int k = 0; k < count; ++k) {
        const std::ptrdiff_t low = rows ? g.at(k, 0) : g.at(0, k), high = rows ? g.at(k, last) : g.at(last, k);
        beyond(c.low, low, low - c.beside);
        beyond(c.high, high, high + c.beside);
    }
}

// Jacobi sweeps with Chebyshev's factors (Golub and Varga 1961): as many as the error asks for.
void solve(const Step& step, const Component& c, float a) {
    const float slow = 4.0f * a / (1.0f + 4.0f * a), rate = slow / (1.0f + std::sqrt(1.0f - slow * slow));
    float factor = 1.0f, error = 1.0f;
    c.wanted = c.value, c.spare = c.value;
    for (int k = 0; k < kMostSweeps && error > kErrorLeft; ++k) {
        set_beyond(step.smoke, c, c.value);
        const auto rows = static_cast<std::size_t>(c.last_row - c.first_row);
        parallel_for(step.world.threads, rows, 16, [&](std::size_t first, std::size_t last) {
            EVIL_PICK(step.world.instruction_set, thicken)
            (step.plan(), c.wanted.data(), c.value.data(), c.share.data(), a, factor, c.first_column, c.last_column,
             c.first_row + static_cast<int>(first), c.first_row + static_cast<int>(last), c.spare.data());
        });
        c.value.swap(c.spare);
        factor = k == 0 ? 1.0f / (1.0f - 0.5f * slow * slow) : 1.0f / (1.0f - 0.25f * slow * slow * factor);
        error *= rate;
    }
}

void give_to_neighbours(const Grid& g, const float* from, const Field& room, float a, int first, int last, float* to) {
    for (int j = first; j < last; ++j)
        for (int i = 0; i < g.nx; ++i) {
            const std::ptrdiff_t at = g.at(i, j);
            if (room[at] == 0.0f) continue;
            const std::ptrdiff_t cell = 4 * (static_cast<std::ptrdiff_t>(j) * g.nx + i);
            auto take = [&](bool inside, std::ptrdiff_t face, std::ptrdiff_t other) {
                if (!inside || room[at + face] == 0.0f) return;
                for (int k = 0; k < 3; ++k) to[cell + k] += a * (from[cell + 4 * other + k] - from[cell + k]);
            };
            take(i > 0, -1, -1), take(i + 1 < g.nx, 1, 1);
            take(j > 0, -g.stride, -g.nx), take(j + 1 < g.ny, g.stride, g.nx);
        }
}

void spread(const Step& step, std::vector<float>& cells) {
    Scratch& s = step.scratch;
    const Grid& g = step.smoke.grid;
    const float whole = step.smoke.gas.diffusion * step.dt / (g.h * g.h);
    const int parts = std::clamp(static_cast<int>(std::ceil(std::min(whole, 1e6f) / kStable)), 1, kMostParts);
    const float a = std::min(whole / static_cast<float>(parts), kStable);
    for (int k = 0; k < parts; ++k) {
        std::ranges::copy(cells, s.cells.begin());
        rows(step, 0, [&](int first, int last) {
            give_to_neighbours(g, s.cells.data(), s.solids.room(), a, first, last, cells.data());
        });
    }
}

} // namespace

void thicken_flow(const Step& step) {
    Smoke& smoke = step.smoke;
    Scratch& s = step.scratch;
    const Grid& g = smoke.grid;
    if (smoke.gas.viscosity == 0.0f) return;
    const float a = smoke.gas.viscosity * step.dt / (g.h * g.h);
    solve(step, {smoke.u, s.u, s.carried, s.solids.across(), 1, g.nx, 0, g.ny, kBottom, kTop, g.stride}, a);
    solve(step, {smoke.v, s.v, s.carried, s.solids.up(), 0, g.nx, 1, g.ny, fluid::kLeft, kRight, 1}, a);
}

void spread_content(const Step& step) {
    if (step.smoke.gas.diffusion == 0.0f) return;
    spread(step, step.scratch.other_cells);
    if (!step.smoke.views->colour.empty()) spread(step, step.scratch.other_colours);
}

} // namespace evil::fluid
