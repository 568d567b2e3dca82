#pragma once
// Continuous collision (SPEC C8): what moves far in a step stops where it first meets something, rather than beyond it.
#include "collider/gjk.hpp"
#include "collider/path.hpp"
#include "collider/placed.hpp"
#include <span>

namespace evil {

struct Joints;

struct Continuous { // Scratch
    struct Fast {   // a body whose path must be looked at
        std::uint32_t body;
        Vec2 low, high;             // bounds of all that it sweeps
        double end = 1.0;           // the share of its motion that is left to it
        double hit = 2.0;           // when it first meets something; more than 1: never
        std::uint32_t wall = kNone; // the body that it meets then
        bool settled = false;
    };
    std::vector<Fast> fast;
    std::vector<Motion> motions;        // of each path
    std::vector<std::uint32_t> path_of; // by body; kNone: it did not move
    std::vector<std::uint32_t> fast_of; // by body; kNone: it is not fast
    struct Swept {                      // bounds of all that a piece sweeps over in the step
        Vec2 low, high;
        float right; // the farthest high.x up to here, in order of low.x
        std::uint32_t piece;
    };
    std::vector<Swept> walls, everything;  // sorted by low.x; the second only where there are bullets
    std::vector<Vec2> core;                // of the piece at hand
    std::vector<std::uint32_t> candidates; // pieces
};

// A body that moved so far that it may have jumped something is cast along its motion, turning and all: a bullet against
// everything, any other against what stands still or is kinematic. Where it meets a wall it stops, and goes with the wall
// for the rest of the step; two bullets stop both. Speeds stay as they are: the contacts of the next step take them over.
//
//     start o - - - - ->|o- - - > end       What is cast is a core a little smaller than the body (kSunk), so that
//                      wall                 what slides over the ground does not stumble, and touches when it stops.
void stop_in_time(Continuous& scratch, std::span<const Path> paths, const Placements& placed, Bodies& bodies,
                  const Shapes& shapes, const Joints& joints);

} // namespace evil
