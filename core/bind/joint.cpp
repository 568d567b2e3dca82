#include "bind/handle.hpp"

namespace evil::bind {
namespace {

struct JointSpec { // what a new joint shall be; numbers are checked by the face, which knows the kind's own words
    Joint row;
};

Joint& fields(JointSpec& spec) { return spec.row; }
const Joint& fields(const JointSpec& spec) { return spec.row; }
Joint& fields(const JointHandle& h) { return row(h); }

void changed(JointSpec&) {}
void changed(const JointHandle& h) { // whoever hangs on it shall feel it
    wake(*h.world, row(h).body_a);
    wake(*h.world, row(h).body_b);
    h.world->joints.unchecked = true;
}

template <auto Field, class C> void bind_field(nb::class_<C>& c, const char* name) {
    using Value = std::remove_reference_t<decltype(std::declval<Joint>().*Field)>;
    c.def_prop_rw(
        name, [](const C& h) { return fields(h).*Field; },
        [](C& h, Value value) {
            fields(h).*Field = value;
            changed(h);
        });
}

template <JointDrive Joint::* Which, auto Field, class C>
void bind_drive_field(nb::class_<C>& c, const std::string& name) {
    using Value = std::remove_reference_t<decltype(std::declval<JointDrive>().*Field)>;
    c.def_prop_rw(
        name.c_str(), [](const C& h) { return (fields(h).*Which).*Field; },
        [](C& h, Value value) {
            (fields(h).*Which).*Field = value;
            changed(h);
        });
}

template <Vec2 Joint::* Field, class C> void bind_point(nb::class_<C>& c, const char* name) {
    c.def_prop_rw(
        name, [](const C& h) { return from_vec2(fields(h).*Field); },
        [name](C& h, nb::handle value) {
            Vec2 given = to_vec2(value, "Joint", name);
            fields(h).*Field = given;
            changed(h);
        });
}

template <JointDrive Joint::* Which, class C> void bind_drive(nb::class_<C>& c, const std::string& prefix) {
    bind_drive_field<Which, &JointDrive::held>(c, prefix + "_held");
    bind_drive_field<Which, &JointDrive::limited>(c, prefix + "_limited");
    bind_drive_field<Which, &JointDrive::motor>(c, prefix + "_motor");
    bind_drive_field<Which, &JointDrive::rest>(c, prefix + "_rest");
    bind_drive_field<Which, &JointDrive::lower>(c, prefix + "_lower");
    bind_drive_field<Which, &JointDrive::upper>(c, prefix + "_upper");
    bind_drive_field<Which, &JointDrive::speed>(c, prefix + "_speed");
    bind_drive_field<Which, &JointDrive::most>(c, prefix + "_most");
    bind_drive_field<Which, &JointDrive::frequency>(c, prefix + "_frequency");
    bind_drive_field<Which, &JointDrive::damping_ratio>(c, prefix + "_damping_ratio");
    bind_drive_field<Which, &JointDrive::stiffness>(c, prefix + "_stiffness");
    bind_drive_field<Which, &JointDrive::damping>(c, prefix + "_damping");
    bind_drive_field<Which, &JointDrive::spring_most>(c, prefix + "_spring_most");
}

template <class C> void bind_fields(nb::class_<C>& c) {
    bind_point<&Joint::anchor_a>(c, "anchor_a");
    bind_point<&Joint::anchor_b>(c, "anchor_b");
    bind_point<&Joint::axis>(c, "axis");
    bind_point<&Joint::over_a>(c, "over_a");
    bind_point<&Joint::over_b>(c, "over_b");
    bind_field<&Joint::reference>(c, "reference");
    bind_field<&Joint::ratio>(c, "ratio");
    bind_field<&Joint::breaking_force>(c, "breaking_force");
    bind_field<&Joint::breaking_torque>(c, "breaking_torque");
    bind_drive<&Joint::along>(c, "along");
    bind_drive<&Joint::turn>(c, "turn");
}

template <class Read> auto reading(Read read) {
    return [read](const JointHandle& h) { return read(state_of(row(h), h.world->bodies)); };
}

void bind_readings(nb::class_<JointHandle>& c) {
    c.def_prop_ro("kind", [](const JointHandle& h) { return static_cast<int>(row(h).kind); });
    c.def_prop_ro("collide", [](const JointHandle& h) { return row(h).collide; });
    c.def_prop_ro("body_a", [](const JointHandle& h) { return row(h).body_a; });
    c.def_prop_ro("body_b", [](const JointHandle& h) { return row(h).body_b; });
    c.def_prop_ro("force", [](const JointHandle& h) { return from_vec2(row(h).force); });
    c.def_prop_ro("torque", [](const JointHandle& h) { return row(h).torque; });
    c.def_prop_ro("at_a", reading([](const JointState& s) { return from_vec2(s.at_a); }));
    c.def_prop_ro("at_b", reading([](const JointState& s) { return from_vec2(s.at_b); }));
    c.def_prop_ro("angle", reading([](const JointState& s) { return s.angle; }));
    c.def_prop_ro("turning", reading([](const JointState& s) { return s.turning; }));
    c.def_prop_ro("length", reading([](const JointState& s) { return s.length; }));
    c.def_prop_ro("lengthening", reading([](const JointState& s) { return s.lengthening; }));
    c.def("destroy", [](const JointHandle& h) {
        require_alive(h);
        destroy_joint(*h.world, h.ref.slot);
    });
}

Anything from_broken(const BrokenJoint& b) {
    return nb::borrow<Anything>(nb::make_tuple(b.ref.slot, b.ref.generation, b.a.slot, b.a.generation, b.b.slot,
                                               b.b.generation, from_vec2(b.force), b.torque));
}

void bind_world_functions(nb::module_& module) {
    module.def(
        "add_joint",
        [](World& w, const JointSpec& spec, const BodyHandle& a, const BodyHandle& b) {
            require_alive(a);
            require_alive(b);
            Joint row = spec.row;
            row.body_a = a.ref.slot;
            row.body_b = b.ref.slot;
            return add_joint(w, row).slot;
        },
        nb::arg("world"), nb::arg("spec"), nb::arg("a"), nb::arg("b"));
    module.def(
        "joint_slots",
        [](const World& w) { // in order of creation
            std::vector<std::uint32_t> list;
            for (std::uint32_t s = 0; s < w.joints.slots.size(); ++s)
                if (w.joints.slots.taken(s)) list.push_back(s);
            std::ranges::sort(list, {}, [&](std::uint32_t s) { return w.joints.rows[s].serial; });
            return list;
        },
        nb::arg("world"));
    module.def(
        "joint_generation",
        [](const World& w, std::uint32_t slot) {
            return slot < w.joints.slots.size() ? w.joints.slots.generation(slot) : 0u;
        },
        nb::arg("world"), nb::arg("slot"));
    module.def("joint_count", [](const World& w) { return w.joints.slots.count(); }, nb::arg("world"));
    module.def(
        "joint_slots_of",
        [](const World& w, std::uint32_t body) {
            std::vector<std::uint32_t> list;
            for_joints_of(w.joints, body, [&](std::uint32_t joint, std::uint32_t) { list.push_back(joint); });
            std::ranges::sort(list, {}, [&](std::uint32_t s) { return w.joints.rows[s].serial; });
            return list;
        },
        nb::arg("world"), nb::arg("body"));
    module.def(
        "broken_joints",
        [](const World& w) {
            nb::list list;
            for (const BrokenJoint& b : w.joints.broken) list.append(from_broken(b));
            return nb::borrow<nb::typed<nb::list, Anything>>(list);
        },
        nb::arg("world"));
}

} // namespace

void register_joint(nb::module_& module) {
    nb::class_<JointSpec> spec(module, "JointSpec", "What a new joint shall be.");
    spec.def(
        "__init__",
        [](JointSpec* self, int kind, bool collide) {
            JointSpec s;
            s.row.kind = static_cast<JointKind>(kind);
            s.row.collide = collide;
            new (self) JointSpec(std::move(s));
        },
        nb::arg("kind"), nb::arg("collide"));
    bind_fields(spec);
    nb::class_<JointHandle> c(module, "Joint", "Reference to a joint of a world.");
    c.def(
        "__init__",
        [](JointHandle* self, std::shared_ptr<World> world, std::uint32_t slot, std::uint32_t generation) {
            JointHandle h{std::move(world), {slot, generation}, 0, 0, false, {}};
            if (alive(h)) h.born = h.world->joints.rows[slot].born;
            new (self) JointHandle(std::move(h));
        },
        nb::arg("world"), nb::arg("slot"), nb::arg("generation"));
    bind_identity(c);
    bind_fields(c);
    bind_readings(c);
    bind_world_functions(module);
}

} // namespace evil::bind
