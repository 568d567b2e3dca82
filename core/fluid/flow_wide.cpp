#include "fluid/flow_wide.hpp"
#include "fluid/spots_wide.hpp"

namespace evil::EVIL_ISA {

using fluid::Faces;
using fluid::Plan;

void centre_flow(const Plan& plan, const float* u, const float* v, float* x, float* y, int first, int last) noexcept {
    for (int j = first; j < last; ++j)
        for (int i = 0; i < plan.nx; i += kLanes) {
            const std::ptrdiff_t at = j * plan.stride + i;
            store(x + at, Floats(0.5f) * (load(u + at) + load(u + at + 1)));
            store(y + at, Floats(0.5f) * (load(v + at) + load(v + at + plan.stride)));
        }
}

void trace_back(const Plan& plan, const float* x, const float* y, float cells, float* dx, float* dy, int first,
                int last) noexcept {
    for (int j = first; j < last; ++j) {
        const Floats row(static_cast<float>(j));
        float *to_x = dx + j * plan.stride, *to_y = dy + j * plan.stride;
        for (int i = 0; i < plan.nx; i += kLanes) {
            const std::ptrdiff_t at = j * plan.stride + i;
            const Floats half(0.5f * cells);
            const Spots middle = spots_of(columns_from(i) - half * load(x + at), row - half * load(y + at), plan.nx,
                                          plan.ny, plan.stride);
            const int count = lanes_of(i, plan.nx);
            store_first(to_x + i, count, Floats(cells) * between(corners(x, middle, plan.stride), middle.s, middle.t));
            store_first(to_y + i, count, Floats(cells) * between(corners(y, middle, plan.stride), middle.s, middle.t));
        }
        to_x[-1] = to_x[0], to_y[-1] = to_y[0]; // for the faces at the edges
        to_x[plan.nx] = to_x[plan.nx - 1], to_y[plan.nx] = to_y[plan.nx - 1];
    }
}

void carry_faces(const Plan& plan, const Faces& f, const float* dx, const float* dy, int first, int last) noexcept {
    for (int j = first; j < last; ++j)
        for (int i = 0; i < f.columns; i += kLanes) {
            const std::ptrdiff_t at = j * plan.stride + i;
            const Floats x = columns_from(i) - Floats(0.5f) * (load(dx + at) + load(dx + at - f.beside));
            const Floats y = Floats(static_cast<float>(j)) - Floats(0.5f) * (load(dy + at) + load(dy + at - f.beside));
            const Spots from = spots_of(x, y, f.columns, f.rows, plan.stride);
            const Corners four = corners(f.value, from, plan.stride);
            const int count = lanes_of(i, f.columns);
            store_first(f.carried + at, count, between(four, from.s, from.t));
            store_first(f.low + at, count, least_of(four));
            store_first(f.high + at, count, most_of(four));
        }
}

void correct_faces(const Plan& plan, const Faces& f, const float* dx, const float* dy, int first, int last) noexcept {
    for (int j = first; j < last; ++j)
        for (int i = 0; i < f.columns; i += kLanes) {
            const std::ptrdiff_t at = j * plan.stride + i;
            const Floats x = columns_from(i) + Floats(0.5f) * (load(dx + at) + load(dx + at - f.beside));
            const Floats y = Floats(static_cast<float>(j)) + Floats(0.5f) * (load(dy + at) + load(dy + at - f.beside));
            const Spots to = spots_of(x, y, f.columns, f.rows, plan.stride);
            const Floats back = between(corners(f.carried, to, plan.stride), to.s, to.t);
            const Floats value = load(f.carried + at) + Floats(0.5f) * (load(f.value + at) - back);
            store_first(f.result + at, lanes_of(i, f.columns), clamp(value, load(f.low + at), load(f.high + at)));
        }
}

void find_inflow(const Plan& plan, const float* u, const float* v, const float* across, const float* up, float* b,
                 int first, int last) noexcept {
    for (int j = first; j < last; ++j)
        for (int i = 0; i < plan.nx; i += kLanes) {
            const std::ptrdiff_t at = j * plan.stride + i, above = at + plan.stride;
            const Floats sideways = load(across + at) * load(u + at) - load(across + at + 1) * load(u + at + 1);
            const Floats upward = load(up + at) * load(v + at) - load(up + above) * load(v + above);
            store_first(b + at, lanes_of(i, plan.nx), sideways + upward);
        }
}

float sum_of(const float* values, int count) noexcept {
    Floats all(0.0f);
    for (int i = 0; i < count; i += kLanes) all += load_first(values + i, lanes_of(i, count));
    return sum(all);
}

void add_to_each(float* values, int count, float more) noexcept {
    for (int i = 0; i < count; i += kLanes)
        store_first(values + i, lanes_of(i, count), load_first(values + i, lanes_of(i, count)) + Floats(more));
}

void push_by_pressure(const Plan& plan, const float* p, const float* across, const float* up, float* u, float* v,
                      int first, int last) noexcept {
    auto push = [&](std::ptrdiff_t at, std::ptrdiff_t beside, const float* share, float* value, int count,
                    float scale) {
        const Floats pushed = load(value + at) - Floats(scale) * (load(p + at) - load(p + at - beside));
        store_first(value + at, count, select(load(share + at) > 0.0f, pushed, Floats(0.0f)));
    };
    for (int j = first; j < last; ++j) { // beyond the grid p is 0, half a cell from an open side
        for (int i = 0; i < plan.nx; i += kLanes) {
            const int count = lanes_of(i, plan.nx);
            if (j < plan.ny) push(j * plan.stride + i, 1, across, u, count, 1.0f);
            push(j * plan.stride + i, plan.stride, up, v, count, j == 0 || j == plan.ny ? 2.0f : 1.0f);
        }
        if (j == plan.ny) continue;
        const std::ptrdiff_t left = j * plan.stride, right = left + plan.nx;
        u[left] = across[left] > 0.0f ? u[left] - p[left] : 0.0f; // the other half of it
        u[right] = across[right] > 0.0f ? u[right] + 2.0f * p[right - 1] : 0.0f;
    }
}

void reflect(const float* after, float* before, std::ptrdiff_t count) noexcept {
    std::ptrdiff_t i = 0;
    for (; i + kLanes <= count; i += kLanes) store(before + i, Floats(2.0f) * load(after + i) - load(before + i));
    for (; i < count; ++i) before[i] = 2.0f * after[i] - before[i];
}

void lift_faces(const float* here, const float* beside, float lift, float wind, float pull, float most, int count,
                float* value) noexcept {
    for (int i = 0; i < count; i += kLanes) {
        const Floats now = load(value + i);
        const Floats lifted = now + Floats(lift) * (Floats(0.5f) * (load(here + i) + load(beside + i))) +
                              Floats(pull) * (Floats(wind) - now);
        store_first(value + i, lanes_of(i, count), clamp(lifted, -most, most));
    }
}

void find_curl(const Plan& plan, const float* x, const float* y, float* curl, int first, int last) noexcept {
    for (int j = first; j < last; ++j) {
        const std::ptrdiff_t above = j + 1 < plan.ny ? plan.stride : 0, below = j > 0 ? plan.stride : 0;
        for (int i = 0; i < plan.nx; i += kLanes) {
            const std::ptrdiff_t at = j * plan.stride + i;
            store_first(curl + at, lanes_of(i, plan.nx),
                        Floats(0.5f) *
                            (load(y + at + 1) - load(y + at - 1) - (load(x + at + above) - load(x + at - below))));
        }
        curl[j * plan.stride] = 0.0f; // the columns at the edges have no neighbour
        curl[j * plan.stride + plan.nx - 1] = 0.0f;
    }
}

void keep_whirls(const Plan& plan, const float* curl, float strength, float* x, float* y, int first,
                 int last) noexcept {
    for (int j = first; j < last; ++j) {
        const std::ptrdiff_t above = j + 1 < plan.ny ? plan.stride : 0, below = j > 0 ? plan.stride : 0;
        for (int i = 0; i < plan.nx; i += kLanes) {
            const std::ptrdiff_t at = j * plan.stride + i;
            const Floats gx = abs(load(curl + at + 1)) - abs(load(curl + at - 1));
            const Floats gy = abs(load(curl + at + above)) - abs(load(curl + at - below));
            const Floats push = Floats(strength) * load(curl + at) / (sqrt(gx * gx + gy * gy) + Floats(1e-5f));
            store_first(x + at, lanes_of(i, plan.nx), gy * push);
            store_first(y + at, lanes_of(i, plan.nx), -(gx * push));
        }
    }
}

void add_means(const float* here, const float* beside, int count, float* to) noexcept {
    for (int i = 0; i < count; i += kLanes)
        store_first(to + i, lanes_of(i, count), load(to + i) + Floats(0.5f) * (load(here + i) + load(beside + i)));
}

void thicken(const Plan& plan, const float* wanted, const float* now, const float* share, float a, float factor,
             int first_column, int last_column, int first, int last, float* before) noexcept {
    const Floats scale(1.0f / (1.0f + 4.0f * a));
    for (int j = first; j < last; ++j)
        for (int i = first_column; i < last_column; i += kLanes) {
            const std::ptrdiff_t at = j * plan.stride + i;
            const Floats round =
                load(now + at - 1) + load(now + at + 1) + (load(now + at - plan.stride) + load(now + at + plan.stride));
            const Floats sweep = scale * (load(wanted + at) + Floats(a) * round), old = load(before + at);
            const Floats better = old + Floats(factor) * (sweep - old);
            store_first(before + at, lanes_of(i, last_column), select(load(share + at) > 0.0f, better, load(now + at)));
        }
}

void publish_flow(const Plan& plan, const float* u, const float* v, float* out, int first, int last) noexcept {
    for (int j = first; j < last; ++j)
        for (int i = 0; i < plan.nx; i += kLanes) {
            const std::ptrdiff_t at = j * plan.stride + i;
            const Floats x = Floats(0.5f) * (load(u + at) + load(u + at + 1));
            const Floats y = Floats(0.5f) * (load(v + at) + load(v + at + plan.stride));
            float pairs[2 * kLanes];
            float* to = out + 2 * (static_cast<std::ptrdiff_t>(j) * plan.nx + i);
            if (i + kLanes <= plan.nx) {
                store_pairs(to, x, y);
                continue;
            }
            store_pairs(pairs, x, y);
            for (int k = 0; k < 2 * (plan.nx - i); ++k) to[k] = pairs[k];
        }
}

} // namespace evil::EVIL_ISA
