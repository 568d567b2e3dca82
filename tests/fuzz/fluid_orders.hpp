#pragma once
// What a life of a world says to its fluids, within what their doors let through.
#include "bytes.hpp"
#include "fluid/sampling.hpp"
#include "fluid/water/pouring.hpp"
#include "fluid/water/sampling.hpp"
#include "world.hpp"
#include <cmath>
#include <cstdlib>
#include <optional>

namespace evil::fuzz {

inline std::optional<std::uint32_t> one_of(const Slots& slots, Bytes& in) {
    if (slots.count() == 0) return {};
    std::uint32_t slot = in.byte() % slots.size();
    while (!slots.taken(slot)) slot = (slot + 1) % slots.size();
    return slot;
}

inline std::uint32_t carrier(const World& world, Bytes& in) { // of a source or a stream; mostly none
    if (in.byte() % 4) return kNone;
    return one_of(world.bodies.slots, in).value_or(kNone);
}

inline Area area_of(Bytes& in) {
    Area area;
    area.centre = in.point(1e4f);
    if (in.byte() % 2) {
        area.radius = in.size();
        return area;
    }
    const Vec2 half{in.size(), in.size()}, at = area.centre;
    area.centre = {};
    area.parts = {{at - half, {at.x + half.x, at.y - half.y}, at + half, {at.x - half.x, at.y + half.y}}};
    return area;
}

inline fluid::Grid grid_of(Bytes& in) { // small, so that a step takes a moment
    const Vec2 low = in.point(1e4f);
    const int nx = 2 + in.byte() % 31, ny = 2 + in.byte() % 31;
    return fluid::grid_of(nx, ny, low, in.byte() % 16 == 0 ? in.size() : 0.2f);
}

inline std::array<bool, 4> sides(Bytes& in) {
    const int bits = in.byte();
    return {(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0, (bits & 8) != 0};
}

inline void make_smoke(World& world, Bytes& in) {
    if (world.fluids.smoke_slots.count() >= 3) return;
    auto smoke = fluid::make_smoke(grid_of(in), in.byte() % 4 ? fluid::Method::staggered : fluid::Method::stam);
    smoke->quality = in.byte() % 2 ? fluid::Quality::high : fluid::Quality::fast;
    smoke->open = sides(in);
    smoke->side_speeds[in.byte() % 4] = in.number(1e4f);
    fluid::Gas& gas = smoke->gas;
    for (float* share : {&gas.viscosity, &gas.diffusion, &gas.cooling, &gas.fade, &gas.burning, &gas.heat, &gas.soot,
                         &gas.weight, &gas.wind_pull})
        *share = in.byte() % 3 ? 0.0f : std::abs(in.number(1e4f));
    gas.buoyancy = in.number(1e4f);
    gas.vorticity = std::abs(in.number(1e3f));
    gas.wind = in.point(5e3f);
    fluid::add_smoke(world, std::move(smoke));
}

inline void make_source(World& world, Bytes& in) {
    const auto smoke = one_of(world.fluids.smoke_slots, in);
    if (!smoke || world.fluids.source_slots.count() >= 8) return;
    fluid::Source source;
    source.smoke = *smoke, source.body = carrier(world, in), source.area = area_of(in);
    source.rate = in.number(1e4f), source.fuel = std::abs(in.number(1e4f)), source.temperature = in.number(1e3f);
    source.blows = in.byte() % 2;
    if (source.blows) source.velocity = in.point(5e3f);
    source.colour.r = static_cast<float>(in.byte()) / 255.0f;
    fluid::add_source(world, std::move(source));
}

inline void make_water(World& world, Bytes& in) {
    if (world.fluids.water_slots.count() >= 3) return;
    const fluid::Grid grid = grid_of(in);
    auto water = fluid::make_water(grid, grid.h / fluid::kCellsOfParticle);
    water->open = sides(in);
    fluid::add_water(world, std::move(water));
}

inline void add_liquid(fluid::Water& water, Bytes& in) {
    if (water.liquids.size() >= fluid::kMostLiquids) return;
    fluid::Liquid liquid;
    liquid.density = in.size();
    liquid.viscosity = in.byte() % 2 ? 0.0f : std::abs(in.number(1e4f));
    liquid.surface_tension = in.byte() % 2 ? 0.0f : std::abs(in.number(1e4f));
    liquid.serial = water.liquids.size();
    water.liquids.push_back(liquid);
}

inline std::uint32_t liquid_of(const fluid::Water& water, Bytes& in) {
    return static_cast<std::uint32_t>(in.byte() % water.liquids.size());
}

inline void make_stream(World& world, std::uint32_t water, Bytes& in) {
    if (world.fluids.stream_slots.count() >= 8) return;
    fluid::Stream stream;
    stream.water = water, stream.body = carrier(world, in), stream.area = area_of(in);
    stream.rate = in.number(fluid::kMostPouring), stream.velocity = in.point(5e3f);
    stream.liquid = liquid_of(*world.fluids.waters[water], in);
    fluid::add_stream(world, std::move(stream));
}

inline void write_over(fluid::Water& water, Bytes& in) { // as from outside, where any number may be written
    if (water.count == 0) return;
    fluid::Particles& particles = *water.particles;
    const std::size_t k = 2 * (in.byte() % water.count);
    particles.positions[k] = in.byte() % 4 ? in.number(1e30f) : NAN;
    particles.velocities[k + 1] = in.byte() % 4 ? in.number(1e30f) : INFINITY;
    particles.lent = true;
}

inline void order_water(World& world, std::uint32_t slot, Bytes& in) {
    fluid::Water& water = *world.fluids.waters[slot];
    switch (in.byte() % 8) {
    case 0:
    case 1:
        if (water.count < 20'000) fluid::fill(world, water, area_of(in), liquid_of(water, in), in.point(5e3f));
        return;
    case 2:
        fluid::clear(water, area_of(in));
        return;
    case 3:
    case 4:
        return make_stream(world, slot, in);
    case 5:
        return fluid::stir(water, in.point(1e4f), in.size(), in.point(5e3f));
    case 6:
        return add_liquid(water, in);
    default:
        write_over(water, in);
        settle_fluids(world);
        const fluid::WaterSampler sampler(water);
        (void)sampler.at(in.point(1e30f));
        (void)sampler.depth(in.point(1e30f), {0.0f, 1.0f});
    }
}

inline void order_fluids(World& world, Bytes& in) {
    const Fluids& all = world.fluids;
    switch (in.byte() % 8) {
    case 0:
        return make_smoke(world, in);
    case 1:
        return make_water(world, in);
    case 2:
        return make_source(world, in);
    case 3:
        if (auto smoke = one_of(all.smoke_slots, in)) {
            (void)fluid::sample(*all.smokes[*smoke], in.point(1e30f));
            if (in.byte() % 4 == 0) fluid::destroy_smoke(world, *smoke);
        }
        return;
    case 4:
        if (auto source = one_of(all.source_slots, in)) fluid::destroy_source(world, *source);
        if (auto stream = one_of(all.stream_slots, in)) fluid::destroy_stream(world, *stream);
        return;
    case 5:
        if (auto water = one_of(all.water_slots, in); water && in.byte() % 4 == 0) fluid::destroy_water(world, *water);
        return;
    default:
        if (auto water = one_of(all.water_slots, in)) order_water(world, *water, in);
    }
}

inline void check_numbers(std::span<const float> numbers) {
    for (const float number : numbers)
        if (!std::isfinite(number)) std::abort();
}

// No step may leave a number that is none.
inline void check_fluids(const World& world) {
    for (std::uint32_t slot = 0; slot < world.fluids.smoke_slots.size(); ++slot) {
        if (!world.fluids.smoke_slots.taken(slot)) continue;
        const fluid::Views& views = *world.fluids.smokes[slot]->views;
        for (const fluid::Cell& cell : views.content) check_numbers({{cell.density, cell.temperature, cell.fuel}});
        check_numbers(views.velocity);
    }
    for (std::uint32_t slot = 0; slot < world.fluids.water_slots.size(); ++slot) {
        if (!world.fluids.water_slots.taken(slot)) continue;
        const fluid::Water& water = *world.fluids.waters[slot];
        check_numbers(std::span(water.particles->positions).first(2 * water.count));
        check_numbers(std::span(water.particles->velocities).first(2 * water.count));
        check_numbers(std::span(water.particles->affine).first(4 * water.count));
    }
}

} // namespace evil::fuzz
