// Many bodies at once: references to them, and writing their values from arrays.
#include "bulk.hpp"
#include "bind/refs.hpp"
#include "bind/values.hpp"
#include <nanobind/stl/tuple.h>

namespace evil::bind {
namespace {

int get_buffer(PyObject* self, Py_buffer* buffer, int flags) {
    BodyRefs* refs = nb::inst_ptr<BodyRefs>(self);
    if (refs->slots.empty())
        for (BodyRef ref : refs->refs) refs->slots.push_back(ref.slot);
    refs->count = static_cast<Py_ssize_t>(refs->slots.size());
    auto bytes = refs->count * static_cast<Py_ssize_t>(sizeof(std::uint32_t));
    int failed = PyBuffer_FillInfo(buffer, self, refs->slots.data(), bytes, 1, flags);
    if (failed) return failed;
    buffer->itemsize = sizeof(std::uint32_t);
    if (flags & PyBUF_FORMAT) buffer->format = const_cast<char*>("I");
    if (flags & PyBUF_ND) buffer->shape = &refs->count;
    if ((flags & PyBUF_STRIDES) == PyBUF_STRIDES) buffer->strides = &refs->stride;
    return 0;
}

PyType_Slot slots[] = {{Py_bf_getbuffer, reinterpret_cast<void*>(get_buffer)}, {0, nullptr}};

[[noreturn]] void raise_at(const char* owner, std::size_t i, std::uint32_t slot, const char* what) {
    raise(ErrorKind::argument,
          std::string(owner) + ": indices[" + std::to_string(i) + "]=" + std::to_string(slot) + " " + what);
}

// Which bodies are meant: those named, or all of them; the second list says which value is whose.
struct Meant {
    std::vector<std::uint32_t> bodies;
    std::vector<std::size_t> values; // empty: each in turn
};

Meant all_bodies(const World& w, std::size_t count, const char* owner, bool moving) {
    Meant meant;
    if (count != w.bodies.slots.size())
        raise(ErrorKind::argument, std::string(owner) + ": there are " + std::to_string(count) + " values for " +
                                       std::to_string(w.bodies.slots.size()) +
                                       " rows of the world's arrays; name the bodies with indices=");
    for (std::uint32_t slot = 0; slot < w.bodies.slots.size(); ++slot) {
        if (!w.bodies.slots.taken(slot) || (moving && !moves(w.bodies.rows[slot]))) continue;
        meant.bodies.push_back(slot);
        meant.values.push_back(slot);
    }
    return meant;
}

Meant named_bodies(const World& w, nb::handle indices, std::size_t count, const char* owner, bool moving) {
    Meant meant;
    const BodyRefs* refs = nullptr;
    if (nb::try_cast<const BodyRefs*>(indices, refs) && refs) {
        for (std::size_t i = 0; i < refs->refs.size(); ++i) {
            if (!w.bodies.slots.alive(refs->refs[i]))
                raise(ErrorKind::stale_reference, std::string(owner) + ": indices[" + std::to_string(i) +
                                                      "] is a Body that was destroyed or restored away");
            meant.bodies.push_back(refs->refs[i].slot);
        }
    } else {
        meant.bodies = to_indices(indices, owner, "indices");
    }
    for (std::size_t i = 0; i < meant.bodies.size(); ++i) {
        std::uint32_t slot = meant.bodies[i];
        if (slot >= w.bodies.slots.size() || !w.bodies.slots.taken(slot)) raise_at(owner, i, slot, "is no body's slot");
        if (moving && !moves(w.bodies.rows[slot]))
            raise_at(owner, i, slot, "is a static body, whose velocity cannot change; make it kinematic or dynamic");
    }
    if (count != meant.bodies.size())
        raise(ErrorKind::argument, std::string(owner) + ": there are " + std::to_string(count) + " values for " +
                                       std::to_string(meant.bodies.size()) + " indices");
    return meant;
}

Meant meant_by(const World& w, nb::handle indices, std::size_t count, const char* owner, bool moving) {
    return indices.is_none() ? all_bodies(w, count, owner, moving) : named_bodies(w, indices, count, owner, moving);
}

template <class T> std::vector<T> chosen(std::vector<T> values, const Meant& meant) {
    if (meant.values.empty()) return values;
    std::vector<T> list;
    list.reserve(meant.values.size());
    for (std::size_t i : meant.values) list.push_back(values[i]);
    return list;
}

void write_positions(World& w, nb::handle values, nb::handle indices) {
    constexpr const char* kMe = "Bodies.set_positions";
    std::vector<Vec2> points = to_points(values, kMe, "values", kPlaces);
    Meant meant = meant_by(w, indices, points.size(), kMe, false);
    set_positions(w, meant.bodies, chosen(std::move(points), meant));
}

void write_angles(World& w, nb::handle values, nb::handle indices) {
    constexpr const char* kMe = "Bodies.set_angles";
    std::vector<double> angles = to_numbers(values, kMe, "values", kAngles);
    Meant meant = meant_by(w, indices, angles.size(), kMe, false);
    set_angles(w, meant.bodies, chosen(std::move(angles), meant));
}

void write_velocities(World& w, nb::handle values, nb::handle indices) {
    constexpr const char* kMe = "Bodies.set_velocities";
    std::vector<Vec2> speeds = to_points(values, kMe, "values", kSpeeds);
    Meant meant = meant_by(w, indices, speeds.size(), kMe, true);
    set_velocities(w, meant.bodies, chosen(std::move(speeds), meant));
}

void write_spins(World& w, nb::handle values, nb::handle indices) {
    constexpr const char* kMe = "Bodies.set_angular_velocities";
    std::vector<double> numbers = to_numbers(values, kMe, "values", kSpins);
    Meant meant = meant_by(w, indices, numbers.size(), kMe, true);
    std::vector<float> spins(numbers.begin(), numbers.end());
    set_spins(w, meant.bodies, chosen(std::move(spins), meant));
}

template <auto Apply> void push(World& w, nb::handle values, nb::handle indices, nb::handle points, const char* owner) {
    std::vector<Vec2> pushes = to_points(values, owner, "values", kPushes), at;
    if (!points.is_none()) {
        at = to_points(points, owner, "points", kPlaces);
        if (at.size() != pushes.size())
            raise(ErrorKind::argument, std::string(owner) + ": there are " + std::to_string(at.size()) +
                                           " points for " + std::to_string(pushes.size()) + " values");
    }
    Meant meant = meant_by(w, indices, pushes.size(), owner, false);
    Apply(w, meant.bodies, chosen(std::move(pushes), meant), points.is_none() ? at : chosen(std::move(at), meant));
}

void push_forces(World& w, nb::handle values, nb::handle indices, nb::handle points) {
    push<push_bodies>(w, values, indices, points, "Bodies.apply_forces");
}

void push_impulses(World& w, nb::handle values, nb::handle indices, nb::handle points) {
    push<kick_bodies>(w, values, indices, points, "Bodies.apply_impulses");
}

} // namespace

void register_bulk(nb::module_& module, nb::class_<World>& world) {
    nb::class_<BodyRefs> c(module, "BodyRefs", nb::type_slots(slots), "References to many bodies; a buffer of slots.");
    c.def("__len__", [](const BodyRefs& r) { return r.refs.size(); });
    c.def("__getitem__", [](const BodyRefs& r, Py_ssize_t i) {
        auto n = static_cast<Py_ssize_t>(r.refs.size());
        if (i < 0) i += n;
        if (i < 0 || i >= n) throw nb::index_error("there are not so many bodies");
        BodyRef ref = r.refs[static_cast<std::size_t>(i)];
        return std::tuple(ref.slot, ref.generation);
    });
    auto values = nb::arg("values").none(), indices = nb::arg("indices").none(), points = nb::arg("points").none();
    world.def("set_positions", write_positions, values, indices);
    world.def("set_angles", write_angles, values, indices);
    world.def("set_velocities", write_velocities, values, indices);
    world.def("set_spins", write_spins, values, indices);
    world.def("apply_forces", push_forces, values, indices, points);
    world.def("apply_impulses", push_impulses, values, indices, points);
}

} // namespace evil::bind
