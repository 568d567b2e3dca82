// What gas carries: moved along with it, with its mass kept, let in and out by open sides; what becomes of it within a step.
#include "fluid/carry_wide.hpp"
#include "fluid/flow.hpp"
#include <algorithm>

namespace evil::fluid {
namespace {

constexpr float kAny = 3e38f; // no bound

void move_cells(const Step& step, float* cells, std::vector<float>& carried, std::vector<float>& result) {
    Scratch& s = step.scratch;
    const Plan plan = step.plan();
    const InstructionSet set = step.world.instruction_set;
    const float* open = s.solids.room().data();
    rows(step, 0, [&](int first, int last) {
        EVIL_PICK(set, carry_cells)(plan, cells, s.dx.data(), s.dy.data(), carried.data(), first, last);
    });
    rows(step, 0, [&](int first, int last) {
        EVIL_PICK(set, correct_cells)
        (plan, cells, carried.data(), s.dx.data(), s.dy.data(), open, result.data(), s.sums.data(), first, last);
    });
}

// visit(cell, share) for the cells at open sides: which share of a cell flows out by the side within the step; negative, in.
template <class Visit> void each_opening(const Step& step, Visit visit) {
    const Smoke& smoke = step.smoke;
    const Grid& g = smoke.grid;
    const float cells = step.dt / g.h;
    auto at = [&](int i, int j) { return static_cast<std::size_t>(j * g.nx + i); };
    for (int j = 0; j < g.ny; ++j) {
        if (smoke.open[kLeft]) visit(at(0, j), -cells * smoke.u[g.at(0, j)]);
        if (smoke.open[kRight]) visit(at(g.nx - 1, j), cells * smoke.u[g.at(g.nx, j)]);
    }
    for (int i = 0; i < g.nx; ++i) {
        if (smoke.open[kBottom]) visit(at(i, 0), -cells * smoke.v[g.at(i, 0)]);
        if (smoke.open[kTop]) visit(at(i, g.ny - 1), cells * smoke.v[g.at(i, g.ny)]);
    }
}

// Clear air comes in; the paths, which end at the edge, had brought the edge's own smoke. What that was, by density.
double let_in(const Step& step, float* cells) {
    double gone = 0.0;
    each_opening(step, [&](std::size_t at, float share) {
        if (!(share < 0.0f)) return;
        const float left = std::max(1.0f + share, 0.0f);
        gone += double((1.0f - left) * cells[4 * at]);
        for (std::size_t k = 0; k < 3; ++k) cells[4 * at + k] *= left;
    });
    return gone;
}

// Advection that follows paths keeps no sums. What it gains or loses within a step, a small share, is taken from all alike.
float correction(const Step& step, double lost, double gone) {
    constexpr double kMost = 0.02; // of it; beyond, something was covered or torn that no factor mends
    double before = -lost, after = -gone;
    for (int j = 0; j < step.smoke.grid.ny; ++j) {
        before += double(step.scratch.sums[static_cast<std::size_t>(2 * j)]);
        after += double(step.scratch.sums[static_cast<std::size_t>(2 * j + 1)]);
    }
    return after > 0.0 ? static_cast<float>(std::clamp(before / after, 1.0 - kMost, 1.0 + kMost)) : 1.0f;
}

// What is left of something that loses a share of itself a second.
float kept(float share_a_second, float dt) { return 1.0f / (1.0f + share_a_second * dt); }

} // namespace

void carry_content(const Step& step) {
    Scratch& s = step.scratch;
    Views& views = *step.smoke.views;
    double lost = 0.0; // what leaves, of which correction is not to make up for
    each_opening(step, [&](std::size_t at, float share) {
        lost += double(std::clamp(share, 0.0f, 1.0f) * views.content[at].density);
    });
    move_cells(step, &views.content[0].density, s.cells, s.other_cells);
    s.correction = correction(step, lost, let_in(step, s.other_cells.data()));
    if (views.colour.empty()) return;
    s.colours.resize(views.colour.size()), s.other_colours.resize(views.colour.size());
    move_cells(step, views.colour.data(), s.colours, s.other_colours);
    let_in(step, s.other_colours.data());
}

void settle_content(const Step& step) {
    Scratch& s = step.scratch;
    Views& views = *step.smoke.views;
    const Gas& gas = step.smoke.gas;
    const bool in_place = step.smoke.method == Method::stam; // which moves it later
    const float by = s.correction, warm = kept(gas.cooling, step.dt), stays = kept(gas.fade, step.dt),
                unburnt = kept(gas.burning, step.dt);
    const Fate fate{
        {by, 1.0f, 1.0f, 1.0f}, {stays, warm, unburnt, 1.0f}, 1.0f - unburnt, gas.soot, gas.heat, kMostHeat};
    const Fate colours{{by, by, by, 1.0f}, {stays, stays, stays, 1.0f}, 0.0f, 0.0f, 0.0f, kAny};
    auto settle = [&](const Fate& what, const float* from, float* to, float* heat) {
        rows(step, 0, [&](int first, int last) {
            EVIL_PICK(step.world.instruction_set, settle_cells)
            (step.plan(), what, in_place ? to : from, to, heat, first, last);
        });
    };
    settle(fate, s.other_cells.data(), &views.content[0].density, in_place ? nullptr : s.heat.data());
    if (!views.colour.empty()) settle(colours, s.other_colours.data(), views.colour.data(), nullptr);
}

} // namespace evil::fluid
