#include "fluid/stam.hpp"
#include <algorithm>
#include <cmath>

namespace evil::fluid {
namespace {

enum class Edge {
    copy,
    mirror_x,
    mirror_y
}; // what the layer round the box holds: the same, or what cancels a velocity

struct Box {
    int nx, ny;
    std::size_t at(int i, int j) const {
        return static_cast<std::size_t>(j) * static_cast<std::size_t>(nx + 2) + static_cast<std::size_t>(i);
    }
    std::size_t size() const { return static_cast<std::size_t>(nx + 2) * static_cast<std::size_t>(ny + 2); }
};

// The boundary layer (thesis 4.5.5): walls throw back the velocity through them.
void set_edges(const Box& box, Edge edge, std::span<float> x) {
    const float across = edge == Edge::mirror_x ? -1.0f : 1.0f, up = edge == Edge::mirror_y ? -1.0f : 1.0f;
    for (int j = 1; j <= box.ny; ++j) {
        x[box.at(0, j)] = across * x[box.at(1, j)];
        x[box.at(box.nx + 1, j)] = across * x[box.at(box.nx, j)];
    }
    for (int i = 1; i <= box.nx; ++i) {
        x[box.at(i, 0)] = up * x[box.at(i, 1)];
        x[box.at(i, box.ny + 1)] = up * x[box.at(i, box.ny)];
    }
    for (int j : {0, box.ny + 1})
        for (int i : {0, box.nx + 1})
            x[box.at(i, j)] = 0.5f * (x[box.at(i == 0 ? 1 : box.nx, j)] + x[box.at(i, j == 0 ? 1 : box.ny)]);
}

// x - a * (sum of the four neighbours - 4 x) = before, by Gauss-Seidel; a = rate * dt / h^2.
void sweep(const Box& box, Edge edge, std::span<float> x, std::span<const float> before, float a, float c) {
    for (int k = 0; k < kSweeps; ++k) {
        for (int j = 1; j <= box.ny; ++j)
            for (int i = 1; i <= box.nx; ++i)
                x[box.at(i, j)] = (before[box.at(i, j)] + a * (x[box.at(i - 1, j)] + x[box.at(i + 1, j)] +
                                                               x[box.at(i, j - 1)] + x[box.at(i, j + 1)])) /
                                  c;
        set_edges(box, edge, x);
    }
}

void diffuse(const Box& box, Edge edge, std::span<float> x, std::span<const float> before, float a) {
    std::ranges::copy(before, x.begin());
    if (a > 0.0f) sweep(box, edge, x, before, a, 1.0f + 4.0f * a);
    set_edges(box, edge, x);
}

// Each cell's middle traced back by its velocity (cells a step), and what lay there, between four cells.
void advect(const Box& box, Edge edge, std::span<float> x, std::span<const float> before, std::span<const float> u,
            std::span<const float> v, float cells) {
    const float right = static_cast<float>(box.nx) + 0.5f, top = static_cast<float>(box.ny) + 0.5f;
    for (int j = 1; j <= box.ny; ++j)
        for (int i = 1; i <= box.nx; ++i) {
            const float from_x = std::clamp(static_cast<float>(i) - cells * u[box.at(i, j)], 0.5f, right);
            const float from_y = std::clamp(static_cast<float>(j) - cells * v[box.at(i, j)], 0.5f, top);
            const int a = static_cast<int>(from_x), b = static_cast<int>(from_y);
            const float s = from_x - static_cast<float>(a), t = from_y - static_cast<float>(b);
            x[box.at(i, j)] = (1.0f - s) * ((1.0f - t) * before[box.at(a, b)] + t * before[box.at(a, b + 1)]) +
                              s * ((1.0f - t) * before[box.at(a + 1, b)] + t * before[box.at(a + 1, b + 1)]);
        }
    set_edges(box, edge, x);
}

// What gathers in each cell: minus its divergence, times the side of a cell.
void gather(const Box& box, std::span<const float> u, std::span<const float> v, std::span<float> divergence) {
    for (int j = 1; j <= box.ny; ++j)
        for (int i = 1; i <= box.nx; ++i)
            divergence[box.at(i, j)] =
                -0.5f * (u[box.at(i + 1, j)] - u[box.at(i - 1, j)] + v[box.at(i, j + 1)] - v[box.at(i, j - 1)]);
}

float root_mean_square(const Box& box, std::span<const float> x) {
    double sum = 0.0;
    for (int j = 1; j <= box.ny; ++j)
        for (int i = 1; i <= box.nx; ++i) sum += double(x[box.at(i, j)]) * double(x[box.at(i, j)]);
    return static_cast<float>(std::sqrt(sum / (double(box.nx) * double(box.ny))));
}

// The part of the field without divergence (thesis 4.5.4: Helmholtz-Hodge): what is left without the pressure's gradient.
void project(const Box& box, std::span<float> u, std::span<float> v, std::span<float> pressure,
             std::span<float> divergence) {
    gather(box, u, v, divergence);
    std::ranges::fill(pressure, 0.0f);
    set_edges(box, Edge::copy, divergence);
    set_edges(box, Edge::copy, pressure);
    sweep(box, Edge::copy, pressure, divergence, 1.0f, 4.0f);
    for (int j = 1; j <= box.ny; ++j)
        for (int i = 1; i <= box.nx; ++i) {
            u[box.at(i, j)] -= 0.5f * (pressure[box.at(i + 1, j)] - pressure[box.at(i - 1, j)]);
            v[box.at(i, j)] -= 0.5f * (pressure[box.at(i, j + 1)] - pressure[box.at(i, j - 1)]);
        }
    set_edges(box, Edge::mirror_x, u);
    set_edges(box, Edge::mirror_y, v);
}

// One lane of rows of `lanes` floats, into the box and out of it.
void take(const Box& box, std::span<const float> from, int lanes, int lane, std::span<float> x) {
    std::size_t at = static_cast<std::size_t>(lane);
    for (int j = 1; j <= box.ny; ++j)
        for (int i = 1; i <= box.nx; ++i, at += static_cast<std::size_t>(lanes)) x[box.at(i, j)] = from[at];
}
void give(const Box& box, std::span<const float> x, std::span<float> to, int lanes, int lane) {
    std::size_t at = static_cast<std::size_t>(lane);
    for (int j = 1; j <= box.ny; ++j)
        for (int i = 1; i <= box.nx; ++i, at += static_cast<std::size_t>(lanes)) to[at] = x[box.at(i, j)];
}

} // namespace

void move_by_stam(const Grid& grid, float viscosity, float dt, std::span<float> velocity, StamScratch& s) {
    const Box box{grid.nx, grid.ny};
    for (auto* x : {&s.u, &s.v, &s.u_before, &s.v_before, &s.pressure, &s.divergence}) x->assign(box.size(), 0.0f);
    const float cells = dt / grid.h, a = viscosity * dt / (grid.h * grid.h);
    take(box, velocity, 2, 0, s.u_before);
    take(box, velocity, 2, 1, s.v_before);
    diffuse(box, Edge::mirror_x, s.u, s.u_before, a);
    diffuse(box, Edge::mirror_y, s.v, s.v_before, a);
    project(box, s.u, s.v, s.pressure, s.divergence);
    s.u_before.swap(s.u);
    s.v_before.swap(s.v);
    advect(box, Edge::mirror_x, s.u, s.u_before, s.u_before, s.v_before, cells);
    advect(box, Edge::mirror_y, s.v, s.v_before, s.u_before, s.v_before, cells);
    project(box, s.u, s.v, s.pressure, s.divergence);
    give(box, s.u, velocity, 2, 0);
    give(box, s.v, velocity, 2, 1);
}

Gathering gathered_by_stam(const Grid& grid, StamScratch& s) {
    const Box box{grid.nx, grid.ny};
    const float before = root_mean_square(box, s.divergence);
    gather(box, s.u, s.v, s.divergence);
    return {before / grid.h, root_mean_square(box, s.divergence) / grid.h};
}

void carry_by_stam(const Grid& grid, float diffusion, float dt, std::span<float> carried, int lanes, int used,
                   StamScratch& s) {
    const Box box{grid.nx, grid.ny};
    s.carried.assign(box.size(), 0.0f);
    s.carried_before.assign(box.size(), 0.0f);
    for (int lane = 0; lane < used; ++lane) {
        take(box, carried, lanes, lane, s.carried);
        diffuse(box, Edge::copy, s.carried_before, s.carried, diffusion * dt / (grid.h * grid.h));
        advect(box, Edge::copy, s.carried, s.carried_before, s.u, s.v, dt / grid.h);
        give(box, s.carried, carried, lanes, lane);
    }
}

} // namespace evil::fluid
