// _core.LiquidLook: how one liquid is shown. evilengine.scene.waters is its face and has checked what it is made of.
#include "draw/liquid.hpp"
#include "bind/scene.hpp"
#include "bind/visit.hpp"
#include "fluid/water/water.hpp"
#include "particles/foam.hpp"
#include <algorithm>
#include <cmath>
#include <nanobind/stl/array.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

namespace evil::bind {
namespace {

using draw::LiquidLook;

struct LookBox { // what Python holds
    LiquidLook look;
    draw::LiquidScratch scratch;
};

using Row = std::array<float, 6>;

const fluid::Water& water_in(const World& world, std::uint32_t slot) {
    if (slot >= world.fluids.water_slots.size() || !world.fluids.water_slots.taken(slot))
        raise(ErrorKind::stale_reference, "this Water was destroyed; ask water.alive first");
    return *world.fluids.waters[slot];
}

// Each liquid's colours from the surface to the deep: any number of rows, the same for all.
void set_tables(LookBox& box, const std::vector<std::vector<Row>>& liquids) {
    std::vector<draw::LiquidTable> tables;
    for (const std::vector<Row>& rows : liquids) {
        if (rows.size() != draw::kLiquidTable)
            raise(ErrorKind::argument, "LiquidLook: a table has LIQUID_TABLE rows of six numbers");
        draw::LiquidTable& table = tables.emplace_back();
        std::copy(rows.begin(), rows.end(), table.begin());
    }
    if (tables.empty() || tables.size() > draw::kMostLiquids) raise(ErrorKind::argument, "LiquidLook: 1 to 16 tables");
    box.look.tables = std::move(tables);
}

std::span<const Vec2> pairs(const std::vector<float>& values, std::size_t count) {
    return {reinterpret_cast<const Vec2*>(values.data()), count};
}

Vec2 high_of(const fluid::Grid& grid) {
    return grid.low + grid.h * Vec2{static_cast<float>(grid.nx), static_cast<float>(grid.ny)};
}

bool collect(LookBox& box, SceneBox& scene, World& world, std::uint32_t slot, const Matrix6& view, double alpha,
             float back, double time, int width, int height, float points, std::int32_t layer) {
    const fluid::Water& water = water_in(world, slot);
    draw::Sea sea;
    sea.at = pairs(water.particles->positions, water.count);
    sea.velocity = pairs(water.particles->velocities, water.count);
    sea.kind = std::span(water.particles->liquid).first(water.count);
    sea.spacing = water.particle_size;
    sea.low = water.grid.low, sea.high = high_of(water.grid);
    for (std::size_t side = 0; side < 4; ++side) sea.closed[side] = !water.open[side];
    const float strength = length(world.gravity);
    const Vec2 up = strength > 0.0f ? (-1.0f / strength) * world.gravity : Vec2{};
    const draw::LiquidView seen{to_affine(view), width, height, points, back, time, up};
    if (map_liquid(add_liquid(*scene.list, layer), box.scratch, sea, box.look, seen, world, part_of_step(alpha)))
        return true;
    drop_liquid(*scene.list);
    return false;
}

void step_foam(particles::Foam& foam, const World& world, std::uint32_t slot, float amount, float dt) {
    const fluid::Water& water = water_in(world, slot);
    particles::Waters waters;
    waters.at = pairs(water.particles->positions, water.count);
    waters.velocity = pairs(water.particles->velocities, water.count);
    waters.spacing = water.particle_size, waters.low = water.grid.low, waters.high = high_of(water.grid);
    for (std::size_t side = 0; side < 4; ++side) waters.closed[side] = !water.open[side];
    waters.gravity = world.gravity;
    particles::step(foam, waters, world, amount, dt);
}

void register_foam(nb::module_& module) {
    using particles::Foam;
    nb::class_<Foam>(module, "Foam", "Spray, foam and bubbles of one water.")
        .def(
            "__init__", [](Foam* foam, std::uint64_t seed) { (new (foam) Foam)->random = seed; }, nb::arg("seed"))
        .def_prop_ro(
            "count", [](const Foam& foam) { return foam.flecks.size(); }, "How many flecks there are.")
        .def("step", &step_foam, nb::arg("world"), nb::arg("slot"), nb::arg("amount"), nb::arg("dt"),
             "One step, after the world's: `amount` times as much as by itself.")
        .def(
            "collect",
            [](const Foam& foam, SceneBox& scene, const Matrix6& view, float back, int width, int height, float spacing,
               float points, bool lit, draw::Rgba8 tint, std::int32_t layer) {
                const Vec2 screen{static_cast<float>(width), static_cast<float>(height)};
                particles::collect(foam, {to_affine(view), screen, back, spacing, points, lit, tint}, layer,
                                   *scene.list);
            },
            nb::arg("scene"), nb::arg("view"), nb::arg("back"), nb::arg("width"), nb::arg("height"), nb::arg("spacing"),
            nb::arg("points"), nb::arg("lit"), nb::arg("tint"), nb::arg("layer"),
            "Put them into the frame that the scene collected.")
        .def("snapshot",
             [](const Foam& foam) {
                 const std::vector<std::uint8_t> bytes = particles::snapshot(foam);
                 return nb::bytes(bytes.data(), bytes.size());
             })
        .def(
            "restore",
            [](Foam& foam, const nb::bytes& bytes) {
                const auto* data = reinterpret_cast<const std::uint8_t*>(bytes.c_str());
                if (!particles::restore(foam, {data, bytes.size()})) throw nb::value_error("these bytes are no foam");
            },
            nb::arg("bytes"));
}

} // namespace

void register_liquid(nb::module_& module) {
    register_foam(module);
    module.attr("LIQUID_TABLE") = draw::kLiquidTable;
    module.attr("MOST_LIQUIDS") = draw::kMostLiquids;
    module.def(
        "liquid_colours",
        [](const World& world, std::uint32_t slot) {
            std::vector<std::array<float, 3>> colours;
            for (const fluid::Liquid& liquid : water_in(world, slot).liquids)
                colours.push_back({liquid.colour.r, liquid.colour.g, liquid.colour.b});
            return colours;
        },
        nb::arg("world"), nb::arg("slot"), "Red, green and blue of each liquid of a water.");
    nb::class_<LookBox>(module, "LiquidLook", "How one liquid is shown.")
        .def(nb::init<>())
        .def("set_tables", &set_tables, nb::arg("tables"),
             "Of each liquid LIQUID_TABLE rows from the surface to the deep: the shares of red, green and blue that "
             "come through, and those that it adds.")
        .def_prop_rw(
            "clarity", [](const LookBox& b) { return b.look.clarity; }, [](LookBox& b, float v) { b.look.clarity = v; })
        .def_prop_rw(
            "refraction", [](const LookBox& b) { return b.look.refraction; },
            [](LookBox& b, float v) { b.look.refraction = v; })
        .def_prop_rw(
            "rim", [](const LookBox& b) { return b.look.rim; }, [](LookBox& b, float v) { b.look.rim = v; })
        .def_prop_rw(
            "waves", [](const LookBox& b) { return b.look.waves; }, [](LookBox& b, float v) { b.look.waves = v; })
        .def_prop_rw(
            "lit", [](const LookBox& b) { return b.look.lit; }, [](LookBox& b, bool v) { b.look.lit = v; })
        .def("collect", &collect, nb::arg("scene"), nb::arg("world"), nb::arg("slot"), nb::arg("view"),
             nb::arg("alpha"), nb::arg("back"), nb::arg("time"), nb::arg("width"), nb::arg("height"), nb::arg("points"),
             nb::arg("layer"),
             "Put the liquid into the frame that the scene collected; whether any of it is to be seen.");
}

} // namespace evil::bind
