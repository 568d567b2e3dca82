#include "bind/traits.hpp"

namespace evil::bind {
namespace {

constexpr const char* kOwner = "Body";

// To read a value may run Python (a `__float__`), which may change the world: rows are looked up after it.

// A float field of the row that any number in a range may be written to; writing wakes the body.
template <float Body::* Field>
void bind_float(nb::class_<BodyHandle>& c, const char* name, float least, float most, const char* doc) {
    def_value(
        c, name, kNumber, [](const BodyHandle& h) { return row(h).*Field; },
        [name, least, most](const BodyHandle& h, nb::handle value) {
            float number = in_range(value, kOwner, name, least, most);
            row(h).*Field = number;
            wake(*h.world, h.ref.slot);
        },
        doc);
}

// A material value of all the body's shapes at once, and of those to come.
template <float Body::* Field, float Material::* Each>
void bind_material(nb::class_<BodyHandle>& c, const char* name, float most, const char* doc) {
    def_value(
        c, name, kNumber, [](const BodyHandle& h) { return row(h).*Field; },
        [name, most](const BodyHandle& h, nb::handle value) {
            float number = in_range(value, kOwner, name, 0.0f, most);
            Body& b = row(h);
            b.*Field = number;
            Shapes& shapes = h.world->shapes;
            for (std::uint32_t s = b.first_shape; s != kNone; s = shapes.rows[s].next)
                shapes.rows[s].material.*Each = b.*Field;
            ++shapes.material_changes;
            wake(*h.world, h.ref.slot);
        },
        doc);
}

void set_position(const BodyHandle& h, nb::handle value) {
    Vec2 p = to_vec2(value, kOwner, "position");
    if (!(length(p) <= kWorldEdge))
        raise(ErrorKind::argument, "Body: position must be within 1e7 metres of the origin");
    move_body(*h.world, h.ref.slot, p, row(h).angle);
}

void set_angle(const BodyHandle& h, nb::handle value) {
    to_float(value, kOwner, "angle"); // refuses what is no finite number
    double angle = PyFloat_AsDouble(value.ptr());
    move_body(*h.world, h.ref.slot, row(h).pose.p, angle);
}

void require_moving(const BodyHandle& h, const char* what) {
    if (row(h).kind == BodyKind::fixed)
        raise(ErrorKind::argument,
              std::string("Body: ") + what + " of a static body cannot change; make it kinematic or dynamic");
}

void set_velocity(const BodyHandle& h, nb::handle value) {
    Vec2 v = to_vec2(value, kOwner, "velocity");
    require_moving(h, "velocity");
    if (std::abs(v.x) > kMaxSpeed || std::abs(v.y) > kMaxSpeed)
        raise(ErrorKind::argument, "Body: velocity must be at most 1e5 m/s along each axis");
    row(h).velocity = v;
    wake(*h.world, h.ref.slot);
    publish(*h.world, h.ref.slot);
}

void set_spin(const BodyHandle& h, nb::handle value) {
    float spin = in_range(value, kOwner, "angular_velocity", -kMaxSpin, kMaxSpin);
    require_moving(h, "angular_velocity");
    row(h).spin = spin;
    wake(*h.world, h.ref.slot);
}

// A point of the world, or none for the centre of mass.
std::optional<Vec2> to_spot(nb::handle at, const char* owner) {
    if (at.is_none()) return {};
    return to_vec2(at, owner, "at");
}

void apply_force(const BodyHandle& h, nb::handle force, nb::handle at) {
    Vec2 f = to_vec2(force, "Body.apply_force", "force");
    std::optional<Vec2> p = to_spot(at, "Body.apply_force");
    Body& b = row(h);
    wake(*h.world, h.ref.slot);
    b.force = clamped(b.force + f, kMaxForce);
    b.torque = clamped(b.torque + cross(p.value_or(b.centre) - b.centre, f), kMaxForce);
}

void apply_impulse(const BodyHandle& h, nb::handle impulse, nb::handle at) {
    Vec2 j = to_vec2(impulse, "Body.apply_impulse", "impulse");
    std::optional<Vec2> p = to_spot(at, "Body.apply_impulse");
    Body& b = row(h);
    wake(*h.world, h.ref.slot);
    b.velocity = clamped(b.velocity + b.inv_mass * j, kMaxSpeed);
    b.spin = clamped(b.spin + b.inv_inertia * cross(p.value_or(b.centre) - b.centre, j), kMaxSpin);
    publish(*h.world, h.ref.slot);
}

void apply_torque(const BodyHandle& h, nb::handle torque) {
    float t = to_float(torque, "Body.apply_torque", "torque");
    Body& b = row(h);
    b.torque = clamped(b.torque + t, kMaxForce);
    wake(*h.world, h.ref.slot);
}

void apply_angular_impulse(const BodyHandle& h, nb::handle impulse) {
    float j = to_float(impulse, "Body.apply_angular_impulse", "impulse");
    Body& b = row(h);
    b.spin = clamped(b.spin + b.inv_inertia * j, kMaxSpin);
    wake(*h.world, h.ref.slot);
}

void set_mass_of(const BodyHandle& h, nb::handle value) {
    float mass = in_range(value, kOwner, "mass", kMinMass, kMaxMass);
    require_alive(h);
    MassProblem problem = set_mass(*h.world, h.ref.slot, mass);
    if (problem != MassProblem::none) raise_mass(problem, "Body.mass");
}

void set_scale_of(const BodyHandle& h, nb::handle value) {
    Vec2 scale = to_vec2(value, kOwner, "scale");
    require_alive(h);
    MatrixProblem problem = set_scale(*h.world, h.ref.slot, scale);
    if (problem != MatrixProblem::none) raise_matrix(problem, "Body.scale");
}

std::vector<std::uint32_t> shape_slots(const BodyHandle& h) {
    std::vector<std::uint32_t> list;
    for (std::uint32_t s = row(h).first_shape; s != kNone; s = h.world->shapes.rows[s].next) list.push_back(s);
    return list;
}

void bind_motion(nb::class_<BodyHandle>& c) {
    def_value(
        c, "position", kPoint, [](const BodyHandle& h) { return from_vec2(row(h).pose.p); }, set_position,
        "Where the body's origin is, the point that its shapes are placed by (metres). Writing it moves the body at "
        "once.");
    def_value(
        c, "angle", kNumber, [](const BodyHandle& h) { return row(h).angle; }, set_angle,
        "Radians, counter-clockwise; it is not wrapped, so two turns are 4 pi.");
    def_value(
        c, "velocity", kPoint, [](const BodyHandle& h) { return from_vec2(row(h).velocity); }, set_velocity,
        "Of the centre of mass, metres a second.");
    def_value(
        c, "angular_velocity", kNumber, [](const BodyHandle& h) { return row(h).spin; }, set_spin, "Radians a second.");
    c.def_prop_ro(
        "centre", [](const BodyHandle& h) { return from_vec2(row(h).centre); }, "The centre of mass, in the world.");
    def_method(
        c, kOwner, "velocity_at",
        "def velocity_at(self, point: evilengine.values.vec2.Point) -> evilengine.values.vec2.Vec2", {"point"},
        [](const BodyHandle& h, nb::handle point) {
            Vec2 p = to_vec2(point, "Body.velocity_at", "point");
            return from_vec2(velocity_at(row(h), p));
        },
        nb::arg("point").none(), "Velocity of the body's matter at a point of the world.");
    def_method(
        c, kOwner, "to_world", "def to_world(self, point: evilengine.values.vec2.Point) -> evilengine.values.vec2.Vec2",
        {"point"},
        [](const BodyHandle& h, nb::handle point) {
            Vec2 p = to_vec2(point, "Body.to_world", "point");
            return from_vec2(apply(body_matrix(row(h)), p));
        },
        nb::arg("point").none(), "A point of the body's own frame, in the world.");
    def_method(
        c, kOwner, "to_local", "def to_local(self, point: evilengine.values.vec2.Point) -> evilengine.values.vec2.Vec2",
        {"point"},
        [](const BodyHandle& h, nb::handle point) {
            Vec2 there = to_vec2(point, "Body.to_local", "point");
            const Body& b = row(h);
            Vec2 p = untransform(b.pose, there);
            return from_vec2({p.x / b.scale.x, p.y / b.scale.y});
        },
        nb::arg("point").none(), "A point of the world, in the body's own frame.");
}

void bind_pushes(nb::class_<BodyHandle>& c) {
    constexpr const char *kForce = "def apply_force(self, force: evilengine.values.vec2.Point,"
                                   " at: evilengine.values.vec2.Point | None = None) -> None",
                         *kImpulse = "def apply_impulse(self, impulse: evilengine.values.vec2.Point,"
                                     " at: evilengine.values.vec2.Point | None = None) -> None";
    def_method(c, kOwner, "apply_force", kForce, {"force", "at"}, apply_force, nb::arg("force").none(),
               nb::arg("at").none() = nb::none(),
               "Push with `force` (newtons) during the next step, at a point of the world; at the centre of mass "
               "without one.");
    def_method(c, kOwner, "apply_impulse", kImpulse, {"impulse", "at"}, apply_impulse, nb::arg("impulse").none(),
               nb::arg("at").none() = nb::none(),
               "Change the velocity at once by an impulse (newton seconds), at a point of the world or the centre of "
               "mass.");
    def_method(c, kOwner, "apply_torque", "def apply_torque(self, torque: float) -> None", {"torque"}, apply_torque,
               nb::arg("torque").none(), "Turn with `torque` (newton metres) during the next step.");
    def_method(c, kOwner, "apply_angular_impulse", "def apply_angular_impulse(self, impulse: float) -> None",
               {"impulse"}, apply_angular_impulse, nb::arg("impulse").none(), "Change the spin at once (kg m2/s).");
    c.def_prop_ro(
        "force", [](const BodyHandle& h) { return from_vec2(row(h).force); },
        "Gathered by apply_force since the last step.");
    c.def_prop_ro(
        "torque", [](const BodyHandle& h) { return row(h).torque; },
        "Gathered by apply_force and apply_torque since the last step.");
    c.def_prop_ro(
        "acceleration", [](const BodyHandle& h) { return from_vec2(row(h).acceleration); },
        "What gravity and forces gave it in the last step, contacts left out (m/s2).");
}

void bind_mass(nb::class_<BodyHandle>& c) {
    auto fixed = [](const Body& b) { return b.kind != BodyKind::dynamic; };
    def_value(
        c, "mass", kNumber, [fixed](const BodyHandle& h) { return fixed(row(h)) ? HUGE_VAL : double(row(h).mass); },
        set_mass_of, "Kilograms; infinite for a static or kinematic body. Writing it scales the inertia along.");
    c.def_prop_ro(
        "inertia", [fixed](const BodyHandle& h) { return fixed(row(h)) ? HUGE_VAL : double(row(h).inertia); },
        "About the centre of mass, kg m2; infinite for a static or kinematic body.");
    c.def_prop_ro(
        "inverse_mass", [](const BodyHandle& h) { return row(h).inv_mass; }, "1 / mass; 0: nothing moves it.");
    c.def_prop_ro(
        "inverse_inertia", [](const BodyHandle& h) { return row(h).inv_inertia; }, "1 / inertia; 0: nothing turns it.");
    bind_float<&Body::damping>(c, "damping", 0.0f, 1.0f, "Fraction of velocity kept per second; 1: none is lost.");
    bind_float<&Body::angular_damping>(c, "angular_damping", 0.0f, 1.0f,
                                       "Fraction of spin kept per second; 1: none is lost.");
    bind_float<&Body::drag>(c, "drag", 0.0f, 1e6f,
                            "How strongly drag and media act on it; 1 as they are, 0 not at all.");
    bind_float<&Body::gravity_scale>(c, "gravity_scale", -1e6f, 1e6f, "How strongly the world's gravity acts on it.");
    bind_material<&Body::friction, &Material::friction>(c, "friction", 1e6f,
                                                        "Of all its shapes; pairs mix as sqrt(a b).");
    bind_material<&Body::restitution, &Material::restitution>(c, "restitution", 1.0f,
                                                              "Of all its shapes; pairs take the larger.");
}

void bind_state(nb::class_<BodyHandle>& c) {
    c.def_prop_rw(
        "_kind", [](const BodyHandle& h) { return static_cast<int>(row(h).kind); },
        [](const BodyHandle& h, int kind) {
            require_alive(h);
            set_kind(*h.world, h.ref.slot, static_cast<BodyKind>(kind));
        });
    def_value(
        c, "bullet", kSwitch, [](const BodyHandle& h) { return row(h).bullet; },
        [](const BodyHandle& h, nb::handle on) { row(h).bullet = to_bool(on, kOwner, "bullet"); },
        "Marked as fast and thin, for continuous collision.");
    def_value(
        c, "touchable", kSwitch, [](const BodyHandle& h) { return row(h).touchable; },
        [](const BodyHandle& h, nb::handle on) { row(h).touchable = to_bool(on, kOwner, "touchable"); },
        "Fingers and the mouse can hold it.");
    def_value(
        c, "awake", kSwitch, [](const BodyHandle& h) { return row(h).awake; },
        [](const BodyHandle& h, nb::handle on) {
            Body& b = row(h);
            if (to_bool(on, kOwner, "awake")) return wake(*h.world, h.ref.slot);
            if (b.kind != BodyKind::dynamic) return;
            b.awake = false;
            b.velocity = {};
            b.spin = 0.0f;
            publish(*h.world, h.ref.slot);
        },
        "False while it rests and costs nothing. A touch, a push or a change wakes it.");
    c.def_prop_rw(
        "_tag", [](const BodyHandle& h) { return row(h), h.world->bodies.tags[h.ref.slot]; },
        [](BodyHandle& h, const std::string& tag) {
            require_alive(h);
            h.world->bodies.tags[h.ref.slot] = tag;
            h.tag = tag;
        });
    def_value(
        c, "scale", kPoint, [](const BodyHandle& h) { return from_vec2(row(h).scale); }, set_scale_of,
        "(x, y) that all its shapes are stretched by; mass follows unless it was set.");
    c.def_prop_ro("_matrix", [](const BodyHandle& h) { return from_affine(body_matrix(row(h))); });
    c.def(
        "_apply_matrix",
        [](const BodyHandle& h, nb::handle matrix) {
            Affine m = to_affine(matrix, "Body.apply_matrix");
            require_alive(h);
            MatrixProblem problem = apply_to_body(*h.world, h.ref.slot, m);
            if (problem != MatrixProblem::none) raise_matrix(problem, "Body.apply_matrix");
        },
        nb::arg("matrix").none());
    c.def("_shape_slots", shape_slots);
    c.def("_destroy", [](const BodyHandle& h) {
        require_alive(h);
        destroy_body(*h.world, h.ref.slot);
    });
    c.def("_take_back", [](const BodyHandle& h) {
        require_alive(h);
        take_back(*h.world, h.ref.slot);
    });
}

} // namespace

void register_body(nb::module_& module) {
    nb::class_<BodyHandle> c(module, "Body", "Reference to a body of a world.");
    c.def(
        "__init__",
        [](BodyHandle* self, std::shared_ptr<World> world, std::uint32_t slot, std::uint32_t generation) {
            BodyHandle h{std::move(world), {slot, generation}, 0, 0, false, {}};
            if (alive(h)) {
                h.born = h.world->bodies.rows[slot].born;
                h.tag = h.world->bodies.tags[slot];
            }
            new (self) BodyHandle(std::move(h));
        },
        nb::arg("world"), nb::arg("slot"), nb::arg("generation"));
    bind_identity(c);
    bind_motion(c);
    bind_pushes(c);
    bind_mass(c);
    bind_state(c);
    bind_traits(c);
}

} // namespace evil::bind
