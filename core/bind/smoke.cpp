// Smoke for Python: handles of gases and their sources. evilengine.world.smoke is the face and has checked what is made.
#include "bind/fluid.hpp"
#include "bind/points.hpp"
#include "fluid/looks.hpp"
#include "fluid/sampling.hpp"
#include "fluid/scratch.hpp"
#include "fluid/sources.hpp"
#include <nanobind/stl/array.h>
#include <nanobind/stl/tuple.h>

namespace evil::bind {

namespace {

using Pair = std::tuple<float, float>;

// ---- fields ------------------------------------------------------------------------------------------------------

// One number of each cell, or two, as a buffer of rows from the lowest up: no copy, and it may be written.
struct FieldView {
    std::shared_ptr<fluid::Views> owner;
    float* data;
    int dimensions;
    Py_ssize_t shape[3], strides[3];
};

constexpr Py_ssize_t kFloat = sizeof(float);

FieldView content_of(const SmokeHandle& h, float fluid::Cell::* value) {
    const fluid::Smoke& smoke = row(h);
    const Py_ssize_t nx = smoke.grid.nx, ny = smoke.grid.ny;
    constexpr Py_ssize_t cell = sizeof(fluid::Cell);
    return {smoke.views, &(smoke.views->content[0].*value), 2, {ny, nx, 0}, {nx * cell, cell, 0}};
}

FieldView velocity_of(const SmokeHandle& h) {
    const fluid::Smoke& smoke = row(h);
    const Py_ssize_t nx = smoke.grid.nx, ny = smoke.grid.ny;
    return {smoke.views, smoke.views->velocity.data(), 3, {ny, nx, 2}, {2 * nx * kFloat, 2 * kFloat, kFloat}};
}

int get_buffer(PyObject* self, Py_buffer* buffer, int flags) {
    FieldView* view = nb::inst_ptr<FieldView>(self);
    if ((flags & PyBUF_STRIDES) != PyBUF_STRIDES) {
        PyErr_SetString(PyExc_BufferError, "a smoke's field has gaps between its numbers; ask for it with strides");
        buffer->obj = nullptr;
        return -1;
    }
    view->owner->lent = true; // NumPy asks to read, and writes where it may
    buffer->buf = view->data;
    buffer->obj = self;
    Py_INCREF(self);
    buffer->len = kFloat * view->shape[0] * view->shape[1] * (view->dimensions == 3 ? view->shape[2] : 1);
    buffer->itemsize = kFloat;
    buffer->readonly = 0;
    buffer->ndim = view->dimensions;
    buffer->format = const_cast<char*>("f");
    buffer->shape = view->shape;
    buffer->strides = view->strides;
    buffer->suboffsets = nullptr;
    buffer->internal = nullptr;
    return 0;
}

PyType_Slot slots[] = {{Py_bf_getbuffer, reinterpret_cast<void*>(get_buffer)}, {0, nullptr}};

float* number_at(const FieldView& view, std::tuple<Py_ssize_t, Py_ssize_t> at) {
    auto [j, i] = at;
    if (j < 0) j += view.shape[0];
    if (i < 0) i += view.shape[1];
    if (j < 0 || j >= view.shape[0] || i < 0 || i >= view.shape[1])
        throw nb::index_error("there is no such cell; the first index counts rows from below, the second columns");
    return view.data + (j * view.strides[0] + i * view.strides[1]) / kFloat;
}

void register_fields(nb::module_& module) {
    nb::class_<FieldView> c(module, "FieldView", nb::type_slots(slots),
                            "A number, or two, for each cell of a smoke, rows from below: a float32 buffer that is "
                            "not copied and may be written. `numpy.asarray(view)` works; `view[j, i]` is one cell.");
    c.def_prop_ro("shape", [](const FieldView& view) {
        nb::tuple shape = view.dimensions == 2 ? nb::make_tuple(view.shape[0], view.shape[1])
                                               : nb::make_tuple(view.shape[0], view.shape[1], view.shape[2]);
        return nb::borrow<nb::typed<nb::tuple, int, nb::ellipsis>>(shape);
    });
    c.def("__len__", [](const FieldView& view) { return view.shape[0]; });
    c.def("__getitem__", [](const FieldView& view, std::tuple<Py_ssize_t, Py_ssize_t> at) -> nb::object {
        const float* number = number_at(view, at);
        if (view.dimensions == 3) return from_vec2({number[0], number[1]});
        return nb::float_(double(*number));
    });
    c.def(
        "__setitem__",
        [](FieldView& view, std::tuple<Py_ssize_t, Py_ssize_t> at, nb::handle value) {
            float* number = number_at(view, at);
            if (view.dimensions == 3) {
                const Vec2 wanted = to_vec2(value, "Smoke", "velocity");
                number[0] = wanted.x, number[1] = wanted.y;
            } else {
                *number = to_float(value, "Smoke", "value");
            }
            view.owner->lent = true;
        },
        nb::arg("at"), nb::arg("value").none());
}

// ---- smokes ------------------------------------------------------------------------------------------------------

template <auto Field>
void bind_number(nb::class_<SmokeHandle>& c, const char* name, float least, float most, const char* doc) {
    def_value(
        c, name, kNumber, [](const SmokeHandle& h) { return row(h).gas.*Field; },
        [name, least, most](const SmokeHandle& h, nb::handle value) {
            const float number = in_range(value, "Smoke", name, least, most);
            row(h).gas.*Field = number;
        },
        doc);
}

void bind_gas(nb::class_<SmokeHandle>& c) {
    using G = fluid::Gas;
    bind_number<&G::viscosity>(c, "viscosity", 0, 1e4f, "m2/s: how thick it is; 0 costs nothing.");
    bind_number<&G::diffusion>(c, "diffusion", 0, 1e4f, "m2/s: how fast what it carries spreads by itself.");
    bind_number<&G::buoyancy>(c, "buoyancy", -1e4f, 1e4f,
                              "How many times the world's gravity a temperature of 1 rises with.");
    bind_number<&G::vorticity>(c, "vorticity", 0, 1e3f, "How strongly small whirls are kept alive.");
    bind_number<&G::cooling>(c, "cooling", 0, 1e4f, "Share of the heat that is lost a second, small shares.");
    bind_number<&G::fade>(c, "fade", 0, 1e4f, "Share of the density that is lost a second, small shares.");
    bind_number<&G::burning>(c, "burning", 0, 1e4f, "Share of the fuel that burns in a second, small shares.");
    bind_number<&G::heat>(c, "heat", 0, 1e4f, "Temperature that a unit of fuel gives.");
    bind_number<&G::soot>(c, "soot", 0, 1e4f, "Density that a unit of fuel leaves.");
    bind_number<&G::weight>(c, "weight", 0, 1e4f, "kg/m2: how hard it pushes bodies.");
    bind_number<&G::wind_pull>(c, "wind_pull", 0, 1e4f, "Share of the difference to the wind that goes in a second.");
    def_value(
        c, "wind", kPoint, [](const SmokeHandle& h) { return from_vec2(row(h).gas.wind); },
        [](const SmokeHandle& h, nb::handle value) {
            const Vec2 wind = to_flow(value, "Smoke", "wind");
            row(h).gas.wind = wind;
        },
        "m/s that it is drawn towards.");
}

std::uint32_t make(World& world, int nx, int ny, Pair low, float h, int method, int quality, std::array<bool, 4> open,
                   std::array<float, 4> side_speeds, bool stick, Three colour) {
    std::unique_ptr<fluid::Smoke> smoke = fluid::make_smoke(
        fluid::grid_of(nx, ny, {std::get<0>(low), std::get<1>(low)}, h), static_cast<fluid::Method>(method));
    smoke->quality = static_cast<fluid::Quality>(quality);
    smoke->open = open, smoke->side_speeds = side_speeds, smoke->stick = stick;
    smoke->colour = to_colour(colour);
    return fluid::add_smoke(world, std::move(smoke)).slot;
}

std::uint32_t make_source(World& world, std::uint32_t smoke, std::uint32_t body, const NewShape& shape, nb::handle at,
                          double angle, float rate, float fuel, float temperature, nb::object velocity, Three colour) {
    fluid::Source source;
    source.smoke = smoke, source.body = body;
    source.area = area_of(shape, at, angle);
    source.rate = rate, source.fuel = fuel, source.temperature = temperature, source.colour = to_colour(colour);
    source.blows = !velocity.is_none();
    if (source.blows) source.velocity = to_vec2(velocity, "Smoke.add_source", "velocity");
    return fluid::add_source(world, std::move(source)).slot;
}

template <class Answer> Answers ask(const SmokeHandle& h, nb::handle points, const char* owner, Answer answer) {
    const fluid::Smoke& smoke = row(h);
    return ask_each(points, owner, [&](Vec2 at) { return answer(fluid::sample(smoke, at)); });
}

void bind_samples(nb::class_<SmokeHandle>& c) {
    using fluid::Sample;
    c.def("_density_at", [](const SmokeHandle& h, nb::handle points) {
        return ask(h, points, "Smoke.density_at", [](const Sample& s) { return nb::float_(double(s.density)); });
    });
    c.def("_temperature_at", [](const SmokeHandle& h, nb::handle points) {
        return ask(h, points, "Smoke.temperature_at",
                   [](const Sample& s) { return nb::float_(double(s.temperature)); });
    });
    c.def("_velocity_at", [](const SmokeHandle& h, nb::handle points) {
        return ask(h, points, "Smoke.velocity_at", [](const Sample& s) { return from_vec2(s.velocity); });
    });
    c.def_prop_ro(
        "mass", [](const SmokeHandle& h) { return fluid::mass_of(row(h)); },
        "All the density in it, times its area in m2.");
}

using RampOf = std::array<std::uint32_t, fluid::kRamp>;

// A picture of it, as values.image has them.
nb::bytes paint(const SmokeHandle& h, const RampOf& colours, float scale, bool heat) {
    const fluid::Smoke& smoke = row(h);
    const std::size_t count = 4 * smoke.grid.cells();
    nb::bytes bytes = nb::steal<nb::bytes>(
        PyBytes_FromStringAndSize(nullptr, static_cast<Py_ssize_t>(count * sizeof(std::uint32_t))));
    if (!bytes.is_valid()) throw std::bad_alloc();
    auto* pixels = reinterpret_cast<std::uint32_t*>(PyBytes_AsString(bytes.ptr())); // new, and aligned
    fluid::paint(smoke, heat ? fluid::Shown::heat : fluid::Shown::density, {colours, scale}, {pixels, count});
    return bytes;
}

std::vector<std::uint32_t> sources_of(const SmokeHandle& h) {
    (void)row(h);
    const Fluids& all = h.world->fluids;
    return slots_of_owner(all.source_slots, all.sources, &fluid::Source::smoke, h.ref.slot);
}

using BlazeRow = std::tuple<std::uint32_t, float, float, float, float>;
std::vector<BlazeRow> blazes_of(const SmokeHandle& h, float above) {
    std::vector<std::uint32_t> sources = sources_of(h);
    std::vector<Vec2> places;
    for (const std::uint32_t slot : sources)
        places.push_back(fluid::middle_of(h.world->fluids.sources[slot], *h.world));
    if (places.empty()) places.push_back({}), sources.push_back(kNone);
    std::vector<fluid::Blaze> blazes;
    fluid::find_blazes(row(h), above, places, blazes);
    std::vector<BlazeRow> rows;
    for (std::size_t k = 0; k < blazes.size(); ++k)
        if (const fluid::Blaze& b = blazes[k]; b.strength > 0.0f)
            rows.emplace_back(sources[k], b.strength, b.middle.x, b.middle.y, b.size);
    return rows;
}

void register_smokes(nb::module_& module) {
    nb::class_<SmokeHandle> c(module, "Smoke", "A handle of a smoke: its slot and generation.");
    bind_handle(c);
    bind_gas(c);
    bind_samples(c);
    c.def_prop_ro(
        "density", [](const SmokeHandle& h) { return content_of(h, &fluid::Cell::density); },
        "Smoke in each cell, (ny, nx) numbers.");
    c.def_prop_ro(
        "temperature", [](const SmokeHandle& h) { return content_of(h, &fluid::Cell::temperature); },
        "Heat of each cell above what surrounds it, (ny, nx) numbers.");
    c.def_prop_ro(
        "fuel", [](const SmokeHandle& h) { return content_of(h, &fluid::Cell::fuel); },
        "Fuel in each cell, (ny, nx) numbers.");
    c.def_prop_ro("velocity", &velocity_of, "m/s in the middle of each cell, (ny, nx, 2) numbers.");
    c.def_prop_ro(
        "cells",
        [](const SmokeHandle& h) {
            const fluid::Grid& g = row(h).grid;
            return std::tuple(g.nx, g.ny);
        },
        "How many cells it has, across and up.");
    c.def_prop_ro("cell", [](const SmokeHandle& h) { return row(h).grid.h; }, "Metres: the side of a cell.");
    c.def_prop_ro(
        "area",
        [](const SmokeHandle& h) {
            const fluid::Grid& g = row(h).grid;
            return std::tuple(g.low.x, g.low.y, g.low.x + g.h * static_cast<float>(g.nx),
                              g.low.y + g.h * static_cast<float>(g.ny));
        },
        "Where it is: (left, bottom, right, top), in whole cells.");
    c.def_prop_ro("_open", [](const SmokeHandle& h) { return row(h).open; });
    c.def_prop_ro("_colour", [](const SmokeHandle& h) { return from_colour(row(h).colour); });
    c.def_prop_ro("_kind", [](const SmokeHandle& h) {
        return std::tuple(static_cast<int>(row(h).method), static_cast<int>(row(h).quality));
    });
    c.def(
        "_gathering",
        [](const SmokeHandle& h) {
            fluid::Scratch& scratch = *row(h).scratch;
            scratch.watched = true;
            return std::tuple(scratch.gathering.before, scratch.gathering.after);
        },
        "Divergence before and after the last projection, root mean square, 1/s, from the step after the first call "
        "on.");
    c.def("_paint", &paint, nb::arg("colours"), nb::arg("scale"), nb::arg("heat"));
    c.def("_blazes", &blazes_of, nb::arg("above"),
          "Of each source that there is fire near: its slot, how strong that is, where and how large; of all fire, if "
          "there are no sources.");
    c.def("_stir", [](const SmokeHandle& h, Pair at, float radius, Pair velocity) {
        fluid::Smoke& smoke = row(h);
        fluid::stir(*h.world, smoke, {std::get<0>(at), std::get<1>(at)}, radius,
                    {std::get<0>(velocity), std::get<1>(velocity)});
    });
    c.def("_sources", &sources_of);
    c.def("_take_back", [](SmokeHandle& h) { // as if it had not been made
        const std::uint64_t serial = row(h).serial;
        h.died = h.world->steps, h.buried = true;
        fluid::destroy_smoke(*h.world, h.ref.slot);
        h.world->fluids.next_serial = serial;
    });
    bind_destroy(c, &fluid::destroy_smoke);
    module.def("add_smoke", &make, nb::arg("world"), nb::kw_only(), nb::arg("nx"), nb::arg("ny"), nb::arg("low"),
               nb::arg("cell"), nb::arg("method"), nb::arg("quality"), nb::arg("open"), nb::arg("side_speeds"),
               nb::arg("stick"), nb::arg("colour"));
    module.def("smoke_slots", [](const World& w) { return taken_slots(w.fluids.smoke_slots); });
}

void register_sources(nb::module_& module) {
    nb::class_<SourceHandle> c(module, "Source", "A handle of a source of smoke: its slot and generation.");
    bind_handle(c);
    auto number = [&c](const char* name, float fluid::Source::* field, float least, float most, const char* doc) {
        def_value(
            c, name, kNumber, [field](const SourceHandle& h) { return row(h).*field; },
            [name, field, least, most](const SourceHandle& h, nb::handle value) {
                const float wanted = in_range(value, "Source", name, least, most);
                row(h).*field = wanted;
            },
            doc);
    };
    number("rate", &fluid::Source::rate, -1e4f, 1e4f, "Density a second; negative: it takes away that share.");
    number("fuel", &fluid::Source::fuel, 0, 1e4f, "Fuel a second.");
    number("temperature", &fluid::Source::temperature, -1e3f, 1e3f, "What it heats to; 0: it heats nothing.");
    def_value(
        c, "velocity", "evilengine.values.vec2.Point | None",
        [](const SourceHandle& h) -> nb::object {
            if (!row(h).blows) return nb::none();
            return from_vec2(row(h).velocity);
        },
        [](const SourceHandle& h, nb::handle value) {
            const Vec2 wanted = value.is_none() ? Vec2{} : to_flow(value, "Source", "velocity");
            row(h).blows = !value.is_none();
            row(h).velocity = wanted;
        },
        "m/s that gas in it is given, beside its body's own; None: it leaves the gas as it moves.");
    bind_flow(c, "Source", "Does it give anything now?");
    c.def_prop_ro("_colour", [](const SourceHandle& h) { return from_colour(row(h).colour); });
    bind_destroy(c, &fluid::destroy_source);
    module.def("add_source", &make_source, nb::arg("world"), nb::kw_only(), nb::arg("smoke"), nb::arg("body"),
               nb::arg("shape"), nb::arg("at"), nb::arg("angle"), nb::arg("rate"), nb::arg("fuel"),
               nb::arg("temperature"), nb::arg("velocity").none(), nb::arg("colour"));
}

} // namespace

void register_smoke(nb::module_& module) {
    module.attr("RAMP") = fluid::kRamp;
    register_fields(module);
    register_smokes(module);
    register_sources(module);
}

} // namespace evil::bind
