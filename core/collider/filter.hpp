#pragma once
// Who meets whom: asked once for each new pair of pieces whose bounds meet.
#include "shapes/shapes.hpp"

namespace evil {

// Two sensors do not see each other. For the rest, a group that both are in decides; else both masks must agree.
inline bool may_meet(const Traits& s, const Traits& t) {
    if (s.sensor && t.sensor) return false;
    if (s.group != 0 && s.group == t.group) return s.group > 0;
    return (s.mask & t.category) != 0 && (t.mask & s.category) != 0;
}

// Would `wall` be in the way of `mover`, whose path goes along `path`? `turn` is how wall's body is turned. A platform
// that is solid from one side lets through what comes from the other.
inline bool blocks(const Traits& wall, Rot turn, const Traits& mover, Vec2 path) {
    if (wall.sensor || mover.sensor || !may_meet(wall, mover)) return false;
    if (wall.one_way != Vec2{} && dot(path, rotate(turn, wall.one_way)) >= 0.0f) return false;
    return true;
}

} // namespace evil
