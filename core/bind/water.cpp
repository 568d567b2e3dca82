// Water for Python: handles of liquids. evilengine.world.water is the face and has checked what is made.
#include "bind/fluid.hpp"
#include <nanobind/stl/array.h>
#include <nanobind/stl/tuple.h>

namespace evil::bind {
namespace {

using Three = std::tuple<float, float, float>;
using Pair = std::tuple<float, float>;

// Two numbers of each particle, as a buffer of rows: no copy, and it may be written. What it shows is the water as it was
// when it was asked for: a water that grows moves to a new one.
struct ParticleView {
    std::shared_ptr<fluid::Particles> owner;
    float* data;
    Py_ssize_t shape[2], strides[2];
};

int get_buffer(PyObject* self, Py_buffer* buffer, int) {
    ParticleView* view = nb::inst_ptr<ParticleView>(self);
    buffer->buf = view->data;
    buffer->obj = self;
    Py_INCREF(self);
    buffer->len = view->shape[0] * view->strides[0];
    buffer->itemsize = sizeof(float);
    buffer->readonly = 0;
    buffer->ndim = 2;
    buffer->format = const_cast<char*>("f");
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
            {static_cast<Py_ssize_t>(water.count), 2},
            {2 * sizeof(float), sizeof(float)}};
}

std::uint32_t make(World& world, int nx, int ny, Pair low, float particle_size, std::array<bool, 4> open, float density,
                   float viscosity, float surface_tension, Three colour) {
    const float h = fluid::kCellsOfParticle * particle_size;
    std::unique_ptr<fluid::Water> water =
        fluid::make_water(fluid::grid_of(nx, ny, {std::get<0>(low), std::get<1>(low)}, h), particle_size);
    water->open = open;
    water->liquids[0] = {
        density, viscosity, surface_tension, {std::get<0>(colour), std::get<1>(colour), std::get<2>(colour)}, 0};
    return fluid::add_water(world, std::move(water)).slot;
}

} // namespace

void register_water(nb::module_& module) {
    nb::class_<ParticleView> view(
        module, "ParticleView", nb::type_slots(slots),
        "Two numbers for each particle of a water: a float32 buffer that is not copied and may "
        "be written. `numpy.asarray(view)` works.");
    view.def("__len__", [](const ParticleView& v) { return v.shape[0]; });

    nb::class_<WaterHandle> c(module, "Water", "A handle of a water: its slot and generation.");
    c.def("__init__", [](WaterHandle* self, std::shared_ptr<World> world, std::uint32_t slot) {
        new (self) WaterHandle;
        self->world = std::move(world);
        self->ref = {slot, slots_of(*self).size() > slot ? slots_of(*self).generation(slot) : 0u};
        self->born = row(*self).born;
    });
    bind_identity(c);
    c.def_prop_ro("count", [](const WaterHandle& h) { return row(h).count; }, "How many particles it has.");
    c.def_prop_ro(
        "positions", [](const WaterHandle& h) { return view_of(h, &fluid::Particles::positions); },
        "Where the particles are, (count, 2) metres; a step changes their order.");
    c.def_prop_ro(
        "velocities", [](const WaterHandle& h) { return view_of(h, &fluid::Particles::velocities); },
        "How they move, (count, 2) m/s, in the same order.");
    c.def_prop_ro(
        "particle_size", [](const WaterHandle& h) { return row(h).particle_size; },
        "Metres: a particle is a square of that side.");
    c.def("_fill", [](const WaterHandle& h, std::array<float, 4> box, Pair velocity) {
        fluid::Water& water = row(h);
        const Area area{{}, 0.0f, {{{box[0], box[1]}, {box[2], box[1]}, {box[2], box[3]}, {box[0], box[3]}}}};
        return fluid::fill(*h.world, water, area, 0, {std::get<0>(velocity), std::get<1>(velocity)});
    });
    c.def("_destroy", [](WaterHandle& h) {
        require_alive(h);
        h.died = h.world->steps, h.buried = true;
        fluid::destroy_water(*h.world, h.ref.slot);
    });
    module.def("add_water", &make, nb::arg("world"), nb::kw_only(), nb::arg("nx"), nb::arg("ny"), nb::arg("low"),
               nb::arg("particle_size"), nb::arg("open"), nb::arg("density"), nb::arg("viscosity"),
               nb::arg("surface_tension"), nb::arg("colour"));
    module.def("water_slots", [](const World& w) {
        std::vector<std::uint32_t> list;
        for (std::uint32_t i = 0; i < w.fluids.water_slots.size(); ++i)
            if (w.fluids.water_slots.taken(i)) list.push_back(i);
        return list;
    });
}

} // namespace evil::bind
