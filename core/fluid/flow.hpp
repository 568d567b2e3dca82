#pragma once
// The parts of a smoke's step on the staggered grid, each on all rows, on all threads.
#include "fluid/flow_wide.hpp"
#include "fluid/scratch.hpp"
#include "world.hpp"

namespace evil::fluid {

inline constexpr float kMostFlow = 1e4f; // m/s: beyond it a step crosses any grid many times over

struct Step { // what all parts of one share
    Smoke& smoke;
    Scratch& scratch;
    World& world;
    float dt;
    Plan plan() const { return {smoke.grid.nx, smoke.grid.ny, smoke.grid.stride}; }
};

inline constexpr std::size_t kRows = 16; // that a thread takes at a time
inline constexpr int kCycles = 2; // of multigrid: leave less than 1% of the divergence, with the last step's pressure

// work(first, last) for all rows of the grid and so many more, in any order.
template <class Work> void rows(const Step& step, int more, Work work) {
    parallel_for(step.world.threads, static_cast<std::size_t>(step.smoke.grid.ny + more), kRows,
                 [&](std::size_t first, std::size_t last) { work(static_cast<int>(first), static_cast<int>(last)); });
}

void see_bodies(const Step& step); // as they move now
Vec2 velocity_at(const Ride& ride, Vec2 place);
void drag_bodies(const Step& step); // and gas by them
// Light bodies are pushed as the projection to come will push, `times` over; from then on they move so.
void take_along(const Step& step, const Field& pressure, float times);
void reflect_rides(const Step& step);

void find_way(const Step& step, float dt);       // the way that gas came within dt, from the velocity as it is
void carry_flow(const Step& step);               // the velocity along that way
void carry_content(const Step& step);            // all that gas carries, along it, into the scratch
void drive(const Step& step);                    // heat, wind, whirls
void thicken_flow(const Step& step);             // by viscosity
void spread_content(const Step& step);           // there, by diffusion
void settle_content(const Step& step);           // and back: fuel burns, heat and density are lost
void project(const Step& step, Field& pressure); // until nothing gathers anywhere, with the bodies moving as they do
void watch(const Step& step);                    // how good that was, if somebody asks
void gather_inflow(const Step& step);            // what flows into each cell, by gas and by bodies
void push_bodies(const Step& step);              // by pressure and drag
void show(const Step& step);                     // the velocity, to whoever looks
void take_over(const Step& step);                // what was written from outside, made finite

} // namespace evil::fluid
