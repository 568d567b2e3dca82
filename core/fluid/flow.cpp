#include "fluid/flow.hpp"
#include "world.hpp"
#include <algorithm>
#include <cmath>

namespace evil::fluid {
namespace {

void carry(const Step& step, Field& value, Field& result, bool across) {
    Scratch& s = step.scratch;
    const Plan plan = step.plan();
    const Faces faces{across ? plan.nx + 1 : plan.nx,
                      across ? plan.ny : plan.ny + 1,
                      across ? 1 : plan.stride,
                      value.data(),
                      s.carried.data(),
                      s.low.data(),
                      s.high.data(),
                      result.data()};
    const InstructionSet set = step.world.instruction_set;
    rows(step, across ? 0 : 1,
         [&](int first, int last) { EVIL_PICK(set, carry_faces)(plan, faces, s.dx.data(), s.dy.data(), first, last); });
    rows(step, across ? 0 : 1, [&](int first, int last) {
        EVIL_PICK(set, correct_faces)(plan, faces, s.dx.data(), s.dy.data(), first, last);
    });
    value.swap(result);
}

// What comes in by an open side was air outside, which moves as the wind does: it brings no other momentum. A jet that blew
// in as it likes would gain speed without end.
void let_in(const Step& step, Side side) {
    Smoke& smoke = step.smoke;
    const Grid& g = smoke.grid;
    const bool across = side == kLeft || side == kRight, low = side == kLeft || side == kBottom;
    const int deep = across ? g.nx : g.ny, along = across ? g.ny : g.nx;
    const auto at = [&](int inwards, int beside) { return across ? g.at(inwards, beside) : g.at(beside, inwards); };
    Field &through = across ? smoke.u : smoke.v, &beside = across ? smoke.v : smoke.u;
    const Vec2 wind = smoke.gas.wind;
    const float wind_through = across ? wind.x : wind.y, wind_beside = across ? wind.y : wind.x;
    bool any = true;
    for (int k = 0; k < deep && any; ++k) {
        any = false;
        const int cell = low ? k : deep - 1 - k, face = low ? k : deep - k;
        for (int m = 0; m <= along; ++m) {
            const float way = (across ? step.scratch.dx : step.scratch.dy)[at(cell, std::min(m, along - 1))];
            const float share = std::min((low ? way : -way) - static_cast<float>(k), 1.0f); // that was outside
            if (!(share > 0.0f)) continue;
            any = true;
            if (m < along) through[at(face, m)] += share * (wind_through - through[at(face, m)]);
            beside[at(cell, m)] += share * (wind_beside - beside[at(cell, m)]);
        }
    }
}

Vec2 velocity_of(const Scratch& s, const Wall& wall) { return velocity_at(s.rides[wall.body], wall.place); }

// Root mean square over the cells with gas, a second.
float gathering(const Step& step) {
    const Grid& g = step.smoke.grid;
    const Field& gas = step.scratch.solids.open();
    double sum = 0.0, cells = 0.0;
    for (int j = 0; j < g.ny; ++j)
        for (int i = 0; i < g.nx; ++i) {
            const double b = double(step.scratch.inflow[g.at(i, j)]), open = double(gas[g.at(i, j)]);
            sum += open * b * b, cells += open;
        }
    return static_cast<float>(std::sqrt(sum / std::max(cells, 1.0)) / double(g.h));
}

} // namespace

void find_way(const Step& step, float dt) {
    Scratch& s = step.scratch;
    const Plan plan = step.plan();
    const InstructionSet set = step.world.instruction_set;
    rows(step, 0, [&](int first, int last) {
        EVIL_PICK(set, centre_flow)
        (plan, step.smoke.u.data(), step.smoke.v.data(), s.x.data(), s.y.data(), first, last);
    });
    rows(step, 0, [&](int first, int last) {
        EVIL_PICK(set, trace_back)
        (plan, s.x.data(), s.y.data(), dt / step.smoke.grid.h, s.dx.data(), s.dy.data(), first, last);
    });
    for (Field* way : {&s.dx, &s.dy}) { // beyond the edges as at them
        std::copy_n(way->data() - 1, plan.nx + 2, way->data() - plan.stride - 1);
        const float* top = way->data() + (plan.ny - 1) * plan.stride - 1;
        std::copy_n(top, plan.nx + 2, way->data() + plan.ny * plan.stride - 1);
    }
}

void carry_flow(const Step& step) {
    carry(step, step.smoke.u, step.scratch.u, true);
    carry(step, step.smoke.v, step.scratch.v, false);
    for (const Side side : {kLeft, kRight, kBottom, kTop})
        if (step.smoke.open[side]) let_in(step, side);
}

void drive(const Step& step) {
    Scratch& s = step.scratch;
    Smoke& smoke = step.smoke;
    const Plan plan = step.plan();
    const InstructionSet set = step.world.instruction_set;
    const Vec2 lift = (-smoke.gas.buoyancy * step.dt) * step.world.gravity;
    const float pull = smoke.gas.wind == Vec2{} ? 0.0f : std::min(smoke.gas.wind_pull * step.dt, 1.0f);
    const bool whirls = smoke.gas.vorticity > 0.0f;
    if (whirls) {
        rows(step, 0, [&](int first, int last) {
            EVIL_PICK(set, find_curl)(plan, s.x.data(), s.y.data(), s.curl.data(), first, last);
        });
        rows(step, 0, [&](int first, int last) {
            EVIL_PICK(set, keep_whirls)
            (plan, s.curl.data(), smoke.gas.vorticity * step.dt, s.x.data(), s.y.data(), first, last);
        });
    }
    rows(step, 1, [&](int first, int last) {
        for (int j = first; j < last; ++j) {
            const std::ptrdiff_t row = j * plan.stride, below = std::max(j - 1, 0) * plan.stride;
            const std::ptrdiff_t here = std::min(j, plan.ny - 1) * plan.stride;
            float *u = smoke.u.data() + row, *v = smoke.v.data() + row;
            if (whirls && j < plan.ny)
                EVIL_PICK(set, add_means)(s.x.data() + row + 1, s.x.data() + row, plan.nx - 1, u + 1);
            if (whirls) EVIL_PICK(set, add_means)(s.y.data() + here, s.y.data() + below, plan.nx, v);
            const float* heat = s.heat.data();
            if (j < plan.ny) EVIL_PICK(set, lift_faces)
            (heat + row, heat + row - 1, lift.x, smoke.gas.wind.x, pull, kMostFlow, plan.nx + 1, u);
            EVIL_PICK(set, lift_faces)
            (heat + here, heat + below, lift.y, smoke.gas.wind.y, pull, kMostFlow, plan.nx, v);
        }
    });
}

void gather_inflow(const Step& step) {
    Scratch& s = step.scratch;
    const Smoke& smoke = step.smoke;
    const Plan plan = step.plan();
    rows(step, 0, [&](int first, int last) {
        EVIL_PICK(step.world.instruction_set, find_inflow)
        (plan, smoke.u.data(), smoke.v.data(), s.solids.across().data(), s.solids.up().data(), s.inflow.data(), first,
         last);
    });
    for (const Wall& wall : s.solids.walls_across()) {
        const float flow = wall.closed * velocity_of(s, wall).x;
        s.inflow[wall.at] += flow;
        s.inflow[wall.at - 1] -= flow;
    }
    for (const Wall& wall : s.solids.walls_up()) {
        const float flow = wall.closed * velocity_of(s, wall).y;
        s.inflow[wall.at] += flow;
        s.inflow[wall.at - plan.stride] -= flow;
    }
    // what bodies pump into a sealed pocket is spread evenly, or no pressure could balance it
    s.solids.pockets().level(smoke.grid, s.inflow, step.world.instruction_set, step.world.threads);
}

void project(const Step& step, Field& pressure) {
    Scratch& s = step.scratch;
    Smoke& smoke = step.smoke;
    const Plan plan = step.plan();
    const InstructionSet set = step.world.instruction_set;
    const float *across = s.solids.across().data(), *up = s.solids.up().data();
    gather_inflow(step);
    s.pressure.solve(smoke.grid, s.inflow, pressure, kCycles, set, step.world.threads);
    s.solids.pockets().level(smoke.grid, pressure, set, step.world.threads);
    rows(step, 1, [&](int first, int last) {
        EVIL_PICK(set, push_by_pressure)
        (plan, pressure.data(), across, up, smoke.u.data(), smoke.v.data(), first, last);
    });
    for (const Wall& wall : s.solids.walls_across())
        if (across[wall.at] == 0.0f) smoke.u[wall.at] = velocity_of(s, wall).x;
    for (const Wall& wall : s.solids.walls_up())
        if (up[wall.at] == 0.0f) smoke.v[wall.at] = velocity_of(s, wall).y;
}

void watch(const Step& step) {
    Scratch& s = step.scratch;
    if (!s.watched) return;
    s.gathering = {gathering(step), 0.0f};
    gather_inflow(step);
    s.gathering.after = gathering(step);
}

void show(const Step& step) {
    float* out = step.smoke.views->velocity.data();
    rows(step, 0, [&](int first, int last) {
        EVIL_PICK(step.world.instruction_set, publish_flow)
        (step.plan(), step.smoke.u.data(), step.smoke.v.data(), out, first, last);
    });
}

// A velocity that was written differs from what the faces say: both faces take half of that.
void take_over(const Step& step) {
    Smoke& smoke = step.smoke;
    Views& views = *smoke.views;
    const Grid& g = smoke.grid;
    std::vector<float>& written = step.scratch.cells;
    written.resize(std::max(written.size(), views.velocity.size()));
    std::copy(views.velocity.begin(), views.velocity.end(), written.begin());
    show(step);
    for (int j = 0; j < g.ny; ++j)
        for (int i = 0; i < g.nx; ++i) {
            const std::size_t at = 2 * static_cast<std::size_t>(j * g.nx + i);
            const Vec2 now = clamped({written[at], written[at + 1]}, kMostFlow);
            const float more_x = now.x - views.velocity[at], more_y = now.y - views.velocity[at + 1];
            if (more_x != 0.0f) {
                smoke.u[g.at(i, j)] += i > 0 ? 0.5f * more_x : more_x;
                smoke.u[g.at(i + 1, j)] += i + 1 < g.nx ? 0.5f * more_x : more_x;
            }
            if (more_y != 0.0f) {
                smoke.v[g.at(i, j)] += j > 0 ? 0.5f * more_y : more_y;
                smoke.v[g.at(i, j + 1)] += j + 1 < g.ny ? 0.5f * more_y : more_y;
            }
        }
}

} // namespace evil::fluid
