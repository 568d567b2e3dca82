// Adding bodies, one by one and many at once.
#include "bind/refs.hpp"
#include "bind/traits.hpp"
#include "bind/values.hpp"
#include "bulk.hpp"
#include <nanobind/stl/tuple.h>

namespace evil::bind {
namespace {

constexpr const char* kMany = "World.add_many";
using Specs = std::vector<const NewShape*>;

// The recipe's body with these shapes, made of the recipe's material.
Recipe with_shapes(const Recipe& recipe, const Specs& specs) {
    Recipe full{recipe.row, {}, recipe.traits};
    full.shapes.reserve(specs.size());
    for (const NewShape* spec : specs) {
        NewShape& shape = full.shapes.emplace_back(*spec);
        shape.shape.local = affine(Pose{{}, rotation(0.0)});
        shape.shape.material = {recipe.row.density, recipe.row.friction, recipe.row.restitution};
    }
    return full;
}

// What most callers give, read at once: false for anything else, which the face looks at more closely.
bool plain_number(PyObject* value, double most, double& out) {
    if (!PyFloat_CheckExact(value) && !PyLong_CheckExact(value)) return false;
    out = PyFloat_AsDouble(value);
    if (out == -1.0 && PyErr_Occurred()) {
        PyErr_Clear();
        return false;
    }
    return std::abs(out) <= most;
}

bool plain_point(PyObject* value, double most, Vec2& out) {
    double x = 0.0, y = 0.0;
    if (!PyTuple_Check(value) || PyTuple_Size(value) != 2) return false;
    if (!plain_number(PyTuple_GetItem(value, 0), most, x) || !plain_number(PyTuple_GetItem(value, 1), most, y))
        return false;
    out = {static_cast<float>(x), static_cast<float>(y)};
    return true;
}

bool plain_text(PyObject* value, std::string& out) {
    if (value == Py_None) return true;
    if (!PyUnicode_CheckExact(value) || PyUnicode_GetLength(value) > 1000) return false;
    Py_ssize_t size = 0;
    const char* text = PyUnicode_AsUTF8AndSize(value, &size);
    if (!text) {
        PyErr_Clear();
        return false;
    }
    out.assign(text, static_cast<std::size_t>(size));
    return true;
}

// The body's slot and generation, and the slots of its shapes.
using Numbers = nb::typed<nb::list, int>;

void append_shape_slots(const World& w, std::uint32_t body, nb::list& slots) {
    for (std::uint32_t s = w.bodies.rows[body].first_shape; s != kNone; s = w.shapes.rows[s].next) slots.append(s);
}

Numbers numbers_of(const World& w, BodyRef ref) {
    nb::list list;
    list.append(ref.slot);
    list.append(ref.generation);
    append_shape_slots(w, ref.slot, list);
    return nb::borrow<Numbers>(list);
}

std::optional<Numbers> add(World& w, const Recipe& recipe, const Specs& specs, nb::handle at, nb::handle angle,
                           nb::handle velocity, nb::handle spin, nb::handle tag) {
    Recipe full = with_shapes(recipe, specs);
    std::string name;
    double turn = 0.0, turning = 0.0;
    if (!plain_point(at.ptr(), kWorldEdge, full.row.pose.p) || !(length(full.row.pose.p) <= kWorldEdge) ||
        !plain_number(angle.ptr(), kMaxAngle, turn) || !plain_point(velocity.ptr(), kMaxSpeed, full.row.velocity) ||
        !plain_number(spin.ptr(), kMaxSpin, turning) || !plain_text(tag.ptr(), name))
        return {};
    full.row.angle = turn;
    full.row.spin = static_cast<float>(turning);
    Added<BodyRef> added = add_body(w, full.row, name, full.shapes, full.traits);
    if (added.problem != MassProblem::none) raise_mass(added.problem, "World.add()");
    return numbers_of(w, added.ref);
}

void check_count(bool given, std::size_t count, std::size_t bodies, const char* argument) {
    if (given && count != bodies)
        raise(ErrorKind::argument, std::string(kMany) + ": " + argument + " has " + std::to_string(count) +
                                       " values for " + std::to_string(bodies) + " positions");
}

Starts read_starts(nb::handle positions, nb::handle angles, nb::handle velocities, nb::handle spins) {
    Starts s;
    s.positions = to_points(positions, kMany, "positions", kPlaces);
    if (!angles.is_none()) s.angles = to_numbers(angles, kMany, "angles", kAngles);
    if (!velocities.is_none()) s.velocities = to_points(velocities, kMany, "velocities", kSpeeds);
    if (!spins.is_none())
        for (double spin : to_numbers(spins, kMany, "angular_velocities", kSpins))
            s.spins.push_back(static_cast<float>(spin));
    check_count(!angles.is_none(), s.angles.size(), s.positions.size(), "angles");
    check_count(!velocities.is_none(), s.velocities.size(), s.positions.size(), "velocities");
    check_count(!spins.is_none(), s.spins.size(), s.positions.size(), "angular_velocities");
    return s;
}

// The bodies, and the slots of their shapes, body after body.
std::tuple<BodyRefs, Numbers> add_all(World& w, const Recipe& recipe, const Specs& specs, nb::handle positions,
                                      nb::handle angles, nb::handle velocities, nb::handle spins,
                                      const std::string& tag) {
    Starts starts = read_starts(positions, angles, velocities, spins);
    BodyRefs added;
    MassProblem problem = add_many(w, with_shapes(recipe, specs), starts, tag, added.refs);
    if (problem != MassProblem::none) raise_mass(problem, kMany);
    nb::list shapes;
    for (BodyRef ref : added.refs) append_shape_slots(w, ref.slot, shapes);
    return {std::move(added), nb::borrow<Numbers>(shapes)};
}

// The same objects in the same order? Equal ones are not enough: True equals 1.
bool identical(Anything a, Anything b) {
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (!nb::handle(a[i]).is(b[i])) return false;
    return true;
}

void bind_recipe(nb::module_& module) {
    nb::class_<Recipe> c(module, "Recipe", "What new bodies shall be, wherever they are. The face has checked it.");
    c.def(
        "__init__",
        [](Recipe* self, int kind, float density, float mass, float friction, float restitution, float damping,
           float angular_damping, float drag, float gravity_scale, bool bullet, bool touchable,
           std::optional<Words> traits, const char* owner) {
            Recipe r;
            Body& b = r.row;
            b.kind = static_cast<BodyKind>(kind);
            b.density = density;
            b.set_mass = mass;
            b.friction = friction;
            b.restitution = restitution;
            b.damping = damping;
            b.angular_damping = angular_damping;
            b.drag = drag;
            b.gravity_scale = gravity_scale;
            b.bullet = bullet;
            b.touchable = touchable;
            if (traits) r.traits = to_traits(*traits, owner);
            new (self) Recipe(std::move(r));
        },
        nb::kw_only(), nb::arg("kind"), nb::arg("density"), nb::arg("mass"), nb::arg("friction"),
        nb::arg("restitution"), nb::arg("damping"), nb::arg("angular_damping"), nb::arg("drag"),
        nb::arg("gravity_scale"), nb::arg("bullet"), nb::arg("touchable"), nb::arg("traits") = nb::none(),
        nb::arg("owner") = "World.add()");
}

} // namespace

void register_adding(nb::module_& module, nb::class_<World>& world) {
    bind_recipe(module);
    module.def("identical", identical, nb::arg("a"), nb::arg("b"), "The same objects in the same order?");
    world.def("add", add, nb::arg("recipe"), nb::arg("shapes"), nb::arg("at").none(), nb::arg("angle").none(),
              nb::arg("velocity").none(), nb::arg("spin").none(), nb::arg("tag").none(),
              "The new body's slot and generation, and its shapes' slots; None where an argument is not plain.");
    world.def("add_many", add_all, nb::arg("recipe"), nb::arg("shapes"), nb::arg("positions").none(),
              nb::arg("angles").none(), nb::arg("velocities").none(), nb::arg("spins").none(), nb::arg("tag"));
}

} // namespace evil::bind
