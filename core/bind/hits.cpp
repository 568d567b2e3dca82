#include "bind/hits.hpp"

namespace evil::bind {
namespace {

template <class T> int visit_world(PyObject* self, visitproc visit, void* arg) { // a hit may lie in a cycle of garbage
    Py_VISIT(Py_TYPE(self));
    if (nb::inst_ready(self)) Py_VISIT(nb::inst_ptr<T>(self)->world.ptr());
    return 0;
}
template <class T> int clear_world(PyObject* self) {
    nb::inst_ptr<T>(self)->world.reset();
    return 0;
}
template <class T>
PyType_Slot kSlots[] = {{Py_tp_traverse, reinterpret_cast<void*>(visit_world<T>)},
                        {Py_tp_clear, reinterpret_cast<void*>(clear_world<T>)},
                        {0, nullptr}};

nb::object body_of(const nb::object& world, BodyRef ref) { return world.attr("_body")(ref.slot, ref.generation); }
nb::object shape_of(const nb::object& world, ShapeRef ref) { return world.attr("_shape")(ref.slot, ref.generation); }

std::string text_of(nb::handle value) { return nb::cast<std::string>(nb::repr(value)); }

bool same(const Hit& a, const Hit& b) {
    return a.world.is(b.world) && a.body == b.body && a.shape == b.shape && a.point == b.point &&
           a.normal == b.normal && a.value == b.value;
}

template <class T> nb::class_<T> bind_hit(nb::module_& module, const char* name, const char* doc) {
    nb::class_<T> c(module, name, nb::type_slots(kSlots<T>), doc);
    c.def_prop_ro(
        "body", [](const T& h) { return body_of(h.world, h.body); },
        nb::for_getter(nb::sig("def body(self) -> evilengine.world.body.Body")), "Whose shape it is.");
    c.def_prop_ro(
        "shape", [](const T& h) { return shape_of(h.world, h.shape); },
        nb::for_getter(nb::sig("def shape(self) -> evilengine.world.body.Shape")), "Which of its shapes.");
    c.def(
        "__eq__",
        [](const T& h, nb::handle other) {
            const T* o = nullptr;
            return nb::try_cast<const T*>(other, o) && o && same(h, *o);
        },
        nb::arg("other").none(), nb::sig("def __eq__(self, other: object, /) -> bool"));
    c.def("__hash__", [](const T& h) {
        return nb::hash(nb::make_tuple(h.body.slot, h.body.generation, h.shape.slot, h.value, h.point.x, h.point.y));
    });
    return c;
}

// A column as a memoryview, which keeps the whole table alive.
template <class Element> using Column = nb::ndarray<nb::memview, const Element, nb::ndim<1>, nb::c_contig>;
template <class Element> using Pairs = nb::ndarray<nb::memview, const Element, nb::shape<-1, 2>, nb::c_contig>;

template <class Element> Column<Element> column(const std::vector<Element>& values, nb::handle owner) {
    return Column<Element>(values.data(), {values.size()}, owner);
}
Pairs<float> pairs(const std::vector<Vec2>& values, nb::handle owner) {
    return Pairs<float>(reinterpret_cast<const float*>(values.data()), {values.size(), 2}, owner);
}

std::size_t row_of(Py_ssize_t i, std::size_t rows) {
    if (i < 0) i += static_cast<Py_ssize_t>(rows);
    if (i < 0 || i >= static_cast<Py_ssize_t>(rows)) throw nb::index_error("there is no such row");
    return static_cast<std::size_t>(i);
}

template <class T> T& self_of(nb::handle self) { return *nb::inst_ptr<T>(self); }

template <class T, class One> nb::class_<T> bind_hits(nb::module_& module, const char* name, const char* doc) {
    nb::class_<T> c(module, name, nb::type_slots(kSlots<T>), doc);
    c.def("__len__", [](const T& h) { return h.body.size(); });
    c.def("__getitem__", [](const T& h, Py_ssize_t index) -> nb::object {
        std::size_t i = row_of(index, h.body.size());
        if (h.body[i].slot == kNone) return nb::none();
        One one;
        static_cast<Hit&>(one) = {h.world, h.body[i], h.shape[i], h.points[i], h.normals[i], h.values[i]};
        return nb::cast(std::move(one));
    });
    auto memory = [&c](const char* what, auto get, const char* text) {
        std::string signature = "def " + std::string(what) + "(self) -> memoryview";
        c.def_prop_ro(what, get, nb::for_getter(nb::sig(signature.c_str())), text);
    };
    memory(
        "bodies", [](nb::handle self) { return column(self_of<T>(self).bodies, self); },
        "(n,) int32: slots of the bodies, as in the rows of world.bodies.positions; -1 where there is none.");
    memory(
        "shapes", [](nb::handle self) { return column(self_of<T>(self).shapes, self); },
        "(n,) int32: slots of the shapes; -1 where there is none.");
    memory(
        "points", [](nb::handle self) { return pairs(self_of<T>(self).points, self); },
        "(n, 2) float32: where in the world.");
    return c;
}

void bind_lists(nb::module_& module) {
    nb::class_<BodyLists> c(module, "BodyLists", nb::type_slots(kSlots<BodyLists>),
                            "The bodies that many questions found: `found[i]` is the tuple of bodies of question i. "
                            "As arrays: its bodies' slots are `bodies[starts[i]:starts[i + 1]]`.");
    c.def("__len__", [](const BodyLists& l) { return l.starts.size() - 1; });
    c.def(
        "__getitem__",
        [](const BodyLists& l, Py_ssize_t index) {
            std::size_t i = row_of(index, l.starts.size() - 1);
            nb::list found;
            for (std::uint32_t k = l.starts[i]; k < l.starts[i + 1]; ++k) found.append(body_of(l.world, l.body[k]));
            return nb::tuple(found);
        },
        nb::sig("def __getitem__(self, index: int, /) -> tuple[evilengine.world.body.Body, ...]"));
    c.def_prop_ro(
        "bodies", [](nb::handle self) { return column(self_of<BodyLists>(self).bodies, self); },
        nb::for_getter(nb::sig("def bodies(self) -> memoryview")), "uint32: slots of all bodies found.");
    c.def_prop_ro(
        "starts", [](nb::handle self) { return column(self_of<BodyLists>(self).starts, self); },
        nb::for_getter(nb::sig("def starts(self) -> memoryview")), "(n + 1,) uint32: where each question's begin.");
}

} // namespace

Hit hit_of(nb::handle owner, const World& w, std::uint32_t body, std::uint32_t shape, Vec2 point, Vec2 normal,
           float value) {
    return {nb::borrow(owner),
            {body, w.bodies.slots.generation(body)},
            {shape, w.shapes.slots.generation(shape)},
            point,
            normal,
            value};
}

Hits::Hits(nb::object owner, std::size_t n)
    : world(std::move(owner)), body(n), shape(n), bodies(n, -1), shapes(n, -1), points(n), normals(n), values(n) {}

void Hits::set(const World& w, std::size_t row, std::uint32_t of_body, std::uint32_t of_shape, Vec2 point, Vec2 normal,
               float value) {
    body[row] = {of_body, w.bodies.slots.generation(of_body)};
    shape[row] = {of_shape, w.shapes.slots.generation(of_shape)};
    bodies[row] = static_cast<std::int32_t>(of_body);
    shapes[row] = static_cast<std::int32_t>(of_shape);
    points[row] = point;
    normals[row] = normal;
    values[row] = value;
}

void register_hits(nb::module_& module) {
    auto ray = bind_hit<Hit>(module, "RayHit", "Where a ray, or a shape that is moved, meets a shape.");
    ray.def_prop_ro("point", [](const Hit& h) { return from_vec2(h.point); }, "Where, in the world.");
    ray.def_prop_ro(
        "normal", [](const Hit& h) { return from_vec2(h.normal); }, "Direction of length 1 out of the shape.");
    ray.def_prop_ro(
        "fraction", [](const Hit& h) { return h.value; }, "How far along the way, 0 at its start, 1 at its end.");
    ray.def("__repr__", [](const Hit& h) {
        return "<RayHit, " + text_of(body_of(h.world, h.body)) + " at " + text_of(from_vec2(h.point)) + ">";
    });
    auto near = bind_hit<NearestHit>(module, "Nearest", "The shape that is nearest to a point.");
    near.def_prop_ro(
        "point", [](const NearestHit& h) { return from_vec2(h.point); }, "The point of the shape that is nearest.");
    near.def_prop_ro(
        "distance", [](const NearestHit& h) { return h.value; }, "Metres; 0 when the shape covers the point.");
    near.def("__repr__", [](const NearestHit& h) {
        return "<Nearest, " + text_of(body_of(h.world, h.body)) + " at " + text_of(from_vec2(h.point)) + ">";
    });

    auto rays = bind_hits<Hits, Hit>(
        module, "RayHits",
        "What many rays, or shapes that are moved, met: columns with a row for each. `hits[i]` is its "
        "RayHit or None; `numpy.asarray(hits.points)` needs no copy.");
    rays.def_prop_ro(
        "normals", [](nb::handle self) { return pairs(self_of<Hits>(self).normals, self); },
        nb::for_getter(nb::sig("def normals(self) -> memoryview")),
        "(n, 2) float32: out of the shape; zeros where nothing was met.");
    rays.def_prop_ro(
        "fractions", [](nb::handle self) { return column(self_of<Hits>(self).values, self); },
        nb::for_getter(nb::sig("def fractions(self) -> memoryview")),
        "(n,) float32: how far along the way; 1 where nothing was met.");
    auto nears = bind_hits<NearestHits, NearestHit>(
        module, "Nearests",
        "What is nearest to many points: columns with a row for each. `found[i]` is its Nearest "
        "or None.");
    nears.def_prop_ro(
        "distances", [](nb::handle self) { return column(self_of<NearestHits>(self).values, self); },
        nb::for_getter(nb::sig("def distances(self) -> memoryview")),
        "(n,) float32: metres; infinite where nothing is near enough.");
    bind_lists(module);
}

} // namespace evil::bind
