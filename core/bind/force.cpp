#include "bind/handle.hpp"
#include "shapes/rounded.hpp"

namespace evil::bind {

NewShape used(const NewShape& spec, nb::handle offset, double angle, float density, float friction, float restitution);

Area area_of(const NewShape& spec, nb::handle at, double angle) {
    Affine m = used(spec, at, angle, 1.0f, 0.0f, 0.0f).shape.local;
    Area area;
    area.centre = {m.tx, m.ty};
    if (spec.shape.kind == ShapeKind::circle) area.radius = spec.shape.radius;
    bool skin = spec.shape.kind != ShapeKind::circle && spec.shape.radius > 0.0f;
    OwnedRings rings = skin ? rounded_outline(spec.rings, spec.shape.radius) : spec.rings;
    for (const Part& part : skin ? split_convex(rings) : spec.parts) {
        auto& corners = area.parts.emplace_back();
        for (std::uint32_t corner : part) corners.push_back(apply(m, rings.corners[corner]));
    }
    if (area.radius == 0.0f && area.parts.empty())
        raise(ErrorKind::argument,
              "Medium: area must be a shape with an inside: a Circle, Rectangle, Polygon, Capsule");
    return area;
}

namespace {

// ("circle", centre, radius) or ("parts", lists of corners), in the world or the frame of the body that carries it.
Anything outline_of(const ForceHandle& h) {
    const Area& area = h.world->forces.areas[(row(h), h.ref.slot)];
    if (area.radius > 0.0f) return nb::borrow<Anything>(nb::make_tuple("circle", from_vec2(area.centre), area.radius));
    nb::list parts;
    for (const auto& part : area.parts) {
        nb::list corners;
        for (Vec2 corner : part) corners.append(from_vec2(corner));
        parts.append(nb::tuple(corners));
    }
    return nb::borrow<Anything>(nb::make_tuple("parts", nb::tuple(parts)));
}

void wake_all_of(const ForceHandle& h) {
    const Force& f = row(h);
    for (std::uint32_t body : f.bodies) wake(*h.world, body);
    if (f.target != kNone) wake(*h.world, f.target);
    if (f.everywhere) wake_all(*h.world);
}

template <float Force::* Field> void bind_float(nb::class_<ForceHandle>& c, const char* name) {
    c.def_prop_rw(
        name, [](const ForceHandle& h) { return row(h).*Field; },
        [](const ForceHandle& h, float value) { // checked by the face, which knows the kind's own words
            row(h).*Field = value;
            wake_all_of(h);
        });
}

template <Vec2 Force::* Field> void bind_vec2(nb::class_<ForceHandle>& c, const char* name) {
    c.def_prop_rw(
        name, [](const ForceHandle& h) { return from_vec2(row(h).*Field); },
        [name](const ForceHandle& h, nb::handle value) {
            Vec2 given = to_vec2(value, "Force", name);
            row(h).*Field = given;
            wake_all_of(h);
        });
}

} // namespace

void register_force(nb::module_& module) {
    module.attr("NO_SLOT") = kNone;
    nb::class_<ForceHandle> c(module, "Force", "Reference to a force of a world.");
    c.def(
        "__init__",
        [](ForceHandle* self, std::shared_ptr<World> world, std::uint32_t slot, std::uint32_t generation) {
            ForceHandle h{std::move(world), {slot, generation}, 0, 0, false, {}};
            if (alive(h)) h.born = h.world->forces.rows[slot].born;
            new (self) ForceHandle(std::move(h));
        },
        nb::arg("world"), nb::arg("slot"), nb::arg("generation"));
    bind_identity(c);
    bind_vec2<&Force::vector>(c, "vector");
    bind_vec2<&Force::anchor>(c, "anchor");
    bind_float<&Force::stiffness>(c, "stiffness");
    bind_float<&Force::rest_length>(c, "rest_length");
    bind_float<&Force::damping>(c, "damping");
    bind_float<&Force::linear>(c, "linear");
    bind_float<&Force::quadratic>(c, "quadratic");
    bind_float<&Force::limit>(c, "limit");
    bind_float<&Force::density>(c, "density");
    c.def_prop_ro("area", outline_of);
    c.def("set_area", [](const ForceHandle& h, const NewShape& spec, nb::handle at, double angle) {
        Area area = area_of(spec, at, angle);
        require_alive(h);
        set_area(*h.world, h.ref.slot, std::move(area));
    });
    c.def_prop_rw(
        "note", [](const ForceHandle& h) { return row(h).note; },
        [](const ForceHandle& h, const std::string& note) { row(h).note = note; });
    c.def_prop_ro("at_anchor", [](const ForceHandle& h) { return row(h).at_anchor; });
    c.def_prop_ro("everywhere", [](const ForceHandle& h) { return row(h).everywhere; });
    c.def_prop_ro("kind", [](const ForceHandle& h) { return static_cast<int>(row(h).kind); });
    c.def_prop_ro("target", [](const ForceHandle& h) { return row(h).target; });
    c.def_prop_ro("body_slots", [](const ForceHandle& h) { return row(h).bodies; });
    c.def("attach", [](const ForceHandle& h, const BodyHandle& b) {
        require_alive(h);
        require_alive(b);
        attach(*h.world, h.ref.slot, b.ref.slot);
    });
    c.def("detach", [](const ForceHandle& h, const BodyHandle& b) {
        require_alive(h);
        require_alive(b);
        detach(*h.world, h.ref.slot, b.ref.slot);
    });
    c.def("destroy", [](const ForceHandle& h) {
        require_alive(h);
        destroy_force(*h.world, h.ref.slot);
    });
}

} // namespace evil::bind
