#pragma once
// What bodies close of cells' faces, and so take part in what flows out of the cells.
#include "fluid/water/scratch.hpp"
#include "world.hpp"
#include <cmath>

namespace evil::fluid {

class Finder {
public:
    Finder(const World& world, const Water& water) : world_(world), s_(*water.scratch), g_(water.grid) {}

    // What bodies close of a cell's faces.
    std::span<const Reach> look_at(int i, int j) {
        const std::ptrdiff_t at = g_.at(i, j), s = g_.stride;
        at_ = at, count_ = 0;
        const Field &across = s_.solids.across(), &up = s_.solids.up();
        const auto x = static_cast<float>(i), y = static_cast<float>(j);
        if (i > 0) add(1.0f - across[at], at, at + s, {-1.0f, 0.0f}, {x, y + 0.5f});
        if (i + 1 < g_.nx) add(1.0f - across[at + 1], at + 1, at + s + 1, {1.0f, 0.0f}, {x + 1.0f, y + 0.5f});
        if (j > 0) add(1.0f - up[at], at, at + 1, {0.0f, -1.0f}, {x + 0.5f, y});
        if (j + 1 < g_.ny) add(1.0f - up[at + s], at + s, at + s + 1, {0.0f, 1.0f}, {x + 0.5f, y + 1.0f});
        return {found_, static_cast<std::size_t>(count_)};
    }

private:
    // A face between two corners of cells, its direction out of the cell. What a body closes of it is at one of its ends.
    void add(float closed, std::ptrdiff_t a, std::ptrdiff_t b, Vec2 out, Vec2 middle) {
        if (closed <= 0.0f) return;
        const Field &distance = s_.solids.distance(), &owner = s_.solids.owner();
        const float aside = 0.5f * (1.0f - closed) * (distance[a] < distance[b] ? -1.0f : 1.0f);
        middle += aside * Vec2{std::abs(out.y), std::abs(out.x)};
        const float number = distance[a] < distance[b] ? owner[a] : owner[b];
        if (number == 0.0f) return;
        const std::uint32_t slot = static_cast<std::uint32_t>(number) - 1;
        const Body& body = world_.bodies.rows[slot];
        if (!moves(body)) return;
        int k = 0;
        while (k < count_ && found_[k].body != slot) ++k;
        if (k == count_) found_[count_++] = {static_cast<std::int32_t>(at_), 0.0f, 0.0f, 0.0f, slot};
        const Vec2 arm = g_.low + g_.h * middle - body.centre;
        found_[k].x += closed * out.x;
        found_[k].y += closed * out.y;
        found_[k].turn += closed * cross(arm, out);
    }

    const World& world_;
    const WaterScratch& s_;
    const Grid& g_;
    Reach found_[4];
    std::ptrdiff_t at_ = 0;
    int count_ = 0;
};

} // namespace evil::fluid
