#pragma once
// What particles may run into: the pieces near them, by the cells of a grid, so that most particles ask nobody.
#include "collider/broad_phase.hpp"
#include <optional>

namespace evil {
struct World;
}

namespace evil::particles {

struct Obstacle {
    Piece piece;
    Pose before, now; // of its body, round the last step
    Bounds bounds;    // of both
    bool moved = false;
    Vec2 velocity, centre; // of its body
    float spin = 0.0f;
};

struct Obstacles { // Scratch
    std::vector<Obstacle> rows;
    Vec2 low;
    float per_metre = 1.0f; // cells
    int columns = 0, lines = 0;
    std::vector<std::uint32_t> first, items, places; // rows of each cell, one list after the other
    std::vector<float> from_x, from_y;               // where the particles were before the step
};

// The pieces of shapes in `mask`, sensors left out, that are or were within `bounds`.
void gather(Obstacles& obstacles, const World& world, const Bounds& bounds, std::uint32_t mask);

struct Touch {
    Vec2 point, normal; // out of the piece
    Vec2 velocity;      // of the piece there
};

// The first that the way from `start` to `end` enters, as seen from the pieces, which move too.
std::optional<Touch> first_touch(const Obstacles& obstacles, const World& world, Vec2 start, Vec2 end);

} // namespace evil::particles
