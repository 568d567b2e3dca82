// Water for Python: handles of liquids and their streams. evilengine.world.water is the face and has checked what is made.
#include "bind/fluid.hpp"
#include "bind/points.hpp"
#include "fluid/water/pouring.hpp"
#include "fluid/water/sampling.hpp"
#include <nanobind/stl/array.h>

namespace evil::bind {
namespace {

using Pair = std::tuple<float, float>;

// ---- particles ---------------------------------------------------------------------------------------------------

// Numbers of each particle, as a buffer of rows: no copy. What it shows is the water as it was when it was asked for: a
// water that grows moves to a new one.
struct ParticleView {
    std::shared_ptr<fluid::Particles> owner;
    float* pairs = nullptr;        // two floats each, which may be written
    std::uint8_t* kinds = nullptr; // or a byte each
    Py_ssize_t shape[2], strides[2];
    bool paired() const { return shape[1] == 2; } // pointers tell nothing: those of an empty water are null
};

int get_buffer(PyObject* self, Py_buffer* buffer, int flags) {
    ParticleView* view = nb::inst_ptr<ParticleView>(self);
    const bool pairs = view->paired();
    if (!pairs && (flags & PyBUF_WRITABLE) != 0) {
        PyErr_SetString(PyExc_BufferError, "which liquid a particle is cannot be written");
        buffer->obj = nullptr;
        return -1;
    }
    if (pairs) view->owner->lent = true; // NumPy asks to read, and writes where it may
    buffer->buf = pairs ? static_cast<void*>(view->pairs) : view->kinds;
    buffer->obj = self;
    Py_INCREF(self);
    buffer->len = view->shape[0] * view->strides[0];
    buffer->itemsize = pairs ? sizeof(float) : 1;
    buffer->readonly = pairs ? 0 : 1;
    buffer->ndim = pairs ? 2 : 1;
    buffer->format = const_cast<char*>(pairs ? "f" : "B");
    buffer->shape = view->shape;
    buffer->strides = view->strides;
    buffer->suboffsets = nullptr;
    buffer->internal = nullptr;
    return 0;
}

PyType_Slot slots[] = {{Py_bf_getbuffer, reinterpret_cast<void*>(get_buffer)}, {0, nullptr}};

ParticleView view_of(const WaterHandle& h, std::vector<float> fluid::Particles::* numbers) {
    const fluid::Water& water = row(h);
    return {water.particles,
            ((*water.particles).*numbers).data(),
            nullptr,
            {static_cast<Py_ssize_t>(water.count), 2},
            {2 * sizeof(float), sizeof(float)}};
}

Py_ssize_t index_in(const ParticleView& view, Py_ssize_t i) {
    if (i < 0) i += view.shape[0];
    if (i < 0 || i >= view.shape[0]) throw nb::index_error("there is no such particle");
    return i;
}

void register_particle_views(nb::module_& module) {
    nb::class_<ParticleView> c(module, "ParticleView", nb::type_slots(slots),
                               "Numbers of each particle of a water: a buffer that is not copied; positions and "
                               "velocities, two float32 each, may be written. `numpy.asarray(view)` works.");
    c.def("__len__", [](const ParticleView& view) { return view.shape[0]; });
    c.def_prop_ro("shape", [](const ParticleView& view) {
        nb::tuple shape = view.paired() ? nb::make_tuple(view.shape[0], view.shape[1]) : nb::make_tuple(view.shape[0]);
        return nb::borrow<nb::typed<nb::tuple, int, nb::ellipsis>>(shape);
    });
    c.def("__getitem__", [](const ParticleView& view, Py_ssize_t at) -> nb::object {
        const Py_ssize_t i = index_in(view, at);
        if (!view.paired()) return nb::int_(view.kinds[i]);
        return from_vec2({view.pairs[2 * i], view.pairs[2 * i + 1]});
    });
    c.def(
        "__setitem__",
        [](ParticleView& view, Py_ssize_t at, nb::handle value) {
            const Py_ssize_t i = index_in(view, at);
            if (!view.paired()) raise(ErrorKind::argument, "Water: which liquid a particle is cannot be written");
            const Vec2 wanted = to_vec2(value, "Water", "particle");
            view.pairs[2 * i] = wanted.x, view.pairs[2 * i + 1] = wanted.y;
            view.owner->lent = true;
        },
        nb::arg("at"), nb::arg("value").none());
}

// The water with particles that are numbers and in their box, whatever was written.
fluid::Water& sound_row(const WaterHandle& h) {
    fluid::Water& water = row(h);
    if (water.particles->lent) fluid::settle(water);
    return water;
}

// ---- liquids -----------------------------------------------------------------------------------------------------

// One of a water's, by its place in the row; `serial` tells whether it is still the same one after a restore.
fluid::Liquid& liquid_of(const WaterHandle& h, std::size_t index, std::uint64_t serial) {
    fluid::Water& water = row(h);
    if (index >= water.liquids.size() || water.liquids[index].serial != serial)
        raise(ErrorKind::stale_reference, "this Liquid is gone: the world was restored to a snapshot without it");
    return water.liquids[index];
}

void bind_liquids(nb::class_<WaterHandle>& c) {
    c.def("_add_liquid", [](const WaterHandle& h, float density, float viscosity, float surface_tension, Three colour) {
        fluid::Water& water = row(h);
        const std::uint64_t serial = h.world->fluids.next_serial++;
        water.liquids.push_back({density, viscosity, surface_tension, to_colour(colour), serial});
        return serial;
    });
    c.def("_liquid_serials", [](const WaterHandle& h) {
        std::vector<std::uint64_t> serials;
        for (const fluid::Liquid& liquid : row(h).liquids) serials.push_back(liquid.serial);
        return serials;
    });
    c.def("_liquid", [](const WaterHandle& h, std::size_t index, std::uint64_t serial) {
        const fluid::Liquid& l = liquid_of(h, index, serial);
        return std::tuple(l.density, l.viscosity, l.surface_tension, from_colour(l.colour));
    });
    c.def("_set_liquid", [](const WaterHandle& h, std::size_t index, std::uint64_t serial, float density,
                            float viscosity, float surface_tension, Three colour) {
        fluid::Liquid& l = liquid_of(h, index, serial);
        l.density = density, l.viscosity = viscosity, l.surface_tension = surface_tension, l.colour = to_colour(colour);
    });
    c.def("_count_of", [](const WaterHandle& h, std::size_t index, std::uint64_t serial) {
        (void)liquid_of(h, index, serial);
        const fluid::Water& water = row(h);
        std::size_t many = 0;
        for (std::size_t k = 0; k < water.count; ++k) many += water.particles->liquid[k] == index;
        return many;
    });
}

// ---- waters ------------------------------------------------------------------------------------------------------

std::uint32_t make(World& world, int nx, int ny, Pair low, float particle_size, std::array<bool, 4> open, float density,
                   float viscosity, float surface_tension, Three colour) {
    const float h = fluid::kCellsOfParticle * particle_size;
    std::unique_ptr<fluid::Water> water =
        fluid::make_water(fluid::grid_of(nx, ny, {std::get<0>(low), std::get<1>(low)}, h), particle_size);
    water->open = open;
    water->liquids[0] = {density, viscosity, surface_tension, to_colour(colour), world.fluids.next_serial++};
    return fluid::add_water(world, std::move(water)).slot;
}

void bind_samples(nb::class_<WaterHandle>& c) {
    c.def("_velocity_at", [](const WaterHandle& h, nb::handle points) {
        const fluid::WaterSampler sampler(sound_row(h));
        return ask_each(points, "Water.velocity_at", [&](Vec2 at) { return from_vec2(sampler.at(at).velocity); });
    });
    c.def("_density_at", [](const WaterHandle& h, nb::handle points) {
        const fluid::WaterSampler sampler(sound_row(h));
        return ask_each(points, "Water.density_at",
                        [&](Vec2 at) { return nb::float_(double(sampler.at(at).density)); });
    });
    c.def("_is_in", [](const WaterHandle& h, nb::handle points) {
        const fluid::WaterSampler sampler(sound_row(h));
        return ask_each(points, "Water.is_in", [&](Vec2 at) { return nb::bool_(sampler.at(at).inside); });
    });
    c.def("_depth_at", [](const WaterHandle& h, nb::handle points) {
        const fluid::WaterSampler sampler(sound_row(h));
        const Vec2 down = h.world->gravity;
        const float pull = length(down);
        const Vec2 up = pull > 0.0f ? (-1.0f / pull) * down : Vec2{0.0f, 1.0f};
        return ask_each(points, "Water.depth_at", [&](Vec2 at) { return nb::float_(double(sampler.depth(at, up))); });
    });
}

void register_waters(nb::module_& module) {
    nb::class_<WaterHandle> c(module, "Water", "A handle of a water: its slot and generation.");
    bind_handle(c);
    bind_samples(c);
    bind_liquids(c);
    c.def_prop_ro("count", [](const WaterHandle& h) { return row(h).count; }, "How many particles it has.");
    c.def_prop_ro(
        "positions", [](const WaterHandle& h) { return view_of(h, &fluid::Particles::positions); },
        "Where the particles are, (count, 2) metres; a step may change their order.");
    c.def_prop_ro(
        "velocities", [](const WaterHandle& h) { return view_of(h, &fluid::Particles::velocities); },
        "How they move, (count, 2) m/s, in the same order.");
    c.def_prop_ro(
        "kinds",
        [](const WaterHandle& h) {
            const fluid::Water& water = row(h);
            return ParticleView{water.particles,
                                nullptr,
                                water.particles->liquid.data(),
                                {static_cast<Py_ssize_t>(water.count), 1},
                                {1, 1}};
        },
        "Which of `liquids` each of them is, (count,) bytes in the same order, to be read.");
    c.def_prop_ro(
        "particle_size", [](const WaterHandle& h) { return row(h).particle_size; },
        "Metres: a particle stands for a square of that side.");
    c.def_prop_ro(
        "cells", [](const WaterHandle& h) { return std::tuple(row(h).grid.nx, row(h).grid.ny); },
        "How many cells its pressure has, across and up.");
    c.def_prop_ro(
        "area",
        [](const WaterHandle& h) {
            const fluid::Grid& g = row(h).grid;
            return std::tuple(g.low.x, g.low.y, g.low.x + g.h * static_cast<float>(g.nx),
                              g.low.y + g.h * static_cast<float>(g.ny));
        },
        "Where it may be: (left, bottom, right, top), in whole cells.");
    c.def_prop_ro("_open", [](const WaterHandle& h) { return row(h).open; });
    c.def("_fill", [](const WaterHandle& h, const NewShape& shape, nb::handle at, double angle, std::uint32_t liquid,
                      Pair velocity) {
        return fluid::fill(*h.world, sound_row(h), area_of(shape, at, angle), liquid,
                           {std::get<0>(velocity), std::get<1>(velocity)});
    });
    c.def("_clear", [](const WaterHandle& h, const NewShape& shape, nb::handle at, double angle) {
        return fluid::clear(row(h), area_of(shape, at, angle));
    });
    c.def("_stir", [](const WaterHandle& h, Pair at, float radius, Pair velocity) {
        fluid::stir(row(h), {std::get<0>(at), std::get<1>(at)}, radius, {std::get<0>(velocity), std::get<1>(velocity)});
    });
    c.def("_streams", [](const WaterHandle& h) {
        (void)row(h);
        const Fluids& all = h.world->fluids;
        return slots_of_owner(all.stream_slots, all.streams, &fluid::Stream::water, h.ref.slot);
    });
    bind_destroy(c, &fluid::destroy_water);
    module.attr("MOST_PARTICLES") = fluid::kMostParticles;
    module.attr("MOST_LIQUIDS_OF_WATER") = fluid::kMostLiquids;
    module.def("add_water", &make, nb::arg("world"), nb::kw_only(), nb::arg("nx"), nb::arg("ny"), nb::arg("low"),
               nb::arg("particle_size"), nb::arg("open"), nb::arg("density"), nb::arg("viscosity"),
               nb::arg("surface_tension"), nb::arg("colour"));
    module.def("water_slots", [](const World& w) { return taken_slots(w.fluids.water_slots); });
}

// ---- streams -----------------------------------------------------------------------------------------------------

std::uint32_t make_stream(World& world, std::uint32_t water, std::uint32_t body, const NewShape& shape, nb::handle at,
                          double angle, float rate, Pair velocity, std::uint32_t liquid) {
    fluid::Stream stream;
    stream.water = water, stream.body = body;
    stream.area = area_of(shape, at, angle);
    stream.rate = rate, stream.liquid = liquid;
    stream.velocity = {std::get<0>(velocity), std::get<1>(velocity)};
    return fluid::add_stream(world, std::move(stream)).slot;
}

void register_streams(nb::module_& module) {
    nb::class_<StreamHandle> c(module, "WaterStream", "A handle of a stream: its slot and generation.");
    bind_handle(c);
    def_value(
        c, "velocity", kPoint, [](const StreamHandle& h) { return from_vec2(row(h).velocity); },
        [](const StreamHandle& h, nb::handle value) {
            const Vec2 wanted = to_flow(value, "Stream", "velocity");
            row(h).velocity = wanted;
        },
        "m/s that liquid comes out with, beside its body's own; of one that drains it means nothing.");
    bind_flow(c, "Stream", "Does it pour, or drain, now?");
    c.def_prop_ro("_rate", [](const StreamHandle& h) { return row(h).rate; });
    c.def("_set_rate", [](const StreamHandle& h, float rate) { row(h).rate = rate; });
    c.def_prop_ro("_water", [](const StreamHandle& h) { return row(h).water; });
    c.def_prop_ro("_liquid", [](const StreamHandle& h) { return row(h).liquid; });
    bind_destroy(c, &fluid::destroy_stream);
    module.attr("MOST_POURING") = fluid::kMostPouring;
    module.def("add_stream", &make_stream, nb::arg("world"), nb::kw_only(), nb::arg("water"), nb::arg("body"),
               nb::arg("shape"), nb::arg("at"), nb::arg("angle"), nb::arg("rate"), nb::arg("velocity"),
               nb::arg("liquid"));
}

} // namespace

void register_water(nb::module_& module) {
    register_particle_views(module);
    register_waters(module);
    register_streams(module);
}

} // namespace evil::bind
