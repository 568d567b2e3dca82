#include "bind/traits.hpp"
#include "bind/views.hpp"
#include "snapshot.hpp"
#include <nanobind/stl/pair.h>
#include <nanobind/stl/tuple.h>

namespace evil::bind {

Area area_of(const NewShape& spec, nb::handle at, double angle);
void register_events(nb::module_& module, nb::class_<World>& world);
NewShape used(const NewShape& spec, nb::handle offset, double angle, float density, float friction, float restitution);
void bind_queries(nb::module_& module, nb::class_<World>& world);

void register_adding(nb::module_& module, nb::class_<World>& world);
void register_bulk(nb::module_& module, nb::class_<World>& world);

void raise_mass(MassProblem problem, const char* owner) {
    const char* what =
        problem == MassProblem::too_small ? "less than 1e-12 kg" : "more than 1e12 kg, or turns too heavily";
    raise(ErrorKind::shape,
          std::string(owner) + ": the body would weigh " + what + "; change density=, mass= or the shape's size");
}

void raise_matrix(MatrixProblem problem, const char* owner) {
    const char* what = "";
    switch (problem) {
    case MatrixProblem::none:
        break;
    case MatrixProblem::flat:
        what = "would make it flat (the matrix has no inverse, or shrinks below 1e-4)";
        break;
    case MatrixProblem::sheared:
        what = "would shear the body, whose matrix holds position, rotation and scale; apply it to its shapes";
        break;
    case MatrixProblem::squeezes_circle:
        what = "would squeeze a Circle, which stays round: scale x and y alike, or use a Polygon";
        break;
    case MatrixProblem::too_large:
        what = "would make it larger than 1e4 times or move it out of the world";
        break;
    case MatrixProblem::mass:
        what = "would give it a mass out of range (1e-12 to 1e12 kg)";
        break;
    }
    raise(ErrorKind::shape, std::string(owner) + ": this " + what);
}

Affine to_affine(nb::handle matrix, const char* owner) {
    float v[16];
    std::size_t n = 0;
    if (!PySequence_Check(matrix.ptr()))
        raise(ErrorKind::argument_type, std::string(owner) + ": matrix must be a Mat4 or 16 numbers");
    for (nb::handle value : nb::iter(matrix)) {
        if (n == 16)
            raise(ErrorKind::argument,
                  std::string(owner) + ": matrix must have 16 numbers, column by column; got more");
        v[n++] = to_float(value, owner, "matrix");
    }
    if (n != 16)
        raise(ErrorKind::argument,
              std::string(owner) + ": matrix must have 16 numbers, column by column; got " + std::to_string(n));
    bool planar =
        v[2] == 0 && v[3] == 0 && v[6] == 0 && v[7] == 0 && v[8] == 0 && v[9] == 0 && v[11] == 0 && v[15] == 1;
    if (!planar)
        raise(ErrorKind::argument,
              std::string(owner) + ": matrix must map the plane to itself: x and y only, last row 0 0 0 1");
    return {v[0], v[1], v[4], v[5], v[12], v[13]};
}

Floats from_affine(const Affine& m) {
    return nb::borrow<Floats>(
        nb::make_tuple(m.a, m.b, 0.0f, 0.0f, m.c, m.d, 0.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f, m.tx, m.ty, 0.0f, 1.0f));
}

namespace {

View view_of(const World& w, std::vector<float> Arrays::* values, Py_ssize_t columns) {
    return {w.arrays, (*w.arrays).*values, static_cast<Py_ssize_t>(w.bodies.slots.size()), columns};
}

std::vector<std::uint32_t> body_slots(const World& w) { // in creation order
    std::vector<std::uint32_t> list;
    for (std::uint32_t slot = 0; slot < w.bodies.slots.size(); ++slot)
        if (w.bodies.slots.taken(slot)) list.push_back(slot);
    std::ranges::sort(list, {}, [&](std::uint32_t slot) { return w.bodies.rows[slot].serial; });
    return list;
}

std::shared_ptr<SavedState> read_bytes(nb::bytes data) {
    ReadSnapshot read = read_snapshot({reinterpret_cast<const std::uint8_t*>(data.c_str()), data.size()});
    const char* what = "";
    switch (read.problem) {
    case SnapshotProblem::none:
        return read.state;
    case SnapshotProblem::not_a_snapshot:
        what = "these bytes are no snapshot of a world";
        break;
    case SnapshotProblem::other_version:
        what = "this snapshot is of another version of the engine";
        break;
    case SnapshotProblem::cut_short:
        what = "this snapshot is cut short; the world is as it was";
        break;
    case SnapshotProblem::damaged:
        what = "this snapshot is damaged; the world is as it was";
        break;
    case SnapshotProblem::inconsistent:
        what = "this snapshot contradicts itself; the world is as it was";
        break;
    }
    raise(ErrorKind::snapshot, std::string("World.restore: ") + what);
}

// A parsed snapshot on its way from read to restore; empty once it is used.
struct Saved {
    std::shared_ptr<SavedState> state;
};

// Slots whose object is another than it was, or gone.
std::vector<std::uint32_t> changed(const std::vector<std::uint32_t>& before, const Slots& now) {
    std::vector<std::uint32_t> slots;
    for (std::uint32_t slot = 0; slot < before.size(); ++slot)
        if (before[slot] != now.generation(slot)) slots.push_back(slot);
    return slots;
}

std::uint32_t add_force_of(World& w, int kind, bool everywhere, nb::handle vector, nb::handle anchor, bool at_anchor,
                           std::uint32_t target, float stiffness, float rest_length, float damping, float linear,
                           float quadratic, float limit, float density, const NewShape* area, nb::handle area_at,
                           double area_angle, std::string note) {
    Force f;
    f.kind = static_cast<ForceKind>(kind);
    f.everywhere = everywhere;
    f.vector = to_vec2(vector, "Force", "vector");
    f.anchor = to_vec2(anchor, "Force", "anchor");
    f.at_anchor = at_anchor;
    f.target = target;
    f.stiffness = stiffness;
    f.rest_length = rest_length;
    f.damping = damping;
    f.linear = linear;
    f.quadratic = quadratic;
    f.limit = limit;
    f.density = density;
    f.note = std::move(note);
    Area where;
    if (area) where = area_of(*area, area_at, area_angle);
    return add_force(w, std::move(f), std::move(where)).slot;
}

void bind_objects(nb::class_<World>& c) {
    c.def("add_shape", [](World& w, const BodyHandle& body, const NewShape& shape) {
        require_alive(body);
        Added<ShapeRef> added = add_shape(w, body.ref.slot, shape);
        if (added.problem != MassProblem::none) raise_mass(added.problem, "Body.add_shape");
        return added.ref.slot;
    });
    c.def("material", [](const World& w, std::uint32_t slot) {
        const Body& b = w.bodies.rows.at(slot);
        return nb::borrow<Floats>(nb::make_tuple(b.density, b.friction, b.restitution));
    });
    c.def("add_force", add_force_of, nb::kw_only(), nb::arg("kind"), nb::arg("everywhere"), nb::arg("vector"),
          nb::arg("anchor"), nb::arg("at_anchor"), nb::arg("target"), nb::arg("stiffness"), nb::arg("rest_length"),
          nb::arg("damping"), nb::arg("linear"), nb::arg("quadratic"), nb::arg("limit"), nb::arg("density"),
          nb::arg("area").none(), nb::arg("area_at"), nb::arg("area_angle"), nb::arg("note"));
    c.def("body_slots", body_slots);
    c.def("force_slots", [](const World& w) {
        std::vector<std::uint32_t> list;
        for (std::uint32_t s = 0; s < w.forces.slots.size(); ++s)
            if (w.forces.slots.taken(s)) list.push_back(s);
        return list;
    });
    c.def("body_generation", [](const World& w, std::uint32_t slot) {
        return slot < w.bodies.slots.size() ? w.bodies.slots.generation(slot) : 0u;
    });
    c.def("shape_generation", [](const World& w, std::uint32_t slot) {
        return slot < w.shapes.slots.size() ? w.shapes.slots.generation(slot) : 0u;
    });
    c.def("force_generation", [](const World& w, std::uint32_t slot) {
        return slot < w.forces.slots.size() ? w.forces.slots.generation(slot) : 0u;
    });
    c.def_prop_ro("body_count", [](const World& w) { return w.bodies.slots.count(); });
}

} // namespace

void register_world(nb::module_& module) {
    module.def(
        "check_traits", [](Words words, const char* owner) { (void)to_traits(words, owner); }, nb::arg("words"),
        nb::arg("owner"), "Raise what is wrong with any of them.");
    module.def("use", used, nb::arg("spec"), nb::arg("offset"), nb::arg("angle"), nb::arg("density"),
               nb::arg("friction"), nb::arg("restitution"), "A shape with the place and material of one use.");
    nb::class_<World> c(module, "World", "The simulation's state and kernels.");
    c.def(nb::init<>());
    c.def(
        "step",
        [](World& w, float dt, int substeps) {
            Meanwhile others(is_large(w));
            w.step(dt, substeps);
        },
        nb::arg("dt"), nb::arg("substeps"));
    c.def_prop_rw(
        "gravity", [](const World& w) { return from_vec2(w.gravity); },
        [](World& w, nb::handle value) { set_gravity(w, to_vec2(value, "World", "gravity")); });
    c.def_prop_rw("sleep", [](const World& w) { return w.sleep_allowed; }, allow_sleep);
    c.def_prop_rw(
        "instruction_set", [](const World& w) { return name(w.instruction_set); },
        [](World& w, const std::string& wanted) {
            for (InstructionSet set : runnable_instruction_sets())
                if (wanted == name(set)) return void(w.instruction_set = set);
            raise(ErrorKind::argument, "World: instruction_set=" + wanted + " is not one that this machine can run");
        },
        "Which kernels it runs on. The bits are the same with any; tests compare them.");
    c.def_prop_rw(
        "threads", [](const World& w) { return w.threads.count(); },
        [](World& w, int count) { w.threads.set_count(count); },
        "How many threads a step may use. The bits are the same with any number.");
    c.def_ro("steps", &World::steps);
    c.def_ro("time", &World::time);
    bind_objects(c);
    register_adding(module, c);
    register_bulk(module, c);
    register_events(module, c);
    c.def_prop_ro("positions", [](const World& w) { return view_of(w, &Arrays::positions, 2); });
    c.def_prop_ro("angles", [](const World& w) { return view_of(w, &Arrays::angles, 1); });
    c.def_prop_ro("velocities", [](const World& w) { return view_of(w, &Arrays::velocities, 2); });
    c.def_prop_ro("matrices", [](const World& w) { return view_of(w, &Arrays::matrices, 16); });
    bind_queries(module, c);
    c.def("snapshot", [](World& w) {
        settle_fluids(w);
        const std::size_t size = snapshot_size(w);
        nb::bytes bytes = nb::steal<nb::bytes>(PyBytes_FromStringAndSize(nullptr, static_cast<Py_ssize_t>(size)));
        if (!bytes.is_valid()) throw std::bad_alloc();
        std::span<std::uint8_t> room(reinterpret_cast<std::uint8_t*>(PyBytes_AsString(bytes.ptr())), size);
        Meanwhile others(is_large(w));
        write_snapshot(w, room);
        return bytes;
    });
    nb::class_<Saved> saved(module, "Saved", "A snapshot that was read and found whole.");
    saved.def("__init__", [](Saved* self, nb::bytes data) { new (self) Saved{read_bytes(data)}; });
    saved.def_prop_ro("notes",
                      [](const Saved& s) { return s.state ? notes_of(*s.state) : std::vector<std::string>{}; });
    saved.def_prop_ro("slots", [](const Saved& s) {
        const SavedSlots slots = s.state ? slots_of(*s.state) : SavedSlots{};
        return std::tuple(slots.bodies, slots.shapes, slots.forces, slots.joints, slots.smokes, slots.sources,
                          slots.waters, slots.streams, slots.liquids);
    });
    saved.def_prop_ro(
        "shape_bodies",
        [](const Saved& s) { return s.state ? slots_of(*s.state).shape_bodies : std::vector<std::uint32_t>{}; },
        "Of each of the shapes in `slots`, the slot of the body that it is on.");
    c.def("restore", [](World& w, Saved& s) {
        if (!s.state) raise(ErrorKind::snapshot, "World.restore: this snapshot was used up; read it again");
        const std::vector<std::uint32_t> bodies = w.bodies.slots.generations(), shapes = w.shapes.slots.generations();
        const std::shared_ptr<SavedState> state = std::move(s.state);
        {
            Meanwhile others(is_large(w));
            restore(w, *state);
        }
        return std::pair(changed(bodies, w.bodies.slots), changed(shapes, w.shapes.slots));
    });
    c.def("checksum", [](const World& w) {
        Meanwhile others(is_large(w));
        return checksum(w);
    });
    c.def("sums", [](const World& w) {
        const Sums each = sums(w);
        return std::tuple(each.bodies, each.contacts, each.forces);
    });
}

} // namespace evil::bind
