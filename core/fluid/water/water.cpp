#include "fluid/rows.hpp"
#include "fluid/water/box.hpp"
#include "fluid/water/scratch.hpp"
#include <algorithm>

namespace evil::fluid {

Water::Water() = default;
Water::~Water() = default;

std::unique_ptr<Water> make_water(const Grid& grid, float particle_size) {
    auto water = std::make_unique<Water>();
    water->grid = grid;
    water->grid.stride = (grid.nx + 2 + 15) / 16 * 16; // two tiles: a coarser level halves them
    water->particle_size = particle_size;
    water->particles = std::make_shared<Particles>(0);
    water->liquids.resize(1);
    water->pressure.lay_out(water->grid);
    water->scratch = std::make_unique<WaterScratch>();
    return water;
}

WaterRef add_water(World& world, std::unique_ptr<Water> water) {
    Fluids& all = world.fluids;
    const std::uint32_t slot = add_row(world, all.water_slots, all.waters, std::move(water));
    return {slot, all.water_slots.generation(slot)};
}

void destroy_water(World& world, std::uint32_t water) {
    Fluids& all = world.fluids;
    for (std::uint32_t i = 0; i < all.stream_slots.size(); ++i)
        if (all.stream_slots.taken(i) && all.streams[i].water == water) {
            all.streams[i] = {};
            all.stream_slots.release(i);
        }
    all.waters[water].reset();
    all.water_slots.release(water);
}

float heaviest(const Water& water) {
    float most = 0.0f;
    for (const Liquid& liquid : water.liquids) most = std::max(most, liquid.density);
    return most;
}

bool make_room(Water& water, std::size_t count) {
    if (count > kMostParticles) return false;
    const Particles& now = *water.particles;
    if (count <= now.capacity) return true;
    auto more =
        std::make_shared<Particles>(std::min(std::max<std::size_t>({256, 2 * now.capacity, count}), kMostParticles));
    const auto n = static_cast<std::ptrdiff_t>(water.count);
    std::copy_n(now.positions.begin(), 2 * n, more->positions.begin());
    std::copy_n(now.velocities.begin(), 2 * n, more->velocities.begin());
    std::copy_n(now.affine.begin(), 4 * n, more->affine.begin());
    std::copy_n(now.liquid.begin(), n, more->liquid.begin());
    water.particles = std::move(more);
    return true;
}

std::size_t fill(World& world, Water& water, const Area& area, std::uint32_t liquid, Vec2 velocity) {
    const Grid& g = water.grid;
    const float size = water.particle_size;
    const int wide = static_cast<int>(kCellsOfParticle) * g.nx, high = static_cast<int>(kCellsOfParticle) * g.ny;
    auto place = [&](float at, int most) {
        return static_cast<int>(std::clamp(at / size, 0.0f, static_cast<float>(most)));
    };
    std::vector<bool> full(static_cast<std::size_t>(wide) * static_cast<std::size_t>(high), false);
    auto spot = [&](int i, int j) {
        return static_cast<std::size_t>(j) * static_cast<std::size_t>(wide) + static_cast<std::size_t>(i);
    };
    for (std::size_t k = 0; k < water.count; ++k)
        full[spot(place(water.particles->positions[2 * k] - g.low.x, wide - 1),
                  place(water.particles->positions[2 * k + 1] - g.low.y, high - 1))] = true;
    update_banks(world, water);
    const Box box = box_of(area);
    const int left = place(box.low.x - g.low.x, wide - 1), right = place(box.high.x - g.low.x, wide - 1);
    const int low = place(box.low.y - g.low.y, high - 1), top = place(box.high.y - g.low.y, high - 1);
    std::size_t come = 0;
    for (int j = low; j <= top; ++j)
        for (int i = left; i <= right; ++i) {
            const Vec2 at = g.low + size * Vec2{static_cast<float>(i) + 0.5f, static_cast<float>(j) + 0.5f};
            if (full[spot(i, j)] || !contains(area, at) ||
                g.h * bank_at(water, (at.x - g.low.x) / g.h, (at.y - g.low.y) / g.h).distance < 0.25f * size)
                continue;
            if (!make_room(water, water.count + 1)) return come;
            Particles& p = *water.particles;
            const std::size_t k = water.count++;
            p.positions[2 * k] = at.x, p.positions[2 * k + 1] = at.y;
            p.velocities[2 * k] = velocity.x, p.velocities[2 * k + 1] = velocity.y;
            std::fill_n(p.affine.begin() + static_cast<std::ptrdiff_t>(4 * k), 4, 0.0f);
            p.liquid[k] = static_cast<std::uint8_t>(liquid);
            ++come;
        }
    return come;
}

} // namespace evil::fluid
