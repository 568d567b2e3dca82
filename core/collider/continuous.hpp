#pragma once
// Fast bodies and walls (SPEC C8): no body's centre passes through what does not move.
#include "collider/contact.hpp"
#include <span>

namespace evil {

struct Path { // of a body's centre of mass within a step
    std::uint32_t body;
    Vec2 start;
};

// A body that moved farther than its own inner radius may have jumped a wall. Its centre's path is cast against all
// static shapes; one that it would cross stops the body where its inner circle touches. Its speed stays, so that the
// contacts of the next step take it over.
void stop_at_walls(std::span<const Path> paths, Bodies& bodies, const Shapes& shapes);

} // namespace evil
