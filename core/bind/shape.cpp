// Shape definitions (what a user asks for) and handles (what is on a body).
#include "bind/handle.hpp"
#include "bind/shapes.hpp"
#include "shapes/polygon.hpp"

namespace evil::bind {
namespace {

Affine placed_at(nb::handle offset, double angle, const char* owner) {
    Vec2 p = to_vec2(offset, owner, "offset");
    return affine(Pose{p, rotation(angle)});
}

Affine rows_of(const ShapeHandle& h) { return definition_to_body(row(h), h.world->bodies.rows[row(h).body].scale); }

// In the body's frame: ("circle", centre, radius), ("polygon", corners) or ("particle", centre).
Anything outline(const ShapeHandle& h) {
    const Shape& shape = row(h);
    Affine m = rows_of(h);
    if (shape.kind == ShapeKind::circle)
        return nb::borrow<Anything>(
            nb::make_tuple("circle", from_vec2({m.tx, m.ty}), shape.radius * length({m.a, m.b})));
    if (shape.kind == ShapeKind::particle)
        return nb::borrow<Anything>(nb::make_tuple("particle", from_vec2({m.tx, m.ty})));
    nb::list corners;
    for (Vec2 p : h.world->shapes.corners[h.ref.slot]) corners.append(from_vec2(apply(m, p)));
    return nb::borrow<Anything>(nb::make_tuple("polygon", nb::tuple(corners)));
}

template <float Material::* Field>
void bind_material(nb::class_<ShapeHandle>& c, const char* name, float most, const char* doc) {
    def_value(
        c, name, kNumber, [](const ShapeHandle& h) { return row(h).material.*Field; },
        [name, most](const ShapeHandle& h, nb::handle value) {
            Shape& shape = row(h);
            shape.material.*Field = in_range(value, "Shape", name, 0.0f, most);
            wake(*h.world, shape.body);
        },
        doc);
}

void bind_definition(nb::module_& module) {
    nb::class_<NewShape> c(module, "ShapeSpec",
                           "A shape as the core takes it: checked, counter-clockwise, split into convex parts.");
    c.def_static("circle", [](float radius) {
        NewShape s;
        s.shape.kind = ShapeKind::circle;
        s.shape.radius = radius;
        return s;
    });
    c.def_static("particle", [](float mass) {
        NewShape s;
        s.shape.kind = ShapeKind::particle;
        s.shape.mass = mass;
        return s;
    });
    c.def_static("polygon", [](nb::handle corners, const char* owner) {
        NewShape s;
        s.shape.kind = ShapeKind::polygon;
        s.corners = to_corners(corners, owner, "corners");
        refuse_bad_polygon(s.corners, owner, "corners");
        make_counter_clockwise(s.corners);
        s.parts = split_convex(s.corners);
        return s;
    });
    c.def_prop_ro("corners", [](const NewShape& s) {
        nb::list corners;
        for (Vec2 p : s.corners) corners.append(from_vec2(p));
        return nb::borrow<nb::typed<nb::tuple, PyVec2, nb::ellipsis>>(nb::tuple(corners));
    });
}

} // namespace

// A spec with the material, place and angle of this one use.
NewShape used(const NewShape& spec, nb::handle offset, double angle, float density, float friction, float restitution) {
    NewShape s = spec;
    s.shape.local = placed_at(offset, angle, "Shape");
    s.shape.material = {density, friction, restitution};
    return s;
}

void register_shape(nb::module_& module) {
    bind_definition(module);
    nb::class_<ShapeHandle> c(module, "Shape", "Reference to a shape on a body.");
    c.def(
        "__init__",
        [](ShapeHandle* self, std::shared_ptr<World> world, std::uint32_t slot, std::uint32_t generation) {
            ShapeHandle h{std::move(world), {slot, generation}, 0, 0, false, {}};
            if (alive(h)) {
                h.born = h.world->shapes.rows[slot].born;
                h.tag = h.world->bodies.tags[h.world->shapes.rows[slot].body];
            }
            new (self) ShapeHandle(std::move(h));
        },
        nb::arg("world"), nb::arg("slot"), nb::arg("generation"));
    bind_identity(c);
    bind_material<&Material::friction>(c, "friction", 1e6f, "Friction coefficient; a pair mixes its two as sqrt(a b).");
    bind_material<&Material::restitution>(c, "restitution", 1.0f, "0: no bounce, 1: full; a pair takes the larger.");
    def_value(
        c, "density", kNumber, [](const ShapeHandle& h) { return row(h).material.density; },
        [](const ShapeHandle& h, nb::handle value) {
            require_alive(h);
            MassProblem problem = set_density(*h.world, h.ref.slot, in_range(value, "Shape", "density", 0.0f, 1e9f));
            if (problem != MassProblem::none) raise_mass(problem, "Shape.density");
        },
        "Relative to water, 1.0: kilograms a square metre.");
    c.def_prop_ro(
        "mass",
        [](const ShapeHandle& h) {
            return moments(h.world->shapes, (row(h), h.ref.slot), h.world->bodies.rows[row(h).body].scale).mass;
        },
        "Kilograms that its density and area make; the body's mass unless that was set.");
    c.def_prop_ro("_body_slot", [](const ShapeHandle& h) { return row(h).body; });
    c.def_prop_ro("outline", outline,
                  "In the body's frame: ('circle', centre, radius), ('polygon', corners) or ('particle', centre).");
    c.def_prop_ro("_matrix", [](const ShapeHandle& h) { return from_affine(row(h).local); });
    c.def("_apply_matrix", [](const ShapeHandle& h, nb::handle matrix) {
        require_alive(h);
        MatrixProblem problem = apply_to_shape(*h.world, h.ref.slot, to_affine(matrix, "Shape.apply_matrix"));
        if (problem != MatrixProblem::none) raise_matrix(problem, "Shape.apply_matrix");
    });
    c.def("_destroy", [](const ShapeHandle& h) {
        require_alive(h);
        destroy_shape(*h.world, h.ref.slot);
    });
}

} // namespace evil::bind
