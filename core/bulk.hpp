#pragma once
// Many bodies at once: what the public face does for one of them, without what need not be done for each.
// All arguments are checked before; `bodies` are live slots, `values` one for each of them.
#include "world.hpp"

namespace evil {

// How a body is to be made, apart from where it is and how it moves.
struct Recipe {
    Body row;
    std::vector<NewShape> shapes;
    Traits traits;
};

// What differs from body to body: as many as there are positions; what is empty is what the recipe says.
struct Starts {
    std::vector<Vec2> positions, velocities;
    std::vector<double> angles;
    std::vector<float> spins;
};

// All of them or, when the recipe has a problem with its mass, none.
[[nodiscard]] MassProblem add_many(World& world, const Recipe& recipe, const Starts& starts, const std::string& tag,
                                   std::vector<BodyRef>& added);

// A body whose value is what it was is left alone, asleep if it was; the others wake, and so does what touches them.
void set_positions(World& world, std::span<const std::uint32_t> bodies, std::span<const Vec2> values);
void set_angles(World& world, std::span<const std::uint32_t> bodies, std::span<const double> values);
void set_velocities(World& world, std::span<const std::uint32_t> bodies, std::span<const Vec2> values);
void set_spins(World& world, std::span<const std::uint32_t> bodies, std::span<const float> values);

// A body that is named twice is pushed twice. Without `points`, at the centre of mass.
void push_bodies(World& world, std::span<const std::uint32_t> bodies, std::span<const Vec2> forces,
                 std::span<const Vec2> points);
void kick_bodies(World& world, std::span<const std::uint32_t> bodies, std::span<const Vec2> impulses,
                 std::span<const Vec2> points);

} // namespace evil
