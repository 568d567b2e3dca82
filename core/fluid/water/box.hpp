#pragma once
// Upright boxes round areas and what lies in them.
#include "forces/forces.hpp"

namespace evil::fluid {

struct Box {
    Vec2 low, high;
    bool holds(Vec2 p) const { return p.x >= low.x && p.y >= low.y && p.x <= high.x && p.y <= high.y; }
};

inline Box box_of(const Area& area) {
    const Vec2 r{area.radius, area.radius};
    if (area.radius > 0.0f) return {area.centre - r, area.centre + r};
    Box box{area.parts[0][0], area.parts[0][0]};
    for (const auto& part : area.parts)
        for (Vec2 corner : part) box.low = min(box.low, corner), box.high = max(box.high, corner);
    return box;
}

} // namespace evil::fluid
