#include "fluid/sampling.hpp"
#include <algorithm>

namespace evil::fluid {

Sample sample(const Smoke& smoke, Vec2 at) {
    const Grid& g = smoke.grid;
    const Vec2 place = (1.0f / g.h) * (at - g.low) - Vec2{0.5f, 0.5f};
    const float right = static_cast<float>(g.nx - 1), top = static_cast<float>(g.ny - 1);
    if (!(place.x >= -0.5f && place.y >= -0.5f && place.x <= right + 0.5f && place.y <= top + 0.5f)) return {};
    const float x = std::clamp(place.x, 0.0f, right), y = std::clamp(place.y, 0.0f, top);
    const int i = std::min(static_cast<int>(x), g.nx - 2), j = std::min(static_cast<int>(y), g.ny - 2);
    const float s = x - static_cast<float>(i), t = y - static_cast<float>(j);
    Sample sum;
    for (int k = 0; k < 4; ++k) {
        const auto cell = static_cast<std::size_t>((j + k / 2) * g.nx + i + k % 2);
        const float share = (k % 2 ? s : 1.0f - s) * (k / 2 ? t : 1.0f - t);
        const Cell& content = smoke.views->content[cell];
        sum.density += share * content.density;
        sum.temperature += share * content.temperature;
        sum.fuel += share * content.fuel;
        sum.velocity =
            sum.velocity + share * Vec2{smoke.views->velocity[2 * cell], smoke.views->velocity[2 * cell + 1]};
    }
    return sum;
}

double mass_of(const Smoke& smoke) {
    double sum = 0.0;
    for (const Cell& cell : smoke.views->content) sum += double(cell.density);
    return sum * double(smoke.grid.h) * double(smoke.grid.h);
}

} // namespace evil::fluid
