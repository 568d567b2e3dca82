// Events for Python: the touches of a step as rows for those that take them one by one, and as columns for bulk readers.
#include "bind/handle.hpp"
#include <cstddef>
#include <nanobind/ndarray.h>
#include <nanobind/stl/pair.h>

namespace evil::bind {
namespace {

struct TouchRows { // a copy: it stays as it is while the world goes on
    std::vector<Touch> rows;
};

// One value of every row, a number or two of them `apart` words from each other, as a memoryview that keeps the rows alive.
template <class Number, std::size_t Width> auto column(nb::handle self, std::size_t offset, std::int64_t apart) {
    static_assert(sizeof(Touch) % sizeof(Number) == 0 && std::is_standard_layout_v<Touch>);
    constexpr std::int64_t kRow = sizeof(Touch) / sizeof(Number);
    const std::vector<Touch>& rows = nb::inst_ptr<TouchRows>(self)->rows;
    auto at = reinterpret_cast<const Number*>(reinterpret_cast<const char*>(rows.data()) + (rows.empty() ? 0 : offset));
    if constexpr (Width == 1)
        return nb::ndarray<nb::memview, const Number, nb::ndim<1>>(at, {rows.size()}, self, {kRow});
    else
        return nb::ndarray<nb::memview, const Number, nb::ndim<2>>(at, {rows.size(), Width}, self, {kRow, apart});
}

Anything row_of(const TouchRows& touches, std::size_t i) {
    if (i >= touches.rows.size()) throw nb::index_error("there is no such event");
    const Touch& t = touches.rows[i];
    return nb::borrow<Anything>(nb::make_tuple(t.a.slot, t.a.generation, t.b.slot, t.b.generation, t.shape_a.slot,
                                               t.shape_a.generation, t.shape_b.slot, t.shape_b.generation,
                                               from_vec2(t.point), from_vec2(t.normal), t.depth, t.impulse, t.speed));
}

template <class Number, std::size_t Width = 1>
void bind_column(nb::class_<TouchRows>& c, const char* name, std::size_t offset, std::int64_t apart = 1) {
    std::string signature = "def " + std::string(name) + "(self) -> memoryview";
    c.def_prop_ro(
        name, [offset, apart](nb::handle self) { return column<Number, Width>(self, offset, apart); },
        nb::for_getter(nb::sig(signature.c_str())));
}

void bind_rows(nb::module_& module) {
    nb::class_<TouchRows> c(module, "Touches", "Touches of a step, in the order that is promised.");
    c.def("__len__", [](const TouchRows& touches) { return touches.rows.size(); });
    c.def("row", row_of, nb::arg("number"));
    constexpr std::int64_t kRef = sizeof(BodyRef) / sizeof(std::uint32_t); // words: a slot and its generation
    static_assert(offsetof(Touch, b) == offsetof(Touch, a) + sizeof(BodyRef));
    static_assert(offsetof(Touch, shape_b) == offsetof(Touch, shape_a) + sizeof(ShapeRef));
    bind_column<std::uint32_t, 2>(c, "bodies", offsetof(Touch, a), kRef);
    bind_column<std::uint32_t, 2>(c, "shapes", offsetof(Touch, shape_a), kRef);
    bind_column<float, 2>(c, "points", offsetof(Touch, point));
    bind_column<float, 2>(c, "normals", offsetof(Touch, normal));
    bind_column<float>(c, "depths", offsetof(Touch, depth));
    bind_column<float>(c, "impulses", offsetof(Touch, impulse));
    bind_column<float>(c, "speeds", offsetof(Touch, speed));
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
