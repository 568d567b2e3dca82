#include "fluid/water/sampling.hpp"
#include <algorithm>
#include <cmath>

namespace evil::fluid {
namespace {

constexpr float kNear =
    0.75f; // of a particle: where one is so near, there is liquid; in still water the farthest point
           // from any is 0.71 away

int column(const Grid& g, float x) { return static_cast<int>(std::clamp((x - g.low.x) / g.h, 0.0f, float(g.nx - 1))); }
int row(const Grid& g, float y) { return static_cast<int>(std::clamp((y - g.low.y) / g.h, 0.0f, float(g.ny - 1))); }

} // namespace

WaterSampler::WaterSampler(const Water& water) : water_(water), first_(water.grid.cells() + 1), order_(water.count) {
    const Grid& g = water.grid;
    auto cell = [&](std::size_t k) {
        const float* p = &water.particles->positions[2 * k];
        return static_cast<std::size_t>(row(g, p[1]) * g.nx + column(g, p[0]));
    };
    for (std::size_t k = 0; k < water.count; ++k) ++first_[cell(k) + 1];
    for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t k = 0; k < water.count; ++k) order_[next[cell(k)]++] = static_cast<std::uint32_t>(k);
}

WaterSample WaterSampler::at(Vec2 point) const {
    const Grid& g = water_.grid;
    const Vec2 end = g.low + g.h * Vec2{static_cast<float>(g.nx), static_cast<float>(g.ny)};
    if (!(point.x >= g.low.x && point.y >= g.low.y && point.x <= end.x && point.y <= end.y)) return {};
    const Particles& p = *water_.particles;
    const int x = column(g, point.x), y = row(g, point.y);
    const float near = kNear * water_.particle_size;
    float weight = 0.0f, mass = 0.0f;
    Vec2 momentum;
    WaterSample sample;
    for (int j = std::max(y - 1, 0); j <= std::min(y + 1, g.ny - 1); ++j)
        for (int i = std::max(x - 1, 0); i <= std::min(x + 1, g.nx - 1); ++i) {
            const auto c = static_cast<std::size_t>(j * g.nx + i);
            for (std::uint32_t n = first_[c]; n < first_[c + 1]; ++n) {
                const std::size_t k = order_[n];
                const Vec2 to = Vec2{p.positions[2 * k], p.positions[2 * k + 1]} - point;
                sample.inside = sample.inside || length_squared(to) < near * near;
                const float w =
                    std::max(1.0f - std::abs(to.x) / g.h, 0.0f) * std::max(1.0f - std::abs(to.y) / g.h, 0.0f);
                weight += w;
                mass += w * water_.liquids[p.liquid[k]].density;
                momentum = momentum + w * Vec2{p.velocities[2 * k], p.velocities[2 * k + 1]};
            }
        }
    if (!(weight > 0.0f)) return sample;
    const float share = water_.particle_size / g.h; // particles are squares of that side, the weights sum to a cell
    sample.density = mass * share * share;
    sample.velocity = (1.0f / weight) * momentum;
    return sample;
}

float WaterSampler::depth(Vec2 point, Vec2 up) const {
    const float step = 0.5f * water_.particle_size;
    float deep = 0.0f;
    while (at(point + deep * up).inside) deep += step;
    return deep;
}

} // namespace evil::fluid
