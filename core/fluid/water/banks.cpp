// Where water may not be: the bodies' shapes, by their distances at the corners of cells.
#include "fluid/water/scratch.hpp"
#include "world.hpp"
#include <algorithm>

namespace evil::fluid {

void update_banks(const World& world, Water& water) {
    WaterScratch& s = *water.scratch;
    if (!s.laid_out) {
        s.laid_out = true;
        s.solids.lay_out(water.grid, water.open);
        s.faces.lay_out(water.grid, water.open);
    }
    s.solids.update(world, water.grid, s.faces, world.instruction_set);
}

float banks_distance(const Water& water, Vec2 at) {
    const Grid& g = water.grid;
    const Vec2 place = (1.0f / g.h) * (at - g.low);
    const float x = std::clamp(place.x, 0.0f, static_cast<float>(g.nx)),
                y = std::clamp(place.y, 0.0f, static_cast<float>(g.ny));
    const int i = std::min(static_cast<int>(x), g.nx - 1), j = std::min(static_cast<int>(y), g.ny - 1);
    const float s = x - static_cast<float>(i), t = y - static_cast<float>(j);
    const Field& d = water.scratch->solids.distance();
    const std::ptrdiff_t low = g.at(i, j), high = g.at(i, j + 1);
    const float below = d[low] + s * (d[low + 1] - d[low]), above = d[high] + s * (d[high + 1] - d[high]);
    return g.h * (below + t * (above - below));
}

} // namespace evil::fluid
