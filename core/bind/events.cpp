// Events for Python: the touches of a step as rows for those that take them one by one, and as columns for bulk readers.
#include "bind/handle.hpp"
#include <array>
#include <bit>
#include <nanobind/stl/pair.h>

namespace evil::bind {
namespace {

struct TouchRows { // a copy: it stays as it is while the world goes on
    std::vector<Touch> rows;
};

// One value of every row as a read-only buffer that owns its bytes.
struct Column {
    std::shared_ptr<std::vector<std::uint32_t>> words; // floats by their bits
    const char* format;
    Py_ssize_t shape[2], strides[2];
};

int get_buffer(PyObject* self, Py_buffer* buffer, int flags) {
    Column* column = nb::inst_ptr<Column>(self);
    if (flags & PyBUF_WRITABLE) {
        PyErr_SetString(PyExc_BufferError, "events are read-only");
        buffer->obj = nullptr;
        return -1;
    }
    buffer->buf = column->words->data();
    buffer->obj = self;
    Py_INCREF(self);
    buffer->len = column->shape[0] * column->shape[1] * 4;
    buffer->itemsize = 4;
    buffer->readonly = 1;
    buffer->ndim = column->shape[1] == 1 ? 1 : 2;
    buffer->format = const_cast<char*>(column->format);
    buffer->shape = column->shape;
    buffer->strides = column->strides;
    buffer->suboffsets = nullptr;
    buffer->internal = nullptr;
    return 0;
}

PyType_Slot slots[] = {{Py_bf_getbuffer, reinterpret_cast<void*>(get_buffer)}, {0, nullptr}};

std::uint32_t word(std::uint32_t value) { return value; }
std::uint32_t word(float value) { return std::bit_cast<std::uint32_t>(value); }

// Columns of what `values` gives of each row: an array of numbers of one kind.
Column column_of(const std::vector<Touch>& rows, auto&& values) {
    using Values = decltype(values(rows[0]));
    constexpr std::size_t width = std::tuple_size_v<Values>;
    auto words = std::make_shared<std::vector<std::uint32_t>>();
    words->reserve(width * rows.size());
    for (const Touch& t : rows)
        for (auto value : values(t)) words->push_back(word(value));
    const char* format = std::is_same_v<typename Values::value_type, float> ? "f" : "I";
    return {words, format, {static_cast<Py_ssize_t>(rows.size()), width}, {4 * width, 4}};
}

Anything row_of(const TouchRows& touches, std::size_t i) {
    if (i >= touches.rows.size()) throw nb::index_error("there is no such event");
    const Touch& t = touches.rows[i];
    return nb::borrow<Anything>(nb::make_tuple(t.a.slot, t.a.generation, t.b.slot, t.b.generation, t.shape_a.slot,
                                               t.shape_a.generation, t.shape_b.slot, t.shape_b.generation,
                                               from_vec2(t.point), from_vec2(t.normal), t.depth, t.impulse, t.speed));
}

template <class Get> void bind_column(nb::class_<TouchRows>& c, const char* name, Get get) {
    c.def_prop_ro(name, [get](const TouchRows& touches) { return column_of(touches.rows, get); });
}

void bind_rows(nb::module_& module) {
    nb::class_<Column> column(module, "Column", nb::type_slots(slots),
                              "One value of every event, a row each: a read-only buffer of float32 or uint32, which "
                              "`numpy.asarray` takes as it is.");
    column.def("__len__", [](const Column& c) { return c.shape[0]; });
    nb::class_<TouchRows> c(module, "Touches", "Touches of a step, in the order that is promised.");
    c.def("__len__", [](const TouchRows& touches) { return touches.rows.size(); });
    c.def("row", row_of, nb::arg("number"));
    using Slots2 = std::array<std::uint32_t, 2>;
    using Floats1 = std::array<float, 1>;
    using Floats2 = std::array<float, 2>;
    bind_column(c, "bodies", [](const Touch& t) { return Slots2{t.a.slot, t.b.slot}; });
    bind_column(c, "shapes", [](const Touch& t) { return Slots2{t.shape_a.slot, t.shape_b.slot}; });
    bind_column(c, "points", [](const Touch& t) { return Floats2{t.point.x, t.point.y}; });
    bind_column(c, "normals", [](const Touch& t) { return Floats2{t.normal.x, t.normal.y}; });
    bind_column(c, "depths", [](const Touch& t) { return Floats1{t.depth}; });
    bind_column(c, "impulses", [](const Touch& t) { return Floats1{t.impulse}; });
    bind_column(c, "speeds", [](const Touch& t) { return Floats1{t.speed}; });
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> references(const std::vector<BodyRef>& list) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> found;
    for (BodyRef ref : list) found.push_back({ref.slot, ref.generation});
    return found;
}

} // namespace

void register_events(nb::module_& module, nb::class_<World>& world) {
    bind_rows(module);
    world.def_prop_ro("begun", [](const World& w) { return TouchRows{w.events.begun}; });
    world.def_prop_ro("ended", [](const World& w) { return TouchRows{w.events.ended}; });
    world.def_prop_ro("hit", [](const World& w) { return TouchRows{w.events.hit}; });
    world.def_prop_ro("active",
                      [](const World& w) { return TouchRows{active_touches(w.contacts, w.shapes, w.bodies, false)}; });
    world.def_prop_ro("entered", [](const World& w) { return TouchRows{w.events.entered}; });
    world.def_prop_ro("left", [](const World& w) { return TouchRows{w.events.left}; });
    world.def_prop_ro("inside",
                      [](const World& w) { return TouchRows{active_touches(w.contacts, w.shapes, w.bodies, true)}; });
    world.def_prop_ro("slept", [](const World& w) { return references(w.events.slept); });
    world.def_prop_ro("woke", [](const World& w) { return references(w.events.woke); });
    world.def_prop_rw(
        "hit_speed", [](const World& w) { return w.events.hit_speed; },
        [](World& w, float speed) { w.events.hit_speed = speed; });
}

} // namespace evil::bind
